"""Checks that a person can make of a page."""
