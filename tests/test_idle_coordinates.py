"""What a file says of coordinates and loads takes part: what nothing moves or turns is told where it is written."""

from __future__ import annotations

import pytest
from answered import solve

from planar_cli.errors import Diagnostic, FileProblem, NoSolution

CRATE = """
title: Crate on a slope
plane: vertical
coordinates: {s: m}
points:
  O: [0, 0]
  P: {from: O, distance: s, angle: 20 deg}
bodies: {crate: {particle: O, mass: 40 kg}}
joints:
  - guide: {point: O, along: 20 deg}
loads:
  - force: {body: crate, at: O, magnitude: 320 N, angle: 20 deg, name: cable}
MOMENT
"""
STATES = """
states:
  1: [START]
  2: [s = 3 m]
find: {v: v(crate).mag @ 2}
"""


def why_not(moment: str) -> Diagnostic:
    return first_objection(CRATE.replace("MOMENT", moment))


def first_objection(text: str) -> Diagnostic:
    with pytest.raises((FileProblem, NoSolution)) as refused:
        solve(text)
    return refused.value.diagnostics[0]


@pytest.mark.parametrize("start", ["at rest, s = 0", "at rest, s = 0, dot(s) = 0"])
def test_states_follow_a_coordinate_that_moves_nothing(start: str) -> None:
    why = why_not(STATES.replace("START", start))
    assert (why.code, why.mark.line) == ("PL463", 4)
    assert why.message == "nothing moves with s: no body, joint or load stands at a point written with it"


def test_the_acceleration_of_a_coordinate_is_told_in_the_words_of_the_file() -> None:
    why = why_not("instant: [at rest, s = 2 m]\nfind: {a: a(P).mag}")
    assert (why.code, why.mark.line) == ("PL606", 4)
    assert why.message == "nothing tells ddot(s): it stands in no equation"


def test_what_acts_on_a_particle_moves_with_it() -> None:
    text = CRATE.replace("at: O,", "at: P,").replace("MOMENT", STATES.replace("START", "at rest, s = 0"))
    why = first_objection(text)
    assert (why.code, why.mark.line) == ("PL465", 12)
    assert why.message == "P moves with s; the force cable acts on crate, which is a particle at O"


def test_with_the_body_at_the_point_it_is_solved() -> None:
    text = CRATE.replace("particle: O", "particle: P").replace("point: O", "point: P").replace("at: O,", "at: P,")
    found = solve(text.replace("MOMENT", STATES.replace("START", "at rest, s = 0")))["v"].values
    assert found is not None
    assert float(found[0]) == pytest.approx((2 * 3 * (320 / 40 - 9.81 * 0.3420201433)) ** 0.5)


@pytest.mark.parametrize(
    ("load", "moment"),
    [
        ("torque: {body: c, moment: 3 N*m}", "instant: [at rest]\nfind: {a: a(c).y}"),
        ("torque: {between: [ground, c], moment: 3 N*m}", "instant: [at rest]\nfind: {a: a(c).y}"),
        (
            "impulse: {body: c, moment: 3 N*m*s, during: 1->2}",
            "states: {1: [at rest], 2: [just after 1]}\nfind: {v: v(c).y @ 2}",
        ),
    ],
)
def test_no_moment_acts_on_a_particle(load: str, moment: str) -> None:
    why = first_objection(
        "title: moment on a particle\nplane: vertical\npoints: {O: [0, 0]}\nbodies: {c: {particle: O, mass: 2 kg}}\n"
        f"loads:\n  - {load}\n{moment}\n"
    )
    assert (why.code, why.mark.line) == ("PL466", 6)
    assert why.message.endswith("acts on c, which is a particle and does not turn")
