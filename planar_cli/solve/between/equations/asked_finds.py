"""The finds of a file as expressions in a motion, before its regimes are worked out."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from planar_cli.equation.system.conditions import gap
from planar_cli.equation.system.system import mode_of
from planar_cli.errors import refuse
from planar_cli.problem.checks.check_dimensions import about
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.dimensions import Kind, dimension_of
from planar_cli.problem.language.expression import Name, Quantity, Relation, Side
from planar_cli.problem.language.walk import names_of_states, walk
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Find, Problem
from planar_cli.records import record
from planar_cli.solve.regimes.regime_sequence import RegimeSequence
from planar_cli.solve.regimes.timeline import NONE_KEPT, KeptLetters, Reader, Stop
from planar_cli.solve.roads import is_curve
from planar_cli.units import IMPULSE, Unit, parse_unit

TRUTHS = ("reached", "stable")
RATES = frozenset(("dot", "ddot", "v", "a", "omega", "alpha", "KE", "momentum", "H"))
"""What vanishes in equilibrium."""


@record
class AskedFind:
    """One find of the file."""

    find: Find
    """What the file asks."""
    reader: Reader
    """Who reads it."""
    raw: tuple[sp.Expr, ...]
    """It in the unknowns of the general position, with stand-ins; of a relation left minus right. Two of a vector."""
    at: Stop | None
    """Its state, where it has no `@` of its own."""
    unit: Unit | None
    """The unit of its answer; None: it is a relation, a word or a curve."""

    def parts(self, kept: KeptLetters = NONE_KEPT) -> tuple[sp.Expr, ...]:
        """It in symbols of states, or of the general position where it holds throughout, and in unknowns kept."""
        if self.at is not None:
            return tuple(self.factor * self.reader.at(self.at, part, kept) for part in self.raw)
        return tuple(self.factor * self.reader.closed(part, kept) for part in self.raw)

    @property
    def factor(self) -> sp.Expr:
        """2 π of a frequency that is asked for in a unit of angular velocity."""
        what = self.find.found.what
        of_swings = isinstance(what, Quantity) and what.word == "frequency"
        return 2 * sp.pi if of_swings and self.unit is not None and self.unit.angle else sp.S.One


def asked_finds(motion: RegimeSequence, units: Mapping[str, str]) -> tuple[AskedFind, ...]:
    """All finds; what they need is put on the lists of what regimes work out. `units`: of answers, by name."""
    only = "" in motion.stops
    last = motion.states[-1].name if motion.states else next(iter(motion.stops))
    found = []
    for find in motion.problem.find:
        reader = motion.readers[last]
        at = motion.stops[""] if only else _alone(motion, find)
        found.append(AskedFind(find, reader, _parts(find, reader), at, _unit(motion, units, find)))
    return tuple(found)


def _alone(motion: RegimeSequence, find: Find) -> Stop | None:
    """The only state of the file, where that is an equilibrium: what is asked of places and forces is asked there. Of
    rates, which vanish there, a formula is asked.
    """
    states, what = motion.problem.states, find.found.what
    if len(states) != 1 or motion.states or is_curve(what) or isinstance(what, Relation):
        return None
    return None if _is_rate(what) else motion.stops[states[0].name]


def _is_rate(what: Side) -> bool:
    """Does it rest on what vanishes in equilibrium?"""
    return any(isinstance(q, Quantity) and q.word in RATES for q in walk(what))


def asks_rates_throughout(problem: Problem) -> bool:
    """Is a formula asked that is zero as long as nothing moves?"""
    sides = [
        f.found.what for f in problem.find if not isinstance(f.found.what, Relation) and not is_curve(f.found.what)
    ]
    return any(_is_rate(side) and not names_of_states(side) for side in sides)


def asked_letters(asked: tuple[AskedFind, ...]) -> set[sp.Symbol]:
    """All symbols that finds ask for."""
    return {s for a in asked for p in a.parts() for s in p.free_symbols}


def _parts(find: Find, reader: Reader) -> tuple[sp.Expr, ...]:
    what = find.found.what
    if isinstance(what, Relation):
        if mode_of(what) is not None:
            return ()
        apart = gap(reader.any(what.left), reader.any(what.right))
        parts = tuple(p.value for p in ((apart.x, apart.y) if isinstance(apart, Vec) else (apart,)))
    elif (isinstance(what, Quantity) and what.word == "mode") or is_curve(what):
        return ()
    else:
        found = reader.any(what)
        parts = tuple(p.value for p in (found.x, found.y)) if isinstance(found, Vec) else (found.value,)
    if any(p is None for p in parts):
        raise refuse(find.mark, "PL552", f"{find.name}: the accelerations do not tell this rate")
    reader.exprs += parts
    return parts


def _unit(motion: RegimeSequence, units: Mapping[str, str], find: Find) -> Unit | None:
    """The unit that the file writes, that of its answer, or the one of its dimension."""
    what = find.found.what
    if isinstance(what, Relation) or is_curve(what) or (isinstance(what, Quantity) and what.word in (*TRUTHS, "mode")):
        return None
    if find.found.unit is not None:
        return parse_unit(find.found.unit)
    if find.name in units:
        return parse_unit(units[find.name])
    setup = motion.readers[next(iter(motion.stops))].regime.general.instant.setup
    scope = Scope(motion.problem, ())

    def lookup(thing: Name | Quantity) -> Kind | None:
        if isinstance(thing, Quantity) and thing.word == "impulse" and about(thing, scope) is None:
            return Kind(IMPULSE)
        return setup.lookup(thing)

    return setup.unit_asked(what, dimension_of(what, lookup))
