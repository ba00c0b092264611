"""Velocity and acceleration of particles in polar coordinates, as the course writes them."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Any

import sympy as sp

from planar_cli.equation.kinematics.components import Components
from planar_cli.equation.scene.centres import centre_of
from planar_cli.equation.scene.line_names import line_name
from planar_cli.equation.system.system import System
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.language.walk import walk
from planar_cli.report.document.blocks import Block, Equation, Line, Name, Paragraph, line
from planar_cli.report.notation.names import index_of
from planar_cli.report.words.words import Phrases

POLAR = " in polar coordinates about "
VELOCITIES = ("v", "KE", "momentum", "H")


def polar_blocks(
    system: System, moved: Collection[str], phrases: Phrases, zero: Collection[sp.Symbol]
) -> Iterator[Block]:
    """v_P = r' e_r + r φ' e_φ and a_P, where it turns. `moved`: bodies whose accelerations stand in equations; `zero`:
    rates that vanish.
    """
    asked = _asked(system)
    for edge in system.tree.edges:
        own = edge.components
        if own is None or not own.turns or own.turns in {s.name for s in zero}:
            continue
        place = centre_of(system.scene, edge.body)
        names = {edge.body, place}
        lines = []
        if any(word in VELOCITIES and names & things for word, things in asked):
            lines.append(("v", own.velocities))
        if edge.body in moved or any(word == "a" and names & things for word, things in asked):
            lines.append(("a", own.accelerations))
        if lines:
            way = line_name(own.origin, place)
            yield Paragraph(line(f"{place}{POLAR}{own.origin}, ", Name("e_r"), f" along {way}:"))
        for letter, parts in lines:
            settled = [p.xreplace(dict.fromkeys(zero, sp.S.Zero)) for p in parts]
            if any(p != 0 for p in settled):
                yield Equation((line(Name(f"{letter}_{index_of(place)}")), _vector(settled, own, phrases)), None)


def _asked(system: System) -> list[tuple[str, set[str]]]:
    """The words of the finds, and what each is about."""
    finds = system.scene.problem.find
    return [(q.word, set(q.things)) for f in finds for q in walk(f.found.what) if isinstance(q, Quantity)]


def _vector(parts: list[sp.Expr], own: Components, phrases: Phrases) -> Line:
    told: list[Any] = []
    for part, unit in zip(parts, ("e_r", f"e_{own.turns}"), strict=True):
        if part == 0:
            continue
        negative = part.could_extract_minus_sign() and not part.is_Add
        size = phrases.math(-part if negative else part)
        told += [" - " if negative else " + "] if told else ["-"] if negative else []
        told += ["(", size, ") ", Name(unit)] if part.is_Add else [size, " ", Name(unit)]
    return line(*told)
