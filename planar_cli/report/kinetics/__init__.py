"""Free-body and kinetic diagrams, and what sums of forces and of moments need."""
