"""Balances of energy: T of every body, U of every force."""
