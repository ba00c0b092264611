"""The plan: the fewest equations that determine what is asked, in the order in which they are solved.

A state of the search is a set of unknowns; the equations inside it are all candidates whose unknowns lie in it. Best
first by size, so that the first set that determines the targets needs the fewest equations. Sets up to one larger are
ordered and priced as well: cost = Σ equations + tear, the unknowns that must be carried as letters.
"""

from __future__ import annotations

import heapq
import itertools
import math
from dataclasses import replace

from planar_cli.records import record
from planar_cli.solve.instant import rough
from planar_cli.solve.instant.candidates import Candidate
from planar_cli.solve.multibody.linear import Row, Span, determined, determines

TEAR = 1.0
NODES = 4000
VISITS = 600_000
"""The search ends after so many looks at a candidate: a third of a second, yet the same plan on every machine."""
CHOICES = 3000
"""So many choices of letters that are carried are compared; of more, they are chosen one at a time."""
GOALS = 12
WIDEST = 4
INNER = 2
"""So many inner forces that would only be added again make a sum over two bodies the plainer one; so many accelerations
with their arms a sum of forces.
"""
HEAVY, TOGETHER = 3, 5
"""Where so many equations have to be solved together anyhow, they may as well be plain ones, at most so many."""


@record
class Block:
    """Equations solved together for as many unknowns. `letters`: the unknowns carried as letters until the end."""

    equations: tuple[Candidate, ...]
    unknowns: tuple[int, ...]
    letters: tuple[int, ...]


@record
class Plan:
    """Blocks in order."""

    blocks: tuple[Block, ...]

    @property
    def equations(self) -> int:
        return sum(len(b.equations) for b in self.blocks)

    @property
    def largest(self) -> int:
        return max((len(b.equations) for b in self.blocks), default=0)

    @property
    def tear(self) -> int:
        return max((len(b.letters) for b in self.blocks), default=0)

    @property
    def cost(self) -> float:
        return sum(e.cost for b in self.blocks for e in b.equations) + TEAR * sum(len(b.letters) for b in self.blocks)


def _weight(plan: Plan) -> tuple[float, float]:
    return plan.equations + TEAR * plan.tear, plan.cost


def bits(mask: int) -> list[int]:
    """The set bits of a mask."""
    found = []
    while mask:
        low = mask & -mask
        found.append(low.bit_length() - 1)
        mask ^= low
    return found


def columns(row: Row, chosen: list[int]) -> Row:
    """The chosen entries of a row and its constant."""
    return [*(row[j] for j in chosen), row[-1]]


