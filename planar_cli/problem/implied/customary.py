"""Whether a file is in US customary units: all its formulas are in ft, slug, s then."""

from __future__ import annotations

import re
from typing import Any

from planar_cli.problem.scene.ordinary import with_units
from planar_cli.problem.scene.scene import Problem

ATOM = re.compile(r"[A-Za-z]+")
US_ATOMS = frozenset("in ft yd mi lb slug lbf kip psi hp mph".split())
NEUTRAL_ATOMS = frozenset("s ms min h deg rad rev rpm Hz kHz".split())
"""Times and angles count neither way."""


def is_us(problem: Problem) -> bool:
    """Are all numbers of `given` in US customary units; where none there tells, those of the whole file?"""
    atoms = _atoms(problem.given) or _atoms(problem)
    return bool(atoms) and atoms <= US_ATOMS


def _atoms(part: Any) -> set[str]:
    """The units that tell."""
    return {atom for n in with_units(part) for atom in ATOM.findall(n.unit or "")} - NEUTRAL_ATOMS
