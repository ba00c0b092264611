"""Lines that were not true of what they name: points beside a curve, ways along a track, level bodies, roots."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


def page(name: str) -> str:
    """The printed page of a problem file."""
    return Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


@pytest.mark.parametrize(
    ("name", "said", "unsaid"),
    [
        ("rigid-bodies/beam-on-two-ropes", "a_B = α × r_B/A = [0, 3 (-4.905)] = [0, -14.715] m/s²", "ρ = "),
        ("rigid-bodies/bar-on-two-slanting-cords", "-0.75462 + 0.6 (-11.319)] = [-1.307, -7.546] m/s²", "ρ = "),
        (
            "rigid-bodies/plate-on-parallel-links",
            "a_G = a_Ct e_t = [0.8660 · 4.905, -0.5 · 4.905] = [4.248, -2.4525] m/s²",
            "ρ = ",
        ),
        ("particles/pendulum-tension", "ρ = l = 1.2 m", "√(l² + 4 y_P²)/2 ="),
        ("textbook/ex-1-13", "ρ = (1 + y′²)^(3/2)/y″ = (1 + 2²)^(3/2)/1 = 5 √5 m = 11.18 m", "ρ = 11.18 m\n\n"),
        ("particles/skier-in-a-parabolic-dip", "y′ = 2 c x_1 = 2 · 0.00625 · 40 = 0.5", "ρ = (1 + 4 c²"),
        ("impact/where-a-bat-meets-the-ball", "= 2.083 ft = 25 in", "d = 25 in = "),
        ("momentum/rocket-up-and-along", "a = u q / (M - q t) - g", "sin φ"),
        ("energy/slider-crank-with-a-spring", "U of the weights of crank, AB =", "U of the weight of slider"),
        ("systems/flat-faced-follower-about-to-lift", "is the same motion the opposite way", "the smaller one"),
        ("oscillations/connecting-rod-on-a-knife-edge", "T_B = 2 π/ω_0", "nothing moves"),
        ("kinematics/robot-arm-that-extends", "e_r + r ω_OA e_θ = 0.2 e_r + 1.2", "v_A = ω_OA × r_A/O"),
        ("motion/longest-throw-up-a-slope", "d_max = v0² / (g (1 + sin β))", "|cos"),
        ("kinematics/collar-on-rotating-rod", "e_r + r ω e_θ = 0.6 e_r + 0.5", "x_A = "),
        ("momentum/vane-at-its-greatest-power", "its derivative is zero.", "Newton"),
        (
            "motion/least-speed-to-a-target",
            "v_0 is smallest, so its derivative with respect to β is zero",
            "respect to β, v_0",
        ),
    ],
)
def test_a_page_says_what_is_true(name: str, said: str, unsaid: str) -> None:
    """The point of a rigid body that moves along a curve is the one that is joined to it; at rest v²/ρ is nothing."""
    printed = page(name)
    assert said in printed
    assert unsaid not in printed


def test_no_more_equations_of_one_law_are_solved_together_than_are_independent() -> None:
    """ω = α t, θ = α t²/2 and ω² = 2 α θ are two equations, not three for ω, θ and t."""
    printed = page("motion/block-in-a-slot-of-a-disk-that-starts")
    assert "t_out = 1.642 s" in printed
    assert "together" not in printed
    assert "t_out, v_P,disk,out and ω_out are found by numerical integration" in printed


def test_a_velocity_along_a_path_that_a_body_carries_is_one_as_seen_from_it() -> None:
    printed = page("motion/bob-in-a-car-that-speeds-up-ever-faster")
    assert "differentiated, along the path as seen from car:" in printed
