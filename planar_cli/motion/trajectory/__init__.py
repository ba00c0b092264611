"""A hybrid automaton, one regime of it integrated, and what a motion was."""
