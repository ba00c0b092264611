"""What a problem file says, as frozen values, and what joints and loads may state about it."""
