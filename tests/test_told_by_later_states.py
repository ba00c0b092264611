"""States whose relations speak of later states, to which they lead: the equations tell when they are."""

from __future__ import annotations

import pytest

from planar_cli.errors import NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import PartSolution, Solution

BUS = """\
title: Bus between two stops
{known}
bodies: {{bus: {{particle: [0, 0]}}}}
joints:
  - guide: {{point: bus, along: {along}, name: road}}
motion:
  - a(bus).along({along}) = {a} during A->cruise
  - a(bus).along({along}) = 0 during cruise->brake
  - a(bus).along({along}) = -d during brake->B
states:
  A: [t = 0, at rest]
  cruise: [v(bus).along({along}) = {u}]
  brake: [{brake}]
  B: [{end}]
find: {{AB: r(bus).mag @ B, d: d, t_B: t @ B}}
"""
NUMBERS = {
    "known": "unknowns: {d: m/s^2}",
    "along": "0 deg",
    "a": "0.8 m/s^2",
    "u": "12 m/s",
    "brake": "x(bus) @ B - x(bus) = 42 m",
    "end": "t = 28 s, v(bus).along(0 deg) = 0",
}


def whole(**changes: str) -> Solution:
    problem, _ = load_text(BUS.format(**{**NUMBERS, **changes}), "bus.yaml")
    return solve_problem(problem)


def solved(**changes: str) -> PartSolution:
    (part,) = whole(**changes).parts
    return part


def numbers(part: PartSolution) -> dict[str, float]:
    return {f.name: float(f.values[0]) for f in part.found if f.values}


@pytest.mark.parametrize("brake", ["x(bus) @ B - x(bus) @ brake = 42 m", "x(bus) = x(bus) @ B - 42 m"])
def test_the_later_state_tells_where_something_begins(brake: str) -> None:
    part = solved(brake=brake)
    assert numbers(part) == pytest.approx({"AB": 204, "d": 12 / 7, "t_B": 28})
    assert part.confirmed is not None
    assert {"AB", "t_B"} <= part.confirmed.finds


def test_the_later_state_tells_when_something_begins() -> None:
    part = solved(brake="t @ B - t = 7 s")
    assert numbers(part) == pytest.approx({"AB": 204, "d": 12 / 7, "t_B": 28})


def test_mirrored() -> None:
    end = "t = 28 s, v(bus).along(180 deg) = 0"
    part = solved(along="180 deg", brake="x(bus) - x(bus) @ B = 42 m", end=end)
    assert numbers(part) == pytest.approx({"AB": 204, "d": 12 / 7, "t_B": 28})


def test_nothing_sought() -> None:
    part = solved(known="given: {d: 2 m/s^2}", brake="x(bus) @ B = 250 m", end="v(bus).along(0 deg) = 0")
    # 90 m while it gains speed, 36 m of braking in 6 s, and 124 m at 12 m/s.
    assert numbers(part) == pytest.approx({"AB": 250, "d": 2, "t_B": 15 + 124 / 12 + 6})


def test_us_units() -> None:
    part = solved(
        a="2 ft/s^2",
        u="40 ft/s",
        brake="x(bus) @ B - x(bus) = 120 ft",
        end="t = 40 s, v(bus).along(0 deg) = 0",
    )
    assert numbers(part) == pytest.approx({"AB": 400 + 40 * 14 + 120, "d": 40 / 6, "t_B": 40})


def test_in_letters() -> None:
    """With the first numbers that are drawn for a, u, T, b it can not do so in the time: others are drawn."""
    solution = whole(
        known="unknowns: {d: m/s^2}\nsymbols: {a: m/s^2, u: m/s, T: s, b: m}",
        a="a",
        u="u",
        brake="x(bus) @ B - x(bus) = b",
        end="t = T, v(bus).along(0 deg) = 0",
    )
    told = {f.name: str(f.expressions[0]) for f in solution.parts[0].found if f.expressions}
    page = Terminal().render(narrate(solution))
    assert told["d"] == "u**2/(2*b)"
    # The speed that is kept is the letter that states it, not the number that was drawn for it.
    kept = [row for row in page.splitlines() if "v_bus,brake = u" in row]
    assert kept
    assert not any(row.endswith("m/s") for row in kept)


def test_a_state_that_says_nothing_new() -> None:
    end = NUMBERS["end"] + ", x(bus) - x(bus) @ brake = 42 m"
    with pytest.raises(NoSolution) as refused:
        solved(brake="v(bus).along(0 deg) = 12 m/s", end=end)
    (told,) = refused.value.diagnostics
    assert (told.code, told.mark.line) == ("PL623", 13)
    assert "when state brake is" in told.message
