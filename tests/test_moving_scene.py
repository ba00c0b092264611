"""The scene at a moving configuration: residuals vanish as drawn, their slopes are right, loads fit potentials."""

from __future__ import annotations

import math
import random
import re
from pathlib import Path
from string import Template

import pytest
import yaml
from conftest import ROOT

from planar_cli.errors import NOWHERE, FileProblem
from planar_cli.joints.base import Joint
from planar_cli.motion.scene.quantities import Quantities
from planar_cli.motion.scene.scene import MovingScene
from planar_cli.motion.terms.terms import Term, evaluate
from planar_cli.problem.language.parser import parse_side
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.structure import load, load_text

FILES = sorted((ROOT / "problems").rglob("*.yaml"))
NO_NUMBER = {"PL504", "PL704", "PL705"}
"""Refusals of files whose letters or unknowns have no number, or have it in their cases alone."""


def only_numbers_missing(error: FileProblem) -> None:
    """A refusal of anything else is an error of ours."""
    if {d.code for d in error.diagnostics} - NO_NUMBER:
        raise error


def scene_of(path: Path) -> MovingScene | None:
    """The scene of a file; None where letters or unknowns have no numbers."""
    problem, wrong, _ = load(str(path))
    assert problem is not None, wrong
    try:
        return MovingScene(problem)
    except FileProblem as error:
        only_numbers_missing(error)
        return None


def residuals(scene: MovingScene) -> list[tuple[str, Term]]:
    """All residuals of all modes of all joints, and of points written with coordinates."""
    found = [(tie.title, tie.residual) for tie in scene.ties]
    for joint in scene.problem.joints:
        try:
            modes = joint.modes(scene)
        except FileProblem as error:
            only_numbers_missing(error)
            continue
        for mode in modes:
            for residual in joint.residuals(scene, mode):
                off = residual.of(scene.poses)
                parts = (off.x, off.y) if isinstance(off, Vec) else (off,)
                found += [(residual.title, scene.graph.of(part)) for part in parts]
    return found


@pytest.mark.parametrize("folder", sorted({p.parent for p in FILES}), ids=lambda p: p.name)
def test_residuals_vanish_as_drawn_and_have_right_slopes(folder: Path) -> None:
    rng = random.Random(7)
    for path in (p for p in FILES if p.parent == folder):
        scene = scene_of(path)
        if scene is None:
            continue
        size = scene.extent
        spans = {q: 1.0 if q.size == 1.0 else size for q in scene.rates() if q is not scene.time}
        for title, term in residuals(scene):
            assert abs(term.value) <= 1e-9 * max(size, 1e-3), (path.name, title)
            at = {q: q.value + 0.02 * span * rng.uniform(-1, 1) for q, span in spans.items()}
            way = {q: span * rng.uniform(-1, 1) for q, span in spans.items()}
            step = 1e-5
            ends = [evaluate([term], {q: at[q] + s * step * way[q] for q in at})[0] for s in (-1, 1)]
            slopes = scene.graph.gradient(term)
            told = sum(evaluate([slopes[q]], at)[0] * way[q] for q in way if q in slopes)
            slope = (ends[1] - ends[0]) / (2 * step)
            assert slope == pytest.approx(told, rel=1e-5, abs=1e-5 * size), (path.name, title)


SCENE = """
title: two rods and a disk
plane: vertical
points: {O: [0, 0], A: [0.4 m, 0.3 m], B: [1.1 m, 0.2 m], C: [1.3 m, -0.5 m], E: [1.4 m, -0.35 m], S: [0.2 m, 0.9 m]}
bodies:
  OA: {rod: [O, A], mass: 2 kg}
  AB: {rod: [A, B], mass: 3 kg}
  wheel: {disk: C, radius: 0.2 m, mass: 1.5 kg, points: [E]}
loads:
  - spring: {between: [S, B], stiffness: 300 N/m, natural_length: 0.3 m}
instant: [at rest]
find: {v: v(B).x}
"""
WORDS = (
    "r(B).x", "r(E/B).y", "r(E).angle", "v(B).x", "v(E).y", "v(E/A).x", "v(B).mag", "theta(AB)", "theta(AB/OA)",
    "omega(wheel)", "r(E).across(B/A)", "v(E).along(AB)", "KE(all)", "PE(all)", "momentum(AB).x", "H(AB/C)", "H(wheel)",
    "v(E/AB).x", "r(E/C).along(wheel)",
)  # fmt: skip


