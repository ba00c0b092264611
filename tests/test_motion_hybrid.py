"""What happens between regimes, on scenes whose regimes are written by hand: hard cases with their numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence

import pytest
from automata import GRAVITY, Always, Condition, Law, Scene, modes, touching

from planar_cli.integrators.base import Setting
from planar_cli.motion.follow.follow import Follower
from planar_cli.motion.trajectory.automaton import Choice, Regime, Start
from planar_cli.motion.trajectory.impact import Struck, StruckContact, strike
from planar_cli.motion.trajectory.schedule import Crossing, Event, Schedule
from planar_cli.motion.trajectory.trajectory import Trajectory

APART, TOUCHES = 0, 1


def follow(
    scene: Scene, y: Sequence[float], until: float, schedule: Schedule | None = None, tolerance: float = 1e-10
) -> Trajectory:
    setting = Setting(scene.scale, tolerance)
    start = Start(0.0, tuple(y))
    return Follower(Always(scene), start, schedule or Schedule(), until, setting).trajectory()


def ball(restitution: float, floor: float = 0.0, speed: float = 3.0) -> Scene:
    """A ball above a floor: y = (x, height, vx, vy); it moves along the floor as well."""

    def laws(choice: Choice) -> Law:
        def energy(t: float, y: Sequence[float]) -> float:
            return y[2] ** 2 / 2 + y[3] ** 2 / 2 + GRAVITY * y[1]

        if choice == (APART,):
            gap = Condition("floor", "gap", "the ball is above the floor", lambda t, y: y[1] - floor)
            return Law(lambda t, y: [0.0, -GRAVITY], (gap,), stored=energy)
        presses = Condition("floor", "presses", "the ball presses on the floor", lambda t, y: GRAVITY, scale=GRAVITY)
        return Law(lambda t, y: [0.0, 0.0], (presses,), lambda t, y: [y[0], floor, y[2], 0.0], energy)

    def contacts(choice: Choice, t: float, y: Sequence[float]) -> list[StruckContact]:
        down = StruckContact("floor", (0.0, 1.0), restitution=restitution)
        return [down] if choice == (TOUCHES,) or touching(y[1] - floor) else []

    scale = (1.0, 1.0, speed, speed)
    return Scene({"floor": modes("apart", "slip")}, laws, (1.0, 1.0), scale, contacts, energy_scale=GRAVITY)


@pytest.mark.parametrize(("e", "end"), [(0.5, 1.35457092296), (0.9, 8.57894917873)])
def test_a_bouncing_ball_comes_to_rest_at_the_exact_time(e: float, end: float) -> None:
    found = follow(ball(e), (0.0, 1.0, 2.0, 0.0), end + 1.0)
    rest = next(x for x in found.transitions if x.kind == "rest")
    assert rest.t == pytest.approx(end, rel=1e-10)
    assert rest.count == math.inf
    assert found.at(end + 0.5)[1] == 0.0
    assert found.at(end + 0.5)[0] == pytest.approx(2.0 * (end + 0.5), rel=1e-12)
    first = found.transitions[0]
    assert first.lost == pytest.approx(GRAVITY * (1 - e * e), rel=1e-12)


def test_a_ball_of_high_restitution_bounces_until_its_exact_time() -> None:
    found = follow(ball(0.99), (0.0, 1.0, 0.0, 0.0), 100.0, tolerance=1e-8)
    rest = next(x for x in found.transitions if x.kind == "rest")
    assert rest.t == pytest.approx(89.8532045562, rel=1e-10)
    assert found.outcome.kind == "rest"


@pytest.mark.parametrize("tolerance", [1e-6, 1e-9, 1e-11, 1e-13])
@pytest.mark.parametrize("e", [0.5, 0.99])
def test_a_bouncing_ball_comes_to_rest_at_every_tolerance(e: float, tolerance: float) -> None:
    """√(2 h/g) (1 + e)/(1 - e)."""
    end = math.sqrt(2 / GRAVITY) * (1 + e) / (1 - e)
    found = follow(ball(e), (0.0, 1.0, 0.0, 0.0), 2 * end, tolerance=tolerance)
    assert next(x for x in found.transitions if x.kind == "rest").t == pytest.approx(end, rel=1e-10)


@pytest.mark.parametrize(("delta", "contacts"), [(1e-3, 2), (1e-6, 2), (0.0, 1), (-1e-6, 0)])
def test_a_ceiling_that_is_just_reached(delta: float, contacts: int) -> None:
    """Thrown up against a ceiling at v²/2g - δ, which does not send it back: it is only looked at."""
    v = GRAVITY / 2
    height = v * v / (2 * GRAVITY) - delta

    def laws(choice: Choice) -> Law:
        return Law(lambda t, y: [-GRAVITY])

    def above(regime: Regime, choice: Choice, t: float, y: Sequence[float]) -> float:
        return height - y[0]

    scene = Scene({}, laws, (1.0,), (1.0, v))
    events = tuple(Event(name, crossing=Crossing(above, 1.0)) for name in ("first", "second"))
    found = follow(scene, (0.0, v), 0.9, Schedule(events=events))
    assert len(found.events) == contacts
    if contacts == 2:
        first, second = found.events
        assert second.t - first.t == pytest.approx(2 * math.sqrt(2 * delta / GRAVITY), rel=1e-6)
        assert abs(first.y[1]) == pytest.approx(math.sqrt(2 * GRAVITY * delta), rel=1e-6)
    if contacts == 1:
        assert found.events[0].t == pytest.approx(0.5, abs=1e-7)


def belt() -> Scene:
    """A block on a moving belt, held by a spring: m = 1, k = 100, belt 0.1 m/s, mu_s = 0.4, mu_k = 0.3."""
    m, k, u, static, kinetic = 1.0, 100.0, 0.1, 0.4, 0.3
    weight = m * GRAVITY

    def energy(t: float, y: Sequence[float]) -> float:
        return m * y[1] ** 2 / 2 + k * y[0] ** 2 / 2

    def laws(choice: Choice) -> Law:
        if choice == (0,):
            limits = tuple(
                Condition("C", "limit", "the friction is enough", limit, scale=weight)
                for limit in (
                    lambda t, y: static * weight - k * y[0],
                    lambda t, y: static * weight + k * y[0],
                )
            )
            return Law(lambda t, y: [0.0], limits, lambda t, y: [y[0], u], energy, lambda t, y: k * y[0] * y[1])
        sense = 1.0 if choice == (1,) else -1.0
        slips = Condition("C", "slips", "the block slips", lambda t, y: sense * (y[1] - u), True)
        force = -sense * kinetic * weight
        return Law(lambda t, y: [(force - k * y[0]) / m], (slips,), stored=energy, fed=lambda t, y: force * y[1])

    return Scene({"C": modes("stick", "slip", "slip")}, laws, (m,), (0.04, 0.4))


def test_stick_and_slip_on_a_belt() -> None:
    found = follow(belt(), (0.0, 0.1), 2.0)
    changes = [x for x in found.transitions if x.kind == "mode"]
    slip, stick, again = (x.t for x in changes[:3])
    assert changes[0].before[0] == pytest.approx(0.03924, rel=1e-9)
    assert stick - slip == pytest.approx(0.47315706234, rel=1e-9)
    assert changes[1].before[0] == pytest.approx(0.01962, rel=1e-8)
    assert again - slip == pytest.approx(0.66935706234, rel=1e-9)
    largest = Event("top", crossing=Crossing(lambda regime, choice, t, y: y[1], 0.1, -1))
    found = follow(belt(), (0.0, 0.1), 2.0, Schedule(events=(largest,)))
    assert found.outcome.kind == "reached"
    assert found.events[0].y[0] == pytest.approx(0.04343842961, rel=1e-9)


def incline(mu_s: float, mu_k: float) -> Scene:
    """A block thrown up an incline of 30 degrees; y = (s, v) up the slope."""
    down, press = GRAVITY * math.sin(math.pi / 6), GRAVITY * math.cos(math.pi / 6)

    def laws(choice: Choice) -> Law:
        def energy(t: float, y: Sequence[float]) -> float:
            return y[1] ** 2 / 2 + down * y[0]

        if choice == (0,):
            limit = Condition("C", "limit", "friction is enough", lambda t, y: mu_s * press - down, scale=GRAVITY)
            return Law(lambda t, y: [0.0], (limit,), lambda t, y: [y[0], 0.0], energy)
        sense = 1.0 if choice == (1,) else -1.0
        slips = Condition("C", "slips", "the block slips", lambda t, y: sense * y[1], True)
        force = -sense * mu_k * press
        return Law(lambda t, y: [force - down], (slips,), stored=energy, fed=lambda t, y: force * y[1])

    return Scene({"C": modes("stick", "slip", "slip")}, laws, (1.0,), (1.0, 3.0), energy_scale=GRAVITY)


def test_a_block_comes_to_rest_on_an_incline_and_sticks() -> None:
    found = follow(incline(0.7, 0.6), (0.0, 3.0), 5.0)
    stop = 3.0 / (GRAVITY * (0.5 + 0.6 * math.sqrt(3) / 2))
    assert [x.new for x in found.transitions] == [(1,), (0,)]
    assert found.transitions[1].t == pytest.approx(stop, rel=1e-12)
    assert found.outcome.kind == "rest"


def test_a_block_slides_back_down_an_incline() -> None:
    found = follow(incline(0.4, 0.3), (0.0, 3.0), 2.0)
    assert [x.new for x in found.transitions] == [(1,), (2,)]
    stop = 3.0 / (GRAVITY * (0.5 + 0.3 * math.sqrt(3) / 2))
    assert found.transitions[1].t == pytest.approx(stop, rel=1e-12)
    back = GRAVITY * (0.5 - 0.3 * math.sqrt(3) / 2)
    assert found.at(2.0)[1] == pytest.approx(-back * (2.0 - stop), rel=1e-10)


def jerked() -> Scene:
    """A particle that hangs on a slack rope of 1 m, fixed at the origin: y = (x, y, vx, vy)."""

    def laws(choice: Choice) -> Law:
        def energy(t: float, y: Sequence[float]) -> float:
            return (y[2] ** 2 + y[3] ** 2) / 2 + GRAVITY * y[1]

        if choice == (1,):
            stretch = Condition("rope", "stretch", "the rope is slack", lambda t, y: 1.0 - math.hypot(y[0], y[1]))
            return Law(lambda t, y: [0.0, -GRAVITY], (stretch,), stored=energy)

        def tension(t: float, y: Sequence[float]) -> float:
            square = y[0] ** 2 + y[1] ** 2
            return (y[2] ** 2 + y[3] ** 2 - GRAVITY * y[1]) / square

        def mend(t: float, y: Sequence[float]) -> list[float]:
            r = math.hypot(y[0], y[1])
            x, z = y[0] / r, y[1] / r
            out = y[2] * x + y[3] * z
            return [x, z, y[2] - out * x, y[3] - out * z]

        taut = Condition("rope", "taut", "the rope pulls", tension, scale=GRAVITY)
        return Law(lambda t, y: [-tension(t, y) * y[0], -GRAVITY - tension(t, y) * y[1]], (taut,), mend, energy)

    def contacts(choice: Choice, t: float, y: Sequence[float]) -> list[StruckContact]:
        r = math.hypot(y[0], y[1])
        return [StruckContact("rope", (-y[0] / r, -y[1] / r))] if choice == (0,) or touching(r - 1.0) else []

    return Scene({"rope": modes("taut", "slack")}, laws, (1.0, 1.0), (1.0, 1.0, 3.0, 3.0), contacts, energy_scale=9.81)


def test_a_rope_jerks_taut_and_loses_what_pulls_along_it() -> None:
    found = follow(jerked(), (0.6, 0.0, 0.0, 0.0), 1.0)
    fall = math.sqrt(2 * 0.8 / GRAVITY)
    impact = next(x for x in found.transitions if x.kind == "impact")
    assert impact.t == pytest.approx(fall, rel=1e-11)
    v = GRAVITY * fall
    # Along the rope (0.6, -0.8) the speed 0.8 v is lost.
    assert impact.lost == pytest.approx((0.8 * v) ** 2 / 2, rel=1e-10)
    assert impact.impulses["rope"][0] == pytest.approx(0.8 * v, rel=1e-10)
    assert found.segments[-1].choice == (0,)


def test_a_rope_slackens_at_the_top_of_a_slow_loop() -> None:
    """From the lowest point with v² = 3 g: the rope is slack where cos = -1/3, at the height 1/3 above the middle."""
    found = follow(jerked(), (0.0, -1.0, math.sqrt(3 * GRAVITY), 0.0), 1.0)
    slack = next(x for x in found.transitions if x.new == (1,))
    assert slack.before[1] == pytest.approx(1 / 3, rel=1e-9)


def buffer() -> Scene:
    """A cart at rest, y = (x of a ball, x of the cart, rates), that a ball pushes over a spring of 1 m."""
    k = 50.0

    def laws(choice: Choice) -> Law:
        def squeeze(t: float, y: Sequence[float]) -> float:
            return 1.0 - (y[1] - y[0])

        def energy(t: float, y: Sequence[float]) -> float:
            return y[2] ** 2 / 2 + y[3] ** 2 + (k * squeeze(t, y) ** 2 / 2 if choice == (0,) else 0.0)

        if choice == (0,):
            engaged = Condition("load s", "stretch", "the spring is compressed", squeeze)
            return Law(lambda t, y: [-k * squeeze(t, y), k * squeeze(t, y) / 2], (engaged,), stored=energy)
        free = Condition("load s", "stretch", "the spring is not compressed", lambda t, y: -squeeze(t, y))
        return Law(lambda t, y: [0.0, 0.0], (free,), stored=energy)

    return Scene({"load s": modes("", "")}, laws, (1.0, 2.0), (1.0, 1.0, 2.0, 2.0))


def test_what_nothing_pushes_yet_begins_to_move_when_something_does() -> None:
    found = follow(buffer(), (-2.0, 0.0, 2.0, 0.0), 3.0)
    assert [x.new for x in found.transitions] == [(1,), (0,), (1,)]
    assert found.transitions[1].t == pytest.approx(0.5, rel=1e-12)
    # Half a period of the two masses on the spring, then the velocities of an elastic impact.
    assert found.transitions[2].t == pytest.approx(0.5 + math.pi * math.sqrt(2 / 3 / 50), rel=1e-9)
    assert found.at(3.0)[2:] == pytest.approx([2.0 * (1 - 2) / 3, 2.0 * 2 / 3], rel=1e-8)


def test_a_block_leaves_a_dome() -> None:
    """A particle slides down a dome of 1 m without friction: it leaves it where cos = 2/3 (from a slow start: less)."""

    def laws(choice: Choice) -> Law:
        def energy(t: float, y: Sequence[float]) -> float:
            return (y[2] ** 2 + y[3] ** 2) / 2 + GRAVITY * y[1]

        if choice == (1,):
            gap = Condition("C", "gap", "it is off the dome", lambda t, y: math.hypot(y[0], y[1]) - 1.0)
            return Law(lambda t, y: [0.0, -GRAVITY], (gap,), stored=energy)

        def normal(t: float, y: Sequence[float]) -> float:
            return (GRAVITY * y[1] - y[2] ** 2 - y[3] ** 2) / (y[0] ** 2 + y[1] ** 2)

        def mend(t: float, y: Sequence[float]) -> list[float]:
            r = math.hypot(y[0], y[1])
            x, z = y[0] / r, y[1] / r
            out = y[2] * x + y[3] * z
            return [x, z, y[2] - out * x, y[3] - out * z]

        presses = Condition("C", "presses", "it presses on the dome", normal, scale=GRAVITY)
        return Law(lambda t, y: [normal(t, y) * y[0], normal(t, y) * y[1] - GRAVITY], (presses,), mend, energy)

    scene = Scene({"C": modes("slip", "apart")}, laws, (1.0, 1.0), (1.0, 1.0, 3.0, 3.0), energy_scale=GRAVITY)
    found = follow(scene, (0.0, 1.0, 0.3, 0.0), 2.0)
    off = next(x for x in found.transitions if x.new == (1,))
    assert off.before[1] == pytest.approx((2 + 0.09 / GRAVITY) / 3, rel=1e-9)


def rod(mu: float, theta: float, omega: float) -> Scene:
    """Painlevé's rod, m = 1, length 2, its lower end sliding on the floor: y = (x, y, θ, rates) of the middle."""

    def end(y: Sequence[float]) -> tuple[float, float, float]:
        return y[1] - math.sin(y[2]), y[3] + y[5] * math.sin(y[2]), y[4] - y[5] * math.cos(y[2])

    def laws(choice: Choice) -> Law:
        if choice == (2,):
            gap = Condition("A", "gap", "the end is above the floor", lambda t, y: end(y)[0])
            return Law(lambda t, y: [0.0, -GRAVITY, 0.0], (gap,))
        sense = 1.0 if choice == (0,) else -1.0

        def normal(t: float, y: Sequence[float]) -> float:
            c, s = math.cos(y[2]), math.sin(y[2])
            return (GRAVITY - y[5] ** 2 * s) / (1 + 3 * c * (c + sense * mu * s))

        def rates(t: float, y: Sequence[float]) -> list[float]:
            c, s, n = math.cos(y[2]), math.sin(y[2]), normal(t, y)
            f = -sense * mu * n
            return [f, n - GRAVITY, 3 * (f * s - n * c)]

        conditions = (
            Condition("A", "presses", "N > 0", normal, scale=GRAVITY),
            Condition("A", "slips", "the end slides", lambda t, y: sense * end(y)[1], True),
        )

        def mend(t: float, y: Sequence[float]) -> list[float]:
            return [y[0], math.sin(y[2]), y[2], y[3], y[5] * math.cos(y[2]), y[5]]

        return Law(rates, conditions, mend)

    return Scene({"A": modes("slip", "slip", "apart")}, laws, (1.0, 1.0, 1 / 3), (1.0,) * 3 + (3.0,) * 3)


