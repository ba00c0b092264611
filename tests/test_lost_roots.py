"""A root that SymPy loses is not lost: positions, path lengths, dampers, friction, data that repeat each other.

Every scene is one for which the plain call of SymPy (`solve`, `integrate`, `dsolve`, `rank`) returns too few roots,
half of an integral, the wrong regime, or nothing for a long time. The right values are written out, or worked out here
from a formula that is not the program's.
"""

from __future__ import annotations

import math
from decimal import Decimal
from typing import Any

import mpmath
import pytest
import sympy as sp
from answered import FOUR_BAR, assert_close, number, solve

from planar_cli.errors import NoSolution

PI = Decimal("3.1415926535897932384626433832795028842")


def text_of(value: Any) -> str:
    """A number of mpmath with all its digits."""
    return str(mpmath.nstr(value, 30))


# --- positions: every root of sines and tangents ---------------------------------------------------------------------

CRANK = """
title: Crank
coordinates: {theta: deg}
points: {O: [0, 0], P: {from: O, distance: 2 m, angle: theta}}
bodies: {crank: {rod: [O, P]}}
joints:
  - pin: {at: O, between: [ground, crank]}
"""
TURNING = """
title: Turning crank
points: {O: [0, 0], P: [2 m, 0]}
bodies: {crank: {rod: [O, P]}}
joints:
  - pin: {at: O, between: [ground, crank]}
motion: [omega(crank) = 1 rad/s]
"""


@pytest.mark.parametrize(
    ("relation", "side", "degrees"),
    [
        ("sin(theta) + cos(theta) = 0", "y(P) > 0", 135),
        ("sin(theta) + cos(theta) = 0", "y(P) < 0", -45),
        ("x(P) + y(P) = 0", "x(P) < 0", 135),
        ("x(P) + y(P) = 0", "x(P) > 0", -45),
        ("tan(theta) = sqrt(3)", "x(P) > 0", 60),
        ("tan(theta) = sqrt(3)", "x(P) < 0", -120),
        ("tan(theta) = sqrt(3)", "y(P) < 0", -120),
        ("y(P) = x(P)*sqrt(3)", "y(P) < 0", -120),
        ("sin(theta)^2 = 1/4", "x(P) < 0, y(P) > 0", 150),
        ("sin(theta)*cos(theta) = 1/4", "x(P) < 0, theta < -120 deg", -165),
    ],
)
def test_both_configurations(relation: str, side: str, degrees: int) -> None:
    found = solve(f"{CRANK}instant: ['{relation}', {side}]\nfind: {{theta_P: theta in deg}}\n")
    turns = (number(found["theta_P"]) * 180 / PI - degrees) / 360
    assert abs(turns - round(turns)) < Decimal("1e-20")


def test_cases_tell_the_configurations_apart() -> None:
    cases = "cases:\n"
    for name, side in (("upper", ">"), ("lower", "<")):
        cases += f"  {name}:\n    instant: [sin(theta) + cos(theta) = 0, y(P) {side} 0]\n"
        cases += f"    find: {{x_{name}: x(P)}}\n"
    found = solve(CRANK + cases)
    assert_close(found["x_upper"], -math.sqrt(2), 14)
    assert_close(found["x_lower"], math.sqrt(2), 14)


def test_passages_of_a_diagonal_in_their_order() -> None:
    """A root is missed or taken twice unless all of them are counted."""
    states = "states:\n  start: [t = 0]\n"
    states += "".join(f"  s{i}: [sin(theta(crank)) + cos(theta(crank)) = 0]\n" for i in range(1, 5))
    found = solve(TURNING + states + "find: {" + ", ".join(f"t_{i}: t @ s{i}" for i in range(1, 5)) + "}\n")
    for i in range(1, 5):
        assert_close(found[f"t_{i}"], (4 * i - 1) * PI / 4, 30)


