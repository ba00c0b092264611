"""What a student typed, read: one finite number or a pair with its unit, a direction in words, a word, or a formula.

    12.5 N    1.25*10^1 N    12,5 N (where a comma is a decimal point)    25/2 N    5*sqrt(2) m/s
    6.2 rad/s cw    9.81 m/s^2 down    10 N at 30 deg    [3, -4] m/s    3i - 4j m/s    yes    m*g*sin(beta)
    -9.4 1/s    250*cos(25°)/45 m/s^2    4 m/s (to the left)    4 m/s down the slope (words behind a unit are not read)

Whatever cannot be read raises Unreadable with a sentence to the student. Nothing typed is ever executed.
"""

from __future__ import annotations

import math
import re
from dataclasses import replace

from planar_cli.homework.typed.typed_directions import SENSES, WAYS, along_line, with_words_behind, without_direction
from planar_cli.homework.typed.typed_pairs import in_brackets
from planar_cli.homework.typed.typed_units import unit_of
from planar_cli.homework.typed.unreadable import Unreadable
from planar_cli.homework.typed.written_numbers import last_place, significant
from planar_cli.records import record
from planar_cli.units import Unit

LONGEST = 500
"""More characters are no answer."""
LARGEST = 1e50
MOST_UNCERTAIN = 0.05
"""Of a number: what may stand behind ±."""
SAID_TWICE = "say the same"
TWO_ASKED = "two components are asked, `[3, -4] m/s`, or magnitude and direction, `5 m/s at -53 deg`"
NO_ANSWER = "this is not an answer that can be read: a number with its unit is asked, such as `12.5 N`"

_SIGNS = str.maketrans({"−": "-", "–": "-", "⋅": "*", "·": "*", "×": "*", "µ": "u", "\u00a0": " ", "î": "i", "ĵ": "j"})
_RAISED = re.compile("[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+")
_POWERS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_NUMBER = r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?(?![0-9.])"
"""All digits of it: what is left of a number that was cut off is no unit."""
_PLAIN = re.compile(
    rf"({_NUMBER})(?:\s*(?:\*|x)\s*10\s*\^\s*\(?([+-]?[0-9]{{1,3}})\)?)?\s*((?:1\s*/\s*[A-Za-z(]|[^0-9\s(\[<.]).*)?"
)
_UNCERTAIN = re.compile(rf"({_NUMBER})\s*(?:±|\+/-|\+-)\s*([0-9]+(?:\.[0-9]+)?)\s*(.*)")
_RATIO = re.compile(rf"({_NUMBER})\s*/\s*([0-9]+(?:\.[0-9]+)?)\s*([A-Za-z].*)?")
_DECIMAL_COMMA = re.compile(r"(?<=[0-9]),(?=[0-9]{1,2}(?![0-9,]))|(?<=\b0),(?=[0-9])")
"""Of thousands three digits stand behind the comma."""
_PAIR = re.compile(rf"[\[(<]\s*({_NUMBER})\s*([^,;\])>]*)[,;]\s*({_NUMBER})\s*([^,;\])>]*)[\])>]\s*(.*)")
_BRACKET = re.compile(r"[\[(<]([^\])>]*)[\])>]\s*(.*)")
_SPACED = re.compile(rf"[\[(<]\s*({_NUMBER})\s+({_NUMBER})\s*[\])>]\s*(.*)")
_UNIT = r"(?:[A-Za-z]+[A-Za-z/*^0-9-]*\s+|[A-Za-z]+/[A-Za-z]+[0-9^]*\s*\*?\s*)?"
_IJ = re.compile(
    rf"\(?\s*({_NUMBER})\s*({_UNIT})\*?\s*i\s*([+-])\s*((?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+))\s*({_UNIT})\*?\s*j"
    r"\s*\)?\s*(.*)"
)
_BRACKETED_UNIT = re.compile(r"^([^\[\]]*[0-9])\s*\[([^\[\]]+)\]$")
_FROM_X = re.compile(
    rf"(.+?)\s*(?:@|,|\bat(?: an angle of)?\b|∠)?\s*({_NUMBER})\s*(?:deg|degrees|°)\s*(above|below)\s+(?:the\s+)?"
    r"(positive\s+|negative\s+|\+\s*|-\s*|)x(?:[- ]axis)?"
)
_POLAR = re.compile(rf"(.+?)\s*(?:@|\bat(?: an angle of)?\b|∠|,\s*angle)\s*({_NUMBER})\s*(deg|degrees|rad|°)?")

