"""Motions of whole scenes from their files' text: modes, impacts, ropes and sticking, with numbers known beforehand."""

from __future__ import annotations

import math
from collections.abc import Mapping

import pytest

from planar_cli.integrators.base import Setting
from planar_cli.motion.follow.follow import Follower
from planar_cli.motion.follow.stages import SceneStages
from planar_cli.motion.scene.scene import MovingScene
from planar_cli.motion.trajectory.automaton import Start
from planar_cli.motion.trajectory.schedule import Crossing, Event, Schedule
from planar_cli.motion.trajectory.trajectory import Trajectory
from planar_cli.problem.structure import load_text

GRAVITY = 9.81


def follow(
    text: str,
    rates: Mapping[str, float],
    until: float,
    places: Mapping[str, float] | None = None,
    tolerance: float = 1e-9,
    momenta: bool = False,
) -> Trajectory:
    """`rates`, `places`: by body and coordinate, `block.x`; what is not given is as drawn, or at rest."""
    problem, wrong = load_text("plane: vertical\ntitle: a motion\n" + text)
    assert problem is not None
    assert not wrong
    stages = SceneStages(MovingScene(problem))
    automaton = stages.automaton(())
    t, y = automaton.model.reference
    names = [f"{s.body}.{s.kind}" for s in automaton.model.layout.slots]
    for name, rate in rates.items():
        y[len(names) + names.index(name)] = rate
    for name, place in (places or {}).items():
        y[names.index(name)] = place
    setting = Setting(automaton.scale, tolerance)
    return Follower(stages, Start(t, tuple(y)), Schedule(), until, setting, momenta=momenta).trajectory()


def kinds(found: Trajectory) -> list[str]:
    return [x.kind for x in found.transitions]


SLOPE = """
points: {O: [0, 0], P: [0, 0]}
surfaces: {slope: {through: O, angle: 30 deg}}
bodies: {block: {particle: P, mass: 2 kg}}
joints:
  - contact: {between: [block, slope], at: P, mu_s: %s, mu_k: %s}
"""


def test_a_block_sticks_where_it_comes_to_rest() -> None:
    c, s = math.cos(math.pi / 6), math.sin(math.pi / 6)
    found = follow(SLOPE % (0.7, 0.6), {"block.x": 3 * c, "block.y": 3 * s}, 3.0)
    stop = 3.0 / (GRAVITY * (s + 0.6 * c))
    assert found.outcome.kind == "rest"
    assert found.outcome.t == pytest.approx(stop, rel=1e-11)
    assert math.hypot(*found.at(3.0)[:2]) == pytest.approx(1.5 * stop, rel=1e-11)


def test_a_block_slides_back_where_friction_is_too_little() -> None:
    c, s = math.cos(math.pi / 6), math.sin(math.pi / 6)
    found = follow(SLOPE % (0.4, 0.3), {"block.x": 3 * c, "block.y": 3 * s}, 3.0)
    stop = 3.0 / (GRAVITY * (s + 0.3 * c))
    assert found.at(3.0)[2] == pytest.approx(-GRAVITY * (s - 0.3 * c) * (3.0 - stop) * c, rel=1e-10)


def test_stick_and_slip_on_a_belt() -> None:
    text = """
points: {O: [0, 0], W: [-1 m, 0]}
surfaces: {belt: {through: O, angle: 0 deg, speed: 0.1 m/s}}
bodies: {block: {particle: O, mass: 1 kg}}
joints:
  - contact: {between: [block, belt], at: O, mu_s: 0.4, mu_k: 0.3}
loads:
  - spring: {between: [W, O], stiffness: 100 N/m, natural_length: 1 m}
"""
    found = follow(text, {"block.x": 0.1}, 2.0, tolerance=1e-11)
    slip, stick, again = (x.t for x in found.transitions[:3])
    assert (stick - slip, again - slip) == pytest.approx((0.47315706234, 0.66935706234), rel=1e-9)
    assert found.transitions[1].after[0] == pytest.approx(0.01962, rel=1e-8)


def test_a_disk_thrown_along_the_floor_begins_to_roll() -> None:
    text = """
points: {C: [0, 0], G: [0, 0.5 m]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {disk: {disk: G, radius: 0.5 m, mass: 2 kg}}
joints:
  - contact: {between: [disk, floor], at: C, mu: 0.2}
"""
    found = follow(text, {"disk.x": 3.0}, 3.0)
    assert found.transitions[-1].t == pytest.approx(3.0 / (3 * 0.2 * GRAVITY), rel=1e-11)
    assert found.at(3.0)[3:] == pytest.approx([2.0, 0.0, -4.0], abs=1e-9)


