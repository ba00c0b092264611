"""All candidates of one instant: every connected group of bodies, every loop and relation, with the multipliers that
free an equation of unknown pushes.

Killed are only lines that a teacher draws: reactions, edges of friction cones, m a of known direction; never a couple
of inertia. Two killed lines give a moment centre, or a direction when they are parallel; both are one operation, the
cross product of two wrenches.
"""

from __future__ import annotations

from collections.abc import Iterable
from decimal import Decimal
from functools import cached_property, partial

import sympy as sp

from planar_cli.equation.algebra.cancelling import cancelled
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import longer, tidy
from planar_cli.equation.scene.centres import centre_of
from planar_cli.equation.system.conditions import Condition
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import CERTAIN, ONE, ZERO
from planar_cli.principles.base import BodyFamily, Family, Single
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record
from planar_cli.solve.instant import candidates as c
from planar_cli.solve.instant.candidates import Candidate, Choice, combine, cross3, priced
from planar_cli.solve.instant.drawn_ways import goes_round, named_ways
from planar_cli.solve.instant.lines_of_action import line_of
from planar_cli.solve.instant.numbers import Numbers
from planar_cli.solve.instant.pressed_across import pressed_across_lines
from planar_cli.solve.multibody.linear import Row

MOST_GROUPS = 72
CLOSE = Decimal("1e-30")
"""Points that lie so near each other, in units of the scene, are one."""
Three = tuple[Decimal, Decimal, Decimal]


@record
class Group:
    """A connected group of bodies: its three rows (Σ F_x, Σ F_y, Σ M about the origin, less inertia), and which columns
    are lines of force that may be killed: their wrenches (f_x, f_y, m).
    """

    bodies: tuple[str, ...]
    rows: tuple[Row, Row, Row]
    lines: dict[int, Three]
    turning: bool


