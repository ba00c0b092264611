"""Driving a regime to the first thing that a watched value reaches."""

from __future__ import annotations

import math

import motions
import pytest

from planar_cli.integrators.base import Setting, StepTooSmall
from planar_cli.motion.terms.crossings import Watch, root
from planar_cli.motion.trajectory.drive import drive

G = motions.GRAVITY


def thrown(t: float, y: list[float]) -> list[float]:
    """A body in free flight: height and speed."""
    return [y[1], -G]


def under_a_ceiling(short: float, speed: float = 3.0) -> Watch:
    """The gap to a ceiling that is `short` below the highest point of a throw upward."""
    ceiling = speed * speed / (2 * G) - short
    return Watch(lambda t, y: [ceiling - y[0]], [ceiling])


def test_a_ball_meets_the_floor_to_the_last_digit() -> None:
    run = drive(thrown, 0.0, [1.0, 0.0], 5.0, Setting([1.0, 4.0]), watch=Watch(lambda t, y: [y[0]], [1.0]))
    (met,) = run.crossings
    assert met.way == "falls"
    assert run.t1 == met.t == pytest.approx(math.sqrt(2 / G), rel=1e-15)
    assert run.y1[1] == pytest.approx(-math.sqrt(2 * G), rel=1e-14)


def test_two_contacts_within_a_millisecond_under_a_ceiling() -> None:
    """The ceiling is a micrometre below the highest point: contact for 9.03e-4 s, at 4.429e-3 m/s."""
    watch = under_a_ceiling(1e-6)
    run = drive(thrown, 0.0, [0.0, 3.0], 2.0, Setting([1.0, 3.0]), watch=watch)
    assert run.crossings[0].way == "falls"
    assert run.y1[1] == pytest.approx(math.sqrt(2 * G * 1e-6), rel=1e-9)
    both = Watch(watch.values, watch.scales, [False])
    later = drive(thrown, run.t1, run.y1, 2.0, Setting([1.0, 3.0]), watch=both)
    assert later.crossings[0].way == "rises"
    assert later.t1 - run.t1 == pytest.approx(9.030e-4, rel=1e-3)


def test_exactly_as_high_as_the_ceiling_is_one_grazing_contact() -> None:
    run = drive(thrown, 0.0, [0.0, 3.0], 2.0, Setting([1.0, 3.0]), watch=under_a_ceiling(0.0))
    assert [c.way for c in run.crossings] == ["grazes"]
    assert run.t1 == pytest.approx(3 / G, abs=1e-7)
    assert run.y1[1] == pytest.approx(0.0, abs=1e-6)
    after = drive(thrown, run.t1, run.y1, 2.0, Setting([1.0, 3.0]), watch=under_a_ceiling(0.0))
    assert after.crossings == ()


@pytest.mark.parametrize("short", [-1e-10, -1e-6, -1e-2])
def test_no_contact_below_the_ceiling(short: float) -> None:
    run = drive(thrown, 0.0, [0.0, 3.0], 2.0, Setting([1.0, 3.0]), watch=under_a_ceiling(short))
    assert run.crossings == ()
    highest = max(run.at(3 / G + k * 1e-6)[0] for k in range(-2, 3))
    assert highest == pytest.approx(9 / (2 * G), abs=1e-12)


def test_a_contact_that_has_just_opened_is_no_contact() -> None:
    """The ball leaves the floor: its gap begins with zero, and is met when the ball comes back."""
    watch = Watch(lambda t, y: [y[0]], [1.0])
    run = drive(thrown, 0.0, [0.0, 2.0], 5.0, Setting([1.0, 4.0]), watch=watch)
    assert run.t1 == pytest.approx(4 / G, rel=1e-14)


def test_a_hop_shorter_than_the_first_step_is_seen() -> None:
    watch = Watch(lambda t, y: [y[0]], [1.0])
    run = drive(thrown, 0.0, [0.0, 1e-4], 5.0, Setting([1.0, 4.0], first=1.0), watch=watch)
    assert run.t1 == pytest.approx(2e-4 / G, rel=1e-9)


