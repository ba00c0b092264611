"""Forces on a page: what the diagrams hold, and where the normal forces of the checks come from."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.page.narrate import narrate


def _page(name: str) -> str:
    return Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


@pytest.mark.parametrize(
    ("name", "row"),
    [
        ("friction/heaviest-weight-before-a-box-slips", "load:  W ↓,  T ↑   =   m_load a_Hy ↑\n"),
        ("particles/unknown-counterweight", "weight:  m_B g ↓,  T ↑   =   m_B a_B ↓\n"),
    ],
)
def test_an_acceleration_that_is_zero_is_not_drawn(name: str, row: str) -> None:
    """What hangs has no acceleration along which nothing acts."""
    assert row in _page(name)


@pytest.mark.parametrize(
    ("name", "row"),
    [
        ("momentum/leaking-bucket", "bucket:  g (M - q t) ↓,  F ↑   =   (M - q t) a ↑\n"),
        ("momentum/rocket-up-and-along", "rocket:  g (M - q t) ↓,  u q ↑   =   (M - q t) a ↑\n"),
        (
            "impact/ball-dropped-on-a-sprung-plate",
            "ball, plate:  m_A v_Ay,2 ↑ at A   =   m_A v_Ay,3 ↑ at A,  m_B v_B,3 ↑ at B\n",
        ),
    ],
)
def test_a_guide_that_keeps_nothing_on_its_line_is_not_drawn(name: str, row: str) -> None:
    """Nor is its force said to do no work."""
    page = _page(name)
    assert row in page
    assert "N_shaft" not in page
    assert "N_track ←" not in page


DAMPED = """\
title: Block with a damper let go
text: A block is tied to a wall by a spring and a damper and let go from rest. Where does it turn back?
plane: vertical
given: {m: 2 kg, k: 200 N/m, l: 0.5 m, c: 10 N*s/m, d: 0.1 m}
coordinates: {x: m}
points: {W: [0, 0], P: [x, 0]}
bodies: {block: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 0 deg, name: rail}
loads:
  - spring: {between: [W, P], stiffness: k, natural_length: l}
  - damper: {between: [W, P], coefficient: c}
states:
  1: [x = l + d, at rest]
  2: [v(P).x = 0]
find: {x_2: x(P) @ 2}
"""


def test_a_damper_at_rest_has_the_sense_in_which_it_counts(tmp_path: Path) -> None:
    path = tmp_path / "damped.yaml"
    path.write_text(DAMPED, encoding="utf-8")
    page = Terminal(width=110).render(narrate(solve_and_compare(read(str(path)))[0]))
    assert "k (x - l) ←,  c x\u0307 ←,  N_rail ↑   =" in page


def test_a_force_that_is_given_as_zero_is_not_drawn() -> None:
    free = _page("friction/block-held-on-slope").partition("CASE  free")[2]
    assert "block:  m g ↓,  N_A ↖,  F_A ↗   =   0\n" in free


def test_a_guide_that_carries_a_weight_is_drawn() -> None:
    assert "rocket:  g (M - q t) ↓,  u q →,  N_track ↑   =" in _page("momentum/rocket-up-and-along")


def test_a_normal_force_of_a_check_has_its_sum_of_forces() -> None:
    page = _page("friction/heaviest-weight-before-a-box-slips")
    assert "N_A = N_B + W_A = 42 lbf > 0" in page
    assert " · N_B = 12 lbf > 0" in page
    assert "N_C = m g = 490.5 N > 0" in _page("textbook/ex-4-05")


def test_a_limit_speaks_of_the_extreme_that_is_asked() -> None:
    page = _page("friction/heaviest-weight-before-a-box-slips")
    assert "At the largest W: friction at B reaches its limit, it is about to slip:" in page


@pytest.mark.parametrize(
    ("name", "rows"),
    [
        # The ball starts at the lowest point to the right; the pole falls to the right.
        ("energy/ball-that-just-rolls-round-a-loop", ["N_K ↖ at C, F_K ↗ at C", "    (1)  ↖ ΣF:   N_K - m g"]),
        ("energy/toppling-pole-that-stops-pressing", ["1/2 m l α ↖ at G,  1/2 m l ω² ↙ at G"]),
    ],
)
def test_arrows_are_those_of_a_position_that_occurs(name: str, rows: list[str]) -> None:
    page = _page(name)
    assert all(row in page for row in rows)


BOWL = """\
title: Particle let go at a rim of a bowl
plane: vertical
given: {R: 0.8 m, m: 0.5 kg}
points: {O: [0, 0], P: [%sR, 0]}
surfaces: {bowl: {center: O, radius: R}}
bodies: {P: {particle: P, mass: m}}
joints: [{guide: {point: P, along: bowl}}]
states:
  1: [at rest]
  2: ["y(P) = -R*sin(45 deg)"]
