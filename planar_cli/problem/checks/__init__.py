"""What is wrong with a problem that has been read."""
