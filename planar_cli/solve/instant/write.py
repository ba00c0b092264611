"""Planned candidates as equations in symbols: each with its left and right side, its law, its words and its source."""

from __future__ import annotations

from dataclasses import field, replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.cancelling import cancelled
from planar_cli.equation.algebra.expansion import expanded, wide
from planar_cli.equation.algebra.plain import longer, rounded_inside, tidy, trigonometric
from planar_cli.equation.kinematics.motion import Motion
from planar_cli.equation.scene.centres import centre_of
from planar_cli.equation.system.conditions import Condition
from planar_cli.equation.system.system import System
from planar_cli.equation.values.parts_of_accelerations import in_letters
from planar_cli.equation.values.waves import without_waves
from planar_cli.principles.base import Single
from planar_cli.problem.scene.facts import Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import changing
from planar_cli.solve.instant.candidates import CONTACT, Candidate, Choice
from planar_cli.solve.instant.carried_parts import carried_parts
from planar_cli.solve.instant.evident_sense import apart, as_counted, as_told, in_its_sense, with_the_motion
from planar_cli.solve.instant.led import led_by_ground, of_length
from planar_cli.solve.instant.lines_of_action import line_of
from planar_cli.solve.instant.named_parts import by_named
from planar_cli.solve.instant.numbers import Numbers, exact_number
from planar_cli.solve.instant.plan import bits
from planar_cli.solve.instant.reasons import acceleration_words
from planar_cli.solve.instant.recognised import recognised
from planar_cli.solve.instant.tangent_angle import of_groove
from planar_cli.solve.instant.without_arm import without_arm
from planar_cli.solve.instant.written import Explicit, Written, put_together

LETTERS, SMALL = "CKQSWZHJ", Decimal("1e-30")
MOST_READ = 60
"""A premise of more operations than this is not told."""
MOST_NORMAL = 3
"""So many parts of a mass centre's normal acceleration are drawn at most."""
LONGEST = 8
"""A coefficient of more operations than this is printed as a number."""


