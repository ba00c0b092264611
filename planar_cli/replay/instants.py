"""The equations of instants, of one or of several that are each complete in themselves, from the blocks of each."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.kinematics.motion import Motion
from planar_cli.equation.values.ledger import Ledger
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.facts import Mode, Row
from planar_cli.problem.scene.facts import Test as Assumption
from planar_cli.replay.at_states import renamed
from planar_cli.replay.equations import Asked, Equations, Test
from planar_cli.replay.opened import NotWritten, of_block
from planar_cli.replay.two_places import squares_of_places
from planar_cli.replay.writer import Writer, is_number
from planar_cli.solve.instant.instant import TINY
from planar_cli.solve.instant.parting import parting
from planar_cli.solve.solution import Found, InstantSolution
from planar_cli.solve.states import combined


class Instants(Writer):
    """Instants that are each complete in themselves."""

    def equations(self) -> Equations:
        if len(self.part.instants) > 1:
            return self._of_several()
        for instant in self.part.instants:
            self.take(instant)
        for found in self.part.found:
            if is_number(found) and found.asked:
                self.asked[found.name] = Asked(tuple(map(sp.sympify, found.asked)), found.turn)
        return self.made()

    def _of_several(self) -> Equations:
        """What is another number at each instant, or may be, has a symbol of its own there."""
        each: dict[str, tuple[Instants, dict[sp.Symbol, sp.Symbol]]] = {}
        for instant in self.part.instants:
            one = Instants(self.part)
            one.take(instant)
            each[instant.state] = one, {}
        alike = _alike([one for one, _ in each.values()])
        for state, (one, own) in each.items():
            own.update({s: sp.Symbol(f"{s.name}__{state}", **s.assumptions0) for s in one.symbols() if s not in alike})
            self._take_renamed(one, own)
        for found in self.part.found:
            pieces = self.part.pieces.get(found.name, ())
            if is_number(found) and pieces and all(piece.asked for _, _, piece in pieces):
                parts = (
                    _joined(found, [(p, side, each[state][1]) for state, side, p in pieces], i, self.ledgers[0])
                    for i in range(len(found.values or ()))
                )
                self.asked[found.name] = Asked(tuple(parts), found.turn)
        return self.made()

    def _take_renamed(self, one: Instants, own: Mapping[sp.Symbol, sp.Symbol]) -> None:
        def put(expr: sp.Expr) -> sp.Expr:
            return sp.sympify(sp.sympify(expr).xreplace(dict(own)))

        self.ledgers += one.ledgers
        self.inputs |= {own.get(s, s).name: own.get(s, s) for s in one.inputs.values()}
        self.defined |= {own.get(s, s): put(e) for s, e in one.defined.items()}
        self.steps += [renamed(step, own) for step in one.steps]
        self.tests += [Test(put(test.positive), test.words) for test in one.tests]
        self.numbers |= {own.get(s, s): n for s in one.symbols() if (n := one._known(s)) is not None}
        self.general |= {new: s for s, new in own.items()}
        for name, squares in one.squares.items():
            self.squares[name] = (*self.squares.get(name, ()), *map(put, squares))

    def symbols(self) -> list[sp.Symbol]:
        """All that stand in what was taken, in an order that is the same in each run."""
        exprs = [
            *(r for s in self.steps for r in s.residuals),
            *self.defined.values(),
            *(t.positive for t in self.tests),
        ]
        inside = set().union(*(sp.sympify(e).free_symbols for e in exprs), self.defined, self.inputs.values())
        return sorted(inside, key=lambda s: s.name)

    def take(self, solution: InstantSolution) -> None:
        ledger = solution.instant.scene.ledger
        if solution.instant.scene.problem.symbols:
            raise NotWritten("letters without numbers remain")
        self.know(ledger, solution.value)
        self.squares = {n: (e,) for n, e in squares_of_places(solution.instant.scene).items()}
        for letter in ledger.letters:
            # A mass that may be any: the answers are the same with the one that was drawn.
            self.inputs[letter.name] = letter
            self.valuations.append(solution.instant.scene.valuations[0])
        for line in solution.lines:
            self.defined[line.symbol] = line.expression
        for stage in solution.stages:
            self.defined.update({line.symbol: line.expression for line in stage.lines})
            self.defined.update(dict.fromkeys(stage.zero, sp.S.Zero))
            self.steps += [of_block(block, self.defined) for block in stage.blocks if block.equations]
        told = {u for step in self.steps for u in step.unknowns} | self.defined.keys() | set(self.inputs.values())
        for mode in solution.trial.system.modes.values():
            for test in mode.tests:
                expr = _assumed(solution, mode, test)
                if expr is not None and expr.free_symbols and expr.free_symbols <= told:
                    self.tests.append(Test(expr, test.words))


def _alike(instants: Sequence[Instants]) -> set[sp.Symbol]:
    """The data that are the same at each of the instants."""
    first, *others = instants
    data = set(first.inputs.values()).intersection(*(one.inputs.values() for one in others))
    return {s for s in data if all(one._known(s) == first._known(s) for one in others)}


def _joined(
    found: Found, pieces: Sequence[tuple[Found, Side, Mapping[sp.Symbol, sp.Symbol]]], index: int, ledger: Ledger
) -> sp.Expr:
    """A part of a find that is made of quantities at several instants, each in the symbols of its own."""
    told = {side: tuple(sp.sympify(e).xreplace(dict(own)) for e in piece.asked) for piece, side, own in pieces}
    what = found.find.found.what if found.find is not None else None
    if getattr(what, "at", None) is not None:
        (parts,) = told.values()
        return parts[index]
    assert isinstance(what, Side)
    put_in = {side: replace(piece, values=None, expressions=told[side]) for piece, side, _ in pieces}
    return combined(what, put_in, index, ledger)


def _assumed(solution: InstantSolution, mode: Mode, test: Assumption) -> sp.Expr | None:
    """What a test demands to be positive; None: it is no sum of forces, and no slip or parting that is positive."""
    symbols = solution.trial.system.symbols
    if test.pushes and not test.within and all(n in symbols for n, _ in test.pushes):
        return sp.Add(*(c * symbols[n] for n, c in test.pushes), sp.sympify(test.constant))
    motion = solution.trial.system.motion
    if motion is None:
        return None
    expr = parting(motion, test) if test.row is None else _slip(solution, motion, mode, test.row)
    number = None if expr is None else solution.value.known(expr)
    return expr if number is not None and number > TINY else None


def _slip(solution: InstantSolution, motion: Motion, mode: Mode, row: Row) -> sp.Expr:
    """The slip in the sense that is assumed: its speed where it is under way, else how fast it begins."""
    speed = mode.direction * motion.row_velocity(row)
    under_way = (solution.value.known(speed) or 0) > TINY
    return speed if under_way else mode.direction * motion.row_acceleration(row)
