"""What is wrong with a motion that can not be told: a datum is missing, data contradict, a state never comes.

A datum is missing where the equations of the motion leave a letter of the first state, or a sought constant, loose;
that is seen from their rank at a general place. Data contradict each other where the motion exists without one of them.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import derivative
from planar_cli.equation.values.exact import Unvalued, Valuation
from planar_cli.equation.values.sample import anywhere
from planar_cli.equation.values.scales import slack_of
from planar_cli.errors import NOWHERE, Diagnostic, Mark, NoSolution, NoValue, Undecided
from planar_cli.problem.language.expression import Relation
from planar_cli.problem.scene.scene import Problem
from planar_cli.solve.between.branches.reached import asked_about
from planar_cli.solve.between.equations.asked_finds import AskedFind, asked_letters
from planar_cli.solve.between.equations.balances import StateBalance
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.roots.followed import Followed
from planar_cli.solve.diagnosis.failures import explain_failure, singular_position
from planar_cli.solve.diagnosis.false_inequalities import false_inequality, without_inequalities
from planar_cli.solve.diagnosis.held_in_blows import what_to_write
from planar_cli.solve.diagnosis.limits_of_modes import sought_at_start
from planar_cli.solve.diagnosis.missed import apart_by, how_near
from planar_cli.solve.diagnosis.placed import driven_with
from planar_cli.solve.diagnosis.turns_off import turns_off
from planar_cli.solve.diagnosis.undated import mode_at_a_time
from planar_cli.solve.diagnosis.words import listed
from planar_cli.solve.following.passage_times import is_steady
from planar_cli.solve.instant.instant import make_instant
from planar_cli.solve.instant.modes_search import search_modes
from planar_cli.solve.multibody.linear import solve
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.mode_sequence import Span, Workshop, fixed_time
from planar_cli.solve.regimes.regime_sequence import RegimeSequence
from planar_cli.solve.regimes.timeline import Demand, Stop

AGREES = Decimal("1e-7")


# --- a datum is missing ----------------------------------------------------------------------------------------------


def loose_letters(course: MotionEquations) -> list[sp.Symbol]:
    """Letters of states and sought constants that the equations do not fix."""
    unknowns = sorted(course.chain().unknowns, key=lambda s: s.name)
    ordinary = course.natural(unknowns)
    value = course.base().extended({x: anywhere(i) * ordinary[x] for i, x in enumerate(unknowns)})
    rows = []
    places = [s.name for s in course.states]
    # Where laws of motion tell everything, balances say nothing new.
    laws = [
        e
        for e in course.equations
        if not isinstance(e.source, StateBalance) or course.laws[places.index(e.stop) - 1].loose
    ]
    for e in _independent(laws):
        slopes = [value.known(derivative(e.residual, x)) if e.residual.has(x) else Decimal(0) for x in unknowns]
        row = [slope for slope in slopes if slope is not None]
        if len(row) == len(unknowns):
            rows.append([*row, Decimal(0)])
    if not rows:
        return unknowns
    solved = solve(rows, len(unknowns))
    return [x for j, x in enumerate(unknowns) if not solved.unique(j)]


def _independent(equations: Iterable[Equation]) -> list[Equation]:
    """As many of every family as say something new."""
    count: dict[tuple[str, ...], int] = {}
    found = []
    for e in sorted(equations, key=lambda e: e.cost):
        if e.residual.has(sp.Integral):
            continue
        if e.family:
            count[e.family] = count.get(e.family, 0) + 1
            if count[e.family] > e.rank:
                continue
        found.append(e)
    return found


def missing(course: MotionEquations) -> NoSolution | None:
    """What the file should say; None: the equations leave nothing loose."""
    loose = set(loose_letters(course))
    sought = [s for s in course.sought() if s in loose]
    first = course.first
    open_first = [s for s in first.letters.values() if s in loose]
    unsaid = [
        s
        for s in course.states[1:]
        if not fixed_time(s.relations)
        and not any(blow.stop.name == s.name for blow in course.blows.values())
        and all(isinstance(r, Relation) and r.operator != "=" for r in s.relations)
        and s.name not in course.modes.turnings
    ]
    if unsaid and not sought and not open_first:
        hint = "give a relation with `=` that holds first in this state, or `t = …`"
        return _wrong(unsaid[0].mark, "PL623", f"nothing says when state {unsaid[0].name} is", hint)
    if not sought and not open_first:
        return _open_impact(course, loose)
    names = [s.name for s in sought] or list(dict.fromkeys(title_of(course, first, s) for s in open_first))
    mark = first.mark if not sought else _mark_of(course, sought[0])
    text = f"{listed(names)} {'is' if len(names) == 1 else 'are'} open: no state tells enough"
    if (limit := sought_at_start(course.states[0], names)) is not None:
        return limit
    hint = mode_at_a_time(course) or driven_with(course.problem, sought)
    if not sought and all(name.startswith("the rate of") for name in names):
        hint = hint or f"say in state {first.name} how it moves: `at rest`, or velocities"
    places = [general.name for general, own in first.letters.items() if own in open_first]
    if not sought and set(places) <= {c.name for c in course.problem.coordinates}:
        # A coordinate has no place as drawn.
        begun = listed([f"`{name} = …`" for name in places])
        hint = hint or f"points are written with {listed(places)}; say in state {first.name} where it begins: {begun}"
    hint = hint or "give one more relation in a state, as a place, a velocity or a time"
    return _wrong(mark, "PL623", text, hint)


def _open_impact(course: StatedMotion, loose: Collection[sp.Symbol]) -> NoSolution | None:
    """A coefficient of restitution that was left out and that nothing tells."""
    for blow in course.blows.values():
        open_names = {f"e_{j.name}": j for j in blow.struck.joints}
        for name, symbol in blow.scene.open_names.items():
            if symbol in loose:
                joint = open_names[name]
                text = f"the restitution of {joint.name} is open: state {blow.stop.name} does not tell enough"
                return _wrong(
                    joint.mark, "PL623", text, "write `restitution: 0.8`, or a velocity just after the impact"
                )
    return None


def demand_told(course: MotionEquations, finds: tuple[AskedFind, ...], told: Collection[sp.Symbol]) -> None:
    """NoSolution: letters that are asked for are not told, because a datum is missing. Undecided: nothing is missing,
    but no formula leads to them.
    """
    untold = asked_letters(finds) & course.chain().unknowns - set(told)
    if untold:
        mark = course.problem.find[0].mark
        titles = {s: title_of(course, p, s) for p in course.stops.values() for s in p.letters.values() if s in untold}
        names = listed(titles.get(s, s.name) for s in sorted(untold, key=str))
        raise missing(course) or Undecided(
            f"{mark.file}:{mark.line}: not decided, no formula leads from what is known to {names}; it may help to "
            "give numbers for letters, or to ask for less of the motion"
        )


def _mark_of(course: RegimeSequence, sought: sp.Symbol) -> Mark:
    return next((u.mark for u in course.problem.unknowns if u.name == sought.name), course.first.mark)


def title_of(course: RegimeSequence, stop: Stop, own: sp.Symbol) -> str:
    """A letter of a state in words."""
    general = next(k for k, v in stop.letters.items() if v == own)
    where = f" in state {stop.name}" if stop.name else ""
    for regime in course.distinct_regimes():
        if general == regime.time:
            return f"the time of state {stop.name}" if stop.name else "the time"
        for c in regime.coordinates:
            if general in (c.symbol, c.speed):
                return f"{'the rate of ' if general == c.speed else ''}{c.words or c.symbol.name}{where}"
    return f"{general.name}{where}"


def as_drawn(span: Span, workshop: Workshop, problem: Problem) -> NoSolution | None:
    """What is wrong with the velocities of the drawn position; None: nothing."""
    instant = make_instant(span.problem, span.always, (), dict(workshop.earlier), False)
    held, rejected = search_modes(instant, instant.scene.valuations)
    if held:
        return None
    singular_position(instant, rejected, problem.find)
    return explain_failure(instant, rejected, problem.find)


# --- data contradict each other --------------------------------------------------------------------------------------


def demand_agreement(
    course: StatedMotion, value: Valuation, guessed: Collection[sp.Symbol] = (), missed: str | None = None
) -> None:
    """NoSolution: a state that was found by some of its relations does not satisfy the others. `guessed`: letters with
    machine numbers, measured by the largest value that they have in any state. `missed`: a state that is not reached.
    """
    large = value.extended(_largest(course, value, guessed))
    for state in (s for s in course.states if s.name != missed):
        for d in course.demands[state.name]:
            if d.kind not in ("equation", "inequality"):
                continue
            number = value.known(d.residual)
            if number is None or large.known(d.residual) is None:
                continue
            slack = AGREES * max(value.size(d.residual), large.size(d.residual))
            if abs(number) > slack:
                letters = [*course.stops[state.name].letters.values()]
                slack += AGREES * AGREES * slack_of(d.residual, letters, course.natural(letters), value)
            if number < -slack if d.kind == "inequality" else abs(number) > slack:
                raise _contradiction(course, d, number)


def _largest(course: RegimeSequence, value: Valuation, letters: Collection[sp.Symbol]) -> dict[sp.Symbol, Decimal]:
    """The largest value that letters of states have in any of the states."""
    sizes: dict[sp.Symbol, Decimal] = {}
    for stop in course.stops.values():
        for general, own in stop.letters.items():
            if own in value.values:
                sizes[general] = max(sizes.get(general, Decimal(0)), abs(value(own)))
    general_of = {own: general for stop in course.stops.values() for general, own in stop.letters.items()}
    return {own: sizes[general_of[own]] for own in letters if own in general_of and general_of[own] in sizes}


def _contradiction(course: StatedMotion, demand: Demand, number: Decimal) -> NoSolution:
    others = [d.text for d in course.demands[demand.state] if d.text != demand.text and d.kind == "equation"]
    others = others or ["what is stated of the states before it"]
    apart = apart_by(course, demand, number)
    text = f"state {demand.state}: `{demand.text}` contradicts {_quoted(others)}{apart and f': {apart}'}"
    return _wrong(demand.mark, "PL624", text, what_to_write(course.problem, demand.state))


def _quoted(texts: list[str]) -> str:
    return ", ".join(t if t.startswith("what ") else f"`{t}`" for t in texts)


def clash(course: MotionEquations, equations: Iterable[Equation]) -> NoSolution | None:
    """Statements of which any one may go, and then there is a motion; None: no single one stands in the way. Equations
    that hold an integral tell the time of a way; each trial of a root of theirs would be a quadrature.
    """
    equations = [e for e in equations if not e.residual.has(sp.Integral)]
    if (wrong := false_inequality(course, equations)) is not None:
        return wrong
    stated = [
        e for e in equations if e.kind == "given" and e.mark != NOWHERE and e.residual.free_symbols != {course.first.t}
    ]
    found, bare = [], without_inequalities(course)
    for e in stated:
        try:
            free = any(bare.chain().branches([x for x in equations if x is not e]))
        except (Undecided, NoValue, Unvalued):
            continue
        if free:
            found.append(e)
    if not found:
        return None
    texts = list(dict.fromkeys(e.words for e in found))
    last = found[-1]
    if len(texts) == 1 and _tells_the_drawing(last, equations):
        text = f"state {last.stop}: `{texts[0]}` does not hold in the drawn position"
        hint = "draw the points at the first state, or write one with a coordinate"
        if turns := turns_off(course, last, equations):
            hint = (
                f"it is {abs(turns)} whole turn{'s' * (abs(turns) > 1)} off: an angle begins as the points are written"
            )
        return _wrong(last.mark, "PL609", text, hint)
    if len(texts) == 1 and (later := [e for e in stated if _comes_after(course.problem, e, last)]):
        return _not_from_there(course, last, later)
    rest = _quoted(texts[:-1]) if len(texts) > 1 else "what else is known"
    text = f"state {last.stop}: `{texts[-1]}` contradicts {rest}"
    return _wrong(last.mark, "PL624", text, what_to_write(course.problem, last.stop))


def _comes_after(problem: Problem, one: Equation, other: Equation) -> bool:
    """Does it speak of a later state?"""
    names = [s.name for s in problem.states]
    return {one.stop, other.stop} <= set(names) and names.index(one.stop) > names.index(other.stop)


def _not_from_there(course: MotionEquations, start: Equation, later: Sequence[Equation]) -> NoSolution:
    """Only without what an earlier state says is there a motion: what is not reached from there is at fault."""
    last, names = later[-1], list(dict.fromkeys(e.stop for e in later))
    here = [f"`{text}`" for text in dict.fromkeys(e.words for e in later if e.stop == last.stop)]
    told, verb = " and ".join(here), "contradict" if len(here) > 1 else "contradicts"
    if len(names) > 1:
        told, verb = f"what is said of {' and '.join(names)}", "contradicts"
    sought = " and ".join(s.name for s in course.problem.unknowns)
    text = f"state {last.stop}: {told} {verb} `{start.words}` in state {start.stop}"
    text += f": it is not reached from there, whatever the value of {sought}" if sought else ""
    return _wrong(last.mark, "PL624", text, what_to_write(course.problem, last.stop))


def _tells_the_drawing(stated: Equation, equations: Iterable[Equation]) -> bool:
    """Does a statement speak of nothing but places that are drawn?"""
    drawn = [e.residual.free_symbols for e in equations if e.kind == "drawn"]
    told = set().union(*drawn) if drawn else set()
    return bool(told) and stated.residual.free_symbols <= told


# --- a state that never comes ----------------------------------------------------------------------------------------


def never(course: MotionEquations, followed: Followed, value: Valuation) -> NoSolution:
    """Why the state that was missed does not come. NoSolution: a state before it is not as it is stated. Undecided: the
    motion was not followed to its end, so that the state may come later.
    """
    name = followed.missed
    assert name is not None
    stop, demands = course.stops[name], course.demands[name]
    stated = next(s.relations for s in course.problem.states if s.name == name)
    texts = "; ".join(dict.fromkeys(r.text for r in stated))
    bare = all(d.kind == "inequality" for d in demands)
    if bare and (lacking := missing(course)) is not None:
        return lacking
    if not course.sought():
        passed = {s: Decimal(repr(v)) for s, v in followed.values.items() if s not in value.values}
        demand_agreement(course, value.extended(passed), passed, name)
    outcome = followed.run.trajectory.outcome if followed.run is not None else None
    # Powers of the time were followed far enough for the highest of them to be all that counts.
    steady = followed.onward is not None and is_steady(followed.onward)
    if outcome is not None and outcome.kind == "long" and not steady:
        raise Undecided(
            f"state {name} (`{texts}`) is not found: {outcome.words}, and the motion goes on; "
            "`planar simulate --until` follows it further"
        )
    hint = "" if name in asked_about(course.problem) else how_near(course, followed, stop, value)
    if any(d.kind == "extreme" for d in demands):
        hint = "on the way from the state before it nothing is stationary: it grows or shrinks without end"
    return _wrong(stop.mark, "PL621", f"state {name} is never reached: {texts}", hint)


def strikes_before(course: RegimeSequence, stretch: int, time: float, words: str) -> NoSolution:
    """Something strikes before the next state, and the file does not speak of it."""
    state = course.states[stretch + 1]
    text = f"before state {state.name}, at t = {time:.4g} s, something meets again, with a blow: {words}"
    hint = (
        "a state `just after` it and an `impact` tell what comes of it; `during` of an `impact` names the blow in "
        "which alone it acts; else ask for nothing later"
    )
    return _wrong(state.mark, "PL706", text, hint)


def _wrong(mark: Mark, code: str, text: str, hint: str = "") -> NoSolution:
    return NoSolution([Diagnostic(mark, code, text, hint)])
