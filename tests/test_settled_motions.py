"""Motions that begin in an equilibrium which the file does not place, and where motions go as t goes to infinity."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from planar_cli.errors import FileProblem, NoSolution
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.structure import load
from planar_cli.simulate.run import Settings, Simulation, simulate

PROBLEMS = Path(__file__).parent.parent / "problems"
HUNG = """\
title: A block on a spring
plane: vertical
given: {{m: {m}, k: {k}, l_0: {l_0}, c: {c}}}
coordinates: {{s: m}}
points: {{C: [0, 0]}}
bodies: {{P: {{particle: [0, -s], mass: m}}}}
joints:
  - guide: {{point: P, along: 90 deg}}
loads:
  - spring: {{between: [C, P], stiffness: k, natural_length: l_0}}
  - damper: {{between: [C, P], coefficient: c}}
"""
SIZES = {"m": "2 kg", "k": "400 N/m", "l_0": "300 mm", "c": "8 N*s/m"}
PENDULUM = """\
title: A pendulum
plane: vertical
coordinates: {phi: rad}
points: {O: [0, 0], P: [sin(phi)*0.5 m, -cos(phi)*0.5 m]}
bodies: {rod: {rod: [O, P], mass: 1 kg}}
joints:
  - pin: {at: O, between: [ground, rod]}
"""


def problem_of(path: Path, case: str = "") -> Problem:
    problem, wrong, _ = load(str(path))
    assert problem is not None, wrong
    return next(c.problem for c in problem.cases if c.name == case) if case else problem


def answers(problem: Problem) -> dict[str, float]:
    return {a.name: a.values[0] for a in simulate(problem, Settings(estimate=False), {}).answers if a.values}


def written(folder: Path, text: str) -> Problem:
    path = folder / "scene.yaml"
    path.write_text(text, encoding="utf-8")
    return problem_of(path)


def run(folder: Path, text: str, settings: Settings | None = None) -> Simulation:
    return simulate(written(folder, text), settings or Settings(estimate=False), {})


@pytest.mark.parametrize(
    ("file", "case", "expected"),
    [
        ("oscillations/block-between-two-springs", "parallel", {"x_rest": 0.5, "F_left": 50.0, "F_right": 50.0}),
        ("oscillations/collar-on-a-turning-rod-with-spring", "steady", {"r_e": 50 * 0.2 / (50 - 0.4 * 64)}),
        ("momentum/jet-against-a-hinged-plate", "hanging", {"angle": math.radians(39.1009496)}),
    ],
)
def test_a_start_in_equilibrium(file: str, case: str, expected: dict[str, float]) -> None:
    """Springs, a driven rod (relative equilibrium: k (r - l0) = m ω² r), a jet that is found with an inequality."""
    found = answers(problem_of(PROBLEMS / f"{file}.yaml", case))
    assert {name: found[name] for name in expected} == pytest.approx(expected, rel=1e-8)


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e6])
def test_it_is_found_at_any_size(size: float, tmp_path: Path) -> None:
    sizes = SIZES | {"m": f"{2 * size:g} kg", "l_0": f"{0.3 * size:g} m"}
    text = HUNG.format(**sizes) + "states: {hang: [s > 0, equilibrium]}\nfind: {s: s @ hang}\n"
    assert answers(written(tmp_path, text))["s"] == pytest.approx(size * (0.3 + 2 * 9.81 / 400), rel=1e-8)


def test_of_several_equilibria_the_file_chooses_one(tmp_path: Path) -> None:
    """A pendulum hangs or stands."""
    found = "states: {low: [equilibrium]}\nfind: {phi: phi @ low}\n"
    with pytest.raises(FileProblem, match=r"several values of phi: 0 rad, 3.14159 rad"):
        run(tmp_path, PENDULUM + found)
    below = found.replace("[equilibrium]", "[equilibrium, y(P) < 0]")
    assert answers(written(tmp_path, PENDULUM + below))["phi"] == pytest.approx(0.0, abs=1e-12)


def test_no_equilibrium_is_said(tmp_path: Path) -> None:
    with pytest.raises(NoSolution, match="no place of equilibrium"):
        run(tmp_path, PENDULUM + "states: {low: [equilibrium, phi > 0.1 rad, phi < 3 rad]}\nfind: {phi: phi @ low}\n")


def test_a_place_that_is_no_equilibrium_is_said(tmp_path: Path) -> None:
    with pytest.raises(NoSolution, match="no equilibrium"):
        run(tmp_path, PENDULUM + "states: {low: [equilibrium, phi = 0.1 rad]}\nfind: {phi: phi @ low}\n")


def test_a_distance_that_is_drawn_negative(tmp_path: Path) -> None:
    """It stays what the file says, on the other side of its origin."""
    text = """\
