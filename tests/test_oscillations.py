"""Small oscillations about states of equilibrium: periods, stability, and where there is none."""

from __future__ import annotations

import math
from pathlib import Path

import mpmath
import pytest
import sympy as sp
from answered import assert_close, solve, solved
from answered import first as number
from conftest import ROOT

from planar_cli.errors import FileProblem, NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

BLOCK = """
title: Block
plane: {plane}
{names}
coordinates: {{x: m}}
points: {{W: [-1 m, 0], P: [x, 0]}}
bodies: {{block: {{particle: P, mass: m}}}}
joints:
  - guide: {{point: P, along: 0 deg}}
loads:
  - spring: {{between: [W, P], stiffness: k, relaxed_at: [x = 0]}}
  - damper: {{between: [W, P], coefficient: c}}
states: {{rest: [equilibrium]}}
find: {find}
"""
NUMBERS = "given: {{m: 2 kg, k: 200 N/m, c: {c} N*s/m}}"

PENDULUM = """
title: Pendulum
plane: vertical
symbols: {m: kg, l: m}
coordinates: {theta: deg}
points: {O: [0, 0], P: {from: O, distance: l, angle: theta - 90 deg}}
bodies: {bob: {particle: P, mass: m}}
joints:
  - link: {between: [O, P]}
states: {s: [STATE]}
find: {FIND}
"""

DOUBLE = """
title: Two blocks
plane: vertical
given: {m: 1 kg, k: 100 N/m}
coordinates: {x: m, y: m}
points: {W: [-1 m, 0], P: [x, 0], Q: [1 m + y, 0], V: [2 m, 0]}
bodies: {p: {particle: P, mass: m}, q: {particle: Q, mass: m}}
joints:
  - guide: {point: P, along: 0 deg}
  - guide: {point: Q, along: 0 deg}
loads:
  - spring: {between: [W, P], stiffness: k, natural_length: 1 m}
  - spring: {between: [P, Q], stiffness: k, natural_length: 1 m}
  - spring: {between: [Q, V], stiffness: k, natural_length: 1 m}
states: {rest: [x = 0, y = 0, equilibrium]}
find: {FIND}
"""


def block(find: str, c: int) -> str:
    return BLOCK.format(plane="vertical", names=NUMBERS.format(c=c), find=find)


def pendulum(state: str, find: str) -> str:
    return PENDULUM.replace("STATE", state).replace("FIND", find)


def test_an_undamped_block(tmp_path: Path) -> None:
    found = solved(tmp_path, block("{T: period(rest), f: frequency(rest), w: frequency(rest) in rad/s}", 0))
    assert number(found["T"]) == pytest.approx(2 * math.pi / 10)
    assert number(found["f"]) == pytest.approx(10 / (2 * math.pi))
    assert number(found["w"]) == pytest.approx(10)


def test_a_damped_block_has_a_longer_period(tmp_path: Path) -> None:
    found = solved(tmp_path, block("{T: period(rest), holds: stable(rest)}", 8))
    assert number(found["T"]) == pytest.approx(2 * math.pi / math.sqrt(100 - 4))
    assert found["holds"].word == "true"


@pytest.mark.parametrize(("c", "word"), [(40, "critically damped"), (100, "overdamped")])
def test_strong_damping_has_no_period(tmp_path: Path, c: int, word: str) -> None:
    with pytest.raises(NoSolution) as caught:
        solved(tmp_path, block("{T: period(rest)}", c))
    assert word in str(caught.value)
    assert caught.value.diagnostics[0].mark.line > 1


def test_letters_give_a_formula(tmp_path: Path) -> None:
    names = "symbols: {m: kg, k: N/m}\ngiven: {c: 0 N*s/m}"
    found = solved(tmp_path, BLOCK.format(plane="vertical", names=names, find="{T: period(rest), x_0: x @ rest}"))
    assert found["T"].expressions is not None
    m, k = sp.symbols("m k", positive=True)
    assert sp.simplify(found["T"].expressions[0] - 2 * sp.pi * sp.sqrt(m / k)) == 0
    assert found["x_0"].expressions == (0,)