def test_the_third_quadrant_in_time() -> None:
    states = "states:\n  start: [t = 0]\n  third: [tan(theta(crank)) = 2, x(P) < 0]\n"
    found = solve(f"{TURNING}{states}find: {{t_3: t @ third, y_3: y(P) @ third}}\n")
    assert_close(found["t_3"], text_of(mpmath.pi + mpmath.atan(2)))
    assert_close(found["y_3"], -4 / math.sqrt(5), 14)


def test_a_direction_down_to_the_left() -> None:
    found = solve("""
title: Throw to the left
plane: vertical
bodies: {P: {particle: [0, 0], mass: any}}
states:
  launch: [t = 0, v(P).x = -3 m/s, v(P).y = 10 m/s]
  down: [v(P).y = 2*v(P).x]
find: {t_d: t @ down, way: v(P).angle @ down}
""")
    assert_close(found["t_d"], Decimal(16) / Decimal("9.81"))
    assert_close(found["way"], math.atan(2) - math.pi, 14)


def rocker(crank: float, above: bool) -> float:
    """The direction of the rocker, from the triangle of the diagonal BD."""
    bx, by = 0.2 * math.cos(crank), 0.2 * math.sin(crank)
    d = math.hypot(bx - 0.6, by)
    inside = math.acos((0.4**2 + d * d - 0.5**2) / (2 * 0.4 * d))
    return math.atan2(by, bx - 0.6) + (-inside if above else inside)


@pytest.mark.parametrize("side", ["above", "below"])
def test_both_branches_of_a_four_bar_linkage(side: str) -> None:
    """The branch that is drawn is the branch that is followed, as far as the linkage goes round."""
    states = "states:\n  1: [theta(AB) = 60 deg]\n  2: [theta(AB) = 135 deg]\n"
    found = solve(FOUR_BAR.format(side=side) + states + "find: {x_C: x(C) @ 2, y_C: y(C) @ 2}\n")
    angle = rocker(math.radians(135), side == "above")
    assert_close(found["x_C"], 0.6 + 0.4 * math.cos(angle), 13)
    assert_close(found["y_C"], 0.4 * math.sin(angle), 13)


@pytest.mark.parametrize("side", ["above", "below"])
def test_a_four_bar_linkage_over_time(side: str) -> None:
    motion = "motion: [omega(AB) = 2 rad/s]\nstates:\n  1: [t = 0]\n  2: [t = 1 s]\n"
    found = solve(FOUR_BAR.format(side=side) + motion + "find: {x_C: x(C) @ 2, y_C: y(C) @ 2}\n")
    angle = rocker(math.radians(60) + 2, side == "above")
    assert_close(found["x_C"], 0.6 + 0.4 * math.cos(angle), 13)
    assert_close(found["y_C"], 0.4 * math.sin(angle), 13)


# --- integrals of sizes ----------------------------------------------------------------------------------------------

TURN = "states:\n  start: [t = 0]\n  end: [t = (2*pi) s]\n"


def test_the_way_along_an_astroid() -> None:
    """v = 3 a w |sin cos|: four branches of 3 a/2 each; the antiderivative that SymPy uses halves it."""
    found = solve(f"""
title: Astroid
plane: horizontal
given: {{a: 2 m, w: 1 rad/s}}
bodies: {{P: {{particle: [a, 0], mass: any}}}}
motion: [x(P) = a*cos(w*t)^3, y(P) = a*sin(w*t)^3]
{TURN}find: {{s: path_length(P) @ start->end, v_m: mean(v(P).mag) @ start->end}}
""")
    assert_close(found["s"], 12)
    assert_close(found["v_m"], 6 / PI)


