"""The scene at one instant: places, bodies, outlines, and where things meet."""
