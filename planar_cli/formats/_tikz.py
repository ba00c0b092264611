"""Figures as TikZ, by the same style sheet as their SVG."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cache

from planar_cli.formats._paper import SIZE, SMALL, Disc, Paper, Placed, Run, Stroke, runs_of, width_of
from planar_cli.formats._svg import BETWEEN, HEADED, LIGHT, MARGIN, NOTED, RULES, laid_out, px
from planar_cli.report.document.marks import Figure
from planar_cli.report.notation.tex_words import words

POINT = 0.66
"""Of a pixel of a figure."""
WIDEST = 450.0
"""A figure is at most so wide, pt."""
COLOURS = "".join(rf"\definecolor{{planar{name}}}{{HTML}}{{{code[1:].upper()}}}" + "\n" for name, code in LIGHT.items())
_RULE = re.compile(r"([^{}]+)\{([^{}]*)\}")


def tikz(figure: Figure) -> str:
    """A figure as one picture."""
    rows: list[str] = []
    left = 0.0
    for place, one in enumerate(laid_out(figure)):
        box = one.box
        if sign := figure.between[place - 1 : place] if place else "":
            rows.append(_node((left - BETWEEN / 2, (box.bottom - box.top) / 2), words(sign), "ink", SIZE * 1.6))
        rows += _panel(one.paper, (left - box.left, -box.top))
        if one.head:
            over = left + (box.right - box.left) / 2, -HEADED / 3
            rows.append(_node(over, _runs(one.head), "ink", SIZE))
        left += box.right - box.left + BETWEEN
    note, width = runs_of(figure.note), left - BETWEEN
    if note:
        rows.append(_node((width / 2, box.bottom - box.top + NOTED * 0.7), _runs(note), "ink", SIZE))
    wide = (max(width, width_of(note)) + 2 * MARGIN) * POINT
    fit = f",scale={px(WIDEST / wide)},transform shape" if wide > WIDEST else ""
    lines = "\n".join(rows)
    return f"\\begin{{tikzpicture}}[x={POINT}pt,y=-{POINT}pt{fit}]\n{lines}\n\\end{{tikzpicture}}"


def _panel(paper: Paper, moved: tuple[float, float]) -> Iterator[str]:
    dx, dy = moved
    for stroke in paper.strokes:
        look = _options(stroke.kind)
        if not look:
            continue
        if isinstance(stroke, Disc):
            x, y = stroke.center
            way = f"({px(x + dx)},{px(y + dy)}) circle[radius={px(stroke.radius * POINT)}pt]"
        else:
            way = _way(stroke, moved)
        yield rf"\path[{look}] {way};"
    for placed in paper.placed:
        yield _placed(placed, moved)


def _way(stroke: Stroke, moved: tuple[float, float]) -> str:
    places = " -- ".join(f"({px(x + moved[0])},{px(y + moved[1])})" for x, y in stroke.places)
    return f"{places} -- cycle" if stroke.closed else places


def _placed(placed: Placed, moved: tuple[float, float]) -> str:
    box = placed.box
    at = ((box.left + box.right) / 2 + moved[0], box.bottom - SIZE * 0.38 + moved[1])
    look = _look(f"words {placed.words.kind}-words")
    return _node(at, _runs(placed.words.runs), _colour(look["fill"]).removeprefix("planar"), SIZE)


def _node(at: tuple[float, float], text: str, colour: str, size: float) -> str:
    size_ = px(size * POINT)
    font = rf"\sffamily\fontsize{{{size_}}}{{{size_}}}\selectfont"
    return rf"\node[inner sep=0pt,anchor=base,text=planar{colour},font={font}] at ({px(at[0])},{px(at[1])}) {{{text}}};"


def _runs(runs: Sequence[Run]) -> str:
    return "".join(map(_run, runs))


def _run(run: Run) -> str:
    text = words(run.text)
    text = rf"\textit{{{text}}}" if run.formula else text
    if not run.index:
        return text
    size = px(SIZE * SMALL * POINT)
    return rf"\raisebox{{-0.25em}}{{\fontsize{{{size}}}{{{size}}}\selectfont {text}}}"


# --- the style sheet -------------------------------------------------------------------------------------------------


@cache
def _options(kind: str) -> str:
    """How a stroke of a kind looks; "" where it is not to be seen."""
    look = _look(f"stroke {kind}")
    found = []
    if (colour := _colour(look.get("stroke", "none"))) != "none":
        found += [f"draw={colour}", f"line width={px(float(look.get('stroke-width', '1')) * POINT)}pt"]
        found += ["line join=round", f"line cap={look['stroke-linecap']}"]
        if "stroke-dasharray" in look:
            parts = [f"{px(float(n) * POINT)}pt" for n in look["stroke-dasharray"].split()]
            found.append("dash pattern=" + " ".join(f"{('on', 'off')[i % 2]} {p}" for i, p in enumerate(parts)))
        found += [f"draw opacity={look['stroke-opacity']}"] if "stroke-opacity" in look else []
    if (colour := _colour(look.get("fill", "none"))) != "none":
        found.append(f"fill={colour}")
        found += [f"fill opacity={look['fill-opacity']}"] if "fill-opacity" in look else []
    return ",".join(found)


def _look(kind: str) -> Mapping[str, str]:
    """What the rules of the style sheet say of something with these classes."""
    own = set(kind.split())
    found: dict[str, str] = {}
    for _, _, said in sorted((len(c), i, s) for i, (c, s) in enumerate(_rules()) if c <= own):
        found |= dict(said)
    return found


@cache
def _rules() -> list[tuple[frozenset[str], tuple[tuple[str, str], ...]]]:
    """Each selector of the style sheet as its classes, with what it says."""
    found = []
    for selectors, said in _RULE.findall(RULES):
        pairs = tuple((k.strip(), v.strip()) for k, _, v in (s.partition(":") for s in said.split(";")) if v)
        found += [(frozenset(s.strip().split(".")[1:]), pairs) for s in selectors.split(",")]
    return found


def _colour(value: str) -> str:
    named = re.fullmatch(r"var\(--(\w+)\)", value)
    return f"planar{named[1]}" if named else value
