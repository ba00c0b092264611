"""What is told of bodies and particles that a path leads: which point has which acceleration, along which direction."""

from __future__ import annotations

from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.narrate import narrate


def _page(name: str) -> str:
    return Terminal(width=140).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


def test_only_the_led_point_of_a_turning_body_moves_along_the_path() -> None:
    page = _page("rigid-bodies/bar-on-two-slanting-cords")
    assert "a_A = a_At e_t = [" in page
    assert "a_G = a_A + α × r_G/A = [-1.307, -7.546] m/s²" in page
    assert "ρ" not in page, "at rest there is no normal acceleration"
