"""Branches of one instant that hold as well as each other: told as one where what is asked is the same, else refused.

A speed that is given without its direction leaves pairs of roots. A sought constant takes the positive one of its
roots; of what moves, the file says which way, and of a place, where it is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from decimal import Decimal
from typing import TYPE_CHECKING

import sympy as sp

from planar_cli.equation.system.system import System
from planar_cli.equation.values.ledger import display
from planar_cli.errors import Diagnostic, Mark, NoSolution
from planar_cli.problem.implied.not_negative import distances
from planar_cli.problem.language.expression import Quantity, Relation
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.geometry import Vec
from planar_cli.solve.diagnosis.choosing import relation_between
from planar_cli.solve.diagnosis.words import in_unit
from planar_cli.units import parse_unit

if TYPE_CHECKING:
    from planar_cli.equation.values.exact import Valuation
    from planar_cli.solve.instant.branches import Choice
    from planar_cli.solve.instant.instant import Instant
    from planar_cli.solve.instant.seeker import Sought

CLOSE = Decimal("1e-25")
"""Numbers that differ by no more than this share of their size are the same."""
UNITS = {"r": ("m", "ft"), "v": ("m/s", "ft/s"), "a": ("m/s^2", "ft/s^2")}
"""In what vectors are measured, in SI and in US customary units."""
SAME = "it holds as well, and what is asked is the same"

Asked = Callable[[System], Sequence[sp.Expr]]
"""What the finds ask, in the unknowns of a system."""


class BothWays(NoSolution):
    """What is given holds both ways, and the answers differ."""


def demand_one_way(instant: Instant, taken: Sought, asked: Asked, mark: Mark) -> Sought:
    """The branch that was taken, if no other with the same constants answers otherwise; else NoSolution."""
    sought = list(instant.scene.ledger.sought)
    others = []
    _demand_one_place(instant, taken, asked, mark)
    here = asked(taken.trial.system)
    of_place = any(_of_place(instant, c) for c in taken.branch.choices)
    for s in taken.others:
        rival = _same(s, taken, sought, sought)
        alike = (rival or of_place) and _same(s, taken, asked(s.trial.system), here)
        if rival and not alike:
            raise BothWays([_both(instant, taken, s, mark)])
        others.append(replace(s, objection=SAME) if alike else s)
    return replace(taken, others=others)


def _demand_one_place(instant: Instant, taken: Sought, asked: Asked, mark: Mark) -> None:
    """NoSolution: equations in several unknowns hold in several ways, or what is given in several positions, and the
    answers differ. A distance is not negative.
    """
    if not any(_of_place(instant, c) for c in taken.branch.choices):
        return
    here = asked(taken.trial.system)
    # A sought constant takes the positive one of its roots: that chooses between positions as well.
    others = [s for s in taken.others if _negative(instant, s) == _negative(instant, taken)]
    others = [s for s in others if not _same(s, taken, asked(s.trial.system), here)]
    if others:
        ways = "; or ".join(dict.fromkeys(_told(instant, s) for s in (taken, *others)))
        text = f"{ways}: with each of them all equations hold"
        relation = _between(instant, [taken, *others])
        such = f"`{relation}`, or with `>`" if relation else "`y(P) < 0`"
        hint = f"say which is meant by an inequality that one alone fulfils, such as {such}"
        raise NoSolution([Diagnostic(mark, "PL635", text, hint)])


def _of_place(instant: Instant, choice: Choice) -> bool:
    """Is it one of roots that were looked for together, or a coordinate, of which the file says where it is meant?"""
    return choice.together or choice.symbol in instant.scene.ledger.coordinates


def _negative(instant: Instant, s: Sought) -> int:
    """How many sought constants and distances are negative?"""
    ledger, value = instant.scene.ledger, s.branch.algebra.value.values
    apart = distances(instant.scene.problem)
    amounts = (c for c in ledger.sought if c not in ledger.coordinates or c.name in apart)
    return sum(value[c] < 0 for c in amounts if c in value)


def _told(instant: Instant, s: Sought) -> str:
    """The roots of one way, in the units of the file."""
    ledger = instant.scene.ledger
    found = ((c.symbol, c.roots[c.taken].value) for c in s.branch.choices if _of_place(instant, c))
    return ", ".join(f"{x.name} = {in_unit(v, ledger.units[x], ledger.us)}" for x, v in found)


def _between(instant: Instant, ways: Sequence[Sought]) -> str:
    """An inequality of what has another value in each of them; "": there is none."""
    ledger = instant.scene.ledger
    for x in (c.symbol for c in ways[0].branch.choices if _of_place(instant, c) and c.symbol in ledger.sought):
        told = [v for s in ways if (v := s.branch.algebra.value.values.get(x)) is not None]
        numbers = [float(f"{display(v, ledger.units[x], ledger.us):.6g}") for v in told]
        if len(told) == len(ways) and (relation := relation_between(x.name, ledger.units[x], numbers)):
            return relation
    return ""


def _numbers(s: Sought) -> Valuation:
    return s.trial.outcomes[0].value.extended(s.branch.algebra.value.values)


def _same(one: Sought, other: Sought, mine: Sequence[sp.Expr], others: Sequence[sp.Expr]) -> bool:
    """Have expressions the same values in two branches, by the size of their terms?"""
    a, b = _numbers(one), _numbers(other)
    return all(abs(a(e) - b(f)) <= CLOSE * max(a.size(e), b.size(f)) for e, f in zip(mine, others, strict=True))


def _both(instant: Instant, one: Sought, other: Sought, mark: Mark) -> Diagnostic:
    """What holds both ways, and the relation that would choose."""
    sized = [r for r, _ in instant.statements.relations if list(_sizes(r))]
    # A size whose direction is told elsewhere is the same both ways.
    stated = [r for r in sized if not _agree(_directed([r], one), _directed([r], other))] or sized
    text = " and ".join(f"`{r.text}`" for r in stated) or "what is given"
    choice = _choice(stated, one, other)
    hint = f"write `{choice} > 0` or `{choice} < 0`" if choice else "an inequality chooses, such as `omega(b) > 0`"
    if not choice and (between := _limit(instant, stated, one, other)):
        hint = f"an inequality chooses, such as `{between}`, or the same with `>`"
    at = stated[0].mark if stated else mark
    return Diagnostic(at, "PL618", f"{text} holds both ways, and the answers differ", hint)


def _sizes(relation: Relation) -> Iterator[Quantity]:
    """The vectors of which only a size stands in a relation; a radius of curvature is a size of the acceleration, and
    so is its part towards the centre of curvature, which may lie on either side of the path.
    """
    for node in walk(relation):
        if isinstance(node, Quantity) and node.parts and node.parts[-1].kind in ("mag", "n"):
            yield replace(node, parts=node.parts[:-1])
        elif isinstance(node, Quantity) and node.word == "rho":
            yield replace(node, word="a", parts=())


def _choice(stated: Sequence[Relation], one: Sought, other: Sought) -> str:
    """Something that has opposite signs in the two branches, as the file would write it; "" for nothing."""
    for (text, a), (_, b) in zip(_candidates(stated, one), _candidates(stated, other), strict=True):
        if a * b < 0:
            return text
    return ""


def _limit(instant: Instant, stated: Sequence[Relation], one: Sought, other: Sought) -> str:
    """An inequality with a number between the values of one component in the two branches; "" for nothing."""
    for (text, a), (_, b) in zip(_directed(stated, one), _directed(stated, other), strict=True):
        unit = UNITS.get(text.partition("(")[0], ("1", "1"))[instant.scene.ledger.us]
        apart = abs(a - b) > CLOSE * max(abs(a), abs(b))
        if apart and (relation := relation_between(text, parse_unit(unit), [float(a), float(b)])):
            return relation
    return ""


def _agree(one: Iterator[tuple[str, Decimal]], other: Iterator[tuple[str, Decimal]]) -> bool:
    return all(abs(a - b) <= CLOSE * max(abs(a), abs(b)) for (_, a), (_, b) in zip(one, other, strict=True))


def _directed(stated: Sequence[Relation], s: Sought) -> Iterator[tuple[str, Decimal]]:
    """Components of what is given by its size."""
    quantities, value = s.trial.system.quantities(), _numbers(s)
    for q in (q for r in stated for q in _sizes(r)):
        found = quantities.any(q)
        if isinstance(found, Vec):
            yield f"{q.word}({'/'.join(q.things)}).x", value(found.x.value)
            yield f"{q.word}({'/'.join(q.things)}).y", value(found.y.value)


def _candidates(stated: Sequence[Relation], s: Sought) -> Iterator[tuple[str, Decimal]]:
    """Components of what is given by its size, then the velocities of bodies."""
    yield from _directed(stated, s)
    system, value, motion = s.trial.system, _numbers(s), s.trial.system.motion
    assert motion is not None
    for body in system.scene.bodies:
        v = motion.velocity(system.scene.center(body), body)
        yield f"omega({body})", value(motion.velocities[body].angular)
        yield f"v({body}).x", value(v.x)
        yield f"v({body}).y", value(v.y)