def test_a_rope_slackens_and_jerks_taut() -> None:
    text = """
points: {O: [0, 0], P: [0, -1 m]}
bodies: {ball: {particle: P, mass: 2 kg}}
joints:
  - rope: {path: [O, P], name: cord}
"""
    found = follow(text, {"ball.x": math.sqrt(3 * GRAVITY)}, 1.5)
    assert kinds(found) == ["mode", "impact", "mode"]
    assert found.transitions[0].before[1] == pytest.approx(1 / 3, rel=1e-8)
    jerk = found.transitions[1]
    x, y, vx, vy = jerk.before
    along = x * vx + y * vy
    assert jerk.impulses["cord"][0] == pytest.approx(2 * along, rel=1e-9)
    assert jerk.lost == pytest.approx(along**2, rel=1e-9)


def test_a_particle_leaves_a_dome() -> None:
    text = """
points: {O: [0, 0], P: [0, 1 m]}
surfaces: {dome: {center: O, radius: 1 m}}
bodies: {ball: {particle: P, mass: 2 kg}}
joints:
  - contact: {between: [ball, dome], at: P, mu: 0}
"""
    found = follow(text, {"ball.x": 0.3}, 1.0)
    assert found.transitions[-1].before[1] == pytest.approx((2 + 0.09 / GRAVITY) / 3, rel=1e-8)


BLOCK = """
points: {G: [0, 0.5 m], A: [0, 0]}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies: {block: {plate: G, width: 0.2 m, height: 1 m, mass: 10 kg}}
joints:
  - contact: {between: [block, floor], at: A, mu: 2}
"""


def test_a_block_rocks_and_loses_speed_at_every_impact() -> None:
    """Housner: ω⁺/ω⁻ = 1 - 1.5 sin²α = 49/52; from α/2 at rest a quarter takes 0.34709358679 s."""
    alpha = math.atan(0.2)
    # Turned by α/2 about its right corner, clockwise.
    turn, reach = -alpha / 2, math.hypot(0.1, 0.5)
    direction = math.pi / 2 + alpha + turn
    places = {
        "block.x": 0.1 + reach * math.cos(direction),
        "block.y": reach * math.sin(direction),
        "block.theta": turn,
    }
    found = follow(BLOCK, {}, 0.5, places)
    impact = next(x for x in found.transitions if x.kind == "impact")
    assert impact.t == pytest.approx(0.34709358679, rel=1e-8)
    assert impact.before[5] == pytest.approx(0.64804901, rel=1e-7)
    assert impact.after[5] / impact.before[5] == pytest.approx(49 / 52, rel=1e-8)


def test_a_rod_that_jams_is_refused_by_name() -> None:
    text = """
points: {A: [0, 0], B: [1 m, 1.7320508075688772 m]}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies: {rod: {rod: [A, B], mass: 1 kg}}
joints:
  - contact: {between: [rod, floor], at: A, mu: 1.5}
"""
    found = follow(text, {"rod.x": -2.0}, 1.0)
    assert (found.outcome.kind, found.outcome.joint, found.outcome.code) == ("none", "A", "PL700")
    omega = 4.0
    several = follow(text, {"rod.x": -2.0 - omega * math.sqrt(0.75), "rod.y": omega / 2, "rod.theta": omega}, 1.0)
    assert (several.outcome.kind, several.outcome.code) == ("several", "PL701")


def test_a_pendulum_stays_in_its_unstable_equilibrium() -> None:
    text = """
points: {O: [0, 0], P: [0, 1 m]}
bodies: {ball: {particle: P, mass: 2 kg}}
joints:
  - link: {between: [O, P]}
"""
    found = follow(text, {}, 60.0)
    assert found.at(60.0) == found.at(0.0)
    assert f"{math.sqrt(1 / GRAVITY):.6g} s" in found.notes[0]


def test_a_ball_bounces_to_rest_on_the_floor() -> None:
    text = """
points: {O: [0, 0], P: [0, 1 m]}
surfaces: {floor: {through: O, angle: 0 deg}}
bodies: {ball: {particle: P, mass: 2 kg}}
joints:
  - impact: {between: [ball, floor], restitution: 0.5}
"""
    found = follow(text, {"ball.x": 0.3}, 3.0)
    rest = next(x for x in found.transitions if x.kind == "rest")
    assert rest.t == pytest.approx(1.35457092296, rel=1e-10)
    assert found.at(3.0) == pytest.approx([0.9, 0.0, 0.3, 0.0], abs=1e-10)


BOX = """
points: {O: [0, 0], P: [0, %g m]}
surfaces: {floor: {through: O, angle: 0 deg}}
bodies: {box: {plate: P, width: %g m, height: %g m, angle: 20 deg, mass: %g kg}}
joints:
  - impact: {between: [box, floor], restitution: 0.3, mu: 0.3}
"""


