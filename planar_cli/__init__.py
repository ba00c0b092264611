"""planar: worked solutions of planar dynamics problems."""

__version__ = "0.1.0"
