"""A film as one SVG that plays by itself, again and again, without any script (SMIL).

What keeps its shape is drawn once and moved; what does not (springs, ropes) has its strokes told moment by moment.
A viewer without animation shows the beginning.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from xml.etree import ElementTree as ET

from planar_cli.formats._graph import Ticked, in_unit, ticked
from planar_cli.formats._labels import with_labels
from planar_cli.formats._on_paper import Scale, pieces_of
from planar_cli.formats._paper import SIZE, Box, Disc, Paper, Placed, Run, Spot, Stroke, Words, along, box_of
from planar_cli.formats._svg import MARGIN, Look, begun, ended, fill, path_of, px, start_of, write
from planar_cli.formats.html import Html
from planar_cli.records import record
from planar_cli.report.document.blocks import Title
from planar_cli.report.document.film import Film, Thing
from planar_cli.report.document.marks import spots_of

WIDE, HIGH = 560.0, 400.0
"""The field, pixels."""
REST = 0.8
"""So many seconds the end is shown before it begins anew."""
STIFF, STILL = 0.06, 0.02
"""What is off by less keeps its shape, or its place (pixels)."""
BELOW, LEAST_LINE = 40.0, 260.0
"""The line of time: how far below the field, and its length at least."""
TICKS = 45.0
EVEN = 0.05
"""A film whose speed is off by less than this part runs as fast as the motion."""
Shape = Stroke | Disc


@record
class _Track:
    """One stroke, or one disc, through all moments; None while it is not there."""

    shapes: tuple[Shape | None, ...]

    @property
    def known(self) -> list[Shape]:
        """The shape at every moment; while it is not there, one that it has."""
        found: list[Shape] = []
        last = next(s for s in self.shapes if s is not None)
        for shape in self.shapes:
            last = shape or last
            found.append(last)
        return found


@record
class _Label:
    """Words that go with their place: where that is at every moment."""

    words: Words
    anchors: tuple[Spot, ...]


def animated(film: Film, look: Look = "own") -> str:
    """A film as an SVG element."""
    scale = _scale(film)
    tracks, labels = _tracks(film, scale)
    places = [spot for t in tracks for s in t.known for spot in along(s, 40.0)]
    field = box_of(places) or Box(0.0, 0.0, 1.0, 1.0)
    first = Paper(tuple(t.known[0] for t in tracks), tuple(label.words for label in labels))
    texts = with_labels(first, led=False).placed
    for placed, label in zip(texts, labels, strict=True):
        for at in label.anchors:
            dx, dy = at[0] - placed.words.anchor[0], at[1] - placed.words.anchor[1]
            box = placed.box
            field = field.around(Box(box.left + dx, box.top + dy, box.right + dx, box.bottom + dy))
    clock = _Clock(film, (field.left, field.bottom + BELOW), max(field.right - field.left, LEAST_LINE))
    root = begun(film.title, look)
    for track in tracks:
        _draw(root, track, film)
    for placed, label in zip(texts, labels, strict=True):
        _name(root, placed, label, film)
    paper = clock.paper()
    fill(root, paper)
    clock.hand(root)
    below = box_of(spot for s in paper.strokes for spot in along(s, 8.0))
    whole = field.around(below) if below is not None else field
    for placed in paper.placed:
        whole = whole.around(placed.box)
    return ended(root, whole.grown(MARGIN))


def page(film: Film) -> str:
    """A film as one HTML page, which plays without script and without network."""
    html = Html()
    return html.whole(film.title, [html.part([Title(film.title)]), f"<figure>{animated(film, 'page')}</figure>"])


def _scale(film: Film) -> Scale:
    spots = [s for thing in film.things for marks in thing.shots for m in marks for s in spots_of(m)]
    if not spots:
        return Scale(100.0)
    xs, ys = zip(*spots, strict=True)
    wide, high = max(xs) - min(xs), max(ys) - min(ys)
    pixels = min(WIDE / wide if wide else math.inf, HIGH / high if high else math.inf)
    return Scale(pixels if math.isfinite(pixels) else 100.0)


# --- what is on paper, through all moments ----------------------------------------------------------------------------


def _tracks(film: Film, scale: Scale) -> tuple[list[_Track], list[_Label]]:
    tracks: list[_Track] = []
    labels: list[_Label] = []
    for thing in film.things:
        shapes, words = _of_thing(thing, scale)
        tracks += shapes
        labels += words
    return tracks, labels


def _of_thing(thing: Thing, scale: Scale) -> tuple[list[_Track], list[_Label]]:
    """The strokes of a thing by kind and order, and its words."""
    count = len(thing.shots)
    shapes: dict[tuple[type, str, int], list[Shape | None]] = {}
    words: dict[tuple[tuple[Run, ...], int], list[Words | None]] = {}
    for k, marks in enumerate(thing.shots):
        seen: dict[object, int] = {}
        for piece in (p for m in marks for p in pieces_of(m, scale)):
            name = piece.runs if isinstance(piece, Words) else (type(piece), piece.kind)
            place = seen[name] = seen.get(name, -1) + 1
            if isinstance(piece, Words):
                if piece.runs:
                    words.setdefault((piece.runs, place), [None] * count)[k] = piece
            else:
                shapes.setdefault((type(piece), piece.kind, place), [None] * count)[k] = piece
    labels = []
    for told in words.values():
        last = next(w for w in told if w is not None)
        anchors = []
        for one in told:
            last = one or last
            anchors.append(last.anchor)
        labels.append(_Label(next(w for w in told if w is not None), tuple(anchors)))
    return [_Track(tuple(s)) for s in shapes.values()], labels


# --- what is drawn ----------------------------------------------------------------------------------------------------


def _draw(root: ET.Element, track: _Track, film: Film) -> None:
    """One stroke or disc, and how it moves."""
    known = track.known
    first = known[0]
    if isinstance(first, Disc):
        centers = [s.center for s in known if isinstance(s, Disc)]
        element = ET.SubElement(root, "circle", {"r": px(first.radius), "class": f"stroke {first.kind}"})
        _moved(element, centers, film)
    else:
        strokes = [s for s in known if isinstance(s, Stroke)]
        element = ET.SubElement(root, "path", {"class": f"stroke {first.kind}"})
        motion = _rigid(strokes)
        if motion is None:
            count = max(len(s.places) for s in strokes)
            _morphed(element, [path_of(_longer(s, count)) for s in strokes], film)
        else:
            origin = first.places[0]
            own = tuple((x - origin[0], y - origin[1]) for x, y in first.places)
            element.set("d", path_of(Stroke(own, first.kind, first.closed)))
            _moved(element, [s.places[0] for s in strokes], film, motion)
    if None in track.shapes:
        _shown(element, [s is not None for s in track.shapes], film)


def _rigid(strokes: Sequence[Stroke]) -> list[float] | None:
    """By how much a stroke has turned at each moment, in degrees clockwise as SVG counts; None: its shape changes."""
    first = strokes[0].places
    if any(len(s.places) != len(first) for s in strokes):
        return None
    k = max(range(len(first)), key=lambda i: math.dist(first[i], first[0]))
    turns, last = [], 0.0
    for stroke in strokes:
        (x0, y0), (x, y) = stroke.places[0], stroke.places[k]
        angle = math.atan2(y - y0, x - x0) - math.atan2(first[k][1] - first[0][1], first[k][0] - first[0][0])
        last += math.remainder(angle - last, 2 * math.pi)
        cos, sin = math.cos(last), math.sin(last)
        for (a, b), (u, v) in zip(first, stroke.places, strict=True):
            dx, dy = a - first[0][0], b - first[0][1]
            if math.hypot(x0 + cos * dx - sin * dy - u, y0 + sin * dx + cos * dy - v) > STIFF:
                return None
        turns.append(math.degrees(last))
    return turns


def _moved(element: ET.Element, places: Sequence[Spot], film: Film, turns: Sequence[float] = ()) -> None:
    """What is drawn about the origin is at these places, turned so."""
    x, y = places[0]
    element.set("transform", f"translate({px(x)} {px(y)})")
    still = all(math.dist(p, places[0]) < STILL for p in places)
    turning = any(abs(a) > 1e-3 for a in turns)
    if not still:
        values = [f"{px(x)} {px(y)}" for x, y in places]
        _animate(element, "animateTransform", values, film, attributeName="transform", type="translate")
    if turning:
        # Added to the place, whether that stands still or moves.
        told = [px(a) for a in turns]
        _animate(element, "animateTransform", told, film, attributeName="transform", type="rotate", additive="sum")


def _morphed(element: ET.Element, paths: Sequence[str], film: Film) -> None:
    element.set("d", paths[0])
    _animate(element, "animate", paths, film, attributeName="d")


def _shown(element: ET.Element, there: Sequence[bool], film: Film) -> None:
    values = ["visible" if t else "hidden" for t in there]
    element.set("visibility", values[0])
    _animate(element, "animate", values, film, attributeName="visibility", calcMode="discrete")


def _longer(stroke: Stroke, count: int) -> Stroke:
    """With so many places, the last one several times."""
    return Stroke((*stroke.places, *[stroke.places[-1]] * (count - len(stroke.places))), stroke.kind, stroke.closed)


def _animate(element: ET.Element, tag: str, values: Sequence[str], film: Film, **how: str) -> None:
    """Values at the moments of the film; the last one stays for a while."""
    kept = _kept(values)
    begin, end = film.times[0], film.times[-1]
    part = film.seconds / (film.seconds + REST) / (end - begin)
    keys = [*(f"{(film.times[k] - begin) * part:.4f}".rstrip("0").rstrip(".") for k in kept), "1"]
    told = [*(values[k] for k in kept), values[kept[-1]]]
    ET.SubElement(element, tag, {**how, "values": ";".join(told), "keyTimes": ";".join(keys), **_timing(film)})


def _kept(values: Sequence[str]) -> list[int]:
    """The moments that must be told: not those inside a stretch in which nothing changes."""
    inner = range(1, len(values) - 1)
    return [0, *(k for k in inner if not values[k - 1] == values[k] == values[k + 1]), len(values) - 1]


def _timing(film: Film) -> dict[str, str]:
    return {"dur": f"{film.seconds + REST:.3f}s", "repeatCount": "indefinite"}


def _name(root: ET.Element, placed: Placed, label: _Label, film: Film) -> None:
    """Words that go with their place."""
    group = ET.SubElement(root, "g")
    x, y = placed.words.anchor
    left, foot = start_of(placed)
    write(group, placed.words.runs, (left - x, foot - y), placed.words.kind)
    _moved(group, label.anchors, film)


# --- the line of time -------------------------------------------------------------------------------------------------


@record
class _Clock:
    """The time along a line below everything, with the states on it, and a hand that goes along."""

    film: Film
    start: Spot
    length: float

    @property
    def axis(self) -> Ticked:
        """Its ticks."""
        return ticked(self.film.times[0], self.film.times[-1], max(1, int(self.length / TICKS)), tight=True)

    def at(self, t: float) -> Spot:
        """Where a time is on it."""
        begin, end = self.film.times[0], self.film.times[-1]
        return self.start[0] + self.length * (t - begin) / (end - begin), self.start[1]

    def paper(self) -> Paper:
        """The line with its words."""
        axis, (x, y) = self.axis, self.start
        strokes: list[Shape] = [Stroke((self.start, (x + self.length, y)), "measure")]
        words = [Words(self._told(), (x + self.length, y), "axis", (0.0,), 12.0, fixed=True)]
        for tick in axis.ticks:
            at = self.at(tick)
            strokes.append(Stroke((at, (at[0], y + 5.0)), "measure"))
            words.append(Words((Run(axis.told(tick)),), (at[0], y + 5.0), "axis", (-math.pi / 2,), 3.0, fixed=True))
        for name, t in self._states():
            strokes.append(Disc(self.at(t), 3.2, "pin"))
            words.append(Words((Run(name),), self.at(t), "name", (math.pi / 2,), 6.0))
        return with_labels(Paper(tuple(strokes), tuple(words)))

    def _states(self) -> Iterator[tuple[str, float]]:
        """The states; those of nearly one moment together."""
        states = sorted(self.film.states, key=lambda s: s[1])
        names: list[str] = []
        for (name, t), after in pairwise([*states, ("", math.inf)]):
            names.append(name.replace("_", " "))
            if after[1] == math.inf or math.dist(self.at(t), self.at(after[1])) > SIZE / 2:
                yield ", ".join(names), t
                names = []

    def _told(self) -> tuple[Run, ...]:
        """t in s, and how much faster or slower than the motion it is shown."""
        times = (self.film.times[-1] - self.film.times[0]) / self.film.seconds
        more = (
            f", {times:.3g} × as fast"
            if times > 1 + EVEN
            else f", {1 / times:.3g} × slower"
            if times < 1 - EVEN
            else ""
        )
        return Run("t", formula=True), Run(in_unit("s", self.axis.power) + more)

    def hand(self, root: ET.Element) -> None:
        """What goes along the line."""
        hand = ET.SubElement(root, "circle", {"r": "5", "class": "stroke mass"})
        _moved(hand, [self.at(t) for t in self.film.times], self.film)
