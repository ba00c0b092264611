"""The sections `joints` and `loads` of a file: lists of one-key entries, read by the declared keys of each member."""

from __future__ import annotations

import re
from dataclasses import Field, replace
from typing import Any

from planar_cli.joints.base import Joint
from planar_cli.loads.base import Load
from planar_cli.problem.nodes import reading
from planar_cli.problem.nodes.fields import Fields
from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar
from planar_cli.problem.nodes.reading import Report
from planar_cli.problem.scene.keys import Choice, KeySpec, RopeStop, example_of, keys_of, spellings
from planar_cli.problem.sections.read_values import Names, read_value
from planar_cli.records import record
from planar_cli.registry import member, members

COMMON = ("name", "during")
NAMED_BY = ("at", "point", "wound_at")
SLIPS = {
    "on": "write both in `between: [spool, floor], at: C`",
    "bodies": "write `between: [ground, AB]`",
    "points": "write `between: [A, B]`",
    "from": "write `between: [A, B]`",
    "to": "write `towards: P`, or `between: [A, B]`",
    "of": "write `body: b`, or `between: [a, b]`",
    "with": "write `between: [a, b]`",
    "surface": "write it in `between: [body, surface]`",
    "direction": "write `angle: 30 deg`, or `towards: P`",
    "value": "write `magnitude: 50 N`",
    "k": "write `stiffness: 200 N/m`",
    "c": "write `coefficient: 20 N*s/m`",
    "e": "write `restitution: 0.8`",
    "l0": "write `natural_length: 0.3 m`",
    "mu_d": "write `mu_k: 0.2`",
    "state": "write `during: 1->2`",
    "point": "write `at: A`",
    "at": "a guide has `point: B`; links and springs have `between: [A, B]`",
    "body": "write `between: [a, b]`",
    "moment": "write `magnitude: 50 N` for a force; a moment is a `torque`",
    "magnitude": "write `moment: 40 N*m`",
}
"""A key that newcomers try, and what is written instead, where the member has a key of which the hint speaks."""
OTHERWISE = (
    *((key, "write `point: P, along: …`") for key in ("on", "in", "surface", "track", "path", "direction", "angle")),
    *((key, "write `path: [A, over D, B]`") for key in ("between", "bodies", "points", "from", "to", "over")),
)
"""The same of members that have none of the keys of which `SLIPS` speaks: a guide, a rope."""
KEY_IN_HINT = re.compile(r"`([a-z_]+):")
MISTAKEN = {
    "weight": "weight acts by itself on every body with mass, when `plane: vertical`",
    "gravity": "weight acts by itself on every body with mass, when `plane: vertical`",
    "moment": "write `- torque: {body: b, moment: 40 N*m}`",
    "couple": "write `- torque: {body: b, moment: 40 N*m}`",
    "hinge": "write `- pin: {at: A, between: [ground, AB]}`",
    "slot": "write `- guide: {point: P, along: AB}`",
    "slider": "write `- guide: {point: B, along: 0 deg}`",
    "cable": "write `- rope: {path: [A, over D, B]}`",
    "string": "write `- rope: {path: [A, B]}`",
    "cord": "write `- rope: {path: [A, B]}`",
    "gear": "write `- rolling: {between: [a, b], at: C}`",
    "friction": "friction belongs to its `contact`: `- contact: {between: [b, floor], at: C, mu: 0.3}`",
    "normal": "the normal force comes with its `contact`",
    "roller": "write `- guide: {point: B, along: 0 deg}`, or a `contact` where it may lift off",
}


def read_joints(node: Node, names: Names, report: Report) -> tuple[Joint, ...]:
    """The list `joints`."""
    return tuple(m for m in _entries(node, "joints", names, report) if isinstance(m, Joint))


def read_loads(node: Node, names: Names, report: Report) -> tuple[Load, ...]:
    """The list `loads`."""
    return _told_apart([m for m in _entries(node, "loads", names, report) if isinstance(m, Load)])


def _told_apart(loads: list[Load]) -> tuple[Load, ...]:
    """Springs and dampers of one kind that would be called by one point are called by their other one; so is a spring
    that acts one way alone, where anything else is called by that point.
    """
    found = list(loads)
    for i, load in enumerate(loads):
        one_way = bool(getattr(load, "acts", ""))
        alike = [x for x in loads if x.name == load.name and (one_way or x.kind == load.kind)]
        others = [n for n in getattr(load, "between", None) or () if n not in (load.name, "ground")]
        if len(alike) > 1 and others:
            taken = {x.name for k, x in enumerate(found) if k != i}
            names = (others[0], *(f"{others[0]}_{k}" for k in range(2, len(loads) + 2)))
            found[i] = replace(load, name=next(n for n in names if n not in taken))
    return tuple(found)


def _entries(node: Node, shelf: str, names: Names, report: Report) -> list[object]:
    example = {"joints": "- pin: {at: A, between: [ground, AB]}", "loads": "- torque: {body: b, moment: 40 N*m}"}[shelf]
    read: list[object] = []
    for item in reading.items(node, shelf, report, example):
        if not isinstance(item, Mapping) or len(item.pairs) != 1:
            report.add(item.mark, "PL312", f"an entry of {shelf} has one key, its kind", f"write `{example}`")
            continue
        kind, value = item.pairs[0]
        member = _member_class(kind, shelf, report)
        if member is not None:
            read.append(_Entry(kind, value, member, names, report).read())
    return read


