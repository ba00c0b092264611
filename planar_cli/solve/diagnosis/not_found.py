"""Why constants, angles, speeds or extremes that are sought are not found."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.system.conditions import Condition
from planar_cli.equation.system.kinetics import body_residuals
from planar_cli.equation.values.exact import Unvalued
from planar_cli.errors import Diagnostic, NoValue
from planar_cli.problem.language.expression import Extreme, Quantity
from planar_cli.solve.diagnosis.meant import otherwise_meant
from planar_cli.solve.diagnosis.open_data import demand
from planar_cli.solve.diagnosis.words import in_general, listed, of_limits, one_of, unknown_name
from planar_cli.solve.instant.beyond import STILL
from planar_cli.solve.instant.candidates import Candidate
from planar_cli.solve.instant.instant import Instant, Trial
from planar_cli.solve.instant.plan import Planner
from planar_cli.solve.instant.seeker import LOOSE, Seeker
from planar_cli.solve.multibody.linear import solve

FIXED = "the other relations fix"
"""How the objection begins that nothing is left of which there could be a largest or smallest value."""
UNITS = {"a": "m/s^2", "alpha": "rad/s^2"}
"""What an acceleration is measured in, by its word."""


def open_symbols(candidates: list[Candidate], nonlinear: int, bits: dict[sp.Symbol, int]) -> list[sp.Symbol]:
    """The targets that no plan reaches."""
    return [s for s, bit in bits.items() if Planner(candidates, nonlinear).plan(bit) is None]


def not_found(instant: Instant, trial: Trial, objections: list[str], loose: list[sp.Symbol]) -> Diagnostic:
    """The diagnosis of a search that came to nothing. `loose`: targets that no equations determine."""
    find = instant.scene.problem.find[0]
    extremes = instant.statements.extremes
    said = list(dict.fromkeys(o for o in objections if o))
    names = [unknown_name(trial.system, s) for s in loose]
    hanging = [o for o in said if LOOSE in o]
    if extremes and "contradiction" in said and (undriven := _undriven(instant, extremes[0])) is not None:
        return undriven
    if extremes and (fixed := next((o for o in said if o.startswith(FIXED)), "")):
        text = f"{fixed}: nothing is left for which it could be {extremes[0].text.split(' is ')[1]}"
        hint = (
            "leave out what fixes it, or declare what may still vary: what sticks to fixed ground has no acceleration"
        )
        return Diagnostic(extremes[0].mark, "PL613", text, hint)
    if extremes and (beyond := next((o for o in said if o.endswith(STILL)), "")):
        wanted, word = extremes[0].text.split(" is ")
        text = f"{wanted} has no {word} value: where an assumption reaches its limit, {beyond}"
        hint = "ask for the other end, or state what else must hold; what friction wedges in holds whatever pushes it"
        return Diagnostic(extremes[0].mark, "PL613", text, hint)
    if extremes and not said:
        return _no_extreme(instant, trial, names)
    if hanging:
        name = hanging[0].split(f" {LOOSE}")[0]
        hint = f"give {name}, or state the case: `mode(C) = stick`, or ask for the limit: `{name} is smallest`"
        mark = next((s.mark for s in instant.scene.problem.unknowns if s.name == name), find.mark)
        return Diagnostic(mark, "PL606", f"{hanging[0]}; {demand(1)}", hint)
    if loose and not said:
        text = f"{find.name} is open: the equations do not determine {listed(names)}; {demand(1)}"
        problem = instant.scene.problem
        return Diagnostic(find.mark, "PL606", text, one_of(names) + of_limits(problem, names) + in_general(problem))
    text = "no solution is consistent" + (f": {'; '.join(said)}" if said else "")
    if (other := otherwise_meant(instant, said)) is not None:
        return Diagnostic(find.mark, "PL601", f"{text}; {other[0]}", other[1])
    hint = "change a given, or state one thing less"
    sought = [s.name for s in instant.scene.ledger.sought]
    if sought and not said and not extremes:
        text = f"no real {' and '.join(sought)} fulfils all equations"
        hint = f"{hint}: a sine or cosine lies in -1 to 1, and no square or length is below zero"
    if instant.scene.cancelling:
        hint += "; or give the masses and inertias that are `any`: they may tell which contacts press"
    return Diagnostic(find.mark, "PL601", text, hint)


def untold(instant: Instant, places: list[sp.Symbol]) -> Diagnostic:
    """Places that are sought, and that no statement tells."""
    problem = instant.scene.problem
    names = [s.name for s in places]
    declared = next((s for s in (*problem.coordinates, *problem.unknowns) if s.name == names[0]), problem.find[0])
    units = ", ".join(f"{s.name}: {instant.scene.ledger.units[s].text}" for s in places)
    text = f"nothing tells {listed(names)}: no statement says where it is, and the laws of motion hold in every place"
    hint = f"give {' and '.join(f'`{example(instant, s)}`' for s in places)}, or let it stay a letter: "
    hint += f"`symbols: {{{units}}}`{in_general(problem)}"
    return Diagnostic(declared.mark, "PL606", text, hint)


def example(instant: Instant, place: sp.Symbol) -> str:
    """A value of it as one would write it: `theta = 50 deg`."""
    unit = instant.scene.ledger.units[place]
    number = "50" if unit.text == "deg" else "0.5"
    return f"{place.name} = {number} {unit.text}".removesuffix(" 1")


def _no_extreme(instant: Instant, trial: Trial, names: list[str]) -> Diagnostic:
    """Why nothing is largest or smallest. `names`: what no equation determines."""
    extreme, problem = instant.statements.extremes[0], instant.scene.problem
    wanted, most = extreme.text.split(" is ")
    strict = next((r for r in instant.statements.inequalities if r.operator in ("<", ">")), None)
    light = [b for b in dict.fromkeys(w.body for w in trial.system.wrenches) if _driven_by_forces(trial, b)]
    if light:
        text = (
            f"{light[0]} has no mass, so that the forces on it must balance: that leaves nothing to choose for {wanted}"
        )
        hint = f"give {light[0]} a mass, or write under `motion` how it moves, as in `v({light[0]}).x = V`"
    elif names and not problem.unknowns:
        text = f"what {wanted} may rest on, {listed(names)}, is left open by the equations, and no letter stands for it"
        hint = "name it: `unknowns: {V: m/s}`, and under `instant` what it is, as in `v(b).x = V`"
    elif not problem.unknowns and not problem.coordinates:
        text = f"{wanted} is what the places as drawn make it: nothing is open that could make it more or less"
        hint = "write the points with an angle or a length under `coordinates`, or ask for it in a state on the way"
    elif strict is not None:
        text = f"`{strict.text}` leaves its own limit out, so that no {wanted} is the {most} one"
        hint = f"let it be reached: write `{strict.text.replace(strict.operator, strict.operator + '=')}`"
    else:
        text = (
            f"{wanted} has no extreme value: no contact, rope or guide reaches its limit, however far {wanted} is taken"
        )
        hint = "state what must hold, such as `mode(C) = stick`, or give a limit"
    return Diagnostic(extreme.mark, "PL613", text, hint)


def _driven_by_forces(trial: Trial, name: str) -> bool:
    """Has a body no mass, and do forces alone tell how it moves?"""
    body = trial.system.scene.bodies.get(name)
    edge = next((e for e in trial.system.tree.edges if e.body == name), None)
    if body is None or body.mass != 0 or edge is None:
        return False
    return any(rate is not None for rate in (edge.spin_rate, edge.slide_rate, edge.rise_rate))


def _undriven(instant: Instant, extreme: Extreme) -> Diagnostic | None:
    """The acceleration of a body is to be extreme that has no mass, and that no force or law drives."""
    q, bodies = extreme.side, instant.scene.bodies
    sought = isinstance(q, Quantity) and q.word in UNITS and len(q.things) == 1 and q.at is None
    if not sought or not isinstance(q, Quantity) or q.things[0] not in bodies or bodies[q.things[0]].mass != 0:
        return None
    asked, word = extreme.text.rsplit(" is ", 1)
    text = f"nothing drives {q.things[0]}, which has no mass: no {asked} is {word}"
    hint = f"let a constant drive it: `unknowns: {{a_0: {UNITS[q.word]}}}`, and here `{asked} = a_0, a_0 is {word}`"
    return Diagnostic(extreme.mark, "PL601", text, hint)


def contradiction(seeker: Seeker) -> Diagnostic | None:
    """Equations that are linear in what is sought, and that contradict each other; None: there are none."""
    unknowns = sorted(seeker.linear & set(seeker.unknowns), key=lambda s: s.name)
    others = set(seeker.unknowns) - set(unknowns)
    told: list[tuple[Condition | None, sp.Expr]] = [(c, e) for c in seeker.conditions for e in c.rows()]
    told += [(None, e) for body in seeker.scene.bodies for e in body_residuals(seeker.system, body)]
    rows, sources = [], []
    for condition, expr in told:
        if expr.free_symbols & others:
            continue
        try:
            form = linear_form(expr, set(unknowns))
            rows.append([*(seeker.value(form.terms.get(x, sp.S.Zero)) for x in unknowns), seeker.value(form.constant)])
        except (Nonlinear, Unvalued, NoValue):
            continue
        sources.append(condition)
    found = solve(rows, len(unknowns)).conflict
    if found is None:
        return None
    part = [c for c, factor in zip(sources, found[0], strict=True) if factor and c is not None and c.kind == "given"]
    if not part:
        return None
    text = f"these contradict each other: {'; '.join(dict.fromkeys(f'`{c.text}`' for c in part))}"
    return Diagnostic(part[-1].mark, "PL602", text, "leave one of these out, or correct its numbers")
