"""Roots of a motion that were not taken, with what rules them out: a time that is not after the state before, a motion
in the other sense, a place on the other side of the start. Where nothing of mechanics does, nothing is said.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.system.system import System
from planar_cli.equation.values.ledger import Kind
from planar_cli.problem.language import expression
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.scene import GROUND, Polar
from planar_cli.report.document.blocks import Block, Line, Math, Name, Paragraph, Text, line
from planar_cli.report.equations.turning_back import only_on_the_way_back
from planar_cli.report.given.stated_bounds import stated_bound
from planar_cli.report.words.turning_values import beyond_the_end, of_the_same_kind, other_kind
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Result

SAME, TINY = Decimal("1e-9"), Decimal("1e-30")
"""Roots that differ by less, in parts of themselves and at all, are the same."""
MOST_ROOTS = 4
ROOT, ITSELF = " root: ", " itself"
FIRST, WHICH, AS = "the first such time after ", "the root for which ", "as "
SENSES = {
    "omega": ("it turns counterclockwise", "it turns clockwise"),
    "x": ("it moves to the right", "it moves to the left"),
    "y": ("it moves upward", "it moves downward"),
    "to the left": ("it moves to the left", "it moves to the right"),
    "downward": ("it moves downward", "it moves upward"),
}


def rejected(found: MotionTrace, r: Result, phrases: Phrases, told: Collection[sp.Symbol]) -> Iterator[Block]:
    """Which root of a letter is taken, and why; nothing where only their size tells them apart. `told`: letters that
    the page gives.
    """
    left = [x for x in r.roots if abs(x.value - r.value) > abs(r.value) * SAME + TINY]
    others = [x.value for x in left]
    if r.unknown in found.named:
        yield from _of_asked(found, r, others, phrases)
        return
    if beyond_the_end(found, r, left):
        return
    said = other_kind(found, r, left, phrases) or _as_before(found, r, others, phrases)
    if said is not None:
        yield said
        return
    why = reason(found, r, others, told) if left or _is_a_root_below(found, r) else ()
    if not why:
        return
    kind = found.ledger.roles[found.general[r.unknown]].kind
    if _is_mirrored(found, r, others, kind):
        return
    single = _is_a_root_below(found, r) or (len(others) == 1 and others[0] * r.value < 0)
    if single and kind in (Kind.TIME, Kind.SPEED):
        if kind is Kind.SPEED and r.value > 0 and not _has_turned(found, r.unknown):
            # A speed is counted positive in its sense: that its root is positive needs no word.
            return
        yield Paragraph(line(f"the {'positive' if r.value > 0 else 'negative'}{ROOT}", *why))
    elif kind is Kind.TIME:
        yield Paragraph(_a_state_itself(found, r, others) or (why if why[0] == Text(FIRST) else line(WHICH, *why)))
        if (same := of_the_same_kind(found, r, left, phrases)) is not None:
            yield same
    else:
        parts: list[Any] = ["not "]
        for i, root in enumerate(left[:MOST_ROOTS]):
            letters = phrases.symbolic and root.expression is not None
            parts += [", " if i else ""]
            parts.append(phrases.math(root.expression) if letters else phrases.shown(r.unknown, root.value))
        yield Paragraph(line(*parts, ": ", *why))


def _is_mirrored(found: MotionTrace, r: Result, others: list[Decimal], kind: Kind) -> bool:
    """Is the only other root of a time, of a place that starts from zero, or of a distance, the same one on the other
    side, after which nobody asks?
    """
    if kind not in (Kind.TIME, Kind.COORDINATE) or len(others) != 1 or not _close(others[0], -r.value):
        return False
    if kind is Kind.TIME:
        return r.value > 0
    general = found.general[r.unknown]
    earlier = _before(found, r.unknown, found.ledger.roles[r.unknown].at or "")
    from_zero = earlier is not None and abs(found.value(earlier)) <= TINY
    return from_zero or (r.value > 0 and _is_radius(found, general))


def _is_a_root_below(found: MotionTrace, r: Result) -> bool:
    """Is it a speed whose formula is a negative root, of several letters that were found together?"""
    kind = found.ledger.roles[found.general[r.unknown]].kind if r.unknown in found.general else None
    formula = r.formula if r.formula is not None else sp.S.Zero
    root = any(f.is_Pow and f.exp == sp.Rational(1, 2) for f in sp.Mul.make_args(formula))
    return kind is Kind.SPEED and len(r.roots) < 2 and root and r.value < 0


def _as_before(found: MotionTrace, r: Result, others: list[Decimal], phrases: Phrases) -> Paragraph | None:
    """Of the roots of a speed those of another size are the state before itself, and it goes on in the same sense."""
    earlier = _before(found, r.unknown, found.ledger.roles[r.unknown].at or "")
    if found.ledger.roles[found.general[r.unknown]].kind is not Kind.SPEED or earlier is None or phrases.symbolic:
        return None
    was = found.value(earlier)
    same = [v for v in others if _close(abs(v), abs(was))]
    if len(others) != 3 or len(same) != 2 or was * r.value <= 0 or not any(_close(-v, r.value) for v in others):
        return None
    shown = phrases.shown(r.unknown, abs(was))
    words = f": that is state {_state(found, earlier)} itself; it goes on in the same sense"
    return Paragraph(line("not ±", shown, words))


def _a_state_itself(found: MotionTrace, r: Result, others: list[Decimal]) -> Line:
    """`not t_1: that is state 1 itself`, of the only other time, if it is that of an earlier state after the start."""
    at = _at(found, r.unknown)
    earlier = found.states[: found.states.index(at)] if at in found.states else ()
    times = (s for s, g in found.general.items() if g == found.general[r.unknown] and _at(found, s) in earlier)
    known = ((s, found.value.known(s)) for s in times)
    same = [s for s, v in known if v is not None and abs(v) > TINY and len(others) == 1 and _close(v, others[0])]
    if same and _begins_there(found, r, same[0]):
        return line(AS, Math(r.unknown), " ≠ ", Math(same[0]))
    return line("not ", Math(same[0]), f": that is state {_state(found, same[0])} itself") if same else ()


def _begins_there(found: MotionTrace, r: Result, time: sp.Symbol) -> bool:
    """Does the stretch that ends at a time begin at another one?"""
    legs = (leg for leg in found.route.steps if r in leg.results)
    starts = {e.since for leg in legs for e in leg.relations}
    known = [
        found.value.known(s) for s, g in found.general.items() if g == found.general[time] and _at(found, s) in starts
    ]
    return any(v is not None and _close(v, found.value(time)) for v in known)


def _has_turned(found: MotionTrace, speed: sp.Symbol) -> bool:
    """Was a speed of the other sign in the state before?"""
    earlier = _before(found, speed, found.ledger.roles[speed].at or "")
    return earlier is not None and found.value(earlier) < 0


def tells_of_others(block: Block) -> bool:
    """Does a short sentence tell which of several roots is taken, so that it stands beside it?"""
    first = block.line[0] if isinstance(block, Paragraph) else None
    return isinstance(first, Text) and (first.text.startswith((FIRST, WHICH, "not ")) or first.text == AS)


def tells_the_root(block: Block) -> bool:
    """Does a sentence tell which root is taken by its sign, so that it stands before it?"""
    first = block.line[0] if isinstance(block, Paragraph) else None
    return isinstance(first, Text) and first.text.endswith(ROOT)


def tells_a_state(block: Block) -> bool:
    """Does a sentence tell that a root of what is asked is a state before, so that it stands beside the equation?"""
    last = block.line[-1] if isinstance(block, Paragraph) else None
    return isinstance(last, Text) and last.text == ITSELF and not tells_of_others(block)


def _of_asked(found: MotionTrace, r: Result, others: list[Decimal], phrases: Phrases) -> Iterator[Block]:
    """The root of what is asked that only tells of a state before: nearest = 0.82 m is state 1 itself."""
    asked = found.named[r.unknown]
    stop = max((found.states.index(at) for s in asked.free_symbols if (at := _at(found, s)) in found.states), default=0)
    for before in found.states[:stop]:
        was = _at_state(found, asked, found.states[stop], before)
        same = [v for v in others if was is not None and (_close(v, was) or max(abs(v), abs(was)) <= TINY)]
        if same:
            shown: Any = "0" if abs(same[0]) <= TINY else phrases.shown(r.unknown, same[0])
            if shown == "0" or not phrases.symbolic:
                yield Paragraph(line(Math(r.unknown), " = ", shown, " is state ", before, ITSELF))
            return


def _at(found: MotionTrace, symbol: sp.Symbol) -> str | None:
    """The state to which a letter belongs."""
    role = found.ledger.roles.get(symbol)
    return role.at if role is not None else None


def _at_state(found: MotionTrace, expr: sp.Expr, stop: str, before: str) -> Decimal | None:
    """What a quantity of one state is in a state before it; None: it is not known there."""
    moved = {}
    for s in (s for s in expr.free_symbols if _at(found, s) == stop):
        own = (x for x, g in found.general.items() if g == found.general.get(s) and _at(found, x) == before)
        moved[s] = next(own, None)
    if None in moved.values():
        return None
    was = expr.xreplace(moved)
    return found.value(was) if all(found.value.known(s) is not None for s in was.free_symbols) else None


def reason(found: MotionTrace, r: Result, others: list[Decimal], told: Collection[sp.Symbol]) -> Line:
    """Why the other roots of a letter are left out; nothing where only their size tells them apart. `told`: letters
    that the page gives.
    """
    general = found.general[r.unknown]
    kind, stop = found.ledger.roles[general].kind, found.ledger.roles[r.unknown].at or ""
    earlier = _before(found, r.unknown, stop)
    if kind is Kind.TIME:
        return _later(found, r, others, earlier, told)
    if kind is Kind.SPEED and all(v * r.value < 0 for v in others):
        return only_on_the_way_back(found, r.unknown) or _sense(found, r, general, stop)
    if kind is Kind.COORDINATE and r.value > 0 and all(v < 0 for v in others) and _is_radius(found, general):
        return line("a distance is not negative")
    if kind is Kind.COORDINATE and earlier is not None:
        return _on_the_way(found, r, others, earlier, told)
    return ()


def _is_radius(found: MotionTrace, coordinate: sp.Symbol) -> bool:
    """Is it the first of two polar coordinates of a point, so that the other one tells its direction?"""
    names = {c.name for c in found.problem.coordinates} - {coordinate.name}
    polar = [p.place for p in found.problem.points if isinstance(p.place, Polar)]
    return any(_is_name(p.distance, {coordinate.name}) and _is_name(p.angle, names) for p in polar)


def _is_name(side: Side, names: Collection[str]) -> bool:
    return isinstance(side, expression.Name) and side.name in names


def _later(
    found: MotionTrace, r: Result, others: list[Decimal], earlier: sp.Symbol | None, told: Collection[sp.Symbol]
) -> Line:
    """Of times the first one after the state before, unless the file says more of it."""
    bound = sp.S.Zero if earlier is None or found.value.is_zero(earlier) else earlier
    since = found.value(bound)
    passed = any(since < v < r.value and not _close(v, since) for v in others)
    if r.value < 0 or passed:
        stated = stated_bound(found, r.unknown, _state(found, r.unknown), others)
        if stated or r.value < 0 or all(v < r.value for v in others):
            return stated
    after = (
        line(Math(r.unknown), " > ", Math(bound)) if bound == 0 or bound in told else _after(found, r.unknown, bound)
    )
    since_start = [v for v in others if v > TINY]
    if not since_start:
        # Of many roots such as those of a sine one is the start itself; else the time of all others is negative.
        return line(FIRST, "the start") if any(abs(v) <= TINY for v in others) else line(Math(r.unknown), " > 0")
    if all(v < r.value for v in others):
        return after
    return line(FIRST, "the start" if bound == 0 else f"state {_state(found, bound)}")


def _after(found: MotionTrace, unknown: sp.Symbol, earlier: sp.Symbol) -> Line:
    return line("state ", _state(found, unknown), " comes after state ", _state(found, earlier))


def _state(found: MotionTrace, symbol: sp.Symbol) -> str:
    return found.ledger.roles[symbol].at or ""


def _before(found: MotionTrace, unknown: sp.Symbol, stop: str) -> sp.Symbol | None:
    """The same letter in the state before, where it has a value."""
    if stop not in found.states[1:]:
        return None
    since = found.states[found.states.index(stop) - 1]
    general = found.general[unknown]
    own = (s for s, g in found.general.items() if g == general and found.ledger.roles[s].at == since)
    return next((s for s in own if found.value.known(s) is not None), None)


def _sense(found: MotionTrace, r: Result, speed: sp.Symbol, stop: str) -> Line:
    """In which sense something moves, where what its speed is tells the axis, or the direction of its path does."""
    positive = r.value > 0
    if speed.name.endswith("_dot"):
        return line(Name(speed.name.removesuffix("_dot")), " grows" if positive else " decreases")
    titles = (r.solution.trial.system.titles.get(speed, "") for r in found.regimes)
    title = next(filter(None, titles), "")
    key = "omega" if title.startswith("angular velocity") else next((k for k in SENSES if title.endswith(f" {k}")), "")
    clockwise = any(e.turn < 0 for r in found.regimes for e in r.solution.trial.system.tree.edges if e.spin == speed)
    if key in SENSES:
        positive = positive != clockwise
        return line(SENSES[key][0 if positive else 1])
    ending = [r for r in found.regimes if any(b == stop for _, b in r.stretches)]
    here = ending or [r for r in found.regimes if any(a == stop for a, _ in r.stretches)]
    system = here[0].solution.trial.system if here else None
    way = (_way(found, system, r, speed, stop) or _round(system, speed, positive)) if system is not None else ""
    sense = "in the positive sense" if positive else "in the negative sense"
    return line(f"it moves {way or sense}")


def _way(found: MotionTrace, system: System, r: Result, speed: sp.Symbol, stop: str) -> str:
    """Where a body goes that slides over the ground; "": it does not, or its path has no direction there that is known
    by now: one that rests on letters, or on a place that is found later, is not told.
    """
    edge = next((e for e in system.tree.edges if e.slide == speed and e.parent == GROUND), None)
    if edge is None or system.motion is None:
        return ""
    velocity = system.motion.velocity(system.scene.bodies[edge.body].center, edge.body)
    here = {general: own for own, general in found.general.items() if _at(found, own) == stop}
    slopes = [sp.diff(v, speed).xreplace(here) for v in (velocity.x, velocity.y)]
    held = {s for slope in slopes for s in slope.free_symbols}
    parts = [found.value.known(slope) for slope in slopes]
    if None in parts or (found.symbolic and held) or held & _found_later(found, r):
        return ""
    across, up = (0 if p is None or abs(p) < SAME else (1 if p * r.value > 0 else -1) for p in parts)
    return " ".join(
        filter(None, ({1: "upward", -1: "downward"}.get(up), {1: "to the right", -1: "to the left"}.get(across)))
    )


def _round(system: System, speed: sp.Symbol, positive: bool) -> str:
    """How something goes that slides along a circle: with the centre on the left of the tangent counterclockwise."""
    edge = next((e for e in system.tree.edges if e.slide == speed), None)
    path = edge.joining.path if edge is not None and edge.joining is not None else None
    bend = 0 if path is None else system.scene.sign(path.curvature)
    return ("counterclockwise" if (bend > 0) == positive else "clockwise") if bend else ""


def _found_later(found: MotionTrace, r: Result) -> set[sp.Symbol]:
    """The letters that the route gives after the step of a result."""
    steps = found.route.steps
    own = next((i for i, leg in enumerate(steps) if r in leg.results), len(steps))
    return {x for leg in steps[own + 1 :] for x in leg.unknowns}


def _on_the_way(
    found: MotionTrace, r: Result, others: list[Decimal], earlier: sp.Symbol, told: Collection[sp.Symbol]
) -> Line:
    """A place is on the side to which the motion goes from the state before, and the first that it reaches there."""
    start = found.value(earlier)
    if _close(start, r.value):
        return ()
    grows = r.value > start
    state = line(Math(r.unknown), " = ", Math(earlier), " is state ", _state(found, earlier), " itself")
    if earlier in told and all(_close(v, start) for v in others):
        return state
    beyond = [v for v in others if not _close(v, start) and (v > start) is grows]
    if any(abs(v - start) < abs(r.value - start) for v in beyond):
        return ()
    first = line(Math(r.unknown), " is reached first")
    if len(beyond) == len(others):
        return first
    if earlier in told:
        ahead = line(Math(r.unknown), " > " if grows else " < ", Math(earlier))
    elif all(_close(v, start) for v in others):
        return line("that is the place in state ", _state(found, earlier))
    else:
        ahead = line(Math(found.general[r.unknown]), " grows" if grows else " decreases", " from state ")
        ahead = line(ahead, _state(found, earlier), " to state ", _state(found, r.unknown))
    return line(ahead, ", and ", first) if beyond else ahead


def _close(a: Decimal, b: Decimal) -> bool:
    return abs(a - b) <= (abs(a) + abs(b)) * Decimal("1e-9")
