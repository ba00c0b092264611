"""The state from which a motion begins, also at an equilibrium."""
