"""One choice of modes with its equations of motion, its guards, and the model of all choices."""
