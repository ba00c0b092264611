"""Why a body without mass has no equations: loaded at its two pins alone it pulls or pushes along them."""

from __future__ import annotations

from collections.abc import Sequence

from planar_cli.equation.system.system import System
from planar_cli.report.document.blocks import Forces, Math, Name, Paragraph, Text, line


def two_force_members(system: System, rows: Sequence[Forces]) -> list[Paragraph]:
    """One line for all of those whose forces stand in these diagrams."""
    groups = [set(row.body.split(", ")) for row in rows]
    drawn = [p for p in system.pushes if p.member and any(len({a.body for a in p.actions} & g) == 1 for g in groups)]
    pulls = {p.member: system.symbols[p.name] for p in drawn}
    if not pulls:
        return []
    bodies = [piece for i, name in enumerate(pulls) for piece in (_before(i, len(pulls)), Name(name))]
    forces = [piece for i, s in enumerate(pulls.values()) for piece in (_before(i, len(pulls)), Math(s))]
    one, several = ("has", "is", "its two pins", "it"), ("have", "are", "their pins", "them")
    have, are, pins, these = one if len(pulls) == 1 else several
    words = f" {have} no mass and {are} loaded at {pins} alone: along {these} "
    return [Paragraph(line(*bodies, words, "acts " if len(pulls) == 1 else "act ", *forces))]


def _before(i: int, count: int) -> Text:
    return Text("" if i == 0 else " and " if i == count - 1 else ", ")