def test_a_pendulum_that_hangs(tmp_path: Path) -> None:
    found = solved(tmp_path, pendulum("theta = 0 deg, equilibrium", "T: period(s), holds: stable(s)"))
    assert found["T"].expressions is not None
    length, g = sp.symbols("l g", positive=True)
    assert sp.simplify(found["T"].expressions[0] - 2 * sp.pi * sp.sqrt(length / g)) == 0
    assert found["holds"].word == "true"


def test_a_pendulum_that_stands_is_unstable(tmp_path: Path) -> None:
    found = solved(tmp_path, pendulum("theta = 180 deg, equilibrium", "holds: stable(s)"))
    assert found["holds"].word == "false"
    with pytest.raises(NoSolution, match="not stable"):
        solved(tmp_path, pendulum("theta = 180 deg, equilibrium", "T: period(s)"))


def test_an_inequality_chooses_the_position(tmp_path: Path) -> None:
    found = solved(tmp_path, pendulum("equilibrium, theta > 90 deg, theta < 270 deg", "up: stable(s)"))
    assert found["up"].word == "false"


def test_several_positions_are_listed(tmp_path: Path) -> None:
    with pytest.raises(NoSolution, match="several positions of equilibrium"):
        solved(tmp_path, pendulum("equilibrium", "T: period(s)"))


def test_a_state_that_is_no_equilibrium(tmp_path: Path) -> None:
    with pytest.raises(FileProblem, match="no equilibrium"):
        solved(tmp_path, pendulum("t = 0, theta = 10 deg, at rest", "T: period(s)"))


def test_a_linear_term_that_vanishes(tmp_path: Path) -> None:
    """Two level springs across the way of a ball: only the third power of the deviation draws it back."""
    text = """
    title: Ball between springs
    plane: horizontal
    given: {m: 1 kg, k: 100 N/m, l: 0.5 m}
    coordinates: {y: m}
    points: {A: [-0.5 m, 0], B: [0.5 m, 0], P: [0, y]}
    bodies: {ball: {particle: P, mass: m}}
    joints:
      - guide: {point: P, along: 90 deg}
    loads:
      - spring: {between: [A, P], stiffness: k, natural_length: l}
      - spring: {between: [B, P], stiffness: k, natural_length: l}
    states: {rest: [y = 0, equilibrium]}
    find: {holds: stable(rest)}
    """
    assert solved(tmp_path, "\n".join(s[4:] for s in text.splitlines()))["holds"].word == "true"


@pytest.mark.slow
def test_two_freedoms_have_two_periods(tmp_path: Path) -> None:
    assert solved(tmp_path, DOUBLE.replace("FIND", "holds: stable(rest)"))["holds"].word == "true"
    told = solved(tmp_path, DOUBLE.replace("FIND", "T: period(rest)"))["T"].values
    assert told is not None
    assert [float(v) for v in told] == pytest.approx([2 * math.pi / 10, 2 * math.pi / math.sqrt(300)])


def test_a_period_can_fix_a_constant(tmp_path: Path) -> None:
    text = block("{k_needed: k}", 0).replace("k: 200 N/m, ", "")
    text = text.replace("coordinates", "unknowns: {k: N/m}\ncoordinates")
    text = text.replace("[equilibrium]", "[equilibrium, period(rest) = 1 s]")
    assert number(solved(tmp_path, text)["k_needed"]) == pytest.approx(2 * (2 * math.pi) ** 2)


UNLIKE = """
title: Double pendulum of two bobs
plane: vertical
points: {O: [0, 0], A: [0, -1 m], B: [0, -2 m]}
bodies: {upper: {particle: A, mass: %d kg}, lower: {particle: B, mass: %d kg}}
joints:
  - link: {between: [O, A], name: first}
  - link: {between: [A, B], name: second}
states: {rest: [equilibrium]}
find: {holds: stable(rest)}
"""


