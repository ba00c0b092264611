"""Particles in polar coordinates: radial and transverse components (equation/kinematics/components.py), chosen where
all that acts passes through one fixed point (solve/central.py).
"""

from __future__ import annotations

import pytest
import sympy as sp

from planar_cli.errors import Undecided
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.central import in_polar_coordinates
from planar_cli.solve.run import solve_problem

PENDULUM = """\
plane: vertical
given: {l: 2 m, m: 3 kg}
coordinates: {phi: deg}
points: {O: [0, 0], P: {from: O, distance: l, angle: phi - 90 deg}}
bodies: {bob: {particle: P, mass: m}}
joints: [link: {between: [O, P], name: cord}]
instant: [phi = 30 deg, dot(phi) = 1 rad/s]
find: {S: tension(cord), alpha: ddot(phi)}
"""
ORBIT = """\
plane: horizontal
given: {GM: 3.986e14 m^3/s^2, r_0: 7e6 m, v_0: 8200 m/s}
points: {O: [0, 0], P: PLACE}
bodies: {probe: {particle: P, mass: 1 kg}}
loads:
  - force: {body: probe, magnitude: (1 kg)*GM/r(P/O).mag^2, towards: O}
states:
  1: [t = 0, v(P).theta = v_0, v(P).r = 0 m/s]
  2: [r(P/O).mag is largest]
find: {r_2: r(P/O).mag @ 2, v_2: v(P).mag @ 2}
"""
PLACES = ["[r_0, 0]", "[0, r_0]", "[0, -r_0]", "[-r_0, 0]", "{from: O, distance: r_0, angle: 25 deg}"]


def page(text: str) -> str:
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    return Terminal(100).render(narrate(solve_problem(problem)))


def answers(text: str) -> dict[str, float]:
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    return {f.name: float(f.values[0]) for p in solve_problem(problem).parts for f in p.found if f.values}


def test_a_pendulum_is_told_along_and_across_its_cord() -> None:
    told = page(PENDULUM)
    assert "m l φ̇²" in told
    assert "m l φ̈" in told
    assert "differentiated" not in told
    found = answers(PENDULUM)
    assert found["S"] == pytest.approx(3 * (9.81 * 3**0.5 / 2 + 2))
    assert found["alpha"] == pytest.approx(-9.81 / 4)


@pytest.mark.parametrize("place", PLACES)
def test_an_orbit_is_told_by_energy_and_angular_momentum(place: str) -> None:
    text = ORBIT.replace("PLACE", place)
    told = page(text)
    assert "conservation of angular momentum about O" in told
    assert "work and kinetic energy" in told
    assert "step by step" not in told
    assert "|r" not in told
    # 1/r_2 = 2 GM/(r_0 v_0)² - 1/r_0
    far = 1 / (2 * 3.986e14 / (7e6 * 8200) ** 2 - 1 / 7e6)
    assert answers(text) == pytest.approx({"r_2": far, "v_2": 7e6 * 8200 / far})


def chosen(text: str) -> bool:
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    return in_polar_coordinates(problem) is not problem


def test_names_of_the_file_are_kept() -> None:
    text = ORBIT.replace("PLACE", "[r_0, 0]").replace("r_2: r(P/O).mag @ 2", "r: r(P/O).mag @ 2, phi: v(P).mag @ 1")
    assert chosen(text)
    assert "r_probe" in page(text)


@pytest.mark.parametrize(
    "change",
    [
        ("loads:", "loads:\n  - force: {body: probe, magnitude: 1 N, angle: 0 deg}"),
        ("loads:", "loads:\n  - drag: {body: probe, linear: 1 kg/s}"),
        ("v(P).theta = v_0, v(P).r = 0 m/s", "at rest"),
        ("plane: horizontal", "plane: vertical"),
        ("bodies: {", "bodies: {disk: {disk: O, radius: 1 m, mass: 1 kg}, "),
    ],
)
def test_only_what_always_passes_through_a_fixed_point_is_followed_about_it(change: tuple[str, str]) -> None:
    text = ORBIT.replace("PLACE", "[r_0, 0]")
    assert chosen(text)
    assert not chosen(text.replace(*change))


