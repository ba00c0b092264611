"""The answers of a motion, and how they are told: in whose letters, in which order."""