_NAMED = re.compile(
    r"^(?:\\?[^\W\d][\w{}]*\s*(?:\([\w ]{1,20}\)\s*)?)?[=≈≃~]\s*"
    r"|^(?i:approx(?:\.|imately)?|ca\.?|about|around|roughly)\s+"
)
"""What may stand before an answer: `a = 3 m/s^2`, `≈ 3 m/s^2`, `about 3 m/s^2`."""
_BEHIND = re.compile(r"(?<=[0-9)}i.°π½⅓⅔¼¾⅛⅜])\s+(?=[A-Za-z°])")
"""Between arithmetic and a unit behind it, where no bracket is open."""
_ARITHMETIC = re.compile(r"[0-9+.(√π½⅓⅔¼¾⅛⅜-]|pi\b|\\(?:frac|sqrt)\b")
_OPERATED = re.compile(r"[\w)]\s*[*/^(]")
"""Where one begins, and what stands in one."""
_GOES_ON = re.compile(r"[-*/+^√π½⅓⅔¼¾⅛⅜]|(?:pi|sqrt|sin|cos|tan)\b")
"""What begins so behind a number is no unit."""
_FUNCTION = re.compile(r"sin|cos|tan")
_DEGREES = re.compile(r"(?<=[0-9.])\s*(?:degrees|deg)\b")
_AT = ("@", "∠", " at ", "angle", "above", "below")
_ONLY_WORDS = re.compile(r"[A-Za-z][A-Za-z ,.;'’()-]*")
_NO_END_OF_A_UNIT = frozenset({"in", "at", "a", "to", "per"})
_OF_UNITS = frozenset({"per", "times", "or", "and", "by"})
"""What is begun so is more of a unit, or another answer: not to be passed over."""

_WORDS = {
    **dict.fromkeys(("yes", "true", "y", "t"), "yes"),
    **dict.fromkeys(("no", "false", "n", "f"), "no"),
    **dict.fromkeys(("slip", "slips", "slides", "sliding", "slipping"), "slip"),
    **dict.fromkeys(("stick", "sticks", "rolls", "rolling", "does not slip", "no slip"), "stick"),
    **dict.fromkeys(("apart", "lifts off", "leaves", "loses contact"), "apart"),
    **dict.fromkeys(("tip", "tips", "tipping", "tips over"), "tip"),
    **dict.fromkeys(("taut", "tight"), "taut"),
    **dict.fromkeys(("slack", "loose"), "slack"),
}


@record
class Typed:
    """One answer as typed; of a vector that is told without its direction one number.

    `unit`: None where none was; `figures`: significant figures of each number as written.

    `sense`: 1 counterclockwise, -1 clockwise, 0 not said. `axis`, `way`: of a direction in words, "" and 0 if none.
    `polar`: magnitude and direction, the direction in radians. Of `word` and `formula` one at most is there.
    """

    values: tuple[float, ...] = ()
    unit: Unit | None = None
    figures: tuple[int, ...] = ()
    sense: int = 0
    axis: str = ""
    way: int = 0
    polar: bool = False
    angle_place: float = 0.0
    """Of that direction: a unit in the last place that was typed, in radians."""
    word: str = ""
    formula: str = ""
    unread: str = ""
    """Words behind the unit that say nothing by themselves."""
    notes: tuple[str, ...] = ()
    """How it was read, where it could be read otherwise; to the student."""


