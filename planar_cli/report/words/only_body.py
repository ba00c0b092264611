"""Of a page with one particle nobody asks whose velocity is meant: v_half for v_ball,y,half of a ball that moves on a
vertical line, v_x and v_y where it moves in the plane.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.problem.scene.scene import Particle, Problem
from planar_cli.records import record
from planar_cli.report.document.blocks import Answer, Block, Equation, Inline, Math, Name, Note, Paragraph, Text
from planar_cli.report.document.mentioned import names_in, pieces_of
from planar_cli.report.notation.names import plain_name
from planar_cli.report.words.one_name import OPENING, RATES, Renaming, letter_of_answer, pieces_of_name

OF_PLACES, OF_MOTIONS, OF_WAYS, OF_OTHERS = ("x", "y"), ("v", "a"), ("s",), ("r",)
"""Stems of coordinates, velocities and accelerations, ways along a line, and what else is called after a point."""
AXES = ("x", "y")
GIVEN, REST = "Given", "eq"


@record
class _Letter:
    """A letter of a particle: `v`, `ball`, `y`, `dot`, whether it is the one of its place of rest, and its state."""

    name: str
    stem: str
    subject: str
    axis: str
    dots: str
    rest: bool
    state: str

    def short(self, with_axis: bool) -> str:
        """Its name without the particle, and without the axis of a velocity."""
        axis = f"_{self.axis}" if self.axis and with_axis and self.stem in OF_MOTIONS else ""
        dots = f"_{self.dots}" if self.dots else ""
        rest = f"_{REST}" if self.rest else ""
        return f"{self.stem}{axis}{dots}{rest}" + (f"__{self.state}" if self.state else "")


def with_only_body(blocks: Sequence[Block], problem: Problem) -> list[Block]:
    """The blocks of a page; of a problem with other bodies as they are."""
    shape = problem.bodies[0].shape if len(problem.bodies) == 1 else None
    if not isinstance(shape, Particle):
        return list(blocks)
    names = _names(blocks)
    asked = {b.name for b in blocks if isinstance(b, Answer)}
    letters = [found for name in names if name not in asked and (found := _read(name)) is not None]
    own = {problem.bodies[0].name, shape.place}
    things = {*own, *(p.name for p in problem.points)}
    others = [x for x in letters if x.subject not in own and things & set(x.subject.split("_"))]
    letters = [x for x in letters if x.subject in own]
    if others or not letters or any(x.stem in OF_OTHERS for x in letters):
        return list(blocks)
    told = set(_names([b for b in blocks if not _is_opening(b)]))
    axes = {x.axis or x.stem for x in letters if x.name in told and (x.axis or x.stem in AXES)}
    axes = axes or {x.axis for x in letters if x.axis}
    letters += [x for n in _quoted(blocks, names) if (x := _read(n)) is not None and x.subject in own]
    ways = (False, True) if len(axes) == 1 else (True,)
    for with_axis in ways:
        # What is not along the only axis keeps its own.
        short = {x.name: x.short(with_axis or not {x.axis} <= {"", *axes}) for x in letters}
        # Along a line a velocity is its component.
        twice = with_axis and len({(x.subject, short[x.name]) for x in letters}) < len(letters)
        if not twice and not _collides(short, names, blocks) and not _merges(short, blocks):
            kept = [_without_nought(b, letters, axes) if _is_given(b) else b for b in blocks]
            renaming = Renaming(short)
            return [_answered(renaming.of(b)) for b in kept]
    return list(blocks)


def _is_opening(block: Block) -> bool:
    return isinstance(block, Note) and (block.kind in OPENING or block.kind == GIVEN)


def _is_given(block: Block) -> bool:
    return isinstance(block, Note) and block.kind == GIVEN


def _names(blocks: Sequence[Block]) -> list[str]:
    """The names of all letters, each once; not those of a law that a heading quotes, v² = v_0² + 2 a (y - y_0)."""
    found: dict[str, None] = {}
    for block in blocks:
        for piece in pieces_of(block):
            match piece:
                case Name(name) if not (isinstance(block, Note) and block.kind in OPENING):
                    found[name] = None
                case Math(expr) if not isinstance(block, Paragraph):
                    found |= dict.fromkeys(sorted(s.name for s in expr.atoms(sp.Symbol)))
    return list(found)


def _quoted(blocks: Sequence[Block], names: Sequence[str]) -> list[str]:
    """The names of letters that stand in sentences alone, as that which vanishes where it turns."""
    maths = (piece for b in blocks if isinstance(b, Paragraph) for piece in pieces_of(b) if isinstance(piece, Math))
    return sorted({math.expr.name for math in maths if math.expr.is_Symbol} - {*names})


def _read(name: str) -> _Letter | None:
    """A name as that of a place or motion of something; None: it is no such name."""
    own, _, state = name.partition("__")
    stem, *rest = pieces_of_name(own)
    dots = next((p for p in rest if p in RATES), "")
    at_rest = REST in rest
    rest = [p for p in rest if p not in (*RATES, REST)]
    axis = rest.pop() if len(rest) > 1 and rest[-1] in AXES and stem in OF_MOTIONS else ""
    if stem not in (*OF_PLACES, *OF_MOTIONS, *OF_WAYS, *OF_OTHERS) or not rest:
        return None
    return _Letter(name, stem, "_".join(rest), axis, dots, at_rest, state)


def _collides(short: dict[str, str], names: Sequence[str], blocks: Sequence[Block]) -> bool:
    """Would a shorter name be that of something else on the page, or of another answer?"""
    new = {name: plain_name(own) for name, own in short.items()}
    others = {plain_name(name) for name in names if name not in short}
    asked = {plain_name(b.name): letter_of_answer(b.line) for b in blocks if isinstance(b, Answer)}
    return bool(others & set(new.values())) or any(own in asked and asked[own] != name for name, own in new.items())


def _merges(short: dict[str, str], blocks: Sequence[Block]) -> bool:
    """Would two letters of one equation have one name, as v_2 = v_2 sin β of the speed and its component along y?"""
    equations = ({n for n in names_in(b.sides) if n in short} for b in blocks if isinstance(b, Equation))
    return any(len({short[n] for n in names}) < len(names) for names in equations)


def _answered(block: Block) -> Block:
    """An answer that is called what it is, once."""
    letter = letter_of_answer(block.line) if isinstance(block, Answer) else ""
    if isinstance(block, Answer) and letter and plain_name(letter) == plain_name(block.name):
        return replace(block, line=block.line[2:])
    return block


def _without_nought(block: Block, letters: Sequence[_Letter], axes: set[str]) -> Block:
    """What is given without `v_x = 0` of a particle that the page follows along y alone."""
    assert isinstance(block, Note)
    across = {x.name for x in letters if x.axis and x.axis not in axes} if len(axes) == 1 else set()
    told: list[Inline] = list(block.line)
    for i in range(len(told) - 4, -1, -1):
        match told[i : i + 4]:
            case [Name(name), Text(" = "), Text("0"), Text(", ")] if name in across:
                del told[i : i + 4]
    return replace(block, line=tuple(told))
