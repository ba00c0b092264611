"""Masses that vary with time are masses only while they are positive."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.problem.language.expression import Name
from planar_cli.solve.regimes.mode_sequence import fixed_time
from planar_cli.solve.regimes.regime_sequence import RegimeSequence


def demand_mass(course: RegimeSequence, value: Valuation) -> None:
    """NoSolution: a body has no mass left at a state whose time [s] is known, in `value` or by the file itself."""
    scene = course.scene
    time = course.ledger.symbols["t"]
    varying = [b for b in scene.bodies.values() if time in b.mass.free_symbols | b.inertia.free_symbols]
    times = dict(_known_times(course, value)) if varying else {}
    for body in varying:
        mark = next(b.mark for b in course.problem.bodies if b.name == body.name)
        for state, when in times.items():
            there = value.extended({time: when})
            then = course.readers[state].regime.general.instant.scene.bodies[body.name]
            for what, expr, unit in (("mass", then.mass, "kg"), ("moment of inertia", then.inertia, "kg m²")):
                number = there.known(expr)
                if number is not None and (number < 0 or (number == 0 and what == "mass")):
                    text = f"the {what} of {body.name} is {number:.4g} {unit} in state {state}, at t = {when:.4g} s"
                    hint = (
                        "let the state come earlier; or let the flow end before it, the stream `during: 1->2` and 2 a "
                        "state `[t = T]`: from there on the mass stays"
                    )
                    raise NoSolution([Diagnostic(mark, "PL634", text, hint)])


def _known_times(course: RegimeSequence, value: Valuation) -> Iterator[tuple[str, Decimal]]:
    """The states whose time is known."""
    for state in course.states:
        stop = course.stops[state.name]
        told = fixed_time(state.relations)
        number = value.known(stop.t)
        if number is None and told is not None:
            side = told.right if isinstance(told.left, Name) and told.left.name == "t" else told.left
            number = value.known(course.scene.value(side))
        if number is not None:
            yield state.name, number
