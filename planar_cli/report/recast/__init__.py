"""The equations of a part as its page tells them, before any of it is written."""
