"""Expressions put in plainer forms, at a price that fits thousands of calls; no mechanics."""