def test_a_guard_that_is_broken_at_the_start_ends_the_run_there() -> None:
    watch = Watch(lambda t, y: [y[0]], [1.0])
    assert drive(thrown, 1.0, [-0.1, 0.0], 5.0, Setting([1.0, 4.0]), watch=watch).t1 == 1.0
    assert drive(thrown, 1.0, [0.0, -1.0], 5.0, Setting([1.0, 4.0]), watch=watch).t1 == 1.0


def test_a_guard_that_stays_zero_breaks_nothing() -> None:
    """Its rounding has signs."""
    watch = Watch(lambda t, y: [1e-15 * math.sin(1e3 * t)], [1.0])
    assert drive(thrown, 0.0, [0.0, 1.0], 1.0, Setting([1.0, 4.0]), watch=watch).crossings == ()


def test_the_first_of_several_zeros_within_a_step() -> None:
    """Three passages through zero between the ends of one step."""
    watch = Watch(lambda t, y: [math.cos(40 * t) + 0.5], [1.0])
    run = drive(lambda t, y: [0.0, 0.0], 0.0, [0.0, 0.0], 1.0, Setting([1.0, 1.0], first=0.5, longest=0.5), watch=watch)
    assert run.t1 == pytest.approx(2 * math.pi / 3 / 40, rel=1e-12)


def test_what_is_reached_at_the_same_time_is_told_together() -> None:
    watch = Watch(lambda t, y: [y[0], 2 * y[0], y[0] + 0.1], [1.0, 1.0, 1.0])
    run = drive(thrown, 0.0, [1.0, 0.0], 5.0, Setting([1.0, 4.0]), watch=watch)
    assert sorted(c.index for c in run.crossings) == [0, 1]


def test_events_of_both_directions() -> None:
    watch = Watch(lambda t, y: [y[0] - 0.3], [1.0], [False])
    run = drive(thrown, 0.0, [0.0, 3.0], 2.0, Setting([1.0, 3.0]), watch=watch)
    assert [c.way for c in run.crossings] == ["rises"]
    assert run.y1[0] == pytest.approx(0.3, rel=1e-14)


def test_a_short_pulse_is_not_missed() -> None:
    """100 N for 10 ms on a mass at rest, after five quiet seconds."""

    def rates(t: float, y: list[float]) -> list[float]:
        return [y[1], 100.0 if 5.0 <= t < 5.01 else 0.0]

    run = drive(rates, 0.0, [0.0, 0.0], 10.0, Setting([1.0, 1.0]), breakpoints=[5.0, 5.01])
    assert run.y1 == pytest.approx([0.5 * 100 * 0.01**2 + 4.99, 1.0], rel=1e-13)
    assert {5.0, 5.01} <= {step.t1 for step in run.steps}
    assert run.counts.rejected == 0


def test_both_sides_of_a_breakpoint_whose_number_is_rounded() -> None:
    kink = 0.1 + 0.2

    def rates(t: float, y: list[float]) -> list[float]:
        return [1.0 if t >= 0.3 else 0.0]

    run = drive(rates, 0.0, [0.0], 1.0, Setting([1.0]), breakpoints=[kink])
    assert run.y1 == pytest.approx([0.7], rel=1e-13)
    assert run.counts.rejected == 0


def test_the_state_at_any_time_of_a_run() -> None:
    run = drive(thrown, 0.0, [0.0, 3.0], 2.0, Setting([1.0, 3.0]))
    for k in range(21):
        t = 0.1 * k
        assert run.at(t) == pytest.approx([3 * t - G * t * t / 2, 3 - G * t], abs=1e-13)


def test_a_root_is_found_to_the_last_digit() -> None:
    assert root(lambda x: x * x * x - 2.0, 0.0, 2.0) == pytest.approx(2 ** (1 / 3), rel=3e-16)
    assert root(lambda x: math.tanh(1e4 * (x - 0.7)), 0.0, 1.0) == pytest.approx(0.7, rel=1e-14)


def hung(stiffness: float, end: float) -> motions.Motion:
    """A mass of 1 kg dropped onto a spring at its natural length."""
    return motions.Motion(lambda t, y: [y[1], -stiffness * y[0] - G], [0.0, 0.0], end, [1.0, 3.0], {})