@pytest.mark.parametrize(("size", "mass"), [(1.0, 1.0), (1e-6, 1e-9), (1e6, 1e9), (1e3, 1e-6)])
def test_a_box_falls_on_its_corner_and_comes_to_lie(size: float, mass: float) -> None:
    """In the same way whatever its size and mass, in times that go with the root of the size."""
    time = math.sqrt(size)
    found = follow(BOX % (size, 0.4 * size, 0.3 * size, 2 * mass), {"box.x": 0.3 * time}, 3.0 * time)
    assert found.outcome.kind == "rest"
    end = found.at(3.0 * time)
    assert end[1] / size == pytest.approx(0.15, abs=1e-9)
    assert end[0] / size == pytest.approx(0.387802932, abs=1e-8)
    assert found.outcome.t / time == pytest.approx(0.8813995622, rel=1e-9)
    # Weight does no work in impacts: what was lost is the fall and the speed.
    unit = mass * size
    lost = sum(x.lost for x in found.transitions) / unit
    slid = sum(s.regime.energy(s.t0, s.start) - s.regime.energy(s.t1, s.end) for s in found.segments) / unit
    assert 2 * GRAVITY * 0.85 + 0.09 - lost == pytest.approx(slid, abs=1e-7)


CRADLE = """
points: {A: [-1 m, 0], B: [0.1 m, 0], C: [%s, 0], P: [-1 m, -0.05 m], Q: [0.1 m, -0.05 m], R: [%s, -0.05 m]}
surfaces: {table: {through: P, angle: 0 deg}}
bodies:
  a: {disk: A, radius: 0.05 m, mass: 2 kg}
  b: {disk: B, radius: 0.05 m, mass: 2 kg}
  c: {disk: C, radius: 0.05 m, mass: 2 kg}
joints:
  - contact: {between: [a, table], at: P, mu: 0}
  - contact: {between: [b, table], at: Q, mu: 0}
  - contact: {between: [c, table], at: R, mu: 0}
  - impact: {between: [a, b], restitution: 1}
  - impact: {between: [b, c], restitution: 1}
"""


@pytest.mark.parametrize(
    ("place", "after", "law"), [("0.2 m", (-1 / 3, 2 / 3, 2 / 3), "at once"), ("0.2001 m", (0, 0, 1), "")]
)
def test_balls_in_a_row_strike_at_once_or_one_after_the_other(place: str, after: tuple[float, ...], law: str) -> None:
    found = follow(CRADLE % (place, place), {"a.x": 1.0}, 3.0)
    end = found.at(3.0)
    assert (end[9], end[12], end[15]) == pytest.approx(after, abs=1e-9)
    impact = next(x for x in found.transitions if x.kind == "impact")
    assert law in impact.law
    assert bool(impact.law) == bool(law)


def test_energy_and_momentum_add_up_over_segments_and_impacts() -> None:
    text = """
points: {O: [0, 0], P: [0, 1 m], A: [0.15 m, 1 m], B: [0.65 m, 1.2 m]}
surfaces: {floor: {through: O, angle: 0 deg}}
bodies:
  box: {plate: P, width: 0.4 m, height: 0.3 m, angle: 20 deg, mass: 2 kg, points: [A]}
  rod: {rod: [A, B], mass: 1 kg}
joints:
  - pin: {at: A, between: [box, rod]}
  - impact: {between: [box, floor], restitution: 0.3, mu: 0.3}
  - impact: {between: [rod, floor], restitution: 0.3, mu: 0.3}
loads:
  - drag: {body: rod, magnitude: (0.2 N*s/m) * v(rod).mag}
"""
    found = follow(text, {"box.x": 0.3, "rod.x": 0.3}, 2.0, momenta=True)
    assert not found.outcome.refused
    impacts = [x for x in found.transitions if x.kind == "impact"]
    assert len(impacts) > 5
    assert max(x.unbalanced for x in impacts) < 1e-12
    for segment in found.segments:
        assert segment.balance is not None
        assert len(segment.balance.momentum) == 3
        assert segment.balance.off < 1e-7


