"""The section `cases`: each case is the file with its own keys laid over it, before anything is read."""

from __future__ import annotations

from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar, Sequence

VALUES = ("given", "symbols", "unknowns", "coordinates")
OWN = ("find", "cases", "answers", "tolerance", "method", "variants", "figure")


def merged(base: Mapping, case: Mapping) -> Mapping:
    """The file as a case sees it: lists are added to, names replaced, words and choices replaced.

    A name that the case gives in `given`, `symbols`, `unknowns` or `coordinates` leaves the others of these four.
    The file's own `find` and `cases` are left out; a case has finds of its own. One that says what holds at a single
    `instant` has that in place of the states of the file, and one with `states` has these in place of its instant.
    """
    moved = _moved(case)
    changes = {key.text: (key, value) for key, value in case.pairs}
    left_out = {"find", "cases", "answers"}
    for own, other in (("instant", "states"), ("states", "instant")):
        if own in changes and other not in changes:
            left_out.add(other)
    pairs: list[tuple[Scalar, Node]] = []
    for key, value in base.pairs:
        if key.text in left_out:
            continue
        kept = _without(value, moved - _names(changes, key.text)) if key.text in VALUES else value
        if key.text in changes:
            kept = _laid_over(kept, changes.pop(key.text)[1])
        pairs.append((key, kept))
    return Mapping(tuple(pairs) + tuple(changes.values()), base.mark)


def _moved(case: Mapping) -> frozenset[str]:
    """The names to which the case gives a new role or value."""
    sections = (value for key, value in case.pairs if key.text in VALUES and isinstance(value, Mapping))
    return frozenset(key.text for section in sections for key, _ in section.pairs)


def _names(changes: dict[str, tuple[Scalar, Node]], section: str) -> frozenset[str]:
    """The names that the case itself has in that section."""
    node = changes[section][1] if section in changes else None
    return frozenset(key.text for key, _ in node.pairs) if isinstance(node, Mapping) else frozenset()


def _without(node: Node, names: frozenset[str]) -> Node:
    if not isinstance(node, Mapping):
        return node
    return Mapping(tuple(pair for pair in node.pairs if pair[0].text not in names), node.mark)


def _laid_over(old: Node, new: Node) -> Node:
    if isinstance(old, Sequence) and isinstance(new, Sequence):
        return Sequence(old.items + new.items, new.mark)
    if isinstance(old, Mapping) and isinstance(new, Mapping):
        replaced = {key.text: (key, value) for key, value in new.pairs}
        kept = tuple(replaced.pop(key.text, (key, value)) for key, value in old.pairs)
        return Mapping(kept + tuple(replaced.values()), new.mark)
    return new
