"""The language of statements: from one line of text to a syntax tree, and what is read from that."""
