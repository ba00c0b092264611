"""A motion that a blow or other forces part is told in the order of time."""

from __future__ import annotations

import re

import pytest
from conftest import PROBLEMS
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate

FILES = {p.stem: p for p in PROBLEMS}
STEP = re.compile(r"^(?:MOTION|STEP \d+)  (.+?)(?:  +(states .+)|  .*)?$", re.MULTILINE)


@pytest.mark.parametrize(("stem", "steps"), [
    ("pile-driven-into-soil-of-constant-resistance", [
        ("from 1 to 2", ""), ("Kinetic analysis", ""), ("Motion over time", "states 1, 2"),
        ("Impulse and momentum", "states 2, 3"),
        ("from 3 to 4", ""), ("Kinetic analysis", ""), ("Motion over time", "states 3, 4")]),
    ("bullet-stays-in-a-block", [
        ("Impulse and momentum", "states before, after"),
        ("Kinetic analysis", ""), ("Work and energy", "states after, stop")]),
    ("sledge-up-a-slope-in-air", [
        ("from start to top", ""), ("Kinetic analysis", ""), ("Motion over time", "states start, top"),
        ("from top to back", ""), ("Kinetic analysis", ""), ("Motion over time", "states top, back")]),
])  # fmt: skip
def test_a_blow_comes_between_what_leads_to_it_and_the_forces_after_it(stem: str, steps: list[tuple[str, str]]) -> None:
    printed = Terminal(100).render(narrate(worked(FILES[stem])[0]))
    assert STEP.findall(printed) == steps


def test_equations_are_numbered_as_they_stand() -> None:
    """What is told early counts on, and the rest after it."""
    printed = Terminal(100).render(narrate(worked(FILES["rod-caught-and-let-go"])[0]))
    numbers = [int(n) for n in re.findall(r"^ +\((\d+)\)  ", printed, re.MULTILINE)]
    assert numbers == list(range(1, len(numbers) + 1))
