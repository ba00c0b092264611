"""A speed that grows from rest has no direction before: it goes the positive way along its track."""

from __future__ import annotations

import math

import pytest
from answered import assert_close, solve

from planar_cli.errors import FileProblem
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.structure import load_text
from planar_cli.simulate.dated_by_spans import with_spans_dated
from planar_cli.simulate.run import Settings, simulate

TRACK = """
title: Car that starts
points: {O: [0, 0], S: [300 m, 0]}
surfaces:
  circle: {center: O, radius: 300 m}
  street: {through: S, angle: 60 deg}
bodies: {car: {particle: S}}
joints:
  - guide: {point: car, along: ALONG}
motion: [LAW = 2 m/s^2]
states:
  start: [t = 0, START]
  end: [t = 4 s]
find: {v: v(car).mag @ end, s: path_length(car) @ start->end, up: y(car) @ end}
"""


@pytest.mark.parametrize("start", ["at rest", "car at rest", "v(car).mag = 0"])
@pytest.mark.parametrize("law", ["a(car).t", "dot(v(car).mag)"])
def test_on_a_circle(law: str, start: str) -> None:
    answers = solve(TRACK.replace("ALONG", "circle").replace("LAW", law).replace("START", start))
    assert_close(answers["v"], 8)
    assert_close(answers["s"], 16)


@pytest.mark.parametrize("along", ["street", "60 deg"])
def test_on_a_line(along: str) -> None:
    answers = solve(TRACK.replace("ALONG", along).replace("LAW", "a(S).t").replace("START", "at rest"))
    assert_close(answers["s"], 16)
    assert_close(answers["up"], 8 * 3**0.5)


def test_what_moves_keeps_its_way() -> None:
    """Clockwise, as its first speed says."""
    answers = solve(TRACK.replace("ALONG", "circle").replace("LAW", "a(car).t").replace("START", "v(car).y = -1 m/s"))
    assert_close(answers["v"], 9)
    assert (answers["up"].values or [0])[0] < 0


@pytest.mark.parametrize("law", ["a(car).t", "dot(v(car).mag)"])
@pytest.mark.parametrize(
    ("along", "sense", "up"),
    [
        ("circle", "a(car).y < 0", -300 * math.sin(16 / 300)),
        ("circle", "0 m/s^2 > a(S).across(car/O)", -300 * math.sin(16 / 300)),
        ("circle", "a(car).y > 0", 300 * math.sin(16 / 300)),
        ("street", "a(car).x < 0", -8 * 3**0.5),
        ("240 deg", "a(car).along(60 deg) > 0", 8 * 3**0.5),
    ],
)
def test_an_inequality_of_the_start_says_which_way(law: str, along: str, sense: str, up: float) -> None:
    text = TRACK.replace("ALONG", along).replace("LAW", law).replace("START", f"at rest, {sense}")
    answers = solve(text)
    assert_close(answers["v"], 8)
    assert_close(answers["s"], 16)
    assert_close(answers["up"], up)


def test_a_negative_rate_goes_against_the_positive_way_by_itself() -> None:
    text = TRACK.replace("ALONG", "circle").replace("LAW = 2", "a(car).t = -2")
    answers = solve(text.replace("START", "at rest, a(car).y < 0"))
    assert (answers["up"].values or [0])[0] < 0


def test_a_chain_of_names_is_refused_as_anywhere() -> None:
    """Nothing is worked out of it while the file is read."""
    chain = "".join(f", c{i}: c{i - 1} + 1" for i in range(1, 3000))
    text = TRACK.replace("ALONG", "circle").replace("LAW = 2 m/s^2", "a(car).t = c2999 * 1 m/s^2")
    text = text.replace("points:", f"given: {{c0: 1{chain}}}\npoints:", 1).replace("START", "at rest, a(car).y < 0")
    problem, wrong = load_text(text)
    assert problem is None
    assert [d.code for d in wrong] == ["PL207"]


@pytest.mark.parametrize("start", ["t = 0", "t = 0, at rest"])
@pytest.mark.parametrize("law", ["v(car).mag", "v(car).t"])
def test_a_speed_that_grows_from_zero(law: str, start: str) -> None:
    """v = k t², s = k t³/3, a_t = 2 k t."""
    text = TRACK.replace("ALONG", "circle").replace("LAW = 2 m/s^2", f"{law} = 3 m/s^3 * t^2").replace("START", start)
    answers = solve(text.replace("find: {", "find: {a_t: a(car).t @ end, a_n: a(car).n @ end, "))
    for name, value in (("v", 48), ("s", 64), ("a_t", 24), ("a_n", 48**2 / 300)):
        assert_close(answers[name], value)


