"""Answers that are read off a motion in numbers, where the file leaves masses or inertias out: are they the same with
others?
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.problem.language.expression import Number
from planar_cli.problem.scene.scene import Body, Problem
from planar_cli.simulate.answers import Answered
from planar_cli.simulate.run import Simulation

OTHER = Fraction(17, 10)
"""In SI units, beside 1 with which the motion was followed."""
SAME = 1e-6
"""An answer that changes by less than this part of it, or of its scale, is the same."""


def demand_any_mass(problem: Problem, found: Simulation, again: Callable[[Problem], Simulation]) -> None:
    """NoSolution: an answer is another one with another mass (or inertia) of a body that leaves it out. `again`: the
    answers of a changed problem.
    """
    for body in problem.bodies:
        for kind, repair, changed in _changed(body):
            bodies = tuple(changed if b is body else b for b in problem.bodies)
            answers = {a.name: a for a in again(replace(problem, bodies=bodies)).answers}
            for answer in found.answers:
                if not _same(answer, answers[answer.name]):
                    text = f"{answer.name} depends on the {kind} of {body.name}, which is not given and does not cancel"
                    raise NoSolution([Diagnostic(body.mark, "PL614", text, f"give it: `{repair}`")])


def _changed(body: Body) -> list[tuple[str, str, Body]]:
    """What is left out of a body, how it is given, and the body with another value of it."""
    found = []
    if body.any_mass:
        mass = Number(OTHER, "kg", 1, body.mark)
        found.append(("mass", "mass: 2 kg", replace(body, any_mass=False, mass=mass)))
    if body.any_inertia:
        inertia = Number(OTHER, "kg*m^2", 1, body.mark)
        kind, repair = "moment of inertia", "inertia: 0.1 kg*m^2` or `radius_of_gyration: 0.2 m"
        found.append((kind, repair, replace(body, any_inertia=False, inertia=inertia)))
    return found


def _same(one: Answered, other: Answered) -> bool:
    if one.word != other.word or len(one.values) != len(other.values):
        return False
    return all(abs(a - b) <= SAME * max(abs(a), one.scale) for a, b in zip(one.values, other.values, strict=True))
