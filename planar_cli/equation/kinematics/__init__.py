"""Velocities and accelerations of all bodies, and the quantities made of them."""
