"""The sections `points` and `surfaces` of a file."""

from __future__ import annotations

from planar_cli.problem.language.expression import Side
from planar_cli.problem.nodes import reading
from planar_cli.problem.nodes.fields import Fields
from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar, Sequence
from planar_cli.problem.nodes.reading import Report
from planar_cli.problem.scene.scene import (
    At,
    Circle,
    Curve,
    Line,
    Midpoint,
    Place,
    Point,
    Polar,
    Surface,
    Towards,
    TwoFacts,
)

POINT_KEYS = tuple("from distance angle towards offset midpoint x y line on lines distances side".split())
POINT_SLIPS = {
    "across": "write `{from: A, towards: B, distance: l, offset: h}`",
    "length": "write `distance: …`",
    "r": "write `distance: …`",
    "to": "write `towards: …`",
    "toward": "write `towards: …`",
    "direction": "write `angle: …`, or `towards: B`",
    "theta": "write `angle: …`",
    "dx": "write `[x, y]`, or `{from: A, distance: l, angle: 30 deg}`",
    "dy": "write `[x, y]`, or `{from: A, distance: l, angle: 30 deg}`",
    "at": "write the place itself: `A: [0, 0.2 m]`",
    "polar": "write `{from: A, distance: l, angle: 30 deg}`",
    "between": "write `midpoint: [A, B]`",
}
LINE_KEYS = ("through", "angle")
SURFACE_KEYS = ("through", "angle", "center", "radius", "y", "r", "body", "speed")
SIDES = ("left", "right", "above", "below")
POINT_EXAMPLE = "A: [0, 0.2 m]"
POINT_FORMS = (
    "`[x, y]`, `{from: A, distance: l, angle: 30 deg}`, `{from: A, towards: B, distance: l}` "
    "(with `offset: h` to the left of that line), `{midpoint: [A, B]}`, "
    "or two facts of x, y, line: [A, 30 deg], lines: [[A, 30 deg], [B, 120 deg]], distances: {A: l, B: d}"
)
SURFACE_FORMS = (
    "a line `{through: P, angle: 0 deg}`, a circle `{center: O, radius: R}`, a curve `{y: c*x^2}` or `{r: b*theta}`"
)


def read_points(node: Node, report: Report) -> tuple[Point, ...]:
    """All points, in the order of the file."""
    read: list[Point] = []
    for key, value in reading.pairs(node, "points", report, f"points: {{{POINT_EXAMPLE}}}"):
        name = reading.name(key, "a name of a point", report)
        place = _place(value, f"the point {key.text}", report)
        if name:
            read.append(Point(name, place, key.mark))
    return tuple(read)


def coordinates(node: Sequence, report: Report) -> At | None:
    """`[x, y]`; a bare 0 needs no unit."""
    if len(node.items) == 2:
        return At(reading.side(node.items[0], "x", report), reading.side(node.items[1], "y", report))
    report.add(node.mark, "PL320", f"coordinates are two numbers, here are {len(node.items)}", "write `[0, 0.2 m]`")
    return None


def _place(node: Node, what: str, report: Report) -> Place:
    """The place of a point; two facts that are none stand in for one that cannot be read."""
    if isinstance(node, Sequence):
        return coordinates(node, report) or TwoFacts(None, None, (), (), None)
    if isinstance(node, Scalar):
        report.add(node.mark, "PL320", f"{what} has no place that can be read: '{node.text}'", POINT_FORMS)
        return TwoFacts(None, None, (), (), None)
    fields = Fields(node, POINT_KEYS, what, report, POINT_SLIPS)
    if "midpoint" in fields:
        return _midpoint(fields)
    if "from" in fields:
        return _from(fields)
    return _two_facts(fields)


def _alone(fields: Fields, keys: set[str]) -> None:
    """Report keys that do not go together with `keys`."""
    for extra in sorted(fields.present() - keys):
        together = ", ".join(sorted(keys))
        fields.report.add(
            fields.place(extra), "PL321", f"'{extra}' does not go with {together} in {fields.what}", POINT_FORMS
        )


def _midpoint(fields: Fields) -> Midpoint:
    _alone(fields, {"midpoint"})
    a, b = pair_of_names(fields.node("midpoint"), "midpoint: [A, B]", fields.report)
    return Midpoint(a, b)


def pair_of_names(node: Node | None, example: str, report: Report) -> tuple[str, str]:
    """Two names of points; "" for one that cannot be read."""
    if node is None:
        return "", ""
    if not isinstance(node, Sequence) or len(node.items) != 2:
        report.add(node.mark, "PL322", "here stand the names of two points", f"write `{example}`")
        return "", ""
    return reading.name(node.items[0], "a point", report), reading.name(node.items[1], "a point", report)