def test_the_way_to_and_fro() -> None:
    """x = a sin²: 2 a w |sin cos| over a turn, four times the width."""
    found = solve(f"""
title: To and fro
given: {{a: 1 m, w: 1 rad/s}}
coordinates: {{x: m}}
points: {{P: [x, 0]}}
bodies: {{b: {{particle: P}}}}
joints:
  - guide: {{point: P, along: 0 deg}}
motion: [x = a*sin(w*t)^2]
{TURN}find: {{s: path_length(b) @ start->end}}
""")
    assert_close(found["s"], 4)


def test_the_mean_of_a_size() -> None:
    find = "find: {m: mean(abs(x(P)*y(P))) @ start->end, n: mean(x(P)*y(P)) @ start->end}\n"
    found = solve(TURNING + TURN + find)
    assert_close(found["m"], 8 / (2 * PI))
    assert_close(found["n"], 0)


def test_a_rectified_force() -> None:
    """∫|sin cos| over a turn is 2, and not 1."""
    found = solve("""
title: Force with a rectified sine
plane: horizontal
given: {w: 1 rad/s, F: 1 N}
points: {P: [0, 0]}
bodies: {b: {particle: P, mass: 1 kg}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - force: {body: b, at: P, magnitude: F*abs(sin(w*t)*cos(w*t)), angle: 0 deg, name: push}
states:
  start: [t = 0, at rest]
  end: [t = (2*pi) s]
find: {v_end: v(b).x @ end, J: impulse(push).x @ start->end}
""")
    assert_close(found["v_end"], 2)
    assert_close(found["J"], 2)


def test_the_work_of_friction_to_and_fro() -> None:
    """The friction of 1 N changes its direction four times in a turn."""
    found = solve(f"""
title: Rubbed to and fro
plane: horizontal
given: {{a: 1 m, w: 1 rad/s}}
bodies: {{b: {{particle: [0, 0], mass: 1 kg}}}}
loads:
  - drag: {{body: b, magnitude: 1 N, name: rub}}
motion: [x(b) = a*sin(w*t)^2, y(b) = 0]
{TURN}find: {{W: work(rub) @ start->end}}
""")
    assert_close(found["W"], -4)


X5 = "given: {c: 1 m, F: 1 N, n: 1 m/s^2, u: 1 m/s}\nplane: horizontal\n"


def root_x5(outside: Any, upper: float = 1) -> str:
    """∫ outside(√(1 + x⁵)) dx from 0 to `upper`, which has no elementary form."""
    return text_of(mpmath.quad(lambda x: outside(mpmath.sqrt(1 + x**5)), [0, upper]))


def test_work_without_an_elementary_form() -> None:
    found = solve(
        f"title: Push\n{X5}"
        """
coordinates: {x: m}
points: {P: [x, 0]}
bodies: {b: {particle: P, mass: 2 kg}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - force: {body: b, at: P, magnitude: F*sqrt(1 + (x/c)^5), angle: 0 deg, name: push}
states:
  1: [t = 0, x = 0, at rest]
  2: [x = 1 m]
find: {W: work(push) @ 1->2, v_2: v(b).x @ 2}
"""
    )
    work = root_x5(lambda r: r)
    assert_close(found["W"], work)
    assert_close(found["v_2"], Decimal(work).sqrt())


def test_laws_without_an_elementary_form() -> None:
    """a(x), v(x) and v(t) with the same root."""
    law = f"title: Law\n{X5}bodies: {{b: {{particle: [0, 0], mass: any}}}}\n"
    of_place = "states: {1: [t = 0], 2: [x(b) = 1 m]}\n"
    found = solve(f"{law}motion: [v(b).x = u*sqrt(1 + (x(b)/c)^5), v(b).y = 0]\n{of_place}find: {{t_2: t @ 2}}\n")
    assert_close(found["t_2"], root_x5(lambda r: 1 / r))
    started = of_place.replace("t = 0", "t = 0, v(b).x = 0")
    found = solve(f"{law}motion: [a(b).x = n*sqrt(1 + (x(b)/c)^5), v(b).y = 0]\n{started}find: {{v_2: v(b).x @ 2}}\n")
    assert_close(found["v_2"], (2 * Decimal(root_x5(lambda r: r))).sqrt())
    in_time = law.replace("u: 1 m/s", "T: 1 s, u: 1 m/s") + "states: {1: [t = 0], 2: [t = 1 s]}\n"
    found = solve(f"{in_time}motion: [v(b).x = u*sqrt(1 + (t/T)^5), v(b).y = 0]\nfind: {{x_2: x(b) @ 2}}\n")
    assert_close(found["x_2"], root_x5(lambda r: r))


