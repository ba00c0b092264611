"""What is raised for an answer that cannot be read."""

from __future__ import annotations


class Unreadable(ValueError):
    """What was typed is no answer; the message says why, to the student."""
