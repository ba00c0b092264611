"""What slides along a body that turns has its vector equation, with the Coriolis acceleration as its own term."""

from __future__ import annotations

from pathlib import Path
from unicodedata import normalize

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.page.narrate import narrate


def _page(name: str) -> str:
    return Terminal(width=140).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


@pytest.mark.parametrize(
    ("name", "lines"),
    [
        (
            "kinematics/collar-on-rotating-rod",
            [
                "r = OP = 0.5 m, ṙ = v_P,rod, r̈ = a_P,rod",
                "v_P = ṙ e_r + r ω e_θ = 0.6 e_r + 0.5 · 4 e_θ = [0.81915 · 0.6 - 0.57358 · 2, ",
                "a_r = r̈ - r ω² = -0.2 - 0.5 · 4² = -8.2 m/s²",
                "a_θ = r α + 2 ṙ ω = 0.5 (-3) + 2 · 0.6 · 4 = 3.3 m/s²",
                "a_P = a_r e_r + a_θ e_θ = [0.8192 (-8.2) - 0.5736 · 3.3, ",
                "coriolis_P = 2 ṙ ω = 2 · 0.6 · 4 = 4.8 m/s² along e_θ",
                "a_across = a_θ = 3.3 m/s²",
            ],
        ),
        (
            "kinematics/robot-arm-that-extends",
            [
                "v_A = ṙ e_r + r ω_OA e_θ = 0.2 e_r + 1.2 · 0.5 e_θ",
                "a_r = -r ω_OA² = -1.2 · 0.5² = -0.3 m/s²",
                "a_θ = 2 ṙ ω_OA = 2 · 0.2 · 0.5 = 0.2 m/s²",
            ],
        ),
        (
            "kinematics/ring-on-two-turning-rods",
            [
                "v_P = ω_AE × r_P/A + v_P/AE e",
                ", -0.3464 · 3² + 0.86603 (-1.4667) + 0.5 · 2 · 3 (-0.23094)] = [-1.333, -5.081] m/s²",
            ],
        ),
        ("kinematics/pin-in-two-slotted-rods", ["a = |a_P| = √(7.778² + 140.5²) = 140.7 ft/s²"]),
    ],
)
def test_sliding_along_a_turning_body(name: str, lines: list[str]) -> None:
    page = normalize("NFC", " ".join(_page(name).split()))
    for told in lines:
        assert normalize("NFC", told) in page
    assert page.count(" e = [0.") + page.count(" e = [cos ") + page.count(" e_r = [cos ") == 1
    assert " along " in page


def test_a_kinetic_energy_by_its_parts() -> None:
    """Of each body the velocity of its mass centre and its moment of inertia stand on the page."""
    page = _page("textbook/ex-4-07")
    for told in (
        "v_G,rod = IG ω_rod = 0.15 · 4.714 = 0.7071 m/s",
        "I_rod = 1/12 m l² = 1/12 · 0.5 · 0.3² = 0.00375 kg·m²",
        "T of disk = 1/2 M v_O² + 1/2 I_disk ω_disk² = ",
        "T of rod = 1/2 m v_G,rod² + 1/2 I_rod ω_rod² = ",
        "T = 0.75 + 0.1667 = 0.9167 J",
    ):
        assert told in page


def test_a_point_of_a_wheel_that_rolls() -> None:
    """Its velocity is ω × r about the point of contact, and is told before it is used."""
    assert "v_G = ω × r_G/C = [-0.1299 (-6), -0.075 (-6)] = [0.7794, 0.45] m/s" in _page(
        "kinematics/disk-in-circular-track"
    )
    assert "v_P = ω_wheel × r_P/C" in _page("kinematics/bar-driven-by-a-pin-on-a-rolling-wheel")


LEANING = """\
title: Rod that leans on a half cylinder
points:
  O: [0, 0]
  A: [0.5 m, 0]
  T: {from: O, distance: 0.2 m, angle: acos(0.4)}
  E: {from: A, towards: T, distance: 0.8 m}
surfaces: {drum: {center: O, radius: 0.2 m}}
bodies: {rod: {rod: [A, E]}}
joints:
  - guide: {point: A, along: 0 deg}
  - contact: {between: [rod, drum], at: T, mu: 0}
motion: [v(A).x = 1.2 m/s]
find: {omega: omega(rod)}
"""


def test_what_slides_is_the_point_of_contact(tmp_path: Path) -> None:
    """The centre of a round surface is a radius away from what slides on it."""
    file = tmp_path / "leaning.yaml"
    file.write_text(LEANING)
    page = Terminal(width=140).render(narrate(solve_and_compare(read(str(file)), None)[0]))
    assert "T slides along rod, O moves at a fixed distance from it: v_O = v_O′ + v_rel" in page
    page = _page("kinematics/eccentric-cam-with-flat-follower")
    assert "the point of contact slides along follower, G moves at a fixed distance from it: " in page