def of(scene: MovingScene, text: str, accelerations: dict[Term, Term]) -> Term:
    """A quantity of the scene."""
    return Quantities(scene, scene.stored_energy, accelerations).sides.value(parse_side(text, NOWHERE))


def moved(scene: MovingScene, time: float) -> dict[Term, float]:
    """A motion of all bodies: places at a time, with their rates and accelerations."""
    found: dict[Term, float] = {}
    for n, (q, v) in enumerate(p for place in scene.places.values() for p in place.variables):
        a, b = 0.7 + 0.3 * n, 0.9 - 0.17 * n
        found |= {q: q.value + a * time + b * time**2, v: a + 2 * b * time}
    return found


@pytest.mark.parametrize("text", WORDS)
def test_rates_of_quantities_are_those_of_the_motion(text: str) -> None:
    problem, wrong = load_text(SCENE)
    assert problem is not None, wrong
    scene = MovingScene(problem)
    pairs = [p for place in scene.places.values() for p in place.variables]
    graph = scene.graph
    second = {v: graph.number(2 * (0.9 - 0.17 * n)) for n, (_, v) in enumerate(pairs)}
    value, rate = of(scene, text, second), of(scene, f"dot({text})", second)
    step = 1e-5
    ends = [evaluate([value], moved(scene, 0.1 + s * step))[0] for s in (-1, 1)]
    assert evaluate([rate], moved(scene, 0.1))[0] == pytest.approx((ends[1] - ends[0]) / (2 * step), rel=1e-6, abs=1e-7)


@pytest.mark.parametrize(
    ("word", "of_it"), [("v(B).x", "r(B).x"), ("omega(AB)", "theta(AB)"), ("alpha(AB)", "omega(AB)")]
)
def test_words_of_motion_are_rates_of_each_other(word: str, of_it: str) -> None:
    problem, _ = load_text(SCENE)
    assert problem is not None
    scene = MovingScene(problem)
    step = 1e-5
    pairs = [p for place in scene.places.values() for p in place.variables]
    second = {v: scene.graph.number(2 * (0.9 - 0.17 * n)) for n, (_, v) in enumerate(pairs)}
    value, rate = of(scene, of_it, second), of(scene, word, second)
    ends = [evaluate([value], moved(scene, 0.1 + s * step))[0] for s in (-1, 1)]
    assert evaluate([rate], moved(scene, 0.1))[0] == pytest.approx((ends[1] - ends[0]) / (2 * step), rel=1e-6)


def test_motion_seen_from_a_body_is_that_of_its_own_axes() -> None:
    problem, _ = load_text(SCENE)
    assert problem is not None
    scene = MovingScene(problem)
    pairs = [p for place in scene.places.values() for p in place.variables]
    second = {v: scene.graph.number(2 * (0.9 - 0.17 * n)) for n, (_, v) in enumerate(pairs)}
    reach = ["r(E/OA).along(OA)", "r(E/OA).across(OA)"]
    step = 1e-4
    for part, axis in zip(reach, ("along", "across"), strict=True):
        place = of(scene, part, second)
        before, now, after = (evaluate([place], moved(scene, 0.1 + s * step))[0] for s in (-1, 0, 1))
        v, a = (evaluate([of(scene, f"{w}(E/OA).{axis}(OA)", second)], moved(scene, 0.1))[0] for w in "va")
        assert v == pytest.approx((after - before) / (2 * step), rel=1e-6)
        assert a == pytest.approx((after - 2 * now + before) / step**2, rel=1e-4)


def begins_later(joint: Joint, problem: Problem) -> bool:
    """Does a joint act only from a later state than the first on?"""
    return joint.during is not None and joint.during[0] != problem.states[0].name


def test_contacts_touch_as_drawn() -> None:
    counted = 0
    for path in FILES:
        scene = scene_of(path)
        for joint in scene.problem.joints if scene is not None else ():
            if scene is None or not joint.unilateral or begins_later(joint, scene.problem):
                # What acts only later need not touch yet.
                continue
            gaps = [g for g in scene.gaps(joint) if all(w.value >= -1e-9 * scene.extent for w in g.within)]
            assert gaps, path.name
            assert min(g.distance.value for g in gaps) == pytest.approx(0, abs=1e-9 * scene.extent), path.name
            counted += 1
    assert counted > 30


