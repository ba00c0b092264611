"""The letters of impulses: of what a file gives in numbers J, or J and the name of the blow; of a reaction J_N_C."""

from __future__ import annotations

import re

from planar_cli.problem.language.expression import Name, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Problem

LETTER = "J"


def impulse_letters(problem: Problem) -> dict[str, tuple[str, Side]]:
    """By the name of the load: its letter and its magnitude. A magnitude with names of the file has letters already."""
    blows = [x for x in (*problem.loads, *problem.strikers) if x.strikes]
    # Two that are called alike have no letters of their own.
    called = [x.name for x in blows]
    told = [x for x in blows if called.count(x.name) == 1]
    sides = {x.name: side for x in told if isinstance(side := getattr(x, "magnitude", None), Side)}
    plain = {name: side for name, side in sides.items() if not any(isinstance(n, Name) for n in walk(side))}
    symbols = (*problem.given, *problem.symbols, *problem.unknowns, *problem.coordinates)
    taken = {x.name for x in symbols} | {p.name for p in problem.points} | {b.name for b in problem.bodies}
    taken |= {f.name for f in problem.find}
    alone = len(blows) == 1 and LETTER not in taken
    letters = {name: LETTER if alone else f"{LETTER}_{name}" for name in plain}
    return {name: (letter, plain[name]) for name, letter in letters.items() if letter not in taken}


def of_reaction(name: str) -> str:
    """The letter for the impulse of a reaction: J_N_C of N_C, and J_OA_x of a component at the point O_A."""
    return "J_" + re.sub(r"^([A-Z])_(\w+)(?=_[xytn]$)", r"\1\2", name)
