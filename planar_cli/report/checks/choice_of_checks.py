"""Which check of a person's own stands on a page: the first candidate that has something to say.

Each candidate is a file of its own: a function that gives one line with numbers on both sides, or nothing. They stand
here in the order in which a teacher would choose: what rests on another principle or on an equation that the solution
did not need, then what was found put in again by another way. Of a motion with a blow that of the blow comes first: a
fall before it needs none; and Newton's law, integrated, comes before the balance by which the speed was found; what
tests the arithmetic alone comes last. None only repeats a line of the solution; where no candidate speaks, the page has
none.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from planar_cli.report.checks.another_equation import another_equation
from planar_cli.report.checks.another_point import another_point
from planar_cli.report.checks.blow_check import blow_check
from planar_cli.report.checks.centre_check import centre_check
from planar_cli.report.checks.cosine_check import cosine_check
from planar_cli.report.checks.energy_check import energy_check, root_check
from planar_cli.report.checks.first_second import first_second
from planar_cli.report.checks.harmonic_check import harmonic_check
from planar_cli.report.checks.inertia_check import inertia_check
from planar_cli.report.checks.law_check import law_check, mean_check, simpson_check
from planar_cli.report.checks.meeting_check import meeting_check
from planar_cli.report.checks.oscillation_check import oscillation_check
from planar_cli.report.checks.polar_check import polar_check
from planar_cli.report.checks.power_check import power_check
from planar_cli.report.checks.round_check import round_check
from planar_cli.report.checks.system_sum import system_sum
from planar_cli.report.checks.tale_check import tale_check
from planar_cli.report.checks.time_check import time_check
from planar_cli.report.checks.track_check import track_check
from planar_cli.report.checks.turn_check import turn_check
from planar_cli.report.checks.velocity_check import velocity_check
from planar_cli.report.document.blocks import Line
from planar_cli.report.laws.passing import passing_check
from planar_cli.report.words.words import Phrases

Candidate = Callable[[Any, Phrases], Line]
"""It looks at an instant, a motion or a part."""

OF_INSTANTS: tuple[Candidate, ...] = (
    another_equation, system_sum, power_check, another_point, velocity_check, polar_check, first_second,
)  # fmt: skip
OF_MOTIONS: tuple[Candidate, ...] = (
    blow_check, energy_check, meeting_check, law_check, simpson_check, root_check,
    passing_check, time_check, oscillation_check, harmonic_check, turn_check,
    mean_check, centre_check,
)  # fmt: skip
OF_PARTS: tuple[Candidate, ...] = (
    tale_check, track_check, inertia_check, round_check, cosine_check,
)  # fmt: skip


def chosen_check(candidates: tuple[Candidate, ...], of: Any, phrases: Phrases) -> Line:
    """The line of the first candidate that has one; empty where none has."""
    return next((told for check in candidates if (told := check(of, phrases))), ())
