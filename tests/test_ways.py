"""What resists a motion is drawn the way it acts on each part of the way: against a rise down, against a fall up."""

from __future__ import annotations

import sympy as sp
from conftest import ROOT
from worked import worked

from planar_cli.equation.values.one_way import one_way
from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


def page(name: str) -> str:
    """The printed solution of a file, in single spaces."""
    solution, _ = worked(ROOT / "problems" / f"{name}.yaml")
    return " ".join(Terminal().render(narrate(solution)).split())


def test_a_ball_in_air_has_two_diagrams() -> None:
    text = page("motion/ball-up-with-drag")
    assert "m g ↓, c ṡ² ↓ = m s̈ ↑" in text
    assert "↑ ΣF: -m g - c ṡ² = m s̈" in text
    assert "m g ↓, c ṡ² ↑ = m s̈ ↓" in text
    assert "↓ ΣF: m g - c ṡ² = m s̈" in text
    assert "against its velocity" not in text
    assert "with v_t: s̈ = g (1 - ṡ²/v_t²)" in text


def test_what_sinks_is_held_up() -> None:
    assert "m g ↓, c |v| ↑" in page("oscillations/block-falling-through-oil")


def test_signs_are_written_out() -> None:
    c, v, g = sp.Symbol("c", positive=True), sp.Symbol("v", real=True), sp.Symbol("g", positive=True)
    assert one_way(c * v**2 * sp.sign(v) + g, {v: -1}) == g - c * v**2
    assert one_way(-c * v**2 * sp.sign(v) - g, {v: 1}).args != ()
    assert one_way(-c * v**2 * sp.sign(v) - g, {v: 1}).is_Add
    assert one_way(c * v, {v: 1}) == c * v
