"""What is decided about a scene by numbers: the draws of its letters, signs, and sides on which places lie."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from decimal import Decimal, DecimalException
from functools import partial
from typing import TYPE_CHECKING, Any, cast

import sympy as sp

from planar_cli.equation.algebra.common_factors import factor_terms
from planar_cli.equation.algebra.plain import derivative, letters, simplified
from planar_cli.equation.scene.bodies import BodyModel
from planar_cli.equation.scene.displacement import Displacement
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Ledger
from planar_cli.errors import FileProblem, Mark, NoValue, refuse
from planar_cli.problem.language.expression import Quantity, Relation, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.outlines import Outlined, hub_of
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.scene.shapes import drawn_by
from planar_cli.units import LENGTH

FEW = 12
"""So many draws are tried where every try solves the scene."""
PART = Decimal("0.45")
"""A length that is assumed to be less than another one is drawn as less than this part of it."""
LENGTH_OF = "length {}{}"
"""Title of a distance between two points that has a letter."""


class Decided:
    """The part of a scene that decides. `sides`: on which sides places are, |x|, from which distances are measured;
    `sided`: those that were asked for, each with its sign and the place;
    `facings`: on which sides of circles contacts are looked at first, as drawn; `headed`: the signs with which speeds
    were written that are given by their size.
    """

    problem: Problem
    ledger: Ledger
    displacement: Displacement | None
    points: dict[str, Vec]
    bodies: dict[str, BodyModel]
    sides: Mapping[str, int]
    sided: dict[str, tuple[int, sp.Expr]]
    facings: Mapping[str, int]
    headed: dict[str, tuple[int, sp.Symbol]]

    def undecided(self) -> None:
        """Nothing is decided yet."""
        self._valuations: tuple[Valuation, ...] | None = None
        self._decided: dict[Any, int] = {}
        self._supposes = False
        self.sides, self.sided, self.facings, self.headed = {}, {}, {}, {}

    if TYPE_CHECKING:

        def value(self, side: Side) -> sp.Expr: ...
        def length(self, v: Vec) -> sp.Expr: ...

    def reach_by_letter(self, reach: Vec, ends: tuple[str, str]) -> sp.Expr:
        """|r|; at one instant AB for √(x² + y²) of given coordinates, so that no root is carried through the page."""
        length, ledger = self.length(reach), self.ledger
        given = length.free_symbols
        if not length.is_Pow or self.displacement is not None or ledger.symbolic or len(given) < 2:
            return length
        if not given <= set(ledger.coordinates) & ledger.values.keys() or not all(len(e) == 1 for e in ends):
            return length
        name, title = "".join(ends), LENGTH_OF.format(*ends)
        known = next((s for s, t in ledger.titles.items() if t == title and ledger.definitions[s] == length), None)
        return ledger.define(name, length, "m", title, positive=True) if known is None else known

    def drawn_by(self, body: str) -> tuple[str, ...]:
        """The points by which a body of no particular shape is drawn; of any other body none."""
        return next((drawn_by(b) for b in self.problem.bodies if b.name == body), ())

    def hub(self, body: str, point: Vec) -> Vec:
        """The centre of the rim through a point of a body, about which a cord there is wound."""
        return hub_of(cast("Outlined", self), body, point)

    def faced(self, joint: str) -> int:
        """The side on which a contact is first looked at, as drawn (Mode.side); 0: this is the drawing."""
        return self.facings.get(joint, 0)

    def came_from(self, joint: str, off: Any) -> None:
        """No motion is at hand that would tell it."""

    def redraw(self, holds: Callable[[Valuation], bool], tries: int = FEW) -> bool:
        """Take draws for which this holds as well. False: none was found among so many."""
        found = self.ledger.valuations(lambda v: self._agrees(v) and holds(v), tries)
        self._valuations = found or self._valuations
        return bool(found)

    def forget_valuations(self) -> None:
        """Draw the numbers anew when they are asked for again: symbols were added."""
        self._valuations = None

    @contextmanager
    def supposing(self, valuation: Valuation) -> Iterator[None]:
        """Signs as they are with these numbers."""
        kept, self._valuations, self._supposes = self._valuations, (valuation,), True
        try:
            yield
        finally:
            self._valuations, self._supposes = kept, False

    @property
    def valuations(self) -> tuple[Valuation, ...]:
        """Numbers for everything known, and for letters draws in which what is assumed holds."""
        if self._valuations is None:
            self._valuations = self._draws(self._agrees) or self._draws(self._assumed)
            if not self._valuations:
                raise self._nowhere()
            self.ledger.above_zero = tuple(self._above_zero())
        return self._valuations

    def _draws(self, holds: Callable[[Valuation], bool]) -> tuple[Valuation, ...]:
        """Draws for which something holds, with lengths well apart where there are such, as in a drawing."""
        pairs = list(self._unlike())

        def apart(value: Valuation) -> bool:
            return holds(value) and all(value(less) < PART * value(more) for less, more in pairs)

        return (self.ledger.valuations(apart) if pairs else ()) or self.ledger.valuations(holds)

    def _unlike(self) -> Iterator[tuple[sp.Expr, sp.Expr]]:
        """The letters of lengths of which `assume` says that one is less than the other."""
        for relation in self.problem.assume:
            if isinstance(relation, Relation) and relation.operator in ("<", ">"):
                sides = self.value(relation.left), self.value(relation.right)
                less, more = sides if relation.operator == "<" else sides[::-1]
                units = [self.ledger.units.get(side) for side in (less, more)]
                if less.is_Symbol and more.is_Symbol and all(u is not None and u.dimension == LENGTH for u in units):
                    yield less, more

    def _above_zero(self) -> Iterator[sp.Expr]:
        """The sums that `assume` says to be positive, and masses of what loses some."""
        masses = [b.mass for b in self.problem.bodies if b.mass is not None]
        for side in (m for m in masses if not any(isinstance(node, Quantity) for node in walk(m))):
            mass = factor_terms(self.value(side))
            if mass.is_Add and self.ledger.symbols.get("t") in mass.free_symbols:
                yield mass
        for relation in self.problem.assume:
            if isinstance(relation, Relation) and relation.operator in ("<", ">"):
                sides = self.value(relation.left), self.value(relation.right)
                difference = factor_terms(sides[0] - sides[1])
                if difference.is_Add:
                    yield difference if relation.operator == ">" else -difference

    def _nowhere(self) -> FileProblem:
        """No numbers were found: which of the assumptions does not go with those before it, else the lengths do not."""
        assumed = [a for a in self.problem.assume if isinstance(a, Relation)]
        for k, last in enumerate(assumed):
            if not self.ledger.valuations(partial(self._all_hold, assumed[: k + 1])):
                before = " and ".join(f"`{r.text}`" for r in assumed[:k])
                text = f"no numbers were found for which `{last.text}` holds{before and f' beside {before}'}"
                return refuse(last.mark, "PL532", text, "change or leave out one of them")
        if assumed:
            text = "no numbers were found for which every length is real and `assume` holds"
            return refuse(assumed[0].mark, "PL532", text, "look at places told by two distances")
        for valuation in self.ledger.valuations(lambda _: True, 1):
            self._demand_no_zero_divisor(valuation)
        text = "no position was found near the drawn one in which the joints hold and every length is real"
        return refuse(Mark(self.problem.file, 1, 1), "PL532", text, "draw the points nearer to where the joints hold")

    def _demand_no_zero_divisor(self, valuation: Valuation) -> None:
        """NoValue: a place divides by what is zero where it is drawn, as by the distance of points that coincide."""
        try:
            self._assumed(valuation)
        except NoValue as error:
            if isinstance(error.__cause__, DecimalException):
                raise

    def _all_hold(self, relations: Iterable[Relation], valuation: Valuation) -> bool:
        return all(self.compare(r, valuation) for r in relations)

    def _assumed(self, valuation: Valuation) -> bool:
        for place in self.points.values():
            valuation(place.x), valuation(place.y)
        inertias = [b.inertia for b in self.bodies.values() if b.inertia.free_symbols]
        # One about a point grows with the distance of the mass centre from it: no body has less than that.
        if any((valuation.known(i) or 0) < 0 for i in inertias):
            return False
        return all(self.compare(r, valuation) for r in self.problem.assume)

    def compare(self, relation: Any, valuation: Valuation) -> bool:
        """Does a relation between names hold with these numbers?"""
        difference = self.value(relation.left) - self.value(relation.right)
        value = valuation(difference)
        return {"<": value < 0, ">": value > 0, "<=": value <= 0, ">=": value >= 0, "=": valuation.is_zero(difference)}[
            relation.operator
        ]

    # --- signs -------------------------------------------------------------------------------------------------------

    def sign(self, expr: Any) -> int:
        """-1, 0 or 1, decided to all certain digits."""
        valuation = self.valuations[0]
        if valuation.is_zero(expr):
            return 0
        found = 1 if valuation(expr) > 0 else -1
        if not self._supposes:
            self._decided[expr] = found
            if not all(self._agrees(v) for v in self.valuations[1:]):
                self._valuations = self._draws(self._agrees) or self._valuations
        return found

    def _agrees(self, valuation: Valuation) -> bool:
        """Does a draw have what is assumed, and every sign that was decided before?"""
        return self._assumed(valuation) and all(sign * valuation(e) > 0 for e, sign in self._decided.items())

    def as_drawn(self, expr: Any) -> Any:
        """An expression of a general position where the file draws it."""
        if self.displacement is None:
            return expr
        return expr.xreplace({c.symbol: c.drawn for c in self.displacement.coordinates if c.drawn is not None})

    def on_side(self, expr: Any, drawn: int) -> Any:
        """|a| of a place, as a or -a: on the side where it is drawn, or the one that `sides` names; it is kept in mind
        in `sided`, as the place may come to the other side.
        """
        varying = {*self.ledger.coordinates}
        if self.displacement is not None:
            varying |= {c.symbol for c in self.displacement.coordinates}
        if self.displacement is None or not expr.free_symbols & varying:
            return expr if drawn > 0 else -expr
        return self._kept_in_mind(expr, drawn)

    def one_way(self, pace: Any) -> Any:
        """|v| of a speed in a general position, as v or -v in the same manner: the motion may go the other way."""
        return self._kept_in_mind(pace, 1)

    def _kept_in_mind(self, expr: Any, drawn: int) -> Any:
        plain = -expr if expr.could_extract_minus_sign() else expr
        key = f"|{plain}|"
        # Numbers of a constant that is sought may lie on either side; what has been decided holds for all that ask.
        earlier = self.sided.get(key, (0, plain))[0]
        way = self.sides.get(key) or earlier or (drawn if plain == expr else -drawn) or 1
        self.sided[key] = way, plain
        return way * plain

    def heading_of(self, speed: sp.Symbol, told: int) -> int:
        """The sign of a speed that is given by its size: the one that `sides` names, else the one that is told; it is
        kept in mind in `headed`, as the motion may arrive the other way.
        """
        key = f"|{speed}|"
        way = self.sides.get(key, told)
        self.headed[key] = way, speed
        return way

    def presumed(self) -> tuple[Any, ...]:
        """What is positive in the scene as it was drawn, though letters may be had with which it is not."""
        return self.not_always_positive(e * sign for e, sign in self._decided.items() if e.free_symbols)

    def decided_with(self, symbols: frozenset[Any]) -> tuple[Any, ...]:
        """What was decided to be positive of expressions in which some of these stand."""
        return tuple(e * sign for e, sign in self._decided.items() if e.free_symbols & symbols)

    def not_always_positive(self, exprs: Iterable[Any]) -> tuple[Any, ...]:
        """Those of the expressions that are negative for some letters with which `assume` holds."""
        told = [e for e in dict.fromkeys(exprs) if not e.is_nonnegative]
        draws = self.ledger.far_draws(self._assumed) if told and self.ledger.letters else ()
        return tuple(e for e in told if any(_negative(e, d) for d in draws))

    def everywhere(self) -> tuple[Valuation, ...]:
        """Many draws of the letters, from decades, with which assumptions hold and signs are as decided."""
        far = self.ledger.far_draws(self._assumed) if self.ledger.letters else ()
        signs = [e * sign for e, sign in self._decided.items() if e.free_symbols]
        return (*self.valuations, *(d for d in far if not any(_negative(e, d) for e in signs)))

    def without_bars(self, expr: sp.Expr) -> sp.Expr:
        """|a - b| of letters alone is the difference that is positive for all letters with which assumptions hold.
        Beside bars of another kind they stay, as all may go together.
        """
        known = set(self.ledger.letters)
        inside = [e.args[0] for e in expr.atoms(sp.Abs)]
        inside = inside if all(a.is_Add and a.free_symbols <= known for a in inside) else []
        draws = self.everywhere() if inside else ()
        ways: dict[sp.Expr, sp.Expr] = {}
        for a in inside:
            numbers = [number for d in draws if (number := d.known(a)) is not None]
            if numbers and len({number > 0 for number in numbers}) == 1 and all(numbers):
                ways[sp.Abs(a)] = a if numbers[0] > 0 else -a
        return sp.sympify(expr.xreplace(ways)) if ways else expr

    def is_zero(self, expr: Any) -> bool:
        return expr == 0 or all(v.is_zero(expr) for v in self.valuations)

    def are_same(self, a: Any, b: Any) -> bool:
        """Are two numbers the same?"""
        return self.is_zero(a - b)

    def steady(self, direction: Vec) -> Vec | None:
        """A direction written with what moves, without it where it stays the same for the numbers of the file."""
        if self.displacement is None:
            return None
        inside = {*letters(direction.x), *letters(direction.y)}
        own = [c for c in self.displacement.coordinates if c.symbol in inside]
        if not own or any(c.drawn is None for c in own) or inside & {*self.ledger.coordinates}:
            return None
        slopes = (derivative(e, c.symbol) for c in own for e in (direction.x, direction.y))
        if not all(self.is_zero(slope) for slope in slopes):
            return None
        upright, level = self.is_zero(direction.x), self.is_zero(direction.y)
        if upright or level:
            way = sp.Integer(1 if self.valuations[0](direction.y if upright else direction.x) > 0 else -1)
            return Vec(sp.S.Zero, way) if upright else Vec(way, sp.S.Zero)
        return Vec(*(simplified(self.as_drawn(e)) for e in (direction.x, direction.y)))

    def vanishes(self, expr: Any) -> bool:
        """Is it zero in all that this scene may be?"""
        return self.is_zero(expr)


def _negative(expr: Any, valuation: Valuation) -> bool:
    return (valuation.known(expr) or 0) < 0
