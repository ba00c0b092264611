"""Laws of coordinates over time, and their integrals."""
