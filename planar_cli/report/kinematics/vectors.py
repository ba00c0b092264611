"""Kinematic relations as the course writes them: the vector equation of each point, then the component that is taken.

    v_B = v_A + ω × r_B/A                          a_B = a_A + α × r_B/A - ω² r_B/A
    v_P = v_P′ + v_rel                             a_P = a_P′ + a_rel + 2 ω × v_rel

P′ is the point of the moving body where P is (An Introduction to Planar Dynamics, 2.2 - 2.5).
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.kinematics.motion import Edge, Motion
from planar_cli.equation.scene.centres import centre_of
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Block, Equation, Line, Name, Paragraph, line
from planar_cli.report.given.written_places import differentiated, stated_rate
from planar_cli.report.kinematics.along_path import across_path, is_along_path, on_path
from planar_cli.report.kinematics.along_slots import coriolis_told, unit_beside
from planar_cli.report.kinematics.as_placed import arm_name, as_placed, with_arm
from planar_cli.report.kinematics.coincident import coincident
from planar_cli.report.kinematics.fixed_lines import along_fixed, touches_at_rest
from planar_cli.report.kinematics.half_arms import half_of
from planar_cli.report.kinematics.projected import known_sides, projected, unit_of, with_direction
from planar_cli.report.kinematics.rolled_contacts import on_fixed_axles, rolls_on_body, rolls_on_ground
from planar_cli.report.kinematics.ties import swings, tie_told
from planar_cli.report.kinematics.told import Across
from planar_cli.report.kinematics.unit_products import with_products
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.names import index_of
from planar_cli.report.words.counted import as_vector
from planar_cli.report.words.spoken import begun
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.instant import Trial
from planar_cli.solve.instant.led import OF_LENGTH
from planar_cli.solve.instant.written import Written
from planar_cli.units import LENGTH

SHORT = 7
"""So many operations has a component of an arm at most that is told in letters before its number."""
LONGEST = 12
"""A component of an arm with more operations is not written beside the equation."""


class VectorTelling:
    """Vector equations of one system, each told once."""

    def __init__(
        self,
        trial: Trial,
        phrases: Phrases,
        zero: Collection[sp.Symbol] = (),
        open_speeds: Collection[sp.Symbol] = (),
    ) -> None:
        """`open_speeds`: velocity unknowns that nothing tells, and on which no answer rests."""
        self.system, self.phrases, self.zero = trial.system, phrases, frozenset(zero)
        self.open_speeds = frozenset(open_speeds)
        self.edges = {e.body: e for e in self.system.tree.edges}
        self.named: set[sp.Symbol] = set()
        """Coordinates whose values stand on the page."""
        self.given: set[sp.Symbol] = set()
        """Unknowns that the file gives as numbers."""
        self.letters: dict[sp.Symbol, sp.Expr] = {}
        self.late: set[sp.Symbol] = set()
        self.valued: set[str] = set()
        """Points whose vector has its components where it was told first."""
        self.components: Across | None = None
        self.centres: dict[str, Any] = {}
        self.preface: list[Block] = []
        self.opened = False  # stand the lines of the preface on the page?
        self.of_wheels: Callable[[str, Vec, str], Iterator[Block]] | None = None
        """Tells the acceleration of a point of a wheel in letters."""
        self._told: set[str] = set()
        self._arms, self._reaches = dict[str, str](), dict[str, Vec]()

    # --- a relation --------------------------------------------------------------------------------------------------

    def before(self, w: Written, level: str) -> list[Block] | None:
        """What stands before the component of a closing joint; None: its kind of relation has other words."""
        scene = self.system.scene
        if w.source == "coordinate" and w.place in scene.formulas:
            writer = self.phrases.writer
            shared = [f for f in writer.shared(writer(w.left), writer(w.right), turns=True) if f.has(sp.sin, sp.cos)]
            if shared and is_along_path(w, self.system, level):
                told = differentiated(replace(w, words=""), level, self.system.scene, self.phrases)
                return [Paragraph(line(*told, f", {on_path(w, self.edges.values())}:"))]
            divided = line(", divided by ", self.phrases.math(sp.Mul(*shared))) if shared else ()
            return [Paragraph(line(*differentiated(w, level, self.system.scene, self.phrases), *divided, ":"))]
        if w.source == "given" and w.place and (told := stated_rate(w, scene, self.phrases)):
            return [Paragraph(told)]
        joining, self.components = self.closure(w), None
        if joining is None or self.system.motion is None or joining.drift is not None:
            return None
        if any(push.kind == "tension" for push in self.system.modes[joining.joint].facts.pushes):
            tied = tie_told(joining, w, level, self._called(joining), self.system, self.phrases, self._told)
            return [*self._reach(joining, level), *tied]
        if meshing := on_fixed_axles(joining, w, level, self.system):
            return [Paragraph(meshing)]
        known, reach = list(projected(self, joining, w, level)), self._reach(joining, level)
        return [*reach, Paragraph(line(*self._words(joining, w, level), ":")), *known]

    def _reach(self, joining: Joining, level: str) -> list[Block]:
        """The vector equations of the point of a joint, on both of its bodies."""
        tied = any(push.kind == "tension" for push in self.system.modes[joining.joint].facts.pushes)
        # Accelerations of the points that touch differ: each has the name of its body.
        apart = joining.rolling is not None and joining.base != GROUND and level != "velocity"
        blocks = [*self.point(joining.mover, joining.point, joining.place, level, apart)]
        if joining.base != GROUND and not tied:
            other = [*self.point(joining.base, joining.point, self._beside(joining), level, apart)]
            # What hangs on a chain comes before what turns about a pivot of its own.
            later = joining.path is None and self.edges[joining.base].parent != GROUND
            blocks = [*other, *blocks] if later else [*blocks, *other]
            blocks += coincident(self._beside(joining), joining.base, self.valued)
        return blocks

    def frame_of(self, w: Written) -> tuple[str, str] | None:
        """The point and the turning body along which it slides, of a relation that holds a Coriolis acceleration."""
        j = self.closure(w)
        if j is None or j.path is None or j.base == GROUND or j.place not in self.system.scene.points:
            return None
        return (j.place, j.base) if self._symbol(j.base, "velocity") != 0 else None

    def swings(self, w: Written) -> bool:
        """Is it the acceleration along a tie whose ends differ by what was told before?"""
        return w.words != OF_LENGTH and (j := self.closure(w)) is not None and swings(j, self.system)

    def closure(self, w: Written) -> Joining | None:
        if w.source != "closure":
            return None
        return next((j for j in self.system.tree.closures if j.joint == w.lead and j.place), None)

    @staticmethod
    def _beside(joining: Joining) -> str:
        """The point of the base at the place of the joint: one of its own where the mover slides along it."""
        return joining.place + "′" if joining.path is not None else joining.place

    def _words(self, j: Joining, w: Written, level: str) -> Line:
        """Why the component vanishes or agrees."""
        v, place, side = level[0], j.place, self._component(w)
        own = Name(f"{v}_{index_of(place)}")
        if j.rolling is not None:
            return self._rolls(j, w, level)
        if j.base == GROUND and j.path is None:
            return line(f"{place} is fixed, ", own, " = 0; ", side)
        if j.base == GROUND:
            return along_fixed(j, own, level, self.system, self.phrases)
        if j.path is None:
            if (key := f"same {level} {j.joint}") in self._told:
                return line("Likewise ", own, " ", side)
            self._told.add(key)
            return line(f"{j.mover} and {j.base} are joined at {place}, with the same ", own, "; ", side)
        e = unit_beside(self, j)
        relative: list[Any] = [own, " = ", Name(f"{own.name}′"), " + ", Name(f"{v}_rel"), *e]
        if level != "velocity":
            spin = self._symbol(j.base, "velocity")
            relative += coriolis_told(self.phrases.math(spin), e) if spin != 0 else []
        touching = next((p.place for p in self.system.pushes if p.joint == j.joint and p.place not in ("", place)), "")
        touching = touching if not touching or self._is_of_file(touching, j.joint) else "the point of contact"
        slides = f"{touching} slides along {j.base}, {place} moves at a fixed distance from it: " if touching else ""
        relative += ["; along ", Name("n")] if e else ["; ", *across_path(j, v)]
        return line(slides or f"{place} slides along {j.base}: ", *relative)

    def _is_of_file(self, place: str, joint: str) -> bool:
        """Does the file name a point, or did its contact?"""
        problem = self.system.scene.problem
        mark = next((joined.mark for joined in problem.joints if joined.name == joint), None)
        return any(point.name == place and point.mark != mark for point in problem.points)

    def _rolls(self, j: Joining, w: Written, level: str) -> Line:
        """What touches does not slip."""
        side, own = self._component(w), Name(f"{'v' if level == 'velocity' else 'a'}_{index_of(j.place)}")
        if j.base == GROUND and j.drift is None:
            return rolls_on_ground(j, own, level, side)
        spins = [self._symbol(b, "velocity") if b != GROUND else sp.S.Zero for b in (j.mover, j.base)]
        return rolls_on_body(j, w, level, side, spins[0] - spins[1], self.phrases)

    def _component(self, w: Written) -> Line:
        """Which component is taken, and why."""
        if w.words.startswith("so that ") and w.words.endswith(" drops out"):
            name = w.words.removeprefix("so that ").removesuffix(" drops out")
            way = f"along {self._arms[name]}, where " if name in self._arms else "in the direction in which "
            return line(way, Name(name), " does not enter")
        return line(w.words)

    def with_unit(self, words: list[Block], w: Written, level: str) -> list[Block]:
        """The words before a component in numbers, with the unit vector along which it is taken."""
        return with_products(self, words, self.closure(w), w, level) or with_direction(words, w, self.phrases)

    # --- a point -----------------------------------------------------------------------------------------------------

    def point(self, body: str, at: Vec, place: str, level: str, apart: bool = False) -> Iterator[Block]:
        """The vector equations that lead to a point of a body, from the ground on, those that were not told before.
        `apart`: the point has the name of its body beside its own.
        """
        body = self.carrier(body)
        found = self.formula(body, at, place, level)
        if found is None:
            yield from self._slid(body, at, place, level)
            key = f"wheel {body} {place}"
            if level == "acceleration" and self.of_wheels is not None and key not in self._told:
                self._told.add(key)
                yield from self.of_wheels(body, at, place)
            return
        edge, sides, arm = found
        reference = self._reference(edge)
        if edge.joining is not None and not self.rests(edge, level):
            yield from self.point(edge.parent, edge.joining.point, reference, level)
            yield from self._tied(edge, level)
            yield from self._driven(edge, level)
        key = f"{level} {body} {place}"
        if key not in self._told:
            self._told.add(key)
            yield from coincident(place, body, self.valued)
            value = () if place.endswith("′") else known_sides(self, body, at, arm, level)
            self.valued |= {f"{level} {place}"} if value and not apart else set()
            sides = (line(Name(f"{level[0]}_{index_of(place)},{index_of(body)}")), sides[1]) if apart else sides
            if level == "velocity" and self.rests(edge, level):
                yield from touches_at_rest(edge, self.system, self._told)
            yield from with_arm((*sides, *value), bool(value), self.arm_once(place, edge, arm))

    def _tied(self, edge: Edge, level: str) -> Iterator[Block]:
        """Of a point on a taut cord that starts from rest: in which direction it has an acceleration."""
        j = edge.joining
        if j is None or j.base != GROUND or level == "velocity" or edge.slide_rate in (None, *self.zero):
            return
        v = self.motion.velocities[edge.body].linear
        tied = any(push.kind == "tension" for push in self.system.modes[j.joint].facts.pushes)
        if tied and v.x == 0 and v.y == 0 and f"tied {j.place}" not in self._told:
            self._told.add(f"tied {j.place}")
            own, along = Name(f"a_{index_of(j.place)}"), self.phrases.math(edge.slide_rate)
            why = f"{self._called(j)} keeps its length and {j.place} is at rest, so that "
            yield Paragraph(line(why, own, " has no component along it, only ", along, " perpendicular to it"))

    def _driven(self, edge: Edge, level: str) -> Iterator[Block]:
        """The velocity of the point with which a body touches a running belt without slip."""
        j = edge.joining
        if j is None or j.drift is None or j.path is not None or edge.parent != GROUND or level != "velocity":
            return
        if f"driven {j.place}" not in self._told:
            self._told.add(f"driven {j.place}")
            x, y = (self.phrases.math(p) for p in (j.drift.x, j.drift.y))
            joint = next((one for one in self.system.scene.problem.joints if one.name == j.joint), None)
            belt = next((str(n) for n in getattr(joint, "between", ()) if n != j.mover), "the belt")
            sides = (line(Name(f"v_{index_of(j.place)}")), line("[", x, ", ", y, "]"))
            yield Equation(sides, None, note=line(f"as {belt} at {j.place}, no slip"))

    def _called(self, j: Joining) -> str:
        return begun(self.system.scene.problem.called(j.joint))

    def _slid(self, body: str, at: Vec, place: str, level: str) -> Iterator[Block]:
        """The vector equation of what slides along a body that turns."""
        key, found = f"{level} {body} {place}", self.sliding(body, at, place, level)
        if found is not None and key not in self._told:
            self._told.add(key)
            yield Equation((line(Name(f"{level[0]}_{index_of(place)}")), found[0]), None, note=found[1])
            yield from self.along(body)

    def carrier(self, body: str) -> str:
        """The body itself; of a particle that is pinned to another body, that one."""
        edge = self.edges.get(body)
        pinned = edge is not None and edge.particle and edge.joining is not None and edge.joining.path is None
        return self.carrier(edge.parent) if pinned and edge is not None else body

    def formula(self, body: str, at: Vec, place: str, level: str) -> tuple[Edge, tuple[Line, Line], Vec] | None:
        """v_P = v_A + ω × r_P/A of a point of a body, or a_P; with the arm r_P/A. None: the point is the one at which
        the body is joined, the body does not turn, or it has no such equation.
        """
        edge = self.edges.get(body)
        if edge is None or edge.particle:
            return None
        if edge.joining is not None and edge.joining.rolling is not None and (level != "velocity" or edge.backward):
            return None
        if all(self._symbol(body, n) == 0 for n in ("velocity", level)):
            return None
        twists = self.motion.velocities if level == "velocity" else self.motion.accelerations
        arm = self.system.scene.arms.between(twists[body].point, at)
        if all(self.phrases.value.is_zero(p) for p in (arm.x, arm.y)):
            return None
        v, reference = ("v" if level == "velocity" else "a"), self._reference(edge)
        self._arms.setdefault(str(self._symbol(body, level)), f"{reference}{place.rstrip('′')}")
        parts: list[Any] = [] if self.rests(edge, level) else [Name(f"{v}_{index_of(reference)}")]
        for sign, piece in self._turning(body, place, reference, level):
            parts += [f" {sign} " if parts else "-" if sign == "-" else "", *piece]
        return (edge, (line(Name(f"{v}_{index_of(place)}")), line(*parts or ["0"])), arm) if reference else None

    def sliding(self, body: str, at: Vec, place: str, level: str, rigid: bool = False) -> tuple[Line, Line] | None:
        """What slides along a straight line of a body that turns: v_P = ω × r_P/A + v_P/AB e, a_P with the Coriolis
        acceleration, and what stands beside it. `rigid`: of a rigid body. None: the line is fixed, or bends.
        """
        edge = self.edges.get(body)
        if edge is None or edge.particle == rigid or edge.joining is None or edge.joining.base != edge.parent:
            return None
        path, frame = edge.joining.path, self.carrier(edge.parent)
        found = self.formula(frame, at, f"{place}′", level) if path is not None and path.curvature == 0 else None
        if path is None or found is None or edge.slide is None or edge.slide_rate is None:
            return None
        own, (_, carried), arm = found
        spin, e = self._symbol(frame, "velocity"), Name("e")
        known = self.phrases.value.known
        parts: list[Any] = [*carried]
        if level == "velocity" or known(edge.slide_rate) != 0:
            parts += [" + ", self.phrases.math(edge.slide if level == "velocity" else edge.slide_rate), " ", e]
        if level != "velocity" and spin != 0 and known(edge.slide) != 0:
            parts += [" + 2 ", self.phrases.math(spin), " × ", self.phrases.math(edge.slide), " ", e]
        return line(*parts), self.arm_once(place, own, arm)

    def along(self, body: str) -> Iterator[Block]:
        """The unit vector of the line along which something slides, once."""
        joining = self.edges[body].joining
        if joining is not None and joining.path is not None and f"e {joining.base}" not in self._told:
            self._told.add(f"e {joining.base}")
            sides = (line(Name("e")), unit_of(joining.path.tangent, self.phrases))
            yield Equation(sides, None, note=line(f"along {joining.base}"))

    def _turning(self, body: str, place: str, reference: str, level: str) -> Iterator[tuple[str, Line]]:
        """ω × r, or α × r and ω² r, where they are not zero."""
        arm = arm_name(place, reference)
        omega = self._symbol(body, "velocity")
        if level == "velocity":
            if omega != 0:
                yield "+", line(self.phrases.math(omega), " × ", arm)
            return
        alpha = self._symbol(body, "acceleration")
        if alpha != 0:
            yield "+", line(self.phrases.math(alpha), " × ", arm)
        if omega != 0:
            yield "-", line(self.phrases.math(omega**2), " ", arm)

    def _symbol(self, body: str, level: str) -> sp.Expr:
        found = (self.motion.velocities if level == "velocity" else self.motion.accelerations)[body].angular
        spin = self.edges[body].spin if body in self.edges else None
        if level == "velocity" and spin is not None and spin in self.open_speeds:
            return spin
        return sp.S.Zero if found in self.zero else as_vector(found, self.system)

    def _reference(self, edge: Edge) -> str:
        """The point of a body from which its others are reached."""
        if edge.joining is None:
            return centre_of(self.system.scene, edge.body)
        return edge.joining.place

    @property
    def motion(self) -> Motion:
        """Velocities and accelerations of the instant."""
        assert self.system.motion is not None
        return self.system.motion

    def arm_once(self, place: str, edge: Edge, arm: Vec) -> Line:
        """The components of the arm from the point at which a body is joined."""
        return self.arm_told(place, self._reference(edge), arm)

    def arm_told(self, place: str, reference: str, arm: Vec) -> Line:
        """The components of an arm, where they were not told before."""
        key = f"{place.rstrip('′')}/{reference}"
        if key in self._told:
            return ()
        self._told.add(key)
        return self._arm(place, reference, arm)

    def rests(self, edge: Edge, level: str) -> bool:
        """Is the point at which a body is joined at rest, or without acceleration?"""
        motion = self.motion
        linear = (motion.velocities if level == "velocity" else motion.accelerations)[edge.body].linear
        nothing = dict.fromkeys(self.zero, sp.S.Zero)
        return all(sp.sympify(p).xreplace(nothing) == 0 for p in (linear.x, linear.y))

    def _arm(self, place: str, reference: str, arm: Vec) -> Line:
        """The arm in numbers, or in letters where they are short."""
        name = arm_name(place, reference)
        plain = not sp.sympify(arm.x).free_symbols | sp.sympify(arm.y).free_symbols
        if plain or (not self.phrases.symbolic and all(self.phrases.has_numbers(p) for p in (arm.x, arm.y))):
            shown = self.phrases.vector(self.phrases.certain(arm.x), self.phrases.certain(arm.y), LENGTH)
            made = self._constructed(arm) or (as_placed(place, reference, arm, self.system.scene, self.phrases))
            half = half_of(name.name, arm, self._reaches) if made else ()
            self._reaches[name.name] = arm
            return line(name, " = ", *(half or made), *shown)
        if longer(arm.x, LONGEST) or longer(arm.y, LONGEST):
            return ()
        return line(name, " = [", self.phrases.math(arm.x), ", ", self.phrases.math(arm.y), "]")

    def _constructed(self, arm: Vec) -> Line:
        """The components of an arm in letters, where they are short and say more than the numbers."""
        parts = [sp.sympify(p) for p in (arm.x, arm.y)]
        ledger, letters = self.phrases.ledger, {s for p in parts for s in p.free_symbols}
        if all(p.is_Atom for p in parts) or letters & set(ledger.definitions) - self.named:
            return ()
        if any(longer(p, SHORT) or not is_clean(ledger, p, dimension=LENGTH) for p in parts):
            return ()
        return line("[", self.phrases.math(parts[0]), ", ", self.phrases.math(parts[1]), "] = ")
