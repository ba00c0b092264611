"""Comparison of what a solution found with the `answers:` that a file states: in base units, to sixty digits.

A number agrees when it lies within a relative tolerance of what is stated. A true zero has no relative error, so a
small share of the problem's own scale (the largest given quantity of that dimension) is allowed on top. A formula is
compared at random points of its letters; one without rounded numbers must agree to all digits.
"""

from __future__ import annotations

from collections.abc import Iterable
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import PRINTABLE, longer
from planar_cli.equation.values.evaluate import Evaluator
from planar_cli.equation.values.exact import PI, Valuation
from planar_cli.equation.values.ledger import Ledger, display
from planar_cli.homework.checking.curves import same_curve
from planar_cli.homework.checking.verdict import FLOOR, TOLERANCE, Verdict
from planar_cli.problem.language.expression import Number, Quantity, Side, Word
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Answer, Problem
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution, Solution

EXACT = Decimal("1e-20")
"""What a formula without rounded numbers is held to."""

MOST_TOLD = 6
"""Names with the values for which a solution was made."""
ONE_WAY_OR_THE_OTHER = frozenset(("v", "a", "omega", "alpha", "friction", "reaction", "impulse", "momentum", "H"))
"""Quantities whose sign is a sense; that of a coordinate, of a work or of a force that presses is a sign."""
LONGEST = 160
TOO_LONG = f"a formula of more than {PRINTABLE} operations"
"""Longer formulas are cut in messages."""


def compare(solution: Solution) -> tuple[Verdict, ...]:
    """A verdict for every answer that the file states, in its order."""
    found = {f.name: (f, part) for part in solution.parts for f in part.found}
    verdicts = []
    for answer in solution.problem.answers:
        if answer.name in found and found[answer.name][1].followed is not None:
            verdicts.append(_read_off(solution.problem, answer, *found[answer.name]))
        elif answer.name in found:
            verdicts.append(_Comparison(solution.problem, answer, *found[answer.name]).verdict())
        else:
            verdicts.append(Verdict(answer.name, "", "", False, None, f"{answer.name} was not found"))
    return tuple(verdicts)


def _read_off(problem: Problem, answer: Answer, found: Found, part: PartSolution) -> Verdict:
    """One answer against what was read off a motion; imported when needed."""
    from planar_cli.homework.checking.read_off import verdict_on

    assert part.followed is not None
    return verdict_on(problem, answer, found, part.followed)


