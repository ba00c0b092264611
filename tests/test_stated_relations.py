"""What a file states of one instant is never ignored: inequalities, known numbers, speeds without a sense."""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path

import pytest
import sympy as sp
from answered import assert_close, solve
from click.testing import CliRunner

from planar_cli.by_click import cli
from planar_cli.errors import NoSolution
from planar_cli.problem.structure import load_text
from planar_cli.solve.run import solve_problem

CRATE = """
title: Crate on a smooth floor
plane: vertical
given: {{P: 50 N, Q: 40 N}}
points: {{C: [0, 0]}}
surfaces: {{floor: {{through: C, angle: 0 deg}}}}
bodies: {{crate: {{particle: C, mass: 20 kg}}}}
joints:
  - contact: {{between: [crate, floor], at: C, mu: 0}}
loads:
  - force: {{body: crate, magnitude: P, angle: 0 deg}}
instant: [at rest, {stated}]
find: {{a: a(crate).x}}
"""

PAINLEVE = """
title: Rod that slides on a very rough floor while it rises
plane: vertical
points: {{A: [0, 0], B: {{from: A, distance: 2 m, angle: 120 deg}}}}
surfaces: {{floor: {{through: A, angle: 0 deg}}}}
bodies: {{rod: {{rod: [A, B], mass: 1 kg}}}}
joints:
  - contact: {{between: [rod, floor], at: A, mu: 1.5}}
instant: [v(A).x = 1 m/s, omega(rod) = 4 rad/s, {stated}]
find: {{alpha: alpha(rod)}}
"""

TURNING = """
title: Rod that turns
plane: vertical
points: {{O: [0, 0], B: [1 m, 0]}}
bodies: {{rod: {{rod: [O, B], mass: 3 kg}}}}
joints:
  - pin: {{at: O, between: [ground, rod]}}
instant: [{stated}]
find: {{{asked}}}
"""

CORD = """
title: Two blocks on a cord
points: {A: [0, 0], C: [1 m, 1 m], B: [2 m, 0]}
bodies: {a: {particle: A}, b: {particle: B}}
joints:
  - guide: {point: A, along: 90 deg}
  - guide: {point: B, along: 90 deg}
  - rope: {path: [A, C, B], along: 90 deg, name: cord}
"""


def refusal(text: str) -> tuple[str, str, str]:
    """Code, message and hint of why there is no answer."""
    with pytest.raises(NoSolution) as caught:
        solve(text)
    (diagnostic,) = caught.value.diagnostics
    return diagnostic.code, diagnostic.message, diagnostic.hint


def test_an_inequality_that_holds_changes_nothing() -> None:
    assert_close(solve(CRATE.format(stated="a(crate).x > 0"))["a"], "2.5")
    assert_close(solve(CRATE.format(stated="P > Q"))["a"], "2.5")


def test_an_inequality_that_every_outcome_makes_false_is_told() -> None:
    code, message, _ = refusal(CRATE.format(stated="a(crate).x < 0"))
    assert code == "PL617"
    assert message == "`a(crate).x < 0` does not hold: the sides are 2.5 m/s^2 and 0 m/s^2"


@pytest.mark.parametrize("stated", ["P < Q", "P = Q", "P + Q <= 80 N"])
def test_a_relation_of_known_numbers_is_checked(stated: str) -> None:
    code, message, _ = refusal(CRATE.format(stated=stated))
    right = "80 N" if "80" in stated else "40 N"
    left = "90 N" if "80" in stated else "50 N"
    assert code == "PL616"
    assert message == f"`{stated}` does not hold: the sides are {left} and {right}"


def test_a_limit_that_is_met_exactly_holds() -> None:
    assert_close(solve(CRATE.format(stated="P + Q <= 90 N"))["a"], "2.5")
    assert refusal(CRATE.format(stated="P + Q < 90 N"))[0] == "PL616"


def test_an_inequality_chooses_among_modes() -> None:
    assert_close(solve(PAINLEVE.format(stated='"N(A) <= 0 N"'))["alpha"], 0)
    slipping = solve(PAINLEVE.format(stated='"N(A) > 1 N"'))["alpha"]
    assert slipping.values is not None
    assert slipping.values[0] < -48


def test_a_speed_without_a_sense_holds_both_ways() -> None:
    code, message, hint = refusal(TURNING.format(stated="v(B).mag = 2 m/s", asked="omega: omega(rod)"))
    assert code == "PL618"
    assert message == "`v(B).mag = 2 m/s` holds both ways, and the answers differ"
    assert hint == "write `v(B).y > 0` or `v(B).y < 0`"


