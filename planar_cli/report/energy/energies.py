"""A balance of energies told as the course writes it: T of every body, U of every force, each with its number.

v_G and ω by the unknown speed, T = m v_G²/2 + I ω²/2;  U = m g (y_1 - y_2);  stretches, U = k (s_1² - s_2²)/2
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.common_factors import together
from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.principles.base import Moving, Storage
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, line
from planar_cli.report.energy.alike import told_of_each, weights_of_each
from planar_cli.report.energy.centre_speeds import centre_lines
from planar_cli.report.energy.common_centre import common_centre
from planar_cli.report.energy.energy_pieces import SHORT, STATE, fits, has_number_root, has_root
from planar_cli.report.energy.parallel_axes import by_parallel_axes
from planar_cli.report.energy.standing import standing_lines
from planar_cli.report.energy.weights import WeightTelling
from planar_cli.report.energy.works import work_integral
from planar_cli.report.in_numbers.in_numbers import SMALL
from planar_cli.report.kinematics.centre_reasons import reason_of
from planar_cli.report.kinetics.inertias import inertia_of
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.units import (
    INERTIA,
    LENGTH,
    MASS,
    RATE,
    STIFFNESS,
    VELOCITY,
)

FEW = 8  # With more operations a speed is told in numbers.
NARROW = 60
"""Characters of a chain beside its words."""
UNITS = {"v": ("m/s", VELOCITY), "omega": ("rad/s", RATE)}


@record
class EnergyTelling(WeightTelling):
    """Tells the parts of one balance, one after the other."""

    def lines(self) -> Iterator[Block]:
        """T at the beginning and at the end, and what every source brings."""
        b = self.balance
        first, last = f"{b.law.letter}__{b.since}", f"{b.law.letter}__{b.stop}"
        amounts = [(body, put) for body, e in b.amounts if not self._vanishes(put := self._put(e))]
        sources = [(words, put) for words, e in b.brought if not self._vanishes(put := self._put(e))]
        shared = common_centre(self, sources)
        yield from () if shared is None else [shared.place(self)]
        resting = list(standing_lines(self))
        still = not amounts and not resting and self._put(b.before) == 0
        if still:
            yield self._at_rest(first, last)
        elif self._put(b.before) != 0 or (sp.Symbol(first, real=True), sp.S.Zero) not in self.told:
            yield self._once(first, self._put(b.before))
        self._note("before", self._put(b.before))
        yield from resting
        bodies = told_of_each(amounts)
        for i, (body, put) in enumerate(amounts):
            self._note(f"T of {body}", put)
            if i in bodies:
                each = f" of {bodies[i]}" if len(amounts) > 1 else ""
                yield from self._amount(body, put, line(Name(last), each))
        if not amounts and not still:
            yield self._at_rest(last, last)
        elif len(amounts) > 1 and not (self.bare and self._is_sought(self._put(b.after))):
            yield self._line(line(Name(last)), *self._summed(self._put(b.after)))
        springs = sum(s.power == 2 for s in b.parts.storages) if b.parts is not None else 0
        told = weights_of_each(sources)
        for i, (words, put) in enumerate(sources):
            self._note(f"U of {words}", put)
            if shared is not None and i in shared.indices:
                yield from shared.lines(self) if i == shared.indices[0] else ()
            elif i in told:
                yield from self._brought(words, put, springs > 1, told[i])

    def _at_rest(self, *names: str) -> Equation:
        """T_1 = T_2 = 0; of a state of which that was said, the other one."""
        own = {name: (sp.Symbol(name, real=True), sp.S.Zero) for name in names}
        new = [name for name in names if own[name] not in self.told] or names[1:]
        self.told.update(own.values())
        return Equation((*(line(Name(name)) for name in new), self.phrases.math(sp.S.Zero)))

    def _once(self, name: str, put: sp.Expr) -> Equation:
        """A kinetic energy with its formula and numbers; where these stand above, its value."""
        sides, own = self._chain(put), (sp.Symbol(name, real=True), put)
        if own in self.told and len(sides) > 2:
            return Equation((line(Name(name)), sides[-1]), None, (), line("as above"))
        self.told.add(own)
        return self._line(line(Name(name)), *sides)

    def _note(self, words: str, put: sp.Expr) -> None:
        """An energy by letters that have their lines, unless heights or stretches of its own are told."""
        about = self._about_axis(put)
        self.letters[words] = about if about is not None else put if put == 0 or self._short(put) else None

    # --- kinetic energies --------------------------------------------------------------------------------------------

    def _amount(self, body: str, put: sp.Expr, lead: Line) -> Iterator[Block]:
        """T of one body at the end: from the speed of its mass centre and of turning, in a line before."""
        made = next((m for m in self.balance.parts.moving if m.body == body), None) if self.balance.parts else None
        speeds = [] if made is None else list(self._speeds(made))
        turning = any(has_root(e) for _, _, e in speeds) and self._about_axis(put) is not None
        at_sight = len(speeds) == 1 and self._short(put) and not self._by_others(speeds[0][2])
        if made is None or not speeds or at_sight or turning:
            yield self._line(lead, *self._chain(put))
            return
        told = [(Math(own), *self._speed(expr, kind, made)) for kind, own, expr in speeds if own != expr]
        # The size of a letter may be told by that letter.
        told = [(own, *others) for own, *others in told if others != [own]]
        why = reason_of(made, self.phrases) if speeds[0][0] == "v" else ()
        if len(self.balance.amounts) > 1 and (axis := by_parallel_axes(self, made, speeds)) is not None:
            self.letters[f"T of {body}"] = put if self._short(put) else axis
            told_at_once = self._line(lead, *self._fitting(Math(axis), put))
            yield replace(told_at_once, note=line(*told_at_once.note, "; ", *why) if told_at_once.note else why)
            return
        # A ball's mass centre goes round a trough whether it rolls or not; that it rolls says how it turns.
        reason = 1 if len(told) > 1 and made.rolls else 0
        yield from self._centre_lines(made)
        if len(told) > 1 and fits(tuple(side for sides in told for side in sides)):
            (one, *first), (two, *second) = told
            yield Equation((line(one), line(*_chained(first), ",  ", two, " = ", *_chained(second))), None, note=why)
        else:
            # The speed of the last state may be a letter that has been told: a package that goes with its belt.
            for i, sides in enumerate(told):
                yield self._speed_line(sides, why if i == reason and self._explains(sides) else ())
        masses, texts = {"v": made.mass, "omega": inertia_of(made.body, made.inertia, self.phrases)}, {}
        for kind, dimension in (("v", MASS), ("omega", INERTIA)):
            if not is_clean(self.phrases.ledger, masses[kind], dimension=dimension):
                number = sp.Symbol(f"{NUMBER}{kind}", positive=True)
                texts[number] = significant(self.phrases.value(masses[kind]), self.phrases.figures)
                masses[kind] = number
        terms = (masses[kind] * own**2 / 2 for kind, own, _ in speeds)
        formula = sp.Add(*(simplified(t) if not longer(t, SHORT) else t for t in terms), evaluate=False)
        self.letters[f"T of {body}"] = put if self._short(put) else None if texts else formula
        yield self._line(lead, *self._fitting(Math(formula, texts) if texts else self.phrases.math(formula), put))

    @staticmethod
    def _explains(sides: tuple[Any, ...]) -> bool:
        """Is there more than a value beside a speed, of which a reason could be told?"""
        return any(isinstance(s, Math) and s.expr.free_symbols for s in sides[1:])

    def _speed_line(self, sides: tuple[Any, ...], why: Line) -> Equation:
        """One speed, with its unit where numbers stand beside an unknown, and why it is so."""
        if sides[0].expr.name.startswith("omega"):
            return Equation(sides, None, note=why)
        told = self._line(*sides, dimension=VELOCITY)
        return replace(told, note=line(*told.note, "; ", *why) if told.note and why else told.note or why)

    def in_letters(self, bodies: Sequence[str], put: sp.Expr, lead: Line) -> Iterator[Block]:
        """T of one body, or of each of several, at the end where everything is a letter, after the speeds:
        T = m v_G²/2 + I ω²/2 = formula.
        """
        moving = self.balance.parts.moving if self.balance.parts is not None else ()
        told = [(made, list(self._speeds(made))) for made in moving if made.body in bodies]
        exprs = [expr for _, speeds in told for _, _, expr in speeds]
        at_sight = all(len(speeds) == 1 for _, speeds in told) and all((e**2).args[:1][0].is_Symbol for e in exprs)
        if not exprs or at_sight or any(longer(e, SHORT) for e in exprs):
            yield Equation((lead, self.phrases.math(put)))
            return
        for made, speeds in told:
            why = reason_of(made, self.phrases)
            shown = [
                (kind, own, self._signed(expr))
                for kind, own, expr in speeds
                if own != expr and (kind == "v" or not (expr**2).args[:1][0].is_Symbol)
            ]
            reason = "omega" if made.rolls and any(kind == "omega" for kind, _, _ in shown) else "v"
            for kind, own, expr in shown:
                explains = kind == reason and expr.free_symbols
                yield Equation((Math(own), self.phrases.math(expr)), None, note=why if explains else ())
        made, speeds = told[0]
        masses = {"v": made.mass, "omega": inertia_of(made.body, made.inertia, self.phrases)}
        formula = sp.Add(*(masses[kind] * own**2 / 2 for kind, own, _ in speeds), evaluate=False)
        # Of equal bodies the letters of one would not do for the others.
        formulas = (self.phrases.math(formula),) if len(told) == 1 else self._alike(told)
        yield Equation((lead, *formulas, self.phrases.math(put)))

    def _alike(self, told: Sequence[tuple[Moving, list[tuple[str, sp.Symbol, sp.Expr]]]]) -> tuple[Line, ...]:
        """1/2 m (1/2 l θ̇)² + 1/2 (1/12 m l²) θ̇² of bodies of which that is the same; empty: it is not, or is long."""
        found = set()
        for made, speeds in told:
            size = {kind: -e if e.could_extract_minus_sign() else e for kind, _, e in speeds}
            inertia = self.phrases.ledger.behind(made.inertia) if made.inertia.is_Symbol else made.inertia
            found.add((made.mass, size.get("v", sp.S.Zero), inertia, size.get("omega", sp.S.Zero)))
        mass, v, inertia, omega = next(iter(found))
        if len(found) > 1 or any(e == 0 or longer(e, FEW) for e in (mass, v, inertia, omega)):
            return ()
        m, speed, i = (self._as_factor(e) for e in (mass, v, inertia))
        return (line("1/2 ", *m, " ", *speed, "² + 1/2 ", *i, " ", self.phrases.math(omega**2)),)

    def _as_factor(self, expr: sp.Expr) -> Line:
        """A letter as it is, more in brackets."""
        told = self.phrases.math(expr)
        return line(told) if expr.is_Symbol else line("(", told, ")")

    def _centre_lines(self, made: Moving) -> Iterator[Block]:
        """The place of a mass centre and its rates, where its speed is a root of both."""
        speed = next((expr for kind, _, expr in self._speeds(made) if kind == "v"), sp.S.Zero)
        moving = [s for s in speed.free_symbols if s in self.unknowns]
        if len(moving) == 1 and has_root(speed) and self._components(made, speed, moving) is not None:
            name = f"{self.centre(made)}{{}}"
            yield from centre_lines(made, name, moving[0], self._put, self.phrases)

    def _by_others(self, expr: sp.Expr) -> bool:
        """Is a speed more than the size of the one that is sought or known?"""
        return not (expr.is_Symbol or (isinstance(expr, sp.Abs) and expr.args[0].is_Symbol))

    def _speeds(self, made: Moving) -> Iterator[tuple[str, sp.Symbol, sp.Expr]]:
        """The speed of the mass centre and that of turning, those that are not zero."""
        stop = self.balance.stop
        vx, vy = self._put(made.vx), self._put(made.vy)
        square = vx**2 + vy**2
        v = sp.sqrt(square if longer(square, SHORT * 4) else simplified(square))
        # A sum along an axis has the sign that it has in the kinematics; what is a product at sight is a speed.
        v = along if 0 in (vx, vy) and ((along := vx + vy).is_Add or _is_times_a_sum(along)) else v
        for kind, mass, name, expr in (
            ("v", made.mass, f"v_{self.centre(made)}", v),
            ("omega", made.inertia, f"omega_{made.body}", _collected(self._put(made.omega))),
        ):
            if mass != 0 and not self._vanishes(expr):
                own = expr if expr.is_Symbol else sp.Symbol(f"{name}{STATE}{stop}", real=True)
                yield kind, *self._named(own, expr, made)

    def _named(self, own: sp.Symbol, expr: sp.Expr, made: Moving) -> tuple[sp.Symbol, sp.Expr]:
        """A speed with the sign of the letter that the motion has for it, or of the rate that it is found by; where the
        letter is something else, another name.
        """
        known = self.phrases.value.known(own)
        if known is None:
            if made.rolls and not made.omega.is_Add and (made.omega**2).args[:1][0].is_Symbol:
                return own, expr
            # v = l θ̇, whichever way it swings: as the kinematics have it.
            return own, expr.replace(
                lambda x: isinstance(x, sp.Abs) and x.args[0] in self.unknowns, lambda x: x.args[0]
            )
        size = self.phrases.value(expr)
        if abs(abs(known) - abs(size)) > abs(size) * SMALL:
            return sp.Symbol(f"{own.name[0]}_G_{made.body}{STATE}{self.balance.stop}", real=True), expr
        return own, expr if known * size >= 0 else -expr

    def _speed(self, expr: sp.Expr, kind: str, made: Moving) -> tuple[Any, ...]:
        """A speed in letters where they are few, else in numbers; the root of c u² is √c u, with the sign that makes
        it positive. One that is no product is told by its components.
        """
        moving = [s for s in expr.free_symbols if s in self.unknowns]
        if isinstance(expr, sp.Abs):
            expr = self._signed(expr)
        if len(moving) == 1 and self._linear(expr, moving[0]):
            u = moving[0]
            factor = (expr / u).xreplace({u: sp.Integer(1 if self.phrases.value(u) >= 0 else -1)})
            expr = self._signed(factor if longer(factor, SHORT) else simplified(factor)) * u
        unit, dimension = UNITS[kind]
        few = not longer(expr, FEW) and self._short(expr, dimension) and not expr.has(sp.Abs)
        letters = (self.phrases.math(expr),) if few else ()
        last = self._summed(expr, unit)
        components = self._components(made, expr, moving) if kind == "v" and has_root(expr) else None
        if components is not None:
            return self.phrases.math(components), *(() if self.bare and moving else last)
        if few and moving:
            numbers = not self.bare and (expr.has(sp.sin, sp.cos, sp.tan) or has_root(expr))
            return (*letters, *last) if numbers else letters
        return (*letters, *(self.phrases.substituted(expr, last[0]) if few else ()), *last)

    def _components(self, made: Moving, expr: sp.Expr, moving: Collection[sp.Symbol]) -> sp.Expr | None:
        """√(v_x² + v_y²) with both in letters, without what is the same of both; None: that is long."""
        parts = [self._put(e) for e in (made.vx, made.vy)]
        (u, *more) = moving or (sp.S.One,)
        if more or any(e == 0 or longer(e, SHORT) or not self._short(e, VELOCITY) for e in parts):
            return None
        parts = [simplified(e / u) for e in parts]
        if any(e.free_symbols & set(moving) for e in parts):
            return None
        squares = sp.Add(*(sp.Pow(e, 2, evaluate=False) for e in parts), evaluate=False)
        sense = 1 if u == 1 or self.phrases.value(u) * self.phrases.value(expr) >= 0 else -1
        return sp.Mul(sense * u, sp.sqrt(squares, evaluate=False), evaluate=False)

    def _signed(self, expr: sp.Expr) -> sp.Expr:
        """|a| with the sign that a has."""

        def sized(x: sp.Abs) -> sp.Expr:
            inside = x.args[0]
            known = self.phrases.value.known(inside)
            return x if known is None else inside if known >= 0 else -inside

        return expr.replace(lambda x: isinstance(x, sp.Abs), sized) if expr.has(sp.Abs) else expr

    def _linear(self, expr: sp.Expr, u: sp.Symbol) -> bool:
        """Is it |u| or u times something without u?"""
        ratio, own = expr / u, sp.Rational(str(self.phrases.value(u)))
        if own == 0:
            return False
        here = [self.phrases.value(ratio.xreplace({u: own * k})) for k in (1, 2)]
        return abs(here[0] - here[1]) <= abs(here[0]) * SMALL

    # --- work --------------------------------------------------------------------------------------------------------

    def _brought(self, words: str, put: sp.Expr, several: bool, each: str) -> Iterator[Block]:
        """U of one source. `several`: springs, whose stretches need names of their own; `each`: of which it is said."""
        lead = line(Name(self.balance.law.bring), f" of the {each}")
        storages = self.balance.parts.storages if self.balance.parts is not None else ()
        made = next((s for s in storages if s.words == words), None)
        if made is None or (made.power == 2 and self._at_sight(made, put)):
            whole = () if made is not None else work_integral(self.balance, words, self.plain, self.phrases)
            sides = self._chain(put)
            lettered = self.bare and isinstance(sides[0], Math) and not fits(sides)
            yield self._line(lead, *whole, *(sides[:1] if lettered else sides))
        elif made.power == 1:
            yield from self._weight(made, put, lead)
        else:
            yield from self._spring(made, put, lead, several, each)

    def _at_sight(self, made: Storage, put: sp.Expr) -> bool:
        """Is a spring at its own length in one state, and its stretch in the other a letter or a difference of two?"""
        ends = [self._put(made.first), self._put(made.last)]
        return self._short(put) and sp.S.Zero in ends and not any(longer(e, 1) or e.is_number for e in ends if e != 0)

    def _spring(self, made: Storage, put: sp.Expr, lead: Line, several: bool, each: str) -> Iterator[Block]:
        """k (s_1² - s_2²)/2, the stretches in lines of their own, each once."""
        letter = "delta" if made.letter in self.phrases.ledger.symbols else made.letter
        name = made.words.rpartition(" ")[2]
        ends = {}
        for state, expr in ((self.balance.since, made.first), (self.balance.stop, made.last)):
            own = sp.Symbol(f"{letter}_{name}{STATE}{state}" if several else f"{letter}{STATE}{state}", real=True)
            ends[own] = self._as_drawn(self._put(expr))
            if (own, ends[own]) not in self.told:
                self.told.add((own, ends[own]))
                yield self._stretch(line(f"stretch of the {each}, ", Math(own)), made, state, ends[own])
        one, two = ends
        inside = sp.Add(one**2, -(two**2), evaluate=False)
        factor, sizes = self._factor(made, STIFFNESS)
        told = sp.Mul(sp.Rational(1, 2), factor, inside, evaluate=False)
        self.letters[f"U of {made.words}"] = None if sizes else told
        shown = self._numbers(put, self._with(told, ends, sizes))
        if self.bare and self._is_sought(put) and operations(put) > operations(told):
            shown = ()
        yield self._line(lead, self._lettered(told, sizes), *shown)

    def _stretch(self, lead: Line, made: Storage, state: str, stretch: sp.Expr) -> Equation:
        """s_1 = CB_1 - l_0 = formula = number, where the spring has a natural length; of none that it is nought."""
        name, natural = self.springs.get(made.words, ("", None))
        letter = sp.Symbol(f"{name}{STATE}{state}", positive=True)
        terms = sp.Add.make_args(stretch)
        differs = natural is not None and not stretch.is_Symbol and not any(t.has(natural) for t in terms)
        length = (Math(sp.Add(letter, -natural, evaluate=False)),) if differs else ()
        if not self._is_sought(stretch) and self.phrases.value.is_zero(stretch):
            why = line("the spring is relaxed")
            return Equation((lead, *length, self.phrases.math(sp.S.Zero)), None, note=why)
        sides = self._length(stretch)
        if length and has_number_root(stretch) and not self._is_sought(stretch):
            own = self._with(
                sp.Add(letter, -natural, evaluate=False), {letter: stretch + natural, natural: natural}, {}
            )
            sides = (*own, sides[-1])
        length = length if fits((*length, *sides), NARROW) else ()
        return self._line(lead, *length, *sides, dimension=LENGTH)


def _collected(omega: sp.Expr) -> sp.Expr:
    """-(R - r) φ̇/r rather than φ̇ - R φ̇/r."""
    if not omega.is_Add or not sp.fraction(together(omega))[1].free_symbols:
        return omega
    return factored(omega)


def _is_times_a_sum(speed: sp.Expr) -> bool:
    """Is it r ω (tan β cos θ - sin θ)?"""
    waves = any(total.has(sp.sin, sp.cos, sp.tan) for total in speed.atoms(sp.Add))
    return bool(speed.is_Mul) and waves and all(p.exp.is_Integer for p in speed.atoms(sp.Pow))


def _chained(sides: Sequence[Any]) -> list[Any]:
    return [x for i, side in enumerate(sides) for x in ((" = ", side) if i else (side,))]
