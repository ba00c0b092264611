"""Values of given names from which variants of a problem are made: ranges with a step, and lists.

    variants: {m: {from: 2 kg, to: 5 kg, step: 0.5 kg}, beta: [20 deg, 25 deg, 30 deg]}
    given: {m: {from: 2 kg, to: 5 kg, step: 0.5 kg}, l: {one_of: [3 m, 4 m]}}

In `given` the first value is that of the file itself. All stay exact, in the unit in which they are written.
"""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Mapping as Dict
from fractions import Fraction

from planar_cli.errors import Mark
from planar_cli.problem.language.expression import Negate, Number, Side
from planar_cli.problem.nodes import reading
from planar_cli.problem.nodes.fields import Fields
from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar, Sequence
from planar_cli.problem.nodes.reading import Report
from planar_cli.records import record
from planar_cli.units import Unit, UnitError, parse_unit

RANGE, CHOICE = ("from", "to", "step"), "one_of"
MOST = 1000
"""So many values of one name at most."""
EXAMPLE = "{from: 1 kg, to: 5 kg, step: 0.5 kg}"


@record
class Variation:
    """The values that a given name may have, as a file writes them: `2.5 kg`."""

    name: str
    values: tuple[str, ...]
    mark: Mark
    in_given: bool = False
    """Does it stand in `given`, where the first value is that of the file itself?"""


def variations_of(node: Node, report: Report) -> tuple[Variation, ...]:
    """All that a file tells, from `variants` and from `given`; what is wrong goes into the report."""
    if not isinstance(node, Mapping):
        return ()
    given, variants = node.get("given"), node.get("variants")
    names = given.keys() if isinstance(given, Mapping) else ()
    found: dict[str, Variation] = {}
    for key, value in [] if variants is None else reading.pairs(variants, "variants", report, f"m: {EXAMPLE}"):
        if key.text not in names:
            hint = reading.did_you_mean(key.text, names, "there are ") or "give it a value under `given` first"
            report.add(key.mark, "PL343", f"'{key.text}' is no given name, so it has no variants", hint)
        found[key.text] = Variation(key.text, _values(key, value, report, _given_value(given, key.text)), key.mark)
    for key, value in given.pairs if isinstance(given, Mapping) else ():
        if not isinstance(value, Mapping):
            continue
        if key.text in found:
            report.add(value.mark, "PL343", f"{key.text} has variants twice", "leave one of them out")
        found[key.text] = Variation(key.text, _values(key, value, report, None), key.mark, in_given=True)
    return tuple(found.values())


def _given_value(given: Node | None, name: str) -> Side | None:
    """The value that the file itself has, where it can be read."""
    node = given.get(name) if isinstance(given, Mapping) else None
    return reading.side(node, f"the value of {name}", Report()) if isinstance(node, Scalar) else None


def with_first_values(node: Node) -> Node:
    """The file with the first value of each range or list that stands in `given`, there and in its cases."""
    if not isinstance(node, Mapping):
        return node
    return Mapping(tuple((key, _first(key.text, value)) for key, value in node.pairs), node.mark)


def _first(key: str, node: Node) -> Node:
    if key == "given" and isinstance(node, Mapping):
        return Mapping(tuple((k, _first_value(v)) for k, v in node.pairs), node.mark)
    return node


def _first_value(node: Node) -> Node:
    if not isinstance(node, Mapping):
        return node
    found = node.get("from") or node.get(CHOICE)
    if isinstance(found, Sequence) and found.items:
        found = found.items[0]
    return found if isinstance(found, Scalar) else node


def with_values(node: Node, values: Dict[str, str]) -> Node:
    """The file with other values of given names, which then vary no more."""
    if not isinstance(node, Mapping):
        return node
    kept = ((k, v) for k, v in node.pairs if k.text != "variants")
    return Mapping(tuple((k, _put_in(v, values) if k.text == "given" else v) for k, v in kept), node.mark)


def _put_in(node: Node, values: Dict[str, str]) -> Node:
    if not isinstance(node, Mapping):
        return node
    pairs = ((k, Scalar(values[k.text], False, v.mark, v.mark) if k.text in values else v) for k, v in node.pairs)
    return Mapping(tuple(pairs), node.mark)


# --- values ----------------------------------------------------------------------------------------------------------


