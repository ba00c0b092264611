"""Logarithms stand of ratios; a law that is given is not told again; the principle says over what is integrated."""

from __future__ import annotations

import sympy as sp
from conftest import ROOT
from worked import worked

from planar_cli.equation.values.ledger import Ledger
from planar_cli.formats.terminal import Terminal
from planar_cli.report.notation.logarithms import of_ratios
from planar_cli.report.page.narrate import narrate
from planar_cli.units import parse_unit


def page(name: str) -> str:
    """The printed solution of a file."""
    solution, _ = worked(ROOT / "problems" / f"{name}.yaml")
    return Terminal().render(narrate(solution))


def letters() -> tuple[Ledger, list[sp.Symbol]]:
    """A ledger with masses M and m, a pure number n and a time t."""
    ledger = Ledger()
    found = [sp.Symbol(name, positive=True) for name in ("M", "m", "n", "t")]
    ledger.units |= {s: parse_unit(u) for s, u in zip(found, ("kg", "kg", "1", "s"), strict=True)}
    return ledger, found


def test_two_of_one_kind_become_one() -> None:
    ledger, (big, small, n, t) = letters()
    assert of_ratios(t * sp.log(big) - t * sp.log(small), ledger) == t * sp.log(big / small)
    assert of_ratios(sp.log(big + small) - sp.log(small), ledger) == sp.log(1 + big / small)
    assert of_ratios(sp.log(n + 1) - sp.log(n), ledger) == sp.log(n + 1) - sp.log(n)


def test_what_is_no_ratio_stays() -> None:
    ledger, (big, _, _, t) = letters()
    assert of_ratios(sp.log(big) + sp.log(t), ledger) == sp.log(big) + sp.log(t)


def test_the_height_of_a_ball_in_air() -> None:
    assert "s_top = v_t² ln(1 + ṡ_hand²/v_t²) / (2 g)" in page("motion/ball-up-with-drag")


def test_a_given_law_is_told_once() -> None:
    text = page("textbook/ex-1-08")
    assert "θ̈ = g/r cos θ; let_go" in text
    assert "For the coordinate" not in text
    assert "Integration over the angle: ω dω = α dθ." in text


def test_damped_vibrations_have_their_principle() -> None:
    assert "solved by its characteristic equation." in " ".join(page("oscillations/damped-block-three-ways").split())
