"""The shelf of typical mistakes: each changes one thing in the equations of a solution, or in its result."""
