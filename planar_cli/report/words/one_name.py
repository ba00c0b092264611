"""One name for one quantity: the letter of the solution gives way to the name that the author asks for, where that is
the same letter with less behind it, y_top for y_ball,top or T for T_cord, and nothing else on the page is meant by it.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import fields, replace
from typing import Any

import sympy as sp

from planar_cli.report.document.blocks import Answer, Block, Inline, Line, Math, Name, Note, Text
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.notation.formula import is_canonical
from planar_cli.report.notation.names import plain_name

PRIME = "′"
CHANGE = "Delta_"
"""So begins how much a coordinate changes by: Δx_B′ beside x_B′."""
OPENING = ("Find", "Principle")
"""Notes that name what is asked, or quantities in general."""
RATES = ("dot", "ddot")
KINDS = (("theta", "omega", "alpha"), ("v", "a"))
"""Stems of what is called after one body or point."""
OF_POINTS = ("x", "y", "v", "a")
"""Stems of what a point has: its letter says whose it is."""
POLAR = ("r", "theta")
"""Components about a pole, of which a page has one, so that they need no point."""
OF_TIES = ("S", "T")
"""Stems of the force in a link, which counts as tension: that of its letter, and the usual one."""
_POINT = re.compile(r"[A-Z]\d*")
_COMPONENT = re.compile(r"([A-Z]\d*)([xytnr])")


def with_one_name(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a page, with one name for what an answer was told to be the same as; its rates follow it."""
    asked = _asked(blocks)
    if not asked:
        return list(blocks)
    used = _used(blocks)
    found: dict[str, dict[str, str]] = {}
    for letter, name in asked.items():
        own = {letter: name} | {x: other for x in used.letters if (other := _along(x, letter, name))}
        if not _stays_beside(letter, own, asked, used) and all(_is_meant(x, other, used) for x, other in own.items()):
            found[letter] = own
    while half := [letter for letter in found if _is_one_of_a_set(letter, found, used)]:
        for letter in half:
            del found[letter]
    return renamed(blocks, {x: name for own in found.values() for x, name in own.items()})


def _is_one_of_a_set(letter: str, found: Mapping[str, Mapping[str, str]], used: _Used) -> bool:
    """Does another letter of its kind keep what this one would lose, T_rope,A beside T_D for T_rope,D?"""
    dropped, stem = set(_left_out(found[letter][letter], letter)), pieces_of_name(letter)[0]
    if "__" in letter or stem in OF_POINTS:
        return False
    kept = (x for x in used.letters if not any(x in own for own in found.values()))
    return any(pieces_of_name(x)[0] == stem and dropped <= set(pieces_of_name(x)) for x in kept)