def read(text: str, kind: str, comma: bool = False) -> Typed:
    """An answer to a find of a kind. `comma`: 12,5 is twelve and a half. Raises Unreadable."""
    plain = text.strip() if text.isascii() else _in_plain_signs(text)
    if kind in ("vector", "number") and ("," in plain or ";" in plain or " and " in plain):
        plain = in_brackets(_with_points(plain) if comma else plain, kind == "vector")
    if kind != "equation":
        plain = _NAMED.sub("", plain, count=1)
    if not plain:
        raise Unreadable("nothing was typed")
    if len(plain) > LONGEST:
        raise Unreadable(f"an answer is at most {LONGEST} characters long")
    if not plain.isprintable():
        raise Unreadable("there is a character that cannot be seen")
    if kind == "word":
        return _word(plain)
    if kind in ("formula", "equation"):
        return Typed(formula=plain)
    plain, uncertain = _without_uncertainty(plain)
    if comma or (kind in ("vector", "list") and ";" in plain):
        plain = _with_points(plain)
    if kind == "list":
        return _list(plain)
    plain = with_words_behind(plain)
    found = _vector(plain) if kind == "vector" else _number(plain)
    return replace(found, notes=(*found.notes, *uncertain)) if uncertain else found


def _with_points(text: str) -> str:
    """With decimal points for decimal commas."""
    return re.sub(r"(?<=[0-9]),(?=[0-9])", ".", text)


def _in_plain_signs(text: str) -> str:
    return _RAISED.sub(lambda m: f"^{m[0].translate(_POWERS)}", text).translate(_SIGNS).strip()


def _without_uncertainty(text: str) -> tuple[str, tuple[str, ...]]:
    """`533 ± 1 N` is 533 N: the answer is one number, and what it may be off is small and not read."""
    if "±" not in text and "+/-" not in text and "+-" not in text:
        return text, ()
    found = _UNCERTAIN.fullmatch(text)
    if found is None or not 0 <= float(found[2]) <= MOST_UNCERTAIN * abs(float(found[1])):
        raise Unreadable("one number is asked, not an interval")
    return f"{found[1]} {found[3]}", (f"not read: '± {found[2]}'",)


def _word(text: str) -> Typed:
    word = _WORDS.get(" ".join(text.lower().rstrip(".!").split()))
    if word is None:
        raise Unreadable(f"'{text[:40]}' is none of the words that may stand here, such as yes or no, slips or sticks")
    return Typed(word=word)


# --- numbers ---------------------------------------------------------------------------------------------------------


def _number(text: str) -> Typed:
    if _is_bracketed_pair(text) or ("j" in text and _IJ.fullmatch(text)):
        return _vector(text)
    if "," in text:
        text = _DECIMAL_COMMA.sub(".", text)
    if "," in text and (number := re.search(r"[0-9]+,[0-9]+", text)) is not None:
        whole, point = number[0].replace(",", ""), number[0].replace(",", ".")
        raise Unreadable(f"the comma in {number[0][:30]} can mean two things; write {whole[:30]} or {point[:30]}")
    if any(word in text for word in _AT) and (polar := _polar(text)) is not None:
        return polar
    plain, sense, axis, way = without_direction(text)
    plain = _BRACKETED_UNIT.sub(r"\1 \2", plain) if plain.endswith("]") else plain
    value, unit, figures, unread = _quantity(plain)
    if (sense or way) and any(word.strip("(),.") in WAYS or word in SENSES for word in unread.lower().split()):
        raise Unreadable("two directions stand behind the number; write one of them, or a sign")
    value, said_twice = _once(value, sense or way, text)
    return Typed((value,), unit, (figures,), sense, axis, way, unread=unread, notes=(*said_twice, *_not_read(unread)))


