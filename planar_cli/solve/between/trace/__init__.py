"""What is said of a motion that is solved, as frozen data: all that print sees of it."""
