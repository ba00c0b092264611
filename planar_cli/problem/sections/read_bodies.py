"""The section `bodies` of a file."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from planar_cli.errors import Mark
from planar_cli.problem.language.expression import Name, Number
from planar_cli.problem.nodes import reading
from planar_cli.problem.nodes.fields import Fields
from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar, Sequence
from planar_cli.problem.nodes.reading import NAME, Report
from planar_cli.problem.scene.scene import (
    Body,
    Composite,
    Outline,
    Particle,
    Piece,
    Plate,
    Rod,
    Round,
    Sector,
    Shape,
)
from planar_cli.problem.sections.read_points import coordinates

SHAPE_KEYS: dict[str, tuple[str, ...]] = {
    "particle": (),
    "rod": ("length",),
    "disk": ("radius", "hub", "center"),
    "ring": ("radius", "hub", "center"),
    "sphere": ("radius", "hub", "center"),
    "sector": ("radius", "span", "angle"),
    "plate": ("width", "height", "angle"),
    "parts": (),
    "points": ("center",),
}
MASS_KEYS = ("mass", "weight", "inertia", "radius_of_gyration")
BODY_KEYS = (
    *SHAPE_KEYS,
    "radius",
    "hub",
    "length",
    "span",
    "angle",
    "width",
    "height",
    "center",
    *MASS_KEYS,
    "about",
)
PIECE_KEYS = tuple(key for key in BODY_KEYS if key not in ("parts", "about"))
SHAPE_FORMS = (
    "`particle: P`, `rod: [A, B]`, `disk: G`, `ring: G`, `sphere: G`, `sector: O`, `plate: G`, "
    "`points: [A, B]` with `center: G`, or `parts: [{…}, {…}]`"
)
_ROUND, _BOX = "a {} is `disk: G` with `radius`", "a {} is `plate: G` with `width` and `height`"
_LONG, _SMALL = "a uniform {} is `rod: [A, B]`", "`particle: P` for a body without size"
SHAPE_SLIPS = {
    **{w: _ROUND.format(w) for w in ("circle", "wheel", "cylinder", "pulley", "gear", "drum", "spool", "roller")},
    **{w: _BOX.format(w) for w in ("rectangle", "square", "panel")},
    **{w: f"a {w} is a `particle: P`, or a `plate: G` with `width` and `height`" for w in ("block", "box", "crate")},
    **{w: _LONG.format(w) for w in ("bar", "beam", "stick", "link", "pole")},
    **dict.fromkeys(("point", "point_mass", "mass_point"), _SMALL),
    "ball": "a ball is `sphere: G` with `radius`, or a `particle: P`",
    "hoop": "a hoop is `ring: G` with `radius`",
    "semicircle": "a semicircle is `sector: O` with `radius` and `span: 180 deg`",
    "half_disk": "half a disk is `sector: O` with `radius` and `span: 180 deg`",
    "composite": "a body of several parts is `parts: [{…}, {…}]`",
}
"""The usual names of shapes, with how they are written."""
_INERTIA = "write `inertia: 2 kg*m^2`, about the mass centre, or with `about: A`"
_GYRATION = "write `radius_of_gyration: 0.2 m`"
SLIPS = SHAPE_SLIPS | {
    "density": "give `mass` or `weight`",
    **dict.fromkeys(("I", "I_G", "J", "J_G"), _INERTIA),
    **dict.fromkeys(("moment_of_inertia", "mass_moment_of_inertia", "rotational_inertia"), "did you mean 'inertia'?"),
    **dict.fromkeys(("k", "k_G"), _GYRATION),
    **dict.fromkeys(("gyration", "gyration_radius", "k_gyration"), "did you mean 'radius_of_gyration'?"),
    "m": "write `mass: 5 kg`",
    "W": "write `weight: 100 N`",
    **dict.fromkeys(("type", "shape"), SHAPE_FORMS.replace("…", "...")),
}


def read_bodies(node: Node, report: Report, numbers: frozenset[str]) -> tuple[Body, ...]:
    """All bodies, in the order of the file; in `rod: [A, beta]` a name out of `numbers` is an angle, not a point."""
    read: list[Body] = []
    for key, value in reading.pairs(node, "bodies", report, "bodies: {AB: {rod: [A, B], mass: 2 kg}}"):
        name = reading.name(key, "a name of a body", report)
        fields = Fields(value, BODY_KEYS, f"the body {key.text}", report, SLIPS, "{rod: [A, B], mass: 2 kg}")
        shape = _settled(_shape(fields), numbers, key.mark)
        if name:
            read.append(_body(name, shape, fields, key))
    return tuple(read)


def _body(name: str, shape: Shape, fields: Fields, key: Scalar) -> Body:
    any_mass, any_inertia = _is_any(fields, "mass"), _is_any(fields, "inertia")
    mass = None if any_mass else fields.side("mass")
    weight = fields.side("weight")
    if "mass" in fields and weight is not None:
        fields.report.add(
            fields.place("weight"), "PL332", f"{fields.what} has both mass and weight", "give one of them"
        )
    inertia = None if any_inertia else fields.side("inertia")
    gyration = fields.side("radius_of_gyration")
    # What is light has none; with an inertia it is still hard to turn.
    mass, weight = (None if isinstance(x, Number) and x.value == 0 else x for x in (mass, weight))
    if "inertia" in fields and gyration is not None:
        fields.report.add(
            fields.place("radius_of_gyration"),
            "PL332",
            f"{fields.what} has both inertia and radius_of_gyration",
            "give one",
        )
    about = fields.name("about", "a point")
    if about is not None and inertia is None and gyration is None:
        fields.report.add(
            fields.place("about"), "PL333", "'about' says about which point the inertia is taken; there is no inertia"
        )
    return Body(
        name, shape, mass, weight, any_mass, inertia, gyration, about, _names(fields, "points"), key.mark, any_inertia
    )


def _settled(shape: Shape, numbers: frozenset[str], mark: Mark) -> Shape:
    """`rod: [A, beta]` is read as two points first; `beta` is an angle where it is the name of a number."""
    if isinstance(shape, Rod) and shape.end in numbers and shape.end is not None:
        return replace(shape, end=None, angle=Name(shape.end, None, mark))
    if isinstance(shape, Composite):
        pieces = (replace(piece, shape=_settled(piece.shape, numbers, piece.mark)) for piece in shape.pieces)
        return Composite(tuple(pieces))
    return shape


def _is_any(fields: Fields, key: str) -> bool:
    node = fields.node(key)
    return isinstance(node, Scalar) and node.text == "any"


def _names(fields: Fields, key: str) -> tuple[str, ...]:
    node = fields.node(key)
    if node is None:
        return ()
    return tuple(
        reading.name(n, "a point", fields.report) for n in reading.items(node, key, fields.report, "points: [A, B]")
    )


def _shape(fields: Fields) -> Shape:
    """The one shape of a body or piece; what belongs to no other shape is refused."""
    kinds = [key for key in SHAPE_KEYS if key in fields and key != "points"]
    if len(kinds) > 1 or not (kinds or "points" in fields):
        if fields.readable and (kinds or not _is_told_otherwise(fields)):
            many = f"here are {' and '.join(kinds)}" if kinds else "here is none"
            fields.report.add(fields.mark, "PL330", f"{fields.what} has one shape, {many}", SHAPE_FORMS)
        return Outline(None)
    kind = kinds[0] if kinds else "points"
    _refuse_strangers(fields, kind)
    return _SHAPES[kind](fields)


def _is_told_otherwise(fields: Fields) -> bool:
    """Is one of the keys that are not allowed meant for the shape?"""
    return any(map(_is_shape, fields.refused))


def _is_shape(key: str) -> bool:
    """Is a key that is not allowed meant for a shape, as its own error says?"""
    word = key.lower()
    if word in SLIPS:
        return word in SHAPE_SLIPS or word in ("type", "shape")
    return reading.close_to(key, BODY_KEYS) in SHAPE_KEYS


def _refuse_strangers(fields: Fields, kind: str) -> None:
    own = {kind, "points", "about", *SHAPE_KEYS[kind], *MASS_KEYS}
    for extra in sorted(fields.present() - own):
        fields.report.add(
            fields.place(extra),
            "PL331",
            f"'{extra}' does not go with '{kind}' in {fields.what}",
            _meant(kind, extra),
        )


def _meant(kind: str, extra: str) -> str:
    """What may be meant by a key that does not go with the shape."""
    if extra == "center":
        return "any other shape, with its mass centre: `points: [A, B], center: G`"
    if kind == "points" and extra in ("radius", "hub"):
        return "a wheel is `disk: O, radius: R`, with `center: G` where its mass centre is not its middle"
    return ""


def _particle(fields: Fields) -> Particle:
    node = fields.node("particle")
    if isinstance(node, Sequence):
        return Particle(coordinates(node, fields.report) or "")
    if node is None or (isinstance(node, Scalar) and node.text == "free"):
        return Particle(None)
    return Particle(reading.name(node, "a point, `[x, y]` or `free`", fields.report))


def _rod(fields: Fields) -> Rod:
    node = fields.need("rod")
    length = fields.side("length")
    if not isinstance(node, Sequence) or len(node.items) != 2:
        fields.report.add(
            fields.place("rod"), "PL322", "a rod is given by two points", "`rod: [A, B]` or `[A, 30 deg]`"
        )
        return Rod("", "", None, length)
    start = reading.name(node.items[0], "a point", fields.report)
    end = node.items[1]
    if isinstance(end, Scalar) and NAME.fullmatch(end.text):
        if end.text == start:
            text = f"a rod is given by two points, and both are {start}"
            fields.report.add(end.mark, "PL322", text, "`rod: [A, B]` or `[A, 30 deg]`")
        return Rod(start, end.text, None, length)
    if length is None and {"mass", "weight"} & fields.present():
        fields.need_side("length", "or name the other end: half of it leads to the mass centre")
    return Rod(start, None, reading.side(end, "angle", fields.report), length)


def _round(kind: str, fields: Fields) -> Round | Outline:
    """A wheel that nothing touches needs no radius: its inertia is told, or must cancel as that of any other shape."""
    if not {"radius", "hub"} & fields.present():
        return Outline(fields.need_name(kind, "a point"))
    found = Round(kind, fields.need_name(kind, "a point"), fields.need_side("radius"), fields.side("hub"))
    center = fields.name("center", "a point")
    return found if center in (None, found.center) else Outline(center, found)


def _sector(fields: Fields) -> Sector:
    return Sector(
        fields.need_name("sector", "a point"),
        fields.need_side("radius"),
        fields.need_side("span"),
        fields.side("angle"),
    )


def _plate(fields: Fields) -> Plate:
    return Plate(
        fields.need_name("plate", "a point"),
        fields.need_side("width"),
        fields.need_side("height"),
        fields.side("angle"),
    )


def _outline(fields: Fields) -> Outline:
    return Outline(fields.name("center", "a point"))


def _composite(fields: Fields) -> Composite:
    node = fields.need("parts")
    if node is None:
        return Composite(())
    example = "parts: [{disk: A, radius: 2 m, mass: 3 kg}, {rod: [A, B], mass: 1 kg}]"
    return Composite(tuple(_piece(item, fields) for item in reading.items(node, "parts", fields.report, example)))


def _piece(node: Node, whole: Fields) -> Piece:
    fields = Fields(node, PIECE_KEYS, f"a part of {whole.what}", whole.report, SLIPS)
    shape = _shape(fields) if isinstance(node, Mapping) else Outline(None)
    if isinstance(shape, Outline) and shape.rim is not None:
        text = f"the mass centre of {fields.what} is that of its shape"
        hint = f"give the {shape.rim.kind} no mass, and its mass to a part `{{particle: {shape.center}}}` beside it"
        fields.report.add(
            fields.place("center"), "PL331", text, f"{hint}, with `radius_of_gyration` for the whole body"
        )
    heavy, told = {"mass", "weight"} & fields.present(), {"inertia", "radius_of_gyration"} & fields.present()
    if isinstance(shape, Outline) and heavy and not told and not _is_told_otherwise(fields):
        wheel = {"disk", "ring", "sphere"} & fields.present()
        text = f"{fields.what} is of no shape that tells its moment of inertia"
        fields.report.add(node.mark, "PL311", text, f"give {'its `radius`' if wheel else 'its `inertia`'}")
    return Piece(
        shape,
        fields.side("mass"),
        fields.side("inertia"),
        node.mark,
        weight=fields.side("weight"),
        gyration=fields.side("radius_of_gyration"),
    )


_SHAPES: dict[str, Callable[[Fields], Shape]] = {
    "particle": _particle,
    "rod": _rod,
    "disk": lambda fields: _round("disk", fields),
    "ring": lambda fields: _round("ring", fields),
    "sphere": lambda fields: _round("sphere", fields),
    "sector": _sector,
    "plate": _plate,
    "points": _outline,
    "parts": _composite,
}
