"""A check that a person can make of a motion that was found without energies: its kinetic energy against the work done.

T_1 + U = 1/2 m v_1² - μ m g x_2 = 32 - 23.5 = 8.5 J;  T_2 = 1/2 m v_2² = 8.5 J

It says nothing new where v² = v_0² + 2 a s was solved for the only speed of the only body: m/2 times that.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.exact import Sample
from planar_cli.equation.values.ledger import Kind, display
from planar_cli.report.document.blocks import Inline, Line, Name, Value, line
from planar_cli.report.energy.alike import WEIGHT, WEIGHTS
from planar_cli.report.in_numbers.sums import agree, chain, counting
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import BalanceTrace, MotionTrace, RouteStep
from planar_cli.units import ENERGY, LENGTH

BALANCE, PUT_IN = "work and energy", "what was found, put into "
"""Of an equation that was solved itself this tests the solving alone."""
MOST = 5
"""Terms that fit a line."""
SHORT, LONGEST, MOST_LETTERS = 9, 16, 20
"""Operations of a term in letters; of the energy at the end; of all terms."""


def energy_check(motion: MotionTrace, phrases: Phrases) -> Line:
    """The balance of the first stretch on which energies with numbers change; empty where there is none."""
    if motion.symbolic:
        return ()
    found = {r.unknown for leg in motion.route.steps for r in leg.results} | set(motion.route.plain)
    if isinstance(motion.value, Sample) and motion.value.drawn:
        return next((told for b in motion.unused if (told := _by_one_work(b, found, motion, phrases))), ())
    telling = [b for b in motion.unused if not _is_solved(b, motion, phrases)]
    return next((told for b in telling if (told := _named(b, found, motion, phrases))), ())


def _of_states(expr: sp.Expr, phrases: Phrases) -> set[sp.Symbol]:
    roles = phrases.ledger.roles
    return {s for s in expr.free_symbols if s in roles and roles[s].kind is Kind.STATE}


def _is_solved(balance: BalanceTrace, motion: MotionTrace, phrases: Phrases) -> bool:
    """Is it the v² = v_0² + 2 a s by which the page goes over that stretch, times m/2?"""
    relations = [e for leg in motion.route.steps for e in leg.relations]
    gone = any((e.since, e.stop, e.kind) == (balance.since, balance.stop, "v(q)") for e in relations)
    # With the R² of a wheel it tests how Newton's law shared its force and its couple.
    energies = [(e, _of_states(e, phrases)) for e in (balance.before, balance.after)]
    turned = any(any(p.exp == 2 for p in (e / s**2).atoms(sp.Pow)) for e, rates in energies for s in rates)
    single = all(len(rates) < 2 for _, rates in energies) and not turned
    return gone and single and len(balance.amounts) < 2


def _named(balance: BalanceTrace, found: Collection[sp.Symbol], motion: MotionTrace, phrases: Phrases) -> Line:
    """The balance with its energies and works in letters, where these are short and have values on the page, else with
    their words. Of one body it is told in letters alone.
    """
    places = {s for _, e in balance.brought for s in _of_states(e, phrases)}
    on_page = all(s in found or phrases.value.known(s) == 0 for s in places)
    if not (on_page or len(balance.amounts) > 1) or not _told(balance, found, phrases):
        return ()
    terms = [("", balance.before), *balance.brought]
    sizes = [phrases.certain(e) for _, e in terms]
    counted = set(counting(sizes))
    kept = [k for k, size in enumerate(sizes) if size in counted]
    letters = [_lettered(terms[k][1], motion, phrases) for k in kept]
    unit = coherent_unit(ENERGY, False, phrases.ledger.us)
    start, end = (Name(f"{balance.law.letter}__{state}") for state in (balance.since, balance.stop))
    left = line(*((start, " + ") if 0 in kept else ()), Name(balance.law.bring), " = ")
    numbers = chain([sizes[k] for k in kept], unit, phrases, "J")
    if on_page and not any(longer(e, SHORT) for e in letters) and sum(sp.count_ops(e) for e in letters) <= MOST_LETTERS:
        sides = line(*_sum(letters, phrases), " = ", *numbers)
    else:
        works = ", ".join(terms[k][0] for k in kept if k)
        sides = line(*numbers, f" ({works})" if works else "")
    return line(f"{BALANCE}: ", *left, *sides, "; ", end, " = ", *_at_end(balance, motion, phrases))


def _at_end(balance: BalanceTrace, motion: MotionTrace, phrases: Phrases) -> Line:
    """The kinetic energy at the end, of several bodies by each."""
    after, unit = _lettered(balance.after, motion, phrases), coherent_unit(ENERGY, False, phrases.ledger.us)
    if after == 0:
        return line("0")
    own = [(body, size) for body, e in balance.amounts if (size := phrases.certain(e))]
    if len(own) > 1:
        return line(*chain([size for _, size in own], unit, phrases, "J"), f" ({', '.join(body for body, _ in own)})")
    value = chain([phrases.certain(balance.after)], unit, phrases, "J")
    return line(*((phrases.math(after), " = ") if not longer(after, LONGEST) else ()), *value)


def _lettered(expr: sp.Expr, motion: MotionTrace, phrases: Phrases) -> sp.Expr:
    """In the names of the page, without what is zero; a way by the data where that is shorter: h for y_2 - y_1."""
    plain = expr.xreplace(dict(motion.route.plain))
    told = simplified(plain.xreplace({s: sp.S.Zero for s in plain.free_symbols if phrases.value.known(s) == 0}))
    ways = (s for s in _of_states(plain, phrases) if phrases.ledger.units[s].dimension == LENGTH)
    formulas = {s: motion.route.formulas.get(s) for s in ways}
    data = {s: f for s, f in formulas.items() if f is not None and not f.free_symbols & motion.general.keys()}
    short = simplified(plain.xreplace(data))
    fewer = len(_of_states(short, phrases)) < len(_of_states(told, phrases))
    return short if fewer and operations(short) <= operations(told) and _is_of_letters(short) else told


def _is_of_letters(expr: sp.Expr) -> bool:
    """Is every term a product of letters, so that no number hides a unit?"""
    return all(t.free_symbols for t in sp.Add.make_args(expr)) and not expr.atoms(sp.Add)


def _sum(terms: list[sp.Expr], phrases: Phrases) -> Line:
    told: list[Inline | str] = []
    for k, term in enumerate(terms):
        # A difference is written as the positive one, which may bring the minus to the front or take it away.
        neat = phrases.neat(term)
        minus = bool(neat.as_coeff_Mul()[0].is_negative) or (neat.is_Add and neat.could_extract_minus_sign())
        told += [(" - " if minus else " + ") if k else "-" if minus else "", phrases.math(-neat if minus else neat)]
    return line(*told)


def _by_one_work(balance: BalanceTrace, found: Collection[sp.Symbol], motion: MotionTrace, phrases: Phrases) -> Line:
    """The work of the only source, from rest: U = M θ_2 = 10 · 52.15 = 521.5 J = T_2. Letters without numbers stand
    neither in it nor in the energy that it must make.
    """
    drawn = motion.value.drawn if isinstance(motion.value, Sample) else frozenset()
    plain = dict(motion.route.plain)
    before, after = (e.xreplace(plain) for e in (balance.before, balance.after))
    works = [put for _, e in balance.brought if (put := simplified(e.xreplace(plain))) != 0]
    if len(works) != 1 or before != 0 or (works[0].free_symbols | after.free_symbols) & drawn:
        return ()
    roles = phrases.ledger.roles
    settled = all(s in motion.route.settled for s in after.free_symbols if s in roles and roles[s].kind is Kind.STATE)
    work, energy = phrases.value.known(works[0]), phrases.value.known(after)
    if not settled or work is None or energy is None or not agree([work], [energy]) or longer(works[0], MOST):
        return ()
    us = phrases.ledger.us
    unit = coherent_unit(ENERGY, False, us)
    value = Value(display(work, unit, us), unit.text if us else "J", phrases.figures)
    certain = replace(phrases, lettered=frozenset())
    sides: list[Inline] = [phrases.math(works[0]), *certain.substituted(works[0], value), value]
    end = Name(f"{balance.law.letter}__{balance.stop}")
    told = [p for side in sides for p in line(" = ", side)]
    return line(f"{BALANCE}: ", Name(balance.law.bring), *told, " = ", end)


def root_check(motion: MotionTrace, phrases: Phrases) -> Line:
    """The first balance of which one of several roots was taken, not of a square alone, or which was solved together
    with other equations, with what was found put in; empty where there is none.
    """
    if motion.symbolic or (isinstance(motion.value, Sample) and motion.value.drawn):
        return ()
    found = {r.unknown for leg in motion.route.steps for r in leg.results} | set(motion.route.plain)
    for leg in motion.route.steps:
        if len(leg.relations) == 1 and not _is_of_several_roots(leg):
            continue
        for e in leg.relations:
            if isinstance(e.source, BalanceTrace) and e.source.law.letter:
                told = _told(e.source, found, phrases, PUT_IN)
                if told := told or _told(_with_one_weight(e.source), found, phrases, PUT_IN):
                    return told
    return ()


def _with_one_weight(balance: BalanceTrace) -> BalanceTrace:
    """All weights as one source, where there are too many terms."""
    weights = sp.Add(*(x for words, x in balance.brought if words.startswith((WEIGHT, WEIGHTS))))
    rest = tuple((words, x) for words, x in balance.brought if not words.startswith((WEIGHT, WEIGHTS)))
    return replace(balance, brought=((WEIGHT, weights), *rest))


def _is_of_several_roots(leg: RouteStep) -> bool:
    """Was one of several values taken that differ by more than their sign?"""
    (r, *others) = leg.results
    return not others and len({abs(x.value) for x in r.roots}) > 1


def _told(balance: BalanceTrace, found: Collection[sp.Symbol], phrases: Phrases, lead: str = "") -> Line:
    """`found`: what has its value on the page; a speed that has none would be no check. `lead`: what is done."""
    exprs = [balance.before, *(e for _, e in balance.brought), balance.after]
    speeds = {s for e in (balance.before, balance.after) for s in e.free_symbols if s in phrases.ledger.roles}
    own = {s for s in speeds if phrases.ledger.roles[s].kind is Kind.STATE and s not in found}
    if any(phrases.value.known(s) != 0 for s in own):
        return ()
    known = [phrases.value.known(e) for e in exprs]
    *left, after = [k for k in known if k is not None]
    if len(known) != len(left) + 1 or not left or not agree(left, [after]):
        return ()
    # From rest the sum begins with nought.
    first = left[0] if counting([left[0], after, *left[1:]])[:1] == [left[0]] else Decimal(0)
    terms = [first, *counting(left[1:])]
    if not 2 <= len(terms) <= MOST:
        return ()
    unit = coherent_unit(ENERGY, False, phrases.ledger.us)
    before, end = (Name(f"{balance.law.letter}__{state}") for state in (balance.since, balance.stop))
    head = line(f"{lead}{BALANCE}: ", before, " + ", Name(balance.law.bring), " = ")
    return line(*head, *chain(terms, unit, phrases, "J"), " = ", end)
