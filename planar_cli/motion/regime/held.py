"""What one joint does in one of its modes, in terms of the state: relations that it keeps and forces that it exerts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from planar_cli.motion.terms.constraints import Constraint
from planar_cli.motion.terms.elimination import factor
from planar_cli.motion.terms.layout import Column, Layout
from planar_cli.motion.terms.terms import Graph, Term
from planar_cli.problem.scene.facts import Mode, Push
from planar_cli.records import record


@record
class Held:
    """One joint in one mode."""

    joint: str
    mode: Mode
    constraints: tuple[Constraint, ...]
    pushes: tuple[Push, ...]
    columns: Mapping[str, Column]
    """The generalized force of a unit of each push, by its name."""
    followers: Mapping[str, tuple[Term, str | None]]
    """Pushes that follow a law: factor · another push, or the factor alone."""
    loads: Column
    """The generalized force of friction of a fixed size against the sliding."""
    presumed: tuple[tuple[str, Term], ...] = ()
    """What it takes for granted of places and does not keep: lengths that stay, and words where one does not."""

    @property
    def free(self) -> tuple[Push, ...]:
        """The pushes that are sought."""
        return tuple(p for p in self.pushes if p.name not in self.followers)

    @property
    def ideal(self) -> bool:
        """Is there no friction in it: do its forces do no work on motions that it allows?"""
        return not any(of is not None for _, of in self.followers.values())

    def driving(self, graph: Graph) -> list[dict[int, Term]]:
        """For every constraint the generalized force of a unit of its multiplier."""
        if self.ideal:
            return [dict(c.row) for c in self.constraints]
        assert len(self.free) == len(self.constraints), self.joint
        found = []
        for push in self.free:
            column = dict(self.columns[push.name])
            for name, (share, of) in self.followers.items():
                if of == push.name:
                    add(column, self.columns[name], share, graph)
            found.append(column)
        return found

    def known(self, graph: Graph) -> dict[int, Term]:
        """The generalized force of what does not depend on the sought pushes."""
        total = dict(self.loads)
        for name, (size, of) in self.followers.items():
            if of is None:
                add(total, self.columns[name], size, graph)
        return total

    def exerted(self, layout: Layout, multipliers: Sequence[Term], reach: float) -> dict[str, Term]:
        """Every push, from the multipliers of the constraints. `reach`: a length, m, comparing couples with forces."""
        if self.ideal:
            found = self._resolved(layout, multipliers, reach)
        else:
            found = {p.name: m for p, m in zip(self.free, multipliers, strict=True)}
        for name, (share, of) in self.followers.items():
            found[name] = share if of is None else share * found[of]
        return {p.name: found[p.name] for p in self.pushes}

    def _resolved(self, layout: Layout, multipliers: Sequence[Term], reach: float) -> dict[str, Term]:
        """The pushes that together do what the multipliers do: as many equations as pushes, by least squares."""
        graph, columns = layout.graph, [self.columns[p.name] for p in self.free]
        total: dict[int, Term] = {}
        for constraint, multiplier in zip(self.constraints, multipliers, strict=True):
            add(total, constraint.row, multiplier, graph)
        weights = [graph.number(1.0 if s.kind in ("x", "y") else 1.0 / reach**2) for s in layout.slots]

        def dot(a: Column, b: Column) -> Term:
            found = graph.number(0.0)
            for i, t in a.items():
                if i in b:
                    found = found + weights[i] * (t * b[i])
            return found

        rows = [{j: dot(a, b) for j, b in enumerate(columns)} for a in columns]
        rows = [{j: t for j, t in row.items() if not (t.constant and t.value == 0)} for row in rows]
        solved = factor(graph, rows).solve([dot(a, total) for a in columns])
        return {p.name: t for p, t in zip(self.free, solved, strict=True)}


def add(total: dict[int, Term], column: Column, factor: Term, graph: Graph) -> None:
    """total += factor · column."""
    for i, t in column.items():
        total[i] = total.get(i, graph.number(0.0)) + factor * t
