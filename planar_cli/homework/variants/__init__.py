"""The problems of a homework solved, for the file itself and for other values of what it gives."""
