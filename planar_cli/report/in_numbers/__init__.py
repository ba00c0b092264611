"""Formulas and equations with the numbers put in."""
