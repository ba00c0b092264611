"""Unknown constants, angles, speeds and extremes: the choices of modes in natural order, until a branch of one holds.

`X is largest`: the freedom that is left is used up by assumptions at their limit (|F| = mu N, N = 0, …), one for each
freedom, or X is stationary; of all points that satisfy every other assumption the largest X counts.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import replace
from decimal import Decimal
from functools import partial

import sympy as sp

from planar_cli.equation.algebra.form import Nonlinear
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import Diagnostic, NoSolution, Undecided, undecided_at
from planar_cli.solve.diagnosis.clash import clash
from planar_cli.solve.diagnosis.not_found import FIXED, contradiction, not_found, open_symbols, untold
from planar_cli.solve.instant.beyond import not_bounded
from planar_cli.solve.instant.impending import drawn_against_the_slip
from planar_cli.solve.instant.instant import Instant, Trial
from planar_cli.solve.instant.seeker import Seeker, Sought, seekers
from planar_cli.solve.instant.stationary import stationary_branches
from planar_cli.solve.instant.told_places import open_places, telling
from planar_cli.units import PURE

MOST_CHOICES = 40
MOST_LIMITS = 2
MOST_DRAWS = 4
"""So many numbers of the letters are tried where an extreme is sought that need not be there for all of them."""
MANY_TRIES = 400
"""So many draws are looked at for numbers with which what is assumed holds."""
CLOSE = Decimal("1e-25")


def seek(instant: Instant, targets_of: Callable[[System], set[sp.Symbol]]) -> tuple[Sought, list[Sought]]:
    """The branch that holds, over all choices of modes in natural order, and those that do not. Of letters: with
    numbers for which the assumptions hold, and no contact parts where a mass or inertia is to cancel, if there are any.
    `targets_of(system)`: the symbols that the finds need.
    """
    scene = instant.scene
    tried = [scene.valuations[0]]
    parted: Valuation | None = None
    failed: NoSolution | None = None
    while True:
        rejected: list[Sought] = []
        try:
            found = _seek(instant, targets_of, rejected)
        except NoSolution as error:
            failed = failed or error
            if not instant.statements.extremes and not any(s.trial.tests for s in rejected):
                break
        else:
            if not (scene.ledger.symbolic and scene.cancelling and _parts(found.trial)):
                return drawn_against_the_slip(instant, found, rejected, targets_of), rejected
            parted = parted or tried[-1]
        if not scene.ledger.symbolic or len(tried) == MOST_DRAWS or not _drawn_anew(instant, tried, rejected):
            break
        tried.append(scene.valuations[0])
    if parted is not None and scene.redraw(lambda v: v.values == parted.values, MANY_TRIES):
        rejected = []
        found = _seek(instant, targets_of, rejected)
        return drawn_against_the_slip(instant, found, rejected, targets_of), rejected
    assert failed is not None
    raise failed


def _drawn_anew(instant: Instant, tried: list[Valuation], rejected: list[Sought]) -> bool:
    """Take numbers for which the most natural modes hold that did not hold with the last ones; for an extreme any."""
    new = partial(_is_new, tried)
    if instant.statements.extremes:
        return instant.scene.redraw(new)
    doubtful = next((s for s in rejected if s.trial.tests and not s.branch.choices), None)
    return doubtful is not None and instant.scene.redraw(lambda v: new(v) and _would_hold(doubtful, v), MANY_TRIES)


def _would_hold(sought: Sought, value: Valuation) -> bool:
    """Would the tests of its modes hold with these numbers?"""
    lines = [line for block in sought.branch.blocks for line in block.lines]
    formulas = {line.symbol: line.formula for line in lines}
    numbers: dict[sp.Symbol, Decimal] = {}
    while formulas:
        # What is carried as a letter is told by a line that comes later.
        ready = [x for x, e in formulas.items() if not e.free_symbols & formulas.keys()]
        if not ready:
            return False
        numbers |= {x: value.extended(numbers)(formulas.pop(x)) for x in ready}
    pushes = {name: numbers.get(s) for name, s in sought.trial.system.symbols.items()}
    told = value.extended(numbers)
    for test in (t for mode in sought.trial.system.modes.values() for t in mode.tests):
        parts = [(factor, pushes.get(name)) for name, factor in test.pushes]
        if not parts or any(x is None for _, x in parts):
            return False
        if sum((told(f) * x for f, x in parts if x is not None), told(test.constant)) <= 0:
            return False
    return True


def _is_new(tried: list[Valuation], value: Valuation) -> bool:
    """Are these numbers others than those that were tried?"""
    return all(value.values != old.values for old in tried)


def _parts(trial: Trial) -> bool:
    """Does something part in a choice of modes?"""
    return any(mode.parted for mode in trial.system.modes.values())


def _seek(instant: Instant, targets_of: Callable[[System], set[sp.Symbol]], rejected: list[Sought]) -> Sought:
    """The same with the numbers that are drawn now; `rejected` gets what does not hold."""
    undecided: Undecided | None = None
    plain = False
    """Has it no place of its own?"""
    best: Sought | None = None
    extremes = instant.statements.extremes
    for choice in _told(instant):
        held: list[Sought] = []
        for seeker in seekers(instant, choice):
            try:
                found = None if seeker.conflict else _best(seeker, targets_of(seeker.system), rejected)
            except Undecided as error:
                undecided, plain = (
                    error,
                    type(error) is Undecided and not str(error).startswith(instant.scene.problem.file),
                )
                continue
            held += [] if found is None else [found, *found.others]
        if held and not extremes:
            return _preferred(held)
        for found in held:
            if best is None or _better(found, best, extremes[0].sense):
                best = found
    if best is not None:
        return best
    if undecided is not None:
        finds = instant.scene.problem.find
        raise undecided_at(finds[0].mark, f"not decided, {undecided}") if finds and plain else undecided
    raise NoSolution([_nothing(instant, targets_of, [s.objection for s in rejected])])


def _told(instant: Instant) -> list[tuple[int, ...]]:
    """The choices in natural order in which something tells the places that are sought. NoSolution: there is none."""
    choices = list(itertools.islice(instant.choices(), MOST_CHOICES))
    told = telling(instant, choices)
    if told == []:
        raise NoSolution([untold(instant, open_places(instant))])
    return choices if told is None else told


def _better(one: Sought, other: Sought, sense: int) -> bool:
    """Is the objective of one choice of modes beyond that of another? Equal ones leave the more natural choice."""
    a, b = one.objective or Decimal(0), other.objective or Decimal(0)
    return sense * (a - b) > CLOSE * max(abs(a), abs(b))


def _is_opposite(one: Sought, other: Sought) -> bool:
    """Is the objective of one choice positive, and that of the other the same with a minus?"""
    a, b = one.objective or Decimal(0), other.objective or Decimal(0)
    return a > 0 and abs(a + b) <= CLOSE * a


def _nothing(instant: Instant, targets_of: Callable[[System], set[sp.Symbol]], objections: list[str]) -> Diagnostic:
    """Why nothing was found, by the first choice of modes whose velocities fit."""
    seekers = (Seeker(instant, c) for c in itertools.islice(instant.choices(), MOST_CHOICES))
    seeker = next((s for s in seekers if not s.conflict), None) or Seeker(instant, next(instant.choices()))
    if seeker.conflict and (contradicted := _contradicted(instant)) is not None:
        return contradicted
    targets = targets_of(seeker.system)
    clashing = None if seeker.conflict or objections else contradiction(seeker)
    if clashing is not None:
        return clashing
    loose: list[sp.Symbol] = []
    if not seeker.conflict and not objections:
        places = [s for s in seeker.ledger.coordinates if s in seeker.ledger.sought]
        targets = targets.union(places)
        offer = seeker.candidates((), targets)
        found, bits = offer.candidates, {x: 1 << j for j, x in enumerate(offer.columns.unknowns)}
        nonlinear = sum(bit for x, bit in bits.items() if x not in seeker.linear)
        loose = open_symbols(found, nonlinear, {x: bit for x, bit in bits.items() if x in targets})
    return not_found(instant, Trial((), seeker.system, (), (), ""), objections, loose)


def _contradicted(instant: Instant) -> Diagnostic | None:
    """What contradicts the velocities that are stated, whatever is sought; None: in some modes nothing does."""
    choices = itertools.islice(instant.choices(), MOST_CHOICES)
    trials = [instant.try_choice(c, instant.scene.valuations) for c in choices]
    if any(t.objection != "velocities" for t in trials):
        return None
    return clash(instant, trials[0], instant.scene.problem.find[0].mark)


def _best(seeker: Seeker, targets: set[sp.Symbol], rejected: list[Sought]) -> Sought | None:
    """As `_best_of`; of a constant by whose square something acts the number is sought too, as nothing can be tested
    without it.
    """
    try:
        return _best_of(seeker, targets, rejected)
    except Nonlinear:
        sought = {s for s in seeker.ledger.sought if s in seeker.unknowns}
        if sought <= targets:
            raise
        return _best_of(seeker, targets | sought, rejected)


def _best_of(seeker: Seeker, targets: set[sp.Symbol], rejected: list[Sought]) -> Sought | None:
    """The branch of one choice of modes that holds (and is extreme, where that is asked)."""
    extremes = seeker.instant.statements.extremes
    held: list[Sought] = []
    targets = targets | seeker.compared()
    if not extremes:
        for sought in seeker.branches(targets, ()):
            (rejected if sought.objection else held).append(sought)
        return _preferred(held) if held else None
    quantities = seeker.system.quantities()
    side = quantities.evaluator.value(extremes[0].side)
    targets = targets | {s for s in side.free_symbols if s in seeker.unknowns}
    limits, beyond = seeker.told_limits(targets), list[Sought]()
    for count in range(1, MOST_LIMITS + 1):
        for chosen in itertools.combinations(limits, count):
            for sought in seeker.branches(targets, chosen):
                sought.objective = (
                    sought.trial.outcomes[0].value.extended(sought.branch.algebra.value.values)(side)
                    if sought.trial.outcomes
                    else None
                )
                if not sought.objection and (unbounded := not_bounded(seeker, sought, side, extremes[0])):
                    sought.objection = unbounded
                    beyond.append(sought)
                (rejected if sought.objection or sought.objective is None else held).append(sought)
        if held:
            break
    if seeker.departures():
        # Of the same motion in opposite ways the positive one counts, and may go on where the other ends.
        held = [s for s in held if not any(_is_opposite(b, s) for b in beyond)]
    if len(limits) == len(seeker.limit_conditions()):
        held += stationary_branches(seeker, targets, side, rejected)
    if not held:
        return None
    best = max(held, key=lambda s: extremes[0].sense * (s.objective or Decimal(0)))
    best = _preferred([s for s in held if s is best or not _better(best, s, extremes[0].sense)])
    if fixed := _fixed(seeker, side, targets, best):
        best.objection = fixed
        rejected.append(best)
        return None
    return replace(best, others=[s for s in held if s is not best])


def _fixed(seeker: Seeker, side: sp.Expr, targets: set[sp.Symbol], best: Sought) -> str:
    """The objection that the other relations fix already what is largest or smallest, and no limit has a part in it."""
    free = [s for s in seeker.branches(targets, ()) if not s.objection and s.trial.outcomes]
    values = [s.trial.outcomes[0].value.extended(s.branch.algebra.value.values)(side) for s in free]
    found = best.objective or Decimal(0)
    if len(values) != 1 or abs(values[0] - found) > CLOSE * max(abs(found), Decimal(1)):
        return ""
    wanted = seeker.instant.statements.extremes[0].text.split(" is ")[0]
    return f"{FIXED} {wanted} already" + ("" if seeker.ledger.symbolic else f", at {values[0]:.4g}")


def _preferred(held: list[Sought]) -> Sought:
    """Of several branches the one with positive (for angles: the smallest) values, of the sought constants first; the
    others are kept beside it.
    """

    def rank(s: Sought) -> tuple[int, int, Decimal]:
        ledger, solved = s.trial.system.scene.ledger, s.branch.algebra.value.values
        sizes = [c for c in ledger.sought if not (ledger.units[c].angle and ledger.units[c].dimension == PURE)]
        negative = sum(solved[c] < 0 for c in sizes if c in solved)
        values = [c.roots[c.taken].value for c in s.branch.choices]
        return negative, sum(v < 0 for v in values), sum((abs(v) for v in values), Decimal(0))

    ordered = sorted(held, key=rank)
    return replace(ordered[0], others=ordered[1:])
