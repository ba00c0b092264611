"""Balances of momentum and angular momentum, and blows."""
