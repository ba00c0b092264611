"""What is asked of `all` where a point is meant, of what springs store, and of loads that are called like bodies."""

from __future__ import annotations

import pytest
from answered import first, solve

from planar_cli.problem.structure import load_text
from planar_cli.simulate.run import Settings, simulate

SCENE = """title: Rod and ball, with a spring and a damper between them
plane: vertical
points: {O: [0, 0], A: [2 m, 0], B: [3 m, 1 m]}
bodies: {OA: {rod: [O, A], mass: 3 kg}, P: {particle: B, mass: 2 kg}}
joints:
  - pin: {at: O, between: [ground, OA]}
loads:
  - spring: {between: [A, B], stiffness: 100 N/m, natural_length: 1 m, name: s}
  - damper: {between: [A, B], coefficient: 3 N*s/m, name: d}
  - torque: {body: OA, moment: 3 N*m, name: M}
instant: [omega(OA) = 2 rad/s, v(P).x = 1 m/s, v(P).y = -2 m/s]
find: {q: ASKED}
"""
PUSHED = """title: Two balls on a spring
plane: horizontal
points: {A: [0, 0], B: [1 m, 0]}
bodies: {P: {particle: A, mass: 2 kg}, Q: {particle: B, mass: 3 kg}}
loads:
  - spring: {between: [A, B], stiffness: 100 N/m, natural_length: 0.5 m, name: s}
  - force: {body: P, magnitude: 10 N, angle: 0 deg, name: F}
states: {1: [t = 0, at rest], 2: [t = 0.2 s]}
find: {v: v(all).x @ 2, x: x(all) @ 2, a: a(all).x @ 1, E: PE(s) @ 1, I: I(all) @ 1, pull: force(s/Q).x @ 1}
"""
DRIVEN = """title: Two arms on one pin, with a motor between them
plane: horizontal
points: {A: [0, 0], B: [2 m, 0], C: [0, 1 m]}
bodies: {AB: {rod: [A, B], mass: 3 kg}, AC: {rod: [A, C], mass: 6 kg}}
joints:
  - pin: {at: A, between: [ground, AB, AC]}
loads:
  - torque: {between: [AB, AC], moment: 4 N*m, name: M}
instant: [at rest]
find: {on_AB: moment(M/AB), on_AC: moment(M/AC)}
"""
CALLED_LIKE_ITS_BODY = """title: Block that is pushed
plane: vertical
points: {A: [0, 0]}
bodies: {P: {particle: A, mass: 2 kg}}
loads:
  - force: {body: P, magnitude: 30 N, angle: 0 deg}
instant: [at rest]
find: {x: force(P).x, y: force(P).y, size: force(P).mag}
"""


@pytest.mark.parametrize(
    ("asked", "truth"),
    [
        ("x(all)", (3 * 1 + 2 * 3) / 5),
        ("r(all/A).mag", (0.2**2 + 0.4**2) ** 0.5),
        ("v(all).y", (3 * 2 - 2 * 2) / 5),
        ("v(all/OA).x", 0.4 + 2 * 0.4),
        ("dot(y(all))", 0.4),
        ("a(all).y", -5.709568),
        ("I(all)", 1 + 2 * 3 / 5 * (2**2 + 1)),
        ("PE(s)", 50 * (2**0.5 - 1) ** 2),
        ("dot(PE(all))", 9.81 * (3 * 2 - 2 * 2) - 100 * (2**0.5 - 1) * 5 / 2**0.5),
        ("moment(M)", 3),
        ("reaction(s/P).x", -100 * (2**0.5 - 1) / 2**0.5),
        ("force(s).mag", 100 * (2**0.5 - 1)),
    ],
)
def test_of_one_instant(asked: str, truth: float) -> None:
    assert first(solve(SCENE.replace("ASKED", asked))["q"]) == pytest.approx(truth, rel=1e-5)


def test_over_time() -> None:
    """Whatever the spring does, the mass centre goes with F/m."""
    truth = {"v": 0.4, "x": 0.64, "a": 2.0, "E": 12.5, "I": 1.2, "pull": -50.0}
    found = solve(PUSHED)
    assert {name: first(f) for name, f in found.items()} == pytest.approx(truth)
    problem, wrong = load_text(PUSHED)
    assert problem is not None, wrong
    followed = {a.name: float(a.values[0]) for a in simulate(problem, Settings()).answers}
    assert followed == pytest.approx(truth, rel=1e-6)


def test_no_mass_centre_without_mass() -> None:
    text = SCENE.replace(", mass: 3 kg", "").replace(", mass: 2 kg", "").replace("ASKED", "x(all)")
    _, wrong = load_text(text)
    assert "PL420" in [d.code for d in wrong]


def test_a_path_that_stands_still_has_no_radius() -> None:
    """Seen from the body that carries it, a point is at rest."""
    with pytest.raises(Exception, match="no value here"):
        solve(SCENE.replace("ASKED", "rho(A/OA)"))


def test_a_couple_on_each_of_two_bodies() -> None:
    found = solve(DRIVEN)
    assert (first(found["on_AB"]), first(found["on_AC"])) == pytest.approx((-4, 4))


@pytest.mark.parametrize("asked", ["force(d)", "force(s).x", "reaction(s)"])
def test_a_force_between_moving_bodies_names_the_one_it_acts_on(asked: str) -> None:
    with pytest.raises(Exception, match="several bodies"):
        solve(SCENE.replace("ASKED", asked))


def test_the_force_of_a_load_called_like_its_body_is_without_the_weight() -> None:
    found = {name: first(f) for name, f in solve(CALLED_LIKE_ITS_BODY).items()}
    assert found == pytest.approx({"x": 30, "y": 0, "size": 30})
