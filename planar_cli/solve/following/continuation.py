"""Positions of states where nothing tells the speeds: carried over from the position that was drawn.

Such a state is its relations about places and the loops. What a relation is off at the state before shrinks to nothing
in small steps, and the position follows: so it stays on the branch that was drawn.
"""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import derivative
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.records import record
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.roots.chain import Branch
from planar_cli.solve.multibody.linear import solve
from planar_cli.solve.regimes.regime_sequence import RegimeSequence

STEP, SMALLEST, NEWTON = Decimal(1) / 32, Decimal("1e-4"), 10
CLOSE, SAME = Decimal("1e-20"), Decimal("1e-9")
JUMP = Decimal("0.5")
"""Newton's method may move a position by so much in one step, in radians or parts of its size."""
Places = dict[sp.Symbol, Decimal]
Way = tuple[sp.Expr, Decimal, tuple[sp.Expr, ...]]
"""What vanishes in the end, what it is at the start, and its derivatives."""


class Blocked(Exception):
    """On the way there the position stops, or could go on in several ways."""


def continued_branch(course: MotionEquations, branches: Sequence[Branch]) -> Branch:
    """Of several branches the one that the drawn position leads to. NoSolution: that cannot be told."""
    places = [own for s in course.states for own in _letters(course, s.name)]
    natural = course.natural(places)
    if all(_agree(b.values, branches[0].values, natural) for b in branches):
        return branches[0]
    for state in course.states[1:]:
        try:
            led = _led(course, state.name)
        except Blocked as error:
            text = f"state {state.name}: several positions fit, and the drawn one leads to none of them: {error}"
            hint = "draw the points in this state, or give the motion that leads to it"
            raise NoSolution([Diagnostic(state.mark, "PL620", text, hint)]) from error
        if led is None:
            continue
        branches = [b for b in branches if _agree(b.values, led, course.natural(led))]
        if not branches:
            text = f"state {state.name}: its relations cannot hold in the way in which the linkage is drawn"
            raise NoSolution([Diagnostic(state.mark, "PL620", text, "draw the points in this state")])
    return branches[0]


def _letters(course: RegimeSequence, name: str) -> list[sp.Symbol]:
    return [course.stops[name].letters[c.symbol] for c in course.regimes[0].coordinates]


def _agree(one: Places, other: Places, natural: Places) -> bool:
    """Are these letters the same? `natural`: an ordinary size of each."""
    both = [(one[s], other[s], size) for s, size in natural.items() if s in one and s in other]
    return all(abs(a - b) <= SAME * max(abs(a), abs(b), size) for a, b, size in both)


def _led(course: MotionEquations, name: str) -> Places | None:
    """Where a state is, carried over from the drawn position; None: its relations do not fix it."""
    base = course.base()
    now, own = _letters(course, name), _letters(course, course.first.name)
    drawn: Places = {}
    for e in course.equations:
        inside = e.residual.free_symbols & set(own)
        if e.kind == "drawn" and len(inside) == 1:
            x = inside.pop()
            place = base.known(sp.expand(x - e.residual))
            if place is None:
                # It is drawn with a constant that is sought.
                return None
            drawn[x] = place
    if set(drawn) != set(own):
        return None
    known = base.extended(drawn)
    there = [e for e in course.equations if e.stop == name and e.kind in ("given", "loop", "motion")]
    fixed = [e for e in there if e.residual.free_symbols & set(now)]
    fixed = [e for e in fixed if not e.residual.free_symbols & (course.chain().unknowns - {*now, *own})]
    loops = [e.residual for e in fixed if e.kind == "loop"]
    goals = [e.residual for e in fixed if e.kind != "loop"]
    start = dict(zip(now, (drawn[x] for x in own), strict=True))
    equations = [(r, False) for r in loops] + [(r, True) for r in goals]
    return _Carrier(known, now, course.natural(now)).run(equations, start)


@record
class _Carrier:
    """Leads letters from one position to another."""

    known: Valuation
    """Numbers of everything else."""
    letters: Sequence[sp.Symbol]
    natural: Places
    """An ordinary size of each letter."""

    def run(self, equations: Sequence[tuple[sp.Expr, bool]], start: Places) -> Places | None:
        """`equations`: what vanishes, and whether only at the end. None: they leave something open."""
        here = self.known.extended(start)
        chosen: list[Way] = []
        for residual, goal in equations:
            slopes = tuple(derivative(residual, x) for x in self.letters)
            trial = [*chosen, (residual, here(residual) if goal else Decimal(0), slopes)]
            if solve(self._rows(trial, start, Decimal(0)), len(self.letters)).rank == len(trial):
                chosen = trial
        if len(chosen) < len(self.letters):
            return None
        at, done, step = start, Decimal(0), STEP
        sense = self._sense(chosen, start)
        while done < 1:
            step = min(step, 1 - done)
            reached = self._newton(chosen, at, done + step)
            if reached is None:
                step /= 2
                if step < SMALLEST:
                    raise Blocked("the position stops on the way")
                continue
            if done + step < 1 and self._sense(chosen, reached) != sense:
                raise Blocked("on the way it could go on in two ways")
            at, done, step = reached, done + step, min(2 * step, STEP)
        return at

    def _rows(self, chosen: Sequence[Way], at: Places, part: Decimal) -> list[list[Decimal]]:
        here = self.known.extended(at)
        return [[*map(here, slopes), here(r) - (1 - part) * off] for r, off, slopes in chosen]

    def _newton(self, chosen: Sequence[Way], at: Places, part: Decimal) -> Places | None:
        """The position at a part of the way; None: not found close by."""
        moved = Decimal(0)
        for _ in range(NEWTON):
            here = self.known.extended(at)
            if any(here.known(e) is None for r, _, slopes in chosen for e in (r, *slopes)):
                return None
            solved = solve(self._rows(chosen, at, part), len(self.letters))
            if solved.rank < len(self.letters):
                return None
            at = {x: at[x] + d for x, d in zip(self.letters, solved.values, strict=True)}
            steps = zip(self.letters, solved.values, strict=True)
            sizes = [abs(d) / max(abs(at[x]), self.natural[x]) for x, d in steps]
            moved += max(sizes)
            if moved > JUMP:
                return None
            if max(sizes) <= CLOSE:
                return at
        return None

    def _sense(self, chosen: Sequence[Way], at: Places) -> int:
        """The sign of the determinant: where it changes, the position can branch."""
        rows = [row[:-1] for row in self._rows(chosen, at, Decimal(0))]
        sign = 1
        for i in range(len(rows)):
            pivot = max(range(i, len(rows)), key=lambda k: abs(rows[k][i]))
            if not rows[pivot][i]:
                return 0
            if pivot != i:
                rows[i], rows[pivot], sign = rows[pivot], rows[i], -sign
            sign = sign if rows[i][i] > 0 else -sign
            for k in range(i + 1, len(rows)):
                factor = rows[k][i] / rows[i][i]
                rows[k] = [a - factor * b for a, b in zip(rows[k], rows[i], strict=True)]
        return sign


__all__ = ["continued_branch"]
