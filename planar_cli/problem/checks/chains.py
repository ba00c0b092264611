"""Chains of names and of points, each told by the one before: how long they may be.

What is told by a chain of a thousand names is put together by a thousand nested steps, which no later stage has room
for. Here nothing nests: whatever stands in the file, the length of its chains is found name by name.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from planar_cli.errors import Diagnostic, Mark
from planar_cli.problem.checks.check_names import points_of_place
from planar_cli.problem.language.expression import Name
from planar_cli.problem.language.walk import Tree, children, walk
from planar_cli.problem.scene.scene import Point, Symbol

LONGEST = 100
"""So many names, signs and brackets may stand one inside the other until numbers are reached."""
LONGEST_OF_POINTS = 100
"""So many points may be placed one from the other: each adds its sine and cosine."""

Link = tuple[Mark, int, tuple[str, ...]]
"""Where a name is defined, how deep its own formula is, and what it names."""


def long_chains(given: Sequence[Symbol], points: Sequence[Point]) -> Iterator[Diagnostic]:
    """The first name, and the first point, at the end of a chain that is too long."""
    values = {
        s.name: (s.mark, _depth(s.value), tuple(n.name for n in walk(s.value) if isinstance(n, Name)))
        for s in given
        if s.value is not None
    }
    yield from _too_long(values, "the value of", LONGEST, "names, signs and brackets")
    placed = {p.name: (p.mark, 1, points_of_place(p.place)) for p in points}
    yield from _too_long(placed, "the point", LONGEST_OF_POINTS, "points")


def _too_long(links: Mapping[str, Link], what: str, longest: int, parts: str) -> Iterator[Diagnostic]:
    for name, length in _lengths(links):
        if length > longest:
            text = f"{what} {name} is told by a chain of more than {longest} {parts}"
            yield Diagnostic(links[name][0], "PL207", text, "write some of those before it as numbers")
            return


def _lengths(links: Mapping[str, Link]) -> Iterator[tuple[str, int]]:
    """The length of the longest chain to each name, first of those that others need; what goes in a circle has none."""
    open_links = {name: {other for other in others if other in links} for name, (_, _, others) in links.items()}
    users: dict[str, list[str]] = {name: [] for name in links}
    for name, others in open_links.items():
        for other in others:
            users[other].append(name)
    before = dict.fromkeys(links, 0)
    ready = [name for name, others in open_links.items() if not others]
    for name in ready:
        length = before[name] + links[name][1]
        yield name, length
        for user in users[name]:
            before[user] = max(before[user], length)
            open_links[user].discard(name)
            if not open_links[user]:
                ready.append(user)


def _depth(tree: Tree) -> int:
    """How many nodes stand one inside the other; the parser bounds it."""
    return 1 + max((_depth(child) for child in children(tree)), default=0)
