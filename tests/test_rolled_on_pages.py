"""A wheel that the file places by the arc on which it has rolled: the page says so before its places."""

from __future__ import annotations

import unicodedata
from pathlib import Path

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.page.narrate import narrate

ROLLS = (
    "The disk rolls on the floor without slipping: the arc from P to the point of contact has met the floor point by"
)
TEXTBOOK = ROOT / "problems" / "textbook"


def _page(path: Path) -> str:
    return Terminal(200).render(narrate(worked(path)[0]))


@pytest.mark.parametrize("stem", ["ex-1-03", "ex-1-04", "ex-1-05"])
def test_a_wheel_placed_by_an_arc_rolls(stem: str) -> None:
    page = _page(TEXTBOOK / f"{stem}.yaml")
    page = " ".join(page.split())
    assert page.index(ROLLS) < page.index("G has advanced from x = 0 by its length, r φ.") < page.index("x_G = r φ")
    assert "φ: the angle by which the disk has turned, clockwise." in page
    assert "At φ = 0 P is straight below G (270°)." in page
    assert "r_P/G = [r cos(270° - φ), r sin(270° - φ)] = [-r sin φ, -r cos φ]" in page
    assert "x_P = x_G - r sin φ = r φ - r sin φ = r (φ - sin φ)" in page
    assert "y_P = y_G - r cos φ = r - r cos φ = r (1 - cos φ)" in page
    assert "Not used" not in page
    # Where G is follows from that; it is no datum.
    assert "G(r φ, r)" not in page


@pytest.mark.parametrize(
    ("stem", "told"),
    [
        ("ex-1-03", "P describes a cycloid. At φ = 0, 2 π, … it touches the floor"),
        (
            "ex-1-04",
            "P is at rest where it touches the floor (φ = 0, 2 π, …); at the top (φ = π) it is twice as fast as G.",
        ),
        ("ex-1-05", ""),
    ],
)
def test_what_is_worth_seeing_of_a_point_of_the_rim(stem: str, told: str) -> None:
    page = _page(TEXTBOOK / f"{stem}.yaml")
    assert told in page
    assert ("cycloid" in page) == ("cycloid" in told)


def test_a_wheel_that_slips_does_not_roll(tmp_path: Path) -> None:
    """Placed by another arc than its own, it touches the floor with a point that moves."""
    text = (TEXTBOOK / "ex-1-03.yaml").read_text(encoding="utf-8").split("answers:", maxsplit=1)[0]
    path = tmp_path / "slips.yaml"
    path.write_text(text.replace("[r*phi, r]", "[2*r*phi, r]"), encoding="utf-8")
    page = Terminal(200).render(narrate(solve_and_compare(read(str(path)))[0]))
    assert "x_G = 2 r φ" in page
    assert "rolls" not in page


def test_derivatives_by_the_chain_rule() -> None:
    page = unicodedata.normalize("NFC", _page(TEXTBOOK / "ex-1-05.yaml"))
    assert "ẏ_P = r φ̇ sin φ = r ω sin φ" in page
    assert "ẏ_G = 0" in page
    assert "ÿ_G = 0" in page
    assert "a_G = 0\n" in page


@pytest.mark.parametrize(
    ("name", "lines"),
    [
        # On a circle the centre has its normal part, and any other point is reached from it.
        (
            "kinematics/disk-in-circular-track",
            [
                "a_G = α × r_G/C + v_G²/ρ e_n = [-1.157 - 0.1299 · 4, 2.004 - 0.075 · 4] = [-1.677, 1.704] m/s²",
                "ρ = R - r_d = 0.35 m, e_n = [-0.5, 0.8660]",
                "a_C = a_G + α × r_C/G - ω² r_C/G = ",
            ],
        ),
        # What a wheel carries: the rack has the velocity of the tooth that it touches.
        (
            "kinematics/gear-between-racks",
            [
                "v_T = ω_gear × r_T/C",
                "v_K = v_T",
                "a_B = a_G + α_gear × r_B/G - ω_gear² r_B/G = [-0.4 - 0.2 · 3², 0.2 · 2] = [-2.2, 0.4] m/s²",
            ],
        ),
        # On a belt that runs the point of contact has its speed, and an acceleration across it alone.
        (
            "kinematics/wheel-on-conveyor",
            [
                "v_C = [u, 0]",
                "as conveyor at C, no slip",
                "C has an acceleration towards G only",
                "a_C = -ω² r_C/G = [0, -(-0.3) · 8.333²] = [0, 20.83] m/s²",
            ],
        ),
        # In letters a vector equation has its components once, without what was found to be zero.
        (
            "kinematics/disk-on-fixed-disk",
            ["v_G = [-(R + r) ω_arm, 0]", "a_B = a_G - ω_disk² r_B/G = [0, -(r ω_disk² + (R + r) ω_arm²)]"],
        ),
    ],
)
def test_points_of_wheels(name: str, lines: list[str]) -> None:
    page = Terminal(width=140).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))
    for told in lines:
        assert told in page


def test_a_wheel_let_go_from_rest() -> None:
    """Its mass centre off the middle has a_G = α × r_G/C; lengths without a letter are numbers with their unit."""
    page = Terminal(140).render(
        narrate(worked(ROOT / "problems/rigid-bodies/half-cylinder-let-go-on-its-side.yaml")[0])
    )
    assert "half rolls without slipping:   a_G = α × r_G/C" in page
    assert "r_G/C = [4 R/(3 π), R]" in page
    page = Terminal(140).render(narrate(worked(ROOT / "problems/kinematics/pin-where-two-slots-cross.yaml")[0]))
    assert "r_P/A = [0.25, 0.4330] m" in page
    assert "1/4" not in page
