"""A method that was named does not lead to what is asked: an energy tells how fast something is, and not which way."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from planar_cli.errors import FileProblem, refuse
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.language.walk import walk
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.roots.chain import Branch
from planar_cli.solve.diagnosis.motions import title_of
from planar_cli.solve.diagnosis.words import listed
from planar_cli.solve.instant.unreached import not_reached
from planar_cli.solve.regimes.equations import Equation


def by_method_alone(course: MotionEquations, missing: Sequence[sp.Symbol], allowed: Sequence[Equation]) -> FileProblem:
    """What the laws of the method (`allowed`) leave open, in the words of the file."""
    problem = course.problem
    titles = [title for s in missing if (title := _title(course, s))]
    mark = problem.find[0].mark
    speeds = {s for stop in course.stops.values() for k, s in stop.letters.items() if k in _speeds(course)}
    one = [e for e in allowed if e.offered and len(e.residual.free_symbols & speeds & set(missing)) > 1]
    if not one or len(titles) < len(missing):
        return not_reached(problem.method, [s.name.replace("__", "_") for s in missing], mark)
    state = next(e.stop for e in one)
    text = f"{_parted(course)}method {problem.method} gives one equation for {listed(titles)}"
    points = {title.split(" in state ")[0].partition(" of ")[2].partition(" of ")[2] for title in titles}
    asked = [n for f in problem.find for n in walk(f.found.what) if isinstance(n, Quantity) and n.word == "v"]
    if len(points) == 1 and points != {""} and asked and len(asked[0].things) == 1:
        text += ": how fast it is there, and not which way"
        say = f"say which way in state {state}, as in `v({asked[0].things[0]}).angle = -30 deg`"
    else:
        say = f"say one of them in state {state}"
    return refuse(mark, "PL570", text, f"{say}; or leave `method` out: then the laws are taken that tell it")


def _parted(course: MotionEquations) -> str:
    """What parts on the way and lets the bodies move apart: why one equation is too few."""
    begins = {p.words for p in course.regimes[0].general.parted}
    words = dict.fromkeys(p.words for r in course.regimes for p in r.general.parted if p.words not in begins)
    return f"{listed(list(words))} on the way, and from there on " if words else ""


def that_tell(course: MotionEquations, needed: set[sp.Symbol], related: Sequence[Branch]) -> list[Branch]:
    """Of states that the laws of a method relate those that tell what is `needed`. FileProblem: they leave it open."""
    telling = [b for b in related if needed <= set(b.values)]
    if related and not telling:
        raise by_method_alone(course, sorted(needed - set(related[0].values), key=lambda s: s.name), course.equations)
    return telling


def _speeds(course: MotionEquations) -> set[sp.Symbol]:
    return {c.speed for regime in course.distinct_regimes() for c in regime.coordinates}


def _title(course: MotionEquations, letter: sp.Symbol) -> str:
    """A letter of a state in words; "": it is none."""
    stop = next((stop for stop in course.stops.values() if letter in stop.letters.values()), None)
    return "" if stop is None else title_of(course, stop, letter)
