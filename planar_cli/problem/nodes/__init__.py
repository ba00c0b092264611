"""The YAML text as nodes that know their places, and the small functions that take them apart."""
