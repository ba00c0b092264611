"""Blows: impacts, impulses, joints that take hold of moving parts or let go, and what a blow keeps and costs."""

from __future__ import annotations

from decimal import Decimal
from math import asin, atan2, cos, pi, sin, sqrt

import pytest
import sympy as sp
from answered import Answers, assert_close, first, number, solve

from planar_cli.errors import FileProblem, NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solution import Found

G = 9.81
LEDGER = (
    "loss: KE(all) @ 1 - KE(all) @ 2, heat: heat(all) @ 1->2, work: work(all) @ 1->2, "
    "p_x: momentum(all).x @ 2 - momentum(all).x @ 1, p_y: momentum(all).y @ 2 - momentum(all).y @ 1"
)


def pair(found: Found) -> tuple[float, float]:
    """Both components of a vector, in SI units."""
    assert found.values is not None
    x, y = found.values
    return float(x), float(y)


def assert_ledger(found: Answers, loss: float, *, kept: bool = True) -> None:
    """What is lost is the heat, the work of all impulses is the change of the energy, and momentum is kept."""
    assert first(found["loss"]) == pytest.approx(loss)
    assert_close(found["heat"], number(found["loss"]))
    assert_close(found["work"], -number(found["loss"]))
    if kept:
        assert_close(found["p_x"], 0)
        assert_close(found["p_y"], 0)


# --- two particles ---------------------------------------------------------------------------------------------------

DIRECT = f"""
title: Two particles collide head on
plane: horizontal
given: {{m_A: 2 kg, m_B: 3 kg, v_A: 5 m/s, v_B: -1 m/s, e: %s}}
bodies: {{A: {{particle: [0, 0], mass: m_A}}, B: {{particle: [1 m, 0], mass: m_B}}}}
joints:
  - impact: {{between: [A, B], restitution: e, name: hit}}
states:
  1: [v(A).x = v_A, v(A).y = 0, v(B).x = v_B, v(B).y = 0]
  2: [just after 1]
find: {{u_A: v(A).x @ 2, u_B: v(B).x @ 2, J: impulse(hit/B).x @ 1->2, J_A: impulse(hit/A).x @ 1->2, {LEDGER}}}
"""


@pytest.mark.parametrize("e", [0, 0.25, 1])
def test_a_direct_impact(e: float) -> None:
    """e = 0 is the plastic one, e = 1 the elastic one."""
    found = solve(DIRECT % e)
    common, reduced, approach = (2 * 5 - 3) / 5, 6 / 5, 6
    assert first(found["u_A"]) == pytest.approx(common - e * approach * 3 / 5)
    assert first(found["u_B"]) == pytest.approx(common + e * approach * 2 / 5)
    assert first(found["J"]) == pytest.approx((1 + e) * reduced * approach)
    assert first(found["J_A"]) == -first(found["J"])
    assert_ledger(found, (1 - e**2) * reduced * approach**2 / 2)


THIN = """
title: Ball against a thin rough wall that is drawn through it
plane: horizontal
given: {v: 3 m/s}
points: {P: [0, 0]}
bodies: {ball: {particle: P, mass: 2 kg}}
surfaces: {wall: {through: P, angle: 90 deg}}
joints:
  - impact: {between: [%s], normal: %s deg, restitution: 0.5, mu: 0.2}
states: {1: [v(P).x = %s*v, v(P).y = v], 2: [just after 1]}
find: {v: v(P) @ 2, J: impulse(ball) @ 1->2}
"""


@pytest.mark.parametrize("way", [1, -1])
@pytest.mark.parametrize("normal", [0, 180])
@pytest.mark.parametrize("between", ["ball, wall", "wall, ball"])
def test_what_may_be_struck_from_either_side_presses(between: str, normal: int, way: int) -> None:
    """Friction opposes the sliding, whichever way the normal is written."""
    found = solve(THIN % (between, normal, way))
    assert pair(found["v"]) == pytest.approx((-1.5 * way, 3 - 0.2 * 1.5 * 3))
    assert pair(found["J"]) == pytest.approx((-9 * way, -1.8))


def test_what_does_not_approach_is_not_struck() -> None:
    """The file says that they strike each other in this blow: that they do not is said."""
    text = (DIRECT % 0).replace("v_A: 5 m/s", "v_A: -5 m/s").replace("name: hit", "name: hit, during: 1->2")
    problem, _ = load_text(text)
    assert problem is not None
    part = solve_problem(problem).parts[0]
    assert first({f.name: f for f in part.found}["u_A"]) == -5
    assert "A and B do not approach each other at 1: no impulse there" in part.motion.checks


APART = """
title: Two carts and a wall, one impact after the other
plane: horizontal
given: {m: 1 kg}
bodies: {A: {particle: [0, 0], mass: m}, B: {particle: [1 m, 0], mass: m}}
surfaces: {wall: {through: W, angle: 90 deg}}
points: {W: [4 m, 0]}
joints:
  - guide: {body: A, along: 0 deg}
  - guide: {body: B, along: 0 deg}
  - impact: {between: [A, B], restitution: 1, name: hit}
  - impact: {between: [B, wall], restitution: 0.5, name: bounce}
states:
  1: [t = 0, v(A).x = 2 m/s, v(B).x = 0]
  2: [x(A) = x(B)]
  3: [just after 2]
  4: [x(B) = 4 m]
  5: [just after 4]
find: {v_3: v(B).x @ 3, v_5: v(B).x @ 5, t_5: t @ 5}
"""


def test_what_is_apart_is_not_struck() -> None:
    """Impacts without `during`: the wall answers when the cart has come to it."""
    found = solve(APART)
    assert first(found["v_3"]) == pytest.approx(2)
    assert first(found["v_5"]) == pytest.approx(-1)
    assert first(found["t_5"]) == pytest.approx(0.5 + 1.5)


