"""The equations of an instant in letters or numbers, and what they give, unknown after unknown."""