def _values(key: Scalar, node: Node, report: Report, given: Side | None) -> tuple[str, ...]:
    what = f"the variant {key.text}"
    if isinstance(node, Sequence):
        return _listed(key, node.items, report, given)
    if isinstance(node, Mapping) and node.get(CHOICE) is not None:
        fields = Fields(node, (CHOICE,), what, report)
        choice = fields.node(CHOICE)
        items = [] if choice is None else reading.items(choice, CHOICE, report, "[3 m, 4 m]")
        return _listed(key, items, report, given)
    fields = Fields(node, RANGE, what, report, example=f"{key.text}: {EXAMPLE}")
    sides = [fields.need_side(part, f"write `{EXAMPLE}`") for part in RANGE]
    numbers = [number_of(side) for side in sides]
    if any(n is None for n in numbers):
        if fields.readable and len(fields.present()) == len(RANGE):
            report.add(node.mark, "PL343", f"{what}: a range has plain numbers", f"write `{EXAMPLE}`")
        return ()
    first = fields.node(RANGE[0])
    if given is not None and isinstance(first, Scalar):
        _check_kind(first, sides[0], given, report)
    return _range(what, [n for n in numbers if n is not None], node.mark, report)


def _listed(key: Scalar, items: Iterable[Node], report: Report, given: Side | None) -> tuple[str, ...]:
    """The values of a list; those without a given value beside them are told by the first."""
    found: list[str] = []
    for item in items:
        side = reading.side(item, f"a value of {key.text}", report)
        given = given or side
        if isinstance(item, Scalar):
            _check_kind(item, side, given, report)
            found.append(item.text)
    if len(found) > MOST:
        report.add(key.mark, "PL343", f"{key.text} has {len(found)} values; {MOST} are allowed")
    return tuple(found)


def _check_kind(item: Scalar, side: Side, given: Side, report: Report) -> None:
    """A value is of the kind of the given one: 20 for an angle in degrees would be 20 radians. A bare zero is zero."""
    value, due = number_of(side), number_of(given)
    if value is None or due is None:
        return
    (number, unit), (size, wanted) = value, due
    same = unit.dimension == wanted.dimension and unit.angle == wanted.angle
    if same or (not number and unit.text == "1") or (not size and wanted.text == "1"):
        return
    its = f"the unit {unit.text}" if unit.text != "1" else "no unit"
    of = f"the given value has {wanted.text}" if wanted.text != "1" else "the given value has none"
    fits = f"{written(number)} {wanted.text}".removesuffix(" 1")
    hint = f"write `{fits}`" if "1" in (unit.text, wanted.text) else f"write it in {wanted.text}"
    report.add(item.mark, "PL343", f"the variant '{item.text}' has {its}, {of}", hint)


def number_of(side: Side) -> tuple[Fraction, Unit] | None:
    """A plain number with its unit; None: it is none."""
    if isinstance(side, Negate):
        inner = number_of(side.operand)
        return None if inner is None else (-inner[0], inner[1])
    if not isinstance(side, Number):
        return None
    try:
        return side.value * (side.sense or 1), parse_unit(side.unit or "1")
    except UnitError:
        return None


def _range(what: str, numbers: list[tuple[Fraction, Unit]], mark: Mark, report: Report) -> tuple[str, ...]:
    (low, unit), high, step = numbers
    if any(u.dimension != unit.dimension or u.pi_power != unit.pi_power for _, u in (high, step)):
        report.add(mark, "PL343", f"{what}: from, to and step have different units", f"write `{EXAMPLE}`")
        return ()
    end, stride = (n * u.factor / unit.factor for n, u in (high, step))
    if stride <= 0 or end < low:
        report.add(mark, "PL343", f"{what}: it goes up from `from` to `to`, by a positive step", f"write `{EXAMPLE}`")
        return ()
    count = int((end - low) / stride) + 1
    if count > MOST:
        report.add(mark, "PL343", f"{what} has {count} values; {MOST} are allowed", "take a larger step")
        return ()
    return tuple(f"{written(low + k * stride)} {unit.text}".removesuffix(" 1") for k in range(count))


def written(number: Fraction) -> str:
    """A fraction as a decimal number where it is one, else as a quotient."""
    for places in range(16):
        scaled = number * 10**places
        if scaled.denominator == 1:
            text = f"{abs(scaled.numerator):0{places + 1}d}"
            whole, part = text[: len(text) - places], text[len(text) - places :]
            return f"{'-' if number < 0 else ''}{whole}{'.' + part if part else ''}"
    return f"({number.numerator}/{number.denominator})"
