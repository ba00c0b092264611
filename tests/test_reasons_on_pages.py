"""What a page gives as reasons: roots that mechanics rules out, rest that matters, data that the file gives."""

from __future__ import annotations

import re

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

FILES = (
    "textbook/ex-1-03",
    "textbook/ex-1-06",
    "textbook/ex-1-07",
    "textbook/ex-1-11",
    "textbook/ex-4-11",
    "textbook/ex-4-13",
    "motion/parachutist",
    "motion/throw-up-a-slope",
    "impact/bullet-in-a-hanging-block",
    "impact/wheel-over-a-kerb",
    "momentum/lawn-sprinkler",
    "momentum/pipe-bend",
    "friction/truck-that-brakes-with-a-crate",
)
NO_MECHANICS = ("other branches", "smaller root", "larger root", "smallest root", "largest root", "along the joints")
TIME = re.compile(r"\bt_\w+ > (t_\w+)")


def _page(name: str) -> str:
    return Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


@pytest.mark.parametrize("name", FILES)
def test_reasons_are_of_mechanics(name: str) -> None:
    """A time that bounds another is found on the page; what is worked out is not called given."""
    page = _page(name)
    assert not [words for words in NO_MECHANICS if words in page]
    for earlier in TIME.findall(page):
        assert re.search(rf"\b{earlier} += ", page)
    assert not re.findall(r"given: +\S+ = [^=\n]*(?:√|\w+/[A-Za-z])[^=\n]*=", page)


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("textbook/ex-4-04", True),
        ("systems/bob-on-a-cart", True),
        ("particles/block-on-wedge", False),
        ("momentum/pipe-bend", False),
        ("friction/truck-that-brakes-with-a-crate", False),
    ],
)
def test_rest_is_said_where_speeds_would_matter(name: str, said: bool) -> None:
    """A rod that turns would have ω² terms; what can only move along a line has none, nor what stays where it is."""
    assert ("at rest: all velocities are zero" in _page(name)) is said


def test_in_the_end_a_speed_no_longer_changes() -> None:
    """The condition at t = infinity stands before the speed that follows from it."""
    page = _page("motion/parachutist")
    assert re.search(r"At end the speed no longer changes:\n +g = c v_end²/m\n +v_end = √\(m g/c\)", page)


def test_a_rate_of_flow_keeps_its_unit_and_a_speed_gets_no_sign() -> None:
    """Friction that stops a sprinkler does not turn it backward."""
    page = _page("momentum/lawn-sprinkler")
    assert "= 0.1155 kg/s, w_end would be zero." in page
    assert "other sign" not in page


LORRY = """
title: Crate that slides on a braking lorry
plane: vertical
points: {C: [0, 0], H: [3 m, 0.5 m]}
surfaces: {bed: {through: C, angle: 0 deg, body: lorry}}
bodies: {lorry: {points: [H]}, crate: {particle: C, mass: 250 kg}}
joints:
  - guide: {body: lorry, along: 0 deg}
  - contact: {between: [crate, bed], at: C, mu: 0.35}
motion: [a(lorry).x = -5 m/s^2]
states:
  1: [t = 0, v(lorry).x = 20 m/s, v(crate).x = 20 m/s]
  2: [r(crate/H).x = 0]
find: {v: v(crate/lorry).mag @ 2}
"""


def test_a_speed_that_is_positive_needs_no_sense() -> None:
    """A name that ends with y says nothing of an axis."""
    problem, _ = load_text(LORRY)
    assert problem is not None
    page = Terminal(width=110).render(narrate(solve_problem(problem)))
    assert "the positive root: it" not in page
    assert "upward" not in page


HOIST = """
title: Load lifted by a turning arm
points: {O: [0, 0], A: [1 m, 0], D: [1 m, 3 m], S: [-1 m, 0], B: [2 m, 0.5 m]}
bodies: {arm: {rod: [O, A]}, load: {particle: S}, bar: {rod: [A, B]}}
joints:
  - pin: {at: O, between: [ground, arm]}
  - pin: {at: A, between: [arm, bar]}
  - guide: {point: B, along: 0 deg}
  - guide: {point: S, along: 90 deg}
  - rope: {path: [S, D, A]}
motion: [omega(arm) = 2 rad/s]
find: {v: v(S).y, C: IC(bar)}
"""


@pytest.mark.parametrize(
    ("key", "called"),
    [("", "The rope from S to A"), (", name: cord", "The cord"), (", name: left_rope", "The left rope")],
)
def test_a_rope_is_called_once(key: str, called: str) -> None:
    problem, wrong = load_text(HOIST.replace("S, D, A]", f"S, D, A]{key}"))
    assert problem is not None, wrong
    page = Terminal(width=110).render(narrate(solve_problem(problem)))
    assert f"  {called} keeps its length" in page
    assert "C = [2, 0] m\n" in page