@pytest.mark.slow
@pytest.mark.parametrize(
    ("upper", "lower", "frequencies"),
    [
        (1, 10**6, ("2.21472373587529", "4429.44857911216")),
        (10**6, 1, ("3.13052708103524", "3.13365917337942")),
    ],
)
def test_frequencies_of_bobs_of_very_unlike_mass(upper: int, lower: int, frequencies: tuple[str, str]) -> None:
    """ω⁴ - 2 (1 + r) (g/l) ω² + (1 + r) (g/l)² = 0 with the ratio r of the lower mass to the upper one."""
    problem, wrong = load_text(UNLIKE % (upper, lower))
    assert problem is not None, wrong
    motion = solve_problem(problem).parts[0].motion
    assert motion is not None
    (found,) = motion.oscillations
    up = sorted(root.imag for root in found.roots if root.imag > 0)
    assert len(up) == 2
    for omega, wanted in zip(up, frequencies, strict=True):
        assert abs(omega - mpmath.mpf(wanted)) <= 1e-10 * omega


ECCENTRIC = """
title: A body that rolls with its rim, its mass centre beside the centre of that
plane: vertical
given: {m: 2 kg, r: 0.2 m}
points: {O: [0, r], C: [0, 0], Q: [0, r/2]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {half: BODY}
joints:
  - rolling: {between: [half, floor], at: C}
states: {rest: [equilibrium]}
find: {T: period(rest)}
"""


@pytest.mark.parametrize(
    ("body", "period"),
    [
        (
            "{parts: [{disk: O, radius: r, mass: m}, {particle: Q, mass: m}]}",
            2 * math.pi * math.sqrt(1.75 * 0.2 / (0.5 * 9.81)),
        ),
        (
            "{sector: O, radius: r, span: 180 deg, angle: -90 deg, mass: m}",
            math.pi * math.sqrt(2 * (9 * math.pi - 16) * 0.2 / 9.81) / 2,
        ),
    ],
)
def test_a_rim_that_rolls_about_a_centre_beside_the_mass_centre(tmp_path: Path, body: str, period: float) -> None:
    found = solved(tmp_path, ECCENTRIC.replace("BODY", body))
    assert number(found["T"]) == pytest.approx(period)


CRADLE = """
title: An eccentric disk in a bowl
plane: vertical
given: {m: 2 kg, r: 0.2 m, R: 0.8 m}
points: {A: [0, R], O: [0, r], C: [0, 0], Q: [0, r/2]}
surfaces: {bowl: {center: A, radius: R}}
bodies: {half: {parts: [{disk: O, radius: r, mass: m}, {particle: Q, mass: m}]}}
joints:
  - rolling: {between: [half, bowl], at: C}
states: {rest: [equilibrium]}
find: {T: period(rest)}
"""


def test_a_rim_that_rolls_in_a_bowl(tmp_path: Path) -> None:
    """V = 2 m g (-(R - r) cos ψ - r/4 cos θ), (R - r) ψ = -r θ, turning about the lowest point."""
    stiffness = 2 * 2 * 9.81 * (0.6 * (0.2 / 0.6) ** 2 + 0.05)
    assert number(solved(tmp_path, CRADLE)["T"]) == pytest.approx(
        2 * math.pi * math.sqrt(1.75 * 2 * 0.2**2 / stiffness)
    )


PIVOT = """
title: Rod on a pivot beside its centre
plane: vertical
given: {{l: 1 m, m: 2 kg}}
unknowns: {{b: m}}
points: {{O: [0, 0], A: [0, l/2 - b], B: [0, -l/2 - b]}}
bodies: {{rod: {{rod: [A, B], mass: m, points: [O]}}}}
joints:
  - pin: {{at: O, between: [ground, rod]}}
states:
  hang: [equilibrium, theta(rod) = -90 deg, {told}]
find: {{b: b}}
"""


