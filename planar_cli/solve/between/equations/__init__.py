"""What principles and the file state between the states of a motion."""