FLAT = """
title: Rod that falls on a floor
plane: vertical
points: {A: [0, %s], B: [1 m, %s]}
surfaces: {floor: {through: F, angle: 0 deg}}
bodies: {rod: {rod: [A, B], mass: 2 kg}}
joints:
  - impact: {between: [rod, floor], restitution: 0.5, name: hit}
states: {1: [at rest], 2: [y(A) = 0], 3: [just after 2]}
find: {v: v(A).y @ 3, spin: omega(rod) @ 3}
"""


def test_two_corners_at_once() -> None:
    """Newton's law of restitution at both: both rise with e times the speed with which they come."""
    found = solve((FLAT % ("1 m", "1 m")).replace("points: {", "points: {F: [0, 0], "))
    assert first(found["v"]) == pytest.approx(sqrt(2 * G) / 2)


def test_a_rod_that_falls_on_one_end() -> None:
    """v_A after is e times before; the angular momentum about A is kept."""
    found = solve((FLAT % ("1 m", "1.3 m")).replace("points: {", "points: {F: [0, 0], "))
    fall = sqrt(2 * G)
    assert first(found["v"]) == pytest.approx(fall / 2)
    arm = cos(asin(0.3 / sqrt(1.09))) * sqrt(1.09) / 2
    inertia = 2 * 1.09 / 12
    impulse = 1.5 * fall / (1 / 2 + arm**2 / inertia)
    assert first(found["spin"]) == pytest.approx(-arm * impulse / inertia)


FACED = """
title: Wagon that hits a wall with its face
plane: vertical
points: {G: [0, 0], W: [3 m, 0]}
surfaces: {wall: {through: W, angle: 90 deg}}
bodies: {wagon: {plate: G, width: 2 m, height: 1 m, mass: 5 kg}}
joints:
  - guide: {body: wagon, along: 0 deg, mu: 0.1}
  - impact: {between: [wagon, wall], restitution: %s, name: hit}
states: {1: [t = 0, v(wagon).x = 4 m/s], 2: [x(wagon) = 2 m], 3: [just after 2], 4: [%s]}
find: {v: v(wagon).x @ 3, J: impulse(hit/wagon).x @ 2->3, x: x(wagon) @ 4}
"""


@pytest.mark.parametrize(("e", "last"), [(0.5, "v(wagon).x = 0"), (0, "t = 2 s")])
def test_a_face_of_what_cannot_turn(e: float, last: str) -> None:
    """Both its corners strike at once, with one velocity; where the impact is plastic it then stays."""
    found = solve(FACED % (e, last))
    v = sqrt(4**2 - 2 * 0.1 * G * 2)
    assert first(found["v"]) == pytest.approx(-e * v)
    assert first(found["J"]) == pytest.approx(-5 * (1 + e) * v)
    assert first(found["x"]) == pytest.approx(2 - (e * v) ** 2 / (2 * 0.1 * G))


ONE_END = """
title: Dumbbell that strikes a floor with its lower end
plane: vertical
points: {A: [0, 0], B: {from: A, distance: 1 m, angle: 30 deg}}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies: {dumbbell: {%s}}
joints:
  - impact: {between: [dumbbell, floor], at: A, restitution: 0.5, name: hit%s}
states:
  1: [v(dumbbell).x = 0, v(dumbbell).y = -1 m/s, omega(dumbbell) = 0]
  2: [just after 1]
find: {v: v(dumbbell).y @ 2, spin: omega(dumbbell) @ 2, J: impulse(hit).y @ 1->2}
"""
DUMBBELLS = (
    "parts: [{particle: A, mass: 1 kg}, {particle: B, mass: 1 kg}], points: [A, B]",
    "parts: [{rod: [A, B], mass: 0 kg}, {particle: A, mass: 1 kg}, {particle: B, mass: 1 kg}]",
    "points: [A, B], center: {midpoint: [A, B]}, mass: 2 kg, inertia: 0.5 kg*m^2",
    "rod: [A, B], mass: 2 kg, inertia: 0.5 kg*m^2",
)


@pytest.mark.parametrize("during", ["", ", during: 1->2"])
@pytest.mark.parametrize("shape", DUMBBELLS)
def test_only_the_end_that_is_there_strikes(shape: str, during: str) -> None:
    """Also where the file says between which states: J = (1 + e) v / (1/m + b²/I), b = l/2 cos 30°."""
    found = solve(ONE_END % (shape, during))
    impulse = 1.5 / (1 / 2 + (3 / 16) / 0.5)
    assert first(found["J"]) == pytest.approx(impulse)
    assert first(found["v"]) == pytest.approx(impulse / 2 - 1)
    assert first(found["spin"]) == pytest.approx(-impulse * sqrt(3 / 16) / 0.5)


STACK = """
title: Two balls dropped one above the other
plane: vertical
points: {F: [0, 0], A: [0, 1 m], B: [0, 1.02 m]}
surfaces: {floor: {through: F, angle: 0 deg}}
bodies: {big: {particle: A, mass: 0.6 kg}, small: {particle: B, mass: 0.06 kg}}
joints:
  - impact: {between: [big, floor], restitution: 0.9}
  - impact: {between: [big, small], normal: 90 deg, restitution: 0.9}
states: {1: [at rest], 2: [y(A) = 0], 3: [just after 2], 4: [y(A) = y(B)], 5: [just after 4]}
find: {v_3: v(big).y @ 3, v_4: v(small).y @ 4, V_4: v(big).y @ 4, v_5: v(small).y @ 5}
"""


def test_impacts_without_names_are_told_apart() -> None:
    """Both are called by their first body."""
    found = {name: first(f) for name, f in solve(STACK).items()}
    assert found["v_3"] == pytest.approx(0.9 * sqrt(2 * G))
    common = (0.6 * found["V_4"] + 0.06 * found["v_4"]) / 0.66
    assert found["v_5"] == pytest.approx(common + 0.9 * (found["V_4"] - found["v_4"]) * 0.6 / 0.66)


