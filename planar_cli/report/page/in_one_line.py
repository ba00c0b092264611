"""What a page tells in several lines though one holds it: both components of a vector that are letters of the solution,
a place that stays what it is from state to state, what is assumed of motions of which nothing else is told, and the
heading over equations of one stretch; and two roots that are found together by trial.

(5), (6) together: θ_AB = 19.31°,  θ_crank = -82.80°
F_O = [O_x, O_y] = [-61.72, -5.900] N
At 3, 4:   φ_4 = φ_3 = φ_2 = -90°     nothing moves during a blow
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace

from planar_cli.report.document.blocks import (
    Answer,
    Block,
    Equation,
    Heading,
    Inline,
    Line,
    Math,
    Name,
    Note,
    Paragraph,
    Text,
    Value,
    line,
)
from planar_cli.report.document.mentioned import names_in
from planar_cli.report.given.data import GIVEN
from planar_cli.report.kinetics.missing_couples import with_couples_among_forces
from planar_cli.report.notation.notation import plain
from planar_cli.report.notation.numbers import quantity
from planar_cli.report.page.both_ways import with_both_ways
from planar_cli.report.words.drives import with_drives_told
from planar_cli.report.words.words import components

TOGETHER, BY_TRIAL = "together:", line("solved numerically")
MOTION, ASSUME = "MOTION", "Assume"
STRETCH = re.compile(r"(From|At) ")
STEADY = re.compile(r"From .*, constant (angular )?velocity")
CONSTANT = re.compile(r"From .*, constant (angular )?acceleration")
AT = re.compile(r"At ([\w, ]+):")
WIDEST = 106
"""A longer heading would break inside its formula."""


def in_one_line(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a part."""
    own = with_both_ways(with_velocities_in_heads(with_drives_told(with_couples_among_forces(blocks))))
    own = with_accelerations_in_heads(list(under_one_heading(own)))
    return with_vectors(with_roots_together(with_places_carried_on(own)))


def with_velocities_in_heads(blocks: Sequence[Block]) -> list[Block]:
    """`From 1 to 2, constant velocity of P along x, ẋ = u:` for the velocity under a heading of its own before that."""
    found: list[Block] = []
    for block in blocks:
        match found[-2:]:
            case [Paragraph() as law, Equation(number=None, lead=(), note=()) as rate] if _is_steady(
                law, block
            ) and not _is_used(rate, blocks):
                assert isinstance(block, Paragraph)
                *before, last = block.line
                assert isinstance(last, Text)
                sides = [p for i, side in enumerate(rate.sides) for p in (" = " if i else ", ", side)]
                found[-2:] = [Paragraph(line(*before, last.text.removesuffix(":"), *sides, ":"))]
            case _:
                found.append(block)
    return found


def with_accelerations_in_heads(blocks: Sequence[Block]) -> list[Block]:
    """`From 4 to 5, constant acceleration of B along its path, s̈_B = a_B = 2.16 m/s²:` for the acceleration, that was
    found before, under a heading of its own.
    """
    found: list[Block] = []
    for block in blocks:
        match found[-2:]:
            case [Paragraph() as law, Equation(number=None, lead=(), note=()) as rate] if (
                _is_steady(law, block, CONSTANT) and _is_letter(rate) and not _is_used(rate, blocks)
            ):
                assert isinstance(block, Paragraph)
                head = _heading(block)
                assert isinstance(head[-1], Text)
                sides = [p for i, side in enumerate(rate.sides) for p in (" = " if i else ", ", side)]
                told = line(*head[:-1], head[-1].text.removesuffix(":"), *sides, ":", *block.line[len(head) :])
                found[-2:] = [Paragraph(told)] if _width(told) <= WIDEST else [*found[-2:], block]
            case _:
                found.append(block)
    return found


def _width(words: Line) -> int:
    """How many characters they take, about as they are printed."""
    return sum(len(_text(p)) for p in words)


def _text(piece: Inline) -> str:
    match piece:
        case Math():
            return plain(piece.expr, piece.values)
        case Value():
            return quantity(piece.number, piece.unit, piece.figures)
        case Text():
            return piece.text
    return str(piece)


def _is_letter(rate: Equation) -> bool:
    """Is it a letter with its value?"""
    if len(rate.sides) != 3:
        return False
    return isinstance(rate.sides[1], Math) and rate.sides[1].expr.is_Symbol and isinstance(rate.sides[2], Value)


def _is_used(rate: Equation, blocks: Sequence[Block]) -> bool:
    """Does another equation hold the letter of a rate, which then has a line of its own, and none give its value; or is
    it told as a component of a velocity, v_boat,x for ẋ_boat, of which it is not the letter?
    """
    own = set(names_in(rate.sides[0]))
    others = [b for b in blocks if isinstance(b, Equation) and b != rate and b.lead != GIVEN]
    given = {name for b in others for name in names_in(b.sides[0])}
    axes = [name.removesuffix("_dot").partition("_") for name in own]
    components = {f"v_{thing}{joined}{axis}" for axis, _, thing in axes if thing for joined in ("", "_")}
    if components & given - set(names_in(rate.sides[1])):
        return True
    again = any(not b.lead and set(names_in(b.sides[0])) == own for b in others)
    if any(isinstance(b, Answer) and own & set(names_in(b)) for b in blocks):
        return True
    return not again and any(own & set(names_in(side)) for b in others for side in b.sides)


