"""The shelf of integrators: orders, dense output, tolerances on scales, hard motions with given rates."""

from __future__ import annotations

import math
from typing import Any

import motions
import pytest

from planar_cli.integrators.base import Integrator, Setting, StepTooSmall
from planar_cli.manual import explanation
from planar_cli.registry import member, members

ALL = sorted(members("integrators"))
KINDS = [kind for kind in ALL if members("integrators")[kind]().available()]
OURS = [kind for kind in KINDS if not members("integrators")[kind].peer]
ADAPTIVE = [kind for kind in OURS if members("integrators")[kind].adaptive]


def made(kind: str) -> Any:
    """A new integrator."""
    return members("integrators")[kind]()


def end_of(kind: str, motion: motions.Motion, **options: Any) -> list[float]:
    """The state at the end of a motion."""
    setting = Setting(motion.scale, **options)
    *_, last = made(kind).steps(motion.rates, 0.0, motion.start, motion.end, setting)
    assert last.t1 == motion.end
    y: list[float] = last.y1
    return y


def error_of(motion: motions.Motion, y: list[float]) -> float:
    return max(abs(y[i] - v) for i, v in motion.reference.items())


def oscillation(t: float) -> list[float]:
    """The position and speed of `test_order`'s motion: a pendulum's small swing under a growing push."""
    return [math.sin(2 * t) + 0.1 * t * t, 2 * math.cos(2 * t) + 0.2 * t]


def pushed(t: float, y: list[float]) -> list[float]:
    # Not linear in y on purpose: the last term vanishes on the solution.
    away = y[0] - math.sin(2 * t) - 0.1 * t * t
    return [y[1], -4 * math.sin(2 * t) + 0.2 - 4 * away - away**2]


@pytest.mark.parametrize("kind", ALL)
def test_a_member_is_documented_and_named_as_its_file(kind: str) -> None:
    cls = members("integrators")[kind]
    assert issubclass(cls, Integrator)
    assert cls is member("integrators", kind)
    page = cls.__doc__ or ""
    assert all(heading in page for heading in ("Meaning", "Valid when", "Reference"))


@pytest.mark.parametrize("kind", OURS)
def test_order(kind: str) -> None:
    """The slope of the error over the step, in the range where rounding does not count, is the order."""
    order = members("integrators")[kind].order
    steps = {1: (0.01, 0.005, 0.0025), 4: (0.1, 0.05, 0.025)}.get(order, (0.5, 0.4, 0.3, 0.25))
    errors = []
    for step in steps:
        *_, last = made(kind).steps(pushed, 0.0, oscillation(0.0), 3.0, Setting([1.0, 2.0], step=step, tolerance=1e-13))
        errors.append(math.dist(last.y1, oscillation(3.0)))
    x, y = [math.log(s) for s in steps], [math.log(e) for e in errors]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    slope = sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y, strict=True)) / sum((a - mean_x) ** 2 for a in x)
    assert slope == pytest.approx(order, abs=0.15 * order)


@pytest.mark.parametrize("kind", KINDS)
def test_dense_output_is_as_good_as_the_ends(kind: str) -> None:
    integrator = made(kind)
    setting = Setting([1.0, 2.0], tolerance=1e-8) if integrator.adaptive else Setting([1.0, 2.0], step=1e-2)
    at_ends, between = 0.0, 0.0
    for step in integrator.steps(pushed, 0.0, oscillation(0.0), 3.0, setting):
        h = step.t1 - step.t0
        at_ends = max(at_ends, math.dist(step.y1, oscillation(step.t1)))
        for k in range(9):
            t = step.t0 + h * k / 8
            between = max(between, math.dist(step.at(t), oscillation(t)))
    assert between <= 30 * max(at_ends, 1e-8 if integrator.adaptive else 0.0)


@pytest.mark.parametrize("kind", KINDS)
def test_backward_in_time_leads_back(kind: str) -> None:
    integrator = made(kind)
    setting = Setting([1.0, 2.0], tolerance=1e-9) if integrator.adaptive else Setting([1.0, 2.0], step=1e-3)
    *_, there = integrator.steps(pushed, 0.0, oscillation(0.0), 1.0, setting)
    *_, back = made(kind).steps(pushed, 1.0, there.y1, 0.0, setting)
    assert math.dist(back.y1, oscillation(0.0)) < {1: 0.05}.get(integrator.order, 1e-6)


@pytest.mark.parametrize("kind", KINDS)
def test_work_is_counted(kind: str) -> None:
    integrator, calls = made(kind), 0

    def counted(t: float, y: list[float]) -> list[float]:
        nonlocal calls
        calls += 1
        return pushed(t, y)

    setting = Setting([1.0, 2.0], tolerance=1e-6) if integrator.adaptive else Setting([1.0, 2.0], step=1e-2)
    steps = list(integrator.steps(counted, 0.0, oscillation(0.0), 3.0, setting))
    assert integrator.counts.steps == len(steps)
    assert integrator.counts.evaluations == calls


@pytest.mark.parametrize("kind", ADAPTIVE)
def test_more_work_is_not_worse(kind: str) -> None:
    motion = motions.double_pendulum()
    ends = [error_of(motion, end_of(kind, motion, tolerance=t)) for t in (1e-6, 1e-8, 1e-10)]
    assert ends == sorted(ends, reverse=True)


def test_few_components_and_many_are_computed_alike() -> None:
    """Generated without loops, and with them: the same numbers up to rounding."""
    one = motions.pendulum(2.0, 3.0)
    n = 12

    def many(t: float, y: list[float]) -> list[float]:
        found = [one.rates(t, [y[i], y[n + i]]) for i in range(n)]
        return [*(q for q, _ in found), *(v for _, v in found)]

    together = motions.Motion(many, [2.0] * n + [0.0] * n, 3.0, [1.0] * n + [math.sqrt(9.81)] * n, {})
    a = end_of("dop853", one, tolerance=1e-9)
    b = end_of("dop853", together, tolerance=1e-9)
    assert b == pytest.approx([a[0]] * n + [a[1]] * n, rel=1e-12)


