"""Particles that are welded together drawn as one body, where no equation is about one of them alone, nor about what
acts between them:

    block, bullet:  (m_B + m_0) g ↓,  N ↑,  μ N ←   =   (m_B + m_0) a →
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.system.one_body import inner_reactions
from planar_cli.equation.values.ledger import Ledger
from planar_cli.report.document.blocks import Forces, Line, Math, Text
from planar_cli.report.kinetics.entries import entries, listed
from planar_cli.report.kinetics.forces import force_rows
from planar_cli.report.kinetics.groups_drawn import with_groups
from planar_cli.report.notation.total_masses import with_totals
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.solution import InstantSolution

NOTHING = (Text("0"),)


def diagrams(instant: InstantSolution, stage: Stage, phrases: Phrases, inertia_as_force: bool) -> list[Forces]:
    """The rows of the kinetic equations, with one for all particles that are one body in them, and one for each group
    of bodies of which an equation is told.
    """
    rows = force_rows(instant, stage, phrases, inertia_as_force)
    told = [w.bodies for block in stage.blocks for w in block.equations]
    return with_groups(as_one_body(rows, instant, stage), instant, told)


def struck_together(
    rows: list[Forces], struck: InstantSolution, since: str, balanced: Iterable[Sequence[str]]
) -> list[Forces]:
    """The diagrams of the blow after a state, with one for all particles that were one body before it, and one for each
    group of bodies that are `balanced` together.
    """
    names = [s.name for s in struck.instant.scene.problem.states]
    begun = names[: names.index(since)] if since in names else []
    told = [tuple(bodies) for bodies in balanced]
    # Of an impulse that one body has from another both are drawn.
    told += [(b,) for bodies in told if any((own,) in told for own in bodies) for b in bodies]
    return with_groups(as_one_body(rows, struck, struck.stages[0], begun), struck, told)


def as_one_body(
    rows: list[Forces], instant: InstantSolution, stage: Stage, begun: Sequence[str] | None = None
) -> list[Forces]:
    """The rows with those of each such group in one. `begun`: the states from which a weld must act; None: any."""
    welds = _welds(instant, begun)
    if not welds or len(rows) < 2:
        return rows
    written = [w for block in stage.blocks for w in block.equations]
    used = {s for w in written for s in w.residual.free_symbols}
    for group, inner in _groups(welds):
        own = [row for row in rows if row.body in group]
        parted = any(0 < len(group & {*w.bodies}) < len(group) for w in written)
        if parted or inner & used or len(own) < len(group) or not _are_particles(instant, group):
            continue
        whole = _joined(own, inner, instant)
        rows = [whole if row is own[0] else row for row in rows if row not in own[1:]]
    return rows


def _welds(instant: InstantSolution, begun: Sequence[str] | None) -> list[tuple[frozenset[str], set[sp.Symbol]]]:
    """The bodies of each weld, with its reactions."""
    symbols, found = instant.trial.system.symbols, dict[frozenset[str], set[sp.Symbol]]()
    for push, joint in inner_reactions(instant.trial.system):
        if begun is None or joint.during is None or joint.during[0] in begun:
            found.setdefault(frozenset(a.body for a in push.actions), set()).add(symbols[push.name])
    return list(found.items())


def _groups(welds: Iterable[tuple[frozenset[str], set[sp.Symbol]]]) -> list[tuple[frozenset[str], set[sp.Symbol]]]:
    """Bodies that hang together by welds, with all reactions between them."""
    groups: list[tuple[frozenset[str], set[sp.Symbol]]] = []
    for bodies, inner in welds:
        met = [g for g in groups if g[0] & bodies]
        whole = bodies.union(*(g[0] for g in met)), inner.union(*(g[1] for g in met))
        groups = [*(g for g in groups if g not in met), whole]
    return groups


def _are_particles(instant: InstantSolution, group: Iterable[str]) -> bool:
    return not any(instant.instant.scene.bodies[b].rigid for b in group)


def _joined(own: Sequence[Forces], inner: set[sp.Symbol], instant: InstantSolution) -> Forces:
    acting = [e for row in own for e in entries(row.left) if not _holds(e, inner)]
    moving = [e for row in own for e in entries(row.right)]
    left, right = (listed(_with_totals(side, instant)) for side in (acting, moving))
    return replace(own[0], body=", ".join(row.body for row in own), left=left, right=right)


def _holds(entry: Line, letters: set[sp.Symbol]) -> bool:
    return any(isinstance(p, Math) and p.expr.free_symbols & letters for p in entry)


def _with_totals(entries: Sequence[Line], instant: InstantSolution) -> list[Line]:
    """Weights, and what they amount to, that point the same way as one, by the total mass."""
    ledger, found = instant.instant.scene.ledger, list[Line]()
    for entry in (e for e in entries if e != NOTHING):
        for i, (size, *arrow) in enumerate(found):
            whole = _total(size, entry[0], ledger) if _told(arrow) == _told(entry[1:]) else None
            if whole is not None and not (put := with_totals(whole, ledger)).is_Add:
                found[i] = (Math(put), *arrow)
                break
        else:
            found.append(entry)
    return found or [NOTHING]


def _total(one: Any, other: Any, ledger: Ledger) -> sp.Expr | None:
    """The sum of two sizes in letters; None: they are numbers, or weights that have letters of their own."""
    plain = all(isinstance(p, Math) and not p.values for p in (one, other))
    given = plain and any(p.expr.xreplace(ledger.definitions).is_Symbol for p in (one, other))
    return one.expr + other.expr if plain and not given else None


def _told(arrow: Iterable[Any]) -> list[Any]:
    return [p.text if isinstance(p, Text) else p for p in arrow]
