"""Figures as SVG, written by the standard library, which escapes every word."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import replace
from hashlib import sha256
from typing import Literal
from xml.etree import ElementTree as ET

from planar_cli.formats._labels import with_labels
from planar_cli.formats._on_paper import Scale, on_paper, world_box
from planar_cli.formats._paper import (
    SIZE,
    SMALL,
    Box,
    Disc,
    Paper,
    Placed,
    Run,
    Spot,
    Stroke,
    along,
    box_of,
    runs_of,
    width_of,
)
from planar_cli.records import record
from planar_cli.report.document.marks import Figure, spots_of

SPACE = "http://www.w3.org/2000/svg"
WIDE, HIGH = 400.0, 300.0
"""A panel is drawn so large, to scale, at most; of several panels each has its part of the width."""
FARTHEST = 1e5
"""What is farther from zero, px, is drawn as seen from a place of its own: a viewer counts with few digits."""
PART = (1.0, 0.7, 0.55, 0.45)
MARGIN, BETWEEN, HEADED, NOTED = 8.0, 46.0, 24.0, 26.0
LIGHT = {
    "ink": "#1b1b1b",
    "faint": "#6d6d6d",
    "body": "#e9edf3",
    "force": "#b3261e",
    "inertia": "#1555a5",
    "velocity": "#1e7d32",
    "accel": "#8a4b00",
    "fifth": "#7b1fa2",
    "paper": "#ffffff",
}
DARK = {
    "ink": "#e8e8e8",
    "faint": "#9a9a9a",
    "body": "#2c3440",
    "force": "#ff8a80",
    "inertia": "#82b1ff",
    "velocity": "#81c784",
    "accel": "#ffb74d",
    "fifth": "#ce93d8",
    "paper": "#111418",
}
RULES = """
.stroke{fill:none;stroke:var(--ink);stroke-width:1.2;stroke-linejoin:round;stroke-linecap:round}
.area{fill:var(--body);fill-opacity:.75}.bar{stroke-width:4.5}.slim{stroke-width:8.5}.core{stroke:var(--body);stroke-width:6.5}.lane{stroke:var(--faint);stroke-width:21;stroke-linecap:butt}.lane.core{stroke:var(--paper);stroke-width:19}.thin{stroke-width:.9;fill:none}
.hidden,.dashed{stroke-dasharray:4 3}.ground{stroke-width:1.6}.hatch{stroke:var(--faint);stroke-width:.8}
.leader{stroke:var(--faint);stroke-width:.6}.rope{stroke-width:1.6}
.chain{stroke-dasharray:12 3 2 3;stroke-width:1}
.gap{fill:var(--paper);stroke:none}.way{stroke:var(--faint);stroke-dasharray:6 4;stroke-width:1}
.spring{stroke-width:1.3}.pin,.centre{fill:var(--paper)}.mass,.dot{fill:var(--ink)}
.support{fill:var(--paper)}.measure{stroke:var(--faint);stroke-width:.8}.axis{stroke:var(--faint)}
.force{stroke:var(--force);stroke-width:1.8}.inertia{stroke:var(--inertia);stroke-width:1.8}
.velocity{stroke:var(--velocity);stroke-width:1.8}.acceleration{stroke:var(--accel);stroke-width:1.8}
.head{stroke-width:.6}.force.head{fill:var(--force)}.inertia.head{fill:var(--inertia)}
.velocity.head{fill:var(--velocity)}.acceleration.head{fill:var(--accel)}.measure.head{fill:var(--faint)}
.axis.head{fill:var(--faint)}
.grid{stroke:var(--faint);stroke-width:.5;stroke-opacity:.35}.curve{stroke-width:1.7}.jump{stroke-width:.7}.total{stroke-width:1.2}
.c0{stroke:var(--inertia)}.c1{stroke:var(--force)}.c2{stroke:var(--velocity)}.c3{stroke:var(--accel)}.c4{stroke:var(--fifth)}
.words{font-family:"DejaVu Sans","Segoe UI",Helvetica,Arial,sans-serif;fill:var(--ink);stroke:none}
.force-words{fill:var(--force)}.inertia-words{fill:var(--inertia)}.axis-words{fill:var(--faint)}
.c0-words{fill:var(--inertia)}.c1-words{fill:var(--force)}.c2-words{fill:var(--velocity)}.c3-words{fill:var(--accel)}.c4-words{fill:var(--fifth)}
.velocity-words{fill:var(--velocity)}.acceleration-words{fill:var(--accel)}.formula{font-style:italic}
"""
Look = Literal["own", "page", "print"]
"""Whence a figure has its colours: its own style, light and dark; that of the page; its own, for white paper."""


def _variables(colours: dict[str, str]) -> str:
    return "".join(f"--{name}:{colour};" for name, colour in colours.items())


def _coloured(colours: dict[str, str]) -> str:
    """The rules with the colours themselves, for readers of SVG that know no variables."""
    return re.sub(r"var\(--(\w+)\)", lambda m: colours[m[1]], RULES)


STYLE = f"svg{{{_variables(LIGHT)}}}@media screen and (prefers-color-scheme:dark){{svg{{{_variables(DARK)}}}}}{RULES}"
"""For a page with figures, on a screen."""
PRINT = _coloured(LIGHT)
"""For paper."""
# On its own ground a figure is seen on a page that is dark where the reader's screen is light, or the other way.
ALONE = (
    f"svg{{background:{LIGHT['paper']}}}{PRINT}"
    f"@media screen and (prefers-color-scheme:dark){{svg{{background:{DARK['paper']}}}{_coloured(DARK)}}}"
)
"""For a figure that is a file by itself."""


@record
class Laid:
    """A panel with the box that it fills, as high as those beside it, and what stands over it."""

    paper: Paper
    box: Box
    head: tuple[Run, ...]


def svg(figure: Figure, look: Look = "own") -> str:
    """A figure as one SVG element."""
    return _element(laid_out(figure), figure.words, figure.between, look, note=runs_of(figure.note))


def panels(figure: Figure, look: Look = "own") -> list[str]:
    """Each panel of a figure as an SVG element of its own; set side by side they are in one scale and level. What
    stands under the figure is in none of them.
    """
    laid = laid_out(figure)
    if len(laid) == 1:
        return [svg(replace(figure, note=()), look)]
    over = any(one.head for one in laid)
    heads = ["".join(r.text for r in one.head) for one in laid]
    told = [f"{figure.words}: {head}" if head else figure.words for head in heads]
    return [_element([one], words, "", look, over) for one, words in zip(laid, told, strict=True)]


def laid_out(figure: Figure) -> list[Laid]:
    """The panels of a figure with all words at their places."""
    papers = papers_of(figure)
    heads = [runs_of(p.head) for p in figure.panels]
    boxes = [_box(p, width_of(head)) for p, head in zip(papers, heads, strict=True)]
    top, bottom = min(b.top for b in boxes), max(b.bottom for b in boxes)
    return [
        Laid(paper, Box(box.left, top, box.right, bottom), head)
        for paper, box, head in zip(papers, boxes, heads, strict=True)
    ]


def _element(
    laid: Sequence[Laid], words: str, between: str, look: Look, headed: bool = False, note: Sequence[Run] = ()
) -> str:
    """Panels side by side. `headed`: there is room for a head, though none of these may have one; `note`: what stands
    under them.
    """
    root = begun(words, look)
    over = HEADED if headed or any(one.head for one in laid) else 0.0
    height, left = laid[0].box.bottom - laid[0].box.top, 0.0
    for place, one in enumerate(laid):
        if sign := between[place - 1 : place] if place else "":
            _between(root, sign, left - BETWEEN / 2, height / 2)
        # One scale and one height: what is the same in two panels is level.
        box = one.box
        group = ET.SubElement(root, "g", {"transform": f"translate({px(left - box.left)} {px(-box.top)})"})
        fill(group, one.paper)
        if one.head:
            middle = (box.left + box.right - width_of(one.head)) / 2
            write(group, one.head, (middle, box.top - HEADED / 3), "head-line")
        left += box.right - box.left + BETWEEN
    width, long = left - BETWEEN, width_of(note)
    if note:
        under = f"translate({px((width - long) / 2)} {px(height + NOTED * 0.7)})"
        write(ET.SubElement(root, "g", {"transform": under}), note, (0.0, 0.0), "note")
    beyond = MARGIN + max(long - width, 0.0) / 2
    below = MARGIN + (NOTED if note else 0.0)
    return ended(root, Box(-beyond, -MARGIN - over, width + beyond, height + below))


def begun(words: str, look: Look) -> ET.Element:
    """An SVG element with what it shows in words, and with its style unless the page has that."""
    root = ET.Element("svg", {"xmlns": SPACE, "role": "img", "aria-label": words})
    ET.SubElement(root, "title").text = words
    if look != "page":
        ET.SubElement(root, "style").text = ALONE if look == "own" else PRINT
    return root


def ended(root: ET.Element, whole: Box) -> str:
    """The text of an SVG element that shows what is in a box."""
    wide, high = px(whole.right - whole.left), px(whole.bottom - whole.top)
    root.set("viewBox", f"{px(whole.left)} {px(whole.top)} {wide} {high}")
    root.set("width", wide)
    root.set("height", high)
    for element in root.iter():
        # A line feed between letters would be a space.
        if element.tag != "tspan":
            element.tail = "\n"
    return ET.tostring(root, encoding="unicode")


def picture(figure: Figure) -> tuple[str, str]:
    """A figure as a file: a name that tells what is in it, and its text."""
    drawn = svg(figure)
    return f"{sha256(drawn.encode()).hexdigest()[:16]}.svg", drawn


def papers_of(figure: Figure) -> list[Paper]:
    """The panels on paper in one scale, with all words at their places."""
    part = PART[min(len(figure.panels), len(PART)) - 1]
    return [with_labels(paper) for paper in unlabelled(figure, WIDE * part, HIGH * part)]


def unlabelled(figure: Figure, width: float, height: float) -> list[Paper]:
    """The same, each no larger than this but for what has its size on paper, with words that have no places yet."""
    sizes = [world_box(p) for p in figure.panels]
    wide, high = max(w for w, _ in sizes), max(h for _, h in sizes)
    pixels = min(width / wide if wide else math.inf, height / high if high else math.inf)
    scale = Scale(pixels if math.isfinite(pixels) else 100.0)
    spots = (s for p in figure.panels for m in p.marks for s in spots_of(m))
    first = next(spots, (0.0, 0.0))
    if max(map(abs, first)) * scale.pixels > FARTHEST:
        scale = replace(scale, origin=first)
    return [on_paper(p, scale) for p in figure.panels]


def _box(paper: Paper, least: float) -> Box:
    """The box round all that is on paper, at least so wide."""
    ink = box_of(spot for s in paper.strokes for spot in along(s, 8.0)) or Box(0, 0, 1, 1)
    for placed in paper.placed:
        ink = ink.around(placed.box)
    short = max(least - (ink.right - ink.left), 0.0) / 2
    return Box(ink.left - short, ink.top, ink.right + short, ink.bottom).grown(3.0)


def _between(root: ET.Element, sign: str, x: float, y: float) -> None:
    look = {"class": "words", "font-size": px(SIZE * 1.6), "text-anchor": "middle"}
    text = ET.SubElement(root, "text", {"x": px(x), "y": px(y), **look})
    text.text = sign


def fill(group: ET.Element, paper: Paper) -> None:
    """Strokes and words into an element."""
    for stroke in paper.strokes:
        if isinstance(stroke, Disc):
            (x, y), kind = stroke.center, f"stroke {stroke.kind}"
            ET.SubElement(group, "circle", {"cx": px(x), "cy": px(y), "r": px(stroke.radius), "class": kind})
        else:
            ET.SubElement(group, "path", {"d": path_of(stroke), "class": f"stroke {stroke.kind}"})
    for placed in paper.placed:
        write(group, placed.words.runs, start_of(placed), placed.words.kind)


def start_of(placed: Placed) -> Spot:
    """Where the first letter stands: its foot on the base line."""
    return placed.box.left, placed.box.bottom - SIZE * 0.38


def write(group: ET.Element, runs: Sequence[Run], at: Spot, kind: str) -> None:
    """Words whose first letter stands at a place, with its foot on the base line."""
    text = ET.SubElement(
        group,
        "text",
        {"x": px(at[0]), "y": px(at[1]), "class": f"words {kind}-words", "font-size": px(SIZE)},
    )
    low = False
    for run in runs:
        piece = ET.SubElement(text, "tspan")
        if run.index != low:
            piece.set("dy", px(SIZE * 0.25 * (1 if run.index else -1)))
            low = run.index
        if run.index:
            piece.set("font-size", px(SIZE * SMALL))
        if run.formula:
            piece.set("class", "formula")
        piece.text = run.text


def path_of(stroke: Stroke) -> str:
    """A stroke as the moves of a pen."""
    moves = " L".join(f"{px(x)} {px(y)}" for x, y in stroke.places)
    return f"M{moves}{' Z' if stroke.closed else ''}"


def px(x: float) -> str:
    """A number with at most two decimals."""
    return f"{round(x, 2) + 0.0:.2f}".rstrip("0").rstrip(".")