PUCK = """
title: Puck that is struck and slides
plane: horizontal
points: {P: [0, 0]}
bodies: {puck: {particle: P, mass: 0.5 kg}}
joints:
  - flat: {between: [puck, ground], mu: 0.2}
loads:
  - impulse: {body: puck, magnitude: 4 N*s, angle: 0 deg, during: 1->2}
states: {1: [at rest], 2: [just after 1], 3: [x(P) = 3 m]}
find: {v_2: v(puck).x @ 2, v_3: v(puck).x @ 3}
"""


def test_friction_in_the_plane_has_no_impulse_in_a_blow() -> None:
    found = solve(PUCK)
    assert first(found["v_2"]) == pytest.approx(8)
    assert first(found["v_3"]) == pytest.approx(sqrt(64 - 2 * 0.2 * G * 3))


def test_a_restitution_that_is_sought() -> None:
    """Left out, it is what a velocity just after tells; as an unknown it is an answer."""
    told = "2: [just after 1, v(B).x = 2.6 m/s]"
    by_name = (DIRECT % 0).replace(", e: 0", "").replace("2: [just after 1]", told)
    found = solve(by_name.replace("bodies:", "unknowns: {e: 1}\nbodies:").replace("u_A:", "e: e, u_A:"))
    assert_close(found["e"], "0.5")
    left_out = solve(by_name.replace(" restitution: e,", ""))
    assert_close(left_out["u_A"], number(found["u_A"]))
    assert_close(left_out["J"], "10.8")


def test_a_restitution_that_stays_open() -> None:
    """See also tests/bad_solve/restitution-open.yaml."""
    text = (DIRECT % 0).replace(", e: 0", "").replace(" restitution: e,", "")
    with pytest.raises(NoSolution, match="restitution of hit is open"):
        solve(text)


def test_what_is_shot_through_is_told_otherwise() -> None:
    """An impact does not let one body come out on the other side; an impulse that is sought does."""
    text = (
        (DIRECT % 0)
        .replace(", e: 0", "")
        .replace(" restitution: e,", "")
        .replace("2: [just after 1]", "2: [just after 1, v(A).x = 4 m/s]")
    )
    with pytest.raises(NoSolution, match="they would pass through each other") as raised:
        solve(text)
    assert "`impulse`" in raised.value.diagnostics[0].hint


def test_an_impact_that_misses() -> None:
    """What does not approach keeps its velocity."""
    found = solve((DIRECT % 0.5).replace("v_B: -1 m/s", "v_B: 7 m/s"))
    assert (first(found["u_A"]), first(found["u_B"]), first(found["J"])) == (5, 7, 0)
    assert_ledger(found, 0)


def test_an_oblique_impact() -> None:
    """Along the line of impact as if it were direct, across it nothing changes."""
    gamma, e = atan2(3, 4), 0.6
    text = (DIRECT % e).replace("name: hit", "normal: atan(0.75), mu: 0, name: hit")
    text = text.replace("v(A).y = 0", "v(A).y = 2 m/s").replace("u_A: v(A).x @ 2", "u_A: v(A) @ 2")
    text = text.replace("J: impulse(hit/B).x", "J: impulse(hit/B)")
    found = solve(text)
    n = (cos(gamma), sin(gamma))
    size = (1 + e) * 6 / 5 * (6 * n[0] + 2 * n[1])
    assert pair(found["J"]) == pytest.approx((size * n[0], size * n[1]))
    assert pair(found["u_A"]) == pytest.approx((5 - size * n[0] / 2, 2 - size * n[1] / 2))
    assert_ledger(found, (1 - e**2) * 3 / 5 * (6 * n[0] + 2 * n[1]) ** 2)


def test_work_on_one_of_two() -> None:
    """The impulse works on each body by the mean of its velocities, and so changes its own energy."""
    finds = "W_A: work(hit/A) @ 1->2, T_A: KE(A) @ 2 - KE(A) @ 1, W_B: work(B) @ 1->2, T_B: KE(B) @ 2 - KE(B) @ 1"
    text = DIRECT % 0.25
    found = solve(text[: text.index("find:")] + f"find: {{{finds}}}")
    assert_close(found["W_A"], number(found["T_A"]))
    assert_close(found["W_B"], number(found["T_B"]))
    assert number(found["W_A"]) != number(found["W_B"])


# --- in a row --------------------------------------------------------------------------------------------------------

ROW = """
title: Three balls in a row
plane: horizontal
given: {{m: 0.2 kg, r: 20 mm, e: {e}}}
points: {{A: [0, 0], B: [2*r, 0], C: [4*r, 0]}}
bodies:
  a: {{sphere: A, radius: r, mass: m}}
  b: {{sphere: B, radius: r, mass: m}}
  c: {{sphere: C, radius: r, mass: m}}
joints:
  - guide: {{body: a, along: 0 deg, name: g_a}}
  - guide: {{body: b, along: 0 deg, name: g_b}}
  - guide: {{body: c, along: 0 deg, name: g_c}}
  - impact: {{between: [a, b], restitution: e, name: ab{first}}}
  - impact: {{between: [b, c], restitution: e, name: bc{second}}}
states:
  1: [v(a).x = 1 m/s, b at rest, c at rest]
  {states}
find:
  u: v(a).x @ {end}
  v: v(b).x @ {end}
  w: v(c).x @ {end}
  p: momentum(all).x @ {end} - momentum(all).x @ 1
  loss: KE(all) @ 1 - KE(all) @ {end}
"""
AT_ONCE = {"first": "", "second": "", "states": "2: [just after 1]", "end": "2"}
IN_TURN = {
    "first": ", during: 1->2",
    "second": ", during: 2->3",
    "states": "2: [just after 1]\n  3: [just after 2]",
    "end": "3",
}