def _once(value: float, way: int, text: str) -> tuple[float, tuple[str, ...]]:
    """A number before a sense or direction in words, and how a minus sign before it is read: to the left and clockwise
    say again what it says; of right and counterclockwise it makes the opposite.
    """
    if not way or value >= 0:
        return value, ()
    if way < 0:
        return -value, (
            f"the minus sign and the words behind the number {SAID_TWICE}: read as {text.lstrip('-')[:40]}",
        )
    return value, ("the minus sign is read as the opposite of the words behind the number",)


def _not_read(words: str) -> tuple[str, ...]:
    return (f"not read: '{words[:40]}'",) if words else ()


def _polar(text: str) -> Typed | None:
    """Magnitude and direction; None: it is written otherwise."""
    from_x, polar = _FROM_X.fullmatch(text), _POLAR.fullmatch(text)
    if from_x is not None:
        before, number, unit_of_angle = from_x[1], from_x[2], "deg"
        angle = _from_plus_x(float(number), from_x[3], from_x[4])
    elif polar is not None:
        before, number, unit_of_angle = polar[1], polar[2], polar[3]
        angle = float(number)
    else:
        return None
    size, unit, figures_of_size, unread = _quantity(before)
    if size < 0:
        raise Unreadable("a magnitude is not negative")
    degrees = 1.0 if unit_of_angle == "rad" else math.pi / 180
    figures, place = (figures_of_size, significant(number)), last_place(number) * degrees
    return Typed((size, angle * degrees), unit, figures, polar=True, angle_place=place, notes=_not_read(unread))


def _quantity(text: str) -> tuple[float, Unit | None, int, str]:
    """A number with its unit, its significant figures, and words behind it that say nothing."""
    ratio = _RATIO.fullmatch(text)
    if ratio is not None and float(ratio[2]):
        figures = 15
        return _finite(float(ratio[1]) / float(ratio[2])), *_unit_and_words(ratio[3], figures)
    plain = _PLAIN.fullmatch(text)
    if plain is not None:
        behind = plain[3] or ""
        if behind.startswith("/") and behind[1:].lstrip()[:1].isalpha():
            # 4.1/s
            behind = f"1{behind}"
        if not _GOES_ON.match(behind):
            value = float(plain[1]) * 10.0 ** int(plain[2] or 0)
            return _finite(value), *_unit_and_words(behind, significant(plain[1]))
    return _computed(text)


def _unit_and_words(text: str | None, figures: int) -> tuple[Unit | None, int, str]:
    """The unit at the beginning of a text, the figures passed on, and the words behind the unit."""
    plain = (text or "").strip()
    try:
        return _unit(plain), figures, ""
    except Unreadable:
        words = plain.split(" ")
        for count in range(len(words) - 1, 0, -1):
            rest = " ".join(words[count:]).strip(" ,;")
            if words[count - 1].lower() in _NO_END_OF_A_UNIT or not _ONLY_WORDS.fullmatch(rest.lstrip("(")):
                continue
            if rest.split(" ")[0].lower() in _OF_UNITS:
                break
            try:
                return _unit(" ".join(words[:count]).rstrip(",;")), figures, rest
            except Unreadable:
                continue
        raise


def _computed(text: str) -> tuple[float, Unit | None, int, str]:
    """Arithmetic without names, `5*sqrt(2) m/s`, `√(2*9.81) m/s`, `9.81 cos 25° m/s^2`."""
    from planar_cli.homework.typed.typed_formula import arithmetic

    if not (_ARITHMETIC.match(text) or _OPERATED.search(text)) or "<" in text:
        raise Unreadable(NO_ANSWER)
    if _FUNCTION.search(text):
        text = _DEGREES.sub("°", text)
    why_not = None
    for behind in _BEHIND.finditer(text):
        number = text[: behind.start()]
        if number.count("(") != number.count(")") or number.count("{") != number.count("}"):
            continue
        try:
            return _finite(arithmetic(number)), *_unit_and_words(text[behind.end() :], 15)
        except Unreadable as why:
            # Behind `2` in `2 sqrt(2) m/s` no unit begins yet.
            why_not = why
    try:
        return _finite(arithmetic(text)), None, 15, ""
    except Unreadable as why:
        raise why_not or why from None


