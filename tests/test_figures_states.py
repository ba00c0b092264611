"""Figures of motions: every state is drawn where the page has it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
import sympy as sp
from conftest import PROBLEMS
from worked import name_of, worked

from planar_cli.figures.drawn import Drawn
from planar_cli.solve.between.trace import MotionTrace

EVERY = 12
"""Of so many problem files one is drawn in each run, as in test_figures.py."""


def named(stem: str) -> Path:
    return next(p for p in PROBLEMS if p.stem == stem)


SEVERAL_REGIMES = [named("cylinder-down-a-slope-and-on-along-a-floor"), named("there-and-back")]


def places_of(motion: MotionTrace) -> Iterator[tuple[str, str, sp.Symbol, int]]:
    """The places of mass centres that have symbols of their own: state, body, symbol of the state, x (0) or y (1)."""
    for regime in motion.regimes:
        for name, body in regime.solution.instant.scene.bodies.items():
            for axis, general in enumerate((body.center.x, body.center.y)):
                own = (x for x, g in motion.general.items() if g == general)
                yield from ((str(motion.ledger.roles[x].at), name, x, axis) for x in own)


@pytest.mark.parametrize("path", [*PROBLEMS[::EVERY], *SEVERAL_REGIMES], ids=name_of)
def test_a_body_is_drawn_where_the_page_has_it(path: Path) -> None:
    for part in worked(path)[0].parts:
        if part.motion is None:
            continue
        for state, body, symbol, axis in places_of(part.motion):
            there = Drawn.in_state(part.motion, state)
            if there is not None and (told := part.motion.value.known(symbol)) is not None:
                spot = there.spot(there.scene.bodies[body].center)
                assert spot is not None
                assert spot[axis] == pytest.approx(float(told), abs=1e-9), (state, body)
