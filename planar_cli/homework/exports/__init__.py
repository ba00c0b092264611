"""Shelf of exports: homework and its results as files of course systems; one file, one member."""
