"""What is worth discussing of answers in letters: a special case in which they come to something that is known.

    With m_A = m_B:  a = 0, T = m_A g            equal weights balance each other
    Without friction, μ = 0:  a = g sin β
    With m_B → 0:  a = -g                        a free fall
    With h → 0:  c = 2 m g/k                     a load put on suddenly: twice the compression at rest

It is no check: nothing else is worked out for it. Only formulas with sums get there something that they do not show at
sight; where the special case would say that a force of nothing is nothing it is none. Nor is one that the file rules
out, or that brings a number nobody expects: v_0 = 2 √(5 g l) is known to no one beforehand.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import combinations

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.records import record
from planar_cli.report.document.blocks import Line, Math, Name, line
from planar_cli.report.given.presumed import assumed_in_file
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import LENGTH, MASS, PURE, TIME

LONGEST, SHORT, MOST, MANY = 40, 3, 2, 3
"""Operations of an answer; factors of what it comes to; answers told of one case; so many a length must tell: without
a height all of a fall is known, while a body without a length is none.
"""
SIMPLE = (1, -1, 2, -2, sp.Rational(1, 2), sp.Rational(-1, 2))
"""Numbers that stand before what is known."""
ROOTED = (2, sp.Rational(1, 2))
"""Numbers under a root there: √(2 g h) is known, √(5 g l) is not."""


@record
class _Case:
    """A special case: its words, what it puts in, whether a zero says something there, and of how many answers at least
    it must tell.
    """

    words: Line
    values: Mapping[sp.Symbol, sp.Expr]
    zero: bool
    least: int = 1


def special_case(part: PartSolution, phrases: Phrases) -> Line:
    """The case that tells most answers, the first of several; empty where none comes to a short product."""
    answers = [f for f in part.found if _is_open(f)]
    letters = {s for f in answers for s in _formula(f).free_symbols}
    assumed = list(assumed_in_file(part)) if part.instants else []
    best: list[tuple[Found, sp.Expr]] = []
    words: Line = ()
    for case in _cases(letters, phrases):
        if any(_rules_out(r, case) for r in assumed) or any(_is_never(f, case) for f in answers):
            continue
        told = [(f, value) for f in answers if (value := _in_case(_formula(f), case)) is not None]
        # That nothing comes of an angle of zero is no news; that equal weights stay at rest is.
        if all(value == 0 for _, value in told) and not all(v.is_Symbol for v in case.values.values()):
            continue
        if len(told) >= case.least and _weight(told) > _weight(best):
            best, words = told, case.words
    # What something comes to tells more than that another is nothing.
    chosen = sorted(sorted(range(len(best)), key=lambda i: best[i][1] == 0)[:MOST])
    pairs = ((k, *best[i]) for k, i in enumerate(chosen))
    shown = [line("; " if k else "", Name(f.name), " = ", phrases.math(value)) for k, f, value in pairs]
    return line(*words, ": ", *(piece for one in shown for piece in one), ".") if shown else ()


def _weight(told: list[tuple[Found, sp.Expr]]) -> tuple[int, int]:
    """By which of several cases the better is told: how many results stand without a number, and how many there are."""
    return sum(value.as_coeff_Mul()[0] in (0, *SIMPLE) for _, value in told), len(told)


def _is_open(found: Found) -> bool:
    """Is it a number with a formula in letters, which is a sum or has one in it?"""
    return (
        found.kind == "number"
        and found.values is None
        and not found.word
        and found.curve is None
        and len(found.expressions or ()) == 1
        and _formula(found).has(sp.Add)
        and not longer(_formula(found), LONGEST)
    )


def _formula(found: Found) -> sp.Expr:
    assert found.expressions is not None
    return found.expressions[0]


def _cases(letters: set[sp.Symbol], phrases: Phrases) -> Iterator[_Case]:
    """The special cases that a teacher would try, by the letters of the answers."""
    ledger = phrases.ledger
    own = [s for s in ledger.letters if s in letters and s.name != "g" and s in ledger.units]
    masses = [s for s in own if ledger.units[s].dimension == MASS]
    for one, other in combinations(masses, 2):
        yield _Case(line("With ", Math(one), " = ", Math(other)), {one: other}, True)
    for s in own:
        if of := ledger.coefficients.get(s.name):
            yield _Case(line(f"Without {of}, ", Math(s), " = 0"), {s: sp.S.Zero}, False)
    for s in own:
        if ledger.units[s].angle and ledger.units[s].dimension == PURE:
            yield _Case(line("With ", Math(s), " = 0"), {s: sp.S.Zero}, True)
            yield _Case(line("With ", Math(s), " = 90°"), {s: sp.pi / 2}, True)
    for s in masses:
        yield _Case(line("With ", Math(s), " → 0"), {s: sp.S.Zero}, False)
    for s in own:
        if ledger.units[s].dimension == LENGTH:
            yield _Case(line("With ", Math(s), " → 0"), {s: sp.S.Zero}, False, MANY)


def _rules_out(relation: sp.Expr, case: _Case) -> bool:
    """Does what the file assumes never hold in this case? On the border of what it assumes the answers hold still."""
    difference = relation.lhs - relation.rhs
    value = simplified(sp.sympify(difference).xreplace(dict(case.values)))
    return bool(value.is_positive if relation.rel_op in ("<", "<=") else value.is_negative)


def _is_never(found: Found, case: _Case) -> bool:
    """Is it a time that grows beyond bounds: does its state never come, as of equal weights that are let go?"""
    value = _formula(found).xreplace(dict(case.values))
    return found.unit.dimension == TIME and bool(value.has(sp.zoo, sp.oo))


def _in_case(formula: sp.Expr, case: _Case) -> sp.Expr | None:
    """What a formula comes to; None: it does not depend on the case, or it is nothing that is known beforehand."""
    if not formula.free_symbols & set(case.values):
        return None
    value = formula.xreplace(dict(case.values))
    if value.has(sp.nan, sp.zoo, sp.oo, sp.Piecewise):
        return None
    value = simplified(value)
    if value == 0:
        return value if case.zero else None
    number, rest = value.as_coeff_Mul()
    factors = sp.Mul.make_args(rest)
    known = number in SIMPLE and not value.is_number and len(factors) <= SHORT
    rooted = any(p.base.as_coeff_Mul()[0] not in (1, *ROOTED) for p in rest.atoms(sp.Pow) if not p.exp.is_Integer)
    return value if known and not rooted and not value.has(sp.Add, sp.log, sp.exp) else None
