"""Roots of the equations of a motion, closed and in numbers, one small block after the other."""
