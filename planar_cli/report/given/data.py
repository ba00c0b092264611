"""Data of one instant as numbered lines: what the file gives, and what of it was differentiated."""

from __future__ import annotations

import re
from dataclasses import field, replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.values.ledger import Kind
from planar_cli.problem.language.expression import Name as Letter
from planar_cli.problem.language.expression import Relation
from planar_cli.records import changing
from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Name, Paragraph, Value, line
from planar_cli.report.given.as_stated import NEAR, Stated, between, sentence, stated_in
from planar_cli.report.notation.clean import common_dimension
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.words.sides import number_of, said
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.written import Written
from planar_cli.units import pretty_unit

GIVEN, DIFFERENTIATED = line("given:"), line("differentiated:")
LOWER = ((re.compile("^alpha"), "omega"), (re.compile("^a(?=_)"), "v"), (re.compile("_ddot$"), "_dot"))
"""By what the name of an acceleration differs from that of its speed."""


@changing
class DataTelling:
    """Tells the data of one instant. `state`: its name; `told`: which statements of the file stand on the page."""

    scene: Scene
    state: str
    phrases: Phrases
    told: set[str] = field(default_factory=set)

    def blocks(self, w: Written, number: int, behind: str) -> list[Block]:
        """letter = value, with the reason where the file says it otherwise. `behind`: that it counts the other way,
        said of the only body, whose letter has no index that tells it from the component under Given.
        """
        stated = stated_in(self.scene.problem, self.state, w.lead)
        letter, value = self.phrases.math(w.left), self._value(w)
        if w.times and w.right == 0 and (lower := lower_name(w.left.name)):
            return [Equation((letter, value), number, line(Name(lower), " constant:"))]
        if w.times:
            return self._differentiated(w, stated, Equation((letter, value), number, (), self._counted_in(w)))
        self.told.add(w.lead)
        if not w.right.is_number or w.right == 0:
            lead = self._unknown(w.right) if self._is_sought(w.right) else GIVEN
            told = self._worked_out(w)
            return [Equation((letter, value, *told), number, lead, () if told else self._counted_in(w))]
        value_of = self.phrases.value(w.right)
        middle = between(stated, w.left, value_of, self.phrases) or self._formula(stated, value_of)
        lead = () if middle and not isinstance(middle[0], Value) else GIVEN
        lead = line(f"{behind.removeprefix('; ')}; ", *GIVEN) if behind and len(self.scene.bodies) == 1 else lead
        return [Equation((letter, *([middle] if middle else []), value), number, lead)]

    def _counted_in(self, w: Written) -> Line:
        """The units of a function of the time with numbers that have some: ω = 3/2 (1 - cos(π t/4)) in rad/s."""
        ledger = self.scene.ledger
        unit = ledger.units.get(w.left) if ledger.symbols.get("t") in w.right.free_symbols else None
        if unit is None or common_dimension(ledger, w.left, w.right) is not None:
            return ()
        told = coherent_unit(unit.dimension, unit.angle, ledger.us)
        return line(f"in {pretty_unit(told.text)}, t in s")

    def restates(self, w: Written) -> bool:
        """Is it a number, or a letter with one, that stands under Given already?"""
        return w.given and not w.times and (w.right.is_number or (w.right.is_Symbol and not self._is_sought(w.right)))

    def _is_sought(self, expr: sp.Expr) -> bool:
        role = self.scene.ledger.roles.get(expr)
        return role is not None and role.kind is Kind.SOUGHT

    def _worked_out(self, w: Written) -> tuple[Inline | Line, ...]:
        """A formula with its numbers and its value, where nothing in it is sought that the instant does not give."""
        sought = {s for s in w.right.free_symbols if self._is_sought(s)}
        short = (-w.right).is_Symbol or w.right.is_Symbol or w.right.is_number
        if short or self.phrases.symbolic or any(self._unknown(s) != GIVEN for s in sought):
            return ()
        if any(self.phrases.value.known(s) is None for s in w.right.free_symbols):
            return ()
        value = self.phrases.shown(w.left)
        return (*self.phrases.substituted(w.right, value), value)

    def of_letter(self, w: Written, moving: frozenset[sp.Symbol], number: int) -> Equation | None:
        """given, w unknown: ω = w, where the file says that a velocity or acceleration is a letter which is sought."""
        letters = w.residual.free_symbols
        sought = [s for s in letters if self._is_sought(s)]
        own = [s for s in letters if s in moving]
        if w.source != "given" or w.times or len(sought) != 1 or len(own) != 1 or len(letters) != 2:
            return None
        (letter,), (x,) = sought, own
        other = next((e for e in (letter, -letter) if sp.expand(w.residual.xreplace({x: e})) == 0), None)
        if other is None:
            return None
        self.told.add(w.lead)
        return Equation((self.phrases.math(x), self.phrases.math(other)), number, self._unknown(letter))

    def _unknown(self, letter: sp.Symbol) -> Line:
        """The statement is given; which letter of it is sought, unless the instant gives that as well."""
        stated = [r for r in self.scene.problem.instant or () if isinstance(r, Relation) and r.operator == "="]
        told = (r for r in stated if isinstance(r.left, Letter) and r.left.name == letter.name)
        if not self.state and any(number_of(r.right) is not None for r in told):
            return GIVEN
        return line("given, ", self.phrases.math(letter), " unknown:")

    def given(self, w: Written, behind: str) -> Line:
        """`Given: v = √(2 g h), differentiated`, as the file has it; empty: it has no such form."""
        stated = stated_in(self.scene.problem, self.state, w.lead) if w.source == "given" else None
        law = sentence(stated, self.phrases.figures) if stated is not None else ()
        often = ("", ", differentiated", ", differentiated twice")[w.times]
        return line("Given: ", law, f"{often}{behind}") if law else ()

    def _formula(self, stated: Stated | None, value: Decimal) -> Line:
        """A formula of numbers as the file has it."""
        if not isinstance(stated, Relation) or number_of(stated.right) is not None or isinstance(stated.right, Letter):
            return ()
        own = self.phrases.value.known(self.scene.value(stated.right))
        same = own is not None and abs(own - value) <= NEAR * abs(value)
        return (said(stated.right, self.phrases.figures) or ()) if same else ()

    def _value(self, w: Written) -> Inline | Line:
        if w.right == 0:
            return line("0")
        return self.phrases.shown(w.left) if w.right.is_number else self.phrases.math(w.right)

    def _differentiated(self, w: Written, stated: Stated | None, equation: Equation) -> list[Block]:
        """The derivative of a statement, behind that statement where nothing has told it."""
        if w.lead in self.told:
            return [replace(equation, lead=DIFFERENTIATED)]
        self.told.add(w.lead)
        law = sentence(stated, self.phrases.figures) if stated is not None else ()
        if not law:
            return [replace(equation, lead=GIVEN)]
        often = ", differentiated twice:" if w.times > 1 else ", differentiated:"
        return [Paragraph(line("Given: ", law, often)), equation]


def lower_name(name: str) -> str:
    """The name of the speed whose rate a letter is; "": it is none."""
    return next((rule.sub(to, name) for rule, to in LOWER if rule.search(name)), "")