@pytest.mark.parametrize(("delta", "kinds_found"), [(1e-6, ["impact"]), (0.0, ["graze"]), (-1e-6, [])])
def test_a_ball_just_reaches_the_ceiling(delta: float, kinds_found: list[str]) -> None:
    """Thrown up at 4.905 m/s below a ceiling at v²/2g - δ: the speed of the impact is √(2 g δ)."""
    text = f"""
points: {{O: [0, {1.22625 - delta:.12g} m], P: [0, 0]}}
surfaces: {{ceiling: {{through: O, angle: 0 deg}}}}
bodies: {{ball: {{particle: P, mass: 2 kg}}}}
joints:
  - impact: {{between: [ball, ceiling], restitution: 0.5}}
"""
    found = follow(text, {"ball.y": 4.905}, 0.9, tolerance=1e-11)
    assert kinds(found) == kinds_found
    if kinds_found == ["impact"]:
        assert found.transitions[0].before[3] == pytest.approx(math.sqrt(2 * GRAVITY * delta), rel=1e-6)
        assert found.transitions[0].after[3] == pytest.approx(-math.sqrt(2 * GRAVITY * delta) / 2, rel=1e-6)


def test_a_block_slides_off_a_turntable_that_speeds_up() -> None:
    """It slips where √(ω⁴ + α²) r = μ g, against the force that held it."""
    problem, wrong = load_text(
        """
title: block on a turntable
plane: horizontal
points: {O: [0, 0], P: [0.5 m, 0]}
bodies: {table: {disk: O, radius: 2 m}, block: {particle: P, mass: 2 kg}}
joints:
  - pin: {at: O, between: [ground, table]}
  - flat: {between: [block, table], mu: 0.3}
motion: [alpha(table) = 1 rad/s^2]
states:
  1: [t = 0, at rest]
"""
    )
    assert problem is not None, wrong
    stages = SceneStages(MovingScene(problem))
    start = stages.start()
    setting = Setting(stages.automaton(("1",)).scale, 1e-9)
    found = Follower(stages, start, Schedule("1"), 10.0, setting).trajectory()
    assert found.outcome.kind == "until"
    slip = next(x for x in found.transitions if x.kind == "mode")
    assert slip.t == pytest.approx(((0.3 * GRAVITY / 0.5) ** 2 - 1) ** 0.25, rel=1e-6)


def test_a_rod_is_caught_in_flight_and_let_go() -> None:
    """A rod falls level, is caught at one end when it has fallen 0.2 m, swings about it, and is let go."""
    problem, wrong = load_text(
        """
title: rod that is caught
plane: vertical
points: {A: [0, 0], B: [1 m, 0]}
bodies: {rod: {rod: [A, B], mass: 2 kg}}
joints:
  - pin: {at: A, between: [ground, rod], during: 2->4}
states:
  1: [t = 0, at rest]
  2: [y(rod) = -0.2 m]
  3: [just after 2]
  4: [theta(rod) = -30 deg]
"""
    )
    assert problem is not None, wrong
    stages = SceneStages(MovingScene(problem))
    model = stages.automaton(("1",)).model
    height = Crossing(lambda regime, choice, t, y: y[1] + 0.2, 1.0)
    turned = Crossing(lambda regime, choice, t, y: y[2] + math.pi / 6, 1.0)
    events = (Event("2", crossing=height), Event("3", after="2"), Event("4", crossing=turned))
    found = Follower(
        stages, stages.start(), Schedule("1", events), 2.0, Setting(model.scale, 1e-10), rest_ends=False
    ).trajectory()
    assert [e.name for e in found.events] == ["2", "3", "4"]
    after, last = found.events[1].y, found.events[2].y
    fall = math.sqrt(2 * GRAVITY * 0.2)
    assert after[5] == pytest.approx(-1.5 * fall, rel=1e-9)
    # Meanwhile the end stays where it was caught.
    assert last[0] - 0.5 * math.cos(last[2]) == pytest.approx(0.0, abs=1e-9)
    assert last[1] - 0.5 * math.sin(last[2]) == pytest.approx(-0.2, abs=1e-9)
    assert last[5] ** 2 == pytest.approx(after[5] ** 2 + 3 * GRAVITY * 0.5, rel=1e-8)


def test_a_block_pushed_over_a_table_seen_from_above_stops() -> None:
    problem, wrong = load_text(
        """
title: block on a table
plane: horizontal
points: {P: [0.5 m, 0]}
bodies: {block: {particle: P, mass: 2 kg}}
joints:
  - flat: {between: [block, ground], mu: 0.3}
states:
  1: [t = 0, v(block).x = 2 m/s, v(block).y = 1 m/s]
"""
    )
    assert problem is not None, wrong
    stages = SceneStages(MovingScene(problem))
    setting = Setting(stages.automaton(("1",)).scale, 1e-9)
    found = Follower(stages, stages.start(), Schedule("1"), 3.0, setting).trajectory()
    assert found.outcome.kind == "rest"
    assert found.outcome.t == pytest.approx(math.sqrt(5) / (0.3 * GRAVITY), rel=1e-9)
