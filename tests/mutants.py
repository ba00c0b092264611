"""Mutants of problem files: one statement, number, sign, key, unit or name is changed at a time."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from planar_cli.problem.language.tokens import ParseError, Token, tokenize
from planar_cli.problem.language.words import QUANTITIES
from planar_cli.problem.nodes import nodes
from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar
from planar_cli.units import UnitError, parse_unit

Path_ = tuple[int, ...]
"""Where a node is: by the numbers of the children (of a mapping: of its pairs) from the root."""

KINDS = ("statement", "number", "sign", "key", "unit", "name")
TEXTS = frozenset(("title", "text", "source", "note", "tolerance", "variants", "figure", "method"))
"""What is only told, or what tells how to solve; names and the figures of answers are no part of the mechanics."""
STATEMENTS = frozenset(("motion", "instant", "assume", "joints", "loads", "relaxed_at"))
NAMED = frozenset(("given", "symbols", "unknowns", "coordinates", "points", "surfaces", "bodies", "states"))
SIZES = frozenset("particle rod disk ring sphere sector plate center radius hub width height points".split())
OTHER_MODES = {"stick": "slip", "slip": "stick", "taut": "slack", "slack": "taut", "apart": "stick", "tip": "stick"}
A_NAME = "a name"
OFF = "1.07"


@dataclass(frozen=True, slots=True)
class Mutant:
    """One change of one file: `at` the node, `new` the text in its place (None: the node goes), `key`: of its key."""

    file: str
    kind: str
    at: Path_
    key: bool
    new: str | None
    place: str
    what: str
    reason: str = ""
    """Why its page may be that of the file: one of the words above; "": there is none."""
    contrary: str | None = None
    """What says the contrary of the statement that goes: a statement that follows from others is checked by them."""
    against: Path_ | None = None
    """The node in which the contrary is said; None: that of the change."""


def mutants(file: str) -> list[Mutant]:
    """All mutants of a file, in its order."""
    _, root, wrong = nodes.read_file(file)
    assert isinstance(root, Mapping), wrong
    return list(_Walk(file, root).mutants())


class _Walk:
    """All nodes of a file, with the keys that lead to them."""

    def __init__(self, file: str, root: Mapping) -> None:
        self.file, self.root = file, root
        self.names: dict[str, list[str]] = {}
        self.uses: dict[str, set[str]] = {}
        """Where each name of `given` is used: "drawn", "given:name" or something else."""
        self._note(root, ())
        self.heavy = bool(_all_keys(root) & {"mass", "weight"})
        """Has anything mass?"""
        self.places: dict[str, str] = {}
        """Where points are drawn, as it is written."""
        for section in (root, *_cases(root)):
            for key, value in section.pairs:
                if key.text == "points" and isinstance(value, Mapping):
                    self.places |= {k.text: repr(_texts(v)) for k, v in value.pairs}
                if key.text in NAMED and isinstance(value, Mapping):
                    known = self.names.setdefault(key.text, [])
                    known.extend(name for name in _keys(value) if name not in known)

    def _note(self, node: Node, keys: tuple[str, ...]) -> None:
        """Gather where names are used."""
        if isinstance(node, Mapping):
            for key, value in node.pairs:
                self._note(value, (*keys, key.text))
        elif isinstance(node, Scalar):
            own = keys[2:] if keys[:1] == ("cases",) else keys
            if not own or own[0] in TEXTS | {"answers"}:
                return
            use = f"given:{own[1]}" if own[0] == "given" and len(own) > 1 else _reason(keys) or own[0]
            for word in re.findall(r"[A-Za-z]\w*", node.text):
                self.uses.setdefault(word, set()).add(use)
        else:
            for item in node.items:
                self._note(item, keys)

    def only_drawn(self, name: str, above: frozenset[str] = frozenset()) -> bool:
        """Is a name used for places and sizes alone, itself or by way of other names?"""
        uses = self.uses.get(name, set())
        further = {use.removeprefix("given:") for use in uses if use.startswith("given:")} - above
        rest = {use for use in uses if not use.startswith("given:")}
        return rest <= {"drawn"} and all(self.only_drawn(other, above | {name}) for other in further)

    def mutants(self) -> Iterator[Mutant]:
        yield from self._inside(self.root, (), ())

    def _inside(self, node: Node, at: Path_, keys: tuple[str, ...]) -> Iterator[Mutant]:
        if isinstance(node, Scalar):
            if not node.quoted or keys[:1] != ("answers",):
                yield from self._scalar(node, at, keys)
        elif isinstance(node, Mapping):
            for i, (key, value) in enumerate(node.pairs):
                if key.text in TEXTS and (not keys or keys[0] == "cases"):
                    continue
                place = f"{key.mark.line}:{key.mark.column}"
                name = key.text + key.text[-1]
                reason = A_NAME if keys and keys[-1] in NAMED | {"find", "cases"} else ""
                yield Mutant(self.file, "key", (*at, i), True, name, place, f"{key.text} -> {name}", reason)
                for mutant in self._inside(value, (*at, i), (*keys, key.text)):
                    yield self._of_a_guide(mutant, node, at) if key.text == "point" else mutant
        else:
            for i, item in enumerate(node.items):
                if _are_statements(keys):
                    place = f"{item.mark.line}:{item.mark.column}"
                    what, (other, below) = f"without {_said(item)}", self._contrary_of(item, keys)
                    reason, against = _reason((*keys, "")), (*at, i, *below) if below else None
                    yield Mutant(self.file, "statement", (*at, i), False, None, place, what, reason, other, against)
                yield from self._inside(item, (*at, i), keys)

    def _of_a_guide(self, mutant: Mutant, guide: Mapping, at: Path_) -> Mutant:
        """A guide along which its point moves anyhow says nothing more, and nothing less where another point has it."""
        along = [(i, v.text) for i, (k, v) in enumerate(guide.pairs) if k.text == "along" and isinstance(v, Scalar)]
        if mutant.kind != "name" or mutant.contrary or not along:
            return mutant
        (where, text), *_ = along
        return replace(mutant, contrary=f"{text} + 90 deg", against=(*at, where))

    def _contrary_of(self, item: Node, keys: tuple[str, ...]) -> tuple[str | None, Path_]:
        """What says the contrary of an item of a list, and where below it.

        Where nothing has mass, and places are written, joints only say what these tell: at another point they do not.
        What hangs straight down, or is led by other joints, moves along a guide without it, and not across it.
        """
        if isinstance(item, Scalar) and item.text in ("at rest", "equilibrium") and self.names.get("bodies"):
            return f"v({self.names['bodies'][0]}).mag > 0", ()
        if keys[-1] != "joints" or not isinstance(item, Mapping):
            return _contrary(item), ()
        inner = item.pairs[0][1]
        for i, (key, value) in enumerate(inner.pairs if isinstance(inner, Mapping) and not self.heavy else ()):
            if key.text in ("at", "point") and isinstance(value, Scalar):
                others = [name for name in self.names.get("points", []) if name != value.text]
                return (others[-1] if others else None), (0, i)
        for i, (key, value) in enumerate(inner.pairs if isinstance(inner, Mapping) else ()):
            if key.text == "along" and isinstance(value, Scalar):
                return f"{value.text} + 90 deg", (0, i)
        return None, ()

    def _scalar(self, node: Scalar, at: Path_, keys: tuple[str, ...]) -> Iterator[Mutant]:
        try:
            tokens = tokenize(node.text, node.mark)
        except ParseError:
            return
        if keys[:1] == ("answers",) or keys[0] in TEXTS:
            return
        for i, token in enumerate(tokens):
            for kind, new, start in self._changed(tokens, i, node, keys):
                text = node.text[:start] + new + node.text[token.end :]
                place = f"{node.mark.line}:{node.mark.column + node.quoted + token.start}"
                # A bound rejects what lies beyond it, and may do so wherever it stands on this side.
                other = _contrary(node) if "<" in node.text or ">" in node.text.replace("->", "") else None
                if kind == "name" and other is None and _are_statements(keys):
                    # The new statement may say the same in other words.
                    other = _contrary(replace(node, text=text))
                if kind == "name" and keys[0] == "joints" and keys[-1] in ("at", "point") and not self.heavy:
                    # Nor does the new one say anything where it holds for the places as they are written.
                    others = [n for n in self.names.get("points", []) if n not in (node.text, text)]
                    other = others[-1] if others else None
                if kind in ("number", "sign") and other is None and (_are_statements(keys) or keys[-1] == "table"):
                    # A count, a mode or a distance may be the same a little later, or on the other side.
                    value = token.text if kind == "sign" else f"(-{token.text})"
                    value = f"{float(value) * float(OFF):.6g}" if kind == "sign" else value
                    other = node.text[: token.start] + value + node.text[token.end :]
                reason = _reason(keys) or self._reason_of(kind, keys, node.text, start)
                if kind == "name" and self.places.get(token.text) == self.places.get(new, ""):
                    # Two points at one place, of which a joint or a load may name either.
                    reason = reason or "drawn"
                yield Mutant(self.file, kind, at, False, text, place, f"{node.text} -> {text}", reason, other)

    def _reason_of(self, kind: str, keys: tuple[str, ...], text: str, start: int) -> str:
        """Why a number may change nothing, by what its name is for or by how it stands there."""
        own = keys[2:] if keys[0] == "cases" else keys
        if own[0] == "given" and len(own) > 1 and self.only_drawn(own[1]):
            return "drawn"
        # Half a turn one way is half a turn the other way.
        if kind == "sign" and text[start:].startswith("180 deg"):
            return "even"
        if kind == "sign" and re.search(r"\([\w*/. ]*$", text[:start]) and re.match(r"[\w. ]*\)\^[24]", text[start:]):
            return "even"
        if kind == "sign" and (own[-1] in ("along", "normal") or re.search(r"cos\([^()]*(\([^()]*)?$", text[:start])):
            return "even"
        return ""

    def _changed(
        self, tokens: Sequence[Token], i: int, node: Scalar, keys: tuple[str, ...]
    ) -> Iterator[tuple[str, str, int]]:
        """Kind of change, what stands instead of token `i`, and from where on it stands there."""
        token, before = tokens[i], tokens[i - 1] if i else None
        if token.kind == "number" and not _is_label(tokens, i, keys) and float(token.text):
            yield "number", f"{float(token.text) * float(OFF):.6g}", token.start
            if not (before and before.text == "^"):
                yield "sign", f"(-{token.text})" if before else f"-{token.text}", token.start
        if token.kind != "name":
            return
        unit = (before and (before.kind == "number" or before.text in (")", "in"))) or _declares(keys)
        if unit and token.text not in ("is", "at", "just") and (other := _other_unit(token.text)):
            yield "unit", other, token.start
            return
        if tokens[i + 1].text == "(" and token.text in QUANTITIES:
            return
        lists = [names for names in self.names.values() if token.text in names and len(names) > 1]
        # What is called like a point at which it stands is in two lists, and may be exchanged for the same in both.
        for other in dict.fromkeys(names[(names.index(token.text) + 1) % len(names)] for names in lists):
            yield "name", other, token.start


def _texts(node: Node) -> list[str]:
    """All scalars of a node."""
    if isinstance(node, Scalar):
        return [node.text]
    inside = (v for pair in node.pairs for v in pair) if isinstance(node, Mapping) else node.items
    return [text for item in inside for text in _texts(item)]


def _reason(keys: tuple[str, ...]) -> str:
    """Why a number or name below these keys may change nothing."""
    own = keys[2:] if keys[0] == "cases" else keys
    if own[:1] in (("points",), ("surfaces",)) or own[-1] in SIZES:
        return "drawn"
    if own[-2:] == ("weld", "at"):
        # Two bodies that are one have the same motion wherever they are joined.
        return "drawn"
    return {"find": "asked", "assume": "assumed"}.get(own[0], "")


def _keys(node: Mapping) -> list[str]:
    return [key.text for key, _ in node.pairs]


def _all_keys(node: Node) -> set[str]:
    """The keys of a tree."""
    if isinstance(node, Mapping):
        return set(_keys(node)).union(*(_all_keys(value) for _, value in node.pairs))
    return set() if isinstance(node, Scalar) else set().union(*map(_all_keys, node.items))


def _cases(root: Mapping) -> list[Mapping]:
    cases = root.get("cases")
    return [] if not isinstance(cases, Mapping) else [v for _, v in cases.pairs if isinstance(v, Mapping)]


def _are_statements(keys: tuple[str, ...]) -> bool:
    """Is a list below these keys one of statements? In a state, in a case, or in a section of its own."""
    return keys[-1] in STATEMENTS or (len(keys) > 1 and keys[-2] == "states")


def _declares(keys: tuple[str, ...]) -> bool:
    return len(keys) > 1 and keys[-2] in ("symbols", "unknowns", "coordinates")


def _is_label(tokens: Sequence[Token], i: int, keys: tuple[str, ...]) -> bool:
    """A state may be called by a number."""
    beside = {tokens[i - 1].text if i else "", tokens[i + 1].text}
    return keys[-1] == "during" or bool(beside & {"@", "->", "during", "after"}) or _declares(keys)


def _other_unit(text: str) -> str | None:
    try:
        dimension = parse_unit(text).dimension
    except UnitError:
        return None
    return "kg" if dimension != parse_unit("kg").dimension else "m"


def _contrary(node: Node) -> str | None:
    """A statement that is false where this one is true."""
    if not isinstance(node, Scalar):
        return None
    if rest := re.fullmatch(r"(\w+) at rest", node.text):
        return f"v({rest[1]}).x > 0"
    if "mode(" in node.text:
        return re.sub("|".join(OTHER_MODES), lambda found: OTHER_MODES[found[0]], node.text)
    for sign, other in (("<=", ">"), (">=", "<"), ("<", ">"), (">", "<"), ("=", ">"), ("largest", "smallest")):
        if sign in node.text:
            return node.text.replace(sign, other)
    return None


def _said(node: Node) -> str:
    match node:
        case Scalar():
            return node.text
        case Mapping():
            return "{" + ", ".join(f"{k.text}: {_said(v)}" for k, v in node.pairs) + "}"
    return "[" + ", ".join(_said(item) for item in node.items) + "]"


def mutated(node: Node, at: Path_, mutant: Mutant) -> Node | None:
    """The tree with the change at a path below `node`; None: nothing is left of it."""
    if isinstance(node, Mapping):
        pairs = list(node.pairs)
        key, value = pairs[at[0]]
        if len(at) == 1 and mutant.key:
            pairs[at[0]] = (replace(key, text=mutant.new or ""), value)
        else:
            rest = mutated(value, at[1:], mutant)
            pairs[at[0] : at[0] + 1] = [] if rest is None else [(key, rest)]
        return replace(node, pairs=tuple(pairs))
    if isinstance(node, Scalar):
        return None if mutant.new is None else replace(node, text=mutant.new)
    items = list(node.items)
    if len(at) == 1 and mutant.new is None:
        del items[at[0]]
    else:
        rest = mutated(items[at[0]], at[1:], mutant)
        items[at[0] : at[0] + 1] = [] if rest is None else [rest]
    return replace(node, items=tuple(items)) if items else None
