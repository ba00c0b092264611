"""The end of a cord without mass, held by a spring on the line of the cord: it stays on that line."""

from __future__ import annotations

import math

import pytest
from answered import assert_close, solve

from planar_cli.errors import NoSolution


def drum(side: int, direction: str) -> str:
    """A drum turned by a force against a spring at the end of its cord, which hangs down or runs level."""
    if direction == "down":
        points = f"T: [{-side * 0.4} m, 0], Q: [{-side * 0.4} m, -0.5 m], W: [{-side * 0.4} m, -1.5 m]"
    else:
        points = f"T: [0, 0.4 m], Q: [{side * 0.5} m, 0.4 m], W: [{side * 1.5} m, 0.4 m]"
    turn = -side if direction == "down" else side
    return "\n".join([
        "title: Drum pulled against a spring",
        "plane: vertical",
        f"points: {{O: [0, 0], {points}, S: [{side * 0.2} m, 0]}}",
        "bodies: {drum: {disk: O, radius: 0.4 m, hub: 0.2 m, mass: any, inertia: 0.5 kg*m^2}, Q: {particle: Q}}",
        "joints:",
        "  - pin: {at: O, between: [ground, drum]}",
        "  - rope: {path: [Q, T on drum], name: cord}",
        "loads:",
        "  - spring: {between: [W, Q], stiffness: 100 N/m, natural_length: 1 m}",
        f"  - torque: {{body: drum, moment: {turn * 4} N*m}}",
        f"states: {{1: [at rest], 2: [theta(drum) @ 2 - theta(drum) @ 1 = {turn * 0.25} rad]}}",
        "find: {w: omega(drum) @ 2, T: tension(cord) @ 2}",
    ])  # fmt: skip


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("direction", ["down", "level"])
def test_a_drum_turns_against_a_spring_at_the_end_of_its_cord(side: int, direction: str) -> None:
    found = solve(drum(side, direction))
    turn = -side if direction == "down" else side
    assert_close(found["w"], turn * math.sqrt(2 * (4 * 0.25 - 50 * 0.1**2) / 0.5), 9)
    assert_close(found["T"], 10, 9)


def test_what_has_no_mass_and_balances_nowhere_on_a_line_is_told() -> None:
    text = drum(1, "level").replace("W: [1.5 m, 0.4 m]", "W: [1.5 m, 0.9 m]").replace("length: 1 m", "length: 0.9 m")
    with pytest.raises(NoSolution) as caught:
        solve(text)
    assert "a `guide` along the line on which it moves" in caught.value.diagnostics[0].hint
