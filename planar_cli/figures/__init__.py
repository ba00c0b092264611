"""Figures of a solution: what is drawn, as marks (report/marks.py)."""
