"""What a file gives and states, as the page says it."""