def test_newtons_cradle_at_once() -> None:
    """Every contact with its own restitution at the same time: -1/3, 2/3, 2/3."""
    found = solve(ROW.format(e=1, **AT_ONCE))
    third = Decimal(1) / 3
    for name, truth in (("u", -third), ("v", 2 * third), ("w", 2 * third), ("p", Decimal(0)), ("loss", Decimal(0))):
        assert_close(found[name], truth)


def test_newtons_cradle_one_after_the_other() -> None:
    """Tiny gaps: 0, 0, 1. Both outcomes keep momentum and energy."""
    found = solve(ROW.format(e=1, **IN_TURN))
    for name, truth in (("u", 0), ("v", 0), ("w", 1), ("p", 0), ("loss", 0)):
        assert_close(found[name], truth)


def test_the_model_of_a_row_is_named() -> None:
    """The outcome depends on it, so the solution says which one it is."""
    problem, wrong = load_text(ROW.format(e=1, **AT_ONCE))
    assert problem is not None, wrong
    told = " ".join(Terminal().render(narrate(solve_problem(problem))).split())
    assert "2 impacts at once, each with its own restitution" in told
    assert "One after the other they would end otherwise." in told


def test_a_plastic_row() -> None:
    """At once all go on together; in turn the last one has half of the speed of the second."""
    together, turn = solve(ROW.format(e=0, **AT_ONCE)), solve(ROW.format(e=0, **IN_TURN))
    assert [first(together[n]) for n in ("u", "v", "w")] == pytest.approx([1 / 3, 1 / 3, 1 / 3])
    assert first(together["loss"]) == pytest.approx(0.1 * (1 - 1 / 3))
    assert [first(turn[n]) for n in ("u", "v", "w")] == pytest.approx([0.5, 0.25, 0.25])


def test_one_contact_of_a_row_that_parts() -> None:
    """The last ball runs away before the blow reaches it."""
    found = solve(ROW.format(e=1, **AT_ONCE).replace("c at rest", "v(c).x = 3 m/s"))
    assert [first(found[n]) for n in ("u", "v", "w")] == [0, 1, 3]


# --- friction --------------------------------------------------------------------------------------------------------

BALL = """
title: Ball on a rough floor
plane: vertical
given: {{r: 40 mm, m: 0.2 kg}}
points: {{C: [0, 0], G: [0, r]}}
surfaces: {{floor: {{through: C, angle: 0 deg}}}}
bodies: {{ball: {{sphere: G, radius: r, mass: m}}}}
joints:
  - impact: {{between: [ball, floor], restitution: 0.75, mu: {mu}, name: bounce}}
states:
  1: [v(G).x = {u} m/s, v(G).y = -4 m/s, omega(ball) = {w} rad/s]
  2: [just after 1]
find:
  v: v(G) @ 2
  omega: omega(ball) @ 2
  J: impulse(bounce) @ 1->2
  loss: KE(ball) @ 1 - KE(ball) @ 2
  heat: heat(bounce) @ 1->2
  work: work(ball) @ 1->2
"""


@pytest.mark.parametrize(
    ("mu", "u", "w", "tangent"),
    [
        (0, 6, 0, 0),
        (0.2, 6, 0, -0.28),
        (0.6, 6, 0, -0.2 * 6 * 2 / 7),
        # It spins so fast that its lowest point moves backwards: friction drives it on.
        (0.2, 1, -200, 0.28),
    ],
)
def test_friction_in_an_impact(mu: float, u: float, w: float, tangent: float) -> None:
    """It slides throughout, with mu times the normal impulse, or its lowest point ends at rest."""
    found = solve(BALL.format(mu=mu, u=u, w=w))
    m, r = 0.2, 0.04
    v, omega = u + tangent / m, w + tangent * r / (0.4 * m * r**2)
    assert pair(found["J"]) == pytest.approx((tangent, 1.4))
    assert pair(found["v"]) == pytest.approx((v, 3))
    assert first(found["omega"]) == pytest.approx(omega)
    before, after = ((m * (a**2 + b**2) + 0.4 * m * r**2 * c**2) / 2 for a, b, c in ((u, 4, w), (v, 3, omega)))
    assert first(found["loss"]) == pytest.approx(before - after)
    assert_close(found["heat"], number(found["loss"]))
    assert_close(found["work"], -number(found["loss"]))


STRUCK = """
title: Block on a floor, struck
plane: vertical
given: {{m: 2 kg, mu: 0.3, J: 6 N*s}}
points: {{C: [0, 0]}}
surfaces: {{floor: {{through: C, angle: 0 deg}}}}
bodies: {{block: {{particle: C, mass: m}}}}
joints:
  - contact: {{between: [block, floor], at: C, mu: mu}}
loads:
  - impulse: {{body: block, magnitude: J, angle: {angle} deg, during: 1->2}}
states:
  1: [t = 0, at rest]
  2: [just after 1]
  {later}
find: {{v: v(block) @ 2, mode: mode(C) @ 2, J: impulse(C) @ 1->2{more}}}
"""


def test_a_contact_that_separates() -> None:
    """A blow that lifts the block has no reaction; then it flies."""
    later = {"later": "3: [v(block).y = 0]", "more": ", x: x(block) @ 3, y: y(block) @ 3"}
    found = solve(STRUCK.format(angle=30, **later))
    assert pair(found["v"]) == pytest.approx((3 * sqrt(3) / 2, 1.5))
    assert pair(found["J"]) == (0, 0)
    assert found["mode"].word == "apart"
    assert (first(found["x"]), first(found["y"])) == pytest.approx((1.5 * sqrt(3) * 1.5 / G, 1.5**2 / (2 * G)))


