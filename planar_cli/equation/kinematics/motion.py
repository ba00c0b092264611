"""Velocities and accelerations of all bodies in terms of a few natural unknowns, along a tree of joints.

Each body hangs on the tree by the joint that leaves it the least freedom: by a pin it adds its angular velocity, by a
guide the speed of the slide, free bodies two components and a rotation. Joints that are left over close loops.

    v_P = v_A + ω k × r_P/A                          a_P = a_A + α k × r_P/A - ω² r_P/A
    slide along a path of the base b:  v = v_b + s t,  a = a_b + ṡ t + κ s² n + 2 ω_b s n     (n = k × t)
    rolling contact:  v_C = v_C' , a_C = a_C' + (ω_b - ω_a)²/(κ_a - κ_b) n

(An Introduction to Planar Dynamics, 2.2 - 2.4.)
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Container, Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.kinematics.components import Components, component
from planar_cli.equation.values.ledger import Kind, Ledger, Role
from planar_cli.equation.values.parts_of_accelerations import CORIOLIS, NORMAL, TANGENTIAL, with_mark
from planar_cli.problem.scene.facts import Joining, Path, Row
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.going import AGAINST, Going
from planar_cli.problem.scene.led_by_ground import led_by_ground
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record

ZERO = sp.S.Zero
STILL = Vec(ZERO, ZERO)


@record
class Twist:
    """Motion of a body: velocity (or acceleration) of its material point at `point`, and ω (or α)."""

    point: Vec
    linear: Vec
    angular: sp.Expr


@record
class Edge:
    """How a body hangs on the tree: by a joining (None: free), from which body, with which new unknowns.

    `backward`: the joining's base hangs on its mover. `spin`, `slide`: velocity unknowns; `spin_rate`, `slide_rate`:
    acceleration unknowns. A free body has `slide` along x and `rise` along y; one that
    the file places by coordinates has none of its own (`components`). `particle`: it does not turn with its parent.
    `turn`: -1 where `spin` and `spin_rate` count clockwise; `upward`: -1 where `rise` and `rise_rate` count downward;
    `rightward`: -1 where `slide` and `slide_rate` of a free body count to the left.
    """

    body: str
    parent: str
    joining: Joining | None
    backward: bool = False
    spin: sp.Symbol | None = None
    spin_rate: sp.Symbol | None = None
    slide: sp.Symbol | None = None
    slide_rate: sp.Symbol | None = None
    rise: sp.Symbol | None = None
    rise_rate: sp.Symbol | None = None
    particle: bool = False
    components: Components | None = None
    turn: int = 1
    upward: int = 1
    rightward: int = 1


@record
class Tree:
    """All edges in the order in which bodies are placed, and the joinings that are left over."""

    edges: tuple[Edge, ...]
    closures: tuple[Joining, ...]

    def turn(self, bodies: Collection[str]) -> int:
        """-1 where the rotations of these bodies count clockwise, else 1."""
        turns = {e.turn for e in self.edges if e.body in bodies and e.spin is not None}
        return -1 if turns == {-1} else 1

    @property
    def clockwise(self) -> frozenset[str]:
        """The bodies whose rotations count clockwise."""
        return frozenset(e.body for e in self.edges if e.turn < 0)

    def velocity_unknowns(self) -> tuple[sp.Symbol, ...]:
        return tuple(s for e in self.edges for s in (e.slide, e.rise, e.spin) if s is not None)

    def acceleration_unknowns(self) -> tuple[sp.Symbol, ...]:
        return tuple(s for e in self.edges for s in (e.slide_rate, e.rise_rate, e.spin_rate) if s is not None)


class TreeBuilder:
    """Chooses the tree and makes its unknowns; names that are asked for again give the same symbol."""

    def __init__(
        self,
        ledger: Ledger,
        rigid: Callable[[str], bool],
        center_name: Callable[[str], str],
        bodies: Iterable[str],
        components: Mapping[str, Components] | None = None,
        heading: Callable[[str, Path], int] | None = None,
    ) -> None:
        """`heading`: does a body move forward on a path, +1, or back, -1? 0: that is not known."""
        self.ledger, self.rigid, self.center_name, self.bodies = ledger, rigid, center_name, tuple(bodies)
        self.components, self.heading = components or {}, heading
        self.clockwise: frozenset[str] = frozenset()
        """Bodies whose angular velocities count clockwise where they hang on the tree."""
        self.going: Mapping[str, Going] = {}
        """Bodies that go straight on: of what nothing carries, velocity and acceleration count the way it goes."""
        self.oblique: Mapping[str, Vec] = {}
        """In a blow, particles that strike something oblique, with the tangent there."""
        self.known_senses: frozenset[str] = frozenset()
        """Bodies that are known to begin to turn in the sense in which their angular velocities count."""
        self.pivots_first = False  # does a rocker hang on its own pivot, v_C = ω × r_C/D, and not on the chain?
        self._made: dict[tuple[str, str], sp.Symbol] = {}
        self.titles: dict[sp.Symbol, str] = {}

    def build(self, joinings: Iterable[Joining], hang: bool = True) -> Tree:
        """The tree over these joinings; with `hang` False every body is free."""
        left = list(joinings)
        placed = {GROUND}
        edges = [Edge(b, GROUND, None, particle=True, components=s) for b, s in self._placed_by_coordinates(left, hang)]
        placed |= {e.body for e in edges}
        while len(placed) <= len(self.bodies):
            choice = self._choose(left, placed) if hang else None
            if choice is None:
                body = next(b for b in self._by_ties(left) if b not in placed)
                way = self.going.get(body) if hang else None
                edges.append(self._free(body, *((1, 1) if way is None else way.senses)))
            else:
                joining, body = choice
                left.remove(joining)
                edges.append(self._hung(body, joining, {e.slide for e in edges}))
            placed.add(edges[-1].body)
        return Tree(tuple(edges), tuple(left))

    def _placed_by_coordinates(self, joinings: list[Joining], hang: bool) -> Iterator[tuple[str, Components]]:
        """Particles that the file places by coordinates and that are joined to nothing that moves."""
        for body, components in self.components.items() if hang else ():
            partners = {b for j in joinings if body in (j.mover, j.base) for b in (j.mover, j.base)}
            if partners <= {body, GROUND}:
                yield body, components

    def _by_ties(self, left: list[Joining]) -> list[str]:
        """Bodies that others are joined to come first."""
        ties = {b: sum(b in (j.mover, j.base) for j in left) for b in self.bodies}
        return sorted(self.bodies, key=lambda b: -ties[b])

    def _choose(self, left: list[Joining], placed: set[str]) -> tuple[Joining, str] | None:
        """The joining with the least freedom that hangs a new body on what is placed; of a wheel that of its axle."""
        best: tuple[tuple[bool, int, bool, int], Joining, str] | None = None
        for rank, joining in enumerate(left):
            for body, parent in ((joining.mover, joining.base), (joining.base, joining.mover)):
                if parent in placed and body not in placed:
                    later = parent != GROUND and joining.rolling is not None and led_by_ground(left, body)
                    pinned = parent == GROUND and joining.only_turns and self.pivots_first
                    cost = (later, self._freedom(joining, body), not pinned, rank)
                    if best is None or cost < best[0]:
                        best = (cost, joining, body)
        return None if best is None else (best[1], best[2])

    def _freedom(self, joining: Joining, body: str) -> int:
        return (joining.path is not None) + (joining.turns and self.rigid(body))

    def _symbol(self, name: str, unit: str, title: str, kind: Kind) -> sp.Symbol:
        if (name, title) not in self._made:
            symbol = self._made[name, title] = self.ledger.fresh(name, unit, role=Role(kind))
            self.titles[symbol] = title
        return self._made[name, title]

    def _pair(
        self, index: str, speed: str, rate: str, *, turns: bool = False, bent: bool = False
    ) -> tuple[sp.Symbol, sp.Symbol]:
        """A velocity unknown and the acceleration unknown that goes with it. `speed`, `rate`: what they are; `bent`: on
        a curved path the rate of the speed is the tangential acceleration only.
        """
        stems, per = (("omega", "alpha"), "rad") if turns else (("v", "a"), "m")
        names = [f"{stem}_{index}" if index else stem for stem in stems]
        names[1] += "_t" if bent else ""
        return (
            self._symbol(names[0], f"{per}/s", speed, Kind.SPEED),
            self._symbol(names[1], f"{per}/s^2", rate, Kind.ACCELERATION),
        )

    def spin_of(self, body: str) -> tuple[sp.Symbol, sp.Symbol]:
        """ω and α of a body; without an index where only one body turns, and the file calls nothing else so."""
        alone = sum(self.rigid(b) for b in self.bodies) == 1 and self.ledger.reserved.isdisjoint(("omega", "alpha"))
        words = f"angular velocity of {body}", f"angular acceleration of {body}"
        return self._pair("" if alone else body, *words, turns=True)

    def _free(self, body: str, rightward: int, upward: int) -> Edge:
        name = self.center_name(body) or body
        (v_x, a_x), (v_y, a_y) = (
            self._pair(index, *(f"{what} of {name} {way}" for what in ("velocity", "acceleration")))
            for axis, sense in (("x", rightward), ("y", upward))
            for way, index in ([(f"along {axis}", component(name, axis)) if sense > 0 else (AGAINST[axis], name)])
        )
        spin, rate = self.spin_of(body) if self.rigid(body) else (None, None)
        senses = -1 if body in self.clockwise else 1, upward, rightward
        return Edge(body, GROUND, None, False, spin, rate, v_x, a_x, v_y, a_y, False, None, *senses)

    def _hung(self, body: str, joining: Joining, taken: Container[sp.Symbol | None]) -> Edge:
        """A body that hangs on what is placed. `taken`: speeds of others, which may slide at the same place."""
        backward = body == joining.base
        parent = joining.mover if backward else joining.base
        turns = (joining.turns or not (self.rigid(parent) or joining.keeps)) and self.rigid(body)
        spin, rate = self.spin_of(body) if turns else (None, None)
        slide = slide_rate = None
        if joining.path is not None:
            joining = self._onward(joining, body, joining.path)
            place, base = joining.place, joining.base
            if backward and joining.far and not self.rigid(body):
                # v_B = v_A + v_B/A: it is placed by the mover, over which the base's own speed is counted.
                place, base = joining.far, joining.mover
            name = place if base == GROUND else f"{place}_{base}"
            seen = "" if base == GROUND else f" seen from {base}"
            path = f"of {place} along its path{seen}"
            bent = joining.path is not None and joining.path.curvature != 0
            slide, slide_rate = self._pair(name, f"speed {path}", f"acceleration {path}", bent=bent)
            if slide in taken:
                path = f"of {body} along its path{seen}"
                slide, slide_rate = self._pair(body, f"speed {path}", f"acceleration {path}", bent=bent)
        own, turn = not self.rigid(body), -1 if body in self.clockwise else 1
        return Edge(body, parent, joining, backward, spin, rate, slide, slide_rate, particle=own, turn=turn)

    def _onward(self, joining: Joining, body: str, path: Path) -> Joining:
        """The same joining with a path in space the way the body moves on it."""
        fixed = self.heading is not None and joining.base == GROUND and body == joining.mover
        back = fixed and self.heading is not None and self.heading(body, path) < 0
        return replace(joining, path=Path(-path.tangent, -path.curvature)) if back else joining


def _spin_rate(edge: Edge) -> sp.Expr:
    """α counterclockwise; 0 of what can not turn."""
    return ZERO if edge.spin_rate is None else edge.spin_rate * edge.turn


class Motion:
    """Velocities and accelerations of any material point, as expressions in the unknowns of a tree.

    `known`: values of velocity unknowns that are settled (zero above all); they are put in at once, so that
    accelerations carry no terms that vanish. `center`: the mass centre of a body; `arm`: from one place to another.
    """

    def __init__(
        self,
        tree: Tree,
        center: Callable[[str], Vec],
        arm: Callable[[Vec, Vec], Vec],
        known: dict[sp.Symbol, sp.Expr],
    ) -> None:
        self.tree, self.center, self.arm, self.known = tree, center, arm, known
        self.velocities: dict[str, Twist] = {GROUND: Twist(STILL, STILL, ZERO)}
        self.accelerations: dict[str, Twist] = {GROUND: Twist(STILL, STILL, ZERO)}
        for edge in tree.edges:
            self._place(edge)

    def _v(self, symbol: sp.Symbol | None) -> sp.Expr:
        return ZERO if symbol is None else self.known.get(symbol, symbol)

    def _spin(self, edge: Edge) -> sp.Expr:
        """ω counterclockwise."""
        return self._v(edge.spin) * edge.turn

    def _settled(self, v: Vec) -> Vec:
        return Vec(v.x.xreplace(self.known), v.y.xreplace(self.known)) if self.known else v

    def _place(self, edge: Edge) -> None:
        at = self.center(edge.body)
        if edge.components is not None:
            own = edge.components
            self.velocities[edge.body] = Twist(at, self._settled(own.vector(own.velocities)), ZERO)
            self.accelerations[edge.body] = Twist(at, self._settled(own.vector(own.accelerations)), ZERO)
            return
        if edge.joining is None:
            velocity = Vec(self._v(edge.slide) * edge.rightward, self._v(edge.rise) * edge.upward)
            self.velocities[edge.body] = Twist(at, velocity, self._spin(edge))
            acceleration = Vec((edge.slide_rate or ZERO) * edge.rightward, (edge.rise_rate or ZERO) * edge.upward)
            self.accelerations[edge.body] = Twist(at, acceleration, _spin_rate(edge))
            return
        point, sign = edge.joining.point, -1 if edge.backward else 1
        parent_spin, parent_rate = self.velocities[edge.parent].angular, self.accelerations[edge.parent].angular
        omega = ZERO if edge.particle else self._spin(edge) if edge.spin is not None else parent_spin
        alpha = ZERO if edge.particle else _spin_rate(edge) if edge.spin_rate is not None else parent_rate
        base_spin = omega if edge.backward else parent_spin
        mover_spin = parent_spin if edge.backward else omega
        speed, pace = self._v(edge.slide), edge.slide_rate or ZERO
        velocity = self.velocity(point, edge.parent) + self._relative(edge.joining, speed, base_spin) * sign
        bend = self.relative_acceleration(edge.joining, speed, pace, base_spin, mover_spin)
        acceleration = self.acceleration(point, edge.parent) + bend * sign
        self.velocities[edge.body] = Twist(point, velocity, omega)
        self.accelerations[edge.body] = Twist(point, acceleration, alpha)

    @staticmethod
    def _relative(joining: Joining, speed: sp.Expr, base_spin: sp.Expr) -> Vec:
        relative = joining.path.tangent * speed if joining.path is not None else STILL
        return relative + joining.drift if joining.drift is not None else relative

    @staticmethod
    def relative_acceleration(
        joining: Joining, speed: sp.Expr, pace: sp.Expr, base_spin: sp.Expr, mover_spin: sp.Expr
    ) -> Vec:
        """Relative and Coriolis acceleration of the mover's point over the base's, or that of rolling outlines."""
        if joining.pace is not None:
            demanded: Vec = joining.pace + (joining.path.tangent * pace if joining.path is not None else STILL)
            return demanded
        if joining.path is not None:
            t = joining.path.tangent
            bend = with_mark(joining.path.curvature * speed**2, NORMAL) + with_mark(2 * base_spin * speed, CORIOLIS)
            along: Vec = t * pace + t.turned() * bend
            return along
        carried = (
            joining.drift.turned() * with_mark(2 * base_spin, CORIOLIS)
            if joining.drift is not None and base_spin != 0
            else STILL
        )
        if joining.rolling is not None:
            roll = joining.rolling
            difference = base_spin - mover_spin
            if roll.mover - roll.base == 0 or difference == 0:
                return carried
            bend = with_mark(difference**2 / (roll.mover - roll.base), NORMAL)
            rolled: Vec = carried + roll.tangent.turned() * bend
            return rolled
        return carried

    # --- what principles and quantities ask --------------------------------------------------------------------------

    def velocity(self, point: Vec, body: str) -> Vec:
        """v of the material point of `body` at `point`."""
        twist = self.velocities[body]
        if twist.angular == 0:
            return twist.linear
        found: Vec = twist.linear + self.arm(twist.point, point).turned() * twist.angular
        return found

    def acceleration(self, point: Vec, body: str) -> Vec:
        """a of the material point of `body` at `point`."""
        twist, omega = self.accelerations[body], self.velocities[body].angular
        found, arm = twist.linear, self.arm(twist.point, point)
        if twist.angular != 0:
            found = found + arm.turned() * with_mark(twist.angular, TANGENTIAL)
        return found if omega == 0 else found - arm * with_mark(omega**2, NORMAL)

    def row_velocity(self, row: Row) -> sp.Expr:
        """Left minus right side of a row, at velocity level."""
        return self._row(row, self.velocity, self.velocities) - row.rate

    def row_acceleration(self, row: Row) -> sp.Expr:
        """The rate of a row: the same on accelerations, plus the turning of its free segments."""
        found = self._row(row, self.acceleration, self.accelerations) - row.pace
        for s in row.segments:
            if s.length is None:
                continue
            across = (self.velocity(s.end.point, s.end.body) - self.velocity(s.start.point, s.start.body)).dot(
                s.direction.turned()
            )
            if across != 0:
                found += with_mark(across**2 / s.length, NORMAL)
        if row.sharpening != 0:
            speed = sp.Add(*(self.velocity(p.anchor.point, p.anchor.body).dot(p.direction) for p in row.slides))
            found -= row.sharpening * speed**2
        return found

    @staticmethod
    def _row(row: Row, of: Callable[[Vec, str], Vec], twists: dict[str, Twist]) -> sp.Expr:
        parts: list[Any] = [of(p.anchor.point, p.anchor.body).dot(p.direction) for p in row.pulls]
        parts += [twists[body].angular * factor for body, factor in row.spins]
        for s in row.segments:
            parts.append((of(s.end.point, s.end.body) - of(s.start.point, s.start.body)).dot(s.direction))
        return sp.Add(*parts)

    def slide_speed(self, joining: Joining) -> sp.Expr:
        """The speed of the mover's point along the path, seen from the base."""
        if joining.path is None:
            return ZERO
        relative = self._gap(joining, self.velocity)
        if joining.drift is not None:
            relative = relative - joining.drift
        return relative.dot(joining.path.tangent)

    def _gap(self, joining: Joining, of: Callable[[Vec, str], Vec]) -> Vec:
        return of(joining.point, joining.mover) - of(joining.point, joining.base)

    def closure_velocity(self, joining: Joining) -> Vec:
        """Relative velocity that a closing joint forbids (along its path: free)."""
        gap = self._gap(joining, self.velocity)
        return gap - joining.drift if joining.drift is not None else gap

    def closure_acceleration(self, joining: Joining) -> Vec:
        """Relative acceleration less its bend and Coriolis part, which a closing joint forbids (but along its path)."""
        base, mover = self.velocities[joining.base].angular, self.velocities[joining.mover].angular
        bend = self.relative_acceleration(joining, self.slide_speed(joining), ZERO, base, mover)
        return self._gap(joining, self.acceleration) - bend