@pytest.mark.parametrize(("side", "omega"), [(">", 2), ("<", -2)])
def test_the_relation_that_is_named_chooses(side: str, omega: int) -> None:
    stated = f'v(B).mag = 2 m/s, "v(B).y {side} 0"'
    assert_close(solve(TURNING.format(stated=stated, asked="omega: omega(rod)"))["omega"], omega)


def test_both_ways_are_one_answer_where_what_is_asked_is_the_same() -> None:
    problem, _ = load_text(TURNING.format(stated="v(B).mag = 2 m/s", asked="pull: reaction(O).x"))
    assert problem is not None
    (part,) = solve_problem(problem).parts
    assert_close(part.found[0], -6)
    assert [s.objection for s in part.instants[0].left_out] == ["it holds as well, and what is asked is the same"]


def test_a_rope_of_pure_kinematics_keeps_its_length() -> None:
    problem, _ = load_text(CORD + "instant: [v(A).y = 1 m/s]\nfind: {v: v(B).y}\n")
    assert problem is not None
    (part,) = solve_problem(problem).parts
    assert_close(part.found[0], -1)
    assert not any(mode.words for mode in part.instants[0].trial.system.modes.values())
    with pytest.raises(NoSolution):
        solve(CORD + "instant: [v(A).y = -1 m/s, v(B).y = -1 m/s]\nfind: {a: r(A/B).mag}\n")
    with pytest.raises(NoSolution):
        solve(CORD + "instant: [v(A).y = 1 m/s, v(B).y = 1 m/s]\nfind: {v: v(B).y}\n")


BOAT = """
title: Boat that is braked by the power 3/2 of its speed
given: {{c: {c}, v_0: 50 m/s}}
bodies: {{boat: {{particle: [0, 0]}}}}
motion: [a(boat).x = -c*v(boat).x^(3/2), y(boat) = 0]
states:
  1: [t = 0, v(boat).x = v_0]
  2: [v(boat).x = 20 m/s]
find: {{T: t @ 2}}
"""


@pytest.mark.parametrize(
    "coefficient", ["0.08 1/(m^(1/2)*s^(1/2))", "0.08 m^(-1/2)*s^(-1/2)", "(0.08 m/s^2)/(1 m/s)^(3/2)"]
)
def test_coefficients_with_broken_powers_of_units(coefficient: str) -> None:
    found = solve(BOAT.format(c=coefficient))
    assert_close(found["T"], 25 * (20**-0.5 - 50**-0.5))


STOPS = """
title: Block that stops on a floor that gets rougher
plane: vertical
given: {{mu_0: 0.2, c: 0.1 1/m}}
coordinates: {{x: m}}
points: {{O: [0, 0], P: [x, 0]}}
surfaces: {{floor: {{through: O, angle: 0 deg}}}}
bodies: {{block: {{particle: P, mass: 3 kg}}}}
joints:
  - contact: {{between: [block, floor], mu_k: mu_0 + c*x, mu_s: 0.9}}
states:
  1: [t = 0, x = 0, v(P).x = 5 m/s]
  2: [{stops}]
find: {{d: x(P) @ 2}}
"""


@pytest.mark.parametrize("stops", ["v(P) = 0", "0 = v(P)", "P at rest", "block at rest"])
def test_a_vector_that_vanishes_and_a_point_at_rest(tmp_path: Path, stops: str) -> None:
    """Solved, and confirmed by following the motion, in the same words."""
    file = tmp_path / "problem.yaml"
    file.write_text(STOPS.format(stops=stops) + "answers: {d: 3.429936 m}\n", encoding="utf-8")
    result = CliRunner().invoke(cli, ["solve", str(file)])
    assert result.exit_code == 0, result.output


SWINGS = """
title: Pendulum set swinging
plane: vertical
given: {{l: 0.9 m, v_0: 2 m/s}}
coordinates: {{beta: deg}}
points: {{O: [0, 0], B: {{from: O, distance: l, angle: beta - 90 deg}}}}
bodies: {{b: {{{body}}}}}
joints:
  - {joint}
states:
  1: [t = 0, beta = 0 deg, v(B).x = v_0]
  2: [v(B) = 0]
find: {{turns: beta @ 2}}
"""


@pytest.mark.parametrize(
    ("body", "joint", "share"),
    [
        ("particle: B, mass: 1 kg", "link: {name: rod, between: [O, B]}", 1),
        ("rod: [O, B], mass: 1 kg", "pin: {at: O, between: [ground, b]}", Fraction(2, 3)),
    ],
    ids=["particle", "end of a rod"],
)
def test_the_first_instant_at_which_a_vector_vanishes(
    tmp_path: Path, body: str, joint: str, share: Fraction | int
) -> None:
    """Not the one after it, on the other side."""
    rise = 4 / (2 * 9.81) * float(share)
    angle = math.degrees(math.acos(1 - rise / 0.9))
    file = tmp_path / "problem.yaml"
    text = SWINGS.format(body=body, joint=joint) + f"answers: {{turns: {angle:.9f} deg}}\n"
    file.write_text(text, encoding="utf-8")
    result = CliRunner().invoke(cli, ["solve", str(file)])
    assert result.exit_code == 0, result.output


