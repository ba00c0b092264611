"""The virtual power of all bodies in letters, where one freedom is left and the reactions themselves are not unique, as
those between several planets and their sun.

    Σ F · ∂v/∂u + Σ M ∂ω/∂u = Σ m a_G · ∂v_G/∂u + Σ I α ∂ω/∂u      u: the speed by which all the others follow
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.system.conditions import Condition
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import CERTAIN, ZERO
from planar_cli.principles.base import Single
from planar_cli.problem.scene.geometry import Vec
from planar_cli.solve.instant.candidates import FAR, Candidate, mask_of, priced
from planar_cli.solve.instant.offers import Offers

LONGEST = 120
"""Longer relations are not followed in letters."""
Rates = Mapping[sp.Symbol, sp.Expr]


def power_in_letters(offers: Offers, targets: list[int], words: str) -> list[Candidate]:
    """One equation in accelerations alone; none where more than one freedom is left, or a reaction would take part."""
    system, numbers = offers.system, offers.numbers
    moving = [x for x in system.tree.acceleration_unknowns() if x in offers.index]
    for j in targets:
        u = numbers.unknowns[j]
        rates = _rates(offers, u, moving) if u in moving else None
        single = None if rates is None else _power(system, rates, words)
        if single is None or rates is None or not _without_reactions(offers, rates):
            continue
        row = numbers.row(single.left - single.right)
        found = priced((), None, None, row, FAR, single)
        if found is not None and mask_of(row):
            return [found]
    return []


def _rates(offers: Offers, u: sp.Symbol, moving: list[sp.Symbol]) -> dict[sp.Symbol, sp.Expr] | None:
    """How all accelerations change with one of them, as the relations of the joints have it; None: it is not told."""
    value, known = offers.numbers.value, dict[sp.Symbol, sp.Expr]({u: sp.S.One})
    try:
        every = [linear_form(row, set(moving)).terms for c in offers.conditions for row in c.rows()]
        forms = [
            terms for c in offers.conditions for row in _rows(c) if (terms := _terms(row, moving, offers)) is not None
        ]
    except Nonlinear:
        return None
    while any(f.keys() - known.keys() for f in forms):
        one = next((f for f in forms if len(f.keys() - known.keys()) == 1), None)
        if one is None:
            return None
        (x,) = one.keys() - known.keys()
        found = simplified(-sp.Add(*(c * known[y] for y, c in one.items() if y != x)) / one[x])
        # Equal wheels turn alike, whichever of the relations tells it.
        known[x] = next((e for e in known.values() if e != 1 and value.is_zero(e - found)), found)
    if set(moving) != set(known):
        return None
    sums = [[value(c * known[x]) for x, c in f.items()] for f in every]
    kept = all(abs(sum(parts, ZERO)) <= CERTAIN * 10**6 * sum(map(abs, parts), ZERO) for parts in sums)
    return known if kept else None


def _rows(condition: Condition) -> tuple[sp.Expr, ...]:
    """The relations that tell something: of what rolls, along the contact."""
    residual, along = condition.residual, condition.along
    return (residual.dot(along),) if isinstance(residual, Vec) and along is not None else condition.rows()


def _terms(row: sp.Expr, moving: list[sp.Symbol], offers: Offers) -> dict[sp.Symbol, sp.Expr] | None:
    """The coefficients of the accelerations; None: it holds none of them, or is too long."""
    terms = linear_form(row, set(moving)).terms
    if any(longer(c, LONGEST) for c in terms.values()):
        return None
    plain = {x: simplified(c) for x, c in terms.items()}
    return {x: c for x, c in plain.items() if not offers.numbers.value.is_zero(c)} or None


def _twist(system: System, body: str, rates: Rates) -> tuple[Vec, sp.Expr]:
    """∂v of the mass centre and ∂ω of a body."""
    assert system.motion is not None
    still = dict.fromkeys(rates, sp.S.Zero)
    a, alpha = system.motion.acceleration(system.scene.center(body), body), system.motion.accelerations[body].angular

    def slope(expr: sp.Expr) -> sp.Expr:
        found: sp.Expr = simplified(sp.sympify(expr).xreplace(dict(rates)) - sp.sympify(expr).xreplace(still))
        return found

    return Vec(slope(a.x), slope(a.y)), slope(alpha)


def _power(system: System, rates: Rates, words: str) -> Single | None:
    """Loads on the left, inertia on the right."""
    assert system.motion is not None
    loads, inertia = [], []
    for name, body in system.scene.bodies.items():
        v, omega = _twist(system, name, rates)
        center = system.scene.center(name)
        for wrench in system.wrenches:
            if wrench.body == name:
                loads.append(wrench.couple * omega)
                if wrench.force is not None:
                    loads.append(simplified(wrench.force.dot(v + (wrench.point - center).turned() * omega)))
        if body.mass != 0:
            inertia.append(body.mass * simplified(system.motion.acceleration(center, name).dot(v)))
        inertia.append(body.inertia * system.motion.accelerations[name].angular * omega)
    left, right = sp.Add(*loads), sp.Add(*inertia)
    return Single(left, right, words, "", FAR) if right != 0 and not longer(right, LONGEST) else None


def _without_reactions(offers: Offers, rates: Rates) -> bool:
    """Does no reaction do work in this motion? Friction that slips does."""
    value, system = offers.numbers.value, offers.system
    pushes = [offers.index[s] for p in system.pushes if (s := system.symbols[p.name]) in offers.index]
    done = dict.fromkeys(pushes, value(sp.S.Zero))
    size = dict.fromkeys(pushes, value(sp.S.Zero))
    for body in offers.bodies:
        v, omega = _twist(system, body, rates)
        center = system.scene.center(body)
        twist = [value(e) for e in (v.x + omega * center.y, v.y - omega * center.x, omega)]
        for rate, row in zip(twist, offers.body_rows(body), strict=True):
            for j in pushes:
                done[j] += rate * row[j]
                size[j] += abs(rate * row[j])
    return all(abs(done[j]) <= CERTAIN * 10**6 * size[j] for j in pushes)
