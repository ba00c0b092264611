"""The strict JSON reader: text to the same tree of nodes as from YAML; numbers stay text as typed.

Keys that stand twice, NaN and infinities are refused, and so is what is nested deeply: nothing recursive runs on it.
The tree has no places, which the parser of the standard library does not tell.
"""

from __future__ import annotations

import json
from collections.abc import Sequence as Values
from typing import Any

from planar_cli.errors import Diagnostic, Mark
from planar_cli.problem.nodes.nodes import MAX_DEPTH, MAX_SCALAR, Mapping, Node, Scalar, Sequence
from planar_cli.records import record


@record
class _Number:
    """A number as it was typed."""

    text: str


class _RefusedError(ValueError):
    """Is no submission; the message says why."""


def json_tree(text: str, file: str) -> tuple[Node | None, list[Diagnostic]]:
    """The tree of a JSON text and what is wrong with it; the tree is None if anything is wrong."""
    nowhere = Mark(file, 0, 0)
    try:
        value = json.loads(
            text, object_pairs_hook=_pairs, parse_float=_Number, parse_int=_Number, parse_constant=_constant
        )
        return _node(value, nowhere, MAX_DEPTH), []
    except json.JSONDecodeError as error:
        hint = "check commas, quotes and brackets"
        return None, [Diagnostic(Mark(file, error.lineno, error.colno), "PL104", f"no JSON: {error.msg}", hint)]
    except _RefusedError as error:
        return None, [Diagnostic(nowhere, "PL102", str(error))]
    except RecursionError:
        return None, [Diagnostic(nowhere, "PL102", f"nested more than {MAX_DEPTH} deep")]


def _pairs(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    made: dict[str, Any] = {}
    for name, value in pairs:
        if name in made:
            raise _RefusedError(f"the key `{name[:60]}` stands twice")
        made[name] = value
    return made


def _constant(name: str) -> Any:
    raise _RefusedError(f"{name} is no number")


def _node(value: Any, mark: Mark, depth: int) -> Node:
    if depth == 0:
        raise _RefusedError(f"nested more than {MAX_DEPTH} deep")
    if isinstance(value, dict):
        pairs: Values[tuple[Scalar, Node]] = [
            (_scalar(key, True, mark), _node(inner, mark, depth - 1)) for key, inner in value.items()
        ]
        return Mapping(tuple(pairs), mark)
    if isinstance(value, list):
        return Sequence(tuple(_node(inner, mark, depth - 1) for inner in value), mark)
    if isinstance(value, bool):
        return _scalar("true" if value else "false", False, mark)
    if value is None:
        return _scalar("", False, mark)
    return _scalar(value.text, False, mark) if isinstance(value, _Number) else _scalar(value, True, mark)


def _scalar(text: str, quoted: bool, mark: Mark) -> Scalar:
    if len(text) > MAX_SCALAR:
        raise _RefusedError(f"a text is at most {MAX_SCALAR} characters long")
    return Scalar(text, quoted, mark, mark)