def rod_start(theta: float, omega: float) -> tuple[float, ...]:
    return (0.0, math.sin(theta), theta, -2.0 - omega * math.sin(theta), omega * math.cos(theta), omega)


def test_a_rod_that_jams_has_no_consistent_motion() -> None:
    theta = math.radians(60)
    scene = rod(1.5, theta, 0.0)
    found = follow(scene, rod_start(theta, 0.0), 1.0)
    assert (found.outcome.kind, found.outcome.code, found.outcome.joint) == ("none", "PL700", "A")
    assert "t = 0 s" in found.outcome.words


def test_a_rod_that_jams_may_have_two_motions() -> None:
    theta, omega = math.radians(60), 4.0
    found = follow(rod(1.5, theta, omega), rod_start(theta, omega), 1.0)
    assert (found.outcome.kind, found.outcome.code) == ("several", "PL701")


@pytest.mark.parametrize(("mu", "normal"), [(0.5, 8.914284), (1.2, 51.319805)])
def test_a_rod_that_slides_presses_as_it_should(mu: float, normal: float) -> None:
    theta = math.radians(60)
    scene = rod(mu, theta, 0.0)
    found = follow(scene, rod_start(theta, 0.0), 1e-3)
    assert found.transitions[0].new == (1,)
    regime = found.segments[0].regime
    assert regime.watch(0.0, list(rod_start(theta, 0.0)))[0] == pytest.approx(normal, rel=1e-7)


