"""What the equations leave open: motions, constants and reactions, and which data would close them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.kinematics.motion import Edge
from planar_cli.equation.system.conditions import vector_or_jet
from planar_cli.equation.values.exact import ZERO, Unvalued, Valuation
from planar_cli.errors import Diagnostic, Mark, NoSolution, NoValue
from planar_cli.problem.language.expression import Quantity, Relation
from planar_cli.problem.scene.facts import Push
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, Find
from planar_cli.solve.diagnosis.singular import ChangePoint, blocked, change_point, dead_centre
from planar_cli.solve.diagnosis.words import (
    in_general,
    left_of,
    listed,
    moved_accelerations,
    moved_velocities,
    on_whom,
    one_of,
    push_name,
    short,
)
from planar_cli.solve.instant.instant import Instant, Trial
from planar_cli.solve.instant.study import Outcome
from planar_cli.solve.instant.worked import unknowns_of

FAINT = Decimal("1e-25")
NUMBERS = ("no", "one", "two", "three", "four", "five", "six")


def demand(count: int) -> str:
    """`one datum is missing`, `two data are missing`."""
    return "one datum is missing" if count == 1 else f"{counted(count)} data are missing"


def counted(count: int) -> str:
    """A small number as a word."""
    return NUMBERS[count] if count < len(NUMBERS) else str(count)


# --- velocities ------------------------------------------------------------------------------------------------------


def open_velocities(instant: Instant, trial: Trial, mark: Mark) -> Diagnostic:
    """No given fixes how fast the parts move."""
    singular = at_change_point(instant, trial, mark) or at_dead_centre(instant, trial, mark)
    if singular is not None:
        return singular
    velocities = trial.velocities[0]
    groups = [moved_velocities(instant, trial.system, change) for change in velocities.loose.values()]
    names = list(dict.fromkeys(n for g in groups for n in g)) or [s.name for s in velocities.free]
    hint = " and ".join(one_of(g) for g in groups if g) or one_of(names)
    text = f"the velocities are open: nothing determines {listed(names)}; {demand(len(velocities.free))}"
    return Diagnostic(mark, "PL604", text, f"{hint}, or say `at rest`")


def at_dead_centre(instant: Instant, trial: Trial, mark: Mark) -> Diagnostic | None:
    """A given speed that says nothing in this position."""
    found = dead_centre(instant, trial.system)
    if found is None:
        return None
    names = [n for m in found.motions for n in moved_velocities(instant, trial.system, m)]
    turning = [n for n in names if n.startswith("omega(")] or names
    left = left_of(found.relation)
    text = f"dead centre: as drawn, {left} is 0 whatever {listed(turning)} {'is' if len(turning) == 1 else 'are'}"
    if any(v.conflict is not None for v in trial.velocities):
        text += f", so that `{found.relation.text}` cannot hold"
    else:
        text += f"; `{found.relation.text}` leaves them open"
    count = len(found.motions)
    wanted = one_of(turning) if count == 1 else f"give {counted(count)} of {', '.join(dict.fromkeys(turning))}"
    return Diagnostic(found.relation.mark, "PL610", text, f"{wanted} instead, or draw another position")


def at_change_point(instant: Instant, trial: Trial, mark: Mark) -> Diagnostic | None:
    """The joints allow more motions here than next to here."""
    found = change_point(instant, trial.system)
    if found is None:
        return None
    text = "change point: as drawn, the joints lose an equation, and velocities do not say how the linkage goes on"
    ways = _ways(instant, found)
    if ways:
        text += f": {', or '.join(ways)}"
    return Diagnostic(mark, "PL611", text, "draw it a little before or after this position, or say `at rest`")


def _ways(instant: Instant, found: ChangePoint) -> list[str]:
    """Each way in which it can leave, by ratios of angular velocities."""
    spins: dict[sp.Symbol, str] = {}
    for branch in found.branches:
        for edge in _edges(instant):
            if edge.spin in branch and edge.spin is not None:
                spins.setdefault(edge.spin, edge.body)
    leader = next((s for s in spins if all(b[s] for b in found.branches)), None)
    if leader is None:
        return []
    ways = []
    for branch in found.branches:
        ratios = {body: branch[s] / branch[leader] for s, body in spins.items() if s != leader}
        parts = [_ratio(body, r, spins[leader]) for body, r in ratios.items()]
        parallel = ratios and all(not r or abs(r - 1) < FAINT for r in ratios.values())
        kind = "as a parallelogram" if parallel else "crossed"
        ways.append(f"{kind} with {listed(parts)}")
    if sum(w.startswith("as a") for w in ways) != 1:
        return [w.removeprefix("crossed ").removeprefix("as a parallelogram ") for w in ways]
    return sorted(ways, key=lambda w: w.startswith("crossed"))


def _edges(instant: Instant) -> tuple[Edge, ...]:
    return instant.system(tuple(0 for _ in instant.modes)).tree.edges


def _ratio(body: str, ratio: Decimal, leader: str) -> str:
    if not ratio:
        return f"omega({body}) = 0"
    factor = "" if abs(ratio - 1) < FAINT else "-" if abs(ratio + 1) < FAINT else f"{short(ratio)}*"
    return f"omega({body}) = {factor}omega({leader})"


def demand_passable(instant: Instant, trial: Trial, finds: tuple[Find, ...]) -> None:
    """Raise at a change point at rest, when the linkage does not begin to move in one of the ways that it can."""
    outcome = trial.outcomes[0]
    if not trial.system.tree.closures or any(trial.velocities[0].values.values()):
        return
    rates = unknowns_of(trial.system, outcome)
    starts = {
        speed: rates.get(rate, ZERO)
        for e in trial.system.tree.edges
        for speed, rate in ((e.spin, e.spin_rate), (e.slide, e.slide_rate), (e.rise, e.rise_rate))
        if speed is not None and rate is not None
    }
    pairs = instant.scene.evaluator.motions.values()
    starts |= {speed: rates.get(rate, ZERO) for speed, rate in pairs if speed is not None and rate is not None}
    if blocked(instant, trial.system, starts):
        found = at_change_point(instant, trial, finds[0].mark)
        if found is not None:
            raise NoSolution([replace(found, hint="draw it a little before or after this position")])


# --- accelerations, constants, reactions -----------------------------------------------------------------------------


def demand_determined(instant: Instant, trial: Trial, finds: tuple[Find, ...]) -> None:
    """Raise where a find depends on what the equations of the instant leave open."""
    if not trial.outcomes or not trial.outcomes[0].solved.null:
        return
    outcome = trial.outcomes[0]
    keys = {j: key for key, j in outcome.assembly.columns.items()}
    for find in finds:
        touching = [v for v in outcome.solved.null.values() if _depends(instant, trial, find, v)]
        if touching:
            changes = [{keys[j]: c for j, c in enumerate(v) if c} for v in touching]
            raise NoSolution([_open(instant, trial, find, changes)])


def _depends(instant: Instant, trial: Trial, find: Find, null: list[Decimal]) -> bool:
    """Does a find change along a freedom of the solution?"""
    what = find.found.what
    if isinstance(what, Quantity) and what.word == "mode":
        return False
    system, outcome = trial.system, trial.outcomes[0]
    quantities = system.quantities_of(instant.free, system.reactions)
    sides = (what.left, what.right) if isinstance(what, Relation) else (what,)
    try:
        values = [vector_or_jet(s, quantities, quantities.evaluator) for s in sides if not _is_mode(s)]
        exprs = [p.value for v in values for p in ((v.x, v.y) if isinstance(v, Vec) else (v,)) if p.value is not None]
        before, after = (_with(instant, trial, outcome, step, null) for step in (ZERO, Decimal("1.37")))
        return any(abs(after(e) - before(e)) > FAINT * (abs(before(e)) + 1) for e in exprs)
    except (Unvalued, NoValue):
        return False


def _is_mode(side: Any) -> bool:
    return type(side).__name__ == "Word" or (isinstance(side, Quantity) and side.word == "mode")


def _with(instant: Instant, trial: Trial, outcome: Outcome, step: Decimal, null: list[Decimal]) -> Valuation:
    """Numbers of everything at the solution plus `step` times a freedom."""
    columns = outcome.assembly.columns
    values = [v + step * n for v, n in zip(outcome.solved.values, null, strict=True)]
    numbers: dict[sp.Symbol, Decimal] = {}
    for edge in instant.free.tree.edges:
        velocity, omega = outcome.assembly.twists[edge.body]
        parts = (("x", edge.slide_rate, edge.slide, velocity.x), ("y", edge.rise_rate, edge.rise, velocity.y))
        for part, rate, speed, now in (*parts, ("turn", edge.spin_rate, edge.spin, omega)):
            if rate is not None and speed is not None:
                numbers[speed], numbers[rate] = now, values[columns[edge.body, part]]
    for name, symbol in trial.system.symbols.items():
        numbers[symbol] = values[columns[name]] if name in columns else ZERO
    rates = trial.system.scene.evaluator.second_rates
    for symbol in (*trial.system.scene.ledger.sought, *rates):
        if symbol.name in columns:
            numbers[symbol] = values[columns[symbol.name]]
    return outcome.value.extended(numbers)


def _open(instant: Instant, trial: Trial, find: Find, changes: list[dict[Any, Decimal]]) -> Diagnostic:
    """Name what is open: a motion, a constant, or only reactions."""
    system = trial.system
    sought = {s.name for s in instant.scene.ledger.sought}
    pushes = {p.name: p for p in system.pushes}
    constants = list(dict.fromkeys(k for c in changes for k in c if k in sought))
    motions = list(dict.fromkeys(n for c in changes for n in moved_accelerations(instant, system, c)))
    if not motions and not constants:
        return _redundant(trial, find, [{pushes[k]: v for k, v in c.items() if k in pushes} for c in changes])
    singular = at_change_point(instant, trial, find.mark)
    if singular is not None:
        return singular
    closing = [*constants, *motions]
    if constants:
        text = f"{find.name} is open: the equations do not determine {listed(closing)}; {demand(len(changes))}"
        others = [push_name(system, pushes[k]) for c in changes for k in c if k in pushes]
        hint = one_of([*closing, *dict.fromkeys(others)][:8])
        return Diagnostic(find.mark, "PL606", text, hint + in_general(instant.scene.problem))
    text = f"the accelerations are open: nothing determines {listed(motions)}; {demand(len(changes))}"
    why = "bodies without mass do not resist; give them masses, or " if _massless(instant, changes) else ""
    constant = "; a speed that stays constant belongs under `motion`" if instant.statements.relations else ""
    return Diagnostic(find.mark, "PL605", text, why + one_of(motions) + constant)


def _massless(instant: Instant, changes: list[dict[Any, Decimal]]) -> bool:
    moved = {k[0] for c in changes for k in c if isinstance(k, tuple)}
    return any(instant.scene.bodies[b].mass == 0 for b in moved)


def _redundant(trial: Trial, find: Find, changes: list[dict[Push, Decimal]]) -> Diagnostic:
    """Reactions that can change together without changing the motion."""
    system = trial.system
    loose = list(dict.fromkeys(p for c in changes for p in c))
    whole = _freedoms(trial, loose)
    names = [push_name(system, p) for p in loose]
    sure = [push_name(system, p) for p in system.pushes if trial.outcomes[0].push(p.name) is not None]
    partly = [d for p in _by_place(loose) if (d := _direction(trial, p, whole)) is not None]
    text = f"{find.name} is not unique: {listed(names)} can change together without changing the motion"
    unique = [*sure, *partly]
    text += f"; unique: {listed(unique)}" if unique else "; no reaction is unique"
    extra = "one support more" if len(whole) == 1 else f"{counted(len(whole))} supports more"
    hint = f"{extra} than there are equations: leave {'one' if len(whole) == 1 else 'some'} out"
    return Diagnostic(find.mark, "PL603", text, hint + (", or ask for what is unique" if unique else ""))


def _freedoms(trial: Trial, loose: list[Push]) -> list[dict[str, Decimal]]:
    """All freedoms of the solution that touch these pushes, by the pushes' names."""
    columns = trial.outcomes[0].assembly.columns
    found = []
    for vector in trial.outcomes[0].solved.null.values():
        part = {p.name: vector[columns[p.name]] for p in loose if p.name in columns}
        if any(part.values()):
            found.append(part)
    return found


