"""What joints and loads may state about a scene: the closed vocabulary from which principles make equations.

A joint says which relative motion it forbids (`Joining`, `Row`), through which unknown pushes it forbids it (`Push`),
and in which modes it may be (`Mode`: stick or slip, taut or slack, touching or apart), each with the tests that its
assumption must pass. A load says what it does (`Wrench`). Numbers here are exact expressions in SI units; vectors are
in the fixed frame, x right, y up, rotation positive counterclockwise.
"""

from __future__ import annotations

from typing import Any

from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record


@record
class Anchor:
    """The material point of `body` that is now at `point`."""

    body: str
    point: Vec


@record
class Path:
    """The curve, fixed in the base body, along which a point slides.

    `tangent`: unit vector. `curvature` [1/m]: positive when the curve bends to the left of the tangent.
    """

    tangent: Vec
    curvature: Any


@record
class Rolling:
    """Two outlines that touch without slip: their signed curvatures [1/m] along the same `tangent`."""

    tangent: Vec
    mover: Any
    base: Any


@record
class Joining:
    """How `mover` is carried by `base` at one point.

    The mover's material point at `point` has the velocity of the base's point there, plus a slide along `path` (None:
    no slide), plus `drift` (a vector: the speed of a running belt's surface). `turns`: may the mover turn relative to
    the base? `place`: the point's name in print. `rolling`: contact without slip between outlines, whose points of
    contact differ in their normal acceleration. `pace`: what is added to the acceleration besides (None: nothing).
    `keeps`: does a base that is a particle keep the mover from turning? Its surfaces do not turn. `far`: the name of
    the base's own point, where the two are tied over a distance; "" where they meet.
    """

    joint: str
    mover: str
    base: str
    point: Vec
    place: str
    path: Path | None = None
    turns: bool = True
    rolling: Rolling | None = None
    drift: Vec | None = None
    pace: Vec | None = None
    keeps: bool = False
    far: str = ""

    @property
    def only_turns(self) -> bool:
        """Do the bodies turn about one point of both?"""
        return self.path is None and self.rolling is None and self.drift is None


@record
class Pull:
    """direction · (velocity of the anchor): one part of a scalar relation."""

    anchor: Anchor
    direction: Vec


@record
class Segment:
    """A straight free part of a rope or a link, from one anchor to the other.

    `length` None: it keeps its direction. `radii`: where it leaves pulleys, the anchors are their centres.
    """

    start: Anchor
    end: Anchor
    direction: Vec
    length: Any | None


@record
class Row:
    """A scalar relation between velocities, Σ pulls + Σ factor · ω(body) = rate, and its derivative.

    The derivative has the same coefficients on the accelerations, and for every segment of finite length the term
    (relative velocity across it)² / length; it equals `pace`, the rate of `rate`. `title`: the relation in words.
    Where a coefficient is the curvature of a curve, it changes along it: `sharpening` times the square of the velocity
    Σ `slides` goes off the derivative.
    """

    joint: str
    title: str
    pulls: tuple[Pull, ...] = ()
    spins: tuple[tuple[str, Any], ...] = ()
    rate: Any = 0
    segments: tuple[Segment, ...] = ()
    pace: Any = 0
    slides: tuple[Pull, ...] = ()
    sharpening: Any = 0


@record
class Action:
    """What a unit of a push does to one body: a force at a point (force None: none), and a couple."""

    body: str
    point: Vec
    force: Vec | None
    couple: Any = 0


def opposed(body: str, other: str, point: Vec, force: Vec | None, couple: Any = 0) -> tuple[Action, Action]:
    """What a unit of a push between two bodies does at a place: to the one, and equal and opposite to the other."""
    back = -force if force is not None else None
    return Action(body, point, force, couple), Action(other, point, back, -couple)


def relative(body: str, other: str, point: Vec, direction: Vec) -> tuple[Pull, Pull]:
    """The velocity of a place of a body along a direction, relative to the other body's at the same place."""
    return Pull(Anchor(body, point), direction), Pull(Anchor(other, point), -direction)


@record
class Push:
    """An unknown scalar reaction: its name, its unit ("N" or "N*m"), and what it does to each body.

    `kind`: normal, friction, component, tension, couple. `place`: the point or joint it is named after. `like`: another
    push, of the same size; "": it has its own. `member`: the body along which it pulls, with such a push at each end.
    """

    name: str
    kind: str
    joint: str
    place: str
    actions: tuple[Action, ...]
    unit: str = "N"
    like: str = ""
    member: str = ""


@record
class Law:
    """A push that follows another one: `push` = factor · `of` (kinetic friction), or = factor when `of` is None."""

    push: str
    factor: Any
    of: str | None


