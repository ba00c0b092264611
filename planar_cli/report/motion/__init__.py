"""A motion told from state to state."""
