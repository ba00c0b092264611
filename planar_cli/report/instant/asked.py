"""What is asked of one instant, where it is more than an unknown of the equations: each answer gets its line.

A velocity or acceleration comes as its vector equation with the numbers, then the component that is asked.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.kinematics.motion import Edge
from planar_cli.equation.scene.centres import centre_of
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import ALL
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, Value, line
from planar_cli.report.friction.needed_friction import limit_of
from planar_cli.report.given.given_vectors import GIVEN, is_given, letters_given, says_all, size_of
from planar_cli.report.instant.asked_energy import kinetic_energy
from planar_cli.report.instant.asked_letters import closed_letter, is_second_rate, is_solved
from planar_cli.report.instant.asked_places import PlaceTelling, place_asked, place_name
from planar_cli.report.instant.axes_asked import (
    along_radius,
    axis_of,
    dimension_of,
    noted,
    part_along,
    rational,
    unit_asked,
    without,
    without_vector,
)
from planar_cli.report.instant.rates_in_turn import rate_in_turn
from planar_cli.report.kinematics.as_placed import with_arm
from planar_cli.report.kinematics.by_centre import asked_by_centre
from planar_cli.report.kinematics.component_sums import components_told, sliding_told, turned_with
from planar_cli.report.kinematics.curvature import radius_asked
from planar_cli.report.kinematics.geometry import coordinate, factor
from planar_cli.report.kinematics.on_path import LONGEST, PathTelling, vector_of
from planar_cli.report.kinematics.polar_slides import SlideTelling
from planar_cli.report.kinematics.relative_motion import RelativeTelling
from planar_cli.report.kinematics.rolled_accelerations import RolledTelling
from planar_cli.report.kinematics.vectors import VectorTelling
from planar_cli.report.kinetics.only_reaction import size_of_only
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.names import index_of, plain_name
from planar_cli.report.words.swallowed import swallowed
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import Found, InstantSolution
from planar_cli.units import ACCELERATION, VELOCITY, Dimension

MOVING = ("v", "a", "coriolis")
AXES = ("x", "y", "along", "across", "r", "theta")
"""Parts of a vector that are components along an axis."""


class AskedTelling:
    """Lines of what is asked of one instant."""

    def __init__(self, instant: InstantSolution, phrases: Phrases, vectors: VectorTelling) -> None:
        self.instant, self.phrases, self.vectors = instant, phrases, vectors
        self.system = instant.trial.system
        self.scene = instant.instant.scene
        self._told: set[str] = set()
        self._named: set[str] = set()
        self._shown: dict[str, Vec] = {}
        written = [w for s in instant.stages for b in s.blocks for w in b.equations]
        vectors.given = {w.left for w in written if w.given and w.right.is_number}
        vectors.letters = letters_given(instant)
        vectors.late = {u for s in instant.stages if s.level != "velocity" for b in s.blocks for u in b.unknowns}
        self.paths = PathTelling(vectors, phrases, self._once)
        self.rolled = RolledTelling(vectors, self._once, lambda body: self.absolute(body, "v"))
        self.slides = SlideTelling(vectors, phrases)
        vectors.of_wheels = self.rolled.in_letters
        self.places = PlaceTelling(self.scene, phrases)
        self.relative = RelativeTelling(vectors, self._once, self.absolute, self._body_point)

    def blocks(self, found: Iterable[Found]) -> Iterator[Block]:
        """A line or several for each answer that is no unknown of the equations."""
        still = (z for stage in self.instant.stages for z in stage.zero)
        nothing = dict.fromkeys((*self.vectors.zero, *still), sp.S.Zero)
        self.relative.answers = every = tuple(found)
        for one in every:
            if one.kind not in ("number", "vector") or one.find is None:
                continue
            raw = replace(one, asked=tuple(e.xreplace(nothing) for e in one.asked))
            if all(e.is_number for e in raw.asked) and not self._way(raw, "x"):
                continue
            answer = replace(raw, asked=tuple(e if longer(e, LONGEST) else simplified(e) for e in raw.asked))
            what = one.find.found.what
            if is_second_rate(what) and is_solved(answer.asked[0], self.instant):
                continue  # The answer names θ̈, which has its line.
            if isinstance(what, Quantity) and (chain := rate_in_turn(answer, what, every, self.instant, self.phrases)):
                yield from chain
                continue
            if len(answer.asked) == 1 and answer.asked[0].is_Symbol:
                yield from closed_letter(answer, self.instant, self.phrases)
                continue
            if isinstance(what, Quantity) and (centred := asked_by_centre(answer, what, self.vectors)):
                yield from centred
            elif isinstance(what, Quantity) and what.word == "KE" and (told := kinetic_energy(answer, what, self)):
                yield from told
            elif isinstance(what, Quantity) and self._has_vectors(answer, what):
                yield from self._moving(answer, what)
            elif isinstance(what, Quantity) and (radius := self.paths.asked_radius(answer, what)) is not None:
                yield from radius
            elif lines := radius_asked(answer, what, self):
                yield from lines
            else:
                yield from self._alone(answer, what)

    def coriolis(self, point: str, frame: str, projected: bool) -> Iterator[Block]:
        """The relative velocity and the Coriolis acceleration, with their numbers, before they are needed.
        `projected`: is the component of the latter told there?
        """
        if not self.phrases.symbolic:
            self._named |= {"v_rel", "a_cor"}
            yield from self.relative.seen(point, frame, "coriolis", projected)

    def _has_vectors(self, answer: Found, q: Quantity) -> bool:
        """Is it a velocity or an acceleration, more than an unknown, all of whose components are known?"""
        if q.word not in MOVING or not q.things or q.things[0] == ALL or self._plain(answer):
            return False
        vector = self.system.quantities().any(replace(q, parts=(), word="a" if q.word == "coriolis" else q.word))
        known = self.phrases.value.known
        return isinstance(vector, Vec) and all(known(p.value) is not None for p in (vector.x, vector.y))

    def _alone(self, answer: Found, what: Any) -> Iterator[Block]:
        """Its formula; before that of a component that does without a part of it the vector equations of its point."""
        axis, told = axis_of(what), list[Block]()
        if axis and what.word in ("v", "a") and len(what.things) == 1 and what.things[0] in self.scene.points:
            point, level = what.things[0], "velocity" if what.word == "v" else "acceleration"
            told = list(self.vectors.point(self.scene.owner(point), self.scene.point(point), point, level))
        aside = without(what, self.system, self.vectors.zero, self.phrases) if told else ()
        yield from (*told, *noted(self._formula(answer), axis if told else "", aside))

    def _plain(self, answer: Found) -> bool:
        """Is it an unknown up to its sign or a simple factor, which says more than a vector would?"""
        expr = answer.asked[0]
        return len(answer.asked) == 1 and len(expr.free_symbols) == 1 and not longer(expr, 2)

    # --- formulas ----------------------------------------------------------------------------------------------------

    def _formula(self, answer: Found) -> Iterator[Block]:
        """name = formula = numbers = value, for each component; of a magnitude with a long formula √(x² + y²)."""
        what = answer.find.found.what if answer.find is not None else None
        sized = isinstance(what, Quantity) and len(what.parts) == 1 and what.parts[0].kind == "mag"
        if sized and answer.values is not None and not self.is_readable(answer.asked[0], answer.unit.dimension):
            assert isinstance(what, Quantity)
            vector = self._parts(what)
            if vector is not None:
                only = size_of_only(what, self.system, self.phrases)
                size = only or size_of(vector, answer.unit.dimension, self.phrases)
                values = self.phrases.in_units(answer.values[0], answer.unit, answer.energy)
                yield Equation((line(Name(answer.name)), size, *values))
                return
        place = place_asked(answer)
        if place is not None:
            if shifted := self.places.shifted(answer, place):
                yield from shifted
                return
            yield from self.places.heading(place)
        axes = ("x", "y") if len(answer.asked) == 2 else ("",)
        for i, (axis, expr) in enumerate(zip(axes, answer.asked, strict=True)):
            name = line(Name(answer.name), f", {axis}" if axis else self._sense(answer))
            name = name if place is None else place_name(place, axis, self.phrases.ledger)
            sides: list[Any] = [name]
            values = (
                [] if answer.values is None else self.phrases.in_units(answer.values[i], answer.unit, answer.energy)
            )
            if way := self._way(answer, axis) or along_radius(answer, self.system.quantities(), self.phrases):
                sides.append(way)
            if self.is_readable(expr, answer.unit.dimension) and not expr.is_number:
                whole = self._with_unit(answer, expr)
                sides.append(whole or self.phrases.math(expr))
            if not self.phrases.symbolic and values and not longer(expr, LONGEST):
                sides += self.phrases.substituted(expr, values[0])
            sides += values
            if not values and answer.expressions and answer.expressions[i] not in (expr, answer.asked[i]):
                closed = answer.expressions[i]
                whole = self._with_unit(answer, closed)
                sides += [] if longer(closed, LONGEST) else [whole or self.phrases.math(closed)]
            if len(sides) > 1:
                yield Equation(tuple(sides), None, note=limit_of(answer, self.system, self.phrases))

    def _with_unit(self, answer: Found, expr: sp.Expr) -> Math | None:
        """A formula whose number holds a unit, with that."""
        return swallowed(expr, answer, self.phrases.ledger, self.phrases.figures) if self.phrases.symbolic else None

    def _way(self, answer: Found, axis: str) -> Line:
        """How the file leads to the place that is asked; of two points the difference."""
        what = answer.find.found.what if answer.find is not None else None
        if not isinstance(what, Quantity) or what.word != "r" or what.parts or not axis:
            return ()
        ways = [coordinate(self.scene, name, axis, self.phrases.figures) for name in what.things]
        if not all(ways) or all(len(way) == 1 for way in ways):
            return ()
        first, *others = ways
        return line(first, *(p for other in others for p in (" - ", *factor(other))))

    def is_readable(self, expr: sp.Expr, dimension: Dimension) -> bool:
        """Is it short, and do its letters make the unit that is asked for?"""
        clean = self.phrases.symbolic or is_clean(self.phrases.ledger, expr, dimension=dimension)
        return not longer(expr, LONGEST) and clean

    def _sense(self, answer: Found) -> str:
        """In which sense it counts, where the equations have a letter of its name."""
        what = answer.find.found.what if answer.find is not None else None
        same = any(plain_name(s.name) == plain_name(answer.name) for e in answer.asked for s in e.free_symbols)
        if not same or not isinstance(what, Quantity) or not what.parts or what.parts[-1].kind not in AXES:
            return " as asked" if same else ""
        return f" in the sense {self.phrases.arrow(*map(rational, self._axis(what)))}"

    def _values(self, answer: Found, component: int) -> list[Value]:
        """The value of a component in the unit of the page and in that of the answer; nothing while letters remain."""
        if answer.values is None:
            return []
        return self.phrases.in_units(answer.values[component], answer.unit, answer.energy)

    # --- velocities and accelerations --------------------------------------------------------------------------------

    def _moving(self, answer: Found, q: Quantity) -> Iterator[Block]:
        """The vectors that lead to it, then its component; its formula where no vector equation leads to it."""
        point, frame = q.things[0], self.system.quantities().frame_body(q)
        if frame is not None and (coriolis := self.slides.coriolis(answer.name, q, self._values(answer, 0))):
            yield coriolis
            return
        if frame is not None:
            told = list(self.relative.seen(point, frame, q.word, True))
            name = {"v": "v_rel", "a": "a_rel", "coriolis": "a_cor"}[q.word]
        elif len(q.things) == 2 and q.things[1] != "ground":
            told = list(self._between(point, q.things[1], q.word))
            name = f"{q.word}_{point}/{q.things[1]}"
        else:
            own = point if point in self.scene.points else centre_of(self.scene, point)
            told, name = list(self.absolute(point, q.word)), f"{q.word}_{index_of(own)}"
        key = f"{'velocity' if q.word == 'v' else 'acceleration'} {name.removeprefix(f'{q.word}_')}"
        if told or name in self._named or key in self._told:
            self._named.add(name)
            yield from without_vector(told) if answer.values is None and axis_of(q) else told
            if answer.values is not None or not says_all(self._shown.get(key), answer.expressions):
                yield from self._component(answer, q, name)
        else:
            yield from self._formula(answer)

    def absolute(self, point: str, word: str) -> Iterator[Block]:
        """v_P = v_A + ω × r_P/A = [x, y]."""
        level = "velocity" if word == "v" else "acceleration"
        if point not in self.scene.points:
            own, at = centre_of(self.scene, point), self.scene.center(point)
            yield from self.paths.acceleration(point, at, own, level)
            yield from self.rolled.acceleration(point, at, own, level)
            yield from self._along_body(point, own, level)
            yield from self._body_point(point, at, own, level)
            return
        place = self.scene.point(point)
        yield from self.paths.acceleration(self.scene.owner(point), place, point, level)
        yield from self.rolled.acceleration(self.scene.owner(point), place, point, level)
        yield from self._along_body(self.scene.owner(point), point, level)
        for body in self.scene.owners.get(point, ()) or (self.scene.owner(point),):
            if body in self.scene.bodies and self.vectors.formula(body, place, point, level) is not None:
                yield from self._body_point(body, place, point, level)
                return

    def _along_body(self, body: str, place: str, level: str, point: Vec | None = None) -> Iterator[Block]:
        """Of a particle, or the `point` of a rigid body, sliding along one that turns, with the Coriolis term."""
        motion, at = self.vectors.motion, self.scene.center(body) if point is None else point
        key, rigid = f"{level} {place}", point is not None
        found = self.vectors.sliding(body, at, place, level, rigid) if key not in self._told else None
        if found is not None:
            vector = motion.velocity(at, body) if level == "velocity" else motion.acceleration(at, body)
            frame = self.vectors.carrier(self.vectors.edges[body].parent)
            if (polar := self.slides.told(body, place, frame, level)) is not None:
                before, polar_sides = polar
                yield from before
                yield from self._once(key, polar_sides, vector, level)
                return
            yield from self._joined(self.vectors.edges[frame], level)
            yield from self.vectors.along(body)
            put = self._slid_in_numbers(body, at, level)
            sides = (line(Name(f"{level[0]}_{index_of(place)}")), found[0], *([put] if put else []))
            yield from self._once(key, sides, vector, level, found[1], bool(put))

    def _slid_in_numbers(self, body: str, at: Vec, level: str) -> Line:
        """The components of what slides along a body that turns, with their numbers."""
        edge, motion = self.vectors.edges[body], self.vectors.motion
        frame = self.vectors.carrier(edge.parent)
        twists = motion.velocities if level == "velocity" else motion.accelerations
        arm = self.scene.arms.between(twists[frame].point, at)
        return () if self.phrases.symbolic else sliding_told(self.vectors, edge, frame, arm, level)

    def _body_point(self, body: str, at: Vec, place: str, level: str) -> Iterator[Block]:
        """The equation of a point of a body with its value, after those of the points on which it rests."""
        body = self.vectors.carrier(body)
        if (found := self.vectors.formula(body, at, place, level)) is None:
            return
        edge, sides, arm = found
        yield from self._joined(edge, level)
        motion, note = self.vectors.motion, self.vectors.arm_once(place, edge, arm)
        vector = motion.velocity(at, body) if level == "velocity" else motion.acceleration(at, body)
        put = turned_with(self.vectors, body, arm, level) if not self.phrases.symbolic else None
        told = components_told(put, self.phrases.figures) if put is not None else ()
        if is_given(vector, self.instant, self.phrases):
            yield from self._once(f"{level} {place}", sides[:1], vector, level, line(GIVEN))
            return
        yield from self._once(f"{level} {place}", (*sides, told) if told else sides, vector, level, note, bool(told))

    def _joined(self, edge: Edge, level: str) -> Iterator[Block]:
        """The point at which a body is joined, from which its others are reached."""
        if edge.joining is not None and not self.vectors.rests(edge, level):
            at, place = edge.joining.point, edge.joining.place
            yield from self.paths.acceleration(edge.body, at, place, level)
            yield from self.rolled.acceleration(edge.parent, at, place, level)
            yield from self._along_body(edge.body, place, level, at)
            yield from self._body_point(edge.parent, at, place, level)

    def _once(
        self, key: str, sides: tuple[Line, ...], vector: Vec, level: str, note: Line = (), put: bool = False
    ) -> Iterator[Block]:
        """`put`: the note is an arm whose numbers stand in the sides."""
        if key not in self._told | self.vectors.valued:
            self._told.add(key)
            self._shown[key] = vector
            nothing = dict.fromkeys(self.vectors.zero, sp.S.Zero) if self.phrases.symbolic else {}
            vector = Vec(*(sp.sympify(p).xreplace(nothing) for p in (vector.x, vector.y))) if nothing else vector
            value = vector_of(vector, VELOCITY if level == "velocity" else ACCELERATION, self.phrases)
            yield from with_arm((*sides, value) if value else sides, put, note)

    def _between(self, one: str, other: str, word: str) -> Iterator[Block]:
        """v_A/B = v_A - v_B."""
        for point in (one, other):
            yield from self.absolute(point, word)
        places = [self.system.quantities().place(point) for point in (one, other)]
        level, order = ("velocity", "rate") if word == "v" else ("acceleration", "second")
        own, base = (Vec(getattr(p.x, order), getattr(p.y, order)) for p in places)
        moves = not all(self.phrases.value.is_zero(sp.sympify(p)) for p in (base.x, base.y))
        less = (" - ", Name(f"{word}_{other}")) if moves else ()
        sides = (line(Name(f"{word}_{one}/{other}")), line(Name(f"{word}_{one}"), *less))
        yield from self._once(f"{word} {one}/{other}", sides, own - base, level)

    def _component(self, answer: Found, q: Quantity, name: str) -> Iterator[Block]:
        """The part of the vector that is asked: its size, its direction, or along an axis."""
        if not q.parts or answer.values is None:
            yield from noted(self._formula(answer) if answer.values is None else (), axis_of(q))
            return
        values, vector = self._values(answer, 0), self._parts(q)
        if name in ("v_rel", "a_rel", "a_cor") and q.parts[-1].kind in ("along", "mag"):
            axis = self._axis(q) if q.parts[-1].kind == "along" else ()
            if (part := self.relative.part(answer.name, q, axis, values)) is not None:
                yield from part
                return
        if vector is None or len(q.parts) > 1 or q.parts[-1].kind not in (*AXES, "mag"):
            told = {"angle": "its direction", "t": "along the path", "n": "across the path"}.get(q.parts[-1].kind, "")
            across = self._across(q) if len(q.parts) == 1 else ()
            chain = (line(Name(answer.name)), *((across,) if across else ()), *values)
            yield Equation(chain, None, note=line(told) if told else ())
            return
        numbers = tuple(self.phrases.of_dimension(v, dimension_of(q)) for v in vector)
        own = [] if plain_name(answer.name) == plain_name(name) else [line(Name(answer.name))]
        if q.parts[-1].kind == "mag":
            size = self.slides.size(name) or size_of(vector, dimension_of(q), self.phrases)
            yield Equation((*own, line("|", Name(name), "|"), *([size] if all(vector) else []), *values))
            return
        axis = self._axis(q)
        if own and (way := self.slides.part(name, axis)):
            yield Equation((*own, way, *values))
            return
        yield from part_along(name, own, numbers, axis, q.parts[-1].kind, values, self.phrases)

    def _across(self, q: Quantity) -> Line:
        """v²/ρ, where that is asked of a particle on a fixed curve; else nothing."""
        body = q.things[0] if q.things[0] in self.scene.bodies else self.scene.owner(q.things[0])
        edge = self.vectors.edges.get(body)
        curved = self.paths.curved(body) is not None
        if q.word != "a" or q.parts[-1].kind != "n" or len(q.things) > 1 or not curved or edge is None:
            return ()
        return () if edge.slide is None else line(self.phrases.math(edge.slide**2), "/ρ")

    def _axis(self, q: Quantity) -> list[Decimal]:
        """The unit vector along which a component is taken."""
        return unit_asked(q, self.system.quantities(), self.phrases)

    def _parts(self, q: Quantity) -> list[Decimal] | None:
        """Both components of the whole vector [SI]."""
        found = self.system.quantities().any(replace(q, parts=()))
        if not isinstance(found, Vec):
            return None
        return [self.phrases.certain(p.value) for p in (found.x, found.y)]
