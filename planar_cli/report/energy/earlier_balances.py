"""What the balances of energies of a motion have told, to which a later one goes back: forces that do no work, energies
by the same formulas, the words of a stretch.

T_3 of crank = 0.0045 ω_crank,3²     after     T_2 of crank = 1/2 m_c v_G,crank,2² + … = 0.0045 ω_crank,2²
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import field, replace
from typing import Any

import sympy as sp

from planar_cli.principles.base import Balance
from planar_cli.records import changing
from planar_cli.report.document.as_printed import as_text
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, Paragraph, Text, Value, line
from planar_cli.report.document.mentioned import names_in
from planar_cli.report.energy.by_stretches import by_stretches
from planar_cli.report.energy.energy_lines import Told, needed_lines
from planar_cli.report.energy.few_lines import SPEEDS, breaks, ended, in_few_lines
from planar_cli.report.energy.idle_reactions import idle_again, idle_reactions
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.solve.between.trace.trace import BalanceTrace

OF_STATE, PUT_IN = re.compile(r"__(\w+)"), re.compile(rf"{NUMBER}\d+")
OF, NOUGHT = " of the ", Math(sp.S.Zero)
FEWEST = 3
"""A line of so many sides has one that it can do without."""


@changing
class EarlierBalances:
    """Remembers what balances have told."""

    ends: set[tuple[sp.Symbol, sp.Expr]] = field(default_factory=set)
    """Stretches, heights and kinetic energies that were told."""
    energies: list[Told] = field(default_factory=list)
    idle: set[tuple[Any, ...]] = field(default_factory=set)
    forms: dict[str, tuple[str, ...]] = field(default_factory=dict)
    """By the left sides of lines, what stood on the others; the states as the first and the last one of a balance."""
    starts: Collection[str] = ()
    """The states from which several balances go."""

    def said_idle(self, law: Balance) -> list[Any]:
        """Which reactions do no work; why, where the same were not told before."""
        own = (law.idle, law.internal)
        again = own in self.idle
        self.idle.add(own)
        return idle_again(*own) if again else idle_reactions(*own)

    def headed(self, heading: Line, blocks: Iterable[Block], since: str = "") -> Iterator[Block]:
        """A balance under its heading, in which a later one has that a kinetic energy is nought, and so has the first
        of several from one state, `since`: `work and kinetic energy, T_4 = 0; N does no work:`.
        """
        later = bool(self.forms) or since in self.starts
        first, *others = by_stretches(list(blocks))
        words, *rest = heading
        ends = later and rest and isinstance(words, Text) and isinstance(rest[0], Text) and rest[0].text[:1] in ";:"
        if not ends or not isinstance(first, Equation) or first.lead or first.note or first.sides[-1] != NOUGHT:
            yield from (Paragraph(heading), first, *others)
            return
        told = line(words, ", ", *(p for side in first.sides[:-1] for p in line(side, " = ")), "0", *rest)
        yield from (Paragraph(told), *others)

    def lines(self, blocks: Sequence[Block], balance: BalanceTrace, at_once: bool, told: Equation) -> list[Block]:
        """The lines before a balance, as `needed_lines` has them, by those before earlier ones."""
        needed = list(needed_lines(blocks, balance, at_once, self.energies))
        states = {balance.since: "@", balance.stop: "#"}
        own = self._shortened(needed, states) if self.forms else needed
        own = self._without_terms(own, balance, told) if self.forms else own
        for b in needed:
            if isinstance(b, Equation):
                left, *others = _forms(b, states)
                self.forms[left] = tuple(others)
        return in_few_lines(own, told)

    def have_works(self, blocks: Sequence[Block], balance: BalanceTrace) -> bool:
        """Had earlier balances the formulas of all works of this one, which come with numbers beside what is sought, so
        that it is their sum at sight?
        """
        works = [b for b in blocks if isinstance(b, Equation) and _is_work(b, balance)]
        known = {left.partition(OF)[2] for left in self.forms if left.startswith(balance.law.bring)}
        beside = (isinstance(b.sides[-1], Math) and bool(b.sides[-1].values) for b in works)
        return bool(works) and all(beside) and all(as_text(b.sides[0]).partition(OF)[2] in known for b in works)

    def _without_terms(self, blocks: list[Block], balance: BalanceTrace, told: Equation) -> list[Block]:
        """Without the works that are the terms of a balance in letters, where all are, and others have told of which
        forces these are.
        """
        works = [b for b in blocks if isinstance(b, Equation) and _is_work(b, balance)]
        known = {left.partition(OF)[2] for left in self.forms}
        whole = as_text(told.sides[0])
        for b in works:
            last = b.sides[-1]
            lettered = isinstance(last, Math) and not last.values and as_text(last).removeprefix("-") in whole
            if not lettered or as_text(b.sides[0]).partition(OF)[2] not in known:
                return blocks
        others = {name for b in (*blocks, told) if b not in works and not ended(b) for name in names_in(b)}
        return [b for b in blocks if b not in works and (not ended(b) or ended(b) in others)]

    def _shortened(self, blocks: Sequence[Block], states: dict[str, str]) -> list[Block]:
        found: list[Block] = []
        for own in blocks:
            if not isinstance(own, Equation):
                found.append(own)
                continue
            left, *others = _forms(own, states)
            before = self.forms.get(left)
            block = _without_words(own) if before is not None else own
            if not before or len(block.sides) < FEWEST or before[0] != others[0]:
                found.append(block)
            elif before == tuple(others) and (speeds := self._known_speeds(block, found, states)):
                found[-speeds:] = [replace(block, sides=(block.sides[0], block.sides[-1]))]
            elif heights := self._idle_heights(block, found):
                self.ends -= {end for end in self.ends if end[0].name in map(ended, heights)}
                found = [*(b for b in found if b not in heights), _without_formula(block)]
            else:
                found.append(self._fitting(block))
        return found

    @staticmethod
    def _fitting(block: Equation) -> Equation:
        """A line, without the formula that is known where it would take two rows with it."""
        return _without_formula(block) if breaks(block) else block

    def _known_speeds(self, energy: Equation, found: Sequence[Block], states: dict[str, str]) -> int:
        """How many lines of the speeds of an energy stand at last; 0: one was not told by the same formula."""
        speeds = {name for name in names_in(energy.sides[1]) if name.startswith(SPEEDS)}
        count = 0
        for block in reversed(found):
            if not isinstance(block, Equation) or not speeds.intersection(names_in(block.sides[0])):
                break
            left, *others = _forms(block, states)
            if self.forms.get(left) != tuple(others):
                return 0
            count += 1
        return count

    @staticmethod
    def _idle_heights(block: Equation, found: Sequence[Block]) -> list[Block]:
        """The lines of heights that only the formula of a work needs, which goes on in other letters."""
        _, formula, next_one, *_ = block.sides
        if not isinstance(formula, Math) or not isinstance(next_one, Math) or next_one.values:
            return []
        only = set(names_in(formula)) - set(names_in(block.sides[2:]))
        heights = [b for b in found if ended(b) in only]
        others = {name for b in found if b not in heights for name in names_in(b)}
        return heights if not others & {ended(b) for b in heights} else []


def _is_work(block: Equation, balance: BalanceTrace) -> bool:
    first = block.sides[0]
    return isinstance(first, tuple) and first[0] == Name(balance.law.bring)


def _without_formula(block: Equation) -> Equation:
    return replace(block, sides=(block.sides[0], *block.sides[2:]))


def _without_words(block: Equation) -> Equation:
    """s_3 = 0.05 m, for `stretch of the spring coil, s_3 = 0.05 m`."""
    first = block.sides[0]
    if not ended(block) or not isinstance(first, tuple):
        return block
    return replace(block, sides=(first[-1], *block.sides[1:]))


def _forms(block: Equation, states: dict[str, str]) -> list[str]:
    """What its sides say, whatever the states."""
    return [_form((block.lead, side) if not i else side, states) for i, side in enumerate(block.sides)]


def _form(side: Any, states: dict[str, str]) -> str:
    match side:
        case tuple():
            return "".join(_form(part, states) for part in side)
        case Name(name):
            said = name
        case Math(expr, values):
            texts = {s.name: text for s, text in (values or {}).items()}
            said = PUT_IN.sub(lambda found: texts.get(found[0], found[0]), str(expr))
        case Value():
            # The number of another state is not compared.
            return "value"
        case _:
            said = as_text(side)
    return OF_STATE.sub(lambda found: f"__{states.get(found[1], found[1])}", said)