def test_a_period_tells_a_constant_that_is_sought(tmp_path: Path) -> None:
    """g b T² = 4 π² (l²/12 + b²) has two roots; an inequality chooses."""
    root = math.sqrt((9.81 * 1.6**2 / (8 * math.pi**2)) ** 2 - 1 / 12)
    near = solved(tmp_path, PIVOT.format(told="period(hang) = 1.6 s, b < 0.3 m"))
    assert number(near["b"]) == pytest.approx(9.81 * 1.6**2 / (8 * math.pi**2) - root)
    with pytest.raises(NoSolution, match=r"b = 0\.184525, theta = -pi/2; b = 0\.451610"):
        solved(tmp_path, PIVOT.format(told="period(hang) = 1.6 s"))


def test_what_is_largest_nowhere_is_told(tmp_path: Path) -> None:
    assert number(solved(tmp_path, PIVOT.format(told="frequency(hang) is largest"))["b"]) == pytest.approx(
        1 / math.sqrt(12)
    )
    with pytest.raises(NoSolution, match="`period\\(hang\\) is largest` nowhere"):
        solved(tmp_path, PIVOT.format(told="period(hang) is largest"))


def test_a_ratio_of_periods() -> None:
    """A period and a frequency are numbers like others: T f = 1, and T in parts of a second."""
    found = solve(
        """
title: Block on a spring
plane: vertical
given: {m: 2 kg, k: 72 N/m}
coordinates: {x: m}
points: {W: [-1 m, 0], P: [x, 0]}
surfaces: {floor: {through: [0, 0], angle: 0 deg}}
bodies: {block: {particle: P, mass: m}}
joints: [{contact: {between: [block, floor], mu: 0}}]
loads: [{spring: {between: [W, P], stiffness: k, relaxed_at: [x = 0]}}]
states: {rest: [equilibrium]}
find: {half: period(rest)/2, one: period(rest)*frequency(rest), ratio: period(rest)/(3 s) + 1}
"""
    )
    assert_close(found["half"], math.pi / 6)
    assert_close(found["one"], 1)
    assert_close(found["ratio"], math.pi / 9 + 1)


@pytest.mark.parametrize("last", [False, True], ids=["equilibrium first", "equilibrium last"])
def test_an_equilibrium_beside_a_motion(last: bool) -> None:
    """A disk rolls by R θ = s_1 - s: the place of the first state enters the equilibrium where that is listed later."""
    text = """
title: Rolling disk on a spring with a damper
plane: vertical
given: {m: 10 kg, R: 0.2 m, k: 600 N/m, c: 40 N*s/m}
coordinates: {s: m}
points: {C: [s, 0], G: [s, R], W: [-1 m, R]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {disk: {disk: G, radius: R, mass: m}}
joints: [{rolling: {between: [disk, floor], at: C}}]
loads:
  - spring: {between: [W, G], stiffness: k, natural_length: 1 m}
  - damper: {between: [W, G], coefficient: c}
states:
  FIRST
  1: [at rest, s = 0.1 m, t = 0]
  2: [t = 1 s]
  LAST
find: {T: period(level), s: x(G) @ 2}
"""
    level = "level: [equilibrium]"
    found = solve(text.replace("FIRST", "" if last else level).replace("LAST", level if last else ""))
    decay = 4 / mpmath.mpf(3)
    swing = mpmath.sqrt(40 - decay**2)
    assert_close(found["T"], str(2 * mpmath.pi / swing), 10)
    assert_close(found["s"], str(mpmath.exp(-decay) * (mpmath.cos(swing) + decay / swing * mpmath.sin(swing)) / 10), 10)


