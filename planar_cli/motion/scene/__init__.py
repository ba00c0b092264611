"""The scene wherever its bodies are: places, outlines, gaps, quantities, constraints of the file."""