find: {N: N(P) @ 2}
"""


@pytest.mark.parametrize(("side", "row"), [("", "↖"), ("-", "↗")])
def test_the_side_on_which_a_body_slides_down_tells_the_arrows(tmp_path: Path, side: str, row: str) -> None:
    page = _page_of(tmp_path, BOWL % side)
    assert f"P:  m g ↓,  N_P {row}   =   m a_Pt" in page
    assert f"(1)  {row} ΣF:   m g sin φ_P + N_P = m v_P²/R" in page


def test_a_rope_that_keeps_its_end_at_rest() -> None:
    """Why the end has no acceleration at all, the vector once, and a check by moments about the mass centre."""
    page = _page("rigid-bodies/beam-on-two-ropes")
    assert "no force acts across the rope A, and A has no acceleration along it:" in page
    assert "a_B along y" not in page
    assert "Check       beam: ↺ ΣM_G = -44.145 N·m, I α = -44.145 N·m · " in page


def test_a_check_by_moments_needs_no_force_through_the_centre() -> None:
    assert "spool: ↻ ΣM_G = 30 - 17.63 = 12.37 N·m, I_G α = 12.37 N·m" in _page("textbook/ex-4-05")


LIMACON = """\
title: Pin driven by a slotted arm along a limacon
plane: horizontal
given: {b: 0.2 m, c: 0.1 m}
points:
  O: [0, 0]
  P: {from: O, distance: 0.25 m, angle: 60 deg}
  E: {from: O, distance: 0.4 m, angle: 60 deg}
surfaces: {groove: {r: b + c*cos(theta)}}
bodies: {arm: {rod: [O, E]}, pin_P: {particle: P, mass: 0.4 kg}}
joints:
  - pin: {at: O, between: [ground, arm]}
  - guide: {point: P, along: arm, name: slot}
  - guide: {point: P, along: groove, name: track}
motion: [omega(arm) = 5 rad/s]
find: {F: N(slot), N: N(track)}
"""
PULLEY = """\
title: Block on a table and a movable pulley
plane: vertical
given: {r: 100 mm}
points: {A: [0, 0], P: [1 m, 0], B: [1.1 m, -1 m], Q: [1.2 m, 0]}
surfaces: {table: {through: A, angle: 0 deg}}
bodies:
  A: {particle: A, mass: 10 kg}
  B: {disk: B, radius: r, mass: 5 kg, inertia: 0}
joints:
  - contact: {between: [A, table], mu: 0.1}
  - rope: {path: [A, P, under B, Q], name: cord}
instant: [at rest]
find: {a_A: a(A).x, a_B: a(B).y, T: tension(cord)}
"""


def _page_of(tmp_path: Path, text: str) -> str:
    file = tmp_path / "problem.yaml"
    file.write_text(text)
    return Terminal(width=110).render(narrate(solve_and_compare(read(str(file)), None)[0]))


def test_of_two_normals_at_a_place_the_force_tells_which(tmp_path: Path) -> None:
    page = _page_of(tmp_path, LIMACON)
    assert "pin_P, along N_slot:\n    (4)  ↖ ΣF:" in page
    assert "N_slot = " in page
    assert "along the normal at P" not in page


def test_bodies_that_a_rope_pulls_apart_have_equations_of_their_own(tmp_path: Path) -> None:
    page = _page_of(tmp_path, PULLEY)
    assert "perpendicular to T" not in page
    assert "where the total reaction" not in page
    assert "  B:  m_B g ↓ at B,  T ↑,  T ↑   =   m_B a_B ↑ at B\n" in page
    assert "(4)  → ΣF_x:   T - μ N_A = m_A a_A" in page


DISK_AND_BAR = """\
title: Rolling disk with a bar hinged to its centre (after 4.20)
plane: vertical
given: {R: 0.3 m, l: 1.2 m}
points:
  C: [0, 0]
  A: [0, R]
  B: {from: A, distance: l, angle: -45 deg}
surfaces: {shelf: {through: C, angle: 0 deg}}
bodies:
  disk: {disk: A, radius: R, mass: 15 kg}
  bar: {rod: [A, B], mass: 10 kg}
joints:
  - rolling: {between: [disk, shelf], at: C}
  - pin: {at: A, between: [disk, bar]}
instant: [at rest]
find:
  a_A: a(A).x
  alpha_bar: alpha(bar)
  pin_on_bar: reaction(A/bar)
  F: friction(C).x
  N: N(C)
"""


def test_a_moment_centre_tells_what_does_not_enter(tmp_path: Path) -> None:
    page = _page_of(tmp_path, DISK_AND_BAR)
    assert "about K at (0, -0.8314 m), chosen so that A_y, α_bar do not enter:" in page
    assert "virtual motion" not in page


def test_no_side_of_an_energy_stands_twice(tmp_path: Path) -> None:
    page = _page_of(tmp_path, BOWL % "")
    assert "T_2 = 1/2 m v_P,2²\n" in page
    assert "(2)  T_1 + U = T_2:   -m g R sin φ_P,2 = 1/2 m v_P,2²\n" in page
    assert page.count("1/2 m v_P,2²") == 2


def test_friction_that_is_found_to_be_zero_stands_on_the_diagrams() -> None:
    """Whether the wheels slip is asked: the friction that answers it acts on both, and an equation gives it."""
    page = _page("momentum/two-wheels-pressed-together")
    assert page.count("F_C ↑ at C (assumed)") == page.count("F_C ↓ at C (assumed)") == 1
    assert "↺ ΣM_A:   F_C R = I_large α_large" in page
    assert "x_B" not in page
