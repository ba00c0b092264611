"""What slides along a body that turns has its vector equation, with the Coriolis acceleration as its own term."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.narrate import narrate


def _page(name: str) -> str:
    return Terminal(width=140).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


@pytest.mark.parametrize(
    ("name", "lines"),
    [
        (
            "kinematics/collar-on-rotating-rod",
            [
                "v_P = ω × r_P/O + v_P,rod e = [-0.6557, 1.982] m/s",
                "a_P = α × r_P/O - ω² r_P/O + a_P,rod e + 2 ω × v_P,rod e = [-8.610, -2.000] m/s²",
                "a_across = -0.5736 (-8.610) + 0.8192 (-2.000) = 3.3 m/s²",
            ],
        ),
        (
            "kinematics/ring-on-two-turning-rods",
            [
                "v_P = ω_AE × r_P/A + v_P/AE e",
                "a_P = -ω_AE² r_P/A + a_P/AE e + 2 ω_AE × v_P/AE e = [-1.333, -5.081] m/s²",
            ],
        ),
        ("kinematics/pin-in-two-slotted-rods", ["a = |a_P| = √(7.778² + 140.5²) = 140.7 ft/s²"]),
    ],
)
def test_sliding_along_a_turning_body(name: str, lines: list[str]) -> None:
    page = _page(name)
    for told in lines:
        assert told in page
    assert page.count("e = [0.") == 1
