"""Reported errors against true ones, on motions whose ends are known to many digits; how errors grow."""

from __future__ import annotations

import math
from collections.abc import Callable

import motions
import pytest

from planar_cli.integrators.base import EPSILON, Setting
from planar_cli.motion.follow.estimate import estimated, growth, shifts
from planar_cli.motion.trajectory.drive import Run, drive

SHIFT = 2.0**-40


def rod() -> motions.Motion:
    """A uniform rod of 1 m, released at rest from 2 rad."""
    reference = {0: -1.71364109596836164191939129}
    return motions.Motion(
        lambda t, y: [y[1], -1.5 * motions.GRAVITY * math.sin(y[0])], [2.0, 0.0], 10.0, [1.0, 3.0], reference
    )


def chain_of_ten() -> motions.Motion:
    """Ten links for 5 s; the reference is that of two runs at 1e-15, which differ by 3e-13."""
    reference = {0: 0.4975565115143, 1: 0.6589197974651, 2: 0.8226078780117}
    return motions.chain(10, 5.0, reference)


def followed(motion: motions.Motion, tolerance: float, shift: float = 0.0) -> Run:
    start = [a + b for a, b in zip(motion.start, shifts(motion.scale, shift), strict=True)]
    return drive(motion.rates, 0.0, start, motion.end, Setting(motion.scale, tolerance=tolerance))


CASES = [
    (rod, (1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12)),
    (motions.double_pendulum, (1e-7, 1e-8, 1e-9, 1e-10, 1e-12, 1e-13, 1e-14)),
    (motions.chain_of_five, (1e-4, 1e-8, 1e-12)),
    (chain_of_ten, (1e-7,)),
    (motions.andrews, (1e-6, 1e-11)),
]


@pytest.mark.parametrize(("made", "tolerances"), CASES, ids=lambda v: getattr(v, "__name__", ""))
def test_the_reported_error_is_within_a_factor_of_ten(
    made: Callable[[], motions.Motion], tolerances: tuple[float, ...]
) -> None:
    motion = made()
    for tolerance in tolerances:
        found = estimated(lambda e: followed(motion, e).y1, tolerance)
        true = max(abs(found.values[i] - v) / motion.scale[i] for i, v in motion.reference.items())
        told = max(found.errors[i] / motion.scale[i] for i in motion.reference)
        assert 0.1 * true <= told <= 10 * true, (made.__name__, tolerance, true, told)


def test_andrews_at_the_tightest_setting() -> None:
    motion = motions.andrews()
    end = followed(motion, 1e-13).y1
    assert max(abs(end[i] - v) for i, v in motion.reference.items()) < 1e-11


def differences(motion: motions.Motion) -> list[tuple[float, float]]:
    a, b = followed(motion, 1e-12), followed(motion, 1e-12, SHIFT)
    times = [motion.end * k / 100 for k in range(101)]
    size = motion.scale
    return [(t, max(abs(p - q) / s for p, q, s in zip(a.at(t), b.at(t), size, strict=True))) for t in times]


def test_how_a_small_difference_grows_in_a_chaotic_motion() -> None:
    """A unit in the last place of the double pendulum is 4e6 units after 10 s; the known digits end after some 25 s."""
    found = growth(differences(motions.double_pendulum()), SHIFT)
    assert 1e6 < found.factor < 1e8
    assert found.extrapolated
    assert found.horizon is not None
    assert 15 < found.horizon < 35


def test_a_pendulum_keeps_its_digits() -> None:
    assert growth(differences(rod()), SHIFT).horizon is None


def test_one_jump_is_no_growth() -> None:
    """An impact at grazing speed multiplies a difference once."""
    assert growth([(t / 10, SHIFT * (1e4 if t > 30 else 1.0)) for t in range(100)], SHIFT).horizon is None


def test_a_horizon_within_the_run() -> None:
    curve = [(t / 10, min(EPSILON * math.exp(t), 1.0)) for t in range(100)]
    found = growth(curve, EPSILON)
    assert not found.extrapolated
    assert found.horizon == pytest.approx(math.log(0.1 / EPSILON) / 10, abs=0.1)
