"""The pages of `planar explain` about the problem language: one module for a page, whose docstring is the page.

A module `points_surfaces` serves the topics `points` and `surfaces`. Every YAML block that begins with `title:` is a
whole problem file, and a test reads it.
"""
