"""A homework as plain data: what is handed out, what is right, what a typical mistake gives, and what was handed in.

Nothing here needs the solver: these records cross processes, and are all that grading, reports and exports see.
Numbers are in the unit of their find, as the key tells it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from planar_cli.records import record

# --- what is right ---------------------------------------------------------------------------------------------------


Place = tuple[tuple[str, float], ...]
"""Values of the letters of a problem, in SI units."""


Printed = Mapping[str, str]
"""A part of a page in print, by the formats in which it is wanted: markdown, html, latex; for course systems, which
have formulas between brackets or between dollars, mathjax and dollars; of a figure svg itself, and in words what it
shows. Pictures that its Markdown calls are under the names by which it calls them.
"""


@record
class Mistaken:
    """What a find comes to with one typical mistake; `values` as those of the find."""

    name: str
    """Of the mistake, the same in every problem: `weight-left-out`."""
    feedback: str
    """A sentence to the student."""
    values: tuple[float, ...]
    """Of a formula that is not written out: at the places of its find."""
    formula: str = ""
    """Of a formula: itself, as a problem file would write it; then it has no values."""


@record
class Expected:
    """The right answer to one find of one variant."""

    find: str
    """Its name in the problem file."""
    asked: str
    """What is asked, as the page tells it: `acceleration of A`."""
    kind: str
    """number, vector (two components), list, word (also yes, no), formula, or equation of a curve."""
    values: tuple[float, ...]
    """In `unit`; of a word or formula none."""
    unit: str
    """As in the problem file, `1` of a pure number."""
    text: str
    """As the key tells it: `3.206 m/s²`, `T = m g sin β`, `yes`."""
    tolerance: float
    """Relative."""
    scale: float
    """The size, in `unit`, of what a zero is measured by."""
    rotation: bool = False
    """Has it a sense of rotation, counterclockwise being positive?"""
    direction: bool = False
    """Is it an angle that is the same after a whole turn?"""
    axis: str = ""
    """x or y, where it is a component along that axis: then right and up are positive; "" of anything else."""
    formula: str = ""
    """Of a formula: itself, as a problem file would write it."""
    letters: tuple[tuple[str, str], ...] = ()
    """Of a formula: its letters with their units."""
    others: tuple[tuple[str, str], ...] = ()
    """Of a formula: the other letters of the problem, which may stand in an answer and cancel there."""
    known: tuple[tuple[str, float], ...] = ()
    """Of a formula: the letters that the sheet gives as numbers, with these in SI units."""
    places: tuple[Place, ...] = ()
    """Of a formula: where mistakes, and what follows from own earlier results, are known by their values."""
    points: float = 1.0
    mistakes: tuple[Mistaken, ...] = ()
    nearly: tuple[Mistaken, ...] = ()
    """What typical mistakes give that is another number than the right one, but not clearly another."""
    heading: float | None = None
    """Of a component along a line: where it is positive, in radians counterclockwise from +x."""
    lines: tuple[float, ...] = ()
    """Of a vector: the directions of the straight surfaces and guides of the problem, in radians from +x."""
    size: bool = False
    """Is it the magnitude of a vector?"""
    mode: str = ""
    """Of whether a contact or a rope is in a mode, which one: stick."""
    us: bool = False
    """Are its base units ft, slug and s?"""
    gravity: float = 0.0
    """The acceleration of gravity of the problem in m/s^2; 0 where none stands in it."""


@record
class Task:
    """One problem of one variant."""

    problem: str
    """Its name in the set: letters, digits, `_`, `-`."""
    title: str
    text: str
    """What the student reads; "" where the file has none."""
    given: tuple[str, ...]
    """Lines such as `m = 2 kg` that stand beside the text, with the numbers of the variant: what it does not tell."""
    expected: tuple[Expected, ...]
    worked: Printed = field(default_factory=dict)
    """The worked solution; nothing where it is not wanted."""
    scene: Printed = field(default_factory=dict)
    """The figure of the sheet; nothing where it is not wanted, or there is none."""
    drawn: tuple[str, ...] = ()
    """The same lines of what varies, wherever the student reads it."""
    lead: str = "Given"
    """What stands before `given`: beside a text that tells values it is not all."""
    behind: tuple[tuple[str, tuple[str, ...]], ...] = ()
    """By find, where there are any: the finds on which it rests, of which own values are carried into it."""
    together: tuple[tuple[str, tuple[str, ...]], ...] = ()
    """By find, where there are any: the finds that equations give only together with what it is made of."""


@record
class Paper:
    """All problems of one variant; variant 0 is the files as they are."""

    variant: int
    tasks: tuple[Task, ...]


# --- what was handed in ----------------------------------------------------------------------------------------------


RIGHT, WRONG, UNGRADABLE, MISSING = "right", "wrong", "ungradable", "missing"
PARTLY = "partly right"
"""In print, of a right value with a slip in unit, sign or figures, which has a part of its points."""
CARRIED = "carried"
"""In print, of what is wrong and follows rightly from another wrong value of the student's own."""


@record
class Graded:
    """One find of one submission.

    `value`, `unit`, `sign`, `precision`: verdicts apart, one of the words above, or "" where that says nothing.
    """

    problem: str
    find: str
    submitted: str
    """As typed, with what cannot be printed made visible."""
    verdict: str
    """right, wrong, ungradable or missing."""
    score: float
    max_score: float
    value: str = ""
    unit: str = ""
    sign: str = ""
    precision: str = ""
    message: str = ""
    """To the student: gives nothing of the key away."""
    mistakes: tuple[str, ...] = ()
    """Names of the mistakes that give this number; several: it is ambiguous."""
    feedback: str = ""
    """What the one mistake is, in a sentence; "" where there is none or it is ambiguous."""
    carried: tuple[str, ...] = ()
    """Finds on which it rests and of which the student's own values were put in."""
    expected: str = ""
    """What the key says; only for the lecturer."""
    due_unit: str = ""
    """The unit of the key; "" of what has none."""
    tolerance: float = 0.0
    """Relative, within which it was compared; 0 of what is not compared by size."""

    @property
    def told(self) -> str:
        """The verdict in print."""
        if self.carried:
            return CARRIED
        return PARTLY if self.verdict == WRONG and self.score > 0 else self.verdict


@record
class Submission:
    """What one student handed in: typed answers by problem and find. `wrong`: why it, or a part of it, cannot be
    graded.
    """

    student: str
    variant: int
    answers: tuple[tuple[str, str, str], ...]
    """Problem, find, what was typed."""
    source: str = ""
    """The file."""
    wrong: tuple[str, ...] = ()


@record
class Result:
    """One submission graded."""

    student: str
    variant: int
    graded: tuple[Graded, ...]
    source: str = ""
    wrong: tuple[str, ...] = ()

    @property
    def score(self) -> float:
        return sum(g.score for g in self.graded)

    @property
    def max_score(self) -> float:
        return sum(g.max_score for g in self.graded)