class _Comparison:
    """One answer against its find, with the names of the part in which it was found."""

    def __init__(self, problem: Problem, answer: Answer, found: Found, part: PartSolution) -> None:
        self.problem, self.answer, self.found = problem, answer, found
        last = part.instants[-1]
        self.scene, self.value, self.stages = last.instant.scene, last.value, last.stages
        self.ledger: Ledger = self.scene.ledger
        self.evaluator: Evaluator = self.scene.evaluator

    def verdict(self) -> Verdict:
        stated = self.answer.value
        if isinstance(stated, bool | Word):
            return self._words(str(stated).lower() if isinstance(stated, bool) else stated.word)
        if isinstance(stated, str):
            agrees = same_curve(stated, self.found.expressions or (), self.evaluator, self.scene.valuations)
            return self._told(stated, self._formulas(), agrees, None)
        sides = stated if isinstance(stated, tuple) else (stated,)
        exprs = tuple(self.evaluator.value(s) for s in sides)
        if self.found.word or len(exprs) != self._count():
            if self._is_list() and self.found.values is not None:
                return self._told(
                    self._shown(tuple(map(self._number, exprs))), self._shown(self.found.values), False, None
                )
            return self._told(_joined(exprs), self.found.word or self._formulas(), False, None)
        if self.found.values is None:
            return self._symbols(sides, exprs)
        return self._numbers(exprs, self.found.values)

    def _count(self) -> int:
        return len(self.found.values or self.found.expressions or ())

    def _words(self, stated: str) -> Verdict:
        solved = self.found.word or "no verdict"
        return self._told(stated, solved, stated == solved, None)

    def _told(self, stated: str, solved: str, agrees: bool, error: Decimal | None, reversed_: bool = False) -> Verdict:
        """`error`: relative; `reversed_`: what is stated is the opposite of what is right."""
        message = "" if agrees else f"{self.answer.name}: the file states {stated}, the solution gives {solved}"
        if message and reversed_:
            message += f" (the same size, the opposite {'sense' if self._has_sense() else 'sign'})"
        elif message and error is not None:
            message += f" ({_percent(error)} off)"
        first = [f"{s.name} = {s.written}" for s in self.problem.given if s.varies]
        if message and first:
            own = "the first value of its range" if len(first) == 1 else "the first values of their ranges"
            message += f"; it is for {', '.join(first[:MOST_TOLD])}{', …' * (len(first) > MOST_TOLD)}, {own} in `given`"
        return Verdict(self.answer.name, stated, solved, agrees, error, message)

    # --- numbers -----------------------------------------------------------------------------------------------------

    def _numbers(self, exprs: tuple[sp.Expr, ...], solved: tuple[Decimal, ...]) -> Verdict:
        stated = tuple(self._number(e) for e in exprs)
        texts = self._shown(stated), self._shown(solved)
        if any(not s.is_finite() for s in (*stated, *solved)):
            return self._told(*texts, stated == solved, None)
        if self._is_list():
            return self._one_by_one(stated, solved)
        size = _size(stated)
        off = _size(tuple(self._difference(a, b) for a, b in zip(solved, stated, strict=True)))
        tolerance = self.tolerance()
        agrees = off <= tolerance * size + FLOOR * tolerance * self._scale()
        opposite = _size(tuple(a + b for a, b in zip(solved, stated, strict=True))) <= tolerance * size != 0
        return self._told(*texts, agrees, off / size if size else None, opposite)

    def _has_sense(self) -> bool:
        """Does what is asked point, or turn, one way or the other?"""
        what = self.found.find.found.what if self.found.find is not None else None
        return self._count() > 1 or (isinstance(what, Quantity) and what.word in ONE_WAY_OR_THE_OTHER)

    def _is_list(self) -> bool:
        return self.found.kind == "list"

    def _one_by_one(self, stated: tuple[Decimal, ...], solved: tuple[Decimal, ...]) -> Verdict:
        """Numbers of a list, each against its own."""
        tolerance = self.tolerance()
        errors = [abs(a - b) / abs(b) if b else abs(a - b) for a, b in zip(solved, stated, strict=True)]
        error = max(errors, default=Decimal(0))
        return self._told(self._shown(stated), self._shown(solved), error <= tolerance, error)

    def _number(self, expr: sp.Expr) -> Decimal:
        return Decimal(str(expr).replace("oo", "Infinity")) if expr.is_infinite else self.value(expr)

    def _difference(self, a: Decimal, b: Decimal) -> Decimal:
        """a - b; a direction is the same after a whole turn."""
        off = abs(a - b)
        what = self.found.find.found.what if self.found.find is not None else None
        if isinstance(what, Quantity) and what.parts and what.parts[-1].kind == "angle" and what.word != "r":
            off = min(off, abs(off - 2 * PI))
        return off

    def _scale(self) -> Decimal:
        """The largest given quantity of the find's dimension; its own unit where there is none."""
        unit = self.found.unit
        sizes = []
        for symbol, expr in self.ledger.values.items():
            known = self.ledger.units.get(symbol)
            if known is not None and known.dimension == unit.dimension:
                sizes.append(abs(self.value.known(expr) or Decimal(0)))
        return max(sizes, default=Decimal(0)) or Decimal(1) / display(Decimal(1), unit, self.ledger.us)

    def tolerance(self) -> Decimal:
        """Relative: of this answer, else of the file, else one per cent."""
        for side in (self.answer.tolerance, self.problem.tolerance):
            if side is not None:
                return self.value(self.evaluator.value(side))
        return TOLERANCE

    # --- formulas ----------------------------------------------------------------------------------------------------

    def _symbols(self, sides: tuple[Side, ...], exprs: tuple[sp.Expr, ...]) -> Verdict:
        """Both formulas at the same random points of the letters that remain."""
        rounded = any(_is_rounded(side) for side in sides) or self.answer.tolerance is not None
        tolerance = self.tolerance() if rounded else EXACT
        solved = self.found.expressions or ()
        texts = _joined(exprs), self._formulas()
        errors = []
        for draw in self._draws((*exprs, *solved)):
            wanted = tuple(draw(e) for e in exprs)
            offs = tuple(draw(a) - w for a, w in zip(solved, wanted, strict=True))
            # The parts of a vector are judged by its size, the numbers of a list each by its own.
            pairs = [((w,), (o,)) for w, o in zip(wanted, offs, strict=True)] if self._is_list() else [(wanted, offs)]
            least = max(*(draw.size(e) * EXACT for e in (*exprs, *solved)), EXACT)
            errors.append(max(_size(o) / max(_size(w), least) for w, o in pairs))
        if not errors:
            return self._told(*texts, False, None)
        return self._told(*texts, max(errors) <= tolerance, max(errors))

    def _draws(self, exprs: tuple[sp.Expr, ...]) -> list[Valuation]:
        """Draws at which all of some formulas are real: a logarithm or a root need not be everywhere."""
        draws = self._real(self.scene.valuations, exprs)
        return draws if len(draws) == len(self.scene.valuations) else self._real(self.scene.everywhere(), exprs)

    def _real(self, valuations: Iterable[Valuation], exprs: tuple[sp.Expr, ...]) -> list[Valuation]:
        draws = (self._with_lines(v) for v in valuations)
        return [d for d in draws if all(d.known(e) is not None for e in exprs)]

    def _with_lines(self, draw: Valuation) -> Valuation:
        """The draw with the solution's lines: a long formula still holds names of intermediates."""
        lines: dict[sp.Symbol, sp.Expr] = {}
        for stage in self.stages:
            lines |= {**stage.algebra.explicit, **stage.algebra.formulas}
        return draw.defining(lines)

    def _formulas(self) -> str:
        return _joined(self.found.expressions or ())

    def _shown(self, values: tuple[Decimal, ...]) -> str:
        unit = self.found.unit
        # Zero has no sign.
        numbers = _listed([f"{float(display(v, unit, self.ledger.us)) + 0.0:.6g}" for v in values])
        return numbers if unit.text == "1" else f"{numbers} {unit.text}"


def _size(parts: tuple[Decimal, ...]) -> Decimal:
    return sum((p * p for p in parts), Decimal(0)).sqrt()


def _is_rounded(side: Side) -> bool:
    """Does a number of three or more figures behind the point stand in a formula?"""
    return any(isinstance(node, Number) and (node.value * 100).denominator != 1 for node in walk(side))


def _joined(exprs: tuple[Any, ...]) -> str:
    return _listed([_cut(_written(e)) if not longer(e, PRINTABLE) else TOO_LONG for e in exprs])


def _written(expr: Any) -> str:
    """A formula or the equation of a curve in the notation of a problem file."""
    text = f"{expr.lhs} = {expr.rhs}" if isinstance(expr, sp.Eq) else str(expr)
    return text.replace("**", "^")


def _cut(text: str) -> str:
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 1]}…"


def _listed(texts: list[str]) -> str:
    return texts[0] if len(texts) == 1 else f"[{', '.join(texts)}]"


def _percent(error: Decimal) -> str:
    if error >= 10:
        return f"a factor of {error + 1:.2g}"
    return f"{100 * error:.0f} %" if error >= 1 else f"{100 * error:.2g} %"
