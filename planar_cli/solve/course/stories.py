"""Kinematics told as in a lecture: places in coordinates, coordinates over time, and what follows by differentiation."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import sympy as sp

from planar_cli.equation.jets import Jet
from planar_cli.equation.plain import simplified
from planar_cli.equation.quantities import Quantities
from planar_cli.problem.expression import Quantity
from planar_cli.problem.scene import Find
from planar_cli.problem.walk import walk
from planar_cli.solve.course.functions import Functions, explained
from planar_cli.solve.course.regime import Regime
from planar_cli.solve.passages import Passage, Row, told_function

LEVELS = {"r": 0, "x": 0, "y": 0, "v": 1, "IC": 1, "coriolis": 1, "KE": 1, "momentum": 1, "H": 1, "a": 2, "rho": 2}
ANGLES = {"theta": 0, "omega": 1, "alpha": 2}
HEADINGS = ("Places:", "Velocities, the derivatives of the places:", "Accelerations, the derivatives of the velocities:")


def places_told(
    regime: Regime, quantities: Quantities, functions: Functions, finds: Iterable[Find], with_rates: bool
) -> tuple[Passage, ...]:
    """Places, then velocities and accelerations as far as the finds go. `with_rates`: say how fast coordinates change."""
    wanted = _wanted(finds)
    rows: tuple[list[Row], list[Row], list[Row]] = ([], [], [])
    used: list[sp.Expr] = []
    for (thing, angular), level in wanted.items():
        for name, jet in _jets(thing, angular, quantities):
            closed = regime.closed(jet.value)
            used.append(closed)
            derivatives = [closed, jet.rate, jet.second]
            for n in range(level + 1):
                expr = derivatives[n]
                if expr is None or (n and jet.rate == 0):
                    break
                formula = simplified(functions.put_in(regime.closed(expr)))
                symbol = sp.Symbol(f"{name}{('', '_dot', '_ddot')[n]}", real=True)
                if formula != symbol:
                    rows[n].append(Row("", sp.Eq(symbol, formula, evaluate=False)))
    told = [told_function(f) for f in explained(functions.found, used)]
    rates = [r for r in _rates(regime, used) if r.line.lhs.name[:-4] not in {s.name for s in functions.found}]
    known = {r.line.lhs for r in told}
    first = [*told, *(r for r in rows[0] if r.line.lhs not in known)]
    passages = [Passage(HEADINGS[0], tuple(first))]
    if rates and with_rates and any(rows[1:]):
        passages.append(Passage("Rates of the coordinates:", tuple(rates)))
    passages += [Passage(HEADINGS[n], tuple(rows[n])) for n in (1, 2) if rows[n]]
    return tuple(p for p in passages if p.rows)


def _wanted(finds: Iterable[Find]) -> dict[tuple[str, bool], int]:
    """Which points and bodies are asked about, and how often their places are to be differentiated. True: an angle."""
    found: dict[tuple[str, bool], int] = {}
    for find in finds:
        dots = 0
        for q in (n for n in walk(find.found.what) if isinstance(n, Quantity)):
            if q.word in ("dot", "ddot"):
                dots += 1 if q.word == "dot" else 2
                continue
            table = ANGLES if q.word in ANGLES else LEVELS
            if q.word not in table:
                continue
            level = min(table[q.word] + dots, 2)
            for thing in q.things[:1] if q.word in ("KE", "momentum", "H") else q.things:
                key = (thing, q.word in ANGLES)
                found[key] = max(found.get(key, 0), level)
    return found


def _jets(thing: str, angular: bool, quantities: Quantities) -> Iterator[tuple[str, Jet]]:
    """The angle of a body, or x and y of a point that moves, as jets with the names under which they are told."""
    scene = quantities.scene
    if angular and thing in scene.bodies:
        twist = quantities.motion
        jet = Jet(scene.bodies[thing].theta, twist.velocities[thing].angular, twist.accelerations[thing].angular)
        yield f"theta_{thing}", jet
        return
    if thing not in scene.points and thing not in scene.bodies:
        return
    if thing in scene.bodies and thing not in scene.points:
        name = scene.center_name(thing) or thing
        place = quantities.place(thing)
    else:
        name, place = thing, quantities.place(thing)
    varies = [j for j in (place.x, place.y) if j.rate is not None and j.rate != 0]
    if not varies:
        return
    yield f"x_{name}", place.x
    yield f"y_{name}", place.y


def _rates(regime: Regime, used: Sequence[sp.Expr]) -> list[Row]:
    """q̇ = …, of the coordinates that stand in what is told."""
    inside = set().union(*(e.free_symbols for e in used)) if used else set()
    rows = []
    for symbol, rate in regime.rates.items():
        if symbol not in inside:
            continue
        dotted = sp.Symbol(f"{symbol.name}_dot", real=True)
        if rate != dotted:
            rows.append(Row("", sp.Eq(dotted, rate, evaluate=False)))
    return rows


