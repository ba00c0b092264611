"""The independent road: the scene once more as a plain multibody system, to compare a worked solution with.

Coordinates x, y, θ of every rigid body and x, y of every particle; the joints give position residuals φ only, which are
differentiated here:

    M q̈ = Q + (Jᵀ + friction) λ,        J q̈ + φ̈(q̈ = 0) = 0

Loads, the file's own relations between accelerations, and sought constants with their values are taken as the worked
solution has them. What keeps a prescribed motion going is the multiplier of its relation (coordinate_drives.py: of one
of coordinates). Only what these equations determine is compared: accelerations of
all bodies, the net force and couple of every joint on every body, and what drives.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import field
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.algebra.plain import letters
from planar_cli.equation.kinematics.motion import Motion
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import CERTAIN, ZERO, Valuation
from planar_cli.equation.values.tangent import Tangent, tangent
from planar_cli.joints.base import Joint, distinct
from planar_cli.problem.scene.facts import Action, Mode, Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import changing
from planar_cli.solve.instant.worked import PARTS, Worked
from planar_cli.solve.multibody.agreement import ENOUGH, FEW, FULL, NOTHING, Agreement, agreeing, short
from planar_cli.solve.multibody.coordinate_drives import CoordinateDrives
from planar_cli.solve.multibody.drives import exerted_by
from planar_cli.solve.multibody.poses import NearPoses, Place
from planar_cli.solve.multibody.sparse import CONSTANT, Echelon, Line
from planar_cli.solve.multibody.time_jets import ONE, Slopes, TimeJet


@changing
class Tie:
    """One scalar residual of a joint: its jet, the column of its multiplier, the friction that a unit of it brings."""

    joint: str
    title: str
    jet: TimeJet
    column: int
    friction: Slopes = field(default_factory=dict)


def second_road(system: System, worked: Worked) -> Agreement:
    """Assemble the scene of a settled system anew and compare what the worked solution says."""
    return Multibody(system, worked).agreement()


class Multibody:
    """The scene of one choice of modes in coordinates of the bodies."""

    def __init__(self, system: System, worked: Worked) -> None:
        self.system, self.worked, self.value = system, worked, worked.numbers
        self.notes: list[str] = []
        self.places = self._places()
        self.count = 0
        for place in self.places.values():
            self.count += 2 + (place.columns[2] is not None)
        self.ties = self._ties()
        self.known: dict[str, Slopes] = {}
        self._friction()
        drivers = [p for p in system.pushes if p.joint not in system.modes]
        self.drives = {p: self.count + len(self.ties) + k for k, p in enumerate(drivers)}
        self.echelon = Echelon()
        self._assemble()

    # --- motion ------------------------------------------------------------------------------------------------------

    def _places(self) -> dict[str, Place]:
        places, column = {}, 0
        for name, body in self.system.scene.bodies.items():
            velocity, spin = self.worked.velocities[name]
            turn = column + 2 if body.rigid else None
            center = Vec(self.value(body.center.x), self.value(body.center.y))
            places[name] = Place(center, velocity, spin, (column, column + 1, turn))
            column += 3 if body.rigid else 2
        return places

    def _ties(self) -> list[Tie]:
        """All residuals of all joints, evaluated once."""
        poses = NearPoses(self.value, self.places)
        ties: list[Tie] = []
        for joint, mode in self._joints():
            name = joint.name
            for residual in joint.residuals(self.system.scene, mode):
                found = residual.of(poses)
                for jet in (found.x, found.y) if isinstance(found, Vec) else (found,):
                    ties.append(Tie(name, residual.title, tidied(jet), self.count + len(ties)))
        return ties

    def _joints(self) -> Iterator[tuple[Joint, Mode]]:
        """All joints of the file, in their modes."""
        joints = {j.name: j for j in distinct(self.system.scene.problem.joints)}
        yield from ((joints[name], mode) for name, mode in self.system.modes.items() if name in joints)

    def _changed(self) -> tuple[Joint, str] | None:
        poses, usual = NearPoses(self.value, self.places), max(map(abs, self._speeds().values()), default=ZERO)
        for joint, mode in self._joints():
            for residual in joint.presumes(self.system.scene, mode):
                if abs(residual.of(poses).rate) > FEW * usual:
                    return joint, residual.title
        return None

    def _speeds(self) -> Slopes:
        """The velocities of all coordinates."""
        speeds: Slopes = {}
        for place in self.places.values():
            own = zip(place.columns, (place.velocity.x, place.velocity.y, place.spin), strict=True)
            speeds |= {column: speed for column, speed in own if column is not None}
        return speeds

    def rates(self) -> Decimal:
        """The largest rate of a residual, relative to the size of its terms."""
        speeds, largest = self._speeds(), ZERO
        for tie in self.ties:
            size = sum((abs(s * speeds[i]) for i, s in tie.jet.slopes.items()), abs(tie.jet.rate))
            error = abs(tie.jet.rate) / size if size > NOTHING else ZERO
            if error > FEW:
                self.notes.append(f"{tie.title}: the velocities change it at the rate {short(tie.jet.rate)}")
            largest = max(largest, error)
        return largest

    def drawn(self) -> None:
        """Residuals that are not zero as drawn."""
        for tie in self.ties:
            if abs(tie.jet.value) > FEW:
                self.notes.append(f"{tie.title}: it is off by {short(tie.jet.value)} as drawn")

    # --- forces ------------------------------------------------------------------------------------------------------

    def wrench(self, body: str, point: Vec, force: Vec | None, couple: sp.Expr) -> Slopes:
        """The generalized force of a force at a point and a couple."""
        place = self.places.get(body)
        if place is None:
            return {}
        f = Vec(self.value(force.x), self.value(force.y)) if force is not None else Vec(ZERO, ZERO)
        found = {place.columns[0]: f.x, place.columns[1]: f.y}
        if place.columns[2] is not None:
            arm = Vec(self.value(point.x), self.value(point.y)) - place.center
            found[place.columns[2]] = arm.cross(f) + self.value(couple)
        return found

    def push(self, actions: Iterable[Action | Wrench], factor: Decimal = ONE) -> Slopes:
        """The generalized force of all that a unit of a push does, times a factor."""
        total: Slopes = {}
        for a in actions:
            for i, c in self.wrench(a.body, a.point, a.force, a.couple).items():
                total[i] = total.get(i, ZERO) + factor * c
        return total

    def _friction(self) -> None:
        """Kinetic friction: along the face, in proportion to the normal component of what the residuals exert."""
        pushes = {p.name: p for p in self.system.pushes}
        for law in self.system.laws:
            joint = pushes[law.push].joint
            unit, factor = self.push(pushes[law.push].actions), self.value(law.factor)
            if law.of is None:
                self.known[joint] = {i: factor * c for i, c in unit.items()}
                continue
            pressed = next(a for a in pushes[law.of].actions if a.body in self.places and a.force is not None)
            normal = self.wrench(pressed.body, pressed.point, pressed.force, 0)
            x, y, _ = self.places[pressed.body].columns
            for tie in self.ties:
                if tie.joint == joint:
                    share = factor * sum((tie.jet.slopes.get(i, ZERO) * normal[i] for i in (x, y)), ZERO)
                    tie.friction = {i: share * c for i, c in unit.items() if share}

    def _loads(self) -> Slopes:
        """Loads of the file, weights, and friction that is known."""
        parts = [*(self.push([w]) for w in self.system.wrenches), *self.known.values()]
        total: Slopes = {}
        for i in set().union(*parts):
            own = [part[i] for part in parts if i in part]
            # Loads in balance leave their rounding, which a body without mass would be asked to take.
            if abs(found := sum(own, ZERO)) > CERTAIN * max(map(abs, own)):
                total[i] = found
        return total

    # --- equations ---------------------------------------------------------------------------------------------------

    def _assemble(self) -> None:
        stated = self._stated()
        self.driving = exerted_by(self.drives, stated, self.count, self._through)
        for title, line in [*self._kinetics(), *self._constraints(), *stated]:
            remainder = self.echelon.add(line, lambda column: column < self.count)
            if remainder > FEW:
                self.notes.append(f"{title}: the second road contradicts it, by {short(remainder)} of its size")

    def _through(self, text: str) -> Slopes | None:
        """What drives a coordinate by a relation of the file."""
        relation = next(r for r, _ in self.system.statements.relations if r.text == text)
        return CoordinateDrives(self.system.scene, self.value, self.places).of(relation)

    def _kinetics(self) -> list[tuple[str, Line]]:
        """m a - Σ F = 0, I α - Σ M = 0; bodies with mass first, so that each leads with its own acceleration."""
        loads = self._loads()
        lines: dict[int, Line] = {i: {CONSTANT: -loads.get(i, ZERO)} for i in range(self.count)}
        titles: dict[int, str] = {}
        for name, place in self.places.items():
            body = self.system.scene.bodies[name]
            for column, inertia, part in zip(place.columns, (body.mass, body.mass, body.inertia), PARTS, strict=True):
                if column is not None:
                    lines[column][column], titles[column] = self.value(inertia), f"{name}, {part}"
        for tie in self.ties:
            for exerted in (tie.jet.slopes, tie.friction):
                for i, c in exerted.items():
                    lines[i][tie.column] = lines[i].get(tie.column, ZERO) - c
        for drive, exerted in self.driving.items():
            for i, c in exerted.items():
                lines[i][self.drives[drive]] = lines[i].get(self.drives[drive], ZERO) - c
        order = sorted(lines, key=lambda i: not lines[i][i])
        return [(titles[i], lines[i]) for i in order]

    def _constraints(self) -> list[tuple[str, Line]]:
        return [(tie.title, {**tie.jet.slopes, CONSTANT: tie.jet.second}) for tie in self.ties]

    def _stated(self) -> list[tuple[str, Line]]:
        """The file's own relations between accelerations, as it states them."""
        free = Motion(
            self.system.builder.build((), hang=False), self.system.scene.center, self.system.scene.arms.between, {}
        )
        conditions = self.system.stated_accelerations(free)
        if not conditions:
            return []
        columns: dict[sp.Symbol, int] = {}
        speeds: dict[sp.Symbol, Decimal] = {}
        paces: dict[sp.Symbol, Decimal] = {}
        for edge in free.tree.edges:
            place = self.places[edge.body]
            linear, angular = self.worked.accelerations[edge.body]
            made = ((edge.slide, edge.slide_rate), (edge.rise, edge.rise_rate), (edge.spin, edge.spin_rate))
            velocity = (place.velocity.x, place.velocity.y, place.spin)
            own = zip(place.columns, made, velocity, (linear.x, linear.y, angular), strict=True)
            for column, (speed, rate), value, pace in own:
                if column is not None and speed is not None and rate is not None:
                    columns[rate], speeds[speed], paces[rate] = column, value, pace
        for rate in self.system.scene.evaluator.second_rates:
            columns[rate] = self.count + len(self.ties) + len(self.drives) + len(columns)
            if (pace := self.worked.numbers.known(rate)) is not None:
                paces[rate] = pace
        pushes = {symbol: self.worked.pushes.get(name, ZERO) for name, symbol in self.system.symbols.items()}
        value = self.value.extended({**pushes, **speeds})
        found = []
        for condition in conditions:
            for expr in condition.rows():
                form = _first_order(expr, columns, paces, value)
                line = {columns[s]: c for s, c in form.slopes.items()}
                if not line and value.is_zero(expr):
                    continue  # a relation between loads and velocities: what its rounding leaves has no other size
                found.append((condition.text, tidied_line({**line, CONSTANT: form.constant})))
        return found

    # --- comparison --------------------------------------------------------------------------------------------------

    def agreement(self) -> Agreement:
        """Compare everything that these equations determine."""
        velocities = self.rates()
        self.drawn()
        digits = self._compare(self._accelerations(PARTS[:2]), self._driven())
        digits = min(digits, self._compare(self._accelerations(PARTS[2:])))
        digits = min(digits, self._compare(self._joint_forces(PARTS[:2])))
        digits = min(digits, self._compare(self._joint_forces(PARTS[2:]), self._turned()))
        digits = min(digits, self._compare(self._driving_forces(PARTS[:2]), self._driven()))
        digits = min(digits, self._compare(self._driving_forces(PARTS[2:]), self._turned()))
        return Agreement(velocities, digits, tuple(self.notes), self._changed())

    def _driven(self) -> Decimal:
        """The largest acceleration that one load alone would give a body [m/s²]."""
        bodies = self.system.scene.bodies
        forces = [(self.value(bodies[w.body].mass), w.force) for w in self.system.wrenches if w.force is not None]
        pulls = (abs(self.value(e)) / mass for mass, force in forces if mass for e in (force.x, force.y))
        return max(pulls, default=ZERO)

    def _turned(self) -> Decimal:
        """The largest moment about a mass centre that a reaction could have with its force and its arm [N m]."""
        largest = ZERO
        for push in self.system.pushes:
            for a in push.actions:
                if a.body in self.places and a.force is not None:
                    arm = Vec(self.value(a.point.x), self.value(a.point.y)) - self.places[a.body].center
                    unit = max(abs(self.value(e)) for e in (a.force.x, a.force.y))
                    largest = max(largest, max(abs(arm.x), abs(arm.y)) * unit * abs(self.worked.pushes[push.name]))
        return largest

    def _compare(self, group: list[tuple[str, Decimal, Line]], driven: Decimal = ZERO) -> int:
        """The digits to which quantities of one dimension agree. `driven`: beside which some of them may cancel."""
        pairs = [(title, ours, self.echelon.value(line)) for title, ours, line in group]
        determined = [(title, ours, theirs) for title, ours, theirs in pairs if theirs is not None]
        scale = max((max(abs(a), abs(b)) for _, a, b in determined), default=ONE)
        fewest = FULL
        for title, ours, theirs in determined:
            digits = agreeing(ours, theirs, scale, driven)
            if digits < ENOUGH:
                self.notes.append(f"{title}: worked solution {short(ours)}, second road {short(theirs)}")
            fewest = min(fewest, digits)
        return fewest

    def _accelerations(self, parts: Sequence[str]) -> list[tuple[str, Decimal, Line]]:
        """a_x and a_y of all mass centres, or α of all bodies."""
        found = []
        for name, place in self.places.items():
            linear, angular = self.worked.accelerations[name]
            for part, column, value in zip(PARTS, place.columns, (linear.x, linear.y, angular), strict=True):
                if column is not None and part in parts:
                    title = f"alpha of {name}" if part == "turn" else f"a_{part} of {name}"
                    found.append((title, value, {column: ONE}))
        return found

    def _driving_forces(self, parts: Sequence[str]) -> list[tuple[str, Decimal, Line]]:
        """What every prescribed motion exerts on every body: its force, or its moment about the mass centre."""
        found = []
        for push, column in self.drives.items():
            ours, theirs = self.push(push.actions, self.worked.pushes[push.name]), self.driving[push]
            for place in self.places.values():
                for part, i in zip(PARTS, place.columns, strict=True):
                    if part in parts and i is not None and (i in ours or i in theirs):
                        line = {column: theirs[i]} if theirs.get(i) else {}
                        found.append((f"what drives `{push.place}`", ours.get(i, ZERO), line))
        return found

    def _joint_forces(self, parts: Sequence[str]) -> list[tuple[str, Decimal, Line]]:
        """The force of every joint on every body, or its moment about the mass centre."""
        found = []
        for joint in self.system.modes:
            ours = self._worked_force(joint)
            ties = [t for t in self.ties if t.joint == joint]
            for name, place in self.places.items():
                for part, column in zip(PARTS, place.columns, strict=True):
                    if column is None or part not in parts:
                        continue
                    line = {t.column: t.jet.slopes.get(column, ZERO) + t.friction.get(column, ZERO) for t in ties}
                    line = {j: c for j, c in line.items() if c}
                    if line or column in ours:
                        line[CONSTANT] = self.known.get(joint, {}).get(column, ZERO)
                        what = "moment" if part == "turn" else f"force along {part}"
                        found.append((f"{what} of {joint} on {name}", ours.get(column, ZERO), line))
        return found

    def _worked_force(self, joint: str) -> Slopes:
        """The generalized force of a joint as the worked solution has it."""
        total: Slopes = {}
        for push in self.system.pushes:
            if push.joint == joint:
                for i, c in self.push(push.actions, self.worked.pushes[push.name]).items():
                    total[i] = total.get(i, ZERO) + c
        return total


def _first_order(
    expr: sp.Expr, columns: Container[sp.Symbol], paces: Mapping[sp.Symbol, Decimal], value: Valuation
) -> Tangent:
    """A relation between accelerations as a linear one; a nonlinear one near the worked accelerations."""
    try:
        form = linear_form(expr, columns)
    except Nonlinear:
        return tangent(expr, {x: paces[x] for x in letters(expr) if x in columns}, value)
    return Tangent({s: value(c) for s, c in form.terms.items()}, value(form.constant))


def tidied(jet: TimeJet) -> TimeJet:
    """The jet without slopes that have cancelled."""
    size = max((abs(s) for s in jet.slopes.values()), default=ZERO)
    return TimeJet(jet.value, jet.rate, jet.second, {i: s for i, s in jet.slopes.items() if abs(s) > NOTHING * size})


def tidied_line(line: Line) -> Line:
    """The line without coefficients that have cancelled."""
    size = max((abs(c) for j, c in line.items() if j != CONSTANT), default=ZERO)
    return {j: c for j, c in line.items() if abs(c) > NOTHING * size}
