"""What every diagnostic code means."""
