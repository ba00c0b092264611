"""Places, velocities and accelerations: vector equations, and the components that are taken."""
