"""Places that a file writes where they are used (`at: [1 m, 0]`): each becomes a point with a name that is free.

The tree of the file is changed before it is read, so that everything behind knows named points only.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar, Sequence
from planar_cli.problem.sections.read_points import POINT_KEYS

ONE = frozenset("at through center disk ring sphere plate sector point wound_at from towards about".split())
"""Keys at which one point stands."""
HELD = frozenset("at point wound_at".split())
"""Those of them at which the point belongs to a body: what is drawn there is meant, and no other point."""
SEVERAL = frozenset("rod between midpoint points path line".split())
"""Keys at which points stand in a list."""
_WORD = re.compile(r"[A-Za-z][A-Za-z0-9_]*")


def with_named_places(sections: dict[str, Node | None], everything: Iterable[Node]) -> dict[str, Node | None]:
    """The sections of the scene with every unnamed place named, and `points` with these names added.

    `everything`: all nodes of the file; no word of them is taken for a name.
    """
    naming = _Naming(everything)
    for section, key in (("points", ""), ("bodies", "particle")):
        naming.know(sections.get(section), key)
    changed = {key: None if node is None else naming.section(node) for key, node in sections.items()}
    if naming.points:
        old = changed.get("points")
        pairs = old.pairs if isinstance(old, Mapping) else ()
        if old is None or isinstance(old, Mapping):
            changed["points"] = Mapping((*pairs, *naming.points), naming.points[0][0].mark if old is None else old.mark)
    return changed


def free_names(stem: str, everything: Iterable[Node]) -> Iterator[str]:
    """`P_1`, `P_2`, …, without those that the file uses anywhere."""
    used = {word for node in everything for word in _words(node)}
    number = 0
    while True:
        number += 1
        if f"{stem}_{number}" not in used:
            yield f"{stem}_{number}"


def free_name(name: str, everything: Iterable[Node]) -> str:
    """The name itself, or that with a number, where the file uses it."""
    nodes = list(everything)
    used = any(word == name for node in nodes for word in _words(node))
    return next(free_names(name, nodes)) if used else name


def _words(node: Node) -> Iterator[str]:
    match node:
        case Scalar(text=text):
            yield from _WORD.findall(text)
        case Sequence(items=items):
            for item in items:
                yield from _words(item)
        case Mapping(pairs=pairs):
            for key, value in pairs:
                yield from _WORD.findall(key.text)
                yield from _words(value)


class _Naming:
    """One file: the points named so far, by what the file writes for them."""

    def __init__(self, everything: Iterable[Node]) -> None:
        self._names = free_names("P", everything)
        self._known: dict[str, str] = {}
        self._drawn: dict[str, str] = {}
        self.points: list[tuple[Scalar, Node]] = []

    def know(self, node: Node | None, key: str) -> None:
        """The names that a section gives to places, or to those at a key of its entries; of two, the first."""
        for name, value in node.pairs if isinstance(node, Mapping) else ():
            places = [v for k, v in value.pairs if k.text == key] if key and isinstance(value, Mapping) else []
            for place in places if key else [value]:
                if not isinstance(place, Scalar):
                    self._drawn.setdefault(_said(place), name.text)

    def section(self, node: Node) -> Node:
        """A section: names with values, or a list of entries with one key, their kind."""
        if isinstance(node, Sequence):
            return Sequence(tuple(self.section(item) for item in node.items), node.mark)
        if isinstance(node, Mapping):
            return Mapping(tuple((key, self._thing(key, value)) for key, value in node.pairs), node.mark)
        return node

    def _thing(self, key: Scalar, node: Node) -> Node:
        """A body or surface; where a particle has a place that is constructed, the point has the particle's name."""
        if isinstance(node, Mapping):
            for own, place in node.pairs:
                if own.text == "particle" and isinstance(place, Mapping):
                    self.points.append((key, self._inside(place)))
                    named = Scalar(key.text, False, place.mark, place.mark)
                    pairs = tuple((k, named if k is own else v) for k, v in node.pairs)
                    return self._inside(Mapping(pairs, node.mark))
        return self._inside(node)

    def _inside(self, node: Node) -> Node:
        if isinstance(node, Sequence):
            return Sequence(tuple(self._inside(item) for item in node.items), node.mark)
        if isinstance(node, Mapping):
            return Mapping(tuple((key, self._value(key.text, value)) for key, value in node.pairs), node.mark)
        return node

    def _value(self, key: str, node: Node) -> Node:
        if key in HELD and not isinstance(node, Scalar) and _said(node) in self._drawn:
            return Scalar(self._drawn[_said(node)], False, node.mark, node.mark)
        if key in ONE:
            return self._named(node)
        if key in SEVERAL and isinstance(node, Sequence):
            return Sequence(tuple(self._named(item) for item in node.items), node.mark)
        if key == "lines" and isinstance(node, Sequence):
            return Sequence(tuple(self._line(item) for item in node.items), node.mark)
        return self._inside(node)

    def _line(self, node: Node) -> Node:
        """One of several lines: a place and an angle, in a list, or at keys."""
        if not isinstance(node, Sequence):
            return self._inside(node)
        return Sequence(tuple(self._named(item) for item in node.items), node.mark)

    def _named(self, node: Node) -> Node:
        """The name of a place that is written out; anything else as it is."""
        written = isinstance(node, Sequence) or (isinstance(node, Mapping) and set(node.keys()) <= set(POINT_KEYS))
        if not written or isinstance(node, Scalar):
            return self._inside(node)
        place = self._inside(node)
        said = _said(place)
        if said not in self._known:
            self._known[said] = next(self._names)
            self.points.append((Scalar(self._known[said], False, node.mark, node.mark), place))
        return Scalar(self._known[said], False, node.mark, node.mark)


def _said(node: Node) -> str:
    """What a node says, wherever it stands."""
    match node:
        case Scalar(text=text):
            return repr(" ".join(text.split()))
        case Sequence(items=items):
            return f"[{', '.join(map(_said, items))}]"
        case Mapping(pairs=pairs):
            return f"{{{', '.join(f'{key.text}: {_said(value)}' for key, value in pairs)}}}"