@pytest.mark.parametrize(("angle", "mode"), [(-30, "slip"), (-80, "stick")])
def test_a_contact_that_is_pressed(angle: int, mode: str) -> None:
    """Inside the cone of friction nothing moves, outside friction takes its limit."""
    found = solve(STRUCK.format(angle=angle, later="", more=""))
    along, press = 6 * cos(angle * pi / 180), -6 * sin(angle * pi / 180)
    friction = min(along, 0.3 * press)
    assert found["mode"].word == mode
    assert pair(found["J"]) == pytest.approx((-friction, press))
    assert pair(found["v"]) == pytest.approx(((along - friction) / 2, 0), abs=1e-12)


def test_a_span_with_a_blow_in_it() -> None:
    """Impulse, work and heat of the blow and of what comes after it are added."""
    text = STRUCK.format(angle=0, later="3: [v(block).x = 0]", more=", all: impulse(block).x @ 1->3")
    text = text.replace("at rest", "v(block).x = 1 m/s").replace("find: {", "find: {W: work(block) @ 1->3, ")
    found = solve(text.replace("find: {", "find: {s: x(block) @ 3, heat: heat(C) @ 1->3, "))
    assert_close(found["all"], -2)
    assert_close(found["W"], -1)
    assert_close(found["heat"], 16)
    assert first(found["s"]) == pytest.approx(16 / (2 * 0.3 * G))


# --- rods ------------------------------------------------------------------------------------------------------------

HANGING = """
title: Rod struck at a distance d from its pin
plane: horizontal
given: {l: 1.2 m, m: 3 kg, J: 5 N*s}
points: {A: [0, 0], B: [l, 0], S: [d, 0]}
bodies: {rod: {rod: [A, B], mass: m}}
joints:
  - pin: {at: A, between: [ground, rod]}
loads:
  - impulse: {name: blow, body: rod, at: S, magnitude: J, angle: 90 deg, during: 1->2}
states:
  1: [at rest]
  2: [just after 1]
"""
WAGON = """
title: Rod that hangs from a wagon, struck at its end
plane: horizontal
given: {M: 4 kg, m: 2 kg, l: 0.8 m, S: 6 N*s}
points: {O: [0, 0], P: [0, -l]}
bodies: {wagon: {particle: O, mass: M}, rod: {rod: [O, P], mass: m}}
joints:
  - guide: {body: wagon, along: 0 deg, name: rails}
  - pin: {at: O, between: [wagon, rod], name: hinge}
loads:
  - impulse: {name: blow, body: rod, at: P, magnitude: S, angle: 0 deg, during: 1->2}
states:
  1: [at rest]
  2: [just after 1]
find:
  u: v(O).x @ 2
  omega: omega(rod) @ 2
  hinge: impulse(hinge/rod).x @ 1->2
  p: momentum(all).x @ 2
  H: H(all/O) @ 2
  turn: impulse(blow/O) @ 1->2
  W: work(blow) @ 1->2
  T: KE(all) @ 2
  W_rod: work(rod) @ 1->2
  T_rod: KE(rod) @ 2
"""


def test_the_kick_of_a_pin() -> None:
    given = HANGING.replace("J: 5 N*s", "J: 5 N*s, d: 0.9 m")
    found = solve(given + "find: {omega: omega(rod) @ 2, kick: impulse(A).y @ 1->2, W: work(A) @ 1->2}")
    omega = 5 * 0.9 / (3 * 1.2**2 / 3)
    assert first(found["omega"]) == pytest.approx(omega)
    assert first(found["kick"]) == pytest.approx(3 * 0.6 * omega - 5)
    assert first(found["W"]) == 0


def test_the_centre_of_percussion() -> None:
    """Struck two thirds of its length below, the rod does not kick its pin."""
    text = HANGING.replace("points:", "unknowns: {d: m}\npoints:")
    text = text.replace("just after 1]", "just after 1, impulse(A).y @ 1->2 = 0]")
    found = solve(text + "find: {d: d, W: work(blow) @ 1->2, T: KE(rod) @ 2}")
    assert_close(found["d"], "0.8")
    assert_close(found["W"], number(found["T"]))


def test_an_impulsive_moment() -> None:
    """It turns the spin round: nothing is gained, but the pin feels it."""
    text = HANGING.replace("at: S, magnitude: J, angle: 90 deg", "moment: 5.76 N*m*s").replace(", S: [d, 0]", "")
    text = text.replace("at rest", "omega(rod) = -2 rad/s")
    found = solve(text + "find: {omega: omega(rod) @ 2, kick: impulse(A).y @ 1->2, W: work(blow) @ 1->2}")
    assert_close(found["omega"], 2)
    assert_close(found["kick"], "7.2")
    assert_close(found["W"], 0)


def test_a_system_that_is_struck() -> None:
    found = solve(WAGON)
    assert first(found["u"]) == pytest.approx(-2 / 3)
    assert first(found["omega"]) == pytest.approx(12.5)
    assert_close(found["hinge"], Decimal(8) / 3)
    assert_close(found["p"], 6)
    assert_close(found["H"], number(found["turn"]))
    assert_close(found["W"], number(found["T"]))
    assert_close(found["W_rod"], number(found["T_rod"]))


DRIVEN = """
title: Rod on a crank that keeps its speed, struck at its free end
plane: horizontal
points: {O: [0, 0], A: [0.3 m, 0], B: [0.3 m, 0.5 m]}
bodies: {OA: {rod: [O, A], mass: 1 kg}, AB: {rod: [A, B], mass: 2 kg}}
joints:
  - pin: {at: O, between: [ground, OA]}
  - pin: {at: A, between: [OA, AB]}
loads:
  - impulse: {name: blow, body: AB, at: B, magnitude: 3 N*s, angle: 0 deg, during: 1->2}
motion: [omega(OA) = 2 rad/s]
states:
  1: [t = 0, omega(AB) = 0]
  2: [just after 1]
find: {omega: omega(AB) @ 2, crank: omega(OA) @ 2, knee: impulse(A/AB) @ 1->2, pin: impulse(O) @ 1->2}
"""