def test_a_puck_that_passes_through_the_point_is_solved_all_the_same() -> None:
    text = """\
plane: horizontal
points: {O: [0, 0], P: [0.5 m, 0]}
bodies: {puck: {particle: P, mass: 2 kg}}
loads: [spring: {between: [O, P], stiffness: 50 N/m, natural_length: 0 m}]
states:
  1: [t = 0, v(P).x = -1 m/s, v(P).y = 0 m/s]
  2: [t = 1 s]
find: {x: x(P) @ 2}
"""
    # x = 0.5 cos 5t - 0.2 sin 5t
    assert answers(text)["x"] == pytest.approx(0.5 * 0.28366218546 + 0.2 * 0.95892427466)


def test_velocity_and_acceleration_are_told_by_their_components() -> None:
    told = page(PENDULUM.replace("alpha: ddot(phi)", "alpha: ddot(phi), v: v(P).mag"))
    assert "v_P = l φ̇ e_φ" in told
    assert "a_P = -l φ̇² e_r + l φ̈ e_φ" in told


def test_a_coordinate_along_an_axis_needs_no_kinematics() -> None:
    text = """\
plane: vertical
given: {k: 20 N/m, m: 2 kg}
coordinates: {x: m}
points: {W: [-1 m, 0], P: [x, 0]}
surfaces: {floor: {through: [0, 0], angle: 0 deg}}
bodies: {block: {particle: P, mass: m}}
joints: [guide: {point: P, along: 0 deg}]
loads: [spring: {between: [W, P], stiffness: k, natural_length: 1 m}]
find: {eom: ddot(x)}
"""
    told = page(text)
    assert "= -k x/m" in told
    assert "differentiated" not in told


def test_a_particle_that_is_placed_by_numbers_is_a_point_of_its_name() -> None:
    text = """\
plane: horizontal
points: {O: [0, 0]}
bodies: {sat: {particle: [1 m, 0], mass: 1 kg}}
loads: [force: {body: sat, magnitude: (1 N*m^2)/r(sat).mag^2, towards: O}]
states:
  1: [t = 0, v(sat).x = 0 m/s, v(sat).y = 1.2 m/s]
  2: [r(sat).mag is largest]
find: {far: r(sat).mag @ 2, v: v(sat).mag @ 2}
"""
    # 1/far = 2/1.2² - 1
    assert answers(text) == pytest.approx({"far": 1.44 / 0.56, "v": 1.2 * 0.56 / 1.44})
    assert "conservation of angular momentum about O" in page(text)


TRANSFER = """\
plane: horizontal
symbols: {K: m^3/s^2, r_1: m, r_2: m}
unknowns: {v_A: m/s}
assume: [r_2 > r_1]
points: {O: [0, 0], A: [r_1, 0]}
bodies: {ship: {particle: A, mass: any}}
loads:
  - force: {body: ship, magnitude: mass(ship)*K/r(ship).mag^2, towards: O}
states:
  A: [t = 0, v(ship).x = 0, v(ship).y = v_A]
  B: [r(ship).mag is largest, r(ship).mag = r_2]
find: {v_A: v_A, v_B: v(ship).mag @ B, t_AB: t @ B}
"""


def test_half_an_ellipse_in_letters() -> None:
    problem, wrong = load_text(TRANSFER)
    assert problem is not None
    assert not wrong
    (time,) = next(f.expressions or () for p in solve_problem(problem).parts for f in p.found if f.name == "t_AB")
    near, far, attraction = sp.symbols("r_1 r_2 K", positive=True)
    half = sp.pi * sp.sqrt(((near + far) / 2) ** 3 / attraction)
    assert sp.simplify(time.xreplace({s: sp.Symbol(s.name, positive=True) for s in time.free_symbols}) / half) == 1


def test_what_polar_coordinates_leave_open_is_told_where_no_others_leave_less() -> None:
    """No formula is known for the time from elsewhere on an ellipse to its end; the speeds have one."""
    problem, wrong = load_text(TRANSFER.replace("v(ship).x = 0", "v(ship).x = v_A"))
    assert problem is not None
    assert not wrong
    with pytest.raises(Undecided) as error:
        solve_problem(problem)
    assert "found for `t_AB`" in str(error.value)
    assert str(error.value).endswith("asked for without what is open, `v_A`, `v_B` can be told")
