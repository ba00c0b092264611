"""Impacts with rods and plates of finite size: what goes past their ends does not strike them, from whichever side."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from planar_cli.problem.structure import load
from planar_cli.simulate.run import Settings, Simulation, simulate

PROBLEMS = Path(__file__).parent.parent / "problems"
ROD = "rod: [A, B], mass: 2 kg"
PLATE = "plate: G, width: 1.2 m, height: 1e-6 m, angle: 0 deg, mass: 2 kg"
PUCK = "particle: P, mass: 0.5 kg"
DISK = "disk: P, radius: 0.05 m, mass: 0.5 kg, inertia: 1e-3 kg*m^2"
SCENE = """\
title: A puck and a turning body on smooth ice
plane: horizontal
points: {{A: [-0.6 m, 0], B: [0.6 m, 0], G: [0, 0], P: [{x}, {y}]}}
bodies:
  body: {{{body}}}
  puck: {{{puck}}}
joints:
  - impact: {{between: [puck, body], restitution: 0.6, name: hit}}
states:
  1: [v(body).x = 0, v(body).y = 0, omega(body) = {turn}, v(puck).x = {u}, v(puck).y = {v}{spin}]
  2: [t = 8 s]
"""


def followed(folder: Path, settings: Settings, **words: str) -> Simulation:
    path = folder / "scene.yaml"
    words["spin"] = ", omega(puck) = 0" if words["puck"] == DISK else ""
    path.write_text(SCENE.format(**words), encoding="utf-8")
    problem, wrong, _ = load(str(path))
    assert problem is not None, wrong
    return simulate(problem, settings, {})


def impacts(found: Simulation) -> list[tuple[float, float]]:
    assert not found.run.trajectory.outcome.refused, found.run.trajectory.outcome.words
    return [(x.t, x.lost) for x in found.run.trajectory.transitions if x.kind == "impact"]


@pytest.mark.parametrize("puck", [PUCK, DISK])
@pytest.mark.parametrize(
    ("x", "y", "u", "v", "turn"),
    [
        ("-1 m", "0.5 m", "0.3 m/s", "-0.1 m/s", "2 rad/s"),
        ("-1 m", "0.5 m", "0.3 m/s", "-0.1 m/s", "-2 rad/s"),
        ("0.9 m", "0.4 m", "-0.2 m/s", "-0.5 m/s", "-1 rad/s"),
        ("0.9 m", "0.4 m", "-0.2 m/s", "-0.5 m/s", "0.3 rad/s"),
        ("0.7 m", "-0.9 m", "-0.1 m/s", "0.4 m/s", "1 rad/s"),
        ("0.66 m", "-0.25 m", "-0.46 m/s", "0.11 m/s", "-2.43 rad/s"),
        ("-0.91 m", "0.1 m", "0.49 m/s", "0.02 m/s", "-0.9 rad/s"),
    ],
)
def test_a_rod_is_a_very_thin_plate(puck: str, x: str, y: str, u: str, v: str, turn: str, tmp_path: Path) -> None:
    """Their outlines are made otherwise: one long side met from both, or four edges each met from outside."""
    words = {"puck": puck, "x": x, "y": y, "u": u, "v": v, "turn": turn}
    of_rod = impacts(followed(tmp_path, Settings(estimate=False), body=ROD, **words))
    of_plate = impacts(followed(tmp_path, Settings(estimate=False), body=PLATE, **words))
    assert len(of_rod) == len(of_plate)
    for one, other in zip(of_rod, of_plate, strict=True):
        assert one == pytest.approx(other, rel=2e-5, abs=1e-9)


def test_it_is_struck_from_behind(tmp_path: Path) -> None:
    """In the last of these scenes the rod meets the puck with the side that was turned away from it at first."""
    words = {"puck": PUCK, "x": "-0.91 m", "y": "0.1 m", "u": "0.49 m/s", "v": "0.02 m/s", "turn": "-0.9 rad/s"}
    found = followed(tmp_path, Settings(estimate=False), body=ROD, **words)
    first, _ = impacts(found)
    x, y, theta, u, v, *_ = found.run.trajectory.at(first[0] - 1e-3)
    assert (v - y) * math.cos(theta) < (u - x) * math.sin(theta)


def test_a_puck_meets_the_side_of_a_plate(tmp_path: Path) -> None:
    """J = (1 + e) v / (1/m + 1/M + b²/I): the far edges and those beside it have no part in it."""
    plate = "plate: G, width: 0.4 m, height: 0.6 m, angle: 0 deg, mass: 2 kg"
    words = {"puck": PUCK, "x": "-1 m", "y": "0.1 m", "u": "8 m/s", "v": "0 m/s", "turn": "0 rad/s"}
    found = followed(tmp_path, Settings(estimate=False), body=plate, **words)
    (hit,) = impacts(found)
    inertia = 2 / 12 * (0.4**2 + 0.6**2)
    impulse = 1.6 * 8 / (1 / 0.5 + 1 / 2 + 0.1**2 / inertia)
    assert hit[0] == pytest.approx(0.1, rel=1e-9)
    end = found.run.trajectory.at(8.0)
    assert end[5:] == pytest.approx([impulse / 2, 0, -0.1 * impulse / inertia, 8 - impulse / 0.5, 0], abs=1e-9)


def test_a_puck_that_leaves_a_rod_does_not_meet_its_line() -> None:
    """It struck the line on which the rod lies, metres beyond its ends, until nothing was consistent any more."""
    problem, _, _ = load(str(PROBLEMS / "impact/puck-hits-a-free-rod.yaml"))
    assert problem is not None
    found = simulate(problem, Settings(until=100.0, estimate=False), {})
    assert [t for t, _ in impacts(found)] == [0.0]
    assert found.answers[2].values == pytest.approx([-6.330561], rel=1e-6)
    assert not math.isnan(found.run.trajectory.t1)
