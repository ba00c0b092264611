"""Mass, mass centre and moment of inertia of the bodies, with the lines that show how they were found.

Composites by the parallel-axis theorem, I = Σ (I_i + m_i d_i²); of uniform shapes see problem/scene/uniform.py.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.scene.new_centres import new_centre
from planar_cli.equation.scene.parts_in_line import PartsInLine, parts_in_line, pin_of
from planar_cli.equation.scene.written_angles import WrittenAngles
from planar_cli.equation.values.evaluate import Evaluator, demand_time
from planar_cli.equation.values.jets import Jet
from planar_cli.equation.values.ledger import Kind, Ledger
from planar_cli.errors import refuse
from planar_cli.problem.language.expression import Quantity, Side
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.masses import placed, varying
from planar_cli.problem.scene.part_names import part_letter, part_names
from planar_cli.problem.scene.scene import Body, Composite, Outline, Particle, Piece, Problem, Rod, Shape
from planar_cli.problem.scene.uniform import Uniform, uniform
from planar_cli.records import record

ZERO = sp.S.Zero
SHORT = 2
"""A formula of more operations gets a letter of its own, where it is put into others."""


@record
class BodyModel:
    """One body as principles see it.

    `mass` [kg] (0: massless), `inertia` [kg m²] about the mass centre at `center`; `center_name` in print. `theta`: the
    direction that its angle measures. `rigid`: False for a particle, which has no angle. `varies`: do its mass or its
    moment of inertia change with the time, or with places?
    """

    name: str
    shape: Shape
    rigid: bool
    mass: sp.Expr
    inertia: sp.Expr
    center: Vec
    center_name: str
    theta: sp.Expr
    varies: bool = False
    parts: tuple[tuple[sp.Expr, sp.Expr, Vec], ...] = ()
    """Of a body of several parts: mass, moment of inertia about its own mass centre, and that centre, of each."""
    pivot: tuple[str, sp.Expr] | None = None
    """The pin about which such a body turns on a line with its parts, and the moment of inertia about it."""


_Part = tuple[tuple[sp.Expr, sp.Expr], Uniform]
"""Mass and moment of inertia about its own mass centre, of a part, and its shape."""


@record
class _Measures:
    """Shapes in exact expressions."""

    point: Callable[[str], Vec]
    evaluator: Evaluator
    written: WrittenAngles
    span: Callable[[str, str], sp.Expr | None]
    zero: sp.Expr = ZERO

    def value(self, side: Side) -> sp.Expr:
        return self.evaluator.value(side)

    def sine(self, angle: sp.Expr) -> sp.Expr:
        return sp.sin(angle)

    def unit_vector(self, angle: sp.Expr) -> Vec:
        return Vec(sp.cos(angle), sp.sin(angle))

    def rod(self, shape: Rod, reach: Vec) -> tuple[sp.Expr, sp.Expr]:
        angle = None if shape.end is None else self.written.angle(shape.start, shape.end, reach)
        angle = sp.atan2(reach.y, reach.x) if angle is None else angle
        # A length that the file gives stands for what follows from coordinates.
        length = None if shape.end is None else self.span(shape.start, shape.end)
        square = reach.dot(reach) if length is None else length**2
        return square if square.is_number or length is not None else simplified(square), angle


class MassReader:
    """Reads the mass properties of one problem's bodies, defining the symbols that the solution shows."""

    def __init__(
        self,
        ledger: Ledger,
        evaluator: Evaluator,
        points: Callable[[str], Vec],
        span: Callable[[str, str], sp.Expr | None],
        written: WrittenAngles,
        gravity: sp.Expr,
        problem: Problem,
    ) -> None:
        self.ledger, self.evaluator, self.points, self.gravity = ledger, evaluator, points, gravity
        heavy = [b for b in problem.bodies if not b.is_massless or isinstance(b.shape, Composite)]
        self.alone, self.problem = len(heavy) == 1, problem
        self.own_points = {p.name for p in problem.points}
        self.varying, self.placed = varying(problem), placed(problem)
        self.measures = _Measures(points, evaluator, written, span)
        self.cancelling: list[sp.Symbol] = []

    def read(self, body: Body) -> BodyModel:
        """The model of one body; of one whose mass goes with places before it is `loaded`."""
        if isinstance(body.shape, Composite):
            return self._composite(body, body.shape)
        shape = uniform(body.shape, self.measures, body.name)
        if isinstance(body.shape, Rod) and body.shape.end is not None:
            reach = self.points(body.shape.end) - self.points(body.shape.start)
            if all(sp.sympify(e).xreplace(dict(self.ledger.values)) == 0 for e in (reach.x, reach.y)):
                text = f"both ends of {body.name} are at the same place"
                raise refuse(body.mark, "PL615", text, "draw them apart")
        rigid, later, varies = not isinstance(body.shape, Particle), body.name in self.placed, body.name in self.varying
        mass = ZERO if later else self._mass(body)
        inertia = self._inertia(body, shape, mass) if rigid and not later else ZERO
        name = shape.center_name
        return BodyModel(body.name, body.shape, rigid, mass, inertia, shape.center, name, shape.theta, varies)

    def loaded(self, body: Body, bodies: Mapping[str, BodyModel]) -> BodyModel:
        """The same with a mass that goes with places, now that all bodies have theirs."""

        def place(thing: str, word: str) -> sp.Expr:
            model = bodies.get(thing)
            if word == "theta":
                return ZERO if model is None else model.theta
            at = self.points(thing) if model is None or thing in self.own_points else model.center
            return sp.sympify(getattr(at, word))

        def asked(quantity: Quantity) -> Jet:
            first, *others = (place(thing, quantity.word) for thing in quantity.things)
            return Jet(first - sp.Add(*others), None, None)

        self.evaluator = replace(self.evaluator, quantity=asked)
        model, mass = bodies[body.name], self._mass(body)
        known, drawn = {**self.ledger.values, **self.ledger.definitions}, mass
        while drawn.free_symbols & known.keys():
            drawn = drawn.xreplace(known)
        if drawn.is_number and not drawn.is_positive:
            text = f"{body.name} has no mass where it is drawn"
            raise refuse(body.mark, "PL520", text, "let it begin with some: a short piece of the chain")
        inertia = self._inertia(body, uniform(body.shape, self.measures, body.name), mass) if model.rigid else ZERO
        return replace(model, mass=mass, inertia=inertia)

    def _named(self, stem: str, body: Body) -> str:
        return stem if self.alone else f"{stem}_{body.name}"

    def _mass(self, body: Body) -> sp.Expr:
        if body.any_mass:
            symbol = self.ledger.letter(self._free(self._named("m", body)), "kg")
            self.cancelling.append(symbol)
            return symbol
        if body.weight is not None:
            weight = self.evaluator.value(body.weight)
            return self.ledger.define(
                self._named("m", body), weight / self.gravity, "kg", f"mass of {body.name}", positive=True
            )
        if body.mass is None:
            return ZERO
        mass = self.evaluator.value(body.mass)
        demand_time(self.ledger, mass, body.mass.mark, f"the mass of {body.name}")
        if self._varies(mass):
            return mass
        if mass.is_number and mass.is_positive:
            return self.ledger.known(self._free(self._named("m", body)), mass, "kg")
        if self.ledger.is_multiple_of_a_letter(mass):
            return mass
        return self._shown(mass, self._named("m", body), "kg", f"mass of {body.name}")

    def _varies(self, expr: sp.Expr) -> bool:
        """Does it change with time or place? Then it stays a formula, so that its rate can be told."""
        return any(self._moves(s) for s in expr.free_symbols)

    def _moves(self, symbol: sp.Symbol) -> bool:
        ledger, role = self.ledger, self.ledger.roles.get(symbol)
        moving = role is not None and role.kind is Kind.COORDINATE and symbol in ledger.letters
        return moving or symbol == ledger.symbols["t"]

    def _free(self, name: str) -> str:
        while name in self.ledger.symbols:
            name += "_"
        return name

    def _shown(self, value: sp.Expr, name: str, unit: str, title: str) -> sp.Expr:
        """A number gets a letter, so that formulas show it; a symbol stays itself."""
        if value.is_Symbol or value == 0:
            return value
        return self.ledger.define(name, value, unit, title, positive=bool(value.is_positive))

    def _inertia(self, body: Body, shape: Uniform, mass: sp.Expr) -> sp.Expr:
        name, title = self._named("I", body), f"moment of inertia of {body.name}"
        if self.alone and shape.center_name:
            name = f"I_{shape.center_name}"
        unit = "kg*m^2"
        if body.inertia is not None:
            value = self._with_mass(self.evaluator.value(body.inertia), mass, body)
            demand_time(self.ledger, value, body.inertia.mark, f"the moment of inertia of {body.name}")
            if body.about is None:
                return value if self._varies(value) else self._shown(value, name, unit, title)
            value = self._about_centre(body, shape, mass, value)
        elif body.gyration is not None:
            value = mass * self.evaluator.value(body.gyration) ** 2
            if body.about is not None:
                value = self._about_centre(body, shape, mass, value)
        elif body.any_inertia or (isinstance(body.shape, Outline) and mass != 0):
            symbol = self.ledger.letter(self._free(name), unit)
            self.cancelling.append(symbol)
            return symbol
        else:
            value = mass * shape.gyration_squared
        if value == 0 or self._varies(value):
            return value
        return self.ledger.define(name, value, unit, title, positive=True)

    def _about_centre(self, body: Body, shape: Uniform, mass: sp.Expr, about: sp.Expr) -> sp.Expr:
        """Of a moment of inertia about another point, which can not be less than the whole mass at the centre has."""
        value = about - mass * self._shift(body, shape)
        drawn = self._known(value)
        drawn = simplified(drawn) if drawn.free_symbols else drawn
        if drawn.is_negative:
            told = body.inertia if body.inertia is not None else body.gyration
            assert told is not None
            what = "moment of inertia" if body.inertia is not None else "radius of gyration"
            text = f"the {what} of {body.name} about {body.about} is less than the distance of its mass centre makes it"
            hint = f"leave out `about: {body.about}` if it is that about the mass centre"
            raise refuse(told.mark, "PL544", text, hint)
        return value

    def _with_mass(self, inertia: sp.Expr, mass: sp.Expr, body: Body) -> sp.Expr:
        """A moment of inertia that is one number is that at t = 0, of a mass that goes with places that where it is
        drawn; it grows and shrinks with the mass.
        """
        if not self._varies(mass) or self._varies(inertia):
            return inertia
        begun = mass.xreplace({self.ledger.symbols["t"]: ZERO})
        if begun == 0:
            text = f"{body.name} has no mass at t = 0, so that its moment of inertia then does not tell the later ones"
            raise refuse(body.mark, "PL520", text, "write `radius_of_gyration:`, or `inertia:` with `t`")
        return inertia * mass / begun

    def _shift(self, body: Body, shape: Uniform) -> sp.Expr:
        d = shape.center - self.points(body.about or "")
        return d.dot(d)

    def _composite(self, body: Body, shape: Composite) -> BodyModel:
        """Mass centre and moment of inertia of the parts together."""
        parts = [
            (self._piece(p, body, i), uniform(p.shape, self.measures, body.name)) for i, p in enumerate(shape.pieces, 1)
        ]
        parts = [(masses, self._named_place(i, parts, body)) for i, (masses, _) in enumerate(parts)]
        whole = sp.Add(*(mass for (mass, _), _ in parts))
        if whole == 0:
            raise refuse(body.mark, "PL520", f"{body.name}: its parts have no mass", "give each part its `mass:`")
        name = self._named("m", body)
        mass = self.ledger.define(name, whole, "kg", f"mass of {body.name}", positive=True)
        center_name = self._own_centre(body, parts)
        if center_name:
            center = self.points(center_name)
        elif (turned := self._in_line(body, shape, parts)) is not None:
            return self._turned_in_line(turned, body, shape, mass, parts)
        else:
            center_name = new_centre(body, self.problem, self.ledger, self._named("G", body))
            center = Vec(*(self._coordinate(parts, mass, axis, f"{axis}_{center_name}", body) for axis in ("x", "y")))
        inertia = sp.Add(*(self._about(center, i, part, body) for i, part in enumerate(parts, 1)))
        if body.inertia is not None or body.gyration is not None:
            stand_in = Uniform(center, center_name, ZERO, ZERO)
            symbol = self._inertia(body, stand_in, mass)
        else:
            how = "parallel axes" if any(own != 0 for (_, own), _ in parts) else "Σ m r² of its point masses"
            title = f"moment of inertia of {body.name} about {center_name}, {how}"
            symbol = self.ledger.define(self._named("I", body), inertia, "kg*m^2", title, positive=True)
        own = tuple((*masses, u.center) for masses, u in parts)
        return BodyModel(body.name, shape, True, mass, symbol, center, center_name, parts[0][1].theta, parts=own)

    def _in_line(self, body: Body, shape: Composite, parts: list[_Part]) -> PartsInLine | None:
        """A body that turns about a pin, on a line through which its parts lie; None: it is none."""
        pin = pin_of(body.name, self.problem)
        own = body.inertia is None and body.gyration is None and all(p.inertia is None for p in shape.pieces)
        if not pin or not own or any(self._varies(mass) for (mass, _), _ in parts):
            return None
        centres = [Vec(self._opened(u.center.x), self._opened(u.center.y)) for _, u in parts]
        line = parts_in_line(pin, self.points(pin), centres, self._vanishes)
        if line is None or not any(self._known(mass).is_nonpositive for (mass, _), _ in parts):
            return line
        # By a hole the mass centre may lie on the other side of the pin.
        moment = sp.Add(*(mass * away for ((mass, _), _), away in zip(parts, line.distances, strict=True)))
        return line if self._known(moment).is_positive else None

    def _opened(self, expr: sp.Expr) -> sp.Expr:
        """In the letters of the file, without those of ours."""
        while inside := {s: e for s in expr.free_symbols if (e := self.ledger.definitions.get(s)) is not None}:
            expr = expr.xreplace(inside)
        return expr

    def _turned_in_line(
        self, line: PartsInLine, body: Body, shape: Composite, mass: sp.Expr, parts: list[_Part]
    ) -> BodyModel:
        """The same of a body that turns about a pin, by distances along the line of its parts: OG, then I_O."""
        names = part_names(body, self.problem)
        center_name = new_centre(body, self.problem, self.ledger, self._named("G", body))
        moments, turning = [], []
        for i, (((own_mass, own), _), distance) in enumerate(zip(parts, line.distances, strict=True), 1):
            piece, which = shape.pieces[i - 1].shape, names[i - 1]
            away = distance
            if distance.is_number or longer(distance, SHORT):
                title = f"from {line.pin} to the mass centre of {which}"
                away = self._shown(distance, part_letter("d", i, body, self.problem), "m", title)
            moments.append(own_mass * away)
            ends = isinstance(piece, Rod) and line.pin in (piece.start, piece.end)
            title = f"moment of inertia of {which} about its {f'end {line.pin}' if ends else 'centre'}"
            about = 4 * own if ends else own
            turning.append(self._shown(about, part_letter("I", i, body, self.problem), "kg*m^2", title))
            turning.append(ZERO if ends else own_mass * away**2)
        title = f"distance of the mass centre of {body.name} from {line.pin}"
        reach = self.ledger.define(f"{line.pin}{center_name}", sp.Add(*moments) / mass, "m", title, positive=True)
        title = f"moment of inertia of {body.name} about {line.pin}, parallel axes"
        about = self.ledger.define(f"I_{line.pin}", sp.Add(*turning), "kg*m^2", title, positive=True)
        title = f"moment of inertia of {body.name} about {center_name}, parallel axes"
        inertia = self.ledger.define(self._named("I", body), about - mass * reach**2, "kg*m^2", title, positive=True)
        own_parts = tuple((*masses, u.center) for masses, u in parts)
        where = (line.at(reach), center_name, parts[0][1].theta)
        return BodyModel(body.name, shape, True, mass, inertia, *where, parts=own_parts, pivot=(line.pin, about))

    def _named_place(self, index: int, parts: list[tuple[tuple[sp.Expr, sp.Expr], Uniform]], body: Body) -> Uniform:
        """A part with letters for the coordinates of its mass centre, along an axis on which one of them is long."""
        shape, place = parts[index][1], dict[str, sp.Expr]()
        for axis in ("x", "y"):
            own = getattr(shape.center, axis)
            every = [getattr(u.center, axis) for _, u in parts]
            named = any(longer(e, SHORT) for e in every) and not any(map(self._varies, every))
            if named and not (own.is_Symbol or own.is_number):
                title = f"{axis} of the mass centre of {part_names(body, self.problem)[index]}"
                own = self.ledger.define(part_letter(axis, index + 1, body, self.problem), own, "m", title)
            place[axis] = own
        return replace(shape, center=Vec(place["x"], place["y"]))

    def _own_centre(self, body: Body, parts: list[tuple[tuple[sp.Expr, sp.Expr], Uniform]]) -> str:
        """The point of the file that is the mass centre of a body of several parts; empty: none is."""
        for name in body.points:
            arms = [(mass, u.center - self.points(name)) for (mass, _), u in parts]
            if all(self._vanishes(sp.Add(*(mass * getattr(arm, axis) for mass, arm in arms))) for axis in ("x", "y")):
                return name
        return ""

    def _vanishes(self, gap: sp.Expr) -> bool:
        """Is it zero with all that is known of its letters?"""
        return bool(simplified(self._known(gap)) == 0)

    def _known(self, expr: sp.Expr) -> sp.Expr:
        """With all that is known of its letters."""
        known = {**self.ledger.values, **self.ledger.definitions}
        while expr.free_symbols & known.keys():
            expr = expr.xreplace(known)
        return expr

    def _about(self, center: Vec, number: int, part: tuple[tuple[sp.Expr, sp.Expr], Uniform], body: Body) -> sp.Expr:
        """Moment of inertia of a part about the mass centre of the whole; of numbers by named steps."""
        (mass, own), shape = part
        reach = shape.center - center
        square = reach.dot(reach)
        if self.ledger.symbolic and (self._varies(own) or not longer(own, SHORT)):
            return own + mass * square
        which = part_names(body, self.problem)[number - 1]
        letter = part_letter("I", number, body, self.problem)
        own = self._shown(own, letter, "kg*m^2", f"moment of inertia of {which} about its centre")
        if square == 0 or self.ledger.symbolic:
            return own + mass * square
        name, title = part_letter("d", number, body, self.problem), f"from the mass centre to that of {which}"
        return own + mass * self._shown(sp.sqrt(square), name, "m", title) ** 2

    def _coordinate(
        self, parts: list[tuple[tuple[sp.Expr, sp.Expr], Uniform]], mass: sp.Expr, axis: str, name: str, body: Body
    ) -> sp.Expr:
        first, *others = (getattr(u.center, axis) for _, u in parts)
        if all(self._vanishes(place - first) for place in others):
            return first
        moment = sp.Add(*(m * getattr(u.center, axis) for (m, _), u in parts))
        if self._vanishes(moment):
            return ZERO
        return self.ledger.define(name, moment / mass, "m", f"{axis} of the mass centre of {body.name}")

    def _piece(self, piece: Piece, body: Body, number: int) -> tuple[sp.Expr, sp.Expr]:
        """Mass of a part and its moment of inertia about its own mass centre."""
        mass = self.evaluator.value(piece.mass) if piece.mass is not None else ZERO
        if piece.weight is not None:
            mass = self.evaluator.value(piece.weight) / self.gravity
        title = f"mass of {part_names(body, self.problem)[number - 1]}"
        shown = self._shown(mass, part_letter("m", number, body, self.problem), "kg", title)
        if piece.inertia is not None:
            return shown, self.evaluator.value(piece.inertia)
        if piece.gyration is not None:
            return shown, shown * self.evaluator.value(piece.gyration) ** 2
        return shown, shown * uniform(piece.shape, self.measures, body.name).gyration_squared
