"""Formulas as text, plain and LaTeX, in the form in which a person would write them."""
