"""The keys of one entry of a file (a point, a body, a joint): what may stand there, what must, and reading it."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Mapping as Dict

from planar_cli.errors import Mark
from planar_cli.problem.language.expression import Side
from planar_cli.problem.nodes import reading
from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar
from planar_cli.problem.nodes.reading import Report


class Fields:
    """The keys of one mapping. Unknown keys are reported when it is made, missing ones when they are asked for.

    `what` names the entry in messages ("the pin"). `slips` maps keys that newcomers try to a hint of their own.
    `example` is shown where there are no keys at all.
    """

    def __init__(
        self,
        node: Node,
        allowed: Iterable[str],
        what: str,
        report: Report,
        slips: Dict[str, str] | None = None,
        example: str = "",
    ) -> None:
        self.mark: Mark = node.mark
        self.what = what
        self.report = report
        self.allowed = tuple(allowed)
        self.readable = isinstance(node, Mapping)
        self.refused: list[str] = []
        """The keys that are not allowed."""
        self._slips = slips or {}
        self._nodes: dict[str, Node] = {}
        self._marks: dict[str, Mark] = {}
        for key, value in reading.pairs(node, what, report, example or f"{{{self.allowed[0]}: …}}"):
            self._accept(key.text, key.mark, value)

    def _accept(self, key: str, mark: Mark, value: Node) -> None:
        if key in self.allowed:
            self._nodes[key] = value
            self._marks[key] = mark
            return
        self.refused.append(key)
        hint = self._slips.get(key, "") or self._slips.get(key.lower(), "")
        hint = hint.replace("…", value.text) if isinstance(value, Scalar) else hint
        hint = hint or reading.did_you_mean(key, self.allowed, "allowed are ")
        self.report.add(mark, "PL310", f"unknown key '{key}' in {self.what}", hint)

    def __contains__(self, key: str) -> bool:
        return key in self._nodes

    def present(self) -> frozenset[str]:
        """The keys that are there."""
        return frozenset(self._nodes)

    def node(self, key: str) -> Node | None:
        """What stands at a key."""
        return self._nodes.get(key)

    def need(self, key: str, hint: str = "") -> Node | None:
        """What stands at a key that must be there."""
        found = self._nodes.get(key)
        if found is None and self.readable:
            self.report.add(self.mark, "PL311", f"{self.what} needs the key '{key}'", hint)
        return found

    def place(self, key: str) -> Mark:
        """Where a key stands; where it is not there, the entry itself."""
        return self._marks.get(key, self.mark)

    def side(self, key: str) -> Side | None:
        """The mathematics at a key, or None where the key is not there."""
        found = self._nodes.get(key)
        return None if found is None else reading.side(found, key, self.report)

    def need_side(self, key: str, hint: str = "") -> Side:
        """The mathematics at a key that must be there; a stand-in when it is not."""
        found = self.need(key, hint)
        return reading.unreadable(self.mark) if found is None else reading.side(found, key, self.report)

    def name(self, key: str, what: str) -> str | None:
        """The name at a key, or None where the key is not there; "" where it cannot be read."""
        found = self._nodes.get(key)
        return None if found is None else reading.name(found, what, self.report)

    def need_name(self, key: str, what: str) -> str:
        """The name at a key that must be there, or ""."""
        found = self.need(key)
        return "" if found is None else reading.name(found, what, self.report)
