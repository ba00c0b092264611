"""The neutral document: its blocks, its lines, and the marks of its drawings."""