@record
class Wrench:
    """A load on one body: a force at a point and a couple.

    `name` of the load, `kind` its word on the shelf (or skid: friction of a fixed size; momentum: what a body brings to
    a blow). `place`: the name of the point in print, where it is not to be found among the points of the file.
    """

    name: str
    kind: str
    body: str
    point: Vec
    force: Vec | None
    couple: Any = 0
    magnitude: Any = 0
    place: str = ""


@record
class Skid:
    """Dry friction of a fixed size on `body` at a point, against its velocity over `base`."""

    joint: str
    body: str
    base: str
    point: Vec
    size: Any


@record
class Effect:
    """How the effects of a scene are listed: what a load brings, and what is said of a scene without it."""

    words: str
    """What it is called where it acts."""
    absent: str = ""
    """What it is called in the list of what does not act; "" where that is not worth saying."""
    rank: int = 9
    """Its place in these lists, from what is always there to what is rare."""


FAR = "far"
"""The mode of an impact whose bodies are apart: they do not strike each other in this blow."""


@record
class Test:
    """A condition that an assumption must pass: Σ coefficient · push + constant ≥ 0, or > 0 when strict.

    `within`: pushes at right angles whose resultant may not exceed the constant. Instead of pushes it may measure an
    acceleration: sense · (that of the row), or sense · (that across the path of the joining, along k × tangent).
    """

    joint: str
    words: str
    pushes: tuple[tuple[str, Any], ...] = ()
    constant: Any = 0
    row: Row | None = None
    joining: Joining | None = None
    sense: int = 1
    strict: bool = False
    within: tuple[str, ...] = ()


@record
class Facts:
    """All that a joint states in one of its modes. `idle`: loads, by the key of their modes, that do not act."""

    joinings: tuple[Joining, ...] = ()
    rows: tuple[Row, ...] = ()
    pushes: tuple[Push, ...] = ()
    laws: tuple[Law, ...] = ()
    skids: tuple[Skid, ...] = ()
    idle: tuple[str, ...] = ()


@record
class Mode:
    """One way in which a joint may act.

    `name`: stick, slip, apart, tip, taut, slack, or "" of a joint without modes. `sliding`: the row that measures the
    speed of slip; `direction`: 0 when it must be zero, ±1 the sign that it has or is about to take. `words`: the
    assumption as a sentence. `touching`: what still holds of the velocities at this instant where a contact is about to
    part, a face to tip, a rope to slacken. `side`: where the drawing leaves it open on which side of its partner a body
    presses, +1 or -1 for the side of this mode; else 0. `where`: that side in words, `inside loop`; else "".
    """

    name: str
    words: str
    facts: Facts
    tests: tuple[Test, ...] = ()
    sliding: Row | None = None
    direction: int = 0
    touching: Facts = Facts()
    side: int = 0
    where: str = ""

    @property
    def parted(self) -> bool:
        """Does the joint state nothing but that it has just held: apart, slack?"""
        return self.facts == Facts() and self.touching != Facts()


@record
class Outline:
    """The shape of a body or surface at a point of contact.

    `kind`: corner, straight or arc (also a curve, by its circle of curvature). `tangent`: unit vector (None at a
    corner). `curvature`: signed along the tangent; `sharpening`: how it changes along it [1/m²]. `center`: of the arc,
    None otherwise. `body`: who carries it.
    `curve`: the surface whose curve y(x) or r(theta) it is.
    `drift`: the belt's surface velocity or None. `extent`: for a straight edge the distances of its ends from the
    point, behind and ahead. `floor`: what touches it stands on it, and does not hang below. `on_line`: a point of a
    straight surface.
    """

    kind: str
    body: str
    tangent: Vec | None = None
    curvature: Any = 0
    center: Vec | None = None
    center_name: str = ""
    drift: Vec | None = None
    extent: tuple[Any, Any] | None = None
    curve: str = ""
    sharpening: Any = 0
    floor: bool = False
    on_line: Vec | None = None


@record
class Meeting:
    """Where two bodies strike each other: the point, and the unit normal from the first to the second. `told`: does the
    drawing tell on which side each of them is?
    """

    point: Vec
    normal: Vec
    told: bool


def center_of(outline: Outline, place: Vec) -> Vec | None:
    """The centre of an arc, or of a curve's circle of curvature; a corner is its own; None for a straight edge."""
    if outline.kind == "corner":
        return place
    if outline.kind == "straight" or outline.tangent is None:
        return None
    return outline.center if outline.center is not None else place + outline.tangent.turned() / outline.curvature
