"""Vibrations are told by ω_n, ζ and ω_d; what a force keeps up by its sine and cosine, the rest by A and B."""

from __future__ import annotations

import pytest
import sympy as sp
from conftest import ROOT
from printed import Page, equations
from worked import worked

from planar_cli.calculus.vibrations import Vibration
from planar_cli.formats.terminal import Terminal
from planar_cli.report.motion.motion import MotionTelling
from planar_cli.report.page.narrate import narrate
from planar_cli.report.words.motion_phrases import motion_phrases

FILES = (
    "oscillations/damped-block-three-ways",
    "oscillations/block-driven-by-a-force",
    "oscillations/instrument-on-a-shaken-base",
    "oscillations/disk-on-a-torsion-wire",
    "energy/roller-onto-a-spring",
    "friction/box-on-a-belt-tied-to-a-wall",
)


def page(name: str) -> str:
    """The printed solution of a file, in single spaces."""
    solution, _ = worked(ROOT / "problems" / f"{name}.yaml")
    return " ".join(Terminal().render(narrate(solution)).split())


@pytest.mark.parametrize("name", FILES)
def test_every_line_is_true(name: str) -> None:
    solution, _ = worked(ROOT / "problems" / f"{name}.yaml")
    for motion in (part.motion for part in solution.parts if part.motion is not None):
        lines = equations(tuple(MotionTelling(motion, motion_phrases(motion, 6), 1).blocks(1)))
        shown = Page(motion.value, motion.ledger.us)
        assert not [w for e in lines for w in shown.wrong(e, 1e-3)]


@pytest.mark.slow
def test_a_frequency_given_by_a_formula_is_one_frequency() -> None:
    """w = 2 pi v/L stands in the place that shakes, and in its velocity, by its name."""
    text = page("oscillations/trailer-on-a-wavy-road")
    assert "(c A w cos(w t) + k A sin(w t) - c " in text
    assert "The forced vibration, y_p = X_c cos(w t) + X_s sin(w t):" in text


def test_free_vibrations_have_their_letters() -> None:
    text = page("oscillations/damped-block-three-ways")
    assert "natural frequency: ω_n = √(k/m) = √(200/2) = 10 rad/s" in text
    assert "damping ratio: ζ = c/(2 m ω_n) = 8 / (2 · 2 · 10) = 0.2" in text
    assert "damped frequency: ω_d = ω_n √(1 - ζ²) = 10 √(1 - 0.2²) = 9.798 rad/s" in text
    assert "t_turn = π/ω_d = π/9.798 = 0.3206 s" in text
    assert "x_later = x_0 (1 + ω_n t_later) exp(-ω_n t_later)" in text
    assert "over-damped, ζ > 1:" in text


def test_driven_vibrations_are_a_sum() -> None:
    text = page("oscillations/block-driven-by-a-force")
    assert "X_s = F_0 / (m (ω_n² - w²)) = 40 / (5 (10² - 6²)) = 0.125 m" in text
    assert "its amplitude: X = √(X_c² + X_s²)" in text
    assert "x = x_p + exp(-ζ ω_n t) (A cos(ω_d t) + B sin(ω_d t))" in text
    assert "A = -X_c = -(-0.05341) = 0.05341 m" in text
    assert "Resonance: the excitation has the natural frequency" in text


@pytest.mark.parametrize("damping", [0, sp.Rational(1, 5), 1, 3])
def test_the_four_solve_the_law(damping: sp.Expr) -> None:
    n, t = sp.Rational(3, 2), sp.Symbol("t", real=True)
    root = sp.sqrt(abs(1 - damping**2)) * n
    own = Vibration(
        natural=n,
        ratio=damping or None,
        damped=root if 0 < damping < 1 else None,
        roots=(-damping * n + root, -damping * n - root) if damping > 1 else None,
        steady=sp.S.Zero,
        free=(),
        forced=(),
    )
    kept, kept_rate, pushed, pushed_rate = own.fundamental(t)
    a, b = own.amplitudes(sp.Integer(2), sp.Integer(5), sp.Symbol("a"))
    first = a.subs("a", 0) if a.has(sp.Symbol("a")) else a
    moving = own.free_motion(t, first, b.subs("a", first))
    for motion, place, speed in ((kept, 1, 0), (pushed, 0, 1), (moving, 2, 5)):
        rest = sp.diff(motion, t, 2) + 2 * damping * n * sp.diff(motion, t) + n**2 * motion
        assert sp.N(rest.subs(t, sp.Rational(7, 10)), 30) == pytest.approx(0, abs=1e-20)
        assert sp.simplify(motion.subs(t, 0)) == place
        assert sp.simplify(sp.diff(motion, t).subs(t, 0)) == speed
    for motion, rate in ((kept, kept_rate), (pushed, pushed_rate)):
        assert sp.N((sp.diff(motion, t) - rate).subs(t, sp.Rational(7, 10)), 30) == pytest.approx(0, abs=1e-20)
