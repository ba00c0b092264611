"""One instant told in its steps, with what is asked of it."""
