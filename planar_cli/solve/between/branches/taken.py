"""What a solved motion tells whoever follows it anew in numbers, beside what its file says."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from planar_cli.solve.between.branches.solved_motion import SolvedMotion
from planar_cli.solve.impulsive.impact import arriving
from planar_cli.solve.taken import Taken


def taken_of(found: SolvedMotion) -> Taken:
    """Constants that were sought, letters as drawn, restitutions, when states are reached, and how bodies start."""
    course, values = found.course, found.value.values
    names = [s.name for s in (*course.problem.symbols, *course.problem.unknowns)]
    names += ["g"] if course.problem.symbols else []
    letters = {n: course.ledger.symbols[n] for n in names if n in course.ledger.symbols}
    open_names = {n: s for blow in course.blows.values() for n, s in blow.scene.open_names.items()}
    return Taken(
        letters={n: float(values[s]) for n, s in letters.items() if s in values},
        opened={n: float(values[s]) for n, s in open_names.items() if s in values},
        times={n: float(values[stop.t]) for n, stop in course.stops.items() if stop.t in values},
        speeds=dict(_speeds(found)),
    )


def _speeds(found: SolvedMotion) -> Iterator[tuple[str, tuple[float, float, float]]]:
    """Of the mass centres along x and y, and of turning, in the first state, of the bodies whose speeds are known."""
    course = found.course
    if not course.states:
        return
    reader, stop = course.readers[course.states[0].name], course.stops[course.states[0].name]
    for body, (v, spin) in arriving(reader.regime).items():
        parts = [reader.at(stop, sp.sympify(e)) for e in (v.x, v.y, spin)]
        if all(p.free_symbols <= found.value.values.keys() for p in parts):
            x, y, turn = (float(found.value(p)) for p in parts)
            yield body, (x, y, turn)
