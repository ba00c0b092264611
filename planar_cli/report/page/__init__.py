"""The whole page: its head, its steps, what is left out or joined at the end; keys and plain data."""
