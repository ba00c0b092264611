"""On which side of a contact a body without mass centre is: where its points are, wherever the origin."""

from __future__ import annotations

import pytest
from answered import assert_close, solve

MU, ARM, DROP, REACH, FORCE, INERTIA, SPEED = 0.4, 0.3, 0.05, 0.9, 100.0, 5.0, 20.0


def brake(origin: tuple[float, float], sense: int, order: str, inside: bool = False) -> str:
    """A drum of radius 0.2 m with a lever above its top, or below it inside the drum; the origin anywhere."""
    x, y = origin
    level = 0.2 - DROP if inside else 0.2 + DROP
    push = 90 if inside else -90
    return "\n".join([
        "title: Brake",
        "plane: horizontal",
        f"points: {{O: [{x} m, {y} m], K: [{x} m, {y + 0.2} m], C: [{x - ARM} m, {y + level} m],"
        f" D: [{x + REACH - ARM} m, {y + level} m]}}",
        "bodies:",
        f"  drum: {{disk: O, radius: 0.2 m, mass: any, inertia: {INERTIA} kg*m^2}}" if not inside else
        f"  drum: {{points: [O], center: O, mass: any, inertia: {INERTIA} kg*m^2}}",
        f"  lever: {{points: [{order}]}}",
        *(["surfaces: {wall: {center: O, radius: 0.2 m, body: drum}}"] if inside else []),
        "joints:",
        "  - pin: {at: O, between: [ground, drum]}",
        "  - pin: {at: C, between: [ground, lever]}",
        f"  - contact: {{between: [lever, {'wall' if inside else 'drum'}], at: K, mu_k: {MU}}}",
        f"loads: [force: {{body: lever, at: D, magnitude: {FORCE} N, angle: {push} deg}}]",
        f"states: {{1: [t = 0, omega(drum) = {sense * SPEED} rad/s], 2: [omega(drum) = 0]}}",
        "find: {N: N(K) @ 1, t: t @ 2}",
    ])  # fmt: skip


@pytest.mark.parametrize("origin", [(0, 0), (3, 4), (-1, -2)])
@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("order", ["C, K, D", "D, C"])
def test_a_brake_lever_presses_on_the_drum_from_outside(origin: tuple[float, float], sense: int, order: str) -> None:
    found = solve(brake(origin, sense, order))
    # Moments about the pin: friction on the lever acts along the motion of the drum's top, DROP below the pin.
    normal = FORCE * REACH / (ARM - sense * MU * DROP)
    assert_close(found["N"], normal)
    assert_close(found["t"], SPEED * INERTIA / (MU * normal * 0.2))


@pytest.mark.parametrize("origin", [(0, 0), (3, 4), (0, -2)])
def test_a_shoe_presses_on_the_drum_from_inside(origin: tuple[float, float]) -> None:
    found = solve(brake(origin, -1, "C, K, D", inside=True))
    normal = FORCE * REACH / (ARM + MU * DROP)
    assert_close(found["N"], normal)
    assert_close(found["t"], SPEED * INERTIA / (MU * normal * 0.2))
