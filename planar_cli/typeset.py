"""PDF and pictures of dots, by typst (the extra `pdf`).

A page comes as the HTML that `formats/html.py` writes, is read into a tree, and goes to typst as data: the template
`typeset.typ` alone has code, so that no word of a file is a command. The same page gives the same bytes.
"""

from __future__ import annotations

import json
import math
import re
from html import escape
from html.parser import HTMLParser
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Literal

from planar_cli.errors import PlanarError

DOTS = 144.0
"""Of an inch: two of a point, three of two pixels."""
ALONE = b"""#let (side, wide, high) = ("side", "wide", "high").map(name => float(sys.inputs.at(name)) * 0.75pt)
#set page(width: wide + 12pt, height: high + 12pt, margin: 6pt, fill: white)
#place(top + left, image(bytes(sys.inputs.figure), format: "svg", width: side, height: side))
"""
_SIZE = re.compile(r'viewBox="(\S+ \S+) (\S+) (\S+)" width="\S+" height="\S+"')
KEPT = ("class", "form", "mathvariant", "width")
"""The attributes that the template looks at."""
VOID = frozenset({"meta", "br", "hr", "img", "link", "wbr"})
LINES = " \t\r\n"
"""What HTML takes for one space; those of other widths stand for themselves."""
Node = dict[str, Any]


def png(svg: str) -> bytes:
    """A figure as a picture. Raises PlanarError where typst is not installed.

    typst draws a figure on dots of its own, as many as its width and its ratio ask for, and copies these: where they
    are not exactly those of the page, a row is left out. So the figure becomes a square of an even number of pixels,
    and the page shows its upper left part.
    """
    size = _SIZE.search(svg)
    assert size is not None, "a figure tells its size"
    wide, high = (2 * math.ceil(float(length) / 2) for length in size.groups()[1:])
    side = max(wide, high)
    square = f'viewBox="{size[1]} {side} {side}" width="{side}" height="{side}"'
    shown = svg.replace(size[0], square, 1)
    return _compiled(ALONE, "png", figure=shown, side=str(side), wide=str(wide), high=str(high))


def pdf(html: str, drawn: str) -> bytes:
    """A page on paper. `drawn`: the style sheet of its figures. Raises PlanarError where typst is not installed."""
    tree = _Tree(drawn)
    tree.feed(html)
    template = (Path(__file__).parent / "typeset.typ").read_bytes()
    return _compiled(template, "pdf", page=json.dumps(tree.body()))


def _compiled(template: bytes, form: Literal["pdf", "png"], **data: str) -> bytes:
    if find_spec("typst") is None:
        raise PlanarError("PDF and PNG need typst: install planar with its extra `pdf`, or take another `--format`")
    import typst

    made = typst.compile(template, format=form, ppi=DOTS, timestamp=0, sys_inputs=data)
    assert isinstance(made, bytes)
    return made


class _Tree(HTMLParser):
    """The elements of a page; a figure is one of them, with its text."""

    def __init__(self, drawn: str) -> None:
        super().__init__(convert_charrefs=True)
        self.style = f"<style>{escape(drawn)}</style>"
        self.root: Node = {"tag": "root", "kids": []}
        self.open = [self.root]
        self.depth, self.figure = 0, ""

    def body(self) -> Node:
        """The element with what is seen."""
        waiting = [self.root]
        while waiting:
            node = waiting.pop()
            if node["tag"] == "body":
                return node
            waiting += [k for k in node["kids"] if isinstance(k, dict)]
        return self.root

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        text = self.get_starttag_text() or ""
        if self.depth or tag == "svg":
            self.figure += text + (self.style if not self.depth else "")
            self.depth += 1
        elif tag not in VOID:
            node: Node = {"tag": tag, "kids": [], **{k: v for k, v in attrs if k in KEPT}}
            self.open[-1]["kids"].append(node)
            self.open.append(node)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if self.depth:
            self.figure += self.get_starttag_text() or ""
            return
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.handle_endtag(tag)

    def handle_endtag(self, tag: str) -> None:
        if self.depth:
            self.figure += f"</{tag}>"
            self.depth -= 1
            if not self.depth:
                self.open[-1]["kids"].append({"tag": "svg", "kids": [], "text": self.figure})
                self.figure = ""
        elif len(self.open) > 1:
            self.open.pop()

    def handle_data(self, data: str) -> None:
        if self.depth:
            self.figure += escape(data)
        elif data.strip(LINES):
            self.open[-1]["kids"].append(data)
        elif "\n" not in data:
            # One space between words; that between the lines of the source would be an empty paragraph.
            self.open[-1]["kids"].append(" ")
