"""What letters must be for a motion to take the course in which it was solved stands on the page."""

from __future__ import annotations

import pytest

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

SLIDING = """
title: Block that slides and stops
plane: vertical
symbols: {m: kg, mu: 1, v_0: m/s, T: s}
points: {C: [0, 0]}
surfaces: {floor: {through: C, angle: 0}}
bodies: {block: {particle: C, mass: m}}
joints:
  - contact: {between: [block, floor], mu: mu, name: F}
states: {1: [t = 0, v(block).x = v_0], 2: [t = T]}
find: {x: x(block) @ 2}
"""

DRAG = """
title: Ball thrown up against the air
plane: vertical
symbols: {m: kg, c: kg/m, v_0: m/s, g: m/s^2, T: s}
points: {P: [0, 0]}
bodies: {ball: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 90 deg}
loads:
  - drag: {body: ball, magnitude: c*v(ball).mag^2}
states: {up: [t = 0, v(ball).y = v_0], then: [t = T]}
find: {v: v(ball).y @ then}
"""

CARS = """
title: A car that brakes behind another one
plane: horizontal
symbols: {v_A: m/s, v_B: m/s, a: m/s^2, d: m}
bodies: {A: {particle: [0, 0]}, B: {particle: [d, 0]}}
motion: [a(A).x = -a, a(A).y = 0, v(B).x = v_B, v(B).y = 0]
states: {1: [t = 0, v(A).x = v_A, v(A).y = 0], 2: [x(A) = x(B)]}
find: {t: t @ 2}
"""

CIRCLE = """
title: Ball on a cord to the top
plane: vertical
symbols: {m: kg, L: m, v_0: m/s}
points: {O: [0, 0], P: [0, -L]}
bodies: {ball: {particle: P, mass: m}}
joints:
  - rope: {path: [O, P], name: S}
states: {1: [t = 0, v(ball).x = v_0], top: [y(ball) = L]}
find: {v: v(ball).mag @ top}
"""

SPRING = """
title: Block with friction on a spring
plane: vertical
symbols: {m: kg, mu: 1, x_0: m, k: N/m, T: s, L: m}
points: {W: [0, 0], C: [L, 0]}
surfaces: {floor: {through: C, angle: 0}}
bodies: {block: {particle: C, mass: m}}
joints:
  - contact: {between: [block, floor], mu: mu, name: F}
loads:
  - spring: {between: [W, C], stiffness: k, natural_length: L - x_0}
states: {1: [t = 0, at rest], 2: [t = T]}
find: {v: v(block).x @ 2}
"""

DOME = """
title: Particle down a dome
plane: vertical
symbols: {m: kg, R: m, h: m}
points: {O: [0, 0], P: [0, R]}
surfaces: {dome: {center: O, radius: R}}
bodies: {ball: {particle: P, mass: m}}
joints:
  - contact: {between: [ball, dome], mu: 0, name: N}
states: {1: [t = 0, at rest], low: [y(ball) = R - h, x(ball) > 0]}
find: {v: v(ball).y @ low}
"""

BACK = """
title: Block that slides back down a rough slope
plane: vertical
symbols: {m: kg, beta: deg, mu: 1, v_0: m/s, T: s}
assume: [T > v_0/(g*(sin(beta) + mu*cos(beta)))]
points: {C: [0, 0]}
surfaces: {slope: {through: C, angle: beta}}
bodies: {block: {particle: C, mass: m}}
joints:
  - contact: {between: [block, slope], mu: mu, name: F}
states: {1: [t = 0, v(block).along(beta) = v_0], 2: [t = T]}
find: {v: v(block).along(beta) @ 2}
"""


def assumed(text: str) -> list[str]:
    """The lines of what is assumed."""
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    lines = Terminal().render(narrate(solve_problem(problem))).splitlines()
    first = next((i for i, line in enumerate(lines) if line.startswith("Assume")), len(lines))
    found = []
    for line in lines[first:]:
        if found and not line.startswith(" " * 12):
            break
        found.append(line[12:])
    return found


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "condition"),
    [
        (SLIDING, "v_0 > μ T g"),
        (DRAG, "arctan(v_0 √(c/(m g))) > T √(c g/m)"),
        (CARS, "v_A > v_B + √(v_A² + v_B² - 2 a d - 2 v_A v_B)"),
        (CIRCLE, "v_0² > 5 g L"),
        (SPRING, "k x_0 > μ m g"),
        (SPRING, "π > T √(k/m)"),
        (DOME, "3 h > R"),
        (BACK, "sin β > μ cos β"),
    ],
)
def test_until_when_it_holds_is_told(text: str, condition: str) -> None:
    """At rest it stays with friction, comes down with drag, never meets, and falls from a cord that is not taut."""
    assert condition in assumed(text)


def test_the_file_may_say_it_itself() -> None:
    """Then it is told once."""
    said = assumed(SLIDING.replace("points:", "assume: [v_0 > mu*g*T]\npoints:"))
    assert len(said) == 2


def test_what_fails_on_the_way_is_told_in_words() -> None:
    """It may be lifted by a force that swings, and be down again at T: m g > F_0 sin(w T) does not tell that."""
    force = "force: {body: block, magnitude: F_0*sin(w*t), angle: 90 deg}"
    smooth = SLIDING.replace("mu: mu", "mu: 0").replace("mu: 1, ", "").replace("T: s}", "T: s, F_0: N, w: rad/s}")
    said = assumed(smooth.replace("states:", f"loads:\n  - {force}\nstates:"))
    assert "m g > F_0 sin(T w)" in said
    assert "N_F presses from 1 to 2; whether it is so depends on the letters" in said


def test_what_always_holds_is_not_assumed() -> None:
    """A block that slides to its stop stops with all letters."""
    stops = SLIDING.replace("2: [t = T]", "2: [v(block).x = 0]").replace(", T: s}", "}")
    assert assumed(stops) == ["block at C slips"]
