"""What a student typed, read: numbers, units, directions, formulas."""
