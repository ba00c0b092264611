"""Where a body swings about an equilibrium: dashed, a little turned from there, with the angle that the page counts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.figures.angles import angles_of_coordinates
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.measures import measure_marks
from planar_cli.figures.positions import Later, position_of
from planar_cli.report.document.blocks import Name
from planar_cli.report.document.marks import Angle, Mark
from planar_cli.solve.between.trace.trace import MotionTrace

TURNED = Decimal("0.25")
"""So far, rad: as small as can be seen."""


def at_equilibrium(drawn: Drawn, motion: MotionTrace) -> Drawn:
    """A scene in the equilibrium about which alone it swings, as far as that tells where it is."""
    return _put(drawn, {q: rest for q, x in _places(motion) if (rest := motion.value.known(x)) is not None})


def deflected(drawn: Drawn, motion: MotionTrace) -> Later | None:
    """Turned by a little from the equilibrium that is drawn, and about which alone it swings; None: no angle that is
    zero there tells the position.
    """
    angles = [(q, motion.value.known(x)) for q, x in _places(motion) if motion.ledger.units[q].turns]
    # What turns all the time, as a hoop that is driven, does not swing: its speed does not vary.
    speeds = {str(g.name) for _, g in _there(motion)}
    swings = [(q, r) for q, r in angles if len(angles) == 1 or f"{q.name}_dot" in speeds]
    turned = {q: rest + TURNED for q, rest in swings if rest is not None}
    return position_of((), _put(drawn, turned)) if turned and not any(rest for _, rest in swings) else None


def _put(drawn: Drawn, places: Mapping[sp.Symbol, Decimal]) -> Drawn:
    here = {q: x for q, x in drawn.here.items() if q not in places}
    return Drawn(drawn.scene, drawn.value.extended(places), here, drawn.beside)


def angles_there(place: Later, motion: MotionTrace) -> Iterator[Mark]:
    """The angles by whose letters it is turned."""
    there, letters = place.there, {Name(str(q.name)) for q, _ in _places(motion)}
    points = {p.name: s for p in there.scene.problem.points if (s := there.named(p.name)) is not None}
    marks = [*measure_marks(there, there.scene.problem, points, {}), *angles_of_coordinates(there)]
    told: set[Name] = set()
    for mark in marks:
        own = letters & {*mark.words} if isinstance(mark, Angle) else set()
        if own - told:
            told |= own
            yield mark


def swings_alone(motion: MotionTrace, states: Sequence[str]) -> bool:
    """Are all states equilibria about which it is asked how it swings?"""
    return bool(states) and {*states} <= {o.state for o in motion.oscillations}


def _places(motion: MotionTrace) -> Iterator[tuple[sp.Symbol, sp.Symbol]]:
    """The coordinates of its general position with what stands for them in the equilibrium."""
    yield from ((g, x) for x, g in _there(motion) if motion.ledger.units[g].places)


def _there(motion: MotionTrace) -> list[tuple[sp.Symbol, sp.Symbol]]:
    """What varies, in the first equilibrium, with what it is in general."""
    states = [o.state for o in motion.oscillations[:1]]
    return [(x, g) for x, g in motion.general.items() if motion.ledger.roles[x].at in states]