def _is_steady(law: Paragraph, block: Block, words: re.Pattern[str] = STEADY) -> bool:
    """Is a law told, and are the words of a motion at this velocity the next ones, up to a colon?"""
    if not isinstance(block, Paragraph) or not _words(law).startswith("For ") or words.match(_words(block)) is None:
        return False
    return bool(_heading(block)) and (words is CONSTANT or _heading(block) == block.line)


def under_one_heading(blocks: Iterable[Block]) -> Iterator[Block]:
    """`From 1 to 2, constant acceleration, x:` once over equations that follow each other; a formula that stands behind
    it stands alone the second time.
    """
    over: Line = ()
    for block in blocks:
        if isinstance(block, Paragraph) and (heading := _heading(block)):
            if heading == over and STRETCH.match(_words(block)):
                formula = tuple(p for p in block.line[len(heading) :] if p != Text(" "))
                yield from (Paragraph(line("By ", *formula, ":")),) if formula else ()
                continue
            over = heading
        elif not isinstance(block, Paragraph | Equation):
            over = ()
        yield block


def _heading(paragraph: Paragraph) -> Line:
    """Its words up to the colon, behind which a formula may stand; empty: it is none."""
    ends = [i for i, p in enumerate(paragraph.line, 1) if isinstance(p, Text) and p.text.endswith(":")]
    return paragraph.line[: ends[0]] if ends else ()


def _words(paragraph: Paragraph) -> str:
    return "".join(p.text for p in paragraph.line if isinstance(p, Text))


def with_vectors(blocks: Sequence[Block]) -> list[Block]:
    """Components that are letters, `F_O, x = O_x` and `F_O, y = O_y`, as one vector."""
    found: list[Block] = []
    for block in blocks:
        vector = _vector(found[-1], block) if found else None
        if vector is None:
            found.append(block)
        else:
            found[-1] = vector
    named = {str(b.sides[0]) for b in found if isinstance(b, Equation) and len(b.sides) > 2 and _is_pair(b.sides[-1])}
    return [b for b in found if not _is_component_alone(b, named)]


def _is_pair(side: Inline | Line) -> bool:
    """Is it [x, y]?"""
    return isinstance(side, tuple) and str(getattr(side[0], "text", "")) == "["


def _is_component_alone(block: Block, named: Collection[str]) -> bool:
    """Is it a component with its value alone, of a vector that is told with both?"""
    if not isinstance(block, Equation) or len(block.sides) != 2 or not _is_bare(block):
        return False
    match block.sides:
        case ((Name() as name, Text(", x" | ", y")), Value()):
            return str(line(name)) in named
    return False


def _vector(one: Block, other: Block) -> Equation | None:
    """Both as one equation; None: they are no components of one vector, or no letters."""
    if not isinstance(one, Equation) or not isinstance(other, Equation):
        return None
    match (one.sides, other.sides):
        case (
            ((Name() as name, Text(", x")), Math() as x, *_, Value() as first),
            ((Name() as same, Text(", y")), Math() as y, *_, Value() as second),
        ) if name == same and first.unit == second.unit and _is_bare(one) and _is_bare(other):
            if not all(part.expr.is_Symbol or (-part.expr).is_Symbol for part in (x, y)):
                return None
            numbers = components(first.number, second.number, first.unit, max(first.figures, second.figures))
            return Equation((line(name), line("[", x, ", ", y, "]"), numbers))
    return None


def _is_bare(equation: Equation) -> bool:
    return equation.number is None and not equation.lead and not equation.note


def with_places_carried_on(blocks: Sequence[Block]) -> list[Block]:
    """`At 3: x_3 = x_2` right after `At 2: x_2 = x_1` in one line."""
    found: list[Block] = []
    for block in blocks:
        carried = _carried(found[-1], block) if found else None
        if carried is None:
            found.append(block)
        else:
            found[-1] = carried
    return found


def with_roots_together(blocks: Sequence[Block]) -> list[Block]:
    """Two roots of two equations, each told by its value alone, the second behind the first."""
    found: list[Block] = []
    for block in blocks:
        one = found[-1] if found else None
        match one, block:
            case (
                Equation(number=None, lead=(Text(words),), note=(Text(),), sides=(Math(), Value() as first)),
                Equation(number=None, lead=(), note=(), sides=(Math() as letter, Value() as second)),
            ) if isinstance(one, Equation) and one.note == BY_TRIAL and words.endswith(TOGETHER):
                found[-1] = replace(one, sides=(one.sides[0], line(first, ",  ", letter), second))
            case _:
                found.append(block)
    return found


def _carried(one: Block, other: Block) -> Equation | None:
    """Both as one chain; None: the second does not follow from the first alone."""
    if not isinstance(one, Equation) or not isinstance(other, Equation) or not _at(one) or not _at(other):
        return None
    if len(other.sides) != 3 or len(one.sides) < 3 or other.sides[1] != one.sides[0] or not one.note:
        return None
    if other.sides[2] != one.sides[-1] or other.note != one.note:
        return None
    return replace(one, sides=(other.sides[0], *one.sides), lead=line(f"At {_at(one)}, {_at(other)}:"))


def _at(equation: Equation) -> str:
    """The state at which a place is told; "" of any other equation."""
    match equation.lead:
        case (Text(text),) if equation.number is None and (found := AT.fullmatch(text)):
            return found[1]
    return ""


def of_motion(blocks: Sequence[Block], stretch: str) -> list[Block]:
    """The blocks of one motion under its heading; of one that only assumes something, its `stretch` with that."""
    if all(isinstance(b, Note) and b.kind == ASSUME for b in blocks):
        return [replace(b, line=line(f"{stretch}: ", *b.line)) for b in blocks if isinstance(b, Note)]
    return [Heading(MOTION, stretch), *blocks]
