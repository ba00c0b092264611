"""Messages point to what is off, and say by how much and what to write instead."""

from __future__ import annotations

import pytest

from planar_cli.errors import Diagnostic, FileProblem, NoSolution, Undecided
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

STACKED = """\
title: A block on a floor
plane: vertical
points: {{A: [0, {height}], Q: [0, {at}]}}
surfaces: {{floor: {{through: O, angle: 0 deg}}}}
bodies: {{block: {{particle: A, mass: 10 {mass}}}}}
joints:
  - contact: {{between: [block, floor], mu_s: 0.25, mu_k: 0.2, name: low{where}}}
loads:
  - force: {{body: block, magnitude: 200 {force}, angle: 0 deg}}
instant: [at rest]
find: {{a: a(block).x}}
"""
THROWN = """\
title: Least speed to hit a basket
plane: vertical
unknowns: {{v_0: m/s, alpha: deg}}
bodies: {{ball: {{particle: [0, 2 m], mass: any}}}}
states:
  throw: [{throw}]
  basket: [{basket}]
find: {{v_min: v_0, angle: alpha in deg}}
"""
SPEED = "t = 0, v(ball).mag = v_0, v(ball).angle = alpha"
BASKET = "x(ball) = 6 m, y(ball) = 3 m"
ROCKET = """\
title: Rocket tracked by radar
symbols: {b: m, w: rad/s, c: rad/s^2}
coordinates: {theta: deg}
points: {A: [0, 0], R: [b, b*tan(theta)]}
bodies: {rocket: {particle: R}}
instant: [dot(theta) = w, ddot(theta) = c]
find: {v: v(rocket).mag}
"""
NAMED = """\
title: A car
bodies: {car: {particle: [0, 0]}}
motion: [a(car).x = 2 m/s^2, a(car).y = 0]
states:
  0: [t = 0, at rest]
  5s: [t = 5 s]
find: {v: v(car).x @ 5s}
"""


def refused(text: str) -> tuple[Diagnostic, ...]:
    problem, wrong = load_text(text)
    if wrong:
        return tuple(wrong)
    with pytest.raises((FileProblem, NoSolution)) as error:
        solve_problem(problem)
    return tuple(error.value.diagnostics)


def block(height: str, at: str, where: str = ", at: Q", us: bool = False) -> str:
    text = STACKED.format(height=height, at=at, where=where, mass="lb" if us else "kg", force="lbf" if us else "N")
    return text.replace("points: {", "points: {O: [0, 0], ")


@pytest.mark.parametrize(
    ("height", "at", "us", "said"),
    [("0.2 m", "0", False, "0.2 m away"), ("2 ft", "0", True, "2 ft away"), ("-0.2 m", "0", False, "0.2 m away")],
)
def test_a_particle_that_is_not_drawn_where_it_is_to_touch(height: str, at: str, us: bool, said: str) -> None:
    (told,) = refused(block(height, at, us=us))
    assert told.code == "PL521"
    assert told.message == f"the particle block is not drawn at Q, where it is to touch, but {said}"


def test_a_particle_that_is_not_on_its_floor() -> None:
    (told,) = refused(block("0.2 m", "0.2 m"))
    assert (told.code, told.message) == ("PL521", "the point of contact is not on floor as drawn, but 0.2 m off")


def test_the_least_speed_is_chosen_by_what_is_to_be_reached() -> None:
    """tan α = (h + √(h² + d²))/d, v² = g (h + √(h² + d²)); written in either state."""
    answers = []
    for throw, basket in ((f"{SPEED}, v_0 is smallest", BASKET), (SPEED, f"{BASKET}, v_0 is smallest")):
        problem, _ = load_text(THROWN.format(throw=throw, basket=basket))
        answers.append({f.name: float(f.values[0]) for f in solve_problem(problem).parts[0].found if f.values})
    assert answers[0] == pytest.approx(answers[1])
    assert answers[0]["v_min"] == pytest.approx((9.81 * (1 + 37**0.5)) ** 0.5)


def test_without_an_instant_it_is_a_formula() -> None:
    (told,) = refused(ROCKET)
    assert told.code == "PL606"
    assert told.hint.endswith("or leave `instant` out: then it is a formula in theta")


