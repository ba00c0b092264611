"""The equations of a solution once more, with other numbers or with one thing changed, in machine numbers.

Variants of a problem, models with a mistake in them, and answers that rest on a student's own earlier value all come
from the equations that the solution wrote; nothing is derived anew.
"""
