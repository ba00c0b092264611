"""Balances of energies that are solved for what is asked: a fall, a compression, the angle of a swing."""

from __future__ import annotations

import pytest
from conftest import PROBLEMS
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.solved_problem import Solution

FILES = {p.stem: p for p in PROBLEMS}


def solved(stem: str) -> Solution:
    return worked(FILES[stem])[0]


def page(stem: str) -> str:
    """The page with single spaces."""
    return " ".join(Terminal(400).render(narrate(solved(stem))).split())


@pytest.mark.parametrize(("stem", "lines"), [
    ("ex-4-11", ["to be found: x_max = y_D,1 - y_D,2", "(M + 2 m) g x_max - 1/2 k x_max² = 0",
                 "x_max = 2 (M + 2 m) g / k =", "x_max = 0 is state 1 itself"]),
    ("ex-4-13", ["to be found: φ_max = θ_3 - θ_1", "(cos φ_max - 1)", "cos φ_max = 54.4", "φ_max = 62.46°"]),
    ("block-runs-into-a-spring", ["to be found: s = x_deepest - d", "1/2 m v0² - 1/2 k s² = 0", "s = v0 √(m/k) ="]),
    ("block-between-two-springs", ["nearest = 0.58 m", "nearest = 0.82 m is state 1 itself"]),
    ("flywheel-of-a-punch-press", ["U of the motor = M turns", "= 83.33 rad = 13.26 rev"]),
])  # fmt: skip
def test_what_is_asked_is_the_unknown(stem: str, lines: list[str]) -> None:
    told = page(stem)
    assert [line for line in lines if line not in told] == []


@pytest.mark.parametrize("stem", ["ex-4-11", "ex-4-13", "block-runs-into-a-spring", "flywheel-of-a-punch-press"])
def test_the_balance_holds_with_what_is_asked(stem: str) -> None:
    (part,) = solved(stem).parts
    motion = part.motion
    assert motion is not None
    assert motion.named
    for leg in motion.route.steps:
        if set(leg.unknowns) & motion.named.keys():
            assert all(motion.value.is_zero(e.residual.xreplace(dict(motion.route.plain))) for e in leg.relations)
    for asked, expr in motion.named.items():
        assert motion.value.is_zero(asked - expr)


def test_a_letter_that_others_need_stays_the_unknown() -> None:
    """What is told at the place of the unknown rests on the place itself."""
    for stem in ("string-that-goes-slack", "ladder-leaving-the-wall"):
        for part in solved(stem).parts:
            assert part.motion is None or not part.motion.named


def test_a_root_is_put_into_its_balance() -> None:
    assert "work and energy: T_1 + U = 0 + 6.159 - 6.159 = 0 J = T_2" in page("ex-4-11")


def test_a_length_that_a_blow_names_has_its_number() -> None:
    assert "J AS = I_A ω_2 AS = 1.5 m" in page("ex-4-13")
