"""Recursive descent over one side of a relation: sums, products, powers, atoms and quantities."""

from __future__ import annotations

from typing import NoReturn

from planar_cli.near import nearest
from planar_cli.problem.language.expression import (
    Binary,
    Function,
    Grouped,
    Name,
    Negate,
    Number,
    Part,
    PointPair,
    Quantity,
    Relation,
    Scaled,
    Side,
    Word,
)
from planar_cli.problem.language.instants import InstantParser, refuse_at, refuse_comma, refuse_neighbour
from planar_cli.problem.language.limits import Guard
from planar_cli.problem.language.tokens import Cursor, Token, exact
from planar_cli.problem.language.unit_run import read_unit, unit_follows
from planar_cli.problem.language.words import (
    CALL_HABITS,
    CONSTANTS,
    DIRECTED_PARTS,
    FUNCTIONS,
    MODES,
    OF_ALL,
    PART_HABITS,
    PARTS,
    QUANTITIES,
    RESERVED,
    is_reserved,
)

RELATION_SIGNS = ("=", "<", ">", "<=", ">=")
_WRONG_SIGNS = {"==": "=", "=>": ">=", "=<": "<="}


class SideParser(InstantParser):
    """Reads sides at a cursor; every method raises ParseError at the exact column."""

    def __init__(self, cursor: Cursor) -> None:
        super().__init__(cursor)
        self.guard = Guard(cursor)

    # -- sums, products, powers -----------------------------------------------------------------

    def side(self) -> Side:
        """["-"] term {("+" | "-") term}"""
        cursor = self.cursor
        self.guard.enter()
        first = cursor.token
        if cursor.is_sign("+"):
            cursor.fail("a side does not begin with +", "leave the sign out", "PL214")
        negative = cursor.accept("-")
        left = self.term()
        if negative:
            left = self.guard.node(Negate(left, cursor.place(first)), first)
        while cursor.is_sign("+", "-"):
            token = cursor.take()
            right = self.term()
            left = self.guard.node(Binary(token.text, left, right, cursor.place(token)), token)
        self.guard.leave()
        return left

    def term(self) -> Side:
        cursor = self.cursor
        start = cursor.token.start
        left = self.power(start)
        while cursor.is_sign("*", "/"):
            token = cursor.take()
            right = self.power(start)
            left = self.guard.node(Binary(token.text, left, right, cursor.place(token)), token)
        refuse_neighbour(cursor, start)
        return left

    def power(self, term_start: int) -> Side:
        cursor = self.cursor
        base = self.atom(term_start)
        if cursor.is_sign("**"):
            cursor.fail("a power is written with ^", "write `^` instead of `**`", "PL215")
        if not cursor.is_sign("^"):
            return base
        token = cursor.take()
        self.guard.enter_power()
        exponent = self._exponent()
        self.guard.leave_power()
        if cursor.is_sign("^", "**"):
            cursor.fail("a power of a power needs brackets", "write `a^(b^c)` or `(a^b)^c`", "PL215")
        return self.guard.node(Binary("^", base, exponent, cursor.place(token)), token)

    def _exponent(self) -> Side:
        """["-"] number | name | "(" side ")"; no unit follows it, so that `x^2 m` is refused."""
        cursor = self.cursor
        first = cursor.token
        negative = cursor.accept("-")
        token = cursor.token
        if token.kind == "number":
            cursor.take()
            number: Side = self.guard.node(Number(exact(token.text), None, 1, cursor.place(token)), token)
            return self.guard.node(Negate(number, cursor.place(first)), first) if negative else number
        if negative:
            cursor.fail("a negative exponent is a number or stands in brackets", "write `^(-…)`", "PL215")
        if cursor.is_sign("("):
            cursor.take()
            inner = self.side()
            self._close(token)
            return inner
        if token.kind == "name" and not self._is_call(token):
            return self._name(cursor.take(), with_state=False)
        raise cursor.error("an exponent is a number, a name, or stands in brackets", "write `^(…)`", "PL215")

    # -- atoms ----------------------------------------------------------------------------------

    def atom(self, term_start: int) -> Side:
        cursor = self.cursor
        token = cursor.token
        if token.kind == "number":
            return self._number(term_start)
        if cursor.is_sign("("):
            return self._group(term_start)
        if token.kind != "name":
            self._nothing_begins(token)
        return self._word()

    def _nothing_begins(self, token: Token) -> NoReturn:
        cursor = self.cursor
        if token.kind == "end":
            before = cursor.before(cursor.index)
            after = f" after {before.text}" if before else ""
            cursor.fail(f"something is missing{after}", "write a number with its unit, a name, or a quantity")
        if token.text in "+-":
            cursor.fail(f"two signs stand side by side before {token.text}", "put the second into brackets", "PL214")
        if token.text == ")":
            cursor.fail("a bracket is empty, or is closed too early", "", "PL214")
        if token.text == "**":
            cursor.fail("a power is written with ^", "write `^` instead of `**`", "PL215")
        if token.text == ".":
            cursor.fail("a dot stands alone", "a number is finite, such as `0.5`; a part is `v(P).x`", "PL213")
        if token.text == "@":
            cursor.fail("`@` stands behind a quantity", "write `v(P) @ 2`", "PL212")
        if token.text == ",":
            refuse_comma(cursor, token, None)
        cursor.fail(f"`{token.text}` cannot stand here", "write a number with its unit, a name, or a quantity")

    def _number(self, term_start: int) -> Side:
        cursor = self.cursor
        start = cursor.index
        token = cursor.take()
        unit, sense = None, 1
        if unit_follows(cursor, token, group=False):
            unit, sense = read_unit(cursor, token, start, term_start)
        elif cursor.is_word("cw", "ccw"):
            cursor.fail("cw and ccw stand behind a unit", f"write `{token.text} rad/s {cursor.token.text}`", "PL205")
        if cursor.is_sign("@"):
            cursor.fail("a number is the same in every state", "leave `@` out", "PL212")
        return self.guard.node(Number(exact(token.text), unit, sense, cursor.place(token)), token)

    def _group(self, term_start: int) -> Side:
        cursor = self.cursor
        start = cursor.index
        opening = cursor.take()
        inner = self.side()
        closing = self._close(opening)
        if unit_follows(cursor, closing, group=True):
            unit, sense = read_unit(cursor, opening, start, term_start)
            inner = self.guard.node(Scaled(inner, unit, sense, cursor.place(opening)), opening)
        if cursor.is_sign("."):
            cursor.fail("a part belongs to one quantity", "write `r(B/A).mag`, or the part of each", "PL213")
        at = self.state_of("a bracket")
        return inner if at is None else self.guard.node(Grouped(inner, at, cursor.place(opening)), opening)

    def _close(self, opening: Token) -> Token:
        """Take the bracket that closes `opening`."""
        cursor = self.cursor
        if cursor.is_sign(")"):
            return cursor.take()
        if cursor.is_sign(","):
            refuse_comma(cursor, cursor.token, None)
        if cursor.is_sign(*RELATION_SIGNS, *_WRONG_SIGNS):
            cursor.fail("a relation cannot stand inside a bracket", "write it as an entry of its own", "PL210")
        if cursor.token.kind != "end":
            cursor.fail(f"`{cursor.token.text}` cannot stand here", "a bracket is closed with `)`", "PL214")
        raise cursor.error("this bracket is never closed", "write `)`", "PL214", opening)

    def _is_call(self, token: Token) -> bool:
        following = self.cursor.peek()
        return following.text == "(" and following.start == token.end

    def _word(self) -> Side:
        """A name, a constant, a mode, a function or a quantity."""
        cursor = self.cursor
        token = cursor.take()
        called = cursor.is_sign("(") and cursor.token.start == token.end
        if called and token.text in FUNCTIONS:
            return self._function(token)
        if called and token.text in QUANTITIES:
            return self._quantity(token)
        if called:
            self._unknown_call(token)
        if cursor.is_sign("(") and (token.text in FUNCTIONS or token.text in QUANTITIES):
            cursor.fail(f"a space stands before the bracket of {token.text}", f"write `{token.text}(`", "PL208")
        if token.text in MODES:
            return self.guard.node(Word(token.text, cursor.place(token)), token)
        return self._name(token, with_state=True)

    def _unknown_call(self, token: Token) -> NoReturn:
        known = sorted(FUNCTIONS | set(QUANTITIES))
        close = nearest(token.text, known, 0.7)
        hint = CALL_HABITS.get(token.text) or CALL_HABITS.get(token.text.lower(), "")
        if not hint and close:
            hint = f"did you mean `{close}(…)`?"
        elif not hint:
            hint = f"write `{token.text}*(…)` for a product; quantities are written as `v(P)`, functions as `sin(…)`"
        self.cursor.fail(f"there is no quantity or function {token.text}(…)", hint, "PL208", token)

    def _name(self, token: Token, with_state: bool) -> Side:
        cursor = self.cursor
        name = token.text
        if name in FUNCTIONS:
            cursor.fail(f"{name} is a function", f"write `{name}(…)`", "PL208", token)
        if is_reserved(name) and name not in CONSTANTS:
            hint = "it is a word of the language and no name" if name in RESERVED else "answers say true or false"
            cursor.fail(f"`{name}` cannot stand here", hint, "PL211", token)
        if name.lower() in ("inf", "nan"):
            cursor.fail("numbers are finite", "write `infinity` where no bound is meant", "PL206", token)
        if cursor.is_sign(".") and name not in CONSTANTS and cursor.token.start == token.end:
            name = f"{name}.{self._behind_dot(token)}"
        at = self.state_of(name) if with_state else None
        return self.guard.node(Name(name, at, cursor.place(token)), token)

    def _behind_dot(self, token: Token) -> str:
        """The find of `case.find`."""
        cursor = self.cursor
        dot = cursor.take()
        following = cursor.token
        if following.kind != "name" or following.start != dot.end or self._is_call(following):
            hint = f"a find of a case is `case.find`; a part belongs to a quantity, `v({token.text}).x`"
            cursor.fail(f"a dot behind the name {token.text}", hint, "PL213", dot)
        cursor.take()
        if cursor.is_sign("."):
            cursor.fail("a name has at most one dot", "write `case.find`", "PL213")
        return following.text

    def _function(self, token: Token) -> Side:
        cursor = self.cursor
        opening = cursor.take()
        grows = token.text == "exp"
        if grows:
            self.guard.enter_power()
        argument = self.side()
        if grows:
            self.guard.leave_power()
        if cursor.is_sign(","):
            cursor.fail(f"{token.text} has one argument", CALL_HABITS.get(token.text + "2", ""), "PL209")
        self._close(opening)
        if cursor.is_sign("."):
            cursor.fail(f"the value of {token.text}(…) is a number and has no parts", "", "PL213")
        at = self.state_of(f"{token.text}(…)")
        return self.guard.node(Function(token.text, argument, at, cursor.place(token)), token)

    # -- quantities -----------------------------------------------------------------------------

    def _quantity(self, token: Token) -> Side:
        cursor = self.cursor
        opening = cursor.take()
        things: tuple[str, ...] = ()
        argument: Side | Relation | None = None
        match QUANTITIES[token.text]:
            case "things":
                things = self._things(token)
            case "state":
                things = (self._state(),)
            case "side":
                argument = self.side()
            case "relation":
                argument = self.relation()
        if cursor.is_sign(","):
            refuse_comma(cursor, cursor.token, token)
        self._close(opening)
        parts = self._parts()
        at = self.instant_or_span()
        return self.guard.node(Quantity(token.text, things, argument, parts, at, cursor.place(token)), token)

    def _things(self, word: Token) -> tuple[str, ...]:
        cursor = self.cursor
        if word.text in OF_ALL and cursor.is_sign(")"):
            return ("all",)
        things = [self._thing(word)]
        while cursor.accept("/"):
            things.append(self._thing(word))
        if len(things) > 2:
            cursor.fail(f"{word.text}(…) takes one name, or two as in `{word.text}(B/A)`", "", "PL208", word)
        if not cursor.is_sign(")", ",") and cursor.token.kind != "end":
            hint = f"write `{word.text}(B)`, or `{word.text}(B/A)` for B seen from A"
            cursor.fail(f"{word.text}(…) takes names, not an expression", hint, "PL208")
        return tuple(things)

    def _thing(self, word: Token) -> str:
        cursor = self.cursor
        token = cursor.token
        named = token.kind == "name" and (token.text in ("all", "ground") or not is_reserved(token.text))
        if not named or self._is_call(token):
            hint = f"write `{word.text}(B)`, or `{word.text}(B/A)` for B seen from A"
            cursor.fail(f"{word.text}(…) takes the name of a point, body, joint or load", hint, "PL208")
        return cursor.take().text

    def _parts(self) -> tuple[Part, ...]:
        cursor = self.cursor
        parts: list[Part] = []
        while cursor.is_sign("."):
            dot = cursor.take()
            token = cursor.token
            if token.kind != "name" or token.text not in PARTS:
                self._unknown_part(token)
            cursor.take()
            direction = self._direction(token) if token.text in DIRECTED_PARTS else None
            self.guard.nodes += 1
            parts.append(Part(token.text, direction, cursor.place(dot).shifted(1)))
        return tuple(parts)

    def _unknown_part(self, token: Token) -> NoReturn:
        part = PART_HABITS.get(token.text) or nearest(token.text, sorted(PARTS))
        hint = f"write `.{part}`" if part else "parts are .x .y .mag .angle .t .n .r .theta .along(…) .across(…)"
        self.cursor.fail(f"there is no part .{token.text}", hint, "PL213", token)

    def _direction(self, part: Token) -> Side | PointPair:
        cursor = self.cursor
        if not (cursor.is_sign("(") and cursor.token.start == part.end):
            hint = f"write `.{part.text}(30 deg)`, `.{part.text}(B/A)` or `.{part.text}(body)`"
            cursor.fail(f".{part.text} needs a direction", hint, "PL213")
        opening = cursor.take()
        first, stroke, second, closing = (cursor.peek(ahead) for ahead in range(4))
        if (first.kind, stroke.text, second.kind, closing.text) == ("name", "/", "name", ")"):
            direction: Side | PointPair = PointPair(first.text, second.text, cursor.place(first))
            cursor.index += 3
        else:
            direction = self.side()
        if cursor.is_sign(","):
            refuse_comma(cursor, cursor.token, part)
        self._close(opening)
        return direction

    # -- relations ------------------------------------------------------------------------------

    def relation(self) -> Relation:
        """side sign side, for a bracket; the text is what was written."""
        cursor = self.cursor
        first = cursor.token
        left = self.side()
        return self.relation_from(left, first)

    def relation_from(self, left: Side, first: Token) -> Relation:
        cursor = self.cursor
        token = cursor.token
        if cursor.is_sign(*_WRONG_SIGNS):
            right = _WRONG_SIGNS[token.text]
            cursor.fail(f"`{token.text}` is no relation sign", f"write `{right}`", "PL210")
        if cursor.is_sign("!=", "<>"):
            cursor.fail("that two things differ is no relation", "write `<` or `>`", "PL210")
        if cursor.is_sign("@"):
            refuse_at(cursor)
        if not cursor.is_sign(*RELATION_SIGNS):
            cursor.fail("a relation sign is missing", "write `left = right`, or `<` `>` `<=` `>=`", "PL210")
        cursor.take()
        middle = cursor.token
        right_side = self.side()
        if cursor.is_sign(*RELATION_SIGNS, *_WRONG_SIGNS):
            self._chained(first, token, middle)
        last = cursor.tokens[cursor.index - 1]
        text = cursor.text[first.start : last.end]
        return Relation(left, token.text, right_side, text, cursor.place(first))

    def _chained(self, first: Token, sign: Token, middle: Token) -> NoReturn:
        cursor = self.cursor
        second = cursor.take()
        low = cursor.text[first.start : sign.start].strip()
        between = cursor.text[middle.start : second.start].strip()
        high = cursor.text[second.end :].strip()
        hint = f"write two entries: `{low} {sign.text} {between}` and `{between} {second.text} {high}`"
        cursor.fail("one relation sign a statement", hint, "PL210", second)
