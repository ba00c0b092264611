"""A linear law of motion told in the letters of vibrations: ω_n, ζ, ω_d, and what a force keeps up."""

from __future__ import annotations

from collections.abc import Container, Iterator
from typing import Any

import sympy as sp

from planar_cli.calculus.vibrations import Vibration
from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import simplified
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, Paragraph, line
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.words.words import Phrases
from planar_cli.solve.law import Law

WORDS = {"omega_n": "natural frequency:", "zeta": "damping ratio:", "omega_d": "damped frequency:"}


def vibration_blocks(own: Vibration, law: Law, phrases: Phrases, new: Container[sp.Symbol]) -> Iterator[Block]:
    """The law compared with the general one, its letters with their numbers, and what a force keeps up. `new`: its
    natural frequency and its midpoint, as far as they were not told before.
    """
    q = law.coordinate.symbol
    waves = [(x, f) for x, f in own.forced if x not in own.rest]
    driven = bool(own.steady.free_symbols & {sp.Symbol("t", real=True)})
    if own.natural in new:
        yield Paragraph(line("Compared with ", *_general(own, q, driven), ":"))
    for letter, formula in own.free if own.natural in new else ():
        lead = next((words for name, words in WORDS.items() if letter.name.startswith(name)), "root:")
        yield Equation(_chain(letter, formula, phrases), None, line(lead))
    for letter, formula in own.forced:
        if letter in own.rest:
            closed = simplified(formula.xreplace(dict(own.free)))
            shorter = closed if operations(closed) < operations(formula) else formula
            yield Equation(_chain(letter, shorter, phrases), None, line("midpoint:"))
    if not driven:
        return
    kept = line(Name(f"{q.name}_p"), " = ", phrases.math(own.steady))
    if not waves:
        yield Paragraph(
            line("Resonance: the excitation has the natural frequency, and the vibration grows, ", *kept, ".")
        )
        return
    yield Paragraph(line("The forced vibration, ", *kept, ":"))
    for letter, formula in waves:
        yield Equation(_chain(letter, formula, phrases))
    if len(waves) == 2:
        yield _amplitude([x for x, _ in waves], law, phrases)


def free_blocks(own: Vibration, law: Law, phrases: Phrases, since: str) -> Iterator[Block]:
    """The free vibration that is added to it, with A and B from the start."""
    (a, _), (b, _) = own.begun
    q, t = law.coordinate.symbol, sp.Symbol("t", real=True)
    free = own.free_motion(t, a, b)
    sum_of = line(Name(q.name), " = ", Name(f"{q.name}_p"), " + ", phrases.math(free))
    yield Paragraph(line(f"With a free vibration from {since} on, ", *sum_of, ":"))
    for letter, formula in own.begun:
        yield Equation(_chain(letter, formula, phrases))


def _amplitude(waves: list[sp.Symbol], law: Law, phrases: Phrases) -> Equation:
    """The amplitude of a sine and a cosine."""
    size = sp.sqrt(sp.Add(*(x**2 for x in waves)))
    dimension = phrases.ledger.units[waves[0]].dimension
    value = phrases.of_dimension(phrases.value(size), dimension, law.coordinate.unit == "rad")
    sides: list[Any] = [line(Name("X")), phrases.math(size), *phrases.substituted(size, value), value]
    return Equation(tuple(sides), None, line("its amplitude:"))


def _chain(letter: sp.Symbol, formula: sp.Expr, phrases: Phrases) -> tuple[Any, ...]:
    """letter = formula = numbers = value; without the formula where a number in it hides a unit."""
    value = phrases.shown(letter, phrases.value(letter))
    clean = not formula.is_number and is_clean(phrases.ledger, letter, formula)
    told = (phrases.math(formula),) if clean else ()
    return phrases.math(letter), *told, *phrases.substituted(formula, value), value


def _general(own: Vibration, q: sp.Symbol, driven: bool) -> Line:
    """q̈ + 2 ζ ω_n q̇ + ω_n² q = 0, or what a force makes of it."""
    rate, second = (Name(f"{q.name}_{dots}") for dots in ("dot", "ddot"))
    damping = line(" + 2 ζ ", Name(own.natural.name), " ", rate) if own.ratio is not None else ()
    stiffness = line(" + ", Math(own.natural**2), " ", Name(q.name))
    rest = line(" = ", Math(own.natural**2), " ", *map(Math, own.rest)) if own.rest else line(" = 0")
    return line(second, *damping, *stiffness, *(line(" = f(t)") if driven else rest))