@changing
class Writer:
    """Writes the equations of one stage; numbers run through the whole solution.

    `lines`: explicit lines made on the way, in order. `centres`: constructed moment centres by name.
    """

    system: System
    numbers: Numbers
    next_number: int = 1
    allowed: set[sp.Symbol] = field(default_factory=set)
    lines: list[Explicit] = field(default_factory=list)
    centres: dict[str, tuple[Vec, tuple[sp.Symbol, ...]]] = field(default_factory=dict)
    named: dict[str, list[tuple[Vec, sp.Expr]]] = field(default_factory=dict)
    by_axes: frozenset[str] = frozenset()

    def number(self) -> int:
        self.next_number += 1
        return self.next_number - 1

    # --- numbers behind symbols --------------------------------------------------------------------------------------

    def vanishes(self, expr: sp.Expr) -> bool:
        """Is a form in the unknowns zero, coefficient by coefficient?"""
        return expr == 0 or not any(self.numbers.row(expr))

    def settled(self, expr: sp.Expr) -> sp.Expr:
        """The expression without unknowns whose coefficients cancel."""
        form = self.numbers.form(expr)
        terms = [c * x for x, c in form.terms.items() if self.numbers.value(c) and not self.numbers.value.is_zero(c)]
        constant = form.constant
        if constant.is_Add:
            constant = sp.Add(*(a for a in constant.args if not self.numbers.value.is_zero(a)))
        if constant != 0 and self.numbers.value.is_zero(constant):
            constant = sp.S.Zero
        return sp.Add(*terms, constant)

    @property
    def plain(self) -> bool:
        """May long coefficients be given as numbers? Not where letters stay, or where they hold what is sought."""
        letters = in_letters() or self.system.scene.ledger.symbolic
        return not letters and len(self.numbers.linear) == len(self.numbers.unknowns)

    def short(self, coefficient: sp.Expr) -> sp.Expr:
        """A coefficient in its plainest form; a long one as a number."""
        found = tidy(coefficient)
        if self.plain and not found.is_number and (longer(found, LONGEST) or rounded_inside(found)):
            simple = recognised(found, self.system.scene.ledger, self.numbers.value)
            return exact_number(self.numbers.value(found)) if simple is None else simple
        return found

    def arm(self, coefficient: sp.Expr) -> sp.Expr:
        """The arm or the share of a force: multiplied out, where that keeps its letters."""
        found = tidy(coefficient)
        spread = expanded(found) if longer(found, LONGEST) else found
        told = of_groove(found, self.system, self.numbers.value) if self.plain else None
        return told or self.short(coefficient if longer(spread, LONGEST) else spread)

    def shortened(self, expr: sp.Expr) -> sp.Expr:
        """A known side: powers of speeds stay visible, their long coefficients become numbers."""
        if not self.plain or not longer(expr, LONGEST):
            return tidy(expr)
        if wide(expr):
            return exact_number(self.numbers.value(expr))
        speeds = set(self.system.tree.velocity_unknowns())
        parts: dict[sp.Expr, list[sp.Expr]] = {}
        for term in sp.Add.make_args(expanded(expr)):
            kept, rest = sp.S.One, term
            if speeds & term.free_symbols:
                rest, kept = term.as_independent(*speeds)
            parts.setdefault(kept, []).append(rest)
        values = {kept: self.numbers.value(sp.Add(*rest)) for kept, rest in parts.items()}
        floor = max((abs(v) for v in values.values()), default=Decimal(0)) * SMALL
        return sp.Add(*(self.short(sp.Add(*rest)) * kept for kept, rest in parts.items() if abs(values[kept]) > floor))

    # --- accelerations of mass centres -------------------------------------------------------------------------------

    def acceleration(self, body: str) -> list[tuple[Vec, sp.Expr]]:
        """The acceleration of a mass centre as (direction, component) pairs; long components get a name and a line."""
        if body not in self.named:
            self.named[body] = self._name_acceleration(body)
        return self.named[body]

    def _name_acceleration(self, body: str) -> list[tuple[Vec, sp.Expr]]:
        motion = self.motion
        a = motion.acceleration(self.system.scene.center(body), body)
        x, y = self.settled(a.x), self.settled(a.y)
        if x == 0 and y == 0:
            return []
        components = next((e.components for e in self.system.tree.edges if e.body == body), None)
        if components is not None:
            ways = (components.axis, components.axis.turned())
            parts = [(way, self.settled(part)) for way, part in zip(ways, components.accelerations, strict=True)]
            signed = [(-way, -part) if part.could_extract_minus_sign() else (way, part) for way, part in parts]
            return [(way, part) for way, part in signed if part != 0]
        if carried := carried_parts(self.system, body, self.vanishes):
            return carried
        axes = [(Vec(sp.S.One, sp.S.Zero), x, "x"), (Vec(sp.S.Zero, sp.S.One), y, "y")]
        axes = [axis for axis in axes if axis[1] != 0]
        if len(axes) == 1:
            return [in_its_sense(self.system, body, axes[0][:2], self._component)]
        led = led_by_ground(self.system, body) if body in self.by_axes else ()
        for tangent in (*self.system.straight_ways(body), *led):
            if self.vanishes(a.cross(tangent)) or tangent in led:
                return [in_its_sense(self.system, body, (tangent, self._along(a, tangent)), self._component)]
        parts = self._vector_parts(x, y)
        if body not in self.by_axes and len({part.as_independent(*self.numbers.unknowns)[1] for _, part in parts}) <= 3:
            return parts
        return [(direction, self._component(body, expr, suffix)) for direction, expr, suffix in axes]

    def _vector_parts(self, x: sp.Expr, y: sp.Expr) -> list[tuple[Vec, sp.Expr]]:
        """An acceleration as vectors drawn one by one: a part for each unknown (a slide, the tangential part r α), and
        what is known (the normal parts r ω²).
        """
        form_x, form_y = self.numbers.form(x), self.numbers.form(y)
        parts = [
            (Vec(form_x.terms.get(unknown, sp.S.Zero), form_y.terms.get(unknown, sp.S.Zero)), unknown)
            for unknown in dict.fromkeys((*form_x.terms, *form_y.terms))
        ]
        parts = [*by_named(parts, self.lines), *self._normal_parts(Vec(form_x.constant, form_y.constant))]
        return [self._unit_part(Vec(self.short(v.x), self.short(v.y)) if size != 1 else v, size) for v, size in parts]

    def _normal_parts(self, v: Vec) -> list[tuple[Vec, sp.Expr]]:
        """The parts that velocities make: one for each ω², or product of two speeds; what is neither in one lump."""
        speeds = sorted(set(self.system.tree.velocity_unknowns()) & (v.x.free_symbols | v.y.free_symbols), key=str)
        found: dict[sp.Expr, list[sp.Expr]] = {}
        for i, part in enumerate((v.x, v.y)):
            for term in sp.Add.make_args(expanded(part)):
                rest, product = term.as_independent(*speeds) if speeds else (term, sp.S.One)
                found.setdefault(product, [sp.S.Zero, sp.S.Zero])[i] += rest
        arms = [(Vec(cancelled(x), cancelled(y)), product) for product, (x, y) in found.items()]
        arms = [(arm, p) for arm, p in arms if not (self.vanishes(arm.x) and self.vanishes(arm.y))]
        if len(arms) > MOST_NORMAL or any(p == 1 or p.is_Add for _, p in arms):
            lump = Vec(self.shortened(v.x), self.shortened(v.y))
            return [] if self.vanishes(lump.x) and self.vanishes(lump.y) else [(lump, sp.S.One)]
        return arms

    def _unit_part(self, v: Vec, size: sp.Expr) -> tuple[Vec, sp.Expr]:
        known = size != 1 and not v.x.has(sp.Add) and not v.y.has(sp.Add)
        length = self.system.scene.length(v) if known else None
        if length is None or longer(length, 4):
            return v, size
        return Vec(tidy(v.x / length), tidy(v.y / length)), length * size

    def _along(self, a: Vec, tangent: Vec) -> sp.Expr:
        """a · t where a is parallel to t."""
        along = self.settled(a.dot(tangent))
        form = self.numbers.form(along)
        terms = (trigonometric(expanded(c)) * x for x, c in form.terms.items())
        return sp.Add(*terms, trigonometric(expanded(form.constant)))

    def _component(self, body: str, expr: sp.Expr, axis: str) -> sp.Expr:
        if expr.is_Symbol or (-expr).is_Symbol:
            return expr
        scene = self.system.scene
        at = centre_of(scene, body)
        own = at.replace("_", ",")
        index = f"{own}_{axis}" if axis and own != at else f"{own}{axis}"
        form = self.numbers.form(expr)
        expr = sp.Add(*(self.short(c) * x for x, c in form.terms.items()), self.shortened(form.constant))
        symbol = scene.ledger.once(f"a_{index}", "m/s^2", expr)
        self.lines.append(Explicit(self.number(), symbol, expr, acceleration_words(self.system, body, at, axis, expr)))
        return symbol

    @property
    def motion(self) -> Motion:
        assert self.system.motion is not None
        return self.system.motion

    # --- kinetics ----------------------------------------------------------------------------------------------------

    def write(self, candidate: Candidate) -> Written:
        """The equation of a candidate; unknowns that it frees itself of are not written."""
        self.allowed = {self.numbers.unknowns[j] for j in bits(candidate.mask)}
        if candidate.single is not None:
            return self._single(candidate.single)
        if (condition := candidate.condition) is not None:
            return of_length(condition, self.system, self.number) or self._relation(condition, candidate.choice)
        assert candidate.choice is not None
        if candidate.choice.moment:
            return self._moment(candidate.bodies, candidate.choice)
        return self._force(candidate.bodies, candidate.choice)

    def _single(self, single: Single) -> Written:
        """An equation that a principle offers as a whole; premises too long to read are left out."""
        left, right = (self._one_side(e) for e in (single.left, single.right))
        read = tuple(p for p in single.premises if not longer(p.formula, MOST_READ))
        return Written(self.number(), "single", (), single.lead, single.words, left, right, "kinetics", premises=read)

    def _one_side(self, expr: sp.Expr) -> sp.Expr:
        """With short coefficients, without unknowns of which it is free."""
        form = self.numbers.form(expr)
        terms = [self.short(c) * x for x, c in form.terms.items() if not self.numbers.value.is_zero(c)]
        return sp.Add(*terms, sp.S.Zero if self.vanishes(form.constant) else self.shortened(form.constant))

    def _force(self, bodies: tuple[str, ...], choice: Choice) -> Written:
        d = with_the_motion(self.system, choice.vector, bodies, self.acceleration)
        left = self._loads(bodies, lambda point, force, couple: force.dot(d) if force is not None else sp.S.Zero)
        right = []
        for body in bodies:
            mass = self.system.scene.bodies[body].mass
            if mass != 0:
                parts = [(component, direction.dot(d)) for direction, component in self.acceleration(body)]
                right += [mass * component * self._factor(share) for component, share in parts]
        written = self._written("force", bodies, choice.name, choice.words, left, self.kept_lines(right))
        return replace(written, along=(d.x, d.y))

    def _factor(self, c: sp.Expr) -> sp.Expr:
        return (of_groove(c, self.system, self.numbers.value) if self.plain else None) or self.short(c)

    def _moment(self, bodies: tuple[str, ...], choice: Choice) -> Written:
        center, name = self._centre(bodies, choice)
        arm = self.system.scene.arms.between

        def moment(point: Vec, force: Vec | None, couple: Any) -> sp.Expr:
            return couple + (arm(center, point).cross(force) if force is not None else sp.S.Zero)

        left = self._loads(bodies, moment)
        parts = [part for body in bodies for part in self._inertia_terms(body, center, name, len(bodies) == 1)]
        right = self.kept_lines([force * about for force, about in parts])
        written = self._written("moment", bodies, name, choice.words, left, right)
        written = replace(written, armless=without_arm(parts, self.numbers.value, self.system.scene.ledger))
        return replace(written, moments=put_together(parts, written.right))

    def _inertia_terms(self, body: str, center: Vec, name: str, alone: bool) -> list[tuple[sp.Expr, sp.Expr]]:
        """m a_G and its arm, I α and 1; I_C α where C is a fixed point of the body."""
        model = self.system.scene.bodies[body]
        alpha = self.motion.accelerations[body].angular if model.rigid else sp.S.Zero
        if alone and model.rigid and alpha != 0 and model.mass != 0 and self._fixed(body, center):
            return [(self._inertia_about(body, center, name) * alpha, sp.S.One)]
        terms = [] if model.inertia == 0 or alpha == 0 else [(model.inertia * alpha, sp.S.One)]
        if model.mass != 0:
            arm = self.system.scene.arms.between(center, model.center)
            terms += [
                (model.mass * component, self.arm(arm.cross(direction)))
                for direction, component in self.acceleration(body)
            ]
        return terms

    def _fixed(self, body: str, center: Vec) -> bool:
        """Is it a pivot? About a point of contact that is only now at rest m a_G keeps its moment."""
        a = self.motion.acceleration(center, body)
        return self.vanishes(a.x) and self.vanishes(a.y) and self.system.is_pivot(body, center)

    def _inertia_about(self, body: str, center: Vec, name: str) -> sp.Expr:
        """I_G + m d², named."""
        model = self.system.scene.bodies[body]
        arm = self.system.scene.arms.between(center, model.center)
        square = trigonometric(tidy(arm.dot(arm)))
        if square == 0:
            return model.inertia
        title = f"moment of inertia of {body} about {name}, parallel axes"
        known = next((s for s, t in self.system.scene.ledger.titles.items() if t == title), None)
        if known is not None:
            return known
        whole = model.inertia + model.mass * square
        return self.system.scene.ledger.define(f"I_{name}", whole, "kg*m^2", title, positive=True)

    def _centre(self, bodies: tuple[str, ...], choice: Choice) -> tuple[Vec, str]:
        if choice.name:
            return choice.vector, choice.name
        place = choice.vector
        if choice.through:
            (p, d), (q, e) = (line_of(self.system, self.numbers, bodies, s) for s in choice.through)
            place = p + d * (tidy((q - p).cross(e)) / tidy(d.cross(e)))
        place = Vec(tidy(place.x), tidy(place.y))
        for name, (known, _) in self.centres.items():
            if all(self.numbers.value.is_zero(getattr(known, axis) - getattr(place, axis)) for axis in ("x", "y")):
                return known, name
        name = next(
            letter
            for letter in (*LETTERS, *(f"C_{i}" for i in range(99)))
            if letter not in {*self.system.scene.points, *self.system.scene.ledger.symbols, *self.centres}
        )
        place = Vec(self._short(place.x), self._short(place.y))
        self.centres[name] = (place, choice.through)
        return place, name

    def _short(self, expr: sp.Expr) -> sp.Expr:
        return exact_number(self.numbers.value(expr)) if longer(expr, 5) and self.plain else expr

    def _loads(self, bodies: tuple[str, ...], part: Any) -> list[sp.Expr]:
        """Every outer force and couple of a group, taken by `part`."""
        assert self.system.reactions is not None
        terms = [self._load_term(wrench, part) for wrench in self.system.wrenches if wrench.body in bodies]
        pulled: dict[frozenset[sp.Symbol], list[sp.Expr]] = {}
        for push, expr in self.system.reactions.pushes:
            inside = [a for a in push.actions if a.body in bodies]
            if inside:
                term = expr * self.arm(sp.Add(*(part(a.point, a.force, a.couple) for a in inside)))
                pulled.setdefault(frozenset(expr.free_symbols & set(self.numbers.unknowns)), []).append(term)
        for together in pulled.values():
            # A slipping contact is one line of action: its parts count together.
            if not self.vanishes(sp.Add(*together)):
                terms += together
        return self.kept_lines(terms)

    def _load_term(self, wrench: Wrench, part: Any) -> sp.Expr:
        """What a load contributes: its magnitude times a short coefficient."""
        if wrench.magnitude != 0 and wrench.force is not None and wrench.couple == 0:
            direction = Vec(cancelled(wrench.force.x / wrench.magnitude), cancelled(wrench.force.y / wrench.magnitude))
            if not (direction.x.free_symbols | direction.y.free_symbols) & wrench.magnitude.free_symbols:
                return wrench.magnitude * self.arm(part(wrench.point, direction, 0))
        return tidy(part(wrench.point, wrench.force, wrench.couple))

    def kept_lines(self, terms: list[sp.Expr]) -> list[sp.Expr]:
        """Drop terms that vanish; explicit lines count with what they stand for."""
        inside = {line.symbol: line.expression for line in self.lines}
        return [t for t in terms if t != 0 and not self.vanishes(t.xreplace(inside))]

    def _without_cancelled(self, sides: tuple[list[sp.Expr], list[sp.Expr]]) -> tuple[list[sp.Expr], list[sp.Expr]]:
        """Terms of unknowns that the equation is free of are left out, where they cancel among themselves."""
        inside = {line.symbol: line.expression for line in self.lines}
        foreign = set(self.numbers.unknowns) - self.allowed

        def gone(term: sp.Expr) -> bool:
            held = term.xreplace(inside).free_symbols & set(self.numbers.unknowns)
            return bool(held) and held <= foreign

        rest = sp.Add(*(t for t in sides[0] if gone(t)), *(-t for t in sides[1] if gone(t))).xreplace(inside)
        if rest != 0 and any(abs(c) > SMALL for c in self.numbers.row(rest)):
            return sides
        return [t for t in sides[0] if not gone(t)], [t for t in sides[1] if not gone(t)]

    def _written(
        self, law: str, bodies: tuple[str, ...], lead: str, words: str, left: list[sp.Expr], right: list[sp.Expr]
    ) -> Written:
        left, right = self._without_cancelled((left, right))
        return Written(self.number(), law, bodies, lead, words, sp.Add(*left), sp.Add(*right), "kinetics")

    # --- relations ---------------------------------------------------------------------------------------------------

    def _relation(self, condition: Condition, choice: Choice | None) -> Written:
        if isinstance(condition.residual, Vec):
            assert choice is not None
            residual = condition.residual.dot(choice.vector)
            along = (choice.vector.x, choice.vector.y)
            words = f"{condition.text}, {choice.words}" if condition.kind != "closure" else choice.words
        else:
            residual, words, along = condition.residual, "", None
        form = self.numbers.form(residual := self.settled(residual))
        made = without_waves if choice is not None and choice.words == CONTACT else sp.sympify
        left = [self.short(made(c)) * x for x, c in form.terms.items()]
        right = -self.shortened(form.constant)
        left, right = as_told(*left) if len(left) == 2 and right == 0 else (left, right)
        unknowns = set(self.numbers.unknowns)
        left, right = (left, right) if left else apart(self.shortened(residual), unknowns)
        given = condition.kind == "given" and len(form.terms) == 1
        left, right = as_counted(left, right, given and not right.free_symbols & unknowns, self.system)
        datum = given and sp.Add(*left).is_Symbol
        written = Written(
            self.number(), "relation", (), condition.text, words, sp.Add(*left), right, condition.kind, datum
        )
        return replace(written, along=along, place=condition.place, times=condition.times)
