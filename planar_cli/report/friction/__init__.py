"""Contacts: what is assumed of them, what friction would have to be, and the decision."""
