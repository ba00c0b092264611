"""Named intermediates with the lines that show how they were found: places, masses and moments of inertia."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.system.system import System
from planar_cli.problem.language.expression import Quantity
from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Value, line
from planar_cli.report.equations.solving import SolvingTelling
from planar_cli.report.kinematics.geometry import measured
from planar_cli.report.kinematics.vectors import VectorTelling
from planar_cli.report.kinetics.damper_rates import rate_of_length
from planar_cli.report.kinetics.inertias import (
    alike_together,
    before_product,
    by_size,
    from_apex,
    in_one_product,
    in_twelfths,
    is_sought,
)
from planar_cli.report.kinetics.parts import in_parts
from planar_cli.report.notation.clean import is_clean
from planar_cli.solve.instant.tangent_angle import GROOVE, TANGENT
from planar_cli.solve.solution import Found
from planar_cli.units import LENGTH

OF_ASKED = 60
"""What is itself asked is told by its formula up to this number of operations."""
ASKED_ALONE = re.compile(r"\bmass\b|^moment of inertia|^momentum per second")
"""Of what, by its title, a line leads to an answer that no equation leads to. Places have lines of their own."""

CENTRE, ARM = " of the mass centre of ", "from the mass centre to that of "
"""What the titles have in common of coordinates of mass centres, and of the arms of their parts."""


class DefinitionTelling:
    """Lines of what the scene names on the way, each told once.

    `constructed`: the letters of each point that is told by its construction; `long`: what has a formula of more
    operations is given by its value alone; None: by its formula all the same.
    """

    def __init__(
        self,
        system: System,
        solving: SolvingTelling,
        vectors: VectorTelling,
        constructed: Mapping[str, Collection[sp.Symbol]],
        long: int | None,
    ) -> None:
        self.system, self.scene, self.phrases = system, system.scene, solving.phrases
        self.solving, self.vectors = solving, vectors
        self.constructed, self.long = constructed, long

    def lines(self, used: Iterable[sp.Symbol], kind: str, least: int = 0) -> list[Equation]:
        """Those on which the letters `used` rest: coordinates (kind "m") with the masses that make them, other masses
        and moments of inertia ("kg"); with formulas of so many operations at `least`.
        """
        ledger = self.scene.ledger
        wanted = self._behind(used)
        places = {s for s in wanted & set(ledger.definitions) if self._is_place(s)}
        first = places | (self._behind(places) if places else set())
        blocks: list[Equation] = []
        for symbol, expr in ledger.definitions.items():
            title = ledger.titles[symbol]
            if (
                symbol in wanted
                and (symbol in first) == (kind == "m")
                and not (expr.is_number and title.startswith("mass"))
                and not self._is_of_groove(title)
            ):
                blocks += self._line(symbol, expr, self._is_length(symbol), OF_ASKED if CENTRE in title else least)
        return alike_together(blocks)

    def _is_of_groove(self, title: str) -> bool:
        """Is it told where the groove is? ψ is not where the forces tell how the point slides in it."""
        return title.startswith(GROOVE) and not (
            title.startswith(GROOVE + TANGENT) and TANGENT not in self.vectors.valued
        )

    def _is_length(self, symbol: sp.Symbol) -> bool:
        return self.scene.ledger.units[symbol].text == "m"

    def _is_place(self, symbol: sp.Symbol) -> bool:
        """A coordinate, not the arm of a parallel axis."""
        return self._is_length(symbol) and not self.scene.ledger.titles[symbol].startswith(ARM)

    def of_asked(self, found: Iterable[Found]) -> list[Block]:
        """Masses, mass centres, moments of inertia and streams that are asked and stand in no equation."""
        ledger = self.scene.ledger
        inside: set[sp.Symbol] = set()
        for one in found:
            what = one.find.found.what if one.find is not None else None
            if not (isinstance(what, Quantity) and what.word == "KE"):
                inside |= {s for e in one.asked for s in e.free_symbols if not is_sought(s, ledger)}
        alone = {s for s in inside & set(ledger.definitions) if ASKED_ALONE.search(ledger.titles[s])}
        inside = {s for s in self._behind(alone) & set(ledger.definitions) if s not in self.vectors.named}
        return [*self.lines(inside, "m", OF_ASKED), *self.lines(inside, "kg", OF_ASKED)]

    def _behind(self, used: Iterable[sp.Symbol]) -> set[sp.Symbol]:
        wanted, definitions = set(used), self.scene.ledger.definitions
        for symbol in reversed(list(definitions)):
            if symbol in wanted:
                wanted |= definitions[symbol].free_symbols
        return wanted

    def _of_inertia(self, symbol: sp.Symbol, expr: sp.Expr, value: Value) -> tuple[Inline | Line, ...]:
        """I_A = I + m (l/2)² = 1/3 m l² with the numbers of the last; empty where the formula says as much itself."""
        whole, shown = in_one_product(symbol, expr, self.phrases), in_twelfths(expr)
        if not self.solving.numeric.readable(expr) or (whole is None and shown == expr):
            return ()
        forms = [self.phrases.math(shown), *([] if whole is None else [self.phrases.math(whole)])]
        put = self.phrases.substituted(shown if whole is None else whole, value)
        return (self.phrases.math(symbol), *forms, *put, value)

    def _line(self, symbol: sp.Symbol, expr: sp.Expr, is_length: bool, least: int) -> list[Equation]:
        ledger = self.scene.ledger
        self.vectors.named.add(symbol)
        value = self.phrases.shown(symbol)
        hidden = self.long is not None and longer(expr, max(self.long, least))
        if hidden and any(symbol in symbols for symbols in self.constructed.values()):
            return []
        sides = (self.phrases.math(symbol), value) if hidden else self.solving.chain(symbol, expr, value)
        if not hidden and not self.phrases.symbolic and (told := self._of_inertia(symbol, expr, value)):
            sides = told
        if sized := by_size(symbol, self.scene, self.phrases, not self.phrases.symbolic):
            valued = self.phrases.symbolic and any(isinstance(side, Value) for side in sides)
            rest = sides[2:] if valued else (*sized[1:], *(() if self.phrases.symbolic else (value,)))
            sides = (sides[0], sized[0], *rest)
        if ledger.titles[symbol].startswith("moment of inertia") and not hidden:
            sides = (sides[0], *before_product(symbol, self.scene, self.phrases), *sides[1:])
        if root := measured(expr, self.phrases):
            sides = (sides[0], root, value)
        if is_length and not self.phrases.symbolic and (hidden or not is_clean(ledger, expr, dimension=LENGTH)):
            parts = in_parts(ledger.titles[symbol], self.scene, self.phrases)
            sides = (sides[0], *parts, value) if parts else sides
        if is_sought(symbol, ledger):
            sides = sides[:2]
        return [
            *rate_of_length(symbol, expr, self.system, self.phrases),
            *from_apex(symbol, self.scene, self.phrases),
            Equation(sides, None, line(ledger.titles[symbol].removeprefix(GROOVE) + ":")),
        ]
