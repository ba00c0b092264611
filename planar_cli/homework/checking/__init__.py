"""Stated answers compared with what a solution found."""