def test_an_arc_without_an_elementary_form() -> None:
    """y = 2/7 x^(7/2), so that ds = √(1 + x⁵) dx."""
    found = solve(
        f"title: Arc\n{X5}"
        """
bodies: {b: {particle: [0, 0], mass: any}}
motion: [x(b) = u*t, y(b) = 2/7*c*(u*t/c)^(7/2)]
states: {1: [t = 0], 2: [t = 1 s]}
find: {s: path_length(b) @ 1->2}
"""
    )
    assert_close(found["s"], root_x5(lambda r: r))


# --- oscillators and pendulums ---------------------------------------------------------------------------------------

BLOCK = """
title: Damped block
plane: horizontal
{names}
coordinates: {{x: m}}
points: {{W: [-3 m, 0], P: [x, 0]}}
bodies: {{block: {{particle: P, mass: m}}}}
joints:
  - guide: {{point: P, along: 0 deg}}
loads:
  - spring: {{between: [W, P], stiffness: k, relaxed_at: [x = 0]}}
  - damper: {{between: [W, P], coefficient: c}}
"""


def test_critical_damping_with_decimals() -> None:
    """c² = 4 k m exactly, though not with floats: no sine of 7e-10 t appears, and x = 0 is never passed."""
    found = solve(
        BLOCK.format(names="given: {m: 1 kg, c: 0.2 N*s/m, k: 0.01 N/m}")
        + "states:\n  start: [t = 0, x = 1 m, at rest]\n  through: [x = 0]\n  later: [t = 10 s]\n"
        "find: {x_10: x @ later, v_10: v(block).x @ later, passes: reached(through)}\n"
    )
    e = Decimal(1).exp()
    assert_close(found["x_10"], 2 / e, 30)
    assert_close(found["v_10"], Decimal("-0.1") / e, 30)
    assert found["passes"].word == "false"


@pytest.mark.parametrize(("c", "passes"), [("0.1999", "true"), ("0.2", "false"), ("0.2001", "false")])
def test_beside_critical_damping(c: str, passes: str) -> None:
    """The regime is decided exactly, a little to both sides as well."""
    found = solve(
        BLOCK.format(names=f"given: {{m: 1 kg, c: {c} N*s/m, k: 0.01 N/m}}")
        + "states: {start: [t = 0, x = 1 m, at rest], through: [x = 0]}\nfind: {passes: reached(through)}\n"
    )
    assert found["passes"].word == passes


@pytest.mark.parametrize(
    ("c", "shape"),
    [
        ("sqrt(k*m)", "exp(-s/2)*(cos(sqrt(3)*s/2) + sin(sqrt(3)*s/2)/sqrt(3))"),
        ("2*sqrt(k*m)", "(1 + s)*exp(-s)"),
        ("4*sqrt(k*m)", "exp(-2*s)*(cosh(sqrt(3)*s) + 2*sinh(sqrt(3)*s)/sqrt(3))"),
    ],
)
def test_three_regimes_in_letters(c: str, shape: str) -> None:
    """One formula with √(c² - 4 k m) would divide by zero in the middle one; s = t √(k/m)."""
    names = f"symbols: {{m: kg, k: N/m, x_0: m, T: s}}\nassume: [x_0 < 3 m]\ngiven: {{c: {c}}}"
    found = solve(
        BLOCK.format(names=names) + "states: {start: [t = 0, x = x_0, at rest], end: [t = T]}\nfind: {x_T: x @ end}\n"
    )["x_T"]
    assert found.expressions is not None
    m, k, x_0, T = sp.symbols("m k x_0 T", positive=True)
    want = x_0 * sp.sympify(shape, {"s": T * sp.sqrt(k / m)})
    for values in ({m: 2, k: 3, x_0: 1, T: sp.Rational(1, 3)}, {m: 5, k: sp.Rational(1, 7), x_0: 2, T: 9}):
        got = found.expressions[0].subs({s: values[sp.Symbol(s.name, positive=True)] for s in _letters(found)})
        assert abs(sp.N(got - want.subs(values), 30)) < 1e-25