class Planner:
    """Plans over one list of candidates. `nonlinear`: bits of unknowns that should be found last; `seeds`: sets
    of unknowns that are likely to determine the targets.
    """

    def __init__(
        self, candidates: list[Candidate], nonlinear: int = 0, seeds: tuple[int, ...] = (), fixed: int | None = None
    ) -> None:
        self.candidates = sorted(candidates, key=lambda c: c.cost)
        self.masks = [c.mask for c in self.candidates]
        self.floats = [[float(x) for x in c.row[:-1]] for c in self.candidates]
        self.nonlinear = nonlinear
        self.seeds = seeds
        self.fixed = fixed
        self.turning: frozenset[str] = frozenset()
        """Bodies that turn and have mass."""
        self.motion = 0
        """Accelerations, as bits."""

    def inside(self, allowed: int) -> list[Candidate]:
        """The candidates all of whose unknowns are allowed."""
        return [self.candidates[i] for i in self._inside(allowed)]

    def _inside(self, allowed: int) -> list[int]:
        outside = ~allowed
        return [i for i, mask in enumerate(self.masks) if not mask & outside]

    def determined(self, most: int | None = None) -> int:
        """The unknowns that all candidates together fix, as bits. `most`: the rank of what they are made from, if
        known.
        """
        everything = self.everything
        chosen = bits(everything)
        most = len(chosen) if most is None else most
        span = Span(len(chosen))
        rows: list[Row] = []
        for c in sorted(self.candidates, key=lambda c: len(c.bodies)):
            row = columns(c.row, chosen)
            if span.grows(row):
                rows.append(row)
                if len(rows) >= most:
                    break
        if len(rows) == len(chosen):
            return everything
        return sum(1 << chosen[i] for i in determined(rows, len(chosen)))

    @property
    def everything(self) -> int:
        """All unknowns that occur."""
        mask = 0
        for m in self.masks:
            mask |= m
        return mask

    def plan(self, targets: int) -> Plan | None:
        """The cheapest plan found, or None when the candidates do not determine the targets."""
        if not targets:
            return Plan(())
        if targets & ~(self.determined() if self.fixed is None else self.fixed):
            return None
        goals = self._search(targets)
        goals += [seed | targets for seed in self.seeds if seed and self.fixes(seed | targets, targets)]
        plans = [p for p in (self.order(goal, targets) for goal in goals) if p is not None]
        if plans:
            best = min(plans, key=_weight)
            plainest = self._plainest(best, targets) if best.largest >= HEAVY else None
            return self._of_wholes(best if plainest is None else min(best, plainest, key=_weight), targets)
        # Beyond the budget of the search: by plain ordering.
        return self.order(self._shrunk(targets), targets)

    def fixes(self, allowed: int, targets: int) -> bool:
        """Do the candidates inside `allowed` determine the targets?"""
        chosen = bits(allowed)
        place = {j: i for i, j in enumerate(chosen)}
        wanted = bits(targets)
        if any(j not in place for j in wanted):
            return False
        inside = self._inside(allowed)
        if len(inside) < len(wanted):
            return False
        aims = [place[j] for j in wanted]
        answer = rough.fixes(
            ([row[j] for j in chosen] for row in map(self.floats.__getitem__, inside)), len(chosen), aims
        )
        if answer is not None:
            return answer
        return determines([columns(self.candidates[i].row, chosen) for i in inside], len(chosen), aims)

    def _search(self, targets: int) -> list[int]:
        """Sets of unknowns that determine the targets, the smallest first."""
        counter = itertools.count()
        heap: list[tuple[int, float, int, int]] = [(targets.bit_count(), 0.0, next(counter), targets)]
        seen = {targets}
        goals: list[int] = []
        best = 10**6
        for _ in range(min(NODES, VISITS // max(len(self.masks), 1) + 1)):
            if not heap or len(goals) >= GOALS:
                break
            size, _, _, state = heapq.heappop(heap)
            if size > best + 1:
                break
            if self.fixes(state, targets):
                goals.append(state)
                best = min(best, size)
                continue
            for mask, c in zip(self.masks, self.candidates, strict=True):
                new = state | mask
                if new in seen or not mask & state or (mask & ~state).bit_count() > WIDEST:
                    continue
                seen.add(new)
                heapq.heappush(heap, (new.bit_count(), c.cost, next(counter), new))
        return goals

    def _shrunk(self, targets: int) -> int:
        """Leave out unknowns one at a time while the targets stay determined."""
        state = self.everything
        for j in reversed(bits(state)):
            smaller = state & ~(1 << j)
            if not targets & (1 << j) and self.fixes(smaller, targets):
                state = smaller
        return state

    # --- order -------------------------------------------------------------------------------------------------------

    def _plainest(self, plan: Plan, targets: int) -> Plan | None:
        """The same unknowns by the plainest equations, a few of them solved together with one unknown as a letter: by
        others of the same bodies, or of single bodies instead of the moments of a group in which several turn, where
        the inner forces are found all the same.
        """
        unknowns = sum(1 << j for b in plan.blocks for j in b.unknowns)
        chosen = _independent(self.inside(unknowns), unknowns)
        if len(chosen) != plan.equations:
            return None
        found = self.order(unknowns, targets, chosen)
        if found is None or found.tear > 1 or found.largest > TOGETHER:
            return None
        ours, theirs = ([e for b in p.blocks for e in b.equations] for p in (found, plan))
        gone = [e for e in theirs if e not in ours]
        if all(len(e.bodies) <= 1 for e in gone):
            return found
        moments = [e for e in gone if e.choice is not None and e.choice.moment]
        return found if any(len(self.turning & set(e.bodies)) > 1 for e in moments) else None

    def _of_wholes(self, plan: Plan, targets: int) -> Plan:
        """The plan with the plainest equation of each block that is one for one unknown, the others being known."""
        known, blocks = 0, []
        for b in plan.blocks:
            own = sum(1 << j for j in b.unknowns)
            one = len(b.equations) == 1
            blocks.append(replace(b, equations=(self._plainer(b.equations[0], own, known, targets),)) if one else b)
            known |= own
        return Plan(_needed(blocks, targets))

    def _plainer(self, own: Candidate, unknown: int, known: int, targets: int) -> Candidate:
        """The sum of forces on a body and the one beside it, where one on a body alone would have several inner forces
        to add that are not asked: F = (M + m) a, not F = M a + F_A + F_B. Where all accelerations are known, a sum of
        forces, if it holds no more unknowns, for moments that hold several of them with their arms.
        """
        if own.choice is None or not own.bodies:
            return own
        heavy = own.choice.moment and (own.mask & self.motion).bit_count() >= INNER
        for mask, c in zip(self.masks, self.candidates, strict=True):
            if not mask & unknown or c.choice is None or c.choice.moment or not c.choice.name:
                continue
            gone = own.mask & ~mask
            wider = len(c.bodies) == len(own.bodies) + 1 and set(own.bodies) < set(c.bodies)
            inner = wider and not mask & ~own.mask and gone.bit_count() >= INNER and not gone & targets
            if inner and c.choice.name == own.choice.name:
                return c
            short = mask.bit_count() <= own.mask.bit_count() and not mask & ~(known | unknown)
            if heavy and short and (wider or c.bodies == own.bodies):
                return c
        return own

    def order(self, allowed: int, targets: int, pool: list[Candidate] | None = None) -> Plan | None:
        """The equations inside a set in the order of solution, the smallest solvable block first, then pruned. `pool`:
        those of which it is made, if not all.
        """
        known = 0
        blocks: list[Block] = []
        pool = self.inside(allowed) if pool is None else pool
        while targets & ~known:
            block = self._next_block(pool, known, allowed)
            if block is None:
                return None
            blocks.append(block)
            for j in block.unknowns:
                known |= 1 << j
        return Plan(_needed(blocks, targets))

    def _next_block(self, pool: list[Candidate], known: int, allowed: int) -> Block | None:
        """The smallest set of unknowns that the pool determines together."""
        left = [(c.mask & ~known, c) for c in pool if c.mask & ~known]
        heap: list[tuple[int, int, float, int, int]] = []
        counter = itertools.count()
        seen: set[int] = set()
        for rest, c in left:
            if rest not in seen:
                seen.add(rest)
                heapq.heappush(heap, (rest.bit_count(), bool(rest & self.nonlinear), c.cost, next(counter), rest))
        while heap:
            size, _, cost, _, state = heapq.heappop(heap)
            usable = [c for rest, c in left if not rest & ~state]
            if len(usable) >= size:
                chosen = _independent(usable, state)
                if len(chosen) == size:
                    return _torn(chosen, state, known, self.nonlinear)
            if len(seen) > NODES:
                break
            for rest, c in left:
                if rest & state and rest & ~state:
                    new = state | rest
                    if new not in seen:
                        seen.add(new)
                        heapq.heappush(
                            heap, (new.bit_count(), bool(new & self.nonlinear), cost + c.cost, next(counter), new)
                        )
        return self._whole(left, allowed & ~known, known)

    def _whole(self, left: list[tuple[int, Candidate]], state: int, known: int) -> Block | None:
        """Beyond the budget: everything that is left, together."""
        chosen = _independent([c for _, c in left], state)
        return _torn(chosen, state, known, self.nonlinear) if len(chosen) == state.bit_count() else None


def _independent(usable: list[Candidate], state: int) -> list[Candidate]:
    """The cheapest independent equations for the unknowns of a set."""
    chosen_columns = bits(state)
    span = Span(len(chosen_columns))
    pivots: list[Candidate] = []
    for c in usable:
        if span.grows(columns(c.row, chosen_columns)):
            pivots.append(c)
            if len(pivots) == len(chosen_columns):
                break
    return pivots


def _torn(chosen: list[Candidate], state: int, known: int, nonlinear: int) -> Block:
    """Order a block: as few letters as possible such that the rest follow one at a time."""
    unknowns = bits(state)
    size = len(chosen)
    if size == 1:
        return Block(tuple(chosen), tuple(unknowns), ())
    forced = [j for j in unknowns if nonlinear & (1 << j)]
    free = [j for j in unknowns if j not in forced]
    for count in range(max(1, len(forced)), size + 1):
        if math.comb(len(free), count - len(forced)) > CHOICES:
            break
        for extra in itertools.combinations(free, count - len(forced)):
            letters = (*forced, *extra)
            found = _chain(chosen, unknowns, letters, known)
            if found is not None:
                return Block(found[0], found[1], letters)
    letters = _letter_by_letter(chosen, forced, known)
    found = _chain(chosen, unknowns, letters, known)
    if found is None:
        return Block(tuple(chosen), tuple(unknowns), tuple(unknowns))
    return Block(found[0], found[1], letters)


def _letter_by_letter(chosen: list[Candidate], forced: list[int], known: int) -> tuple[int, ...]:
    """Letters one at a time: wherever no equation has one new unknown, all but one of the equation with the fewest."""
    letters, solved = list(forced), known
    for j in forced:
        solved |= 1 << j
    left = [c for c in chosen if c.mask & ~solved]
    while left:
        c = min(left, key=lambda c: ((c.mask & ~solved).bit_count(), c.cost))
        new = bits(c.mask & ~solved)
        letters += new[:-1]
        solved |= c.mask
        left = [x for x in left if x is not c and x.mask & ~solved]
    return tuple(letters)


def _chain(
    chosen: list[Candidate], unknowns: list[int], letters: tuple[int, ...], known: int
) -> tuple[tuple[Candidate, ...], tuple[int, ...]] | None:
    """Equations and unknowns in an order in which each next equation has one new unknown; the letters come last."""
    solved = known
    for j in letters:
        solved |= 1 << j
    equations: list[Candidate] = []
    order: list[int] = []
    left = list(chosen)
    while len(order) < len(unknowns) - len(letters):
        step = next(((c, c.mask & ~solved) for c in left if (c.mask & ~solved).bit_count() == 1), None)
        if step is None:
            return None
        left.remove(step[0])
        equations.append(step[0])
        order.append(bits(step[1])[0])
        solved |= step[1]
    return (*equations, *left), (*order, *letters)


def _needed(blocks: list[Block], targets: int) -> tuple[Block, ...]:
    """Drop the blocks on which the targets do not rest."""
    wanted = targets
    kept: list[Block] = []
    for block in reversed(blocks):
        own = sum(1 << j for j in block.unknowns)
        if own & wanted:
            kept.append(block)
            for e in block.equations:
                wanted |= e.mask
    return tuple(reversed(kept))
