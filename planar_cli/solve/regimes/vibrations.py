"""The letters of vibrations: which laws of a motion are linear with a stiffness, and what their letters are."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.calculus.forcing import split
from planar_cli.calculus.vibrations import Vibration
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import derivative, letters, longer, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Ledger
from planar_cli.records import record
from planar_cli.solve.law import Law
from planar_cli.solve.regimes.equations import Laws
from planar_cli.solve.regimes.regime import Regime

LONGEST = 60
"""A law of more operations has no coefficients that anybody would read."""
Made = dict[tuple[int, sp.Symbol, str], sp.Symbol]


def with_vibrations(
    laws: Sequence[Laws],
    regimes: Sequence[Regime],
    states: Sequence[str],
    value: Valuation,
    ledger: Ledger,
    made: Made,
) -> tuple[tuple[Laws, ...], dict[sp.Symbol, sp.Expr]]:
    """The laws with the letters of their vibrations, and what these letters are, down to names of the file. `states`:
    where the regimes begin; `value`: numbers of what is given; `made`: letters of earlier tries.
    """
    formulas: dict[sp.Symbol, sp.Expr] = {}
    known: dict[tuple[sp.Symbol, sp.Expr], Vibration | None] = {}
    found = []
    for regime, own, state in zip(regimes, laws, states, strict=True):
        told = []
        for law in own.laws:
            key = (law.coordinate.symbol, law.f.xreplace({law.v: sp.Symbol("v", real=True)}))
            if key not in known:
                others = [v for v in known.values() if v is not None]
                namer = _Namer(ledger, made, state if others else "")
                known[key] = _vibration(law, regime, value, namer, others)
            told.append(replace(law, vibration=known[key]))
        found.append(replace(own, laws=tuple(told)))
    for vibration in filter(None, known.values()):
        for letter, formula in (*vibration.free, *vibration.forced):
            formulas[letter] = formula.xreplace(formulas)
    return tuple(found), formulas


class _Namer:
    """Makes letters, each once for a state."""

    def __init__(self, ledger: Ledger, made: Made, state: str) -> None:
        self.ledger, self.made, self.state = ledger, made, state

    def __call__(self, name: str, unit: str, positive: bool = False) -> sp.Symbol:
        key = (id(self.ledger), sp.Symbol(name), self.state)
        if key not in self.made:
            whole = f"{name}__{self.state}" if self.state else name
            self.made[key] = self.ledger.fresh(whole, unit, positive=positive)
        return self.made[key]


def _vibration(
    law: Law, regime: Regime, value: Valuation, name: _Namer, others: Sequence[Vibration]
) -> Vibration | None:
    """The letters of one law; None: it is not linear with a stiffness, or its letters have no numbers. `others`: those
    of laws before.
    """
    q, t = law.coordinate.symbol, regime.time
    if law.order != 2 or longer(law.f, LONGEST) or not {q} <= letters(law.f):
        return None
    w2, c = -derivative(law.f, q), -derivative(law.f, law.v)
    if (letters(w2) | letters(c)) & {*regime.letters, law.v}:
        return None
    w2, c = simplified(w2), simplified(c)
    forcing = simplified(expanded(law.f + w2 * q + c * law.v))
    settled = value.without(value.drawn)
    strength, damping = settled.known(w2), settled.known(c)
    if strength is None or damping is None or strength <= 0 or damping < 0 or _is_open(forcing, t, settled):
        return None
    # What only moves the midpoint, as dry friction does where it turns, leaves the frequency what it was.
    same = [x.natural for x in others if damping == 0 and x.ratio is None and x.free[0][1] == sp.sqrt(w2)]
    natural = same[0] if same else name("omega_n", "rad/s", positive=True)
    free = [(natural, sp.sqrt(w2))]
    ratio = damped = roots = None
    if damping > 0:
        ratio = name("zeta", "1", positive=True)
        free.append((ratio, c / (2 * natural)))
        inner = settled(w2 - c**2 / 4)
        if settled.is_zero(w2 - c**2 / 4):
            pass
        elif inner > 0:
            damped = name("omega_d", "rad/s", positive=True)
            free.append((damped, natural * sp.sqrt(1 - ratio**2)))
        else:
            roots = name("lambda_1", "1/s"), name("lambda_2", "1/s")
            root = sp.sqrt(ratio**2 - 1)
            free += [(roots[0], -natural * (ratio - root)), (roots[1], -natural * (ratio + root))]
    known = value.defining(dict(free))
    kept = _steady(forcing, law, t, (natural, ratio), known, name)
    return (
        None
        if kept is None
        else Vibration(natural, ratio, damped, roots, kept.formula, tuple(free), kept.lines, kept.rest)
    )


@record
class _Steady:
    """qp, its letters with their formulas, and that of the place of rest."""

    formula: sp.Expr
    lines: tuple[tuple[sp.Symbol, sp.Expr], ...]
    rest: tuple[sp.Symbol, ...]


def _is_open(forcing: sp.Expr, t: sp.Symbol, settled: Valuation) -> bool:
    """Does a letter without a number stand in it?"""
    return any(settled.known(s) is None for s in letters(forcing) - {t})


def _steady(
    forcing: sp.Expr,
    law: Law,
    t: sp.Symbol,
    own: tuple[sp.Symbol, sp.Symbol | None],
    value: Valuation,
    name: Callable[..., sp.Symbol],
) -> _Steady | None:
    """qp = q_eq + X_s sin(w t) + X_c cos(w t); what grows with t where it is driven at its own frequency. None: the
    force is of another kind.
    """
    terms = split(forcing, t)
    if terms is None or any(term.growth != 0 or len(term.powers) != 1 for term in terms):
        return None
    natural, ratio = own
    q, unit = law.coordinate.symbol, law.coordinate.unit
    constant = sp.Add(*(term.powers[0] for term in terms if term.phase == 0))
    rest = (name(f"{q.name}_eq", unit),) if constant != 0 else ()
    lines = [(letter, simplified(constant) / natural**2) for letter in rest]
    waves = [term for term in terms if term.phase != 0]
    steady: sp.Expr = sp.Add(*rest)
    if len({wave.phase for wave in waves}) > 1:
        return None
    if not waves:
        return _Steady(steady, tuple(lines), rest)
    phase = waves[0].phase
    w = simplified(sp.diff(phase, t))
    sine, cosine = (sp.Add(*(x.powers[0] for x in waves if x.sine == kind)) for kind in (True, False))
    distance, drag = natural**2 - w**2, 2 * natural * w * (ratio or 0)
    if value.is_zero(distance) and drag == 0:
        growing = t * (cosine * sp.sin(phase) - sine * sp.cos(phase)) / (2 * w)
        return _Steady(steady + simplified(growing), tuple(lines), rest)
    below = distance**2 + drag**2 if drag != 0 else distance
    above = (sine * distance + cosine * drag, cosine * distance - sine * drag) if drag != 0 else (sine, cosine)
    for letter, part, wave in zip(("X_s", "X_c"), above, (sp.sin(phase), sp.cos(phase)), strict=True):
        if part != 0:
            lines.append((name(letter, unit), simplified(part) / below))
            steady += lines[-1][0] * wave
    return _Steady(steady, tuple(lines), rest)
