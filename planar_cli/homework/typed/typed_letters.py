"""Formulas as students and keys write them, brought to the notation of problem files: text to text, nothing is valued.

    5/2 m g    mgl/2    √(3 g/l)    \\frac{3}{8}\\sqrt{3gl}    2 m g sin β    (1 - e²) m g l    SQRT(3*g/l)

Between letters that are known a missing sign is a product, where that is the only reading: `mgl` is m*g*l where m, g
and l are letters of the problem. What stands behind a stroke and a missing sign can be read in two ways, 3g/2l as
3*g/2*l or as 3*g/(2*l): both readings are told.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence

from planar_cli.homework.sets.printed_names import LETTERS
from planar_cli.homework.typed.unreadable import Unreadable
from planar_cli.records import record

FUNCTIONS = ("sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "abs")
_OTHERWISE = {"arcsin": "asin", "arccos": "acos", "arctan": "atan", "ln": "log", "root": "sqrt"}
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+")
_LOWERED = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_PARTS = {"½": "(1/2)", "⅓": "(1/3)", "⅔": "(2/3)", "¼": "(1/4)", "¾": "(3/4)", "⅛": "(1/8)", "⅜": "(3/8)"}
_MIXED = re.compile(r"(?<![\w.^/])([0-9]{1,3})(?:\s+([0-9]{1,3}/[0-9]{1,3})(?![0-9.])|\s*([½⅓⅔¼¾⅛⅜]))")
"""2½ and 2 1/2 are sums."""
MOST_BRACES = 40
"""So many fractions and roots of LaTeX are taken for what they are; an answer has a few."""
_FRACTION = re.compile(r"\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}")
_ROOT = re.compile(r"\\sqrt\s*\{([^{}]*)\}")
_SUBSCRIPT = re.compile(r"_\{([A-Za-z0-9]{1,20})\}")
_TOKEN = re.compile(
    r"\s*([0-9]+(?:\.[0-9]*)?(?:[eE][+-]?[0-9]+)?|\.[0-9]+|[A-Za-z][A-Za-z0-9]*(?:_[A-Za-z0-9_]+)?|\*\*|[-+*/^()°]|\S)"
)


@record
class _Token:
    """`kind`: number, name, function, or the character itself; `apart`: a space stands before it."""

    kind: str
    text: str
    apart: bool


def readings(text: str, letters: Collection[str]) -> tuple[str, ...]:
    """One text, or two where a stroke can be read in two ways: first that in which it ends before the missing sign.

    Unreadable: a run of letters can be split in several ways.
    """
    tokens = _with_roots(list(_tokens(plain(text), letters)))
    ends_before = _written(tokens, below=False)
    goes_on = _written(tokens, below=True)
    return (ends_before,) if ends_before == goes_on else (ends_before, goes_on)


def plain(text: str) -> str:
    """Signs of print and of LaTeX in plain characters; Greek letters by their names."""
    if "\\" in text:
        text = _without_latex(text)
    text = re.sub(r"[⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺]+", lambda m: f"^({m[0].translate(_RAISED)})", text)
    text = re.sub(r"(?<=\w)[₀₁₂₃₄₅₆₇₈₉]+", lambda m: m[0].translate(_LOWERED), text)
    text = re.sub(r"(?<=[0-9]),(?=[0-9]{1,2}(?![0-9]))", ".", text)
    text = _MIXED.sub(lambda m: f"({m[1]}+{m[2] or _PARTS[m[3]]})", text)
    for sign, written in (*_PARTS.items(), *LETTERS.items()):
        if sign in text:
            # A letter of its own, whatever stands beside it.
            text = re.sub(rf"(?<![_]){sign}", f" {written}" if written.isalpha() else written, text)
            text = text.replace(sign, written)
    return text.translate(str.maketrans("[]{}", "()()")) if not text.isascii() or re.search(r"[\[\]{}]", text) else text


def _without_latex(text: str) -> str:
    text = re.sub(r"\\(?:left|right|displaystyle|,|;|!|:|quad|mathrm|text)(?![a-z])|\$", " ", text)
    text = re.sub(r"\\(?:cdot|times)(?![a-z])", "*", _SUBSCRIPT.sub(r"_\1", text))
    for _ in range(MOST_BRACES):
        found = _ROOT.sub(r" sqrt(\1)", _FRACTION.sub(r" ((\1)/(\2))", text))
        if found == text:
            break
        text = found
    return re.sub(r"\\(?=[A-Za-z])", " ", text)


def _tokens(text: str, letters: Collection[str]) -> Iterator[_Token]:
    place = 0
    for match in _TOKEN.finditer(text):
        word, apart = match[1], bool(match.start(1) > place) or match.start(1) > match.start()
        place = match.end()
        if word[0].isdigit() or word[0] == ".":
            yield _Token("number", word, apart)
        elif word[0].isalpha() and word.isascii():
            yield from _names(word, letters, apart)
        else:
            yield _Token("^" if word == "**" else word, "^" if word == "**" else word, apart)


def _names(word: str, letters: Collection[str], apart: bool) -> Iterator[_Token]:
    """A word: a letter, a function, or several of them written together; of an unknown word nothing is made."""
    for number, part in enumerate(_parts(word, letters)):
        name = _function(part) if part not in letters else ""
        yield _Token("function" if name else "name", name or part, apart and not number)


def _function(word: str) -> str:
    low = word.lower()
    low = _OTHERWISE.get(low, low)
    return low if low in FUNCTIONS else ""


def _parts(word: str, letters: Collection[str]) -> tuple[str, ...]:
    if word in letters or word == "pi" or _function(word):
        return (word,)
    known = (*letters, "pi", *(f for f in FUNCTIONS if f not in letters))
    # How many ways lead to each place of the word, and the last part of one of them.
    ways, last = [1, *[0] * len(word)], [""] * (len(word) + 1)
    for end in range(1, len(word) + 1):
        for name in known:
            if word.endswith(name, 0, end) and ways[end - len(name)]:
                ways[end] += ways[end - len(name)]
                last[end] = name
    if ways[-1] > 1:
        raise Unreadable(f"'{word[:40]}' can be split into letters in several ways; write the signs of the products")
    parts: list[str] = []
    end = len(word) if ways[-1] else 0
    while end:
        parts.insert(0, last[end])
        end -= len(last[end])
    if not parts and "_" not in word and (digits := re.fullmatch(r"([A-Za-z]+)([0-9]+)", word)):
        # m₁ of a file that writes m_1
        joined = f"{digits[1]}_{digits[2]}"
        return (joined,) if joined in letters else (word,)
    return tuple(parts) or (word,)


def _with_roots(tokens: list[_Token]) -> list[_Token]:
    """The sign of a root as the function, which takes the bracket, number or letter behind it."""
    found = []
    for number, token in enumerate(tokens):
        if token.kind != "√":
            found.append(token)
            continue
        behind = tokens[number + 1 : number + 3]
        if [t.kind for t in behind] == ["number", "name"] and not behind[1].apart:
            raise Unreadable("it is not clear where the root ends; write `sqrt(…)`")
        found.append(_Token("function", "sqrt", token.apart))
    return found


def _written(tokens: Sequence[_Token], below: bool) -> str:
    """The tokens with all signs written. `below`: what stands behind a stroke goes on through missing signs."""
    return _Writer(tokens, below).all()


class _Writer:
    """Goes through the tokens once, from left to right."""

    def __init__(self, tokens: Sequence[_Token], below: bool) -> None:
        self.tokens, self.below, self.place = tokens, below, 0

    def all(self) -> str:
        return "".join(self._until(""))

    def _kind(self, ahead: int = 0) -> str:
        at = self.place + ahead
        return self.tokens[at].kind if at < len(self.tokens) else ""

    def _take(self) -> str:
        self.place += 1
        return self.tokens[self.place - 1].text

    def _until(self, closing: str) -> list[str]:
        """What stands before a closing bracket, or the end."""
        found: list[str] = []
        while self._kind() and self._kind() != closing:
            if self._kind() == "/" and self.place and self._operand(1):
                self._take()
                found += ["/", self._below()]
            elif self._operand():
                found.append(self._factor())
                self._check_number()
                if self._operand():
                    found.append("*")
            else:
                found.append(self._take())
        return found

    def _below(self) -> str:
        """The divisor."""
        first = self._factor()
        factors = [first]
        fraction = self._is_fraction()
        while self._operand() and self._kind() != "number" and self.below and not fraction:
            factors.append(self._factor())
        self._check_number()
        behind = "*" if self._operand() else ""
        return (f"({'*'.join(factors)})" if len(factors) > 1 else first) + behind

    def _check_number(self) -> None:
        """No number stands behind a factor: `l 2` may be meant as a power, an index or a product."""
        if self._kind() == "number":
            before, number = self.tokens[self.place - 1].text, self.tokens[self.place].text
            raise Unreadable(f"between {before[:20]} and {number[:20]} the sign is missing")

    def _is_fraction(self) -> bool:
        """Is the divisor just taken a number below a number, with a space behind: 5/2 m g, as keys print it?"""
        numbers = [t.kind for t in self.tokens[max(self.place - 3, 0) : self.place]] == ["number", "/", "number"]
        before = self.tokens[self.place - 4].kind if self.place > 3 else ""
        return (
            numbers
            and before in ("", "+", "-", "(", "*")
            and self.place < len(self.tokens)
            and (self.tokens[self.place].apart)
        )

    def _operand(self, ahead: int = 0) -> bool:
        return self._kind(ahead) in ("number", "name", "function", "(")

    def _factor(self) -> str:
        """A number, letter, bracket or function with what it is raised to."""
        base = self._atom()
        if self._kind() == "^":
            return f"{base}{self._power()}"
        return base

    def _power(self) -> str:
        sign = self._take()
        while self._kind() in ("-", "+"):
            sign += self._take()
        return f"{sign}{self._atom()}" if self._operand() else sign

    def _atom(self) -> str:
        kind = self._kind()
        if kind == "(":
            self._take()
            inside = "".join(self._until(")"))
            return f"({inside}{self._take() if self._kind() == ')' else ''}"
        if kind == "function":
            return self._called()
        number = self._take()
        # An angle in degrees stays with its number.
        return f"{number}{self._take()}" if kind == "number" and self._kind() == "°" else number

    def _called(self) -> str:
        name = self._take()
        power = self._power() if self._kind() == "^" else ""
        if self._kind() == "(":
            inside = self._atom()
        elif self._operand():
            first = self._kind()
            inside = self._atom()
            if first == "number" and self._kind() == "name":
                inside = f"{inside}*{self._atom()}" if name != "sqrt" else inside
            inside = f"({inside})"
        else:
            return f"{name}{power}"
        return f"({name}{inside}){power}" if power else f"{name}{inside}"