def _by_place(loose: list[Push]) -> list[tuple[Push, Push]]:
    """Pairs of components of one reaction that are both loose."""
    parts = [p for p in loose if p.kind == "component"]
    return [(a, b) for i, b in enumerate(parts) for a in parts[:i] if a.joint == b.joint and _bodies(a) == _bodies(b)]


def _bodies(push: Push) -> list[str]:
    return [a.body for a in push.actions]


def _direction(
    trial: Trial, pair: tuple[Push, Push], changes: list[Mapping[str, Decimal]] | list[dict[str, Decimal]]
) -> str | None:
    """The direction in which a reaction is unique though both components are loose."""
    value = trial.outcomes[0].value
    action = next((a for a in pair[0].actions if a.body != GROUND), None)
    if action is None:
        return None
    vectors = []
    for change in changes:
        x = y = ZERO
        for push in pair:
            force = next(a.force for a in push.actions if a.body == action.body)
            if force is not None:
                x += change[push.name] * value(force.x)
                y += change[push.name] * value(force.y)
        if x or y:
            vectors.append((x, y))
    x, y = vectors[0]
    if any(abs(x * v - y * u) > FAINT * (abs(x) + abs(y)) * (abs(u) + abs(v)) for u, v in vectors):
        return None
    angle = float(sp.atan2(sp.Float(str(x)), sp.Float(str(-y)))) * 57.29577951308232
    return f"reaction({on_whom(trial.system, pair[0])}).along({short(Decimal(angle % 180))} deg)"


__all__ = ["demand_determined", "open_velocities"]
