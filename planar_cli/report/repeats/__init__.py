"""What an earlier part or case has told, to which a later one refers."""
