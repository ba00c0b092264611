"""The plain sections of a file: words, names with values or units, lists of relations, states, finds, answers."""

from __future__ import annotations

import re

from planar_cli.problem.language.expression import Found, Law, Relation, Side, Statement
from planar_cli.problem.nodes import reading
from planar_cli.problem.nodes.fields import Fields
from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar, Sequence
from planar_cli.problem.scene.scene import Answer, Find, State, Symbol
from planar_cli.problem.sections.said_here import said_here
from planar_cli.units import UnitError, parse_unit

PLANES = ("vertical", "horizontal")
ANSWER_KEYS = ("value", "tolerance")
FIGURE_KEYS = ("hide",)
ONE_LINE = ("title", "source")


def words(whole: Fields, key: str) -> str:
    """The words at `title`, `text`, `source` or `note`, of the first and third as one line; "" where there are none."""
    node = whole.node(key)
    said = "" if node is None else reading.text(node, key, whole.report)
    return " ".join(said.split()) if key in ONE_LINE else said


def one_of(whole: Fields, key: str, allowed: tuple[str, ...]) -> str | None:
    """One of some words, or None."""
    node = whole.node(key)
    if node is None:
        return None
    word = reading.text(node, key, whole.report)
    if word in allowed:
        return word
    hint = reading.did_you_mean(word, allowed, "write ")
    whole.report.add(node.mark, "PL317", f"'{word}' does not stand at '{key}'", hint)
    return None


def given(whole: Fields) -> tuple[Symbol, ...]:
    """`given`: names with values."""
    node = whole.node("given")
    if node is None:
        return ()
    return tuple(
        Symbol(
            key.text,
            _value(key, value, whole),
            None,
            key.mark,
            written=value.text if isinstance(value, Scalar) else "",
        )
        for key, value in reading.pairs(node, "given", whole.report, "given: {m: 50 kg}")
        if _is_name(key, whole)
    )


def _value(key: Scalar, node: Node, whole: Fields) -> Side:
    """The value of a given name; a list is meant as one of which each variant takes its own."""
    if not isinstance(node, Sequence):
        return reading.side(node, f"the value of {key.text}", whole.report)
    items = ", ".join(item.text for item in node.items if isinstance(item, Scalar))
    hint = f"for variants write `{key.text}: {{one_of: [{items}]}}`, or put the list under `variants`"
    whole.report.add(node.mark, "PL343", f"{key.text} is given one value, not a list", hint)
    return reading.unreadable(node.mark)


def _is_name(key: Scalar, whole: Fields) -> bool:
    return bool(reading.name(key, "a name", whole.report))


def with_units(whole: Fields, section: str) -> tuple[Symbol, ...]:
    """`symbols`, `unknowns`, `coordinates`: names with units, `1` for a pure number."""
    node = whole.node(section)
    if node is None:
        return ()
    if isinstance(node, Sequence):
        return _without_units(node, section, whole)
    example = {"symbols": "symbols: {L: m}", "unknowns": "unknowns: {F: N}"}.get(section, "coordinates: {theta: deg}")
    return tuple(
        Symbol(key.text, None, _unit(key, value, section, whole), key.mark)
        for key, value in reading.pairs(node, section, whole.report, example)
        if _is_name(key, whole)
    )


def _without_units(node: Sequence, section: str, whole: Fields) -> tuple[Symbol, ...]:
    """A list of names, which is refused; the names are known all the same."""
    listed = [item for item in node.items if isinstance(item, Scalar)]
    named = [item for item in listed if reading.NAME.fullmatch(item.text)]
    pairs = ", ".join(f"{item.text}: UNIT" for item in named) or "F: N"
    hint = f"write `{section}: {{{pairs}}}`, each with its unit: N, deg, m/s, or `1` for a pure number"
    whole.report.add(node.mark, "PL301", f"{section} holds names with their units, not a list", hint)
    return tuple(Symbol(item.text, None, "", item.mark) for item in named)


def _unit(key: Scalar, node: Node, section: str, whole: Fields) -> str:
    """The unit of a name; `1` stands in where it cannot be read."""
    word = reading.text(node, f"the unit of {key.text}", whole.report)
    if not word:
        return ""
    try:
        return parse_unit(word).text
    except UnitError as error:
        hint = error.hint
        if re.match(r"-?[0-9.]+\s*\S", word) and word != "1":
            hint = f"'{section}' has units only; a name with a value goes under `given`"
        whole.report.add(node.mark, "PL340", f"'{word}' is no unit for {key.text}: {error.message}", hint)
        return ""


