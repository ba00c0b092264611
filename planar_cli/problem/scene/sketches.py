"""How a joint or load of the file looks in a drawing: the closed vocabulary in which each kind says so.

Places are vectors of exact expressions, as in `facts.py`; a body's own shape is drawn from the scene, and so is a
surface, so that a contact needs no sign.
"""

from __future__ import annotations

from typing import Any

from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.keys import Table
from planar_cli.records import record


@record
class Hinge:
    """A pin at a place; `grounded`: on a fixed support. `bodies`: those that turn about it."""

    at: Vec
    grounded: bool
    bodies: tuple[str, ...] = ()


@record
class Slide:
    """A slider at a place on a straight track along a direction. `grounded`: the track is fixed. `body`: the whole body
    that slides, unable to turn, or the particle. `drawn`: its track is a surface of the file. `carrier`: the body in
    which the track is. `pinned`: the place itself is fixed, and the body with the track slides and turns over it.
    `track`: the name of the surface or body along which it is.
    """

    at: Vec
    along: Vec
    grounded: bool
    body: str | None = None
    drawn: bool = False
    carrier: str | None = None
    pinned: bool = False
    track: str = ""


@record
class Fastening:
    """Bodies fixed to each other at a place."""

    at: Vec


@record
class CordStop:
    """Where a cord passes: a point, a circle about it (`side` +1: its centre lies to the left of the running cord), or
    the place `rim` where the cord leaves a drum on which it is wound. `fixed`: is the point on the ground?
    """

    center: Vec
    radius: Any = 0
    side: int = 0
    rim: Vec | None = None
    fixed: bool = False
    name: str = ""
    """Of the point, or of the pulley."""
    body: str = ""
    """With which it moves."""


@record
class Cord:
    """A rope from stop to stop. `fixed`: are its ends fastened to the ground? `along`: the direction of all its parts,
    if it has one. `name`: that of the joint.
    """

    stops: tuple[CordStop, ...]
    fixed: tuple[bool, bool] = (False, False)
    along: Vec | None = None
    name: str = ""


@record
class Bar:
    """A light rod from pin to pin; `fixed`: which of them are supports?"""

    start: Vec
    end: Vec
    fixed: tuple[bool, bool] = (False, False)


@record
class Spiral:
    """A helical spring; `fixed`: which of its ends are fastened to the ground? `free`: of one that only pushes its
    length while nothing touches it. `size`: its stiffness as the file writes it.
    """

    start: Vec
    end: Vec
    fixed: tuple[bool, bool] = (False, False)
    free: Any = None
    size: Side | None = None


@record
class Absorber:
    """A viscous damper; `fixed`: which of its ends are fastened to the ground? `size`: its force per speed as the file
    writes it.
    """

    start: Vec
    end: Vec
    fixed: tuple[bool, bool] = (False, False)
    size: Side | None = None


@record
class Loop:
    """An endless belt round two disks."""

    centers: tuple[Vec, Vec]
    radii: tuple[Any, Any]
    crossed: bool


@record
class Push:
    """A force, an impulse or a jet at a place, in a direction, with its size as the file writes it."""

    at: Vec
    direction: Vec
    size: Side | Table | None
    inward: bool = False
    """Does it come to the place, as a jet that enters?"""
    unwinds: bool = False
    """Does it pull at the end of a cord that leaves a drum there?"""
    flows: bool = False
    """Is it no force, but matter that flows there, with its speed?"""


@record
class Twist:
    """A couple about a place, counterclockwise where its size is positive, with its size as the file writes it.
    `reversed`: it is the reaction to that, the other way round. `body`: on which it acts.
    """

    at: Vec
    size: Side | Table
    reversed: bool = False
    body: str = ""


Sketch = Hinge | Slide | Fastening | Cord | Bar | Spiral | Absorber | Loop | Push | Twist
