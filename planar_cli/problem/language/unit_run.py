"""The unit behind a number or bracket: the run of characters without a space, and why some runs are refused.

A unit and a product of names look alike (`2 N*m`, `2 m*g`), so that everything that could be read in two ways is
refused with both spellings.
"""

from __future__ import annotations

import re

from planar_cli.problem.language.tokens import Cursor, Token
from planar_cli.units import Unit, UnitError, is_habit, parse_unit

_POWER = r"\^\(-?[0-9]+/[0-9]+\)"
_RUN = re.compile(rf"(?:1/)?(?:{_POWER}|\^-(?=[0-9])|[A-Za-z0-9_.*/^])*")
_BRACKET = re.compile(rf"\((?:{_POWER}|[A-Za-z0-9*^])+\)")
_HYPHENATED = re.compile(
    r"(?:(?:kg|slug|lb)-(?:m|ft|in)\^2|(?:k?N|lbf?|ft|in|kip)-(?:m|s|ft|in|lbf?))(?![A-Za-z0-9_(])"
)
_ENDS = frozenset(("is", "at", "during", "cw", "ccw"))


def unit_follows(cursor: Cursor, previous: Token, group: bool) -> bool:
    """Whether a unit stands at the cursor, behind the number or bracket that ended with `previous`.

    `in` is the inch only directly behind a number, and not where another unit follows it (`2*d in km`).
    """
    token = cursor.token
    if token.start == previous.end:
        return False
    if token.kind == "number":
        bracket = _BRACKET.match(cursor.text, token.start + 2)
        return cursor.text.startswith("1/", token.start) and (cursor.peek(2).kind == "name" or bracket is not None)
    if token.kind != "name" or token.text in _ENDS:
        return False
    if token.text != "in":
        return True
    following = cursor.peek()
    return not group and (following.kind != "name" or following.text in _ENDS or following.text == "in")


def read_unit(cursor: Cursor, first: Token, start: int, term_start: int) -> tuple[str, int]:
    """The unit at the cursor and its sense (-1 after `cw`).

    `first` is the first token of the atom (number or `(`) at index `start` of the tokens; `term_start` is the offset
    at which the product began.
    """
    begin = cursor.token
    run = _run(cursor.text, begin.start)
    number = cursor.text[first.start : begin.start].rstrip()
    previous = cursor.before(start)
    if previous is not None and previous.text == "/":
        _refuse_below(cursor, first, number, run, term_start)
    unit = _known_unit(cursor, begin, number, run)
    cursor.skip_to(begin.start + len(run))
    sense = _sense(cursor)
    _refuse_gram(cursor, begin, number, unit)
    if not _alone(cursor, previous, start) and "*" in re.sub(r"\(.*\)", "", run):
        hint = f"write `({number} {run})` in brackets if the unit is meant, `{number}*{run}` for a product of names"
        cursor.fail(f"the unit {run} stands inside a longer expression", hint, "PL204", begin)
    return run, sense


def _run(text: str, start: int) -> str:
    """The characters of the unit; a bracket belongs to it directly behind a stroke."""
    match = _HYPHENATED.match(text, start)
    if match:
        return match[0]
    match = _RUN.match(text, start)
    run = match[0] if match else ""
    bracket = _BRACKET.match(text, start + len(run))
    return run + bracket[0] if bracket and run.endswith("/") else run


def _refuse_below(cursor: Cursor, first: Token, number: str, run: str, term_start: int) -> None:
    whole = cursor.text[term_start : first.start] + number
    below = cursor.text[term_start : first.start] + f"({number} {run})"
    message = f"a unit behind a stroke can be read in two ways: {whole} {run}"
    cursor.fail(message, f"write `({whole}) {run}` or `{below}`", "PL204")


def _known_unit(cursor: Cursor, begin: Token, number: str, run: str) -> Unit:
    """The parsed unit of the run; raises ParseError with the repair that fits best."""
    behind = cursor.text[begin.start + len(run) : begin.start + len(run) + 1]
    if behind == "^":
        hint = f"write the power at each unit, as in `1/(m^(1/2)*s^(1/2))`, or `({number} {run})^…` of the whole"
        cursor.fail(f"a power behind the unit {run} can be read in two ways", hint, "PL204", begin)
    try:
        unit = parse_unit(run)
        if behind != "(":
            return unit
        error = UnitError(f"unknown unit `{run}`")
    except UnitError as problem:
        error = problem
    prefix = _unit_prefix(run)
    if prefix and not is_habit(error.atom):
        rest = run[len(prefix) :] + ("(…)" if behind == "(" else "")
        spaced = f" {rest[0]} {rest[1:]}".rstrip()
        hint = f"write `({number} {prefix}){rest}` or `{number} {prefix}{spaced}` if {prefix} is the unit"
        if _is_names(run):
            hint += f", `{number}*{prefix}{rest}` for a product of names"
        cursor.fail(f"the unit {prefix} runs on into {rest}", hint, "PL204", begin)
    if behind == "(":
        cursor.fail(f"between {number} and {run}(…) the sign is missing", f"write `{number}*{run}(…)`", "PL205", begin)
    product = f"`{number}*{run}` for a product" if _is_names(run) else ""
    hint = ", or ".join(filter(None, (error.hint, product)))
    if product and not error.hint:
        hint = f"write {product}"
    raise cursor.error(error.message.replace("`", ""), hint, "PL203", begin)


def _unit_prefix(run: str) -> str:
    """The longest beginning of the run that is a unit and ends before an operator; empty if there is none."""
    for match in reversed(list(re.finditer(r"[*/]", run))):
        prefix = run[: match.start()]
        try:
            parse_unit(prefix)
        except UnitError:
            continue
        return prefix
    return ""


def _is_names(run: str) -> bool:
    return re.fullmatch(r"[A-Za-z]\w*(?:[*/][A-Za-z]\w*)*", run) is not None


def _sense(cursor: Cursor) -> int:
    if cursor.is_word("cw", "ccw"):
        return -1 if cursor.take().text == "cw" else 1
    return 1


def _alone(cursor: Cursor, previous: Token | None, start: int) -> bool:
    """Whether number and unit are a whole side, a whole bracket, or that behind a minus."""
    if previous is not None and previous.text == "-":
        previous = cursor.before(start - 1)
    opened = previous is None or previous.text in ("(", "=", "<", ">", "<=", ">=")
    return opened and not cursor.is_sign("+", "-", "*", "/", "^")


def _refuse_gram(cursor: Cursor, begin: Token, number: str, unit: Unit) -> None:
    """`2 m*g` and `500 N/g` mean gravity, not the gram; only `g` alone or above a stroke is the gram."""
    if re.search(r"[*/]g(?![A-Za-z])|^g\*", unit.text):
        hint = f"write `{number}*{unit.text}` for a product of names; write the mass in `kg` if the gram is meant"
        cursor.fail(f"the gram in a product, {unit.text}, is taken for gravity", hint, "PL204", begin)
