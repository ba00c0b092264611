"""Homework sets and their rules as plain data, and what is handed out."""
