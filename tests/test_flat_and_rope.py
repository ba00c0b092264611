"""A block on a table: what a rope and friction share is open; friction while it sticks, and while it slides."""

from __future__ import annotations

import pytest
from answered import solve

from planar_cli.errors import NoSolution

HELD_TWICE = """
title: A block on a turning table, tied to its centre
plane: horizontal
given: {m: 2 kg, r: 0.5 m, w: 4 rad/s, mu: 0.3}
points: {O: [0, 0], P: [r, 0]}
bodies:
  table: {disk: O, radius: 1 m}
  block: {particle: P, mass: m}
joints:
  - pin: {at: O, between: [ground, table]}
  - flat: {between: [block, table], mu: mu}
  - rope: {path: [O, P], name: cord}
motion: [omega(table) = w]
instant: [v(P/table).mag = 0]
find: {T: tension(cord)}
"""


def test_the_tension_is_open() -> None:
    with pytest.raises(NoSolution) as raised:
        solve(HELD_TWICE)
    assert [d.code for d in raised.value.diagnostics] == ["PL603"]


def test_it_sticks_with_the_rope_and_slips_without() -> None:
    text = HELD_TWICE.replace("tension(cord)", "mode(block)")
    assert solve(text)["T"].word == "stick"
    without = "\n".join(line for line in text.splitlines() if "- rope" not in line)
    assert solve(without)["T"].word == "slip"


PULLED = """
title: A block on a table is pulled
plane: horizontal
points: {P: [0, 0]}
bodies: {block: {particle: P, mass: 2 kg}}
joints: [{flat: {between: [block, ground], FRICTION}}]
loads:
  - force: {body: block, at: P, magnitude: FORCE, angle: 30 deg}
instant: [at rest]
find: {a: a(P).along(30 deg), F: friction(block).mag, m: mode(block)}
"""


@pytest.mark.parametrize(
    ("friction", "force", "a", "size", "mode"),
    [
        ("mu_s: 0.5, mu_k: 0.4", "9 N", 0, 9, "stick"),
        ("mu_s: 0.5, mu_k: 0.4", "12 N", 6 - 0.4 * 9.81, 0.4 * 2 * 9.81, "slip"),
        ("mu_k: 0.4", "12 N", 6 - 0.4 * 9.81, 0.4 * 2 * 9.81, "slip"),
        ("friction: 8 N", "12 N", 2, 8, "slip"),
        ("friction: 8 N", "7 N", 0, 7, "stick"),
    ],
)
def test_static_and_kinetic_friction(friction: str, force: str, a: float, size: float, mode: str) -> None:
    found = solve(PULLED.replace("FRICTION", friction).replace("FORCE", force))
    assert [float(found[n].values[0]) for n in ("a", "F")] == pytest.approx([a, size])
    assert found["m"].word == mode


def test_the_static_coefficient_alone_tells_whether_it_slides() -> None:
    text = PULLED.replace("FRICTION", "mu_s: 0.5").replace("FORCE", "12 N")
    assert solve(text.replace("a: a(P).along(30 deg), F: friction(block).mag, ", ""))["m"].word == "slip"
    with pytest.raises(NoSolution) as raised:
        solve(text)
    assert raised.value.diagnostics[0].code == "PL636"


def test_it_slides_on_a_table_that_speeds_up() -> None:
    """(μ_s g)² = (α r)² + (ω² r)² where it begins."""
    text = HELD_TWICE.replace("  - rope: {path: [O, P], name: cord}\n", "").replace("mu: mu", "mu_s: mu, mu_k: 0.2")
    text = text.replace("omega(table) = w", "alpha(table) = 0.8 rad/s^2").replace("instant: [v(P/table).mag = 0]", "")
    states = (
        "states: {1: [t = 0, table at rest, v(P/table).mag = 0], 2: [mode(block) = slip]}\nfind: {w: omega(table) @ 2}"
    )
    text = text.replace("find: {T: tension(cord)}", states).replace(", w: 4 rad/s", "")
    expected = (((0.3 * 9.81) ** 2 - 0.4**2) ** 0.5 / 0.5) ** 0.5
    assert float(solve(text)["w"].values[0]) == pytest.approx(expected)