def test_what_is_driven_goes_on() -> None:
    found = solve(DRIVEN)
    assert_close(found["omega"], -9)
    assert_close(found["crank"], 2)
    assert pair(found["knee"]) == pytest.approx((1.5, 0))
    assert pair(found["pin"]) == pytest.approx((1.5, 0))


LIFT = """
title: Bolt that drops on the floor of a lift
plane: vertical
points: {F: [0, 0], B: [0, 2.6 m]}
surfaces: {floor: {through: F, angle: 0 deg, body: lift}}
bodies: {lift: {points: [F]}, bolt: {particle: B, mass: any}}
joints:
  - guide: {body: lift, along: 90 deg}
  - impact: {between: [bolt, floor], restitution: 0.6, during: 2->3}
motion: [%s]
states:
  1: [t = 0, %sv(bolt).x = 0, v(bolt).y = 3 m/s]
  2: [r(bolt/F).y = 0]
  3: [just after 2]
find: {u: v(lift).y @ 2, v: v(bolt).y @ 3, V: v(lift).y @ 3}
"""


@pytest.mark.parametrize(
    ("law", "said", "a"),
    [("v(lift).y = 3 m/s", "", 0.0), ("a(lift).y = 1.5 m/s^2", "v(lift).y = 3 m/s, ", 1.5)],
)
def test_what_is_driven_without_mass_is_struck_and_goes_on(law: str, said: str, a: float) -> None:
    """Its speed is that before the blow, whether its velocity or its acceleration is given."""
    found = solve(LIFT % (law, said))
    fall = sqrt(2 * 2.6 / (G + a))
    assert first(found["u"]) == pytest.approx(3 + a * fall)
    assert first(found["V"]) == pytest.approx(3 + a * fall)
    assert first(found["v"]) == pytest.approx(3 + a * fall + 0.6 * (G + a) * fall)


# --- taking hold and letting go --------------------------------------------------------------------------------------

FIXED = """
title: Sliding rod that catches on a nail, and comes off again
plane: horizontal
given: {m: 2 kg, l: 1.2 m}
points: {A: [0, 0], B: [l, 0], C: [l/3, 0]}
bodies: {rod: {rod: [A, B], points: [C], mass: m}}
joints:
  - pin: {at: C, between: [ground, rod], during: 1->3, name: nail}
states:
  1: [t = 0, v(A).x = 0, v(A).y = 3 m/s, omega(rod) = 0]
  2: [just after 1]
  3: [theta(rod) = 90 deg]
  4: [omega(rod)*(t - t @ 3) = 1]
find:
  omega: omega(rod) @ 2
  J: impulse(nail).y @ 1->2
  loss: KE(rod) @ 1 - KE(rod) @ 2
  heat: heat(nail) @ 1->2
  v: v(rod) @ 4
  omega_4: omega(rod) @ 4
  r: r(rod) @ 4
"""
CLAY = f"""
title: Lump of clay thrown at a hanging rod
plane: vertical
given: {{m: 0.5 kg, M: 2 kg, l: 0.6 m, v_0: 9 m/s}}
points: {{A: [0, 0], B: [0, -l]}}
bodies: {{rod: {{rod: [A, B], mass: M}}, clay: {{particle: B, mass: m}}}}
joints:
  - pin: {{at: A, between: [ground, rod]}}
  - weld: {{at: B, between: [rod, clay], during: 1->3, name: stuck}}
states:
  1: [rod at rest, v(clay).x = v_0, v(clay).y = 0]
  2: [just after 1]
  3: [omega(rod) = 0]
find:
  omega: omega(rod) @ 2
  phi: theta(rod) @ 3 - theta(rod) @ 1
  kick: impulse(A).x @ 1->2
  J: impulse(stuck/clay).x @ 1->2
  H: H(all/A) @ 2 - H(all/A) @ 1
  {LEDGER.replace(", ", chr(10) + "  ")}
"""
JERK = """
title: Ball on a slack cord that jerks taut
plane: horizontal
given: {l: 2 m}
points: {O: [0, 0], P: [1.2 m, 0]}
bodies: {ball: {particle: P, mass: 3 kg}}
joints:
  - rope: {path: [O, P], name: cord, during: 2->4}
states:
  1: [t = 0, v(P).x = 0, v(P).y = 4 m/s]
  2: [r(P).mag = l]
  3: [just after 2]
  4: [t = 1 s]
find:
  t: t @ 2
  v: v(P) @ 3
  J: impulse(cord/ball) @ 2->3
  T: tension(cord) @ 3
  heat: heat(cord) @ 2->3
  loss: KE(all) @ 2 - KE(all) @ 3
  v_4: v(P).mag @ 4
"""


def test_sudden_fixing_and_release() -> None:
    """Angular momentum about the nail is kept when it catches; when it lets go, both velocities are."""
    found = solve(FIXED)
    omega = 3 * 0.2 / (1.2**2 / 12 + 0.2**2)
    assert first(found["omega"]) == pytest.approx(omega)
    assert first(found["J"]) == pytest.approx(2 * (0.2 * omega - 3))
    assert first(found["loss"]) == pytest.approx(9 - 0.16 * omega**2)
    assert_close(found["heat"], number(found["loss"]))
    assert pair(found["v"]) == pytest.approx((-0.2 * omega, 0))
    assert first(found["omega_4"]) == pytest.approx(omega)
    assert pair(found["r"]) == pytest.approx((0.4 - 0.2, 0.2))