def test_double_pendulum() -> None:
    """Amplification of errors is 4e6 here: 1e-12 a step gives some 1e-7 at 10 s."""
    motion = motions.double_pendulum()
    assert error_of(motion, end_of("dop853", motion, tolerance=1e-12)) < 1e-6
    assert error_of(motion, end_of("dop853", motion, tolerance=1e-14)) < 2e-8


def test_chain_of_five() -> None:
    motion = motions.chain_of_five()
    assert error_of(motion, end_of("dop853", motion, tolerance=1e-11)) < 1e-8


def test_kepler_from_the_nearest_point() -> None:
    """Eccentricity 0.99: the criterion of this classic is 1e-7 after one period."""
    motion = motions.kepler(0.99)
    y = end_of("dop853", motion, tolerance=1e-12)
    assert math.hypot(y[0] - motion.reference[0], y[1]) < 1e-7


@pytest.mark.parametrize("kind", ADAPTIVE)
@pytest.mark.parametrize(("length", "mass", "time"), [(1.0, 1.0, 1.0), (1e-9, 1e6, 1e-6), (1e9, 1e-3, 3600.0)])
def test_units_change_nothing(kind: str, length: float, mass: float, time: float) -> None:
    """A spring and a mass in other units of length, mass and time, all sizes with them."""
    k, m = 3.0 * mass / time**2, 2.0 * mass
    cube = 1.0 / length**2
    motion = motions.Motion(
        lambda t, y: [y[1], -k / m * y[0] * (1 + cube * y[0] ** 2)],
        [0.0, 1.5 * length / time],
        20.0 * time,
        [length, length / time],
        {},
    )
    plain = motions.Motion(lambda t, y: [y[1], -1.5 * y[0] * (1 + y[0] ** 2)], [0.0, 1.5], 20.0, [1.0, 1.0], {})
    x, v = end_of(kind, motion, tolerance=1e-10)
    there = end_of(kind, plain, tolerance=1e-10)
    assert [x / length, v / (length / time)] == pytest.approx(there, rel=1e-11)


@pytest.mark.parametrize("kind", ADAPTIVE)
def test_released_from_exactly_horizontal_rest(kind: str) -> None:
    """Every second derivative of the angle vanishes there; no step may be taken as if the motion were simple."""
    motion = motions.pendulum(math.pi / 2, 10.0)
    # Period 4 K(1/2)/√(g/l): by the arithmetic-geometric mean.
    a, g = 1.0, math.cos(math.pi / 4)
    for _ in range(8):
        a, g = (a + g) / 2, math.sqrt(a * g)
    period = 2 * math.pi / a / math.sqrt(motions.GRAVITY)
    whole = motions.Motion(motion.rates, motion.start, 3 * period, motion.scale, {})
    assert end_of(kind, whole, tolerance=1e-9) == pytest.approx([math.pi / 2, 0.0], abs=3e-7)


@pytest.mark.parametrize("kind", OURS)
def test_zero_rates_stay_zero(kind: str) -> None:
    """An unstable equilibrium whose rates are exactly zero is not left by rounding, however long."""
    motion = motions.Motion(lambda t, y: [y[1], motions.GRAVITY * math.sin(y[0])], [0.0, 0.0], 60.0, [1.0, 3.0], {})
    options = {} if members("integrators")[kind].adaptive else {"step": 0.1}
    assert end_of(kind, motion, **options) == [0.0, 0.0]


@pytest.mark.parametrize("kind", OURS)
def test_every_step_is_projected(kind: str) -> None:
    def onto_circle(t: float, y: list[float]) -> list[float]:
        r = math.hypot(*y)
        return [y[0] / r, y[1] / r]

    options: dict[str, Any] = {"tolerance": 1e-3} if members("integrators")[kind].adaptive else {"step": 0.05}
    setting = Setting([1.0, 1.0], project=onto_circle, **options)
    for step in made(kind).steps(lambda t, y: [-y[1], y[0]], 0.0, [1.0, 0.0], 6.0, setting):
        assert math.hypot(*step.y1) == pytest.approx(1.0, abs=1e-15)


def test_rates_that_end_are_refused_by_name() -> None:
    """y' = -1/y reaches zero at t = 1/2, where there are no rates any more."""
    with pytest.raises(StepTooSmall, match=r"t = 0\.5"):
        list(made("dop853").steps(lambda t, y: [-1 / y[0]], 0.0, [1.0], 1.0, Setting([1.0])))


@pytest.mark.parametrize("kind", ["rk4", "semi_implicit_euler"])
def test_what_grows_beyond_all_numbers_is_refused(kind: str) -> None:
    """Steps that are too long for a stiff spring."""
    setting = Setting([1.0, 1.0], step=1.0)
    with pytest.raises(StepTooSmall, match="too long"):
        list(made(kind).steps(lambda t, y: [y[1], -1e10 * y[0]], 0.0, [1.0, 0.0], 100.0, setting))


def test_no_run_is_without_an_end() -> None:
    """A sign that flips with every step is refused by the number of steps, or by their length."""
    setting = Setting([1.0, 1.0], tolerance=1e-10, most_steps=200)
    with pytest.raises(StepTooSmall):
        list(made("dop853").steps(lambda t, y: [-math.copysign(1.0, y[0]), 0.0], 0.0, [0.1, 0.0], 10.0, setting))


def test_integrators_have_manual_pages() -> None:
    assert explanation("radau").startswith("radau: Radau IIA")
