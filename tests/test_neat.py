"""Formulas as a person would write them: shorter, and never another value."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from conftest import PROBLEMS
from worked import worked

from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Ledger
from planar_cli.formats.terminal import Terminal
from planar_cli.report.notation.neat import Neat
from planar_cli.report.notation.notation import plain
from planar_cli.report.page.narrate import narrate

m, R, r, g, L, k = sp.symbols("m R r g L k", positive=True)
phi, omega, theta = sp.symbols("phi omega theta", real=True)
phi_dot, theta_dot, alpha = sp.symbols("phi_dot theta_dot alpha", real=True)
SMALLER = Ledger(above_zero=(R - r,))
"""A file that assumes r < R."""
ROLL = r / (r - R) - 1

LETTERS = (
    "ball-rolling-round-a-loop",
    "disk-rolling-in-a-trough",
    "half-disk-rocking",
    "load-on-four-strands",
    "body-slider-crank-over-time",
    "throw-up-a-slope",
)
SAMPLE = [p for p in PROBLEMS if p.stem in LETTERS]
MORE = [p for p in PROBLEMS[::10] if p not in SAMPLE]
DRAWS, CERTAIN = 4, 1e-9


@pytest.mark.parametrize(
    ("expr", "text"),
    [
        (r * (R - r) * omega * sp.cos(phi) / (r - R), "-r ω cos φ"),
        (r * omega / (r - R), "-r ω / (R - r)"),
        (m * g * (R - r) * ROLL * sp.cos(phi) / R + k, "k - m g cos φ"),
        (m * r**2 * omega**2 / sp.Abs(R - r), "m r² ω² / (R - r)"),
        (sp.Rational(7, 10) * m * phi_dot**2 * (R**2 + r**2 - 2 * R * r), "0.7 m (R - r)² φ\u0307²"),
        (m * (g + R * phi_dot**2 - r * phi_dot**2), "m (g + (R - r) φ\u0307²)"),
        (sp.Abs(phi_dot) * sp.sqrt(R**2 + r**2 - 2 * R * r), "|φ\u0307| (R - r)"),
        (sp.Rational(3, 7) * (R - r) * sp.sqrt(21 * g / (R - r)), "√(27 g (R - r) / 7)"),
        (-(R - r) * sp.sqrt(g / (R - r)) / r, "-√(g (R - r))/r"),
        (sp.sqrt((4 * g * sp.cos(phi) - 4 * g) / (3 * r - 3 * R)), "√(4 g (1 - cos φ) / (3 (R - r)))"),
        (sp.sqrt(3 * g * L) * sp.Abs(sp.sqrt(sp.sin(theta))), "√(3 g L sin θ)"),
        (m * g * (1 - sp.cos(phi)), "m g (1 - cos φ)"),
        (m * (R**2 * sp.sin(phi) ** 2 + R**2 * sp.cos(phi) ** 2 - L**2), "m (R² - L²)"),
        (m * (R**2 / 2 - 16 * R**2 / (9 * sp.pi**2)), "(1/2 - 16/(9 π²)) m R²"),
        (m * k * (r - (r - R) * sp.cos(phi)), "m k (r + (R - r) cos φ)"),
        (sp.sqrt((2 * g - 2 * g * sp.cos(phi)) / L), "√(2 g (1 - cos φ) / L)"),
        (g * L * ((m * r + L) / L - 1) / r, "m g"),
        (g / (L + R * (m * R + k / R)), "g/(m R² + k + L)"),
        ((sp.sqrt(k**2 * g + m) - k * sp.sqrt(g)) / (L * sp.sqrt(g)), "(√((m + k² g)/g) - k)/L"),
    ],
)
def test_neat(expr: Any, text: str) -> None:
    assert plain(Neat(SMALLER, Valuation({}))(expr)) == text


def test_nothing_is_taken_for_granted() -> None:
    """Without `assume: r < R` a difference keeps its bars, and its sign."""
    neat = Neat(Ledger(), Valuation({}))
    for expr in (sp.Abs(R - r), r * omega / (r - R), sp.sqrt((R - r) ** 2) * omega):
        assert neat(expr) == expr


def test_what_is_under_a_root_is_positive() -> None:
    """With √(g/(R - r)) the difference cannot be negative, whatever the file says."""
    neat = Neat(Ledger(), Valuation({}))
    assert plain(neat((R - r) * sp.sqrt(g / (R - r)))) == "√(g (R - r))"
    assert plain(neat((r - R) * sp.sqrt(g / (R - r)))) == "-√(g (R - r))"


def test_common_factors_of_a_relation() -> None:
    """A length goes, the sine of a coordinate stays: it may vanish."""
    neat = Neat(SMALLER, Valuation({}))
    assert neat.sides(L * omega * sp.sin(theta), L * theta_dot * sp.sin(theta)) == (
        omega * sp.sin(theta),
        theta_dot * sp.sin(theta),
    )
    assert neat.sides(L * omega + L * alpha, sp.S.Zero) == (omega + alpha, 0)
    assert neat.sides(L * omega, r * theta_dot) == (L * omega, r * theta_dot)
    assert neat.sides((R - r) * omega, (R - r) * phi_dot) == (omega, phi_dot)


def test_a_relation_that_solves_itself_stands_once() -> None:
    """R ω = R θ̇ is ω = θ̇; the line of another equation of the same number stays."""
    path = next(p for p in PROBLEMS if p.stem == "half-disk-rocking")
    text = Terminal().render(narrate(worked(path)[0]))
    assert text.partition("CASE  rocking")[0].count(" ω = θ\u0307\n") == 1
    assert text.count("   δ\u0308 + 8 g δ / ((9 π - 16) R) = 0") == 1


@pytest.mark.parametrize("path", SAMPLE, ids=lambda p: p.stem)
def test_no_value_changes(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What is printed has the value of what was derived, wherever that is real."""
    assert _compared(path, monkeypatch) > 0 or path.stem == "throw-up-a-slope"


