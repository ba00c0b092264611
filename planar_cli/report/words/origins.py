"""Where a relation of a motion comes from, in words: the heading under which it is told."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from decimal import Decimal
from itertools import takewhile
from typing import Any

import sympy as sp

from planar_cli.calculus.linear_laws import EQUATION
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import by_name, simplified
from planar_cli.equation.values.ledger import Ledger
from planar_cli.problem.scene.scene import with_article
from planar_cli.report.document.blocks import Block, Equation, Line, Paragraph, Result, Text, line
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.names import plain_name
from planar_cli.report.words.changes import changes
from planar_cli.report.words.characteristic import with_coefficients
from planar_cli.report.words.spoken import spoken
from planar_cli.report.words.state_words import at, turning
from planar_cli.report.words.turning_values import over_time, why_there
from planar_cli.solve.between.trace import trace
from planar_cli.solve.between.trace.trace import (
    BalanceTrace,
    ImpactEquation,
    MotionTrace,
    Relation,
    RouteTrace,
)
from planar_cli.solve.law import IN_THE_END, Law

EDGE = "distance from the edge"
KEPT = {
    EDGE: "the distance from the line at {} stays the same",
    "distance of the centres": "the distance of the centres at {} stays the same",
    "angle": "the angle at {} stays the same",
    "length": "{} keeps its length",
    "arcs on both rims": "{} runs over equal arcs of both rims",
    "arc rolled on the line": "at {} the arc rolled equals the way along the line",
    "arcs rolled on each other": "at {} equal arcs roll on each other",
}
"""What a joint keeps of places, by what follows its name in the title."""
DRAWN = "in the given position"
DIRECTION = re.compile(r"^[va]\([^()]*\)\.angle = (-?[\d.]+) deg$")
PLACE, ACROSS = "place of ", " across its line"
"""What stands about the name of a point that a line leads."""


def head(e: Relation, names: Mapping[str, sp.Symbol]) -> Line:
    """The heading of a relation. `names`: those of symbols, which are set as mathematics."""
    if is_vibration(e):
        return line(at(e.stop) if e.stop else f"From {e.since} on:")
    if e.span is not None:
        reach = f"From {e.since} to {e.stop}" if e.stop else f"From {e.since} on"
        if e.since and e.law is not None and (e.law.order, e.law.f) == (1, 0):
            thing = with_article(e.law.coordinate.words.partition(" of ")[2].partition(" ")[0])
            return line(f"{reach} {thing or 'it'} stays where it is:")
        words = calculus(e)
        return line(f"{reach}, " if e.since else "", with_coefficients(words, e.law, names["t"]), ":")
    if e.is_datum:
        words = turning(e.words) if e.kind == "turn" else DRAWN if e.kind == "drawn" else e.words
        words += components_of(e.words) if e.kind == "given" else ""
        return spoken(at(e.stop, words), names)
    if e.kind == "handed" and e.stop:
        # Its velocity or place there in other letters, from which the next part of the motion starts.
        return line(at(e.stop))
    if e.kind == "link" and e.words.endswith(" follows") and (told := changes(e)):
        return line(f"From {e.since} to {e.stop}, by the kinematics, ", *told, ":")
    words = kept(e.words) if e.kind == "loop" else e.words
    words += f", {why_there(e)}" if over_time(e) else components_of(e.words) if e.kind == "given" else ""
    return spoken(f"From {e.since} to {e.stop}, {words}:" if e.since else at(e.stop, words), names)


def is_vibration(e: Relation) -> bool:
    """Is it a relation by the time of a vibration, whose motion is told by itself before?"""
    return e.law is not None and e.law.vibration is not None and e.span is not None and EQUATION in e.span.words


def components_of(words: str) -> str:
    """What a direction that the file gives in degrees says of the components; "" of other words."""
    found = DIRECTION.search(words)
    if found is None:
        return ""
    angle = Decimal(found[1])
    if angle % 90 == 0:
        return f", so that its {'y' if angle % 180 == 0 else 'x'} component is zero"
    return f", so that its y component is tan({found[1]}°) times its x component"


def sides_of(e: Relation, route: RouteTrace) -> tuple[sp.Expr, sp.Expr]:
    """A relation as two sides, as the law writes them from which it comes."""
    if isinstance(e.source, ImpactEquation):
        return e.source.left.xreplace(dict(route.plain)), e.source.right.xreplace(dict(route.plain))
    if isinstance(e.source, BalanceTrace):
        sides = (e.source.before + e.source.gain, e.source.after)
        return sides[0].xreplace(dict(route.plain)), sides[1].xreplace(dict(route.plain))
    residual = (e.residual if e.told is None else e.told).xreplace(dict(route.plain))
    left = sp.Add(*(a for a in sp.Add.make_args(residual) if not a.could_extract_minus_sign()))
    return left, left - residual


def kept(title: str) -> str:
    """What a joint keeps: `B: distance from the edge` as a sentence."""
    name, _, what = title.partition(": ")
    if what == EDGE and name[:1].isupper():
        return f"{name} is still on its line"
    if what in KEPT:
        return KEPT[what].format(name)
    if what.startswith(PLACE) and what.endswith(ACROSS):
        point = what.removeprefix(PLACE).removesuffix(ACROSS)
        own = name == point or re.fullmatch(rf"{point}_\d+", name)
        return f"{point} stays on {'its line' if own else f'the line {name}'}"
    if what.startswith("place on "):
        first, _, second = what.removeprefix("place on ").partition(" and ")
        first, second = ("the ground" if body == "ground" else body for body in (first, second))
        return f"{name} belongs to {first} and to {second}"
    return f"{name} {what}" if what.startswith("stays on ") else title


def calculus(e: Relation) -> str:
    """Where a relation between two states comes from, in the letters of its coordinate."""
    assert e.span is not None
    if e.law is None:
        return e.span.words
    q = e.law.coordinate
    if is_steady(e):
        return f"{_steady_words(e.law, e.kind)}{_of_what(q.words)}"
    single = plain_name(q.symbol.name.split("_")[0]) if q.unit != "rad" else plain_name(q.symbol.name)
    words = re.sub(r"\bsolved for q\b", f"solved for {single}", re.sub(r"\bdq\b", f"d{single}", e.span.words))
    if q.unit == "rad":
        speed, rate = (plain_name(f"{q.symbol.name}_{dots}") for dots in ("dot", "ddot"))
        speed, rate = (speed, rate) if _runs_over(e, f"{q.symbol.name}_dot") else ("ω", "α")
        words = re.sub(r"\b(d?)v(?=²|\b)", rf"\1{speed}", re.sub(r"\ba\b", rate, words))
    return f"{words}, {q.words}" if q.words != q.symbol.name else words


def _runs_over(e: Relation, name: str) -> bool:
    """Has the integral of a relation this letter as its variable?"""
    left = e.span.left if e.span is not None else None
    return isinstance(left, sp.Integral) and left.variables[0].name == name


def is_steady(e: Relation) -> bool:
    """Is it a relation of constant velocity or constant acceleration? The course knows these without an integral."""
    law = e.law
    if law is None or e.span is None or e.kind not in ("v(t)", "q(t)", "v(q)"):
        return False
    return law.order > 0 and not law.f.has(sp.Symbol("t", real=True), law.coordinate.symbol, law.v)


def _of_what(words: str) -> str:
    """Whose velocity or acceleration is constant, by what its coordinate counts: y of P, angle of the wheel."""
    what, of, thing = words.partition(" of ")
    if what in ("x", "y") and of:
        return f" of {with_article(thing)} along {what}"
    if not of:
        return f", {plain_name(words)}"
    name, _, way = thing.partition(" ")
    return f" of {with_article(name)} {way}".rstrip() if what in ("angle", "way") else f", {words}"


def _steady_words(law: Law, kind: str) -> str:
    """What is constant."""
    turns = "angular " if law.coordinate.unit == "rad" else ""
    if law.order == 2 and law.f != 0:
        return f"constant {turns}acceleration"
    return f"no {turns}acceleration" if kind == "v(t)" else f"constant {turns}velocity"


def known_from(e: Relation, r: trace.Result) -> str:
    """Where a datum comes from; nothing where it is worked out of what is given."""
    if e.kind in ("turn", "followed"):
        return turning(e.words) if e.kind == "turn" else "found by trial" if "trial" in e.words else ""
    plainly = r.formula is None or r.formula.is_number or (r.formula / r.formula.as_coeff_Mul()[0]).is_Symbol
    given = "as given" if plainly and e.words != IN_THE_END else ""
    return {"drawn": DRAWN, "start": e.words}.get(e.kind, given)


def told_once(blocks: Iterable[Block]) -> Iterator[Block]:
    """Blocks without a heading that is still in force: only equations and results have followed it."""
    heading: Paragraph | None = None
    for block in blocks:
        if isinstance(block, Paragraph):
            if block == heading or _is_said(block, heading):
                continue
            heading = block
        elif not isinstance(block, Equation | Result):
            heading = None
        yield block


def _is_said(block: Paragraph, heading: Paragraph | None) -> bool:
    """Does `At B:` stand under `At B, y = -3/4 x:`?"""
    if heading is None or len(block.line) != 1 or not isinstance(block.line[0], Text):
        return False
    said = "".join(p.text for p in takewhile(lambda p: isinstance(p, Text), heading.line) if isinstance(p, Text))
    place = block.line[0].text.removesuffix(":")
    return place.startswith("At ") and said.startswith(f"{place},")


def without_number(residual: sp.Expr) -> sp.Expr:
    """What vanishes, without a number that all of it is multiplied by: √2/2 (v + w_y - w_x) says v + w_y - w_x = 0."""
    numbers = [f for f in sp.Mul.make_args(residual) if f.is_number]
    return residual if residual == 0 or not numbers else residual / sp.Mul(*numbers)


def balanced(e: Relation, residual: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """What vanishes as two sides without a minus in front; a derivative of one letter stands as it is, 20 - 4 t = 0."""
    if over_time(e) and len(residual.free_symbols) == 1:
        return residual, sp.S.Zero
    residual = residual if e.told is None else e.told
    residual = without_number(residual) if e.kind == "given" else residual
    positive = [a for a in sp.Add.make_args(residual) if not a.could_extract_minus_sign()]
    left = sp.Add(*positive)
    alone = next((a for a in reversed(positive) if a.is_Symbol), None)
    if left == residual and alone is not None and e.span is None:
        left = alone
    return left, left - residual


def is_explicit(e: Relation, leg: trace.RouteStep, route: RouteTrace, ledger: Ledger) -> bool:
    """Does the one relation of a step itself give its unknown, with what is left out of it or put in?"""
    result = leg.results[0]
    if result.formula is not None:
        own, residual = result.unknown - result.formula, e.residual.xreplace(dict(route.plain))
        if e.kind in (trace.PAIR, "link") or e.is_datum:
            return bool(expanded(residual - own) == 0) or e.kind in (trace.PAIR, "link")
        if e.kind in ("loop", "handed") and not result.roots[1:]:
            return any(expanded(residual - sense * own) == 0 for sense in (1, -1))
    return e.span is not None and e.span.explicit is not None and letter_of(e, ledger) == result.unknown


def is_handed_on(r: trace.Result) -> bool:
    """Does a letter only keep its value of the state before?"""
    return r.formula is not None and (r.formula.is_Symbol or r.formula.is_number)


def says_zero(e: Relation, r: trace.Result, route: RouteTrace, ledger: Ledger) -> bool:
    """Does a relation that is no balance say at sight that a letter is zero, without others that have to vanish? Of
    what a joint keeps its heading says it, where numbers of the file hide units in the equation.
    """
    if r.formula != 0 or isinstance(e.source, BalanceTrace):
        return False
    if isinstance(e.source, ImpactEquation) or (e.kind == "loop" and not is_clean(ledger, *sides_of(e, route))):
        return True
    return r.unknown not in simplified(e.residual.xreplace(dict(route.plain)) / r.unknown).free_symbols


def letters_of_blows(found: MotionTrace) -> set[sp.Symbol]:
    """The letters in the equations of blows on the way to the answers, and in what is asked."""
    blows = (e.source for leg in found.route.steps for e in leg.relations if isinstance(e.source, ImpactEquation))
    sides = [side for e in blows for side in (e.left, e.right)] + [p for r in found.requests for p in r.parts]
    return {s for side in sides for s in sp.sympify(side).free_symbols}


def inertias_of_blows(found: MotionTrace) -> dict[sp.Symbol, sp.Expr]:
    """Moments of inertia about the points at which blows hold bodies, with their formulas."""
    blows = (e.source for leg in found.route.steps for e in leg.relations if isinstance(e.source, ImpactEquation))
    made: dict[sp.Symbol, sp.Expr] = {}
    for e in blows:
        ledger = e.impact.solution.instant.scene.ledger if e.impact.solution is not None else found.ledger
        for symbol in by_name((e.left - e.right).free_symbols & ledger.definitions.keys()):
            if " about " in ledger.titles.get(symbol, ""):
                made[symbol] = ledger.definitions[symbol].xreplace(dict(ledger.definitions))
    return made


def is_outright(e: Relation, r: trace.Result, route: RouteTrace, ledger: Ledger) -> bool:
    """Does a relation say no more than that its letter is a number, as v - 5 = 0? A derivative that vanishes at some
    time says first what it is, 20 - 4 t = 0.
    """
    if e.source is not None or e.span is not None or r.formula is None or not r.formula.is_number:
        return False
    if over_time(e) and ledger.roles[r.unknown].of == ledger.symbols.get("t"):
        return False
    slope = sp.diff(e.residual.xreplace(dict(route.plain)), r.unknown)
    return bool(slope.is_number) and slope != 0


def letter_of(e: Relation, ledger: Ledger) -> sp.Symbol | None:
    """The letter that a relation between states gives, by its kind."""
    span = e.span
    if span is None:
        return None
    if span.explicit is not None:
        found = (span.residual + span.explicit).expand() if span.residual.is_Add else span.residual + span.explicit
        found = simplified(found)
        return found if found.is_Symbol else None
    if e.kind == "v(q)":
        roles = ledger.roles
        own = [s for s in by_name(span.residual.free_symbols) if s in roles and roles[s].at == e.stop]
        return next((s for s in own if span.residual.coeff(s, 2) == 1), None)
    return None


def needed_steps(route: RouteTrace, wanted: Collection[str] | None) -> list[trace.RouteStep]:
    """The steps on which wanted letters rest; None: all of them."""
    if wanted is None:
        return list(route.steps)
    names, kept = set(wanted), []
    for leg in reversed(route.steps):
        if any(x.name in names for x in leg.unknowns):
            kept.append(leg)
            names |= {s.name for s in leg.needs}
    return kept[::-1]


def needed_results(leg: trace.RouteStep, found: MotionTrace) -> list[trace.Result]:
    """What a step gives that is asked, or that a later line rests on; its first result always."""
    if len(leg.results) < 2:
        return list(leg.results)
    used = set(used_elsewhere(leg, found))
    kept: list[trace.Result] = []
    for r in reversed(leg.results):
        if r is leg.results[0] or r.unknown in used:
            kept.insert(0, r)
            used |= r.formula.free_symbols if r.formula is not None else set()
    return kept


def used_elsewhere(leg: trace.RouteStep, found: MotionTrace) -> set[sp.Symbol]:
    """The unknowns of a step that are asked, or on which other lines rest."""
    routes = [found.route, *found.passing.values()]
    used = {s for route in routes for step in route.steps if step is not leg for s in letters_of(step)}
    used |= {s for r in found.requests for e in (*r.parts, *(f for _, f in r.beside)) for s in e.free_symbols}
    used |= {s for span in found.spans if span.formula is not None for s in span.formula.free_symbols}
    used |= {s for span in found.spans for piece in span.pieces for s in piece.limits}
    told = {state for regime in found.regimes for state in regime.asked}
    roles = found.ledger.roles
    return {x for x in leg.unknowns if x in used or x not in roles or roles[x].at in told}


def letters_of(step: trace.RouteStep) -> set[Any]:
    return {*step.needs, *(s for e in step.relations for s in e.residual.free_symbols)}
