"""Words of a page: states, directions and senses as they are spoken of, and one letter for one thing."""