@pytest.mark.slow
@pytest.mark.parametrize("path", MORE, ids=lambda p: p.stem)
def test_no_value_changes_elsewhere(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The same for one file in ten."""
    _compared(path, monkeypatch)


def _compared(path: Path, monkeypatch: pytest.MonkeyPatch) -> int:
    """How many formulas of a page are written otherwise; each is compared."""
    changed: dict[tuple[Any, Any], Ledger] = {}
    plainly = Neat.__call__

    def seen(self: Neat, expr: Any) -> Any:
        found = plainly(self, expr)
        if found is not expr:
            changed[expr, found] = self.ledger
        return found

    monkeypatch.setattr(Neat, "__call__", seen)
    narrate(worked(path)[0])
    for (before, after), ledger in changed.items():
        _compare(before, after, ledger)
    return len(changed)


def _compare(before: Any, after: Any, ledger: Ledger) -> None:
    chance = random.Random(plain(before))
    symbols = {s for e in (before, after, *ledger.above_zero) for s in e.free_symbols}
    for _ in range(DRAWS):
        place = {s: _value(s, ledger, chance) for s in sorted(symbols, key=str)}
        if any(d.subs(place) <= 0 for d in ledger.above_zero):
            continue
        one, other = (complex(sp.N(e.subs(place), 20)) for e in (before, after))
        if not one.imag:
            assert abs(one - other) <= CERTAIN * max(abs(one), CERTAIN), (plain(before), plain(after), place)


def _value(symbol: sp.Symbol, ledger: Ledger, chance: random.Random) -> Any:
    known = ledger.values.get(symbol)
    return known if known is not None and known.is_number else sp.Rational(chance.randint(20, 300), 100)


def test_no_fraction_under_a_fraction_stroke() -> None:
    """Two gears: all is multiplied by both radii."""
    m_1, m_2, k_1, k_2 = sp.symbols("M_1 M_2 I_1 I_2", positive=True)
    told = Neat(Ledger(), Valuation({}))((m_1 * r / R - m_2) / (k_1 * r / R + k_2 * R / r))
    assert plain(told) == "r (M_1 r - M_2 R) / (I_1 r² + I_2 R²)"