def test_a_direction_that_is_driven_is_not_the_opposite_one() -> None:
    """x' = r' cos(2 t) - 2 r sin(2 t), r = 0.5 m + 0.1 m/s t."""
    found = solve(
        """
title: Direction driven
coordinates: {phi: rad, s: m}
points: {O: [0, 0], P: {from: O, distance: s, angle: phi}}
bodies: {p: {particle: P}}
motion: [r(P).angle = (2 rad/s)*t, s = 0.5 m + (0.1 m/s)*t]
find: {v: v(P).x}
"""
    )["v"]
    assert found.expressions is not None
    (formula,) = found.expressions
    (t,) = formula.free_symbols
    expected = sp.cos(2 * t) / 10 - 2 * (sp.Rational(1, 2) + t / 10) * sp.sin(2 * t)
    assert sp.simplify(formula - expected) == 0


TURNED = """
title: Disk that turns
plane: horizontal
points: {{O: [0, 0]}}
bodies: {{disk: {{disk: O, radius: 0.2 m, mass: 15 kg}}}}
joints:
  - pin: {{at: O, between: [ground, disk]}}
loads:
  - torque: {{body: disk, moment: 3 N*m}}
states:
  1: [t = 0, at rest]
  2: [{stated}]
find: {{omega: omega(disk) @ 2}}
"""


@pytest.mark.parametrize(
    ("stated", "omega"),
    [
        ("theta(disk) @ 2 = 8 rad", math.sqrt(160)),
        ("theta(disk) @ 2 - theta(disk) @ 1 = 8 rad", math.sqrt(160)),
        ("(omega(disk) - 1 rad/s) @ 2 = 9 rad/s", 10),
        ("t @ 2 = t @ 1 + 2 s", 20),
    ],
)
def test_a_state_may_name_itself(stated: str, omega: float) -> None:
    """`@ 2` in state 2 says the same as nothing."""
    assert_close(solve(TURNED.format(stated=stated))["omega"], omega)


GROOVE = """
title: Bead that starts at rest in the groove of a turntable
plane: horizontal
given: {r: 0.2 m, R: 0.8 m, w: 6 rad/s}
points: {O: [0, 0], P: [r, 0]}
bodies: {table: {disk: O, radius: R, mass: 1 kg}, bead: {particle: P, mass: 0.5 kg}}
joints:
  - pin: {at: O, between: [ground, table]}
  - guide: {point: P, along: table}
motion: [omega(table) = w]
states:
  1: [t = 0, v(bead/table).mag = 0]
  2: [r(bead).mag = R]
find: {t: t @ 2, v: v(bead/table).mag @ 2}
"""


def test_a_velocity_does_not_place_a_round_body() -> None:
    """Only a place stands for an angle that no drawing shows; the velocity along the groove vanishes at any angle."""
    found = solve(GROOVE)
    assert_close(found["t"], math.acosh(4) / 6)
    assert_close(found["v"], 6 * math.sqrt(0.8**2 - 0.2**2))


def test_an_assumption_of_known_numbers_is_told_with_them() -> None:
    with pytest.raises(NoSolution) as error:
        solve("title: Sizes\ngiven: {a: 2 ft, b: 3 ft}\nassume: [a < b, 2*a < b]\nfind: {x: a + b}\n")
    (told,) = error.value.diagnostics
    assert (told.code, told.message) == ("PL616", "`2*a < b` does not hold: the sides are 4 ft and 3 ft")


THREAD = """
title: Bob on a thread
plane: vertical
given: {l: 0.8 m}
unknowns: {v_0: m/s}
points: {O: [0, 0], P: [0, -l]}
bodies: {bob: {particle: P, mass: 0.3 kg}}
joints:
  - rope: {path: [O, P], name: thread}
states:
  1: [v(P).x = v_0, v_0 > 0]
  2: [y(P) = l, y(O) = PLACE, tension(thread) = 0]
find: {v: v_0}
"""


def test_where_a_fixed_point_is_not() -> None:
    """No motion is looked for that would bring it there."""
    problem, wrong = load_text(THREAD.replace("PLACE", "l"))
    assert problem is not None, wrong
    with pytest.raises(NoSolution) as error:
        solve_problem(problem)
    (told,) = error.value.diagnostics
    assert (told.code, told.mark.line) == ("PL616", 12)
    assert told.message == "`y(O) = l` does not hold: the sides are 0 m and 0.8 m"
