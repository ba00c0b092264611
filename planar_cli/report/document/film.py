"""A motion as it is shown: what a drawing is made of at many moments, thing by thing."""

from __future__ import annotations

from planar_cli.records import record
from planar_cli.report.document.marks import Mark


@record
class Thing:
    """Something that is drawn at every moment: its marks there; none where it is not there."""

    shots: tuple[tuple[Mark, ...], ...]


@record
class Film:
    """A motion from its beginning to its end, again and again."""

    times: tuple[float, ...]
    """The moments, s; in between everything goes on evenly."""
    things: tuple[Thing, ...]
    states: tuple[tuple[str, float], ...]
    """When the states of the file are reached, s."""
    seconds: float
    """How long it takes on the screen."""
    title: str
    heavy: bool
    """Is there weight?"""