TOY = """
title: Half disk with a rectangle on it, on its round end
plane: vertical
given: {r: 100 mm, q: 50 kg/m^2, h: 70 mm}
points: {C: [0, 0], O: [0, r], K: [0, r + h/2]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies:
  toy:
    parts:
      - {sector: O, radius: r, span: 180 deg, angle: 270 deg, mass: q*pi*r^2/2}
      - {plate: K, width: 2*r, height: h, angle: 0 deg, mass: 2*q*r*h}
joints:
  - rolling: {between: [toy, floor], at: C}
"""


def test_a_part_that_is_a_sector_rolls_on_its_arc() -> None:
    found = solve(TOY + "states: {up: [equilibrium, x(toy) = 0]}\nfind: {T: period(up), holds: stable(up)}\n")
    r, h, m1, m2 = 0.1, 0.07, 50 * math.pi * 0.01 / 2, 2 * 50 * 0.1 * 0.07
    y1, y2 = -4 * r / (3 * math.pi), h / 2
    y = (m1 * y1 + m2 * y2) / (m1 + m2)
    inertia = m1 * (r * r / 2 - y1 * y1 + (y1 - y) ** 2) + m2 * ((4 * r * r + h * h) / 12 + (y2 - y) ** 2)
    inertia += (m1 + m2) * (r + y) ** 2
    assert number(found["T"]) == pytest.approx(2 * math.pi * math.sqrt(inertia / (-(m1 + m2) * 9.81 * y)))
    assert found["holds"].word == "true"


def test_a_size_that_is_sought_is_not_negative() -> None:
    """The mass centre is in the centre of the arc for h = ± r √(2/3)."""
    text = TOY.replace(", h: 70 mm", "") + "unknowns: {h: mm}\nstates: {up: [equilibrium, x(toy) = 0, y(toy) = r]}\n"
    assert number(solve(text + "find: {h: h}\n")["h"]) == pytest.approx(0.1 * math.sqrt(2 / 3))


def test_what_is_long_in_data_stands_in_the_letters_of_the_page() -> None:
    text = TOY + "states: {up: [equilibrium, x(toy) = 0]}\nfind: {T: period(up)}\n"
    problem, _ = load_text(text)
    assert problem is not None
    page = " ".join(Terminal().render(narrate(solve_problem(problem))).split())
    assert "δ̈ + m g (r - y_G) δ / (m y_G² + I) = 0" in page
    assert "(1.485 · 0.094053² + 0.007351)) = 2.056 rad/s" in page


CLOSER = """
title: Block that just does not oscillate
plane: horizontal
{known}
unknowns: {{c: N*s/m}}
coordinates: {{x: m}}
points: {{W: [-0.5 m, 0], P: [x, 0]}}
bodies: {{block: {{particle: P, mass: m}}}}
joints:
  - guide: {{point: P, along: 0 deg}}
loads:
  - spring: {{between: [W, P], stiffness: k, relaxed_at: [x = 0]}}
  - damper: {{between: [W, P], coefficient: c}}
states: {{rest: [equilibrium, x = 0, frequency(rest) = 0]}}
find: {{c: c}}
"""


def test_critical_damping() -> None:
    """c = 2 √(k m), and not its negative."""
    found = solve(CLOSER.format(known="given: {m: 2 kg, k: 200 N/m}"))
    assert number(found["c"]) == pytest.approx(40)
    letters = solve(CLOSER.format(known="symbols: {m: kg, k: N/m}"))["c"].expressions
    m, k = sp.symbols("m k", positive=True)
    assert letters is not None
    assert sp.simplify(letters[0] - 2 * sp.sqrt(k * m)) == 0


def test_no_coefficient_that_is_surely_negative() -> None:
    """Where c = 2 √(k m) is excluded, c = -2 √(k m) is no answer, in letters either."""
    with pytest.raises(NoSolution, match="no position of equilibrium"):
        solve(CLOSER.format(known="symbols: {m: kg, k: N/m}\nassume: [c < sqrt(k*m)]"))


