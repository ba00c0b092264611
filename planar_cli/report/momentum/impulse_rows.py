"""Impulses over a time = momenta at its end, for each body that starts from rest: J_Ax → at A,  M t_2 ↻   =   I ω_2 ↺.

They are the free-body diagrams of the motion with every force replaced by its impulse, where reactions have impulses
that the equations of momentum do not leave out.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.values.ledger import Kind
from planar_cli.problem.scene.impulse_letters import of_reaction
from planar_cli.report.document.blocks import Block, Forces, Line, Math, Paragraph, Text, Value, line
from planar_cli.report.given.conditions_of_states import asked_here
from planar_cli.report.given.light_bodies import own_momenta, parts_of_mass
from planar_cli.report.kinetics.entries import ASSUMED, entries, listed
from planar_cli.report.kinetics.forces import force_rows
from planar_cli.report.momentum.speeds_of_momenta import speeds_first
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import BalanceTrace, MotionTrace, RegimeTrace, RouteStep
from planar_cli.solve.solution import InstantSolution

OPPOSITE = str.maketrans("→←↑↓↗↙↖↘↺↻", "←→↓↑↙↗↘↖↻↺")
IMPULSES = ("impulses", "momenta")
"""What stands over both sides of such diagrams."""


def before_leg(leg: RouteStep, found: MotionTrace, phrases: Phrases, told: set[sp.Symbol]) -> Iterator[Block]:
    """What stands before the equations of a leg: what is asked and solved for, or speeds by it, and diagrams of
    impulses. `told`: speeds that were told, which grows.
    """
    balances = [e.source for e in leg.relations if isinstance(e.source, BalanceTrace) and not e.source.law.letter]
    rows, first = list[Block](), list[Block]()
    for since, stop in dict.fromkeys((b.since, b.stop) for b in balances):
        own = [b for b in balances if (b.since, b.stop) == (since, stop)]
        regime = next((r for r in found.regimes if (since, stop) in r.stretches), None)
        drawn = list(_rows(regime, own, found, phrases)) if regime is not None and _rests(regime, since, found) else []
        first += speeds_first(own, found.route.plain, phrases, told) if drawn else ()
        rows += drawn
    if not first:
        yield from asked_here(leg, found, phrases)
    yield from (*first, *rows)


def _rests(regime: RegimeTrace, since: str, found: MotionTrace) -> bool:
    """Is everything at rest in a state, also in a direction in which there is no balance?"""
    speeds = regime.solution.trial.system.rates()
    own = [x for x, general in found.general.items() if general in speeds and found.ledger.roles[x].at == since]
    return all(found.value.known(x) == 0 for x in own)


def _rows(regime: RegimeTrace, own: list[BalanceTrace], found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """The diagrams of the bodies of these balances; nothing where no reaction has an impulse in them."""
    solution, since, stop = regime.solution, own[0].since, own[0].stop
    system = solution.trial.system
    letters = {system.symbols[p.name]: sp.Symbol(f"{of_reaction(p.name)}__{stop}", real=True) for p in system.pushes}
    used = {s.name for b in own for s in b.gain.free_symbols}
    stage = next((s for s in reversed(solution.stages) if s.level == "acceleration"), None)
    time = _between(since, stop, found)
    if stage is None or time is None or not used & {s.name for s in letters.values()}:
        return
    speeds = {rate: speed for speed, rate in system.rates().items()}
    ends = {general: x for x, general in found.general.items() if found.ledger.roles[x].at == stop}
    after = {rate: ends.get(speed, sp.Symbol(f"{speed.name}__{stop}", real=True)) for rate, speed in speeds.items()}
    asked = {sp.expand(made): x for x, made in found.named.items()}
    for x in stage.lines:
        made = sp.expand(x.expression.xreplace(after).xreplace(dict(found.route.plain)))
        after[x.symbol] = asked.get(made, sp.Symbol(f"v{x.symbol.name[1:]}__{stop}", real=True))
    told = Phrases(solution.instant.scene.ledger, solution.value, phrases.figures, phrases.symbolic)
    groups = list(dict.fromkeys(b.law.bodies for b in own))
    bodies = {body for group in groups for body in group}
    shares = _shares(solution, groups, ends, found)
    if shares is None:
        return
    against = {s for s, (_, number) in regime.constants.items() if number < 0}
    rows = []
    for row in force_rows(solution, stage, told, inertia_as_force=False):
        left, right = _impulses(row.left, letters, time, found, against), _momenta(row.right, after)
        if row.body in bodies and (left is None or right is None):
            return
        if row.body in bodies and left is not None and right is not None:
            rows.append(Forces(row.body, left, right, IMPULSES, row.scene))
    ends_of = {letters[system.symbols[p.name]]: {a.body for a in p.actions} for p in system.pushes}
    drawn = rows
    rows = []
    for group in sorted(groups, key=len):
        inner = {letter for letter, both in ends_of.items() if both <= {*group}}
        rows += _of_group(group, drawn, shares, inner)
    level = [_level(row) for row in rows]
    kept = {s for row in level for s in _letters(row)}
    upright = {s.name for row in rows for s in _letters(row) - kept}
    left_out = rows != level and not used & upright
    left_out = left_out and all(_is_level(e) or _turns(e) for row in rows for e in entries(row.right))
    across = "impulses along y" if found.problem.plane == "horizontal" else "vertical impulses"
    note = line("J: impulse of a reaction", *parts_of_mass(solution, shares))
    note = line(*note, f"; the {across} do not enter" if left_out else "")
    yield Paragraph(line(f"From {since} to {stop}, from rest: impulses = momenta at {stop} (", *note, ")"))
    yield from level if left_out else rows


def _shares(
    solution: InstantSolution, groups: list[tuple[str, ...]], ends: Mapping[sp.Symbol, sp.Symbol], found: MotionTrace
) -> dict[str, Line] | None:
    """The momenta of bodies whose mass is counted in that of another one; None: they can not be drawn."""
    asked = {sp.expand(made): x for x, made in found.named.items()}
    plain = dict(found.route.plain)

    def speed(velocity: sp.Expr) -> sp.Expr | None:
        return asked.get(sp.expand(velocity.xreplace(dict(ends)).xreplace(plain)))

    return own_momenta(solution, groups, speed)


def _of_group(
    group: tuple[str, ...], rows: list[Forces], shares: Mapping[str, Line], inner: set[sp.Symbol]
) -> Iterator[Forces]:
    """The diagram of a group without the impulses `inner`, which act between its bodies, and without couples that are
    opposite; that of a body alone is its own, with the momentum that the other ones leave to it.
    """
    own = [row for row in rows if row.body in group]
    if len(own) < 2:
        yield from (replace(row, right=listed([*_share(row, shares), *entries(row.right)])) for row in own)
        return
    acting = [entry for row in own for entry in entries(row.left)]
    outer = [entry for entry in acting if not any(isinstance(p, Math) and p.expr.free_symbols & inner for p in entry)]
    outer = [entry for entry in outer if not _turns(entry) or outer.count(_opposite(entry)) != outer.count(entry)]
    left, right = outer or [line("0")], [entry for row in own for entry in entries(row.right)]
    yield replace(own[0], body=", ".join(row.body for row in own), left=listed(left), right=listed(right))


def _opposite(entry: Line) -> Line:
    return tuple(_sense(p, turned=True) if isinstance(p, Text) else p for p in entry)


def _share(row: Forces, shares: Mapping[str, Line]) -> list[Line]:
    return [shares[row.body]] if row.body in shares else []


def _level(row: Forces) -> Forces:
    """A diagram without vertical impulses."""
    kept = [e for e in entries(row.left) if not _is_upright(e)] or [line("0")]
    return replace(row, left=listed(kept))


def _is_upright(entry: Line) -> bool:
    return any(isinstance(p, Text) and ("↑" in p.text or "↓" in p.text) for p in entry)


def _is_level(entry: Line) -> bool:
    return any(isinstance(p, Text) and ("→" in p.text or "←" in p.text) for p in entry)


def _turns(entry: Line) -> bool:
    return any(isinstance(p, Text) and ("↺" in p.text or "↻" in p.text) for p in entry)


def _letters(row: Forces) -> set[sp.Symbol]:
    return {s for p in row.left if isinstance(p, Math) for s in p.expr.free_symbols}


def _between(since: str, stop: str, found: MotionTrace) -> sp.Expr | None:
    """The time between two states; None: it has no letter."""
    times = {found.ledger.roles[x].at: x for x, g in found.general.items() if found.ledger.roles[g].kind is Kind.TIME}
    if since not in times or stop not in times:
        return None
    return sp.sympify(times[stop] - times[since]).xreplace(dict(found.route.plain))


def _impulses(
    row: Line,
    letters: Mapping[sp.Symbol, sp.Symbol],
    time: sp.Expr,
    found: MotionTrace,
    against: set[sp.Symbol],
) -> Line | None:
    """What acts, by its impulses; None: a force varies, or is a number. `against`: reactions that act the other way
    than their letters count.
    """
    pieces: list[Any] = []
    turned = False
    for piece in row:
        if isinstance(piece, Value) or (isinstance(piece, Math) and piece.expr.free_symbols & found.varying):
            return None
        if isinstance(piece, Math):
            reaction = piece.expr.free_symbols & letters.keys()
            turned = bool(reaction & against)
            put = piece.expr.xreplace(dict(letters)) if reaction else piece.expr * time
            pieces.append(Math(put))
        else:
            pieces.append(_sense(piece, turned) if isinstance(piece, Text) else piece)
    return tuple(pieces)


def _sense(piece: Text, turned: bool) -> Text:
    """`→ at A`, the other way round where it acts so."""
    text = piece.text.replace(ASSUMED, "")
    return replace(piece, text=text.translate(OPPOSITE) if turned else text)


def _momenta(row: Line, after: Mapping[sp.Symbol, sp.Symbol]) -> Line | None:
    """What they amount to at the end; None: an acceleration has no velocity of its own."""
    pieces: list[Any] = []
    for piece in row:
        if isinstance(piece, Math):
            if piece.values or not piece.expr.free_symbols & after.keys():
                return None
            pieces.append(Math(piece.expr.xreplace(dict(after))))
        else:
            pieces.append(piece)
    return tuple(pieces)