def _letters(found: Any) -> set[sp.Symbol]:
    return set().union(*(e.free_symbols for e in found.expressions))


PENDULUM = """
title: Pendulum
plane: vertical
coordinates: {theta: deg}
points: {O: [0, 0], P: {from: O, distance: 1 m, angle: theta - 90 deg}}
bodies: {bob: {particle: P, mass: 1 kg}}
joints:
  - link: {between: [O, P]}
"""


@pytest.mark.parametrize("degrees", [20, 60, 90, 120, 179])
def test_the_swing_of_a_pendulum(degrees: int) -> None:
    """Nobody waits for a general solution: the time is an integral, √(l/g) K(sin(θ0/2))."""
    states = f"states:\n  start: [t = 0, theta = {degrees} deg, at rest]\n  low: [theta = 0]\n"
    found = solve(f"{PENDULUM}{states}find: {{t_low: t @ low, w_low: dot(theta) @ low}}\n")
    k = mpmath.sin(mpmath.radians(degrees) / 2)
    assert_close(found["t_low"], text_of(mpmath.ellipk(k**2) / mpmath.sqrt(mpmath.mpf("9.81"))))
    assert_close(found["w_low"], text_of(-2 * mpmath.sqrt(mpmath.mpf("9.81")) * k))


# --- linear data that repeat each other ------------------------------------------------------------------------------

FORCES = """
title: Two forces, weighed twice
plane: horizontal
unknowns: {A: N, B: N}
points: {P: [0, 0]}
bodies: {b: {particle: P, mass: 1 kg}}
loads:
  - force: {body: b, at: P, magnitude: A, angle: 0 deg}
  - force: {body: b, at: P, magnitude: B, angle: 90 deg}
"""
SPEEDS = """
title: Two walkers
plane: horizontal
unknowns: {A: m/s, B: m/s}
bodies: {p: {particle: [0, 0], mass: any}, q: {particle: [0, 1 m], mass: any}}
motion: [v(p).x = A, v(p).y = 0, v(q).x = B, v(q).y = 0]
"""


def test_data_that_nearly_repeat_each_other_contradict() -> None:
    """0.1 A + 0.2 B = 0.3 and 0.3 A + 0.6 B = 0.9000000001 have no solution, and not a whole family."""
    with pytest.raises(NoSolution):
        solve(f"{FORCES}instant: [at rest, 0.1*A + 0.2*B = 0.3 N, 0.3*A + 0.6*B = 0.9000000001 N]\nfind: {{a: A}}\n")
    states = "states:\n  start: [t = 0]\n  one: [t = 1 s, 0.1*x(p) + 0.2*x(q) = 0.3 m]\n"
    with pytest.raises(NoSolution):
        solve(f"{SPEEDS}{states}  two: [t = 3 s, 0.1*x(p) + 0.2*x(q) = 0.9000000001 m]\nfind: {{a: A}}\n")


def test_data_that_repeat_each_other_leave_it_open() -> None:
    """The rank of [[0.1, 0.3], [0.3, 0.9]] is 1, though the determinant of floats is 1e-17."""
    with pytest.raises(NoSolution, match="one datum is missing"):
        solve(f"{FORCES}instant: [at rest, 0.1*A + 0.3*B = 0.5 N, 0.3*A + 0.9*B = 1.5 N]\nfind: {{a: A}}\n")


