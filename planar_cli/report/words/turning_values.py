"""Largest and smallest values over time: where the derivative is zero, one kind of root is the largest, the other the
smallest value.
"""

from __future__ import annotations

import re
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.ledger import Kind
from planar_cli.report.document.blocks import Line, Math, Paragraph, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Relation, Result
from planar_cli.solve.instant.roots import Root

LARGEST, SMALLEST = " is largest", " is smallest"
SAME = Decimal("1e-20")
DERIVATIVE, EQUALLY_FAST = "where its derivative is zero", "where both change equally fast"
UNACCELERATED = "where the acceleration along the path is zero"
SPEED = re.compile(r"(?:v\(\w+\)\.mag|\|v(?:_\w+)?\|) is (?:largest|smallest)")
GAP = re.compile(r"([xys])(?:_\w+|\(\w+\)) - \1(?:_\w+|\(\w+\)) is (?:largest|smallest)")


def over_time(e: Relation) -> bool:
    """Is it the condition of a largest or smallest value over time?"""
    return e.kind == "extreme" and e.words.endswith((LARGEST, SMALLEST))


def why_there(e: Relation) -> str:
    """Where something is largest or smallest: its derivative is zero; that of a difference of two places, x_A - x_B,
    where both change equally fast; that of a speed, d|v|/dt = a_t, where this acceleration is.
    """
    return EQUALLY_FAST if GAP.fullmatch(e.words) else UNACCELERATED if SPEED.fullmatch(e.words) else DERIVATIVE


def other_kind(found: MotionTrace, r: Result, left: list[Root], phrases: Phrases) -> Paragraph | None:
    """`not 3 T/4: there it would be smallest`, where that is true of all other roots; None: it is not, or there is no
    such value. In a place where the motion was before it is so.
    """
    relation = _condition(found, r) if left else None
    senses = None if relation is None else _senses(found, r, relation, left)
    if relation is None or senses is None or not all(sense < 0 for sense in senses):
        return None
    kind = "smallest" if relation.words.endswith(LARGEST) else "largest"
    verb = "is" if all(_was_there(found, r, x) for x in left) else "would be"
    return Paragraph(line("not ", *_listed(r, left, phrases), f": there it {verb} {kind}"))


def beyond_the_end(found: MotionTrace, r: Result, left: list[Root]) -> bool:
    """Are all other roots of a largest or smallest value times after the last state, when nobody looks any more?"""
    letters = [s for s, own in found.general.items() if found.ledger.roles[own].kind is Kind.TIME]
    end = max((t for s in letters if (t := found.value.known(s)) is not None), default=r.value)
    return (
        bool(left)
        and r.unknown in letters
        and _condition(found, r) is not None
        and all(x.value > end > r.value for x in left)
    )


def _was_there(found: MotionTrace, r: Result, root: Root) -> bool:
    """Is a root the value of the same letter in another state?"""
    general = found.general.get(r.unknown)
    others = (found.value.known(s) for s, own in found.general.items() if own == general and s != r.unknown)
    return any(n is not None and abs(n - root.value) <= SAME * max(abs(n), Decimal(1)) for n in others)


def of_the_same_kind(found: MotionTrace, r: Result, left: list[Root], phrases: Phrases) -> Paragraph | None:
    """`other local maxima: 2.526 s, 4.712 s`, the later ones among the roots that were found; None: there are none."""
    later = [x for x in left if x.value > r.value]
    relation = _condition(found, r) if later else None
    senses = None if relation is None else _senses(found, r, relation, later)
    alike = [x for x, sense in zip(later, senses or (), strict=bool(senses)) if sense > 0]
    if relation is None or not alike:
        return None
    one, several = ("maximum", "maxima") if relation.words.endswith(LARGEST) else ("minimum", "minima")
    told = f"another local {one}" if len(alike) == 1 else f"other local {several}"
    return Paragraph(line(f"{told} at ", Math(r.unknown), " = ", *_listed(r, alike, phrases)))


def _condition(found: MotionTrace, r: Result) -> Relation | None:
    """The condition of a largest or smallest value over time from which a letter was found; None: it was another."""
    relations = [e for leg in found.route.steps if r in leg.results for e in leg.relations]
    return relations[0] if len(relations) == 1 and over_time(relations[0]) else None


def _senses(found: MotionTrace, r: Result, condition: Relation, others: list[Root]) -> list[Decimal] | None:
    """By their signs whether other roots are of the kind of the one that was taken; None: it can not be told."""
    slope = sp.diff(condition.residual, r.unknown)
    if any(found.value.known(s) is None for s in slope.free_symbols):
        return None

    def sense(at: Decimal) -> Decimal:
        return found.value.extended({r.unknown: at})(slope)

    own = sense(r.value)
    return [own * sense(x.value) for x in others] if own else None


def _listed(r: Result, roots: list[Root], phrases: Phrases) -> list[str | Math | Line]:
    """Roots, in letters where they have some, with commas between them."""
    parts: list[str | Math | Line] = []
    for i, x in enumerate(roots):
        letters = x.expression is not None and not x.expression.is_number
        shown = phrases.math(x.expression) if letters else phrases.shown(r.unknown, x.value)
        parts += [*([", "] if i else []), line(shown)]
    return parts
