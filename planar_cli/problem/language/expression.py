"""The syntax tree of one statement: what the parser makes, what dimensions and equations are read from.

Nothing here knows SymPy, units' meaning, or the scene; nodes only keep what was written and where.
Numbers are exact rationals in the unit that was written.
"""

from __future__ import annotations

from fractions import Fraction

from planar_cli.errors import Mark
from planar_cli.records import record


@record
class Number:
    """A number as written, with its unit (`None`: none written) and sense: +1, or -1 after `cw`."""

    value: Fraction
    unit: str | None
    sense: int
    mark: Mark


@record
class Name:
    """A name of the file, `t`, `pi`, `infinity`, or `case.find`; `at` a state's name when `name @ state`."""

    name: str
    at: str | None
    mark: Mark


@record
class Word:
    """A mode word: stick, slip, apart, tip, taut or slack."""

    word: str
    mark: Mark


@record
class Negate:
    operand: Side
    mark: Mark


@record
class Binary:
    """`operator` is one of + - * / ^ (`evaluation.ARITHMETIC` says what they do)."""

    operator: str
    left: Side
    right: Side
    mark: Mark


@record
class Scaled:
    """A bracket followed by a unit, `(pi/4) rad/s`; `sense` as in Number."""

    operand: Side
    unit: str
    sense: int
    mark: Mark


@record
class Function:
    """sin cos tan asin acos atan sqrt exp log abs of one side."""

    name: str
    argument: Side
    at: str | None
    mark: Mark


@record
class Grouped:
    """A bracket with an instant behind it, `(x - y) @ 2`."""

    operand: Side
    at: str
    mark: Mark


@record
class PointPair:
    """`B/A` as a direction: from A to B."""

    to: str
    origin: str
    mark: Mark


@record
class Part:
    """`.x .y .mag .angle .t .n .r .theta`, or `.along(direction)`, `.across(direction)`."""

    kind: str
    direction: Side | PointPair | None
    mark: Mark


@record
class Quantity:
    """`v(B/A).along(30 deg) @ 2`.

    `word` is the quantity; exactly one of the following is set: `things` (one or two names, `all` among them),
    or `argument` (a side, or a relation for `count`; dot, ddot, mean, count).
    `at` is a state's name, or a span `("1", "2")`.
    """

    word: str
    things: tuple[str, ...]
    argument: Side | Relation | None
    parts: tuple[Part, ...]
    at: str | tuple[str, str] | None
    mark: Mark


Side = Number | Name | Word | Negate | Binary | Scaled | Function | Grouped | Quantity


@record
class Relation:
    """`left operator right`; operator is one of = < > <= >= ."""

    left: Side
    operator: str
    right: Side
    text: str
    mark: Mark


@record
class Extreme:
    """`side is largest` (sense +1) or `is smallest` (-1)."""

    side: Side
    sense: int
    text: str
    mark: Mark


@record
class AtRest:
    """`at rest` (body None: everything that motion does not drive) or `name at rest`."""

    body: str | None
    text: str
    mark: Mark


@record
class Equilibrium:
    """`equilibrium`: at rest, and all accelerations are zero; `body` as in AtRest."""

    body: str | None
    text: str
    mark: Mark


@record
class JustAfter:
    """`just after 1`: same place and time as state 1; velocities changed by impulses only."""

    state: str
    text: str
    mark: Mark


Statement = Relation | Extreme | AtRest | Equilibrium | JustAfter


@record
class Law:
    """A statement of `motion`, with the span during which it holds (None: always)."""

    statement: Statement
    during: tuple[str, str] | None


@record
class Found:
    """What `find` names: a side or a relation (is it true?), and the unit that is wanted (None: the default)."""

    what: Side | Relation
    unit: str | None
    text: str
    mark: Mark
