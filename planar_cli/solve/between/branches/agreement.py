"""Checks of a motion by other roads: the numbers that follow it step by step, and the balance of energy.

    dT/dt = P      T the kinetic energy of all bodies, P the power of all loads and of friction; ideal joints do no work

(An Introduction to Planar Dynamics, 3.3, 4.4.) For one free speed u, T(q, u): (∂T/∂u) du/dt = P - (∂T/∂q) dq/dt.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import derivative
from planar_cli.equation.values.exact import PI, Valuation
from planar_cli.errors import NoSolution, NoValue, undecided_at
from planar_cli.motion.scene.masses import ANY_MASS
from planar_cli.solve.between.branches.integrated import apart, digits
from planar_cli.solve.between.branches.solved_motion import SolvedMotion
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.roots.events import LOOKS
from planar_cli.solve.between.roots.followed import Followed
from planar_cli.solve.diagnosis.any_mass import not_cancelled
from planar_cli.solve.diagnosis.driven_jumps import driven_jump
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.solve.regimes.equations import DATA
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.solution import BY_ENERGY

NEEDED = 6
FULL = 50
APART = 1e-6
"""Letters of a motion that was followed, and of its equations, may differ by this part of their size."""


def compared(found: SolvedMotion) -> tuple[str, ...]:
    """What agrees, in phrases. Disagreement: two roads to the same motion differ."""
    if found.followed is not None and found.followed.values and _apart(found, found.followed) > APART:
        raise Disagreement("the motion followed step by step differs from its equations")
    return balanced(found.course.distinct_regimes())


def demand_fulfilled(course: MotionEquations, value: Valuation, guessed: Collection[sp.Symbol]) -> None:
    """Disagreement: what following the motion alone has given does not fulfil an equation that it stands in. What is
    said of the start of a later regime speaks of no moment of the motion. Undecided: it does but for turns.
    """
    for e in course.equations:
        if e.kind == "start" or not e.residual.free_symbols.intersection(guessed) or e.residual.has(sp.Integral):
            continue
        off = value.known(e.residual)
        if off is None or abs(off) <= Decimal(repr(APART)) * value.size(e.residual):
            continue
        if abs(_without_turns(off, e.residual, value)) <= Decimal(repr(APART)) * value.size(e.residual):
            text = f"an angle in the equation of {e.words} goes on over turns that its formula does not count"
            raise undecided_at(course.states[0].mark, text)
        # Terms that all vanish there, as of a velocity across a radius, are measured by what their letters may be off;
        # a number beside them does not vanish.
        known = sp.Add(*(t for t in sp.Add.make_args(e.residual) if not t.free_symbols.intersection(guessed)))
        if value.known(known) or abs(off) > Decimal(repr(APART)) * _play(course, value, e.residual, guessed):
            _demand_cancelled(course, value, e.residual)
            if (jump := driven_jump(course, value)) is not None:
                raise NoSolution([jump])
            mark = course.states[0].mark
            text = f"the motion that was followed contradicts an equation: {e.words}"
            raise Disagreement(f"{mark.file}:{mark.line}: {text}")


def _demand_cancelled(course: MotionEquations, value: Valuation, residual: sp.Expr) -> None:
    """NoSolution: with the numbers that were followed for masses that are not given the equation holds, and with others
    it does not.
    """
    hidden = [s for s in course.scene.cancelling if s in residual.free_symbols]
    there = value.extended(_followed_masses(course, value)) if hidden else value
    off = there.known(residual) if hidden else None
    if off is not None and abs(off) <= Decimal(repr(APART)) * there.size(residual):
        raise NoSolution([not_cancelled(course.scene, "the motion", None, hidden)])


def _followed_masses(course: MotionEquations, value: Valuation) -> dict[sp.Symbol, Decimal]:
    """What was put in for masses and moments of inertia that the file does not give."""
    hidden, one = course.scene.cancelling, Decimal(repr(ANY_MASS))
    found: dict[sp.Symbol, Decimal] = {}
    for body in course.problem.bodies:
        model = course.scene.bodies[body.name]
        mass = one if model.mass in hidden else value.known(model.mass)
        if model.mass in hidden:
            found[model.mass] = one
        if model.inertia in hidden and mass is not None:
            found[model.inertia] = one if body.any_inertia else one * mass
    return found


def _without_turns(off: Decimal, residual: sp.Expr, value: Valuation) -> Decimal:
    """What is left of a residual when angles that go on over many turns, of which a formula tells the last one, are
    counted so that it is least.
    """
    for angle in sorted(residual.atoms(sp.atan2), key=str):
        letter = sp.Dummy()
        slope = value.known(derivative(residual.xreplace({angle: letter}), letter))
        if slope:
            turn = abs(slope) * 2 * PI
            off -= (off / turn).to_integral_value() * turn
    return off


def _play(course: MotionEquations, value: Valuation, residual: sp.Expr, guessed: Collection[sp.Symbol]) -> Decimal:
    """How far a residual is off if each letter that was guessed is off by its size: the largest of its dimension in
    any state.
    """
    units = course.ledger.units
    sizes: dict[str, Decimal] = {}
    for stop in course.stops.values():
        for s in stop.letters.values():
            number = value.known(s)
            if s in units and number is not None:
                kind = str(units[s].dimension)
                sizes[kind] = max(sizes.get(kind, Decimal(0)), abs(number))
    inside = [s for s in guessed if s in residual.free_symbols and s in units]
    slopes = [(value.known(derivative(residual, s)), sizes.get(str(units[s].dimension))) for s in inside]
    return sum((abs(slope) * size for slope, size in slopes if slope is not None and size is not None), Decimal(0))


def integrated(found: SolvedMotion, needed: Collection[sp.Symbol]) -> SolvedMotion:
    """The same, with the equations of motion integrated beside what following the motion alone has given. Disagreement:
    they lead elsewhere. `needed`: symbols of states on which answers rest.
    """
    guessed = found.guessed.intersection(needed)
    if not guessed or found.followed is None:
        return found
    off = apart(found.followed.segments, found.followed.sizes, _resting_on(found.course, guessed))
    if off is None:
        return found
    if off > APART:
        if masses := _followed_masses(found.course, found.value):
            there = [replace(s, value=s.value.extended(masses)) for s in found.followed.segments]
            again = apart(there, found.followed.sizes, _resting_on(found.course, guessed))
            if again is not None and again <= APART:
                raise NoSolution([not_cancelled(found.course.scene, "the motion", None, list(masses))])
        raise Disagreement("the equations of motion, integrated, lead elsewhere than the motion that was followed")
    words = f"the integrated equations of motion agree with the motion followed to {digits(off)} digits"
    return replace(found, integrated=True, checks=(*found.checks, words))


def _resting_on(course: MotionEquations, guessed: Collection[sp.Symbol]) -> dict[str, set[sp.Symbol]]:
    """By the state, letters of the general position that tell these, and when it is; by "" those that tell these."""
    general = {own: s for stop in course.stops.values() for s, own in stop.letters.items()}
    wanted = {general[s] for s in guessed if s in general}
    stated = {name: {s for d in demands for s in d.residual.free_symbols} for name, demands in course.demands.items()}
    found = {name: wanted | {general[s] for s in letters if s in general} for name, letters in stated.items()}
    return {"": wanted, **found}


def balanced(regimes: Iterable[Regime]) -> tuple[str, ...]:
    """That the balance of energy gives the same equations of motion. Disagreement: it does not."""
    powers = [d for r in regimes if (d := power_digits(r)) is not None]
    if not powers:
        return ()
    if min(powers) < NEEDED:
        raise Disagreement("the balance of energy gives another equation of motion")
    return (f"{BY_ENERGY}, to {min(powers)} digits",)


def _apart(found: SolvedMotion, followed: Followed) -> float:
    """By how much letters of states differ at most, in parts of the largest of the same dimension on the way, or of an
    ordinary one.
    """
    worst = 0.0
    stated = _stated_letters(found)
    sizes: dict[str, float] = {}
    units = found.course.ledger.units
    kinds = {own: str(units[own].dimension) for stop in found.course.stops.values() for own in stop.letters.values()}
    natural = {s: float(size) for s, size in found.course.natural(kinds).items()}
    for s, v in _passed(followed):
        if s in units:
            kind = str(units[s].dimension)
            sizes[kind] = max(sizes.get(kind, 0.0), abs(v))
    for s, v in followed.values.items():
        if s in found.guessed or s in stated or s not in kinds:
            continue
        exact = found.value.known(s)
        if exact is None:
            continue
        off = abs(float(exact) - v) / max(sizes[kinds[s]], natural[s])
        worst = max(worst, off)
    return worst


def _stated_letters(found: SolvedMotion) -> set[sp.Symbol]:
    """Letters that the file gives one by one, and those from which the motion was followed: on both roads the same."""
    course = found.course
    own = {s for stop in course.stops.values() for s in stop.letters.values()}
    alone = [e.residual.free_symbols & own for e in course.equations if e.kind in DATA]
    return {s for inside in alone if len(inside) == 1 for s in inside} | {*course.first.letters.values()}


def _passed(followed: Followed) -> Iterator[tuple[sp.Symbol, float]]:
    """The letters of the states with their values, and those of the general position on the way between them."""
    yield from followed.values.items()
    for segment in followed.segments:
        for k in range(1, LOOKS):
            try:
                here = segment.at(segment.t0 + (segment.t1 - segment.t0) * k / LOOKS)
            except NoValue:
                break
            yield from here.items()


def power_digits(regime: Regime) -> int | None:
    """To how many digits Newton's law and the balance of energy give the same du/dt; None: it does not tell."""
    if regime.balance is None:
        return None
    u = regime.free[0]
    total, given = (regime.in_letters(e) for e in regime.balance)
    left = derivative(total, u) * regime.accelerations[u]
    left += sp.Add(*(derivative(total, q) * r for q, r in regime.rates.items()))
    here = _anywhere(regime)
    a, b = here.known(left), here.known(given)
    if a is None or b is None:
        return None
    size = max(abs(a), abs(b), here.size(left) if left.is_Add else abs(a))
    ordinary = regime.general.instant.scene.ledger.natural
    power = abs(here(derivative(total, u))) * ordinary(u) / ordinary(regime.time)
    if size <= power * Decimal(10) ** -FULL:
        # What vanishes is known to the rounding of what cancels in it.
        return FULL
    off = abs(a - b) / size
    return FULL if off == 0 else min(int(-off.log10()), FULL) if off < Decimal(1) else 0


def _anywhere(regime: Regime) -> Valuation:
    """Numbers of a position like no other; where loops close, those of the position that was drawn."""
    general = regime.general
    if general.constraints:
        return general.value
    letters = (*(c.symbol for c in regime.coordinates), *regime.free)
    ordinary = general.instant.scene.ledger.natural
    moved = {s: general.value(s) + Decimal(i + 3) / 17 * ordinary(s) for i, s in enumerate(letters)}
    return general.value.extended(moved)