def _from(fields: Fields) -> Polar | Towards | TwoFacts:
    origin = fields.need_name("from", "a point")
    distance = fields.need_side("distance")
    if fields.present() & {"line", "on"}:
        _alone(fields, {"from", "distance", "line", "on", "side"})
        if "line" in fields and "on" in fields:
            text = f"{fields.what} is fixed by two facts, here are three: a distance and two lines"
            fields.report.add(fields.place("on"), "PL323", text, POINT_FORMS)
        return TwoFacts(None, None, _lines(fields), ((origin, distance),), _side_word(fields))
    if "towards" in fields:
        _alone(fields, {"from", "distance", "towards", "offset"})
        return Towards(origin, fields.need_name("towards", "a point"), distance, fields.side("offset"))
    _alone(fields, {"from", "distance", "angle"})
    return Polar(origin, distance, fields.need_side("angle", "or `towards:` another point"))


def _two_facts(fields: Fields) -> TwoFacts:
    lines, distances = _lines(fields), _distances(fields)
    facts = len(distances) + len(lines) + sum(key in fields for key in ("x", "y"))
    stray = fields.present() & {"distance", "angle", "towards", "offset"}
    if stray:
        fields.report.add(fields.place(min(stray)), "PL321", f"{fields.what} needs the key 'from'", POINT_FORMS)
    elif facts != 2 and fields.readable:
        told = "is one" if facts == 1 else f"are {facts or 'none'}"
        fields.report.add(fields.mark, "PL323", f"{fields.what} is fixed by two facts, here {told}", POINT_FORMS)
    return TwoFacts(fields.side("x"), fields.side("y"), lines, distances, _side_word(fields))


def _side_word(fields: Fields) -> str | None:
    node = fields.node("side")
    if node is None:
        return None
    word = reading.text(node, "side", fields.report)
    if word and word not in SIDES:
        fields.report.add(node.mark, "PL324", f"'{word}' is no side", reading.did_you_mean(word, SIDES, "write "))
    return word if word in SIDES else None


def _lines(fields: Fields) -> tuple[tuple[str, Side], ...]:
    """The lines on which a point is: `line` or `on`, both for a point where two cross, or a list of them, `lines`."""
    nodes = [node for key in ("line", "on") if (node := fields.node(key)) is not None]
    several = fields.node("lines")
    if isinstance(several, Sequence):
        nodes += several.items
    elif several is not None:
        hint = "write `lines: [[A, 30 deg], [B, 120 deg]]`"
        fields.report.add(several.mark, "PL322", "lines are a list, each a point and an angle", hint)
    return tuple(_line(node, fields) for node in nodes)


def _line(node: Node, fields: Fields) -> tuple[str, Side]:
    if isinstance(node, Mapping):
        inner = Fields(node, LINE_KEYS, f"the line of {fields.what}", fields.report)
        return inner.need_name("through", "a point"), inner.need_side("angle")
    if not isinstance(node, Sequence) or len(node.items) != 2:
        fields.report.add(node.mark, "PL322", "a line is a point and an angle", "write `line: [A, 30 deg]`")
        return "", reading.unreadable(node.mark)
    return reading.name(node.items[0], "a point", fields.report), reading.side(node.items[1], "angle", fields.report)


def _distances(fields: Fields) -> tuple[tuple[str, Side], ...]:
    node = fields.node("distances")
    if node is None:
        return ()
    return tuple(
        (reading.name(key, "a point", fields.report), reading.side(value, "distance", fields.report))
        for key, value in reading.pairs(node, "distances", fields.report, "distances: {A: l, B: d}")
    )


def read_surfaces(node: Node, report: Report) -> tuple[Surface, ...]:
    """All surfaces, in the order of the file."""
    read: list[Surface] = []
    for key, value in reading.pairs(node, "surfaces", report, "surfaces: {floor: {through: P, angle: 0 deg}}"):
        name = reading.name(key, "a name of a surface", report)
        fields = Fields(value, SURFACE_KEYS, f"the surface {key.text}", report)
        shape = _surface_shape(fields)
        if name:
            body = fields.name("body", "a body")
            read.append(Surface(name, shape, body, fields.side("speed"), key.mark))
    return tuple(read)


def _surface_shape(fields: Fields) -> Line | Circle | Curve:
    kinds = [key for key in ("through", "center", "y", "r") if key in fields]
    if len(kinds) != 1:
        if fields.readable:
            fields.report.add(
                fields.mark, "PL325", f"{fields.what} has one shape, here are {len(kinds)}", SURFACE_FORMS
            )
        return Line("", reading.unreadable(fields.mark))
    kind = kinds[0]
    own = {"through": {"through", "angle"}, "center": {"center", "radius"}, "y": {"y"}, "r": {"r"}}[kind]
    for extra in sorted(fields.present() - own - {"body", "speed"}):
        fields.report.add(fields.place(extra), "PL325", f"'{extra}' does not go with '{kind}'", SURFACE_FORMS)
    if kind == "through":
        return Line(fields.need_name("through", "a point"), fields.need_side("angle"))
    if kind == "center":
        return Circle(fields.need_name("center", "a point"), fields.need_side("radius"))
    return Curve(kind, fields.need_side(kind))