@pytest.mark.parametrize(
    ("law", "t", "v"), [("2 m/s^2 * t", 4, 8), ("3 m/s^3 * t^2", 16 ** (1 / 3), 3 * 16 ** (2 / 3))]
)
def test_a_length_of_path_dates_a_state(law: str, t: float, v: float) -> None:
    text = TRACK.replace("ALONG", "circle").replace("LAW = 2 m/s^2", f"v(car).mag = {law}").replace("START", "t = 0")
    text = text.replace("end: [t = 4 s]", "end: [path_length(car) @ start->end = 16 m]")
    answers = solve(text.replace("find: {", "find: {T: t @ end, a_n: a(car).n @ end, "))
    for name, value in (("T", t), ("v", v), ("a_n", v**2 / 300)):
        assert_close(answers[name], value)


@pytest.mark.parametrize("law", ["a(car).t = 2 m/s^2", "v(car).mag = 2 m/s^2 * t", "dot(v(car).mag) = 2 m/s^2"])
def test_along_a_curve_it_goes_the_way_its_variable_grows(law: str) -> None:
    """s = ∫ √(1 + 4 c² x²) dx = 31.71 m to x = 30 m; v² = 2 a_t s."""
    text = f"""
title: Car on a parabola
surfaces: {{road: {{y: (0.01 1/m)*x^2}}}}
bodies: {{car: {{particle: [0, 0]}}}}
joints:
  - guide: {{point: car, along: road}}
motion: ["{law}"]
states:
  1: [t = 0, at rest]
  2: [x(car) = 30 m]
find: {{t: t @ 2, v: v(car).mag @ 2, a_n: a(car).n @ 2}}
"""
    s = math.asinh(0.6) / 0.04 + 15 * math.sqrt(1.36)
    answers = solve(text)
    for name, value in (("t", math.sqrt(s)), ("v", math.sqrt(4 * s)), ("a_n", 4 * s * 0.02 / 1.36**1.5)):
        assert_close(answers[name], value)


ON_A_FLOOR = """
title: Car that starts
plane: vertical
points: {P: [0, 0]}
bodies: {car: {particle: P, mass: 900 kg}}
joints:
  - contact: {between: [car, ground], at: P, mu: 0}
motion: [dot(v(P).mag) = 2 m/s^2]
states:
  1: [at rest]
  2: [path_length(P) @ 1->2 = 25 m]
find: {v: v(P).mag @ 2, t: t @ 2}
"""
WHEEL = """
title: Wheel that starts
given: {R: 0.5 m}
points: {C: [0, 0], G: [0, R]}
bodies: {wheel: {disk: G, radius: R}}
joints:
  - rolling: {at: C, between: [ground, wheel]}
motion: [dot(v(G).mag) = 3 m/s^2]
states: {1: [at rest], 2: [t = 2 s]}
find: {v: v(G).mag @ 2, x: x(G) @ 2, w: omega(wheel) @ 2}
"""
ROD = """
title: Rod whose end gets faster
points: {O: [0, 0], B: [2 m, 0]}
bodies: {rod: {rod: [O, B]}}
joints:
  - pin: {at: O, between: [ground, rod]}
motion: [dot(v(B).mag) = 3 m/s^2]
states: {1: [at rest], 2: [t = 2 s]}
find: {v: v(B).mag @ 2, w: omega(rod) @ 2, theta: theta(rod) @ 2}
"""
FREE = """
title: Particle sent in a direction
bodies: {P: {particle: [0, 0]}}
motion: [dot(v(P).mag) = 2 m/s^2, v(P).angle = 30 deg]
states: {1: [at rest], 2: [t = 5 s]}
find: {v: v(P).mag @ 2, y: y(P) @ 2}
"""


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (ON_A_FLOOR, {"v": 10, "t": 5}),
        (WHEEL, {"v": 6, "x": 6, "w": -12}),
        (ROD, {"v": 6, "w": 3, "theta": 3}),
        (FREE, {"v": 10, "y": 12.5}),
    ],
)
def test_whatever_keeps_it_on_its_way(text: str, expected: dict[str, float]) -> None:
    answers = solve(text)
    followed = {a.name: a.values[0] for a in simulate(with_spans_dated(_read(text), {}), Settings()).answers}
    for name, value in expected.items():
        assert_close(answers[name], value)
        assert followed[name] == pytest.approx(value)


def test_without_a_direction_it_does_not_stay_at_rest() -> None:
    """A midpoint has no track of its own in the file; its speed grows all the same, v = a t = ω L/2."""
    text = """
points: {A: [1.2 m, 0], B: [0, 1.6 m], M: {midpoint: [A, B]}}
bodies: {rod: {rod: [A, B], points: [M]}}
joints:
  - guide: {point: A, along: 0 deg}
  - guide: {point: B, along: 90 deg}
motion: [dot(v(M).mag) = 3 m/s^2]
states: {1: [at rest], 2: [t = 0.2 s]}
find: {v: v(M).mag @ 2}
"""
    assert_close(solve(text)["v"], 0.6)
    with pytest.raises(FileProblem) as told:
        simulate(_read(text), Settings())
    why = told.value.diagnostics[0]
    assert (why.code, why.message.partition(",")[0]) == ("PL556", "the rate of the speed of M")


def _read(text: str) -> Problem:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    return problem
