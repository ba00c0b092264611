"""Scenes as other packages are told them. Whether these are installed is left open: the scene is checked, not them."""

from __future__ import annotations

import math
from xml.etree import ElementTree

import pytest
from answered import BARS_IN_A_LOOP

from planar_cli.errors import PlanarError
from planar_cli.problem.structure import load_text
from planar_cli.simulate.mechanism import Mechanism
from planar_cli.simulate.peers import PEERS, largest_of
from planar_cli.simulate.run import Run, Settings, follow

PLACES = {"A": "[0, 0]", "B": "[0, 1 m]", "C": "[2 m, 1 m]", "D": "[2 m, 0]"}
FOUR_BAR = f"""{BARS_IN_A_LOOP.format(**PLACES, mass="2 kg")}\
states:
  1: [t = 0, omega(AB) = -1 rad/s]
  2: [t = 0.5 s]
"""


def followed(text: str) -> Run:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    return follow(problem, Settings(tolerance=1e-11))


def test_a_mechanism_of_bodies_and_pins() -> None:
    found = Mechanism.of(followed(FOUR_BAR))
    assert [b.mass for b in found.bodies] == pytest.approx([1.0, 2.0, 1.0])
    assert [b.inertia for b in found.bodies] == pytest.approx([1 / 12, 2 / 3, 1 / 12])
    assert found.gravity == pytest.approx(9.81)
    assert len(found.pins) == 4
    upper = found.bodies[1]
    assert (upper.x, upper.y, upper.vx, upper.vy, upper.omega) == pytest.approx((1.0, 1.0, 1.0, 0.0, 0.0), abs=1e-12)
    for pin in found.pins:
        assert math.hypot(*pin.on_b) in (pytest.approx(0.5), pytest.approx(1.0))


def test_the_tree_of_a_loop_has_one_connection_left_over() -> None:
    root = ElementTree.fromstring(Mechanism.of(followed(FOUR_BAR)).as_mjcf(0.01))
    assert len(list(root.iter("body"))) == 3
    assert len(list(root.iter("connect"))) == 1
    assert len([j for j in root.iter("joint") if j.get("type") == "hinge"]) == 3


def test_what_can_not_be_told_is_refused() -> None:
    pushed = FOUR_BAR.replace("states:", "loads:\n  - torque: {body: AB, moment: 1 N*m}\nstates:")
    point = FOUR_BAR.replace("{rod: [C, D], mass: 1 kg}", "{particle: C, mass: 1 kg}")
    point = point.replace("  - pin: {at: D, between: [CD, ground]}\n", "").replace("omega(AB) = -1 rad/s", "at rest")
    for text in (pushed, point):
        with pytest.raises(PlanarError, match="can be expressed"):
            Mechanism.of(followed(text))


@pytest.mark.parametrize("peer", [p for p in PEERS if p().available()], ids=lambda p: p.name)
def test_installed_packages_agree(peer: type) -> None:
    run = followed(FOUR_BAR)
    end = [a / s for a, s in zip(run.trajectory.at(run.trajectory.t1), run.model.scale, strict=True)]
    finest = min(peer.tolerances) if peer.tolerances else min(peer.steps) * run.model.time_scale
    assert largest_of(peer().follow(run, finest).end, end, run.model.scale) < 1e-3