def test_clay_on_a_rod() -> None:
    """A plastic impact with a body that is held: momentum is not kept, angular momentum about the pin is."""
    found = solve(CLAY)
    omega = 0.5 * 9 * 0.6 / (2 * 0.36 / 3 + 0.5 * 0.36)
    drop = (0.24 + 0.18) / 2 * omega**2 / ((0.5 * 0.6 + 2 * 0.3) * G)
    assert first(found["omega"]) == pytest.approx(omega)
    assert first(found["phi"]) == pytest.approx(pi / 2 + asin(drop - 1))
    assert first(found["J"]) == pytest.approx(0.5 * (0.6 * omega - 9))
    assert first(found["kick"]) == pytest.approx(0.5 * 0.6 * omega + 2 * 0.3 * omega - 4.5)
    assert_close(found["H"], 0)
    assert_close(found["p_x"], number(found["kick"]))
    assert_ledger(found, 0.25 * 81 - 0.21 * omega**2, kept=False)


def test_a_rope_that_jerks_taut() -> None:
    """The velocity along the rope is lost; across it the ball goes on, on a circle."""
    found = solve(JERK)
    along = 4 * 0.8
    assert_close(found["t"], "0.4")
    assert pair(found["v"]) == pytest.approx((-4 * 0.6 * 0.8, 4 * 0.6 * 0.6))
    assert pair(found["J"]) == pytest.approx((-3 * along * 0.6, -3 * along * 0.8))
    assert first(found["T"]) == pytest.approx(3 * 2.4**2 / 2)
    assert first(found["loss"]) == pytest.approx(1.5 * along**2)
    assert_close(found["heat"], number(found["loss"]))
    assert_close(found["v_4"], "2.4")


KERB = """
title: Wheel that just gets over a kerb
plane: vertical
symbols: {m: kg, R: m, h: m}
assume: [h < R]
unknowns: {v_0: m/s}
points: {K: [0, h], G: {y: R, distances: {K: R}, side: left}}
bodies: {wheel: {disk: G, radius: R, mass: m}}
joints:
  - pin: {at: K, between: [ground, wheel], during: 1->3}
states:
  1: [v(G).x = v_0, v(G).y = 0, omega(wheel) = -v_0/R, v_0 > 0]
  2: [just after 1]
  3: [x(G) = 0, y(G) > h, omega(wheel) = 0]
find: {v_0: v_0}
"""


def test_the_least_speed_over_a_kerb() -> None:
    (formula,) = solve(KERB)["v_0"].expressions or ()
    letters = {n: sp.Symbol(n, positive=True) for n in ("R", "h", "g")}
    want = sp.sympify("2*R*sqrt(3*g*h)/(3*R - 2*h)", letters)
    assert sp.simplify(formula.xreplace({s: letters[s.name] for s in formula.free_symbols}) - want) == 0


# --- places that are reached later -----------------------------------------------------------------------------------

OVERTAKEN = """
title: A runs into B
plane: horizontal
bodies: {A: {particle: [0, 0], mass: 2 kg}, B: {particle: [6 m, 0], mass: 3 kg}}
joints:
  - impact: {between: [A, B], normal: 0 deg, restitution: 0.5, during: 2->3}
states:
  1: [t = 0, v(A).x = 5 m/s, v(A).y = 0, v(B).x = 2 m/s, v(B).y = 0]
  2: [x(A) = x(B)]
  3: [just after 2]
  4: [t = 4 s]
find: {t: t @ 2, x: x(A) @ 2, v_A: v(A).x @ 3, v_B: v(B).x @ 3, x_A: x(A) @ 4, x_B: x(B) @ 4}
"""
BOUNCING = """
title: Bouncing ball
plane: vertical
given: {{e: {e}, h: 1 m}}
points: {{F: [0, 0]}}
surfaces: {{floor: {{through: F, angle: 0 deg}}}}
bodies: {{ball: {{particle: [0, h], mass: 1 kg}}}}
joints:
  - impact: {{between: [ball, floor], restitution: e}}
states:
  0: [t = 0, at rest]
  1: [y(ball) = 0]
  2: [just after 1]
  3: [y(ball) = 0]
  4: [just after 3]
  5: [y(ball) = 0]
  6: [just after 5]
find:
  t_1: t @ 1
  t_3: t @ 3
  t_5: t @ 5
  v_6: v(ball).y @ 6
  path: path_length(ball) @ 0->5
  heat: heat(all) @ 0->6
"""
ROCKING = """
title: Block that rocks from corner to corner
plane: vertical
given: {b: 0.1 m, h: 0.5 m, m: 3 kg, R: (sqrt(0.26)) m, phi: atan(0.2)/2}
points:
  A: [0, 0]
  G: {from: A, distance: R, angle: 90 deg + phi}
  B: {from: A, distance: 2*b, angle: 180 deg - phi}
bodies: {block: {points: [A, B], center: G, mass: m, inertia: m*R^2/3}}
joints:
  - pin: {at: A, between: [ground, block], during: 1->2}
  - pin: {at: B, between: [ground, block], during: 2->4}
states:
  1: [t = 0, at rest]
  2: [y(B) = 0]
  3: [just after 2]
  4: [omega(block) = 0]
find:
  t: t @ 2
  before: omega(block) @ 2
  after: omega(block) @ 3
  energy: KE(block) @ 3/KE(block) @ 2
  turned: theta(block) @ 4 - theta(block) @ 3
"""


def test_an_impact_in_a_place_reached_later() -> None:
    found = solve(OVERTAKEN)
    truth = {"t": 2, "x": 10, "v_A": "2.3", "v_B": "3.8", "x_A": "14.6", "x_B": "17.6"}
    for name, value in truth.items():
        assert_close(found[name], value)