@pytest.mark.parametrize(
    ("stem", "reason"),
    [
        ("friction/stone-in-a-rotating-drum", "other roots: -7.093 rad/s (given: w > 0)"),
        ("friction/package-on-the-end-drum-of-a-conveyor", "(N = -5.367 N < 0)"),
    ],
)
def test_a_root_is_ruled_out_by_what_is_false_of_it(stem: str, reason: str) -> None:
    """Not by what is false of a root of another limit."""
    assert reason in _page(stem)


def test_a_height_that_stays_is_no_rest() -> None:
    """The ball slides along the floor meanwhile."""
    page = _page("momentum/ball-with-backspin-that-rolls-up-a-ramp")
    assert re.search(r"y_G,2 = R = 0\.11 m +it does not change\n", page)
    assert "rests meanwhile" not in page


@pytest.mark.parametrize("path", [
    "momentum/ball-on-a-cord-that-goes-slack",
    "energy/cylinder-that-rolls-off-a-cylinder",
    "impact/two-pendulums-that-collide",
])  # fmt: skip
def test_nobody_asks_after_the_same_root_on_the_other_side(path: str) -> None:
    """-0.5108 m of a distance, -55.15° of what starts from the top."""
    page = _page(path)
    assert "not -" not in page
    assert "reached first" not in page


WHEELS = """
title: Wheel that drives one in a guide
plane: horizontal
given: {R: 0.25 m, r: 0.15 m, M: 2 N*m, F: 50 N, m_A: 8 kg, m_B: 3 kg}
points: {A: [0, 0], C: [R, 0], B: [R + r, 0]}
bodies:
  large: {disk: A, radius: R, mass: m_A}
  small: {disk: B, radius: r, mass: m_B}
joints:
  - pin: {at: A, between: [ground, large]}
  - guide: {point: B, along: 0 deg, name: slide}
  - contact: {between: [large, small], at: C, mu: 0.5}
loads:
  - force: {body: small, at: B, magnitude: F, angle: 180 deg}
  - torque: {body: large, moment: M}
states:
  1: [at rest]
  2: [theta(large) - theta(large) @ 1 = 2 rev]
find: {w: omega(large) @ 2}
"""


def test_a_centre_that_rests_in_its_guide_is_why_its_reaction_does_no_work() -> None:
    problem, wrong = load_text(WHEELS)
    assert problem is not None, wrong
    page = " ".join(Terminal(width=110).render(narrate(solve_problem(problem))).split())
    idle = "A_x, A_y (A is fixed), N_slide (B is at rest) do no work, the internal forces N_C, F_C no net work: T_1 = 0"
    assert f"work and kinetic energy; {idle}" in page


@pytest.mark.parametrize(
    ("stem", "told"),
    [
        ("impact/pile-driven-into-soil-of-constant-resistance", "(the impulses of the weights and R are"),
        ("impact/dumbbell-dropped-on-a-floor", "(the impulse of the weight is negligible)"),
        ("impact/hinged-bars-struck", "momentum after."),
        ("energy/yo-yo", "T_thread (the point T of yoyo is at rest) does no work"),
        ("energy/plank-on-a-tree-trunk", "N_rim, F_rim (the point of contact is at rest) do no work:"),
        ("momentum/two-wheels-pressed-together", "at C both have the same velocity; along the contact:"),
        ("textbook/ex-4-13", "momentum after (the impulse of the weight is negligible)."),
        ("textbook/ex-4-14", "momentum after."),
        ("textbook/ex-4-14", "of AB about G, Σ m r² of its point masses:"),
        ("textbook/ex-4-16", "B moves along the floor, so that a_By = 0:"),
    ],
)
def test_a_reason_names_what_the_scene_has(stem: str, told: str) -> None:
    assert told in _page(stem)


@pytest.mark.parametrize("stem", ["particles/sphere-on-two-wires-in-a-circle", "friction/car-on-a-banked-curve"])
def test_what_goes_round_is_at_rest_in_its_plane(stem: str) -> None:
    """Its speed is no zero velocity."""
    page = " ".join(_page(stem).split())
    assert "at rest in the plane of the drawing, which goes round" in page
    assert "all velocities are zero" not in page


def test_a_rope_without_tension_is_not_assumed_to_be_taut() -> None:
    slow, fast, between = _page("particles/sphere-on-two-wires-in-a-circle").split("CASE")[1:]
    assert "Assume      the rope upper is taut\n" in slow
    assert "Assume      the rope lower is taut\n" in fast
    assert "Assume      the rope upper is taut; the rope lower is taut\n" in between


def test_why_moments_are_taken_about_a_constructed_point_in_the_only_equation() -> None:
    """The line of m a_C and I α have their moments cancel there."""
    page = _page("hard/rod-that-jams")
    assert page.count("moments about K at (1.167 m, 0.8660 m), chosen so that a_C, α do not enter:") == 2
