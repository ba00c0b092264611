"""What a problem file says, as frozen values: the result of reading, the input of everything else.

Formulas stay syntax trees (`expression.py`); nothing is evaluated here and SymPy is not needed.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from planar_cli.errors import Mark
from planar_cli.problem.language.expression import Found, Law, Number, Side, Statement
from planar_cli.problem.scene.going import Going
from planar_cli.records import record

if TYPE_CHECKING:
    from planar_cli.joints.base import Joint
    from planar_cli.loads.base import Load

GROUND = "ground"
ALL = "all"


@record
class Symbol:
    """A name of `given` (value set), `symbols`, `unknowns` or `coordinates` (unit set). No `distance` is negative."""

    name: str
    value: Side | None
    unit: str | None
    mark: Mark
    distance: bool = False
    written: str = ""
    varies: bool = False
    coefficient: str = ""
    """Of friction or rebound. `written`: as the file has it; where it `varies` the first of its range."""


@record
class At:
    """A point by coordinates."""

    x: Side
    y: Side


@record
class Polar:
    """A point at `distance` from `origin` in the direction `angle`."""

    origin: str
    distance: Side
    angle: Side


@record
class Towards:
    """A point at `distance` from `origin` in the direction of `towards`, and `offset` to the left of that line."""

    origin: str
    towards: str
    distance: Side
    offset: Side | None = None


@record
class Midpoint:
    """The point half-way between two."""

    a: str
    b: str


@record
class TwoFacts:
    """A point by two of: x, y, lines (through a point, at an angle), distances from points. Of two places
    `side` chooses one: left, right, above or below the other place.
    """

    x: Side | None
    y: Side | None
    lines: tuple[tuple[str, Side], ...]
    distances: tuple[tuple[str, Side], ...]
    side: str | None


@record
class Foot:
    """Where a rim about `center` touches an edge through `through`, at `angle` or towards the point `towards`; of one
    that meets it only `later`, the place of the rim that is nearest. `former`: the point where it touches until then,
    which tells the side.
    """

    center: str
    through: str
    angle: Side | None
    towards: str | None
    radii: tuple[Side, ...] = ()
    later: bool = False
    former: str = ""


@record
class Rims:
    """Where two rims touch: circles about `a` and `b`, side by side or one inside the other. Of a body with steps, each
    with its radius, those touch that the places of the centres let touch.
    """

    a: str
    radii_a: tuple[Side, ...]
    b: str
    radii_b: tuple[Side, ...]


@record
class Tip:
    """The one of the ends of a rod, or corners of a plate, on the edge of `on`; without one, the lowest (ground)."""

    body: str
    on: str
    ends: tuple[str, ...]
    plate: Plate | None
    through: str = ""
    angle: Side | None = None
    towards: str | None = None


Place = At | Polar | Towards | Midpoint | TwoFacts | Foot | Rims | Tip


@record
class Point:
    name: str
    place: Place
    mark: Mark
    unnamed: bool = False  # the file writes its place where it is used, and no name for it


@record
class Line:
    through: str
    angle: Side


@record
class Circle:
    center: str
    radius: Side


@record
class Curve:
    """`y: c*x^2` (variable x) or `r: b*theta` (variable theta): `kind` is "y" or "r"."""

    kind: str
    formula: Side


@record
class Surface:
    """`body`: the body that carries it (None: the ground); `speed`: of a belt running along its angle.

    `inferred`: the floor of a file that says only `ground`, on which its bodies stand.
    """

    name: str
    shape: Line | Circle | Curve
    body: str | None
    speed: Side | None
    mark: Mark
    inferred: bool = False


@record
class Particle:
    """`place`: a point's name, coordinates, or None (`free`: from the relations)."""

    place: str | At | None


@record
class Rod:
    """Uniform slender rod: from `start` to `end`, or from `start` in the direction `angle`; `length` if a place is
    open.
    """

    start: str
    end: str | None
    angle: Side | None
    length: Side | None


@record
class Round:
    """`kind`: disk, ring or sphere. `hub`: the radius of a second, concentric step."""

    kind: str
    center: str
    radius: Side
    hub: Side | None


@record
class Sector:
    """Circular sector with its apex at `apex`; `span` is the opening angle, `angle` the direction of its axis."""

    apex: str
    radius: Side
    span: Side
    angle: Side | None


@record
class Plate:
    """Rectangle about its centre; `angle` is the direction of its width."""

    center: str
    width: Side
    height: Side
    angle: Side | None


@record
class Outline:
    """Any other shape: some of its points and, if known, its mass centre.

    `rim`: of a wheel whose mass centre is not that of its rim.
    """

    center: str | None
    rim: Round | None = None


@record
class Piece:
    """A part of a composite; a hole has minus mass. `inertia`, `gyration`: about the part's own mass centre."""

    shape: Shape
    mass: Side | None
    inertia: Side | None
    mark: Mark
    weight: Side | None = None
    gyration: Side | None = None


@record
class Composite:
    pieces: tuple[Piece, ...]