HINGED_BAR = """
title: Hinged bar that just does not oscillate
plane: vertical
symbols: {m: kg, L: m, k: N/m, h: m}
unknowns: {l_0: m, c: N*s/m}
coordinates: {theta: rad}
points:
  A: [0, 0]
  B: {from: A, distance: L, angle: theta}
  D: {midpoint: [A, B]}
  S: [L, h]
  E: [L/2, -h]
bodies: {AB: {rod: [A, B], mass: m, points: [D]}}
joints:
  - pin: {at: A, between: [ground, AB]}
loads:
  - spring: {between: [S, B], stiffness: k, natural_length: l_0}
  - damper: {between: [E, D], coefficient: c}
states: {rest: [equilibrium, theta = 0, frequency(rest) = 0]}
find: {c: c}
"""


def test_a_stated_place_is_put_into_the_period_before_it_is_solved() -> None:
    """m L²/3 θ̈ + c L²/4 θ̇ + k L² θ = 0; in a general position this has roots of roots that no one can expand."""
    (c,) = solve(HINGED_BAR)["c"].expressions or ()
    k, m = sp.symbols("k m", positive=True)
    assert sp.simplify(c - 8 * sp.sqrt(k * m / 3)) == 0


LIGHT_LEVER = """
title: Light lever that a spring holds against a force
plane: vertical
given: {k: 2 kN/m, l: 0.5 m, F: 100 N}
coordinates: {theta: deg}
points: {A: [0, 0], B: {from: A, distance: l, angle: theta}, S: [0, 2*l]}
bodies: {AB: {rod: [A, B]}}
joints:
  - pin: {at: A, between: [ground, AB]}
loads:
  - spring: {between: [B, S], stiffness: k, natural_length: l}
  - force: {body: AB, at: B, magnitude: F, angle: -90 deg}
states: {1: [equilibrium, theta > 0, theta < 90 deg]}
find: {theta: theta @ 1 in rad}
"""


def test_equilibrium_of_a_light_lever() -> None:
    """With n l the length of the spring, 2 k l (1 - 1/n) = F and n² = 5 - 4 sin θ. The reaction at A runs along the
    lever: its moment about the middle has cancelled.
    """
    n = 1 / (1 - 100 / (2 * 2000 * 0.5))
    assert number(solve(LIGHT_LEVER)["theta"]) == pytest.approx(math.asin((5 - n**2) / 4))


SHAKEN = """
title: Block on a spring whose other end is shaken
plane: horizontal
given: {m: 2 kg, k: 800 N/m, b: 10 mm, w: 15 rad/s, l: 300 mm}
points: {B: [0, 0], P: [l, 0]}
bodies: {base: {particle: B}, block: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 0 deg}
  - guide: {point: B, along: 0 deg}
loads:
  - spring: {between: [B, P], stiffness: k, natural_length: l}
motion: [x(B) = b*sin(w*t)]
states: {1: [t = 0, block at rest], 2: [t = 0.5 s]}
find: {x: x(P) @ 2 - l}
"""


def test_a_shaken_base_has_a_closed_form() -> None:
    """x = b (sin wt - n sin w_0 t)/(1 - n²), n = w/w_0: the place of the base stands in the law as a function of t."""
    problem, _ = load_text(SHAKEN)
    assert problem is not None
    solution = solve_problem(problem)
    page = Terminal(200).render(narrate(solution))
    assert "sin(w t_2)" in page
    assert "natural frequency: ω_n = √(k/m)" in " ".join(page.split())
    assert "numerically" not in page
    n = 15 / 20
    expected = 0.01 * (math.sin(7.5) - n * math.sin(10)) / (1 - n**2)
    assert number(solution.parts[0].found[0]) == pytest.approx(expected)


def test_an_equilibrium_that_nothing_chooses_is_named() -> None:
    text = (ROOT / "problems/oscillations/bead-on-a-turning-hoop.yaml").read_text(encoding="utf-8")
    with pytest.raises(NoSolution, match=r"in_: several positions of equilibrium: phi = 0; phi = pi$"):
        solve(text.replace("phi = pi, equilibrium", "equilibrium"))