def test_the_name_of_a_state_is_refused_where_it_is_given() -> None:
    first, *others = refused(NAMED)
    assert (first.code, first.mark.line) == ("PL304", 6)
    assert "`t5s`" in first.hint
    assert all("has a letter first" in told.hint for told in others)


def test_what_is_open_does_not_hide_what_is_told() -> None:
    """No formula tells the time of a fall against a linear resistance; the final speed has one."""
    problem, _ = load_text(
        """\
title: Falling with linear resistance
symbols: {k: 1/s, h: m}
bodies: {stone: {particle: [0, 0]}}
joints:
  - guide: {point: stone, along: -90 deg, name: plumb}
motion: [a(stone).along(-90 deg) = g - k*v(stone).along(-90 deg)]
states:
  top: [t = 0, at rest]
  low: [y(stone) = -h]
  end: [t = infinity]
find: {v_T: v(stone).along(-90 deg) @ end, t_low: t @ low}
"""
    )
    with pytest.raises(Undecided) as error:
        solve_problem(problem)
    assert "found for `t_low`" in str(error.value)
    assert str(error.value).endswith("asked for without what is open, `v_T` can be told")


SLOTTED = """\
title: A pin in the slot of a rod
{known}
points: {{B: [0, 0], E: [0, 0], O: [-2*R, 0], P: {{from: B, distance: R, angle: 150 deg}}}}
bodies: {{D: {{disk: B, radius: R, points: [P]}}, S: {{rod: [O, {end}]}}}}
joints:
  - pin: {{at: B, between: [ground, D]}}
  - pin: {{at: O, between: [ground, S]}}
  - guide: {{point: P, along: S}}
motion: [omega(D) = 10 rad/s]
find: {{w_S: omega(S)}}
"""


@pytest.mark.parametrize(
    ("known", "end", "said"),
    [
        ("given: {R: 50 mm}", "E", "slot of S through P parallel to its line, 0.025 m beside it"),
        ("given: {R: 2 ft}", "E", "slot of S through P parallel to its line, 1 ft beside it"),
        ("symbols: {R: m}", "E", "slot of S through P parallel to its line"),
        ("given: {R: 50 mm}", "P", ""),
        ("symbols: {R: m}", "P", ""),
    ],
)
def test_a_slot_beside_the_line_of_its_rod_is_told(known: str, end: str, said: str) -> None:
    """A pin that is drawn off the rod makes a slot parallel to it: where that is a slip, the page shows it."""
    problem, _ = load_text(SLOTTED.format(known=known, end=end))
    page = " ".join(Terminal().render(narrate(solve_problem(problem))).split())
    assert (said in page) if said else ("parallel to its line" not in page)


@pytest.mark.parametrize(
    ("used", "hint"),
    [
        ("v_1", "ask for it in a case, `first: {find: {v_1: …}}`, and write `first.v_1` in a later one"),
        ("v_2", "write `second.v_2` for the find of the earlier case"),
    ],
)
def test_a_find_that_a_case_names_alone(used: str, hint: str) -> None:
    """A find of the file itself, and one of an earlier case without the name of the case."""
    (told,) = refused(
        f"""\
title: A case that goes on
bodies: {{P: {{particle: [0, 0]}}}}
motion: [v(P).x = 3 m/s, v(P).y = 0]
find: {{v_1: v(P).x}}
cases:
  second: {{find: {{v_2: v(P).mag}}}}
  third: {{given: {{u: {used}}}, find: {{v_3: u + v(P).x}}}}
"""
    )
    assert told.code == "PL410"
    assert told.hint.endswith(hint)


@pytest.mark.parametrize("quote", ["", '"'])
def test_a_table_in_a_law_of_motion(quote: str) -> None:
    """With quotes it is no expression, and without them it is no YAML."""
    law = f"{quote}v(P).x = {{table: [[0 s, 0 m/s], [4 s, 8 m/s]]}}{quote}"
    (told,) = refused(
        f"""\
title: A diagram of the velocity
bodies: {{P: {{particle: [0, 0]}}}}
motion:
  - {law}
  - v(P).y = 0
states: {{1: [t = 0], 2: [t = 4 s]}}
find: {{d: x(P) @ 2}}
"""
    )
    assert (told.code, told.mark.line) == ("PL202", 4)
    assert "for each stretch" in told.hint