def test_what_is_too_small_to_see_is_seen_with_a_tighter_tolerance() -> None:
    """A spring of 1e10 N/m under 1 kg: an amplitude of 1e-9 m, 16 000 times a second."""
    motion = hung(1e10, 0.01)
    fine = drive(motion.rates, 0.0, motion.start, motion.end, Setting(motion.scale, tolerance=1e-13))
    assert fine.changed is None
    assert fine.y1[0] == pytest.approx(-4.293061261588e-10, abs=1e-13)
    coarse = drive(motion.rates, 0.0, motion.start, 10.0, Setting(motion.scale, tolerance=1e-6))
    assert coarse.changed is not None
    assert coarse.changed.unresolved
    assert coarse.changed.fastest == pytest.approx(1e5, rel=0.1)
    assert coarse.y1[0] == pytest.approx(-9.81e-10, rel=1e-3)


@pytest.mark.parametrize("tolerance", [1e-6, 1e-9])
def test_a_stiff_spring_costs_no_more_the_stiffer_it_is(tolerance: float) -> None:
    """Two masses, a soft spring and a stiff one: the slow motion is right to the tolerance, the work is bounded."""
    work = []
    for stiffness in (1e6, 1e8, 1e10):
        motion = motions.two_springs(stiffness, 10.0)
        run = drive(motion.rates, 0.0, motion.start, motion.end, Setting(motion.scale, tolerance=tolerance))
        assert run.changed is not None
        # Both masses on the soft spring; the stiff one adds g/k to the way of the lower, and as much to its softness.
        slow = math.sqrt(10.0 / 2.0 * (1.0 - 10.0 / stiffness / 4.0))
        assert run.y1[0] == pytest.approx(
            -2 * G / 10 * (1 - math.cos(slow * 10.0)), abs=10 * tolerance + 10 / stiffness
        )
        work.append(run.counts.evaluations)
    assert max(work) <= 2 * min(work)


def test_a_strong_damper_is_given_to_the_implicit_method() -> None:
    """A damper that stops a mass within 1e-6 s, and a slow spring: stability alone holds the explicit method down."""
    run = drive(
        lambda t, y: [y[1], -1e6 * (y[1] + y[0])], 0.0, [1.0, -1.000001000002], 2.0, Setting([1.0, 1.0], tolerance=1e-7)
    )
    assert run.changed is not None
    assert not run.changed.unresolved
    assert run.y1[0] == pytest.approx(math.exp(-2.0), rel=1e-5)
    assert run.counts.evaluations < 5000


def test_smooth_motions_are_not_taken_for_stiff() -> None:
    for motion in (motions.double_pendulum(), motions.chain_of_five(), motions.kepler(0.99)):
        for tolerance in (1e-4, 1e-8):
            setting = Setting(motion.scale, tolerance=tolerance)
            assert drive(motion.rates, 0.0, motion.start, motion.end, setting).changed is None


def test_a_named_method_is_kept_to() -> None:
    motion = motions.pendulum(1.0, 2.0)
    setting = Setting(motion.scale, tolerance=1e-9)
    ends = [drive(motion.rates, 0.0, motion.start, 2.0, setting, kind=k).y1 for k in ("dop853", "radau", "auto")]
    assert ends[0] == pytest.approx(ends[1], abs=1e-7)
    assert ends[0] == ends[2]


def test_an_unstable_equilibrium_is_left_as_fast_as_it_should_be() -> None:
    """A pendulum 1e-9 rad beside its upper position, where the motion is invisible for long: it is not damped away."""
    motion = motions.pendulum(math.pi - 1e-9, 2000.0)
    setting = Setting(motion.scale, tolerance=1e-6)
    watch = Watch(lambda t, y: [math.pi - 0.1 - y[0]], [1.0], [False])
    run = drive(motion.rates, 0.0, motion.start, motion.end, setting, watch=watch)
    assert run.t1 == pytest.approx(math.acosh(0.1 / 1e-9) / math.sqrt(G), rel=0.02)


def test_what_grows_without_end_is_not_followed_until_it_overflows() -> None:
    with pytest.raises(StepTooSmall, match="grown") as stopped:
        drive(lambda t, y: [y[1], y[0]], 0.0, [1.0, 1.0], 1e6, Setting([1.0, 1.0]))
    assert stopped.value.t == pytest.approx(math.log(1e8), abs=2.0)