def test_three_balls_in_a_row_strike_at_once_or_one_after_the_other() -> None:
    row = [
        StruckContact("12", (-1.0, 1.0, 0.0), restitution=1.0),
        StruckContact("23", (0.0, -1.0, 1.0), restitution=1.0),
    ]
    struck = Struck((1.0, 0.0, 0.0), (1.0,) * 3, (1.0,) * 3, (), tuple(row))
    at_once = strike(struck)
    assert at_once.velocities == pytest.approx((-1 / 3, 2 / 3, 2 / 3), rel=1e-14)
    assert at_once.unique is True

    def laws(choice: Choice) -> Law:
        gaps = (
            Condition("12", "gap", "apart", lambda t, y: y[1] - y[0] - 1.0),
            Condition("23", "gap", "apart", lambda t, y: y[2] - y[1] - 1.0),
        )
        return Law(lambda t, y: [0.0] * 3, gaps, stored=lambda t, y: sum(v * v for v in y[3:]) / 2)

    def contacts(choice: Choice, t: float, y: Sequence[float]) -> list[StruckContact]:
        return [row[i] for i in range(2) if touching(y[i + 1] - y[i] - 1.0)]

    scene = Scene({"12": modes(""), "23": modes("")}, laws, (1.0,) * 3, (1.0,) * 6, contacts)
    found = follow(scene, (-1.0, 1.0, 2.0 + 1e-6, 1.0, 0.0, 0.0), 3.0)
    assert found.segments[-1].end[3:] == pytest.approx((0.0, 0.0, 1.0), abs=1e-12)
    assert [x.law for x in found.transitions] == ["", ""]
    together = follow(scene, (-1.0, 1.0, 2.0, 1.0, 0.0, 0.0), 3.0)
    assert together.segments[-1].end[3:] == pytest.approx((-1 / 3, 2 / 3, 2 / 3), rel=1e-12)
    assert "at once" in together.transitions[0].law


def test_a_state_that_is_reached_just_when_another_one_is_due() -> None:
    def laws(choice: Choice) -> Law:
        return Law(lambda t, y: [-GRAVITY])

    v = GRAVITY / 2
    scene = Scene({}, laws, (1.0,), (1.0, v))
    top = Event("top", crossing=Crossing(lambda regime, choice, t, y: y[1], v, -1))
    low = Event("low", crossing=Crossing(lambda regime, choice, t, y: y[0] + 1.0, 1.0))
    events = (top, low, Event("noon", time=0.5))
    found = follow(scene, (0.0, v), 3.0, Schedule(events=events))
    assert sorted((e.t, e.name) for e in found.events)[:2] == [(0.5, "noon"), (0.5, "top")]
    assert [e.name for e in found.events][-1] == "low"