def test_data_that_repeat_each_other_and_one_more() -> None:
    instant = "instant: [at rest, 0.1*A + 0.3*B = 0.5 N, 0.3*A + 0.9*B = 1.5 N, a(b).x = 2 m/s^2]\n"
    found = solve(f"{FORCES}{instant}find: {{a: A, beside: B}}\n")
    assert_close(found["a"], 2, 30)
    assert_close(found["beside"], 1, 30)
    states = "states:\n  start: [t = 0]\n  one: [t = 1 s, 0.1*x(p) + 0.2*x(q) = 0.3 m]\n"
    found = solve(f"{SPEEDS}{states}  two: [t = 3 s, 0.1*x(p) + 0.2*x(q) = 0.9 m, x(q) = 3 m]\nfind: {{a: A}}\n")
    assert_close(found["a"], 1, 30)


# --- the direction of friction ---------------------------------------------------------------------------------------

PUSHED = """
title: Block pushed over a rough floor
plane: vertical
unknowns: {F: N}
points: {P: [0, 0]}
surfaces: {floor: {through: P, angle: 0 deg}}
bodies: {b: {particle: P, mass: 1 kg}}
joints:
  - contact: {between: [b, floor], at: P, friction: 3 N}
loads:
  - force: {body: b, at: P, magnitude: F, angle: 0 deg}
"""


@pytest.mark.parametrize(("speed", "force"), [(1, 5), (-1, -1)])
def test_both_directions_of_friction(speed: int, force: int) -> None:
    """F - 3 sign F - 2 = 0 has the roots 5 and -1: one for each direction in which the block slides."""
    found = solve(f"{PUSHED}instant: [v(b).x = {speed} m/s, a(b).x = 2 m/s^2]\nfind: {{push: F}}\n")
    assert_close(found["push"], force, 30)


@pytest.mark.parametrize(("start", "end", "force"), [(1, 5, 5), (-5, -1, -1)])
def test_both_directions_of_friction_over_time(start: int, end: int, force: int) -> None:
    states = f"states:\n  1: [t = 0, v(b).x = {start} m/s]\n  2: [t = 2 s, v(b).x = {end} m/s]\n"
    assert_close(solve(f"{PUSHED}{states}find: {{push: F}}\n")["push"], force, 30)


# --- decimals that meet ----------------------------------------------------------------------------------------------


def test_times_that_meet_though_their_floats_do_not() -> None:
    """0.1 + 0.2 is 0.3: the force ends in the very state that is asked about."""
    found = solve("""
title: Push that ends
plane: horizontal
points: {P: [0, 0]}
bodies: {b: {particle: P, mass: 1 kg}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - force: {body: b, at: P, magnitude: 10 N, angle: 0 deg, during: 1->2}
states:
  1: [t = 0, at rest]
  2: [t = 0.1 s + 0.2 s]
  3: [t = 0.3 s + 0.1 s]
find: {v_2: v(b).x @ 2, x_3: x(b) @ 3}
""")
    assert_close(found["v_2"], 3, 30)
    assert_close(found["x_3"], "0.75", 30)


def test_a_slope_exactly_at_the_angle_of_friction() -> None:
    """tan β = 0.75 = mu: the block stays, by nothing."""
    found = solve("""
title: Block at the limit
plane: vertical
given: {mu: 0.75}
points: {P: [0, 0]}
surfaces: {slope: {through: P, angle: -atan(3/4)}}
bodies: {b: {particle: P, mass: 1.3 kg}}
joints:
  - contact: {between: [b, slope], at: P, mu: mu}
instant: [at rest]
find: {what: mode(P), a_b: a(b).mag}
""")
    assert found["what"].word == "stick"
    assert_close(found["a_b"], 0)
