"""The names of a problem as symbols, and the exact values of expressions in them."""
