"""Verdicts and scores: wrong values carried on, and the mistakes that explain them."""