BOX = """
title: a turned box over a floor and beside a wheel
plane: vertical
points: {F: [0, 0], G: [0, 2 m], W: [1.5 m, 1.2 m]}
surfaces: {floor: {through: F, angle: 10 deg}}
bodies:
  box: {plate: G, width: 0.8 m, height: 0.4 m, angle: 25 deg, mass: 2 kg}
  wheel: {disk: W, radius: 0.3 m, mass: 1 kg}
joints:
  - impact: {between: [box, floor], restitution: 0.5, name: b}
  - impact: {between: [wheel, floor], restitution: 0.5, name: w}
  - impact: {between: [box, wheel], restitution: 0.5, name: bw}
states:
  1: [at rest]
  2: [just after 1]
find: {v: v(G).x @ 2}
"""


def test_gaps_are_distances_wherever_the_bodies_are() -> None:
    problem, wrong = load_text(BOX)
    assert problem is not None, wrong
    scene = MovingScene(problem)
    at = moved(scene, 0.3)
    x, y, theta = (at[q] for q, _ in scene.places["box"].variables)
    corners = [
        (x + i * math.cos(theta) - j * math.sin(theta), y + i * math.sin(theta) + j * math.cos(theta))
        for i in (-0.4, 0.4)
        for j in (-0.2, 0.2)
    ]
    tilt = math.radians(10)
    floor = sorted(q * math.cos(tilt) - p * math.sin(tilt) for p, q in corners)
    box, wheel, both = problem.joints
    assert sorted(evaluate([g.distance for g in scene.gaps(box)], at)) == pytest.approx(floor)
    wx, wy, _ = (at[q] for q, _ in scene.places["wheel"].variables)
    assert evaluate([g.distance for g in scene.gaps(wheel)], at) == pytest.approx(
        [wy * math.cos(tilt) - wx * math.sin(tilt) - 0.3]
    )
    near = [g for g in scene.gaps(both) if all(w >= 0 for w in evaluate(g.within, at))]
    local = (
        (wx - x) * math.cos(theta) + (wy - y) * math.sin(theta),
        (wy - y) * math.cos(theta) - (wx - x) * math.sin(theta),
    )
    outside = math.hypot(max(abs(local[0]) - 0.4, 0), max(abs(local[1]) - 0.2, 0)) - 0.3
    assert any(d == pytest.approx(outside) for d in evaluate([g.distance for g in near], at))


CURVES = """
title: beads and a wheel on curves
plane: vertical
points: {B: [1 m, 0.5 m], S: [0, 2.5 m], C: [0, 0], G: [0, 0.2 m], O: [0, 0], K: [0, 1 m], P: [0, 2 m]}
surfaces:
  hill: {y: x^2/(2 m)}
  spiral: {r: 1 m + (2/pi) m * theta, body: cam}
bodies:
  bead: {particle: B, mass: 1 kg}
  wheel: {disk: G, radius: 0.2 m, mass: 1 kg}
  cam: {points: [O, K]}
  point: {particle: P, mass: 1 kg}
joints:
  - guide: {point: B, along: hill, name: slot}
  - contact: {between: [wheel, hill], at: C, mu: 0.3}
  - guide: {point: P, along: spiral, name: track}
  - pin: {at: O, between: [ground, cam]}
instant: [at rest]
find: {v: v(B).x}
"""


def test_curves_are_followed_far_from_where_they_are_drawn() -> None:
    problem, wrong = load_text(CURVES)
    assert problem is not None, wrong
    scene = MovingScene(problem)
    slot, contact, track, _ = problem.joints

    def off(joint: Joint, at: dict[Term, float]) -> float:
        mode = next(m for m in joint.modes(scene) if m.name == "slip")
        residual = joint.residuals(scene, mode)[0].of(scene.poses)
        return evaluate([residual], at)[0]

    bead, tip, cam, wheel = (scene.places[name] for name in ("bead", "point", "cam", "wheel"))
    assert off(slot, {bead.x: -3.0, bead.y: 4.5}) == pytest.approx(0, abs=1e-12)
    assert off(slot, {bead.x: -3.0, bead.y: 4.6}) == pytest.approx(0.1)
    # The cam has turned by 30 deg; the tip is at 150 deg from its axis, 120 deg in the plane.
    r, turn = 1 + 2 / math.pi * math.radians(150), math.radians(120)
    assert cam.theta is not None
    at = {cam.theta: cam.theta.value - math.radians(30), tip.x: r * math.cos(turn), tip.y: r * math.sin(turn)}
    assert off(track, at) == pytest.approx(0, abs=1e-12)
    # The wheel's centre is 0.2 m from the hill where its foot is at x = 1 m, and the foot is below it.
    (foot, _), (tie,) = scene.own_variables["foot of wheel on hill"], scene.ties
    far = {foot: 1.0, wheel.x: 1 - 0.2 / math.sqrt(2), wheel.y: 0.5 + 0.2 / math.sqrt(2)}
    assert off(contact, far) == pytest.approx(0, abs=1e-12)
    assert evaluate([tie.residual, scene.gaps(contact)[0].distance], far) == pytest.approx([0, 0], abs=1e-12)
    assert evaluate([scene.point("C").x, scene.point("C").y], far) == pytest.approx([1, 0.5])