def statements(whole: Fields, key: str) -> tuple[Statement, ...] | None:
    """A list of relations, or None where the key is not there."""
    node = whole.node(key)
    return None if node is None else reading.statements(node, key, whole.report)


def motion(whole: Fields) -> tuple[Law, ...]:
    """The list `motion`."""
    node = whole.node("motion")
    return () if node is None else reading.laws(node, whole.report)


def states(whole: Fields) -> tuple[State, ...]:
    """`states`: names with lists of relations."""
    node = whole.node("states")
    if node is None:
        return ()
    read: list[State] = []
    for key, value in reading.pairs(node, "states", whole.report, "states: {1: [at rest], 2: [theta = 0]}"):
        name = reading.state(key, whole.report)
        relations = reading.statements(value, f"the state {key.text}", whole.report)
        if name:
            read.append(State(name, tuple(said_here(s, name) for s in relations), key.mark))
    return tuple(read)


def finds(whole: Fields) -> tuple[Find, ...]:
    """`find`: names with what is asked."""
    node = whole.node("find")
    if node is None:
        return ()
    read: list[Find] = []
    if isinstance(node, Sequence):
        _refuse_list(node, whole)
        return ()
    for key, value in reading.pairs(node, "find", whole.report, "find: {v: v(B).mag}"):
        if not _is_name(key, whole):
            continue
        what = reading.found(value, whole.report)
        # One that cannot be read is there all the same: an answer to it is no mistake too.
        read.append(Find(key.text, what or Found(reading.unreadable(key.mark), None, "", key.mark), key.mark))
    return tuple(read)


def _refuse_list(node: Sequence, whole: Fields) -> None:
    first = node.items[0] if node.items else None
    said = first.text if isinstance(first, Scalar) else "v(B).mag"
    whole.report.add(
        node.mark, "PL301", "find holds names with what is asked, not a list", f"write `find: {{answer: {said}}}`"
    )


def answers(whole: Fields) -> tuple[Answer, ...]:
    """`answers`: what a key says of each find."""
    node, asked = whole.node("answers"), whole.node("find")
    if node is None or not (asked is None or isinstance(asked, Mapping)):
        return ()  # nothing can be read of what they answer
    return tuple(
        _answer(key, value, whole)
        for key, value in reading.pairs(node, "answers", whole.report, "answers: {alpha: 6.186 rad/s^2 cw}")
        if _is_name(key, whole)
    )


def _answer(key: Scalar, node: Node, whole: Fields) -> Answer:
    if not isinstance(node, Mapping):
        return Answer(key.text, _answer_value(key, node, whole), None, key.mark)
    fields = Fields(node, ANSWER_KEYS, f"the answer {key.text}", whole.report)
    value = fields.need("value", "write `{value: 6.19 rad/s^2, tolerance: 0.02}`")
    read = "" if value is None else _answer_value(key, value, whole)
    return Answer(key.text, read, fields.side("tolerance"), key.mark)


def _answer_value(key: Scalar, node: Node, whole: Fields) -> Side | tuple[Side, ...] | bool | str:
    """A pair is a vector, or a list of several modes; true or false a verdict; what else cannot be read as mathematics
    is an error.
    """
    if isinstance(node, Sequence):
        if len(node.items) >= 2:
            return tuple(reading.side(item, f"the answer {key.text}", whole.report) for item in node.items)
        whole.report.add(
            node.mark, "PL341", f"a vector has two parts, here are {len(node.items)}", "write `[3 m, 4 m]`"
        )
        return ""
    if isinstance(node, Scalar) and node.text in ("true", "false"):
        return node.text == "true"
    if isinstance(node, Scalar) and node.text.lower() in ("yes", "no", "on", "off"):
        said = "true" if node.text.lower() in ("yes", "on") else "false"
        whole.report.add(node.mark, "PL342", f"'{node.text}' is no answer", f"write `{said}`")
        return ""
    if isinstance(node, Scalar) and "=" in node.text:
        # The equation of a curve; its x and y are those of the plane, not names of the file.
        equation = reading.statement(node, whole.report)
        return equation.text if isinstance(equation, Relation) else ""
    return reading.side(node, f"the answer {key.text}", whole.report)


def hidden(whole: Fields) -> frozenset[str]:
    """The names that figures do not show, of `figure`."""
    node = whole.node("figure")
    hide = None if node is None else Fields(node, FIGURE_KEYS, "figure", whole.report).node("hide")
    listed = [] if hide is None else reading.items(hide, "hide", whole.report, "figure: {hide: [W]}")
    return frozenset(reading.name(item, "a name", whole.report) for item in listed)
