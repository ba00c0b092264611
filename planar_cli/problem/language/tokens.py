"""The lexer of expressions: hostile-input safe, exact columns, and a cursor for the parser."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import Literal, NoReturn

from planar_cli.errors import Diagnostic, Mark, PlanarError
from planar_cli.records import record

MAX_LENGTH = 2000
MAX_TOKENS = 1500
MAX_DIGITS = 40
MAX_NAME = 40

Kind = Literal["number", "name", "sign", "end"]


@record
class Token:
    """One piece of an expression; `start` and `end` are offsets in its text."""

    kind: Kind
    text: str
    start: int
    end: int


class ParseError(PlanarError):
    """An expression that cannot be read; carries one diagnostic."""

    def __init__(self, message: str, hint: str, code: str, mark: Mark) -> None:
        super().__init__(message)
        self.diagnostic = Diagnostic(mark, code, message, hint)


_NUMBER = re.compile(r"(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
_SIGN = re.compile(r"->|<=|>=|==|=>|=<|!=|<>|\*\*|[-+*/^().,=<>@]")
_DATE = re.compile(r"[0-9]{4}-[0-9]{2}-[0-9]{2}(?![0-9])")

TABLE = re.compile(r"\{ *table *:")
TABLE_IN_A_LINE = (
    "a table stands alone as a magnitude, a moment or a rate of `loads`",
    "in `motion` write a law for each stretch: `a(P).x = 2 m/s^2 during 1->2`",
)
"""What to say of a table inside a statement: the message and the hint."""

# Characters that a keyboard, a word processor or another program puts in, and what to write for them.
_INSTEAD = {
    "·": "`*`",
    "×": "`*`",
    "⋅": "`*`",
    "÷": "`/`",
    "−": "`-`",
    "–": "`-`",
    "—": "`-`",
    "°": "` deg`",
    "²": "`^2`",
    "³": "`^3`",
    "√": "`sqrt(…)`",
    "½": "`1/2`",
    "≤": "`<=`",
    "≥": "`>=`",
    "→": "`->`",
    "∞": "`infinity`",
    "±": "one relation for each sign",
    "%": "a fraction, `0.05`",
    ":": "a plain number with its unit, `90 s` instead of `1:30`",
    "?": "the name of an unknown, declared under `unknowns`",
    ";": "two entries of the list",
    "[": "a round bracket; `[x, y]` only stands by itself",
    "]": "a round bracket; `[x, y]` only stands by itself",
    "{": "a round bracket",
    "}": "a round bracket",
    "|": "`abs(…)`, or the part `.mag` of a vector",
    "!": "nothing: factorials and `!=` are not part of the language",
    "&": "two entries of the list",
    "'": "`dot(…)` for a rate; quotes do not belong in an expression",
    '"': "nothing: quotes do not belong in an expression",
    "_": "a name that begins with a letter",
    "#": "the comment on a line of its own",
    "$": "plain text, no LaTeX",
    "\\": "plain text, no LaTeX",
    "\n": "the expression on one line",
    "\t": "a space",
    "\xa0": "an ordinary space",
}
_GREEK_LETTERS = "αβγδεζηθικλμνξπρστφχψω"
_GREEK_NAMES = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau phi chi psi omega"
)
_GREEK = dict(zip(_GREEK_LETTERS, _GREEK_NAMES.split(), strict=True))


def tokenize(text: str, mark: Mark) -> list[Token]:
    """The tokens of one line, an `end` token last; raises ParseError at the first thing that cannot stand."""
    if len(text) > MAX_LENGTH:
        raise ParseError(f"an expression is at most {MAX_LENGTH} characters long", "name its parts", "PL207", mark)
    tokens: list[Token] = []
    position = 0
    while position < len(text):
        if text[position] == " ":
            position += 1
            continue
        token = _token(text, position, mark)
        tokens.append(token)
        position = token.end
    if len(tokens) > MAX_TOKENS:
        raise ParseError("an expression has too many parts", "name some of them under `given`", "PL207", mark)
    tokens.append(Token("end", "", len(text.rstrip(" ")), len(text)))
    return tokens


def _token(text: str, position: int, mark: Mark) -> Token:
    if match := _NUMBER.match(text, position):
        _check_number(text, match, mark)
        return Token("number", match[0], position, match.end())
    if match := _NAME.match(text, position):
        if len(match[0]) > MAX_NAME:
            raise ParseError(f"a name is at most {MAX_NAME} characters long", "", "PL207", mark.shifted(position))
        return Token("name", match[0], position, match.end())
    if match := _SIGN.match(text, position):
        return Token("sign", match[0], position, match.end())
    if TABLE.match(text, position):
        raise ParseError(*TABLE_IN_A_LINE, "PL202", mark.shifted(position))
    raise _bad_character(text[position], mark.shifted(position))


def _bad_character(character: str, mark: Mark) -> ParseError:
    shown = character if character.isprintable() else f"U+{ord(character):04X}"
    instead = _INSTEAD.get(character)
    if character.lower() in _GREEK:
        name = _GREEK[character.lower()]
        instead = f"`{name if character.islower() else name.capitalize()}`"
    hint = f"write {instead}" if instead else "letters A to Z, digits, `_` and `+ - * / ^ ( ) . = < > @` are allowed"
    return ParseError(f"the character {shown} cannot stand in an expression", hint, "PL202", mark)


def _check_number(text: str, match: re.Match[str], mark: Mark) -> None:
    """Refuse dates, `0x1F`, `1_000`, `2m`, `1.2.3`, and numbers that are too long."""
    place = mark.shifted(match.start())
    number = match[0]
    if _DATE.match(text, match.start()):
        hint = "put spaces round the minus if a difference is meant"
        raise ParseError("a date is not a number", hint, "PL206", place)
    mantissa, _, exponent = number.lower().partition("e")
    if len(mantissa) > MAX_DIGITS or len(exponent.lstrip("+-")) > 3:
        message = f"a number has at most {MAX_DIGITS} digits and an exponent of at most three"
        raise ParseError(message, "", "PL206", place)
    following = text[match.end() : match.end() + 1]
    if following == ".":
        raise ParseError("a number has one decimal point", "", "PL206", place)
    if following == "_":
        plain = re.match(r"[0-9._]*", text[match.start() :])
        digits = plain[0].replace("_", "") if plain else number
        raise ParseError("digits are not grouped with `_`", f"write `{digits}`", "PL206", place)
    if following.isalpha():
        raise _glued(text, match, place)


def _glued(text: str, match: re.Match[str], place: Mark) -> ParseError:
    """A letter directly behind a number: `0x1F`, `2m`."""
    word = _NAME.match(text, match.end())
    rest = word[0] if word else text[match.end()]
    if match[0] == "0" and rest[0] in "xXoObB":
        return ParseError("numbers are written in decimal", "", "PL206", place)
    hint = f"write `{match[0]} {rest}` for a unit, `{match[0]}*{rest}` for a product"
    if text[: match.start()].rstrip().endswith(("@", "->")):
        hint = f"the name of a state has a letter first, or is a number alone: `t{match[0]}{rest}`"
    return ParseError(f"the number {match[0]} is followed directly by a letter", hint, "PL205", place)


def exact(number: str) -> Fraction:
    """The rational that a decimal number says: 0.45 is 45/100."""
    return Fraction(number if number[0] != "." else "0" + number)


class Cursor:
    """A place in the tokens of one text."""

    def __init__(self, text: str, mark: Mark) -> None:
        self.text = text
        self.mark = mark
        self.tokens = tokenize(text, mark)
        self.index = 0

    @property
    def token(self) -> Token:
        return self.tokens[self.index]

    def peek(self, ahead: int = 1) -> Token:
        """The token `ahead` further on; the end token beyond the end."""
        return self.tokens[min(self.index + ahead, len(self.tokens) - 1)]

    def before(self, index: int) -> Token | None:
        return self.tokens[index - 1] if index > 0 else None

    def take(self) -> Token:
        token = self.token
        if token.kind != "end":
            self.index += 1
        return token

    def is_sign(self, *signs: str) -> bool:
        return self.token.kind == "sign" and self.token.text in signs

    def is_word(self, *words: str) -> bool:
        return self.token.kind == "name" and self.token.text in words

    def accept(self, sign: str) -> bool:
        if self.is_sign(sign):
            self.index += 1
            return True
        return False

    def skip_to(self, offset: int) -> None:
        """Go on behind the characters before `offset`."""
        while self.token.kind != "end" and self.token.start < offset:
            self.index += 1

    def place(self, token: Token | None = None) -> Mark:
        return self.mark.shifted((token or self.token).start)

    def error(self, message: str, hint: str = "", code: str = "PL201", token: Token | None = None) -> ParseError:
        """The ParseError at `token` (the current one if left out)."""
        return ParseError(message, hint, code, self.place(token))

    def fail(self, message: str, hint: str = "", code: str = "PL201", token: Token | None = None) -> NoReturn:
        """Raise ParseError at `token` (the current one if left out)."""
        raise self.error(message, hint, code, token)
