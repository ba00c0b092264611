"""The letter of the solution that an answer is, where its author gave it another name or counts it the other way."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy as sp

from planar_cli.equation.values.ledger import display
from planar_cli.problem.language.expression import Name as Letter
from planar_cli.problem.language.expression import Quantity
from planar_cli.report.answers.letter_vectors import letter_vector_words
from planar_cli.report.document.blocks import Answer, Block, Equation, Inline, Math, Name, Text, Value, line
from planar_cli.report.friction.guide_senses import guide_sense_words
from planar_cli.report.friction.what_happens import what_happens
from planar_cli.report.notation.names import plain_name
from planar_cli.report.words.mode_words import mode_words
from planar_cli.report.words.senses import direction_words
from planar_cli.report.words.words import Phrases, answer_line, told_unit
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution


def answer_block(found: Found, part: PartSolution, phrases: Phrases, told: Iterable[Block]) -> Answer:
    """The answer to a find. `told`: the blocks before it, whose letters it may name."""
    behind = letter_vector_words(found, part, phrases) or guide_sense_words(found, part, phrases)
    said = line(*answer_line(found, phrases, decimals=True), *behind)
    if words := mode_words(found, part):
        return Answer(found.name, line(words), ":")
    relation = ":" if found.word or found.curve is not None else "="
    if part.tale is not None and (letter := part.tale.letters.get(found.name)) is not None:
        named = plain_name(found.name) == plain_name(letter.name)
        whole = said if named else line(Math(letter), " = ", *_signed(found, phrases), said)
        return Answer(found.name, whole, relation)
    asked = _asked(found, part)
    symbol, size = _symbol(asked)
    if asked is not None and asked == symbol and _seeks_extremes(part) and (happens := what_happens(symbol, part)):
        said = line(*said, happens)
    if (rate := _second_rate(found)) is not None:
        named = plain_name(found.name) == plain_name(rate.name)
        return Answer(found.name, said if named else line(Math(rate), " = ", said), "=" if named else ":")
    if symbol is None or symbol not in _solved(told) or asked in (found.expressions or ()):
        return Answer(found.name, said, relation)
    own = part.motion.general.get(symbol, symbol) if part.motion is not None else symbol
    same = plain_name(found.name) in (plain_name(symbol.name), plain_name(own.name))
    if same and asked == symbol:
        return Answer(found.name, said, relation)
    if (
        same
        and not size
        and found.values is not None
        and direction_words(found, found.values[0], phrases.ledger, phrases.value, phrases.slopes)
    ):
        # Its direction says in which sense it counts.
        return Answer(found.name, said, "=")
    if asked == -symbol and _is_friction_as_it_acts(symbol, found, part, phrases):
        return Answer(found.name, said if same else line(Math(symbol), " = ", said), relation)
    if asked == symbol and _is_of_another_state(found.name, symbol, part):
        return Answer(symbol.name, line(said, " (asked for as ", Name(found.name), ")"), "=")
    positive = (phrases.value.known(symbol) or 0) > 0 and (not phrases.symbolic or _goes_so(part))
    if same and size and positive:
        return Answer(found.name, said, "=")
    letter = line("|", Math(symbol), "|") if size and not positive else line(Math(symbol if size else asked))
    # A name that is its own opposite, or its own size, is no equation.
    return Answer(found.name, line(letter, " = ", *_signed(found, phrases), said), ":" if same else relation)


def _is_friction_as_it_acts(symbol: sp.Symbol, found: Found, part: PartSolution, phrases: Phrases) -> bool:
    """Is it a friction that is asked against the sense in which it acts and is drawn, with words for its direction?"""
    if part.motion is not None or phrases.symbolic or found.values is None or (phrases.value.known(symbol) or 0) <= 0:
        return False
    systems = [i.trial.system for i in part.instants]
    frictions = {s.symbols.get(p.name) for s in systems for p in s.pushes if p.kind == "friction"}
    told = direction_words(found, found.values[0], phrases.ledger, phrases.value, phrases.slopes)
    return symbol in frictions and bool(told)


def _seeks_extremes(part: PartSolution) -> bool:
    """Is something the largest or the smallest?"""
    return any(instant.instant.statements.extremes for instant in part.instants)


def _goes_so(part: PartSolution) -> bool:
    """Does everything go one way all the time, which counts as positive?"""
    return part.motion is not None and any(not way.until for _, way in part.motion.problem.going)


def _is_of_another_state(name: str, symbol: sp.Symbol, part: PartSolution) -> bool:
    """Is the name that the file gives to ω_2 on this page that of the same letter in state 1? ω_1 = ω_2 reads so."""
    own = part.motion.general if part.motion is not None else {}
    others = (s for s, general in own.items() if s != symbol and general == own.get(symbol))
    return any(plain_name(s.name) == plain_name(name) for s in others)


def _second_rate(found: Found) -> sp.Symbol | None:
    """ẍ, where an equation of motion is asked in letters."""
    what = found.find.found.what if found.find is not None else None
    if not isinstance(what, Quantity) or what.word != "ddot" or not isinstance(what.argument, Letter):
        return None
    return None if found.values is not None else sp.Symbol(f"{what.argument.name}_ddot", real=True)


def asked_symbol(found: Found, part: PartSolution) -> sp.Symbol | None:
    """The letter of the solution that a find is, without its sign being changed."""
    asked = _asked(found, part)
    return asked if asked is not None and asked.is_Symbol else None


def _asked(found: Found, part: PartSolution) -> Any:
    """What is asked, in the letters of the solution, without those that are zero; None: it is no number."""
    asked = found.asked
    if part.motion is not None:
        asked = next((r.parts for r in part.motion.requests if r.find is found.find), ())
        zeros = {s: f for s, f in part.motion.route.formulas.items() if f == 0}
        asked = tuple(a.xreplace(zeros) for a in asked)
    return asked[0] if len(asked) == 1 and found.kind == "number" and not found.word else None


def _symbol(asked: Any) -> tuple[sp.Symbol | None, bool]:
    """The letter that is asked up to its sign, and whether its size alone is."""
    if asked is None:
        return None, False
    size = isinstance(asked, sp.Abs)
    inner = asked.args[0] if size else asked
    return next((s for s in (inner, -inner) if s.is_Symbol), None), size


def _solved(told: Iterable[Block]) -> set[Any]:
    """The letters that have a line."""
    return {b.sides[0].expr for b in told if isinstance(b, Equation) and isinstance(b.sides[0], Math)}


def _signed(found: Found, phrases: Phrases) -> list[Inline]:
    """A negative number before its size and direction."""
    if found.values is None:
        return []
    number = display(found.values[0], found.unit, phrases.ledger.us)
    if number >= 0 or not direction_words(found, number, phrases.ledger, phrases.value, phrases.slopes):
        return []
    return [Value(number, told_unit(found.unit, found.energy), phrases.figures), Text(", that is ")]
