"""Of what an angular momentum is made, and an impulse that varies in time, before their balance.

v_G = -R ω (rolling),   H_C = I_G ω - m R v_G,   ∫ΣM dt = ∫[0 → t_2] -q (R + r) t dt
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.system.setup import ANGULAR_IMPULSE
from planar_cli.principles.base import Moving
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, line
from planar_cli.report.energy.energy_pieces import STATE
from planar_cli.report.in_numbers.put_in import put_in
from planar_cli.report.kinetics.inertias import inertia_of
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.words.counted import counts_the_other_way
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import BalanceTrace
from planar_cli.units import ANGULAR_MOMENTUM, IMPULSE, RATE, VELOCITY, Dimension

SHORT = 12
"""Longer velocities, momenta and impulses stand in the balance alone."""
OPPOSITE = str.maketrans("↑→", "↓←")


@record
class MomentumTelling:
    """Tells what one balance of momenta is made of. `unknowns`: what it is solved for; `plain`: letters that are data;
    `told`: what was told before.
    """

    balance: BalanceTrace
    unknowns: Collection[sp.Symbol]
    phrases: Phrases
    plain: Mapping[sp.Symbol, sp.Expr]
    told: set[sp.Symbol]

    def lines(self) -> Iterator[Block]:
        """The momentum at the end, of one body that turns, or that alone of several has mass; and the impulse."""
        yield from self.speeds()
        if self.balance.law.about and (only := self._only()) is not None:
            yield from self._momentum(only)
        if self.balance.impulse is not None and self.balance.gain != 0:
            yield from self._impulse(self.balance.impulse)

    def speeds(self) -> Iterator[Equation]:
        """The speed of that body by the speed of another one, unless it was told."""
        if (only := self._only()) is not None:
            yield from self._led(only)

    def _only(self) -> Moving | None:
        """The body that turns, or that alone of several has mass; None: several do."""
        parts = self.balance.parts
        moving = [] if parts is None else [m for m in parts.moving if m.mass != 0 or self.balance.law.about]
        return moving[0] if len(moving) == 1 else None

    def _led(self, made: Moving) -> Iterator[Equation]:
        """What the balance counts by the speed of another body: turning, or going along one axis."""
        omega, stop = self._put(made.omega), self.balance.stop
        along = [v for v in (self._put(made.vx), self._put(made.vy)) if v != 0]
        name = f"omega_{made.body}" if self.balance.law.about else f"v_{made.center or made.body}"
        own, expr = sp.Symbol(f"{name}{STATE}{stop}", real=True), omega
        if not self.balance.law.about:
            expr = along[0] if len(along) == 1 else sp.S.Zero
        dimension = RATE if self.balance.law.about else VELOCITY
        if own in self.told or expr in (0, own) or (expr.is_Symbol and not self.balance.law.about):
            return
        whose = {str(s).partition(STATE)[0].partition("_")[2] for s in expr.free_symbols if STATE in s.name}
        if (
            not {"", made.body} & whose
            and not longer(expr, SHORT)
            and is_clean(self.phrases.ledger, expr, dimension=dimension)
        ):
            self.told.add(own)
            yield Equation((Math(own), self.phrases.math(expr)), None, note=line(made.why))

    def _momentum(self, made: Moving) -> Iterator[Block]:
        """Where the velocity of the mass centre rests on that of turning: both momenta, then their sum."""
        after, omega = self._put(self.balance.after), self._put(made.omega)
        along = [v for v in (self._put(made.vx), self._put(made.vy)) if v != 0]
        if len(along) != 1 or not omega.is_Symbol or omega not in along[0].free_symbols or made.inertia == 0:
            return
        own = sp.Symbol(f"v_{made.center or 'G'}{STATE}{self.balance.stop}", real=True)
        if made.mass == 0:
            return
        arm = simplified((after - self._put(made.inertia) * omega) / (self._put(made.mass) * along[0]))
        inertia = inertia_of(made.body, made.inertia, self.phrases)
        whole = sp.Add(inertia * omega, made.mass * arm * own, evaluate=False)
        if own in self.told or any(longer(e, SHORT) for e in (arm, along[0], whole)) or arm.free_symbols & {omega}:
            return
        if not is_clean(self.phrases.ledger, along[0], dimension=VELOCITY) or arm.is_number:
            return
        self.told.add(own)
        yield Equation((Math(own), self.phrases.math(along[0])), None, note=line(made.why))
        amount = line(Name(f"{self.balance.law.name}__{self.balance.stop}"))
        yield Equation((amount, self.phrases.math(whole), self.phrases.math(after)))

    def _impulse(self, integral: sp.Expr) -> Iterator[Block]:
        """As an integral, and its value."""
        gain = self._put(self.balance.gain)
        about = f"angular impulse about {self.balance.law.about}" if self.balance.law.about else "impulse"
        dimension = ANGULAR_MOMENTUM if self.balance.law.about else IMPULSE
        put = integral.xreplace(dict(self.plain))
        clean = is_clean(self.phrases.ledger, gain, dimension=dimension)
        if longer(put.args[0], SHORT):
            return
        if not clean or longer(gain, SHORT):
            yield from self._in_numbers(line(about), put, gain, dimension, clean)
            return
        sides: list[Any] = [line(about), self.phrases.math(put), self.phrases.math(gain)]
        if not gain.free_symbols & set(self.unknowns) and not self.phrases.symbolic:
            told = all(self.phrases.has_numbers(s) for s in gain.free_symbols)
            value = self.phrases.value.known(gain) if told else None
            shown = [] if value is None else [self.phrases.of_dimension(value, dimension)]
            usual = bool(self.balance.law.about) and not self.phrases.ledger.us
            # A number is not written twice, bare and with its unit.
            sides = sides[:2] if gain.is_number and shown else sides
            sides += [replace(v, unit=ANGULAR_IMPULSE) if usual else v for v in shown]
        yield Equation(tuple(sides))

    def _in_numbers(
        self, about: Line, put: sp.Expr, gain: sp.Expr, dimension: Dimension, clean: bool
    ) -> Iterator[Block]:
        """Of a law in numbers with the time alone: ∫[0 → t_2] (20 - 4 t) dt = 20 t_2 - 2 t_2², in N·s; where the time
        is known, beside letters too: ∫[0 → t_2] (m g - 4 t) dt = 9.31 N·s. `clean`: no number hides a unit.
        """
        varies, (time, *_) = put.args[0].free_symbols, put.args[1]
        data = self.phrases.ledger.values.keys() - {time}
        open_ = gain.free_symbols & set(self.unknowns)
        lettered = bool((varies | (gain.free_symbols - open_)) & data)
        if self.phrases.symbolic or (lettered and (open_ or clean)):
            return
        if open_:
            found = put_in(sp.expand(gain), sp.S.Zero, self.unknowns, self.phrases, dimension)
            if found is not None:
                yield Equation((about, self.phrases.math(put), found.left), None, (), found.note)
        elif (value := self.phrases.value.known(gain)) is not None:
            note = line("t in s") if lettered else ()
            yield Equation((about, self.phrases.math(put), self.phrases.of_dimension(value, dimension)), None, (), note)

    def _put(self, expr: sp.Expr) -> sp.Expr:
        put = sp.sympify(expr).xreplace(dict(self.plain))
        return put if longer(put, SHORT * 4) else simplified(put)


def in_its_sense(b: BalanceTrace, put: Callable[[sp.Expr], sp.Expr]) -> BalanceTrace:
    """The balance of a linear momentum, counted the other way where all its terms, or both momenta, are negative.
    `put`: what is known put in.
    """
    if b.law.letter or b.law.name:
        return b
    before, gain, after = put(b.before), put(b.gain), put(b.after)
    against = after != 0 and counts_the_other_way(before, after, moments=False)
    if not against and not counts_the_other_way(before + gain, after, moments=False):
        return b
    return replace(
        b,
        law=replace(b.law, lead=b.law.lead.translate(OPPOSITE)),
        before=-b.before,
        after=-b.after,
        brought=tuple((words, -e) for words, e in b.brought),
        amounts=tuple((body, -e) for body, e in b.amounts),
        impulse=None if b.impulse is None else _opposite(b.impulse),
    )


def _opposite(impulse: sp.Expr) -> sp.Expr:
    """An integral of what counts the other way."""
    return sp.Integral(-impulse.function, *impulse.limits) if isinstance(impulse, sp.Integral) else -impulse
