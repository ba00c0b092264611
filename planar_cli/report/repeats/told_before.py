"""What an earlier part of a motion has told is told once: the later part refers to it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import field, replace
from itertools import pairwise

from planar_cli.records import changing, record
from planar_cli.report.document.blocks import (
    Block,
    Equation,
    Forces,
    Heading,
    Inline,
    Math,
    Name,
    Paragraph,
    Text,
    line,
)
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.equations.results import numbered
from planar_cli.report.equations.solved_before import solved_before
from planar_cli.report.equations.steps import EQUILIBRIUM, KINETICS, SOLVING
from planar_cli.report.repeats.as_there import as_there

NUMBERED = re.compile(r"\((\d+)\)")
STEP = "STEP"
DEFINED = ("moment of inertia of", "moments of inertia of", "pull of the", "push of the")
"""Begins the line of a quantity that stays what it is."""
NAMES = {"Kinematic analysis": "kinematics", KINETICS: "equations", EQUILIBRIUM: "equations", SOLVING: "solution"}


def defined_once(blocks: Iterable[Block]) -> Iterator[Block]:
    """The blocks of a part; a moment of inertia, or the force of a spring, is defined where it first occurs, and in a
    step what has no number is told once.
    """
    said: set[str] = set()
    step: set[str] = set()
    kept: Block | None = None
    every = list(blocks)
    for i, block in enumerate(every):
        step = set() if isinstance(block, Heading) else step
        if isinstance(block, Equation) and block.number is None:
            key = "".join(map(_written, pieces_of((block.lead, block.sides))))
            follows = every[i + 1] if i + 1 < len(every) else None
            # T_1 = 0 of a second balance is known; what stands alone under its heading stays.
            # What refers to a number above is said wherever it is put in.
            again = key in step and not _is_work(block) and block.note != line("as above")
            if key in said or (again and isinstance(kept, Equation | Paragraph) and isinstance(follows, Equation)):
                continue
            step.add(key)
            said |= {key} if _defines(block) else set()
        kept = block
        yield block


def _is_work(equation: Equation) -> bool:
    """Is it the work of a force, without which the sum of a balance would not be seen?"""
    left = equation.sides[0] if equation.sides else ()
    return isinstance(left, tuple) and left[:1] == (Name("U"),)


def _defines(equation: Equation) -> bool:
    lead = equation.lead[0] if equation.number is None and equation.lead else None
    return isinstance(lead, Text) and lead.text.startswith(DEFINED)


def _written(piece: Inline) -> str:
    """A formula without the order in which numbers are put into it."""
    return str(piece.expr) if isinstance(piece, Math) else str(piece)


@record
class Section:
    """One step: its heading and what stands under it."""

    heading: Heading
    blocks: tuple[Block, ...]

    @property
    def title(self) -> str:
        return self.heading.text

    @property
    def forces(self) -> tuple[Block, ...]:
        """The diagrams of its bodies."""
        return tuple(b for b in self.blocks if isinstance(b, Forces))

    @property
    def equations(self) -> Section:
        """The same without them."""
        return Section(self.heading, tuple(b for b in self.blocks if not isinstance(b, Forces)))

    def key(self) -> tuple[str, ...]:
        """What it says, whatever the numbers of its equations."""
        own = {n: i for i, n in enumerate(self.numbers())}
        return (self.title, *(_said(b, own) for b in self.blocks))

    def numbers(self) -> list[int]:
        """Of its equations."""
        return [b.number for b in self.blocks if isinstance(b, Equation) and b.number is not None]

    def refers(self) -> set[int]:
        """The numbers of equations that it names."""
        return {int(n) for b in self.blocks for text in _texts(b) for n in NUMBERED.findall(text)}


@changing
class ToldBefore:
    """Remembers what the parts of one motion have told."""

    told: list[tuple[str, tuple[Section, ...]]] = field(default_factory=list)
    data: list[Block] = field(default_factory=list)
    """Steps that were left out, as they only write down what is given."""
    named: set[int] = field(default_factory=set)
    """Numbers of equations that stand for those of an earlier part."""
    by_number: bool = True
    """Do equations give way to their numbers? A key has no words that say of which they are."""

    def reduced(self, blocks: Sequence[Block], where: str, steps: int) -> list[Block]:
        """Blocks without the steps that an earlier place has told, which is named instead. `where`: what this place is
        called later (from 1 to 2); `steps`: how many steps stand before it.
        """
        first = next((i for i, b in enumerate(blocks) if _begins(b)), len(blocks))
        sections = tuple(_sections(blocks[first:]))
        found = [*blocks[:first], *_numbered(self._kept(sections), steps)]
        found = solved_before(found, (b for _, old in self.told for s in old for b in s.blocks))
        if sections:
            self.told.append((where, sections))
        return found

    def _kept(self, sections: tuple[Section, ...]) -> Iterator[Section | Paragraph]:
        """The sections that say something new; at last a sentence with where the others stand."""
        dropped: dict[str, list[str]] = {}
        whole = next((where for where, old in self.told if [s.key() for s in old] == [s.key() for s in sections]), None)
        if sections and whole is not None:
            yield Paragraph(line(f"The same steps as {whole}."))
            return
        for section in sections:
            needed = set(section.numbers()) & set().union(
                *(s.refers() for s in self._new(sections) if s is not section)
            )
            where = self._before(section)
            if where is None and section.forces and self._before(section.equations) and not needed:
                where = self._before(section.equations)
                yield replace(section, blocks=section.forces)
            elif where is not None and needed and not section.forces and self.by_number:
                yield self._referred(section, where)
                continue
            elif where is None or needed:
                yield self._as_there(section)
                continue
            dropped.setdefault(where or "", []).append(NAMES.get(section.title, section.title))
        for where, names in dropped.items():
            said = f"{', '.join(names[:-1])} and {names[-1]}" if len(names) > 1 else names[0]
            yield Paragraph(line(f"{said[:1].upper()}{said[1:]}: as {where}."))

    def _as_there(self, section: Section) -> Section:
        """A step by what changes in it, where the last one of its kind is like it."""
        earlier = [(where, s) for where, told in self.told for s in told if s.title == section.title and s.forces]
        if not section.forces or not earlier or not self.by_number:
            return section
        where, last = earlier[-1]
        found = replace(section, blocks=as_there(section.blocks, last.blocks, where))
        self.named |= {*section.numbers()} - {*found.numbers()}
        return found

    def _referred(self, section: Section, where: str) -> Section:
        """A step that was told there, of which later ones name equations: how these were numbered there."""
        old = next(s for place, told in self.told if place == where for s in told if s.key() == section.key())
        if not (numbers := section.numbers()) or sorted(numbers) != numbers or sorted(old.numbers()) != old.numbers():
            return section
        aside = f"as {where}: {numbered(numbers)}, there {numbered(old.numbers())}"
        return Section(replace(section.heading, aside=aside), ())

    def _new(self, sections: Iterable[Section]) -> list[Section]:
        return [s for s in sections if self._before(s) is None]

    def _before(self, section: Section) -> str | None:
        """Where the same was told."""
        key = section.key()
        return next((where for where, old in self.told for s in old if key in (s.key(), s.equations.key())), None)


def _numbered(kept: Iterable[Section | Paragraph], steps: int) -> Iterator[Block]:
    """Steps numbered anew, as some are left out."""
    for item in kept:
        if isinstance(item, Paragraph):
            yield item
            continue
        steps += 1
        yield replace(item.heading, label=f"{STEP} {steps}")
        yield from item.blocks


def _sections(blocks: Sequence[Block]) -> Iterator[Section]:
    starts = [i for i, b in enumerate(blocks) if _begins(b)]
    for start, stop in pairwise([*starts, len(blocks)]):
        heading = blocks[start]
        assert isinstance(heading, Heading)
        yield Section(heading, tuple(blocks[start + 1 : stop]))


def _begins(block: Block) -> bool:
    return isinstance(block, Heading) and block.label.startswith(STEP)


def _said(block: Block, own: dict[int, int]) -> str:
    """A block as text, the numbers of equations counted from the first of its section; others as they are."""
    if isinstance(block, Equation):
        block = replace(block, number=None if block.number is None else own[block.number])
    return NUMBERED.sub(lambda m: f"({own.get(int(m[1]), '-')})", repr(block))


def _texts(block: Block) -> Iterator[str]:
    """The words of a block in which equations are named."""
    lines = (block.lead, block.note) if isinstance(block, Equation) else (getattr(block, "line", ()),)
    yield from (piece.text for parts in lines for piece in parts if isinstance(piece, Text))