title: A bead on a rod
plane: horizontal
coordinates: {r: m}
points: {O: [0, 0], P: {from: O, distance: r, angle: 30 deg}}
bodies: {bead: {particle: P, mass: 1 kg}}
joints:
  - guide: {point: P, along: 30 deg}
states:
  1: [t = 0, r = -2 m, dot(r) = 1 m/s]
  2: [t = 1 s]
find: {r_1: r @ 1, r_2: r @ 2}
"""
    assert answers(written(tmp_path, text)) == pytest.approx({"r_1": -2.0, "r_2": -1.0})


def test_a_speed_that_is_approached() -> None:
    """m g = c v²."""
    found = answers(problem_of(PROBLEMS / "motion/parachutist.yaml"))
    assert found["v_end"] == pytest.approx(math.sqrt(80 * 9.81 / 0.24), rel=1e-9)


def test_a_place_at_which_it_comes_to_rest(tmp_path: Path) -> None:
    text = HUNG.format(**SIZES) + "states: {1: [t = 0, s = l_0, at rest], end: [t = infinity]}\nfind: {s: s @ end}\n"
    found = simulate(written(tmp_path, text), Settings(), {}).answers[0]
    assert found.values[0] == pytest.approx(0.3 + 2 * 9.81 / 400, rel=1e-8)
    assert found.error is not None
    assert found.error < 1e-7


@pytest.mark.parametrize("law", ["swinging", "coasting"])
def test_what_does_not_settle_is_not_reached(law: str, tmp_path: Path) -> None:
    """An oscillation without damping; a boat whose speed falls with the time, but only as 1/t."""
    if law == "swinging":
        text = HUNG.format(**SIZES | {"c": "0 N*s/m"}) + "states: {1: [t = 0, s = l_0, at rest], end: [t = infinity]}\n"
        text += "find: {s: s @ end}\n"
    else:
        text = """\
title: A boat
plane: horizontal
bodies: {boat: {particle: [0, 0], mass: 100 kg}}
loads:
  - drag: {body: boat, magnitude: (8 kg/m)*v(boat).mag^2}
states: {1: [t = 0, v(boat).x = 3 m/s, v(boat).y = 0], end: [t = infinity]}
find: {x: x(boat) @ end}
"""
    found = run(tmp_path, text, Settings(estimate=False, tolerance=1e-6))
    assert "has not settled" in found.run.trajectory.outcome.words
    assert found.answers[0].why


@pytest.mark.parametrize(
    ("states", "t", "v"),
    [
        ("end: [t = infinity], near: [dot(x) = 0.95*dot(x) @ end]", math.log(20), 1.9),
        ("near: [dot(x) = 0.95*dot(x) @ end], end: [t = infinity]", math.log(20), 1.9),
        ("end: [t = infinity], 2: [dot(x) = 1 m/s], near: [dot(x) = 0.95*dot(x) @ end]", math.log(20), 1.9),
        ("near: [dot(x) = dot(x) @ end / 2], end: [t = 1 s]", -math.log(0.5 + 0.5 / math.e), 1 - 1 / math.e),
    ],
)
def test_a_part_of_what_is_reached_later(states: str, t: float, v: float, tmp_path: Path) -> None:
    """v = 2 (1 - e^-t)."""
    found = run(
        tmp_path,
        f"""
title: Particle that is braked the more the faster it is
coordinates: {{x: m}}
bodies: {{p: {{particle: [x, 0]}}}}
motion: ["ddot(x) = 2 m/s^2 - 1 1/s * dot(x)"]
states: {{start: [t = 0, x = 0, dot(x) = 0], {states}}}
find: {{t: t @ near, v: dot(x) @ near}}
""",
    )
    assert [a.values[0] for a in found.answers] == pytest.approx([t, v])


def test_a_part_of_the_limit_that_is_never_reached(tmp_path: Path) -> None:
    """The limit is, all the same."""
    text = (
        HUNG.format(**SIZES)
        + """\
states: {start: [t = 0, s = 0, at rest], end: [t = infinity], far: [s = 3*s @ end]}
find: {s: s @ end, there: reached(far)}
"""
    )
    found = {a.name: a for a in run(tmp_path, text).answers}
    assert found["s"].values == pytest.approx([0.3 + 2 * 9.81 / 400])
    assert found["there"].word == "false"
