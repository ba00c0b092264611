"""Submissions read from files, and graded in batches."""
