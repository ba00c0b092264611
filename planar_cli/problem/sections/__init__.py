"""The sections of a file, read one by one, and the JSON Schema of them."""
