"""All equations of one instant: conditions, pushes, loads."""
