"""Figures of a solution: what is drawn, as marks (report/document/marks.py)."""