def _finite(value: float) -> float:
    if not math.isfinite(value) or abs(value) > LARGEST:
        raise Unreadable("the number is not finite, or too large")
    return value


def _unit(text: str | None) -> Unit | None:
    plain = (text or "").strip().strip("[]()").strip()
    return unit_of(plain) if plain else None


def _from_plus_x(angle: float, side: str, end: str) -> float:
    """The direction that `19.8 deg below +x` tells, counterclockwise from +x."""
    turned = angle if side == "above" else -angle
    return 180 - turned if end.strip() in ("-", "negative") else turned


# --- pairs and lists -------------------------------------------------------------------------------------------------


def _is_bracketed_pair(text: str) -> bool:
    return text[0] in "[<" and (_PAIR.fullmatch(text) or _SPACED.fullmatch(text)) is not None


def _vector(text: str) -> Typed:
    if text.startswith("{"):
        text = text.translate(str.maketrans("{}", "[]"))
    spaced = _SPACED.fullmatch(text)
    if spaced is not None:
        text = f"[{spaced[1]}, {spaced[2]}] {spaced[3]}"
    pair, unit_vectors = _PAIR.fullmatch(text), _IJ.fullmatch(text)
    if pair is not None:
        return _of_two((pair[1], pair[3]), (pair[2], pair[4], pair[5]))
    if unit_vectors is not None:
        x, first, sign, y, second, behind = unit_vectors.groups()
        return _of_two((x, sign + y), (first, second, behind))
    polar = _polar(text)
    if polar is not None:
        return polar
    plain, sense, axis, way = without_direction(text)
    if not sense and _PLAIN.fullmatch(plain) is not None:
        size, unit, figures_of_size, unread = _quantity(plain)
        size, said_twice = _once(size, way, text)
        figures, notes = (figures_of_size, figures_of_size), (*said_twice, *_not_read(unread))
        if unread and axis == "y" and along_line(f"{unread} up"):
            # `17.0 N along the ramp, down`
            unread, way = f"{unread} {'up' if way > 0 else 'down'}", 0
        if not way:
            return Typed((size,), unit, figures[:1], unread=unread, notes=notes)
        return Typed((way * size, 0.0) if axis == "x" else (0.0, way * size), unit, figures, notes=notes)
    raise Unreadable(TWO_ASKED)


def _of_two(numbers: tuple[str, str], behind: tuple[str, ...]) -> Typed:
    """A vector of two components, with the unit that stands behind one of them or both."""
    units = [u for u in map(_unit, behind) if u is not None]
    if any(u.text != units[0].text for u in units[1:]):
        raise Unreadable("the two components have different units")
    x, y = (_finite(float(n)) for n in numbers)
    return Typed((x, y), units[0] if units else None, (significant(numbers[0]), significant(numbers[1])))


def _list(text: str) -> Typed:
    plain, behind = text, ""
    bracket = _BRACKET.fullmatch(text)
    if bracket is not None:
        plain, behind = bracket[1], bracket[2]
    entries = [_quantity(entry.strip()) for entry in re.split("[,;]", plain)]
    units = [u for u in (*(unit for _, unit, _, _ in entries), _unit(behind)) if u is not None]
    if any(u.text != units[0].text for u in units[1:]):
        raise Unreadable("the numbers have different units")
    notes = tuple(note for _, _, _, unread in entries for note in _not_read(unread))
    figures = tuple(f for _, _, f, _ in entries)
    return Typed(tuple(v for v, _, _, _ in entries), units[0] if units else None, figures, notes=notes)