Shape = Particle | Rod | Round | Sector | Plate | Outline | Composite


@record
class Body:
    """`mass`, `weight`: one of them or neither (massless); `any_mass`, `any_inertia`: `any`, must cancel.

    `inertia`, `gyration` replace the uniform value; about the mass centre, or about the point `about`.
    `points`: further named points that belong to the body.
    """

    name: str
    shape: Shape
    mass: Side | None
    weight: Side | None
    any_mass: bool
    inertia: Side | None
    gyration: Side | None
    about: str | None
    points: tuple[str, ...]
    mark: Mark
    any_inertia: bool = False

    @property
    def is_round(self) -> bool:
        """Has it a round rim, itself or as what one of its parts may be?"""
        return isinstance(self.shape, Round | Composite) or self.hub_point is not None

    @property
    def is_disk(self) -> bool:
        """Is it one round body with its mass centre in the middle?"""
        return isinstance(self.shape, Round)

    @property
    def is_particle(self) -> bool:
        return isinstance(self.shape, Particle)

    @property
    def hub_point(self) -> str | None:
        """The centre of a round body."""
        rim = self.shape.rim if isinstance(self.shape, Outline) else self.shape
        return rim.center if isinstance(rim, Round) else None

    @property
    def is_massless(self) -> bool:
        """Is nothing said of its mass?"""
        return self.mass is None and self.weight is None and not self.any_mass

    @property
    def resists_turning(self) -> bool:
        """Has it mass, and no moment of inertia that is written as zero?"""
        return not self.is_massless and not (isinstance(self.inertia, Number) and self.inertia.value == 0)


@record
class State:
    name: str
    relations: tuple[Statement, ...]
    mark: Mark
    before: bool = False
    """Is it an equilibrium that the file lists before the state with which the motion begins?"""
    dated: bool = False  # is it the `instant` of a file, whose time follows from what it says?
    steady: bool = False
    """Is it a time by which the motion has become steady, put in for a state at t = infinity?"""


@record
class Find:
    name: str
    found: Found
    mark: Mark


@record
class Answer:
    """What a key says of one find: a side with unit, a pair of sides (several of a list), a truth value, or
    words.
    """

    name: str
    value: Side | tuple[Side, ...] | bool | str
    tolerance: Side | None
    mark: Mark


@record
class Case:
    """The file with the changes of one case; `problem.find` holds that case's finds only."""

    name: str
    problem: Problem
    mark: Mark


@record
class Problem:
    """A whole problem file. `plane`: vertical, horizontal, or None. `us`: in US units; formulas in ft, slug, s."""

    file: str
    title: str
    text: str
    source: str
    note: str
    plane: str | None
    given: tuple[Symbol, ...]
    symbols: tuple[Symbol, ...]
    unknowns: tuple[Symbol, ...]
    coordinates: tuple[Symbol, ...]
    assume: tuple[Statement, ...]
    points: tuple[Point, ...]
    surfaces: tuple[Surface, ...]
    bodies: tuple[Body, ...]
    joints: tuple[Joint, ...]
    loads: tuple[Load, ...]
    motion: tuple[Law, ...]
    instant: tuple[Statement, ...] | None
    states: tuple[State, ...]
    find: tuple[Find, ...]
    cases: tuple[Case, ...]
    answers: tuple[Answer, ...]
    tolerance: Side | None
    method: str | None
    us: bool
    kinetic_energy: str = "T"  # its letter, the same in all cases: T, where the file calls nothing else so
    strikers: tuple[Joint | Load, ...] = ()
    """Impacts and impulses of the file, in a problem of what acts while time passes."""
    idle: tuple[Joint, ...] = ()
    """Joints of the file that touch only before or after that time: where they would touch, a rim goes on."""
    placed: tuple[str, ...] = ()  # coordinates left open, put somewhere, as the answers are the same wherever they are
    bounded: tuple[tuple[str, str], ...] = ()
    """What is largest or smallest, with the inequality that bounds it: here an equation stands in their place."""
    clockwise: tuple[str, ...] = ()  # of a case: bodies that count clockwise in what was told before of the same file
    turning: tuple[str, ...] = ()  # bodies whose rotation counts clockwise through a motion, as they turn so
    going: tuple[tuple[str, Going], ...] = ()  # bodies that go one way along a straight line through a whole motion
    hidden: frozenset[str] = frozenset()  # names that figures do not show

    def holds_at_first(self, during: tuple[str, str] | None) -> bool:
        """Does what acts `during` a span act as the motion begins, though not before it alone?"""
        if during is None or not self.states:
            return True
        first = self.states[0].name
        return during[0] == first or (during[1] != first and any(s.before and s.name == during[0] for s in self.states))

    def called(self, joint: str) -> str:
        """How the joint of that name is called in a sentence."""
        return next((j.called for j in self.joints if j.name == joint), joint)


def with_article(body: str) -> str:
    """A body in a sentence: the boom, but AB."""
    return f"the {body}" if body.isalpha() and body.islower() and len(body) > 2 else body
