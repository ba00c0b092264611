"""How a point moves as a body sees it: v_rel = v_P - v_P′, a_cor = 2 ω × v_rel, a_rel = a_P - a_P′ - a_cor; of what
slides along a straight line of the body the component along that line.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.scene.centres import centre_of
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Block, Equation, Line, Name, Paragraph, Value, line
from planar_cli.report.kinematics.along_slots import (
    Slot,
    along_unit_vector,
    component,
    coriolis_size,
    coriolis_way,
    relative_along,
    slot_of,
    unit_told,
    whole_component,
)
from planar_cli.report.kinematics.coincident import coincident
from planar_cli.report.kinematics.component_sums import both_told, in_page_units
from planar_cli.report.kinematics.on_path import Once
from planar_cli.report.kinematics.projected import differences, vector_at
from planar_cli.report.kinematics.told import RATES
from planar_cli.report.kinematics.vectors import VectorTelling
from planar_cli.report.notation.names import index_of, plain_name
from planar_cli.report.words.one_name import pieces_of_name
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.solution import Found
from planar_cli.units import VELOCITY

LEVELS = {"v": ("velocity",), "coriolis": ("velocity",), "a": ("velocity", "acceleration")}
"""What must be told for each kind of relative motion."""
SAME = Decimal("1e-9")
"""How closely two numbers agree that are one."""


class RelativeTelling:
    """Lines of relative motion. `absolute` tells the velocity or acceleration of a point, `carried` those of a point
    of a body.
    """

    def __init__(
        self,
        vectors: VectorTelling,
        once: Once,
        absolute: Callable[[str, str], Iterator[Block]],
        carried: Callable[[str, Vec, str, str], Iterator[Block]],
    ) -> None:
        self.vectors, self.phrases, self.once = vectors, vectors.phrases, once
        self.absolute, self.carried, self.system = absolute, carried, vectors.system
        self.answers: tuple[Found, ...] = ()
        """What is being told."""
        self._along: dict[str, Decimal] = {}
        """The components along lines that were told, in the unit of the page."""
        self._converted: set[str] = set()
        """Answers whose component was told in the unit that is asked."""

    def seen(self, point: str, frame: str, word: str, projected: bool = False) -> Iterator[Block]:
        """All that leads to what is meant by `word`. `projected`: the Coriolis acceleration is told where its component
        is taken.
        """
        slot = slot_of(self.vectors, point, frame)
        relative, _ = self.system.quantities().seen_from(point, frame)
        for level in LEVELS[word]:
            yield from self._vectors(point, frame, level) if slot is None else self._component(slot, level)
        if word == "coriolis" and (slot is None or not projected):
            yield from self._coriolis(relative, self.vectors.motion.velocities[frame].angular)

    def _component(self, slot: Slot, level: str) -> Iterator[Block]:
        """along e: v_rel = v_P · e = 0.8660 · 0.8619 = 0.7464 m/s."""
        key = f"{level[0]}_rel {slot.point} {slot.frame}"
        if key in self._along:
            return
        for name in (slot.point, slot.reference):
            yield from self.absolute(name, level[0])
        sides, value = relative_along(self.vectors, slot, level)
        self._along[key] = value
        before = whole_component(self.vectors, slot) if level == "acceleration" else ()
        if f"e {slot.frame}" not in self.vectors.valued:
            self.vectors.valued.add(f"e {slot.frame}")
            unit = Paragraph(line(*unit_told(self.vectors, slot)))
            if self.vectors.opened:
                yield unit
            else:
                self.vectors.preface.append(unit)
        lead = along_unit_vector(self.vectors, slot)
        if before:
            yield Equation(before, None, lead)
        yield Equation((*sides, *self._shown(value, slot, level)), None, line("so that:") if before else lead)

    def _shown(self, value: Decimal, slot: Slot, level: str) -> list[Value]:
        """In the unit of the page; and, where that component is an answer of its own name, in the one that is asked."""
        one, v = self.phrases.of_dimension(Decimal(1), RATES[level]), level[0]
        for answer in self.answers:
            q = answer.find.found.what if answer.find is not None else None
            asked = isinstance(q, Quantity) and (q.word, tuple(q.things)) == (v, (slot.point, slot.frame))
            if not asked or answer.values is None or plain_name(answer.name) != plain_name(f"{v}_rel"):
                continue
            values = self.phrases.in_units(answer.values[0], answer.unit)
            if len(values) > 1 and abs(values[0].number - value) <= SAME * abs(value):
                self._converted.add(answer.name)
                return values
        return [Value(value, one.unit, one.figures)]

    def part(self, answer: str, q: Quantity, axis: Sequence[Decimal], values: list[Value]) -> list[Block] | None:
        """The line of what is asked after the component along a line was told: v_slot = v_rel,
        |a_cor| = 2 |ω| |v_rel|; empty where that was the line itself. None: no component was told. `axis`: along which
        it is asked, if any.
        """
        point, frame = q.things
        v, slot = "a" if q.word == "a" else "v", slot_of(self.vectors, point, frame)
        along = self._along.get(f"{v}_rel {point} {frame}")
        if along is None or slot is None:
            return None
        name = "a_cor" if q.word == "coriolis" else f"{v}_rel"
        own = [] if plain_name(answer) == plain_name(name) else [line(Name(answer))]
        if q.word == "coriolis":
            told = coriolis_size(self.vectors, slot)
            way = coriolis_way(self.vectors, slot)
            return [Equation((*own, line("|", Name(name), "|"), *told, *values), None, note=way)]
        if q.parts[-1].kind == "mag":
            size = [Equation((*own, line("|", Name(name), "|"), *values))]
            return [] if not own and along >= 0 else [*size]
        against = sum((e * x for e, x in zip(slot.unit, axis, strict=True)), Decimal(0)) < 0
        along_line = component(self.vectors, slot, v)
        if not own and not against:
            return [Equation((along_line, *values))] if len(values) > 1 and answer not in self._converted else []
        shown = line("-", *along_line) if against else along_line
        return [Equation((line(Name(answer)), shown, *values))]

    def _vectors(self, point: str, frame: str, level: str) -> Iterator[Block]:
        quantities, motion, v = self.system.quantities(), self.vectors.motion, level[0]
        place, spin = self.system.scene.point(point), motion.velocities[frame].angular
        relative, acceleration = quantities.seen_from(point, frame)
        yield from self.absolute(point, v)
        own = self._called(point)
        yield from coincident(f"{own}′", frame, self.vectors.valued)
        yield from self.carried(frame, place, f"{own}′", level)
        sides: list[Any] = [Name(f"{v}_{index_of(own)}"), " - ", Name(f"{v}_{index_of(own)}′")]
        others = [vector_at(self.vectors, frame, place, level)]
        if level == "acceleration" and spin != 0:
            sides += [" - ", Name("a_cor")]
            others += [relative.turned() * (2 * spin)]
            yield from self._coriolis(relative, spin)
        put = differences(relative if v == "v" else acceleration, others, RATES[level], self.phrases)
        shown = (line(Name(f"{v}_rel")), line(*sides), *([put] if put else []))
        yield from self.once(f"{v}_rel {point} {frame}", shown, relative if v == "v" else acceleration, level, ())

    def _called(self, point: str) -> str:
        """What the lines of a particle call it: B where its letters do, v_B,arm; its own name where they have that."""
        edge = self.vectors.edges.get(point)
        if point in self.system.scene.points or edge is None or edge.slide is None:
            return point
        own = centre_of(self.system.scene, point)
        letters = {piece for s in sp.sympify(edge.slide).free_symbols for piece in pieces_of_name(s.name)}
        return own if own in letters else point

    def _coriolis(self, relative: Vec, spin: sp.Expr) -> Iterator[Block]:
        put: Line = ()
        if not self.phrases.symbolic:
            omega, (along, across) = self.phrases.certain(spin), in_page_units(relative, VELOCITY, self.vectors)
            factors = ((Decimal(2), 1), (omega, 1))
            terms = [[(sign, (*factors, (v, 1)))] if v else [] for sign, v in ((-1, across), (1, along))]
            put = both_told(terms, self.phrases.figures)
        formula = line("2 ", self.phrases.math(spin), " × ", Name("v_rel"))
        sides = (line(Name("a_cor")), formula, *([put] if put else []))
        yield from self.once(f"a_cor {spin} {relative}", sides, relative.turned() * (2 * spin), "acceleration", ())


def is_told(seen: tuple[str, str], stage: Stage, vectors: VectorTelling, at_once: Collection[tuple[int, int]]) -> bool:
    """Have the lines so far told how a point moves as a body sees it, and how that body turns? `at_once`: equations of
    stages that are their own solution.
    """
    point, frame = seen
    relative, _ = vectors.system.quantities().seen_from(point, frame)
    spin = vectors.motion.velocities[frame].angular
    inside = spin.free_symbols | relative.x.free_symbols | relative.y.free_symbols
    solved = {
        x.symbol
        for x in (x for b in stage.blocks for x in b.lines)
        if x.equations and all((id(stage.algebra), n) in at_once for n in x.equations)
    }
    return not inside & (vectors.late - vectors.given - solved)
