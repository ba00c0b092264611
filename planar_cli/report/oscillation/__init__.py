"""Oscillations: about an equilibrium, free and driven, and simple harmonic motion."""