def without_primes(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of one part of a page without a prime on an index that it sets apart from nothing there: a_G for a_G′
    where there is no a_G; y′ is a derivative.
    """
    symbols = {s.name for b in blocks for p in pieces_of(b) if isinstance(p, Math) for s in p.expr.free_symbols}
    primed = {x: x.removesuffix(PRIME) for x in sorted(symbols) if x.endswith(PRIME) and "_" in x}
    if not primed:
        return list(blocks)
    # The time t__4 of a state reads as t_4, which may be what is asked.
    used = {plain_name(x) for x in _used(blocks).letters}
    told = [(plain_name(b.name), letter_of_answer(b.line)) for b in blocks if isinstance(b, Answer)]
    names = {x: own for x, own in primed.items() if plain_name(own.removeprefix(CHANGE)) not in used}
    return renamed(
        blocks, {x: n for x, n in names.items() if all(letter == x for name, letter in told if name == plain_name(n))}
    )


def renamed(blocks: Sequence[Block], names: Mapping[str, str]) -> list[Block]:
    """Blocks in other names. `names`: those of letters, by the names that they had."""
    if not names:
        return list(blocks)
    renaming = Renaming(names)
    return [renaming.answered(b) if isinstance(b, Answer) else renaming.of(b) for b in blocks]


def _asked(blocks: Iterable[Block]) -> dict[str, str]:
    """The shorter name of an answer by the letter that it is told to be, where all that are asked for begin with it."""
    found: defaultdict[str, set[str]] = defaultdict(set)
    for block in blocks:
        if isinstance(block, Answer) and (letter := letter_of_answer(block.line)):
            found[letter].add(block.name)
    only = {letter: name for letter, names in found.items() if (name := _first_of(names))}
    return {letter: name for letter, name in only.items() if _may_stand_for(name, letter)}


def _first_of(names: Iterable[str]) -> str:
    """The only name, or the one that all others begin with: T_A of T_A and T_A_after; empty: there is none."""
    shortest = min(names, key=lambda n: (len(n), n))
    return shortest if all(n == shortest or n.startswith(f"{shortest}_") for n in names) else ""


def _may_stand_for(name: str, letter: str) -> bool:
    """Is a name short for a letter, and says as well what it is?"""
    return _shortens(name, letter) and bool(_left_out(name, letter)) and not _tells_the_point(name, letter)


def letter_of_answer(told: Line) -> str:
    """The letter L of an answer `L = value`."""
    first = told[0] if len(told) > 1 and told[1] == Text(" = ") else None
    return first.expr.name if isinstance(first, Math) and first.expr.is_Symbol else ""


def pieces_of_name(name: str) -> list[str]:
    """The stem of a name and what stands behind it, components apart: a, A, y of a_Ay."""
    found: list[str] = []
    for piece in name.replace("__", "_").split("_"):
        component = _COMPONENT.fullmatch(piece)
        found += [component[1], component[2]] if component else [piece]
    return found


def _shortens(name: str, letter: str) -> bool:
    """Is a name the letter without some of what stands behind its stem, but for its state, which is kept whole?"""
    (stem, *kept), (own, *left) = pieces_of_name(name), pieces_of_name(letter)
    state = pieces_of_name(letter.partition("__")[2]) if "__" in letter else []
    rest = iter(left)
    if state and kept[-len(state) :] != state:
        return False
    return (stem == own or (own, stem) == OF_TIES) and all(piece in rest for piece in kept)


def _left_out(name: str, letter: str) -> list[str]:
    """What of a letter its shorter name leaves out."""
    kept = pieces_of_name(name)
    return [p for i, p in enumerate(pieces_of_name(letter)) if p not in kept and (i > 0 or p != OF_TIES[0])]


def _tells_the_point(name: str, letter: str) -> bool:
    """Does what the name leaves out say of which point a place, a velocity or an acceleration is?"""
    if pieces_of_name(letter)[-1] in POLAR:
        return False
    return pieces_of_name(letter)[0] in OF_POINTS and any(_POINT.fullmatch(p) for p in _left_out(name, letter))


def _along(other: str, letter: str, name: str) -> str:
    """The name of what goes with a letter, which is called after the same: ṙ_P after r_P, ω_gear,A after α_gear,A."""
    marks = [p for p in other.split("_") if p in RATES]
    if marks and [p for p in other.split("_") if p not in RATES] == letter.split("_"):
        own, _, state = name.partition("__")
        return f"{own}_{marks[0]}" + (f"__{state}" if state else "")
    (stem, *pieces), (own_stem, *own_pieces) = other.partition("__")[0].split("_"), letter.split("_")
    kin = any(stem in kind and own_stem in kind for kind in KINDS) and stem != own_stem
    if not kin or pieces != own_pieces or "__" in letter:
        return ""
    return f"{stem}{name.removeprefix(own_stem)}" + other.removeprefix(other.partition("__")[0])


def _stays_beside(letter: str, own: Mapping[str, str], asked: Mapping[str, str], used: _Used) -> bool:
    """Do others stay that are called after the same body, v_block or x_block at the end beside x_block at the start?"""
    name = own[letter]
    if "__" not in letter and pieces_of_name(letter)[0] not in OF_POINTS:
        return False
    dropped = set(_left_out(name, letter))
    others = [x for x in used.letters if x not in own]
    if pieces_of_name(letter)[-1] in POLAR:
        others = [x for x in others if x not in asked and pieces_of_name(x)[-1] in POLAR]
    return any(_kindred(x, letter) and dropped <= set(pieces_of_name(x)) for x in others)


def _kindred(other: str, letter: str) -> bool:
    """Are both of one kind, or of one point?"""
    one, two = (x.split("_")[0].removeprefix("d") for x in (other, letter))
    return one == two or any(one in kind and two in kind for kind in (*KINDS, OF_POINTS))


class _Used:
    """What a page speaks of: the names of its letters, and the words of its sentences."""

    def __init__(self, letters: frozenset[str], words: frozenset[str]) -> None:
        self.letters, self.words = letters, words


def _used(blocks: Iterable[Block]) -> _Used:
    letters: set[str] = set()
    words: set[str] = set()
    for block in blocks:
        if isinstance(block, Note) and block.kind in OPENING:
            continue
        for piece in pieces_of(block):
            match piece:
                case Name(name):
                    letters.add(name)
                case Math(expr):
                    letters |= {s.name for s in expr.free_symbols}
                case Text(text):
                    words |= set(re.findall(r"\w+", text))
    return _Used(frozenset(letters), frozenset(words))


def _is_meant(letter: str, name: str, used: _Used) -> bool:
    """Would nothing else on the page be meant by the name: no other letter that it shortens, no point, no body?"""
    others = (x for x in used.letters if x != letter and not _along(x, letter, name))
    if name[:1].isupper() and name in used.words:
        return False
    return not any(_shortens(name, x) or plain_name(x) == plain_name(name) for x in others)


class Renaming:
    """Writes blocks in other names."""

    def __init__(self, names: Mapping[str, str]) -> None:
        self.names = names
        told = {plain_name(letter): plain_name(name) for letter, name in names.items()}
        self._told = told
        self._word = re.compile("|".join(rf"(?<![\w,/]){re.escape(x)}(?![\w,/′])" for x in told))

    def answered(self, answer: Answer) -> Answer:
        """An answer that is called what it is."""
        called = self.names.get(letter_of_answer(answer.line)) == answer.name
        return replace(answer, line=self.of(answer.line[2:] if called else answer.line))

    def of(self, value: Any) -> Any:
        """A block, a line, or a piece of one."""
        match value:
            case Text(text):
                return replace(value, text=self._word.sub(lambda m: self._told[m[0]], text))
            case Name(name):
                return replace(value, name=self.names.get(name, name))
            case Math(expr):
                return self._math(value, expr)
            case tuple():
                return tuple(self.of(part) for part in value)
        if not hasattr(value, "__slots__") or isinstance(value, str):
            return value
        return replace(value, **{f.name: self.of(getattr(value, f.name)) for f in fields(value) if f.init})

    def _math(self, value: Math, expr: Any) -> Inline:
        put = {
            s: sp.Symbol(self.names[s.name], **s.assumptions0)
            for s in (*expr.atoms(sp.Symbol), *(value.values or ()))
            if s.name in self.names
        }
        values = value.values and {put.get(s, s): text for s, text in value.values.items()}
        return Math(put_in_place(expr, put), values) if put else value


def put_in_place(expr: Any, put: Mapping[sp.Symbol, sp.Symbol]) -> Any:
    """A formula in other letters, as its author arranged it: (M - q t) a stays, 2 (R - r) is not multiplied out."""
    if not expr.args:
        return put.get(expr, expr)
    args = [put_in_place(a, put) for a in expr.args]
    if args == list(expr.args):
        return expr
    arranged = isinstance(expr, sp.Add | sp.Mul | sp.Pow) and not is_canonical(expr)
    return expr.func(*args, evaluate=False) if arranged else expr.func(*args)
