"""What a lecturer draws under the faces of a wedge or a carrier, down to what it stands on."""

from __future__ import annotations

import math
from collections.abc import Sequence

from planar_cli.figures.rings import Ring, around, left_of, off
from planar_cli.records import record
from planar_cli.report.document.marks import Spot

LEVEL = math.radians(8)
"""A face that rises by less than this above what the body stands on is a deck."""


@record
class Face:
    """A straight face: through `at` along `angle`, with the body on the left; `spots`: what touches it."""

    at: Spot
    angle: float
    spots: tuple[Spot, ...]
    by: frozenset[str]


@record
class Known:
    """What a file tells of a body, as seen from what it stands on (turned by -`turned`): its own points, its mass
    centre, its faces, the level of what it stands on (None: beneath all of it), and how far an outline goes beyond.
    """

    turned: float
    own: tuple[Spot, ...]
    center: Spot | None
    faces: tuple[Face, ...]
    floor: float | None
    margin: float


def standing(known: Known) -> list[Ring]:
    """What lies under the faces of a body down to what it stands on; each wall on it has an outline of its own."""
    m, faces = known.margin, known.faces
    decks = [f for f in faces if abs(math.sin(f.angle)) < math.sin(LEVEL)]
    walls = [f for f in faces if f not in decks and any(_is_wall(f, d, m) for d in decks)]
    edges = [f for f in faces if f not in walls]
    low = _lowest(known)
    places: Ring = [*known.own, *_round_centre(known, low)]
    if not faces:
        places += [(x + i * m, y + j * m) for x, y in known.own for i in (-1, 1) for j in (-1, 1)]
    for face in edges:
        places += _deck(face, known, low) if face in decks else _slope(face, known, low)
    places += [(p[0] + i * m, _top(decks, p)) for w in walls for p in (w.at, *w.spots) for i in (-1, 1)]
    ring = around([*places, *((x, low) for x, _ in places)])
    for face in edges:
        ring = left_of(ring, face.at, face.angle)
    ring = left_of(ring, (0.0, low), 0.0)
    return [ring, *(_wall(w, decks, known) for w in walls)]


def _is_wall(face: Face, deck: Face, margin: float) -> bool:
    """Does a face stand on a deck, so that what lies on the deck can come to it?"""
    return bool(face.by & deck.by) or face.at[1] > _top([deck], face.at) + margin / 9


def _round_centre(known: Known, low: float) -> Ring:
    """The corners of a box round the mass centre, within what other points of the body tell of its length."""
    if known.center is None:
        return []
    m, (x, y) = known.margin, known.center
    wide = max(m, 0.4 * (y - low)) if known.floor is not None and not known.faces else m
    others = [p[0] for p in known.own if math.dist(p, known.center) > 1e-9]
    left, right = min([x, *others]), max([x, *others])
    if not others:
        left, right = x - wide, x + wide
    return [(a, b) for a in (left, right) for b in (max(y - m, low), y + m)]


def _lowest(known: Known) -> float:
    """The level of what a body stands on."""
    if known.floor is not None:
        return known.floor
    m, center = known.margin, known.center
    ends = [y for x, y in known.own if center is None or math.dist((x, y), center) > 1e-9]
    spots = [y - m for f in known.faces for _, y in (f.at, *f.spots) if (f.at[0], y) not in known.own]
    low = min([*ends, *spots, *([center[1] - m] if center else [])], default=0.0)
    on_faces = all(any(off(f.at, f.angle, p) < 1e-9 for f in known.faces) for p in known.own if p != center)
    deep = center is not None or any(abs(math.sin(f.angle)) > math.sin(LEVEL) for f in known.faces)
    return low if deep and not (on_faces and center is None) else low - m


def _deck(face: Face, known: Known, low: float) -> Ring:
    """A deck reaches as far to one side of the mass centre as to the other."""
    m, xs = known.margin, [x for x, _ in (face.at, *face.spots, *known.own)]
    if known.center is not None:
        reach = max(max(abs(x - known.center[0]) for x in xs) + m, (face.at[1] - low) / 2)
        xs = [known.center[0] - reach, known.center[0] + reach]
        m = 0.0
    low, high = min(xs) - m, max(xs) + m
    return [(x, face.at[1] + (x - face.at[0]) * math.tan(face.angle)) for x in (low, high)]


def _slope(face: Face, known: Known, low: float) -> Ring:
    """A slope, from what the body stands on up to the highest thing on it, and a little beyond if that moves."""
    up = face.angle if math.sin(face.angle) > 0 else face.angle + math.pi
    sin, cos = math.sin(up), math.cos(up)
    ends = [(p[1] - face.at[1]) / sin for p in known.own if off(face.at, face.angle, p) < 1e-6]
    moving = [(p[1] - face.at[1]) / sin for p in face.spots]
    top = max([*ends, *(t + 1.5 * known.margin for t in moving if not ends or t > max(ends) - 1e-9)])
    if not ends and len(known.faces) == 1 and known.center is not None and abs(cos) > 0.05:
        # Of a wedge the mass centre is a third of its length from its back.
        tip = face.at[0] + (low - face.at[1]) / sin * cos
        back = max(1.5 * abs(known.center[0] - tip), abs(known.center[0] - tip) + 2 * known.margin)
        top = max(top, (tip + math.copysign(back, cos) - face.at[0]) / cos)
    return [(face.at[0] + t * cos, face.at[1] + t * sin) for t in ((low - face.at[1]) / sin, top)]


def _top(decks: Sequence[Face], at: Spot) -> float:
    return decks[0].at[1] + (at[0] - decks[0].at[0]) * math.tan(decks[0].angle)


def _wall(face: Face, decks: Sequence[Face], known: Known) -> Ring:
    """A wall on a deck, on the far side of what comes to it."""
    m, (x, y) = known.margin, face.at
    foot = _top(decks, face.at)
    up = face.angle if math.sin(face.angle) > 0 else face.angle + math.pi
    side = 1.0 if math.sin(face.angle) < 0 else -1.0
    high = max(y, foot) + m
    lean = math.cos(up) / math.sin(up)
    inner = [(x + (h - y) * lean, h) for h in (foot, high)]
    return around([*inner, *((a + side * m / 2, h) for a, h in inner)])
