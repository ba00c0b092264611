"""Formulas of a worked page, from the LaTeX of the report to MathML, which browsers set without scripts.

Only what the report writes is known; of a command that is not, the name is shown as it stands. A formula on display is
cut where it may go on in the next line, before a relation and, where it is long, before a sign of a sum: browsers do
not break a formula by themselves.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from html import escape
from itertools import groupby

from planar_cli.greek import GREEK
from planar_cli.records import record

LONG, SHORT = 24, 8
"""A piece with more characters than the first may also break before a plus or minus, not so near to each other."""
FUNCTIONS = frozenset("sin cos tan cot sec csc arcsin arccos arctan sinh cosh tanh ln exp max min".split())
RELATIONS = {"ne": "≠", "lt": "<", "le": "≤", "gt": ">", "ge": "≥", "approx": "≈", "to": "→"}
OPERATORS = {"cdot": "·", "times": "×", "sim": "~", "wedge": "^", "backslash": "\\"}
ARROWS = {"leftarrow": "←", "uparrow": "↑", "downarrow": "↓", "rightarrow": "→"}
SLANTED = {"nearrow": "↗", "nwarrow": "↖", "searrow": "↘", "swarrow": "↙"}
SIGNS = {"circlearrowleft": "↺", "circlearrowright": "↻", "infty": "∞", "circ": "°", "prime": "′"} | ARROWS | SLANTED
OPENING = {"(": "(", "lbrack": "[", "lbrace": "{", "lvert": "|"}
CLOSING = {")": ")", "rbrack": "]", "rbrace": "}", "rvert": "|"}
BREAK = "<wbr/>"
SPACES = {"~": 0.17, " ": 0.25, ",": 0.17, "quad": 1.0, "qquad": 2.0}
"""Their widths in em."""
OVER = {"dot": "˙", "ddot": "¨", "vec": "→"}
TOKENS = re.compile(r"\\(?P<command>[A-Za-z]+) ?|\\(?P<escaped>.)|(?P<number>\d+(?:\.\d+)?)|(?P<space>\s+)|(?P<sign>.)")


@record
class Item:
    """A piece of a formula, with its number of characters. `kind`: what it is beside its neighbours."""

    kind: str
    mathml: str
    size: int = 1


class MathML:
    """The formulas of a page, as `worked_html` asks for them."""

    def inline(self, latex: str) -> str:
        """A formula among words."""
        return f"<math>{_joined(_Reader(latex).row())}</math>"

    def display(self, latex: str) -> str:
        """A formula on a line of its own, with its number at the right."""
        number = re.search(r" ?\\tag\{([^{}]*)\}", latex)
        items = _Reader(latex.replace(number[0], "") if number else latex).row()
        tag = f'<span class="number">({escape(number[1])})</span>' if number else ""
        shown = "".join(map(_shown, _pieces(items))).removeprefix(BREAK)
        return f'<span class="equation">{tag}{shown}</span>'


def _shown(piece: Sequence[Item]) -> str:
    """A piece, behind a place at which the line may break: a wide space where the formula has that.

    A long one breaks inside, at its signs, only where it does not fit into a line of its own.
    """
    gap = "\N{EM SPACE} " if piece[0].kind == "break" else BREAK
    parts = [_told(part) for part in _at_signs(piece)]
    return gap + (parts[0] if len(parts) == 1 else f'<span class="long">{BREAK.join(parts)}</span>')


def _told(items: Sequence[Item]) -> str:
    """Formulas as MathML, and words between them, which may go on in the next line, as words."""
    told = ""
    for wordy, group in groupby(items, lambda i: i.kind == "words"):
        found = list(group)
        if wordy:
            # The spaces at their ends stay firm: a unit does not begin a line.
            told += re.sub("</?mtext>", "", _joined(found))
        elif mathml := _joined(found):
            told += f'<math><mstyle displaystyle="true">{mathml}</mstyle></math>'
    return told


def _joined(items: Sequence[Item]) -> str:
    return "".join(i.mathml for i in items)


def _pieces(items: Sequence[Item]) -> list[list[Item]]:
    """Where a line breaks first: at a wide space, before the relations behind the first."""
    pieces: list[list[Item]] = [[]]
    for item in items:
        if item.kind == "break" or (item.kind == "relation" and any(i.kind == "relation" for i in pieces[-1])):
            pieces.append([item])
        else:
            pieces[-1].append(item)
    return [piece for piece in pieces if piece]


def _at_signs(piece: Sequence[Item]) -> list[list[Item]]:
    """A long piece in parts, each but the first with its sign."""
    parts: list[list[Item]] = [[]]
    long, size = sum(i.size for i in piece) > LONG, 0
    for item in piece:
        if long and item.kind == "sum" and size > SHORT:
            # At the head of a formula a browser takes it for the sign of a number.
            infix = item.mathml.replace("<mo>", '<mo form="infix">')
            parts.append([replace(item, mathml=infix)])
            size = 0
        else:
            parts[-1].append(item)
        size += item.size
    return parts


class _Reader:
    """Reads LaTeX of the report, token by token."""

    def __init__(self, latex: str) -> None:
        self.latex = latex
        self.tokens = list(TOKENS.finditer(latex))
        self.place = 0

    def _next(self) -> re.Match[str] | None:
        token = self.tokens[self.place] if self.place < len(self.tokens) else None
        self.place += 1
        return token

    def row(self, upright: bool = False) -> list[Item]:
        """Up to a brace or command that closes, which is passed."""
        items: list[Item] = []
        while (token := self._next()) is not None:
            sign, command = token["sign"], token["command"]
            if sign == "}" or command in ("right", "end") or sign == "&" or token["escaped"] == "\\":
                break
            if sign in ("^", "_") or sign == "'":
                self._script(items, "_" if sign == "_" else "^", prime=sign == "'")
                continue
            made = self._item(token, upright, next((i.kind for i in reversed(items) if i.kind != "space"), ""))
            if made is not None:
                self._add(items, made, upright)
        return items

    def _add(self, items: list[Item], made: Item, upright: bool) -> None:
        behind_function = items and items[-1].kind == "function" and made.kind not in ("open", "space")
        before_function = items and items[-1].kind in ("term", "letters", "close") and made.kind == "function"
        if behind_function or before_function:
            items.append(_space(SPACES[","]))
        if upright and items and made.kind == items[-1].kind == "letters":
            both = re.sub("<.*?>", "", items.pop().mathml + made.mathml)
            made = _upright_of(both)
        items.append(made)

    def _item(self, token: re.Match[str], upright: bool, before: str) -> Item | None:
        if token["number"]:
            return Item("term", f"<mn>{token['number']}</mn>", len(token["number"]))
        if token["command"]:
            return self._command(token["command"], upright, before)
        if token["escaped"]:
            spaced = token["escaped"] in SPACES
            return _space(SPACES[token["escaped"]]) if spaced else _upright(token["escaped"])
        if token["space"]:
            return None
        return self._sign(token["sign"], upright, before)

    def _sign(self, sign: str, upright: bool, before: str) -> Item:
        if sign == "{":
            return _row(self.row(upright))
        if sign == "~":
            return _space(SPACES["~"])
        if sign in "+-":
            form = ' form="prefix"' if before in ("", "relation", "operator", "open", "sum", "comma", "break") else ""
            return Item("operator" if form else "sum", f"<mo{form}>{'−' if sign == '-' else sign}</mo>")
        if sign == "=":
            return Item("relation", "<mo>=</mo>")
        if sign in "()":
            return _bracket("open" if sign == "(" else "close", sign)
        if sign == ",":
            return Item("comma", '<mo separator="true">,</mo>')
        if sign in "/:|;!":
            return Item("operator", f'<mo lspace="0" rspace="0" stretchy="false">{sign}</mo>')
        if upright:
            return _upright(sign)
        return Item("letters", f"<mi>{escape(sign)}</mi>")

    def _command(self, name: str, upright: bool, before: str) -> Item:
        if name in GREEK:
            letter = GREEK[name]
            return _upright(letter) if letter.isupper() else Item("term", f"<mi>{letter}</mi>")
        if name in SPACES:
            return Item("break", "")
        if name in RELATIONS:
            return Item("relation", f"<mo>{escape(RELATIONS[name])}</mo>")
        if name in OPERATORS:
            return Item("operator", f"<mo>{OPERATORS[name]}</mo>")
        if name in SIGNS:
            return _upright(SIGNS[name])
        if name in OPENING or name in CLOSING:
            return _bracket("open" if name in OPENING else "close", (OPENING | CLOSING)[name])
        if name in FUNCTIONS:
            return Item("function", f'<mi mathvariant="normal">{name}</mi>', len(name))
        return self._with_arguments(name, upright)

    def _with_arguments(self, name: str, upright: bool) -> Item:
        match name:
            case "frac":
                above, below = self._argument(), self._argument()
                return Item("term", f"<mfrac>{above.mathml}{below.mathml}</mfrac>", max(above.size, below.size))
            case "sqrt":
                inside = self._argument()
                return Item("term", f"<msqrt>{inside.mathml}</msqrt>", inside.size + 1)
            case "dot" | "ddot" | "vec":
                over = f'<mo stretchy="false">{OVER[name]}</mo>'
                return Item("term", f'<mover accent="true">{self._argument().mathml}{over}</mover>')
            case "mathrm":
                return self._argument(upright=True)
            case "operatorname":
                return Item("function", self._argument(upright=True).mathml, 4)
            case "text":
                return self._words()
            case "int":
                return Item("operator", "<mo>∫</mo>")
            case "surd":
                return Item("operator", '<mo form="prefix">√</mo>')
            case "left":
                return self._stretched()
            case "begin":
                return self._cases()
        return Item("term", f"<mtext>\\{name}</mtext>", len(name))

    def _argument(self, upright: bool = False) -> Item:
        """What stands in the braces that follow."""
        token = self._next()
        if token is None or token["sign"] != "{":
            made = self._item(token, upright, "") if token is not None else None
            return made or _row([])
        return _row(self.row(upright))

    def _words(self) -> Item:
        """Words as they stand up to the brace that closes."""
        opening = self._next()
        start = opening.end() if opening is not None else len(self.latex)
        stop = self.latex.find("}", start)
        stop = len(self.latex) if stop < 0 else stop
        while self.place < len(self.tokens) and self.tokens[self.place].start() <= stop:
            self.place += 1
        text = self.latex[start:stop]
        shown = re.sub(r"^\s|\s$", "\N{NO-BREAK SPACE}", text)
        # arctan( is part of a formula.
        kind = "words" if " " in text or text.endswith(":") else "term"
        return Item(kind, f"<mtext>{escape(shown)}</mtext>", len(text))

    def _stretched(self) -> Item:
        """What stands between brackets of its own height."""
        opening, inside = self._delimiter(OPENING), self.row()
        closing = self._delimiter(CLOSING)
        whole = _joined(inside)
        size = sum(i.size for i in inside) + 2
        return Item("term", f"<mrow><mo>{opening}</mo>{whole}<mo>{closing}</mo></mrow>", size)

    def _delimiter(self, known: dict[str, str]) -> str:
        token = self._next()
        name = (token["command"] or token["sign"] or "") if token is not None else ""
        return known.get(name, escape(name))

    def _cases(self) -> Item:
        self._argument()
        rows: list[list[str]] = [[]]
        while self.place <= len(self.tokens):
            rows[-1].append(_joined(self.row()))
            ended = self.tokens[min(self.place, len(self.tokens)) - 1]
            if ended["command"] == "end":
                self._argument()
                break
            if ended["escaped"] == "\\":
                rows.append([])
        cells = "".join("<mtr>" + "".join(f"<mtd>{c}</mtd>" for c in row) + "</mtr>" for row in rows)
        return Item("term", f'<mrow><mo>{{</mo><mtable columnalign="left">{cells}</mtable></mrow>', LONG)

    def _script(self, items: list[Item], place: str, prime: bool) -> None:
        """A subscript or superscript, set to the item before it."""
        base = items.pop() if items else _row([])
        if prime:
            # The sign is raised by itself.
            items.append(Item("term", f'<mrow>{base.mathml}<mo lspace="0" rspace="0">′</mo></mrow>', base.size + 1))
            return
        script = self._argument()
        if script.mathml == _upright("°").mathml and base.kind == "words":
            items.append(Item("words", base.mathml.replace("</mtext>", "°</mtext>"), base.size + 1))
            return
        if script.mathml == _upright("°").mathml:
            items += [base, script]
            return
        both = re.fullmatch(r"<msub>(.*)</msub>", base.mathml) if place == "^" else None
        if both:
            mathml = f"<msubsup>{both[1]}{script.mathml}</msubsup>"
        else:
            tag = "msup" if place == "^" else "msub"
            mathml = f"<{tag}>{base.mathml}{script.mathml}</{tag}>"
        items.append(Item("term" if base.kind in ("letters", "words") else base.kind, mathml, base.size + script.size))


def _row(items: Sequence[Item]) -> Item:
    if len(items) == 1:
        return items[0]
    size = sum(i.size for i in items)
    return Item("term", f"<mrow>{_joined(items)}</mrow>", size)


def _bracket(kind: str, sign: str) -> Item:
    form = "prefix" if kind == "open" else "postfix"
    return Item(kind, f'<mo form="{form}" stretchy="false">{sign}</mo>')


def _upright(text: str) -> Item:
    return Item("letters", f'<mi mathvariant="normal">{escape(text)}</mi>', len(text))


def _upright_of(escaped: str) -> Item:
    return Item("letters", f'<mi mathvariant="normal">{escaped}</mi>', len(escaped))


def _space(width: float) -> Item:
    return Item("space", f'<mspace width="{width:g}em"/>', 0)