TEMPLATES: dict[str, str] = yaml.safe_load((Path(__file__).parent / "joint_scenes.yaml").read_text())


def drawn(name: str, power: int) -> MovingScene:
    """The scene of one template with all lengths times a power of ten."""
    rng = random.Random(name)
    numbers = {k: f"{rng.uniform(0.4, 1.6):.3f}" for k in "xyzr"}
    numbers |= {"a": f"{rng.uniform(100, 170):.1f}", "b": f"{rng.uniform(60, 85):.1f}"}
    text = Template(TEMPLATES[name]).substitute(numbers)
    body = text.split("bodies: {")[1].split(":")[0]
    text = re.sub(r"(\d+(?:\.\d+)?) m\b", rf"\1e{power} m", text)
    text += f"plane: horizontal\ninstant: [at rest]\nfind: {{x: x({body})}}\n"
    problem, wrong = load_text(f"title: drawn at random\n{text}")
    assert problem is not None, [d.message for d in wrong]
    return MovingScene(problem)


def decided(scene: MovingScene) -> list[object]:
    """What was decided of a scene: modes, who pushes whom in which direction, how many residuals."""
    found: list[object] = []
    for joint in scene.problem.joints:
        for mode in joint.modes(scene):
            found.append((joint.name, mode.name, mode.direction, len(joint.residuals(scene, mode))))
            for push in mode.facts.pushes:
                for action in push.actions:
                    force = action.force or Vec(0, 0)
                    found.append((push.name, action.body, scene.sign(force.x), scene.sign(force.y)))
    return found


@pytest.mark.parametrize("name", TEMPLATES)
def test_decisions_know_no_unit_of_length(name: str) -> None:
    usual = drawn(name, 0)
    for power in (-6, 6):
        scaled = drawn(name, power)
        assert decided(scaled) == decided(usual)
        size = scaled.extent
        for title, term in residuals(scaled):
            assert abs(term.value) <= 1e-12 * max(size, 1.0 if "angle" in title or "arc" in title else 0), title


def test_a_wheel_rolls_along_the_arc_of_a_curve() -> None:
    problem, _ = load_text(CURVES)
    assert problem is not None
    scene = MovingScene(problem)
    contact, wheel = problem.joints[1], scene.places["wheel"]
    stick = next(m for m in contact.modes(scene) if m.name == "stick")
    slip = contact.residuals(scene, stick)[1].of(scene.poses)
    foot, _ = scene.own_variables["foot of wheel on hill"]
    # y = x²/(2 m) to x = 1 m: the arc is (√2 + asinh 1)/2 m; the tangent turns by 45 deg there.
    arc = (math.sqrt(2) + math.asinh(1)) / 2
    assert wheel.theta is not None
    turned = {foot: 1.0, wheel.theta: math.pi / 4 - arc / 0.2}
    assert evaluate([slip], turned)[0] == pytest.approx(0, abs=1e-12)
    slope = scene.graph.gradient(slip)[foot]
    # Per dx at x = 1 m: the arc grows by √2, the tangent turns by 1/(1 + x²).
    assert evaluate([slope], turned)[0] == pytest.approx(math.sqrt(2) - 0.2 / 2)


TURNING_TRACK = """
title: a bead on a line that turns with a coordinate
plane: horizontal
coordinates: {beta: deg}
points: {P: [1 m, 0], O: [0, 0], B: {from: O, distance: 1 m, angle: beta}}
bodies: {bead: {particle: P, mass: 1 kg}, arm: {rod: [O, B], mass: 1 kg}}
joints:
  - pin: {at: O, between: [ground, arm]}
  - guide: {point: P, along: beta}
instant: [beta = 0 deg, omega(arm) = 1 rad/s]
find: {v: v(P).x}
"""


def test_a_track_that_nobody_carries_is_refused_when_it_turns() -> None:
    problem, wrong = load_text(TURNING_TRACK)
    assert problem is not None, wrong
    scene = MovingScene(problem)
    with pytest.raises(FileProblem) as refused:
        problem.joints[1].modes(scene)
    assert [d.code for d in refused.value.diagnostics] == ["PL707"]