class Offers:
    """Makes all candidates of a system. `families`: what a principle offers, beside the relations of motion;
    `constructed`: centres as well. `most`: so many equations of a group in the same unknowns.
    """

    constructed = True
    most = 1

    def __init__(
        self, system: System, numbers: Numbers, conditions: list[Condition], families: Iterable[Family]
    ) -> None:
        self.system, self.numbers, self.conditions = system, numbers, conditions
        every = list(families)
        self.families = {f.body: f for f in every if isinstance(f, BodyFamily)}
        self.singles = [f for f in every if isinstance(f, Single)]
        self.scene = system.scene
        self.index = {x: j for j, x in enumerate(numbers.unknowns)}
        self._residuals: dict[str, tuple[Row, Row, Row]] = {}
        self._aside: dict[str, bool] = {}
        self._spins = {self.index[e.spin_rate]: e.body for e in system.tree.edges if e.spin_rate in self.index}
        self._moved: dict[sp.Symbol, set[str]] = {}

    def all(self) -> list[Candidate]:
        found: list[Candidate] = []
        for condition in self.conditions:
            found += self.of_condition(condition)
        for single in self.singles:
            row = self.numbers.row(single.left - single.right)
            found += c.cheapest([priced((), None, None, row, single.cost, single)])
        for group in self.groups() if self.families else ():
            found += self.of_group(group)
        return found

    # --- relations of motion -----------------------------------------------------------------------------------------

    def of_condition(self, condition: Condition) -> list[Candidate]:
        """A scalar relation as it is; a vector one along the axes, and across each unknown's direction."""
        residual = condition.residual
        if not isinstance(residual, Vec):
            return c.cheapest([priced((), condition, None, self.numbers.row(residual), c.AXIS)])
        if condition.normal is not None:
            choice = Choice(False, condition.normal, f"across the path of {condition.place}")
            return c.cheapest([priced((), condition, choice, self.numbers.row(residual.dot(condition.normal)), c.AXIS)])
        x, y = self.numbers.row(residual.x), self.numbers.row(residual.y)
        axes = ("x", Vec(sp.S.One, sp.S.Zero), x), ("y", Vec(sp.S.Zero, sp.S.One), y)
        found = [priced((), condition, Choice(False, way, f"along {n}", (), n), row, c.AXIS) for n, way, row in axes]
        if condition.along is not None:
            way = self._onward(condition.along)
            contact = self.numbers.row(residual.dot(way))
            found.append(priced((), condition, Choice(False, way, c.CONTACT), contact, c.ALONG_CONTACT))
        form_x, form_y = self.numbers.form(residual.x), self.numbers.form(residual.y)
        for j, symbol in enumerate(self.numbers.unknowns):
            if not (x[j] and y[j]) or (symbol not in form_x.terms and symbol not in form_y.terms):
                continue
            if any(x[j] * b == y[j] * a and (a or b) for a, b in zip(x[j + 1 :], y[j + 1 :], strict=True)):
                # Another one of the same direction is nearer to the end of the chain, where the condition is.
                continue
            across = Vec(-form_y.terms.get(symbol, sp.S.Zero), form_x.terms.get(symbol, sp.S.Zero))
            row = combine((x, y), (-y[j], x[j]))
            if (across.x.free_symbols | across.y.free_symbols) & self._bent:
                # What multiplies holds unknowns itself: slopes are those of the product.
                row = list(self.numbers.row(tidy(expanded(residual.dot(across)))))
            row[j] = ZERO
            words = f"so that {symbol.name} drops out"
            choice = Choice(False, partial(self._direction, across), words, (symbol,))
            found.append(priced((), condition, choice, row, c.ACROSS))
        return c.cheapest(found, self.most)

    def _onward(self, way: Vec) -> Vec:
        """A line's direction, to the right or upwards."""
        x, y = self.numbers.value(way.x), self.numbers.value(way.y)
        return -way if (x if abs(x) > abs(y) else y) < 0 else way

    @cached_property
    def _bent(self) -> set[sp.Symbol]:
        """Unknowns that enter some equation otherwise than linearly."""
        return set(self.numbers.unknowns) - self.numbers.linear

    def _direction(self, across: Vec) -> Vec:
        """A projection that drops one unknown, scaled to a unit vector where its length is simple."""
        length = self.scene.length(across)
        if longer(length, 4):
            return across
        return Vec(*(cancelled(p) if p.free_symbols else p for p in (across.x / length, across.y / length)))

    # --- groups of bodies --------------------------------------------------------------------------------------------

    def groups(self) -> list[Group]:
        """Connected groups, the smallest first; all of them where they are few."""
        neighbours = self.neighbours()
        bodies = self.bodies
        found: list[frozenset[str]] = [frozenset([b]) for b in bodies]
        seen, layer = set(found), list(found)
        while layer and len(found) < MOST_GROUPS:
            grown = []
            for group in layer:
                for body in sorted((set().union(*(neighbours[b] for b in group)) & set(bodies)) - group):
                    larger = group | {body}
                    if larger not in seen:
                        seen.add(larger)
                        grown.append(larger)
            found += grown[: MOST_GROUPS - len(found)]
            layer = grown[:MOST_GROUPS]
        whole = frozenset(bodies)
        if whole not in seen:
            found.append(whole)
        single = {b: self.body_rows(b) for b in bodies}
        return [self._group(tuple(b for b in bodies if b in g), single) for g in found]

    def neighbours(self) -> dict[str, set[str]]:
        found: dict[str, set[str]] = {b: set() for b in self.scene.bodies}
        for push in self.system.pushes:
            bodies = {a.body for a in push.actions if a.body != GROUND}
            for b in bodies:
                found[b] |= bodies - {b}
        for wrench in self.system.wrenches:
            pair = (wrench.kind, wrench.name)
            others = {w.body for w in self.system.wrenches if wrench.name and (w.kind, w.name) == pair}
            found[wrench.body] |= (others & set(found)) - {wrench.body}
        return found

    @property
    def bodies(self) -> list[str]:
        """The bodies of which there are families, in the order of the file."""
        return [b for b in self.scene.bodies if b in self.families]

    def body_rows(self, body: str) -> tuple[Row, Row, Row]:
        """The family of one body, in numbers."""
        if body not in self._residuals:
            family = self.families[body]
            self._residuals[body] = (
                self.numbers.row(family.x),
                self.numbers.row(family.y),
                self.numbers.row(family.moment),
            )
        return self._residuals[body]

    def base_rows(self) -> list[Row]:
        """The rows of which all candidates are made: three of each body in turn, then the other equations."""
        rows = [row for b in self.bodies for row in self.body_rows(b)]
        singles = (self.numbers.row(s.left - s.right) for s in self.singles)
        return [
            *rows,
            *singles,
            *(self.numbers.row(expr) for condition in self.conditions for expr in condition.rows()),
        ]

    def _group(self, bodies: tuple[str, ...], single: dict[str, tuple[Row, Row, Row]]) -> Group:
        ones = [ONE] * len(bodies)
        x, y, m = (combine([single[b][i] for b in bodies], ones) for i in range(3))
        lines: dict[int, Three] = {}
        for j in self._killable(bodies):
            wrench = (x[j], y[j], m[j])
            if wrench[0] or wrench[1]:
                lines[j] = wrench
        turning = any(self.scene.rigid(b) for b in bodies) and not any(self._pressed_aside(b) for b in bodies)
        return Group(bodies, (x, y, m), lines, turning)

    def _pressed_aside(self, body: str) -> bool:
        """Does a force act on a particle elsewhere than at its place? Then a couple that nobody asks for holds it."""
        if self.scene.rigid(body):
            return False
        if body not in self._aside:
            self._aside[body] = self._asides(body)
        return self._aside[body]

    def _asides(self, body: str) -> bool:
        center = self.scene.center(body)
        points = [a.point for p in self.system.pushes for a in p.actions if a.body == body]
        return any(not self._same(p, center) for p in points)

    def _same(self, a: Vec, b: Vec) -> bool:
        return self.scene.is_zero(a.x - b.x) and self.scene.is_zero(a.y - b.y)

    def _killable(self, bodies: tuple[str, ...]) -> list[int]:
        """Columns that are drawn as one line: reactions, and the part of m a that has a known direction."""
        forces = [self.system.symbols[p.name] for p in self.system.pushes if p.unit != "N*m"]
        found = [self.index[symbol] for symbol in forces if symbol in self.index]
        for edge in self.system.tree.edges:
            slides = edge.slide_rate is not None and edge.joining is not None
            if slides and edge.slide_rate in self.index and self._only_translation(edge.slide_rate, bodies):
                found.append(self.index[edge.slide_rate])
        return found

    def _only_translation(self, symbol: sp.Symbol, bodies: tuple[str, ...]) -> bool:
        """Does the unknown move just one body of the group?"""
        if symbol not in self._moved:
            assert self.system.motion is not None
            center, motion = self.scene.center, self.system.motion
            ways = {b: motion.acceleration(center(b), b) for b in self.scene.bodies}
            self._moved[symbol] = {b for b, a in ways.items() if symbol in a.x.free_symbols | a.y.free_symbols}
        return len(self._moved[symbol].intersection(bodies)) <= 1

    def of_group(self, group: Group) -> list[Candidate]:
        """Axes, named points, directions across a line, intersections of two lines."""
        found = self._along_axes(group)
        for direction, words in named_ways(self.system, self.numbers, group.bodies):
            found.append(self._force(group, direction, words, self._form_along(words, group)))
        if not group.turning or (group.bodies[1:] and not self._crossed.isdisjoint(group.bodies)):
            return c.cheapest(found, self.most)
        named = self._named_points(group)
        for name, place in named.items():
            found.append(self._moment(group, place, name, c.NAMED_POINT))
        if not self.constructed:
            return c.cheapest(found, self.most)
        points = [(self.numbers.value(place.x), self.numbers.value(place.y)) for place in named.values()]
        lines = [(j, a) for j, a in group.lines.items() if not self._pulls_apart(group, self.numbers.unknowns[j])]
        for i, (j, a) in enumerate(lines):
            found.append(self._across(group, j, a))
            for k, b in lines[i + 1 :]:
                found.append(self._crossing(group, (j, a), (k, b), points))
        return c.cheapest(found, self.most)

    @cached_property
    def _crossed(self) -> frozenset[str]:
        """Particles about whose arms nobody asks."""
        return pressed_across_lines(self.system)

    def along_axes(self, bodies: tuple[str, ...]) -> list[Candidate | None]:
        """The sums of forces on bodies along x and y, whatever else is offered; None: nothing is left of one."""
        return self._along_axes(self._group(bodies, {b: self.body_rows(b) for b in bodies}))

    def about(self, body: str, place: Vec, name: str) -> Candidate | None:
        """The sum of moments on one body about a point; None: nothing is left of it."""
        return self._moment(self._group((body,), {body: self.body_rows(body)}), place, name, c.NAMED_POINT)

    def _along_axes(self, group: Group) -> list[Candidate | None]:
        ways = ("x", Vec(sp.S.One, sp.S.Zero)), ("y", Vec(sp.S.Zero, sp.S.One))
        return [self._force(group, way, name, c.AXIS) for name, way in ways]

    def _form_along(self, words: str, group: Group) -> float:
        """How it is drawn: along a contact or tie; also across a tie that leads a particle on an arc."""
        drawn = words.startswith("along") or goes_round(self.system, group.bodies)
        return c.ALONG_CONTACT if drawn else c.NAMED_SLANT

    def _force(self, group: Group, direction: Vec, words: str, form: float) -> Candidate | None:
        row = combine(group.rows[:2], (self.numbers.value(direction.x), self.numbers.value(direction.y)))
        row = self.numbers.with_turning(row, group.rows[:2], (direction.x, direction.y))
        choice = Choice(False, direction, words, (), words if words in "xy" else "")
        return priced(group.bodies, None, choice, row, c.of_whole(self.scene, group.bodies, form))

    def _moment(self, group: Group, place: Vec, name: str, form: float) -> Candidate | None:
        row = combine(group.rows, (self.numbers.value(place.y), -self.numbers.value(place.x), ONE))
        # About a pin the α of another body may happen to cancel, which moves the group towards it or away.
        pinned = any(p.place == name for p in self.system.pushes)
        if self._percussion(group, row, [j for j, b in self._spins.items() if b in group.bodies or not pinned]):
            return None
        return priced(group.bodies, None, Choice(True, place, "", (), name), row, form)

    def _percussion(self, group: Group, row: Row, spins: Iterable[int]) -> bool:
        """Does inertia cancel about this point? Nobody looks for a centre of percussion to be rid of α."""
        return any(not row[j] and any(r[j] for r in group.rows) for j in spins)

    def _named_points(self, group: Group) -> dict[str, Vec]:
        found: dict[str, Vec] = {}
        for name, owners in self.scene.owners.items():
            if set(owners) & set(group.bodies):
                found[name] = self.scene.point(name)
        for body in group.bodies:
            if self.scene.rigid(body):
                found.setdefault(centre_of(self.scene, body), self.scene.center(body))
        for push in self.system.pushes:
            for action in push.actions:
                if action.body in group.bodies and push.place in self.scene.points:
                    found.setdefault(push.place, self.scene.point(push.place))
        return found

    def _across(self, group: Group, j: int, line: Three) -> Candidate | None:
        """The force direction across one line."""
        if not (line[0] and line[1]):
            return None
        row = combine(group.rows[:2], (-line[1], line[0]))
        row[j] = ZERO
        symbol = self.numbers.unknowns[j]
        return priced(
            group.bodies,
            None,
            Choice(False, partial(self._across_line, group, symbol), f"across {symbol.name}", (symbol,)),
            row,
            c.ACROSS,
        )

    def _pulls_apart(self, group: Group, symbol: sp.Symbol) -> bool:
        """Does a tie pull bodies of the group in several directions? Nobody draws the resultant of these."""
        every = self.system.reactions.pushes if self.system.reactions else ()
        pulls = [push for push, expr in every if push.kind == "tension" and symbol in expr.free_symbols]
        forces = [a.force for push in pulls for a in push.actions if a.body in group.bodies and a.force is not None]
        return any(abs(self.numbers.value(forces[0].cross(f))) > CERTAIN for f in forces[1:])

    def _crossing(
        self, group: Group, first: tuple[int, Three], second: tuple[int, Three], points: list[tuple[Decimal, Decimal]]
    ) -> Candidate | None:
        """Moments about the intersection of two lines, or the force direction across two parallel ones."""
        (j, a), (k, b) = first, second
        multiplier = cross3(a, b)
        size = max(abs(p) for p in multiplier)
        if not size or not multiplier[2]:
            return None
        x, y = -multiplier[1] / multiplier[2], multiplier[0] / multiplier[2]
        tiny = CLOSE * self._scale
        if any(abs(px - x) <= tiny and abs(py - y) <= tiny for px, py in points):
            return None
        row = combine(group.rows, (y, -x, ONE))
        row[j] = row[k] = ZERO
        if self._percussion(group, row, self._spins):
            return None
        symbols = (self.numbers.unknowns[j], self.numbers.unknowns[k])
        form = c.CONSTRUCTED if max(abs(x), abs(y)) < 8 * self._scale else c.FAR
        return priced(group.bodies, None, Choice(True, Vec(None, None), "", symbols), row, form)

    @cached_property
    def _scale(self) -> Decimal:
        """The size of the scene: its largest coordinate."""
        places = [self.numbers.value(p) for v in self.scene.points.values() for p in (v.x, v.y)]
        return max((abs(p) for p in places), default=ONE) or ONE

    def _across_line(self, group: Group, symbol: sp.Symbol) -> Vec:
        """The direction across the line of an unknown on this group."""
        return line_of(self.system, self.numbers, group.bodies, symbol)[1].turned()
