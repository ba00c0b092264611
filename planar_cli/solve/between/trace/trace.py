"""What is said of a motion that is solved, as frozen data: all that print, comparison and submissions see of it.

Expressions are in the symbols of states (`x__2` of x in state 2), of the file, and of the general position. SI units.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from decimal import Decimal

import sympy as sp

from planar_cli.calculus.spans import Span
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Ledger
from planar_cli.principles.base import Balance, EnergyParts
from planar_cli.problem.scene.scene import Find, Problem
from planar_cli.records import record
from planar_cli.solve.between.trace.oscillation_trace import OscillationTrace
from planar_cli.solve.between.trace.span_trace import SpanIntegral
from planar_cli.solve.instant.conditions import Proviso
from planar_cli.solve.instant.roots import Root
from planar_cli.solve.law import RELATIVE, Law
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.taken import Taken
from planar_cli.units import Unit

# --- relations between states ----------------------------------------------------------------------------------------


@record
class BalanceTrace:
    """One balance of a principle between two states, in SI units."""

    law: Balance
    """The law, with the words in which it is told."""
    since: str
    """The state at the beginning."""
    stop: str
    """The state at the end."""
    before: sp.Expr
    """The amount at the beginning."""
    after: sp.Expr
    """The amount at the end."""
    brought: tuple[tuple[str, sp.Expr], ...]
    """What sources bring meanwhile, by their words; those that bring nothing are left out."""
    amounts: tuple[tuple[str, sp.Expr], ...]
    """The amount at the end, by body."""
    parts: EnergyParts | None = None
    """Of energies and angular momenta, what they are made of."""
    impulse: sp.Expr | None = None
    """The integral over time of what sources bring; None: it does not vary in time, or not with time alone."""

    @property
    def gain(self) -> sp.Expr:
        """What all sources bring."""
        return sp.Add(*(e for _, e in self.brought))


@record
class Impact:
    """Impacts and impulses between two states of one instant."""

    since: str
    """The state just before."""
    impacts: int
    """How many impacts happen in it."""
    solution: InstantSolution | None
    """Its plan of equations, with velocities where an instant has accelerations; None: nothing had to be planned."""


@record
class Centre:
    """A moment centre without a name: where two lines of action meet."""

    x: sp.Expr
    """Its abscissa, m."""
    y: sp.Expr
    """Its ordinate, m."""
    through: tuple[sp.Expr, ...]
    """The impulses whose lines meet there."""


@record
class ImpactEquation:
    """One equation of the plan of an impact."""

    impact: Impact
    """The impact that it is of."""
    left: sp.Expr
    """Its left side."""
    right: sp.Expr
    """Its right side."""
    law: str
    """force, moment or relation."""
    lead: str
    """The direction or the moment centre; of a relation, its words."""
    words: str
    """What it says, in words."""
    bodies: tuple[str, ...]
    """The group whose momentum it balances."""
    centre: Centre | None
    """The moment centre, where it has no name."""
    along: tuple[sp.Expr, sp.Expr] | None
    """Of linear momenta, the direction in which they count as positive."""
    together: tuple[str, sp.Symbol, bool] | None = None
    """The bodies that do not rebound in it, the letter of the velocity that they then have, and whether that is their
    whole velocity, not its part along the common normal alone.
    """


@record
class AimTrace:
    """What is largest or smallest over a constant that is sought: in a letter of a state, as a formula of constants,
    and the balance from which that follows; or the equations, by their residuals, from which a time was eliminated.
    """

    quantity: sp.Expr
    formula: sp.Expr
    law: BalanceTrace | None
    timed: tuple[sp.Expr, ...] = ()


FUNCTION = "function"
"""The kind of a relation by which something at a state is what a function of the place is there."""
PAIR = "pair"
"""That by which two bodies that a tie joins move about their mass centre, in formulas."""
GIVEN_RATE = "given rate"
"""That by which it is what a function of the time is there that the file gives."""


@record
class Relation:
    """One equation between states: `residual` vanishes."""

    residual: sp.Expr
    """Left side minus right side."""
    kind: str
    """Of which kind it is: given, drawn, link, loop, v(t), energy, blow, …"""
    words: str
    """Where it comes from."""
    stop: str
    """The state at its end; "" where it holds throughout."""
    since: str = ""
    """The state at its beginning; "" for none."""
    is_datum: bool = False
    """Does it only say what is known anyway?"""
    span: Span | None = None
    """The integral of a law that it is, with its limits."""
    law: Law | None = None
    """The law of motion of which it is an integral."""
    source: BalanceTrace | ImpactEquation | None = None
    """What it was planned from, where that is written out."""
    offered: frozenset[str] = frozenset()
    """The principles of which it is a law, by their words; none for data, geometry and blows."""
    aim: AimTrace | None = None
    """What is largest or smallest by it."""
    told: sp.Expr | None = None
    """The residual in letters that have lines of their own, as the coordinates of mass centres; None: as it is."""
    of: sp.Expr | None = None
    """What is largest or smallest in time where it holds."""

    @property
    def is_of_motion(self) -> bool:
        """Does it tell how something goes on in time?"""
        return self.law is not None or self.kind == RELATIVE


# --- the route -------------------------------------------------------------------------------------------------------


@record
class Result:
    """One line: unknown = formula = value."""

    unknown: sp.Symbol
    """What is found."""
    formula: sp.Expr | None
    """Its formula in what was found before; None: none is short."""
    value: Decimal
    """Its number."""
    roots: tuple[Root, ...] = ()
    """All roots of its equation, with those that do not happen."""


@record
class DeadPosition:
    """A dead position by its right triangle."""

    acute: Result
    """The acute angle of the line of both links."""
    sine: tuple[sp.Expr, sp.Expr]
    """Of its right triangle the longest side and the one opposite to it."""
    place: Result | None
    """How far its end is along the guide; None: that is not asked."""
    along: sp.Expr
    """The same in the angles of both links."""
    angle: sp.Expr
    """The angle of the first link by the acute one."""
    direction: Result | None = None
    """The same with its own letter; None: the file has that letter for something else."""
    turned: Result | None = None
    """Through what the first link has turned since the position before."""
    since: str = ""
    """The state of the position before."""
    again: bool = False
    """Is it an earlier position some turns later?"""


@record
class LinksInLine:
    """Where two links lie in one line: the angle of the first, that of the other as so many half turns more."""

    first: sp.Symbol
    other: sp.Symbol
    half_turns: int
    formula: sp.Expr
    """The first angle: n π ± arcsin of a ratio of lengths."""
    dead: DeadPosition | None = None
    """Its right triangle, where nothing else rests on both angles."""

    @property
    def folded(self) -> bool:
        return self.half_turns % 2 == 1

    @property
    def turns(self) -> bool:
        """Does it tell through what the first link turns?"""
        return self.dead is not None and self.dead.turned is not None


@record
class RouteStep:
    """Unknowns from relations in which all else is known."""

    relations: tuple[Relation, ...]
    """The relations that are used."""
    unknowns: tuple[sp.Symbol, ...]
    """What they fix."""
    needs: frozenset[sp.Symbol]
    """What must be known for that."""
    results: tuple[Result, ...]
    """The lines that it gives."""
    is_datum: bool
    """Does it only say what is given?"""
    in_line: LinksInLine | None = None
    """Of an extreme position of a mechanism."""

    @property
    def turns(self) -> bool:
        """Does it tell through what a crank turns?"""
        return self.in_line is not None and self.in_line.turns


@record
class RouteTrace:
    """The way to what is asked."""

    steps: tuple[RouteStep, ...]
    """Derivations in their order."""
    settled: frozenset[sp.Symbol]
    """The unknowns whose numbers rest on no letter without a number."""
    formulas: Mapping[sp.Symbol, sp.Expr]
    """Everything that was derived."""
    plain: Mapping[sp.Symbol, sp.Expr]
    """Data that are put in at once: zeros and names of the file."""


# --- the motion ------------------------------------------------------------------------------------------------------


@record
class Turning:
    """A state that was put in: until when an assumption holds, or what happens there."""

    state: str
    """Its name."""
    time: sp.Symbol | None
    """Its time; None: it has no number."""
    expr: sp.Expr
    """What vanishes there."""
    words: str
    """What held up to there, or what happens."""
    before: str
    """The given time of the state that follows, as the file has it; "": it has none."""


@record
class Request:
    """A find of the file."""

    find: Find
    """What the file asks."""
    parts: tuple[sp.Expr, ...]
    """It in symbols of states; of the general position where it holds throughout. Two of a vector."""
    unit: Unit | None
    """The unit of its answer; None: it is a relation or a word."""
    beside: tuple[tuple[sp.Symbol, sp.Expr], ...] = ()
    """Letters of its state in which it is told and that nothing else tells, with what they are."""


@record
class RegimeTrace:
    """One regime of the motion."""

    solution: InstantSolution
    """Its general position, worked out."""
    stretches: tuple[tuple[str, str], ...]
    """From which state to which it acts; to "" beyond the last, and to itself of a state that no motion leads to."""
    wanted: frozenset[str] | None
    """Names of the unknowns of its general position on which the motion and its finds rest; None: all of them."""
    resting: frozenset[str] | None
    """The same without finds at single states."""
    asked: Mapping[str, Mapping[str, tuple[sp.Expr, ...]]]
    """By state, by name: the components of such finds."""
    laws: tuple[tuple[sp.Symbol, sp.Expr], ...]
    """Its equations of motion: the rate of every free speed, a formula of the general position."""
    constants: Mapping[sp.Symbol, tuple[sp.Expr, Decimal]]
    """Formulas and numbers of the unknowns of its general position that are the same all the time and not zero."""
    ways: Mapping[sp.Symbol, int]
    """The signs of its free speeds, where it is the way in which something goes that tells a force."""


@record
class MotionTrace:
    """A motion over time with the way to what is asked of it."""

    problem: Problem
    """The file that it is of."""
    states: tuple[str, ...]
    """The states in their order."""
    ledger: Ledger
    """Units and titles of all symbols."""
    value: Valuation
    """Numbers of everything."""
    symbolic: bool
    """Do letters of the file stay in the answers?"""
    unknowns: frozenset[sp.Symbol]
    """Symbols of states and sought constants."""
    general: Mapping[sp.Symbol, sp.Symbol]
    """By the symbol of a state, that of the general position."""
    varying: frozenset[sp.Symbol]
    """Symbols of the general position of all regimes: t, coordinates, free speeds."""
    free: frozenset[sp.Symbol]
    """The free speeds of the first regime."""
    guessed: frozenset[sp.Symbol]
    """Symbols of states whose values come from following the motion in numbers alone."""
    integrated: bool
    """Do the equations of motion, integrated by themselves, give these too?"""
    followed: Mapping[sp.Symbol, float] | None
    """Symbols of states with the values that following the motion in numbers gave; None: it could not be followed."""
    turnings: tuple[Turning, ...]
    """States that were put in."""
    route: RouteTrace
    """The way to what is asked."""
    requests: tuple[Request, ...]
    """What is asked."""
    passing: Mapping[str, RouteTrace]
    """By the name of a find that holds throughout the motion, the way to it."""
    spans: tuple[SpanIntegral, ...]
    """Quantities over spans."""
    oscillations: tuple[OscillationTrace, ...]
    """About equilibrium states that are asked about."""
    regimes: tuple[RegimeTrace, ...]
    """The regimes that are told."""
    stretches: tuple[tuple[str, str, tuple[Law, ...]], ...]
    """From state to state, but for blows: how the coordinates move."""
    unused: tuple[BalanceTrace, ...]
    """Energies between states that the route does without: another principle, to check it by."""
    checks: tuple[str, ...]
    """What was compared, in phrases."""
    presumed: tuple[sp.Expr, ...]
    """What is positive with these letters, and need not be."""
    corners: tuple[str, ...]
    """States at which a body passes over a corner, with its speed kept."""
    taken: Taken
    """For a motion that is followed anew."""
    provisos: tuple[Proviso, ...] = ()
    """What the letters must be for the motion to take this course."""
    named: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    """Finds that are unknowns of the route, by letters of the states."""
    read_off: frozenset[str] = frozenset()
    """The names of finds that no equation tells, but the motion that was followed."""

    def regime(self, solution: InstantSolution) -> RegimeTrace:
        """The regime of a general position."""
        return next(r for r in self.regimes if r.solution is solution)

    def is_read_off(self, find: Find | None) -> bool:
        """Does the number of a find rest on one that following the motion alone has given?"""
        rests = {s for r in self.requests if r.find is find for e in r.parts for s in e.free_symbols}
        for step in reversed(self.route.steps):
            rests |= step.needs if rests & set(step.unknowns) else frozenset()
        told = find is not None and find.name in self.read_off
        return told or (not self.integrated and bool(rests & self.guessed))