def _member_class(kind: Scalar, shelf: str, report: Report) -> type | None:
    """The class of a kind; None, with an error, when the shelf has none, or when it is never written."""
    if kind.text != "weight":
        try:
            found: type = member(shelf, kind.text)
        except KeyError:
            pass
        else:
            return found
    other = "loads" if shelf == "joints" else "joints"
    if kind.text in MISTAKEN:
        hint = MISTAKEN[kind.text]
    elif kind.text in members(other):
        hint = f"'{kind.text}' belongs under `{other}`"
    else:
        hint = reading.did_you_mean(kind.text, (k for k in members(shelf) if k != "weight"), "there are ")
    report.add(kind.mark, "PL313", f"there is no '{kind.text}' among the {shelf}", hint)
    return None


@record
class _Entry:
    """One entry of a list and what is needed to read it."""

    kind: Scalar
    value: Node
    member: type
    names: Names
    report: Report

    def read(self) -> object:
        specs = keys_of(self.member)
        fields = self._fields(specs)
        values = {_field_of(self.member, spec).name: self._value(fields, spec) for spec in specs}
        self._choices(fields)
        node = fields.node("during")
        during = None if node is None else reading.span(node, self.report)
        return self.member(name=self._name(fields, values), during=during, mark=self.kind.mark, **values)

    def _fields(self, specs: tuple[KeySpec, ...]) -> Fields:
        allowed = (*(spec.name for spec in specs), *COMMON)
        slips: dict[str, str] = {}
        for key, hint in (*SLIPS.items(), *OTHERWISE):
            if key not in allowed and any(named in allowed for named in KEY_IN_HINT.findall(hint)):
                slips.setdefault(key, hint)
        example = f"{self.kind.text}: {{{', '.join(f'{spec.name}: …' for spec in specs if spec.required)}}}"
        return Fields(self._as_meant(allowed), allowed, f"the {self.kind.text}", self.report, slips, example)

    def _as_meant(self, allowed: tuple[str, ...]) -> Node:
        """What is written, with another spelling of a key as that key, where the key itself is not written too."""
        if not isinstance(self.value, Mapping):
            return self.value
        written, meant = frozenset(self.value.keys()), spellings(allowed)
        known = {other: key for other, key in meant.items() if key not in written}
        renamed = ((replace(key, text=known.get(key.text, key.text)), value) for key, value in self.value.pairs)
        return Mapping(tuple(renamed), self.value.mark)

    def _value(self, fields: Fields, spec: KeySpec) -> Any:
        node = (
            fields.need(spec.name, f"write `{spec.name}: {example_of(spec)}`: {spec.doc}")
            if spec.required
            else fields.node(spec.name)
        )
        if node is None and not spec.required:
            return _field_of(self.member, spec).default
        return read_value(node, spec, fields, self.names)

    def _choices(self, fields: Fields) -> None:
        if not fields.readable:
            return
        for choice in self.member.__dict__.get("choices", ()):
            written = fields.present() & choice.names()
            if all(written != frozenset(group) for group in choice.groups):
                none = "neither is given" if len(choice.groups) == 2 else "none of these is given"
                said = f"here is {' and '.join(sorted(written))}" if written else none
                place = fields.place(min(written)) if written else self.kind.mark
                about = listed_groups(choice.groups)
                message = f"the {self.kind.text} takes {about}; {said}"
                self.report.add(place, "PL314", message, f"write {self._hint(choice, fields)}")

    @staticmethod
    def _hint(choice: Choice, fields: Fields) -> str:
        """The hint of a choice, with the names that the file has at its keys."""
        hint = choice.hint
        for key in fields.present() & choice.names():
            node = fields.node(key)
            if isinstance(node, Scalar) and reading.NAME.fullmatch(node.text):
                before, found, after = re.split(rf"(`{key}: [A-Za-z]\w*`)|$", hint, maxsplit=1)
                hint = f"{before}`{key}: {node.text}`{after}" if found else hint
        return hint

    def _name(self, fields: Fields, values: dict[str, Any]) -> str:
        """`name:`, else that of its point, else that of its first body. What touches at a place that is written out,
        and a load there, has no point by whose name the file could call it; a reaction is that at its place.
        """
        if "name" in fields:
            return fields.need_name("name", "a name")
        at = next((str(values[key]) for key in NAMED_BY if values.get(key)), "")
        known = values.get("body") or self._first(values.get("between") or ())
        touches = getattr(self.member, "touches", True)
        if at and not (touches and known and at in self.names.unnamed):
            return at
        if values.get("body"):
            return str(values["body"])
        path = values.get("path")
        if path and isinstance(path[0], RopeStop):
            return path[0].name
        return self._first(values.get("between") or ())

    def _first(self, between: tuple[str, ...]) -> str:
        bodies = [n for n in between if n in self.names.bodies]
        return (bodies or [n for n in between if n != "ground"] or [""])[0]


def listed_groups(groups: tuple[tuple[str, ...], ...]) -> str:
    """`mu, or mu_s and mu_k, or none of these`."""
    said = [" and ".join(group) for group in groups if group]
    return ", or ".join([*said, "none of these"] if () in groups else said)


def _field_of(member: type, spec: KeySpec) -> Field[Any]:
    """The dataclass field of a key; the two differ in name where a key is no Python name."""
    declared: dict[str, Field[Any]] = vars(member)["__dataclass_fields__"]
    return next(f for f in declared.values() if "key" in f.metadata and (f.metadata["name"] or f.name) == spec.name)
