"""How paths and hodographs read: what varies, the radius of a circle, and places that stand above once only."""

from __future__ import annotations

import unicodedata

from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


def _page(name: str) -> str:
    page = Terminal(200).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))
    return unicodedata.normalize("NFC", page)


def test_each_frame_says_what_varies() -> None:
    page = _page("textbook/ex-1-01")
    assert "Path of A over the ground (s varies, h is constant):" in page
    told = " ".join(page.split())
    assert "does not turn, in which A is at rest, the origin of x′, y′ (β varies, l is constant):" in told
    assert "seen from the boom, origin at A, x″ axis along the boom (c varies):" in page
    assert "straight line through A along the boom, y″ = 0" in page
    assert "circle about A of radius l, x′² + y′² = l²" in page


def test_a_circle_has_its_radius_and_x_of_t_stands_once() -> None:
    page = _page("textbook/ex-1-12")
    assert page.count("15 cos(π t/4)") == 1
    assert "drawn from one point, v_x = ẋ_P and v_y = ẏ_P:" in page
    assert "of radius 15 m, x² + y² = 15² (lengths in m)" in page
    assert "of radius 15 π/4 = 11.78 m/s, v_x² + v_y² = (15 π/4)² (velocities in m/s)" in page


def test_what_no_step_is_left_of_keeps_its_lines() -> None:
    """A hodograph that is a straight line: v_x = 3 is its equation."""
    page = _page("motion/parabola-in-time")
    assert "v_x = 3" in page.split("Hodograph of P")[1]