@pytest.mark.parametrize("e", ["0.5", "0.9"])
def test_a_bouncing_ball(e: str) -> None:
    """Times and heights of the bounces are geometric sequences in e and e²."""
    found = solve(BOUNCING.format(e=e))
    q = Decimal(e)
    fall = (2 / Decimal("9.81")).sqrt()
    assert_close(found["t_1"], fall)
    assert_close(found["t_3"], fall * (1 + 2 * q))
    assert_close(found["t_5"], fall * (1 + 2 * q + 2 * q**2))
    assert_close(found["v_6"], q**3 * Decimal("9.81") * fall)
    assert_close(found["path"], 1 + 2 * q**2 + 2 * q**4)
    assert_close(found["heat"], (1 - q**6) * Decimal("9.81"))


def test_a_rocking_block() -> None:
    """Housner: on a base of a fifth of its height it keeps 49/52 of its spin, and the swing is not a linear one."""
    found = solve(ROCKING)
    assert first(found["t"]) == pytest.approx(0.34709358679, abs=1e-11)
    assert first(found["before"]) == pytest.approx(0.64804901, abs=1e-8)
    assert_close(found["after"], number(found["before"]) * 49 / 52)
    assert_close(found["energy"], Decimal(49) ** 2 / Decimal(52) ** 2)
    alpha, r = atan2(0.1, 0.5), sqrt(0.26)
    rise = 2 * r / 3 * first(found["after"]) ** 2 / G
    assert first(found["turned"]) == pytest.approx(alpha - asin(sqrt(1 - (cos(alpha) + rise) ** 2)))


# --- what is refused -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("span", "second", "message"),
    [
        (", during: 1->2", "t = 1 s", "the impact takes no time, but state 2 is not just after state 1"),
        (", during: 1->3", "just after 1]\n  3: [t = 1 s", "takes no time, but state 3 is not just after state 1"),
    ],
)
def test_a_blow_says_when_it_happens(span: str, second: str, message: str) -> None:
    text = (DIRECT % 0.5).replace("name: hit", f"name: hit{span}").replace("just after 1", second)
    text = text.replace("1: [", "1: [t = 0, ")
    with pytest.raises(FileProblem) as caught:
        solve(text)
    (diagnostic,) = caught.value.diagnostics
    assert diagnostic.code == "PL433"
    assert message in diagnostic.message


def test_a_line_of_impact_that_is_open() -> None:
    text = (DIRECT % 0.5).replace("[1 m, 0]", "[0, 0]")
    with pytest.raises(FileProblem) as caught:
        solve(text)
    (diagnostic,) = caught.value.diagnostics
    assert (diagnostic.code, diagnostic.message) == (
        "PL528",
        "the direction in which A and B strike each other is open",
    )
    assert diagnostic.hint == "write `normal: 0 deg`, the direction of the common normal"


STRUCK_ROD = """
title: Ball that strikes the end of a pinned rod
plane: horizontal
points: {O: [0, 0], B: [0, -1.5 m]}
bodies: {rod: {rod: [O, B], mass: 4 kg}, ball: {particle: B, mass: 0.5 kg}}
joints:
  - pin: {at: O, between: [ground, rod]}
  - impact: {between: [ball, rod], at: B, normal: 0 deg, restitution: 0.6}
states: {1: [omega(rod) = 0, v(ball).x = 6 m/s, v(ball).y = 0], 2: [just after 1]}
find: {omega: omega(rod) @ 2, v: v(ball).x @ 2, J: impulse(B/rod).x @ 1->2}
"""


def test_the_point_of_an_impact_may_be_written_and_names_it() -> None:
    """m v L = I ω + m v_2 L about the pin, and 1.5 ω - v_2 = e v; the wrong point is in tests/bad_solve."""
    found = solve(STRUCK_ROD)
    omega = sp.Rational(72, 10) / sp.Rational(4125, 1000)
    assert_close(found["omega"], Decimal(str(omega.evalf(30))))
    assert_close(found["v"], Decimal(str((sp.Rational(3, 2) * omega - sp.Rational(36, 10)).evalf(30))))
    assert_close(found["J"], Decimal(str((2 * omega).evalf(30))))


@pytest.mark.parametrize("e", ["1.2", "-0.1"])
def test_a_restitution_that_can_not_be(e: str) -> None:
    with pytest.raises(FileProblem, match="the coefficient of restitution is between 0 and 1"):
        solve(DIRECT % e)


TWO_PINS = """
title: Beam on two pins, struck between them
plane: vertical
points: {{A: [0, 0], B: [2 m, 0], S: [0.5 m, 0]}}
bodies: {{beam: {{rod: [A, B], mass: 12 kg}}}}
joints:
  - pin: {{at: A, between: [ground, beam]}}
  - pin: {{at: B, between: [ground, beam]}}
loads:
  - impulse: {{body: beam, at: S, magnitude: 30 N*s, angle: -90 deg, during: 1->2}}
states: {{1: [at rest], 2: [just after 1]}}
find: {{J: impulse(A).{axis} @ 1->2}}
"""


def test_impulses_that_are_not_unique() -> None:
    """Two pins share what acts along their line as they like; across it they do not."""
    assert_close(solve(TWO_PINS.format(axis="y"))["J"], "22.5")
    with pytest.raises(NoSolution) as caught:
        solve(TWO_PINS.format(axis="x"))
    assert [d.code for d in caught.value.diagnostics] == ["PL603"]
    assert "impulse(A).x" in caught.value.diagnostics[0].message


TOGETHER = """
title: Two cars at a crossing
plane: horizontal
points: {O: [0, 0]}
bodies: {A: {particle: O, mass: 3 kg}, B: {particle: O, mass: 1 kg}}
joints: [{weld: {at: O, between: [A, B], during: 1->2}}]
states:
  1: [v(A).x = 4 m/s, v(A).y = 0, v(B).x = 0, v(B).y = 8 m/s]
  2: [just after 1]
find: {v: v(A) @ 2}
"""


def test_two_particles_at_one_point_are_two() -> None:
    assert pair(solve(TOGETHER)["v"]) == pytest.approx((3, 2))
