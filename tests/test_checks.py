"""Checks: one table of small files and the codes that they must give, or none."""

from __future__ import annotations

import pytest

from planar_cli.problem.structure import load_text

ROD = """\
plane: vertical
given: {l: 2 m, m: 3 kg}
points: {A: [0, 0], B: [l, 0]}
surfaces: {floor: {through: B, angle: 0 deg}}
bodies: {AB: {rod: [A, B], mass: m}}
joints:
  - pin: {at: A, between: [ground, AB]}
"""
STATES = ROD + "states: {1: [t = 0, at rest], 2: [theta(AB) = -30 deg]}\n"


def codes(text: str) -> list[str]:
    return [d.code for d in load_text(text, "file.yaml")[1]]


RIGHT = [
    "instant: [at rest]\nfind: {a: alpha(AB), b: v(B/A).along(B/A), c: v(B).along(AB), d: a(B).across(30 deg)}\n",
    "instant: [AB at rest]\nfind: {a: reaction(A), b: reaction(A/AB).x, c: H(AB/A), d: I(AB/A), e: KE(all)}\n",
    "instant: [v(B) = 0]\nfind: {a: r(B) - r(A), b: dot(r(B)).x, c: ddot(theta(AB)), d: path(B), f: IC(AB)}\n",
    "loads:\n  - force: {body: AB, at: B, magnitude: m*g, angle: theta_0}\nunknowns: {theta_0: deg}\n"
    "instant: [omega(AB) = 2 rad/s]\nfind: {P: force(B), Q: power(B), R: theta_0}\n",
    "motion: [omega(AB) = 2 rad/s^2 * t]\nfind: {a: a(B).mag}\n",
    "loads:\n  - torque: {body: AB, moment: (2 N*m/s)*t, name: motor}\n"
    "instant: [t = 2 s, at rest]\nfind: {P: power(motor)}\n",
]
RIGHT_STATES = [
    "find: {a: omega(AB) @ 2, b: work(AB) @ 1->2, c: t @ 2 - t @ 1, d: reached(2), e: impulse(A).x @ 1->2}\n",
    "find: {a: mean(omega(AB)) @ 1->2, b: count(theta(AB) = 0) @ 1->2, c: path_length(B) @ 1->2, d: heat(A) @ 1->2}\n",
    "find: {a: KE(AB) @ 2/KE(AB) @ 1, b: period(2) in s, c: impulse(A/B) @ 1->2 in N*m*s, d: I(AB/A)}\n",
    "find: {a: (x(B) - x(A)) @ 2, b: v(B) @ 2 in km/h, c: omega(AB) @ 2 > 1 rad/s}\n",
]
WRONG = [
    ("instant: [at rest]\nfind: {a: alpha(ab)}\n", ["PL420"]),
    ("instant: [at rest]\nfind: {a: v_B}\n", ["PL410"]),
    ("instant: [at rest]\nfind: {a: alpha(AB) @ 2}\n", ["PL405"]),
    ("instant: [at rest]\nfind: {a: work(AB)}\n", ["PL422"]),
    ("instant: [v(B) = 3 m/s]\nfind: {a: alpha(AB)}\n", ["PL426"]),
    ("instant: [v(B).x = 3 m]\nfind: {a: alpha(AB)}\n", ["PL221"]),
    ("instant: [omega(AB) = 3]\nfind: {a: alpha(AB)}\n", ["PL225"]),
    ("instant: [just after 1]\nfind: {a: alpha(AB)}\n", ["PL405", "PL431"]),
    ("instant: [at rest]\nstates: {1: [at rest]}\nfind: {a: alpha(AB) @ 1}\n", ["PL430"]),
    ("instant: [at rest]\nfind: {a: alpha(AB)}\nanswers: {b: 3 m}\n", ["PL460"]),
    ("instant: [at rest]\nfind: {a: alpha(AB)}\nanswers: {a: 3 m}\n", ["PL224"]),
    ("instant: [at rest]\nfind: {a: v(B) in kg}\n", ["PL227"]),
    ("instant: [at rest]\nfind: {a: l, l: m}\nunknowns: {m: kg}\n", ["PL402"]),
    ("loads:\n  - force: {body: AB, at: B, magnitude: 5 lb, angle: 0 deg}\nfind: {a: alpha(AB)}\n", ["PL224"]),
    (
        "loads:\n  - force: {body: AB, at: B, magnitude: 5 N, angle: 2 m/s * t}\nfind: {a: alpha(AB)}\n",
        ["PL224", "PL411"],
    ),
    ("find: {a: alpha(AB), b: N(A), c: mode(AB)}\n", ["PL420", "PL420"]),
]


@pytest.mark.parametrize("rest", RIGHT)
def test_right(rest: str) -> None:
    assert codes(ROD + rest) == []


@pytest.mark.parametrize("rest", RIGHT_STATES)
def test_right_with_states(rest: str) -> None:
    assert codes(STATES + rest) == []


@pytest.mark.parametrize(("rest", "expected"), WRONG)
def test_wrong(rest: str, expected: list[str]) -> None:
    assert sorted(codes(ROD + rest)) == expected


def test_particles_without_mass_need_a_drive() -> None:
    start = "points: {O: [0, 0]}\n"
    assert codes(start + "bodies: {P: {particle: O}}\nfind: {v: v(P)}\n") == ["PL451"]
    assert codes(start + "bodies: {P: {particle: O}}\nmotion: [v(P).x = 2 m/s]\nfind: {v: v(P)}\n") == []
    driven = "coordinates: {s: m}\nbodies: {P: {particle: [s, 0]}}\nmotion: [dot(s) = 2 m/s]\nfind: {v: v(P)}\n"
    assert codes(start + driven) == []


def test_forces_between_moving_bodies_say_on_which() -> None:
    text = """\
points: {O: [0, 0], A: [1 m, 0], B: [2 m, 0]}
bodies: {OA: {rod: [O, A]}, AB: {rod: [A, B]}}
joints:
  - pin: {at: O, between: [ground, OA]}
  - pin: {at: A, between: [OA, AB]}
  - guide: {point: B, along: 0 deg}
motion: [omega(OA) = 2 rad/s]
"""
    assert codes(text + "find: {R: reaction(A/AB), N: N(B)}\n") == []
    assert codes(text + "find: {R: reaction(A)}\n") == ["PL424"]


def test_a_given_name_may_move_in_a_case() -> None:
    case = "cases: {open: {unknowns: {m: kg}, instant: [alpha(AB) = 3 rad/s^2 cw], find: {mass: m}}}\n"
    assert codes(ROD + case) == []


@pytest.mark.parametrize("word", ["t", "pi", "ground", "stick", "on", "Yes", "sin"])
def test_reserved_names(word: str) -> None:
    assert "PL401" in codes(f"given: {{{word}: 3 m}}\npoints: {{A: [0, 0]}}\nfind: {{x: x(A)}}\n")


def test_impacts_happen_between_two_states() -> None:
    text = """\
plane: horizontal
points: {A: [0, 0], B: [1 m, 0]}
bodies: {A: {particle: A, mass: 2 kg}, B: {particle: B, mass: 1 kg}}
joints:
  - impact: {between: [A, B], restitution: 0.5, during: 1->2}
find: {v: v(A).x @ 2, J: impulse(A/B) @ 1->2}
"""
    assert codes(text + "states: {1: [v(A).x = 3 m/s, B at rest], 2: [just after 1]}\n") == []
    assert codes(text + "states: {1: [v(A).x = 3 m/s, B at rest], 2: [t = 3 s]}\n") == ["PL433"]
