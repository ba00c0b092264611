"""An instant of a motion that is given over time: places differentiated, with their values at that instant."""

from __future__ import annotations

from pathlib import Path

import pytest
from answered import assert_close, solve

from planar_cli import cli
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

POLAR = """\
title: Pin in polar coordinates
points: {O: [0, 0]}
bodies: {P: {particle: free}}
motion: [r(P/O).mag = 3 ft + 2 ft/s^2 * t^2, r(P/O).angle = 0.5 rad/s * t]
instant: [t = 1 s]
find: {v_theta: v(P/O).theta, a_r: a(P/O).r, speed: v(P).mag}
"""
ARM = """\
title: Arm that drives a pin along a rod
coordinates: {theta: rad}
points: {O: [0, 0], B: {from: O, distance: 0.65 m, angle: theta}, P: {y: 500 mm, line: [O, theta]}}
bodies: {arm: {rod: [O, B]}, collar: {particle: P}}
joints:
  - pin: {at: O, between: [ground, arm]}
  - guide: {point: P, along: 0 deg, name: rod}
  - guide: {point: P, along: arm, name: slot}
motion: [theta = pi/2 + pi/6*sin(1.5 rad/s * t)]
instant: [t = 5 s]
find: {theta: theta in rad, r: r(P/O).mag, v_r: v(P/O).r, a_theta: a(P/O).theta}
"""
PATH = """\
title: Particle in the plane
bodies: {P: {particle: free}}
motion: [x(P) = 2 m/s * t, y(P) = 1 m/s^3 * t^3]
instant: [t = 1 s]
find: {a_t: a(P).t, a_n: a(P).n, rho: rho(P)}
"""

RATE_LIKE_TIME = """\
title: Pin that is drawn out along a line whose angle is t²/2
coordinates: {s: m, theta: rad}
points: {O: [0, 0], P: {from: O, distance: s, angle: theta}}
bodies: {pin: {particle: P}}
motion: [theta = 0.5 rad/s^2 * t^2, s = 0.05 m/s * t]
instant: [t = 2 s]
find: {a: a(P).mag}
"""
"""θ̇ is then t itself, which is no rate that is left open."""
SLOT = """\
title: Pin in a slot of a disk that gathers speed
given: {h: 0.1 m}
coordinates: {s: m, theta: rad}
points:
  O: [0, 0]
  F: {from: O, distance: h, angle: theta + 90 deg}
  P: {from: F, distance: s, angle: theta}
bodies: {disk: {disk: O, radius: 0.4 m, points: [F]}, pin: {particle: P}}
joints:
  - pin: {at: O, between: [ground, disk]}
motion: [theta = 0.5 rad/s^2 * t^2, s = 0.05 m/s * t]
states:
  0: [t = 0]
  2: [t = 2 s]
find: {v: v(P).mag @ 2, a: a(P).mag @ 2, a_cor: coriolis(P/disk).mag @ 2, omega: omega(disk) @ 2}
"""


def _page(text: str) -> str:
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    return " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        (
            POLAR,
            (
                "r_P = 3 + 2 t² = 5 ft",
                "v_Pθ = r_P θ̇_P = 5 · 0.5 = 2.5 ft/s",
                "a_Pr = r̈_P - r_P θ̇_P² = 4 - 5 · 0.5² = 2.75 ft/s²",
                "v_P = √(v_Pr² + v_Pθ²) = √(4² + 2.5²) = 4.717 ft/s",
            ),
        ),
        (
            ARM,
            (
                "θ̇ = π/4 cos(3 t/2) = 0.2722 rad/s",
                "r = y_P/sin θ = 0.5 m/sin θ = 0.5/sin(2.062 rad) = 0.5670 m",
                "θ = 2.062 rad",
                "2 · 0.08256 · 0.2722 + 0.5670 (-1.105) = -0.5816 m/s²",
            ),
        ),
        (
            PATH,
            (
                " = 3 t² = 3 m/s",
                "/3.606 = 4.992 m/s²",
                "ρ = v_P²/a_Pn = 3.6056²/3.328 = 3.906 m",
            ),
        ),
    ],
)
def test_lines(text: str, lines: tuple[str, ...]) -> None:
    page = _page(text)
    for one in lines:
        assert one in page
    assert "Hence" not in page


@pytest.mark.parametrize("command", ["solve", "simulate"])
def test_no_state_is_before_the_first(tmp_path: Path, capsys: pytest.CaptureFixture[str], command: str) -> None:
    file = tmp_path / "slider.yaml"
    file.write_text(
        "plane: vertical\npoints: {A: [0, 0]}\nbodies: {b: {particle: A, mass: 2 kg}}\n"
        "joints: [{guide: {point: A, along: 0 deg}}]\n"
        "states: {1: [t = 0, r(A).x = 0, v(A).x = 1 m/s], 2: [t = -10 s]}\nfind: {x: r(A).x @ 2}\n"
    )
    assert cli.run([command, str(file)]) == 1
    assert "PL723 state 2 is at t = -10 s, before the motion begins at t = 0 s" in "".join(capsys.readouterr())


def test_a_rate_that_is_the_time_itself() -> None:
    page = _page(RATE_LIKE_TIME)
    assert "= 0.5 m/s² Answer a = 0.5 m/s²" in page


def test_a_slot_of_a_disk_that_gathers_speed() -> None:
    """v = (ṡ - ω h, ω s), a = (-α h - ω² s, α s - ω² h + 2 ω ṡ) along the slot and across it."""
    found = solve(SLOT)
    for name, truth in {"v": "0.25", "a": "0.50990195135927848", "a_cor": "0.2", "omega": "2"}.items():
        assert_close(found[name], truth)
