"""What a reader of a page does not need: a line that stands just above, the name of the only body that is drawn over
its sums of forces, the time of a state that a blow does not change, what nothing after it speaks of, and a line of its
own for the reason of a root.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TypeGuard

from planar_cli.problem.language.expression import Number
from planar_cli.problem.scene.scene import Polar, Problem
from planar_cli.report.document.blocks import Block, Equation, Forces, Inline, Math, Name, Paragraph, Text, Value
from planar_cli.report.document.mentioned import names_in, pieces_of
from planar_cli.report.document.said import said as worded
from planar_cli.report.equations.left_out import tells_a_state, tells_of_others, tells_the_root
from planar_cli.report.motion.states_put_in import without_unused_times
from planar_cli.report.notation.numbers import quantity
from planar_cli.report.page.heads_of_states import with_states_headed_once
from planar_cli.report.page.idle_contacts import without_idle_contacts
from planar_cli.report.repeats.idle_symmetry import without_idle_symmetry
from planar_cli.report.words.one_name import renamed

BLOW = "a blow takes no time"
"""The remark on the time of a state just after a blow."""
DRAWN = "in the given position:"
"""The end of the lead of what a place is as it is drawn."""
PLACES = ("x_", "y_")
"""Begins the letter of where a point is."""
MEANS = ": the angle "
"""Begins what an angle is."""
CLOCKWISE = " is counted clockwise"
"""Begins that a rotation counts so."""
STILL = "nothing moves during a blow"
"""The remark on a place just after a blow."""
STATE = "__"
"""Stands before the state in the name of a letter."""
FIGURES = 12
QUARTER = 90
"""Of angles that are so many degrees, or a multiple of it, the sine and cosine are put in."""
DEFINED = ("mass of ", "moment of inertia of ")
"""Begins the line of a mass or a moment of inertia."""


def without_idle_lines(
    blocks: Sequence[Block], said: set[str] | None = None, problem: Problem | None = None
) -> list[Block]:
    """The blocks of a part. `said`: what letters mean, as far as that stands on the page; changed, where it is left
    out. `problem`: the file, of which angles of the given position stand under Given.
    """
    told = with_times_of_blows(list(said_above(without_unused_masses(without_idle_contacts(blocks)))))
    needed = list(without_unused_places(told, angles_given(problem) if problem is not None else ()))
    if said is not None:
        said -= {str(b.line) for b in told if isinstance(b, Paragraph) and b not in needed}
    told = without_idle_symmetry(with_roots_beside(needed))
    return with_states_headed_once(without_told_values(without_unused_times(told)))


def without_unused_masses(blocks: Sequence[Block]) -> list[Block]:
    """Blocks without masses and moments of inertia of which nothing else speaks: those of a second body that is told
    with its equal.
    """
    kept = list(blocks)
    while True:
        spoken = Counter(name for block in kept for name in _letters(block))
        idle = [b for b in kept if (name := _defined(b)) and spoken[name] == 1]
        if not idle:
            return kept
        kept = [b for b in kept if b not in idle]


def _defined(block: Block) -> str:
    """The letter of a mass or moment of inertia that a line defines; "" of any other."""
    if not isinstance(block, Equation) or block.number is not None or not block.lead or len(block.sides) < 2:
        return ""
    lead, letter = block.lead[0], block.sides[0]
    told = isinstance(lead, Text) and lead.text.startswith(DEFINED)
    return letter.expr.name if told and isinstance(letter, Math) and letter.expr.is_Symbol else ""


def said_above(blocks: Sequence[Block]) -> Iterator[Block]:
    """Blocks without a line that only repeats the one above, and without the name of the body whose diagram alone
    stands there.
    """
    for i, block in enumerate(blocks):
        last = blocks[i - 1] if i else None
        alone = isinstance(last, Forces) and (i < 2 or not isinstance(blocks[i - 2], Forces))
        if alone and isinstance(last, Forces) and _words(block) == f"{last.body}:":
            continue
        if (
            isinstance(block, Equation)
            and block.number is None
            and (block == last or _numbered_above(block, blocks[:i]))
        ):
            continue
        yield _without_note_above(block, last)


def _numbered_above(block: Equation, above: Sequence[Block]) -> bool:
    """Does a line solve an equation above, by its number, that stands there solved already?"""
    led = len(block.lead) == 1 and not block.note
    return led and any(
        isinstance(b, Equation) and block.lead == (Text(f"({b.number}):"),) and b.sides == block.sides for b in above
    )


def _without_note_above(block: Block, last: Block | None) -> Block:
    """An equation without a remark beside it with which the sentence above ends."""
    if not isinstance(block, Equation) or not block.note or not isinstance(last, Paragraph):
        return block
    above, beside = (tuple(map(_read, parts)) for parts in (last.line[-len(block.note) :], block.note))
    return replace(block, note=()) if above == beside else block


def _read(piece: Inline) -> object:
    """What reads alike: a letter as a name, or as a formula."""
    return piece.name if isinstance(piece, Name) else getattr(getattr(piece, "expr", None), "name", piece)


def _words(block: Block) -> str:
    """A sentence of words alone."""
    if not isinstance(block, Paragraph) or not all(isinstance(p, Text) for p in block.line):
        return ""
    return "".join(p.text for p in block.line if isinstance(p, Text))


def with_times_of_blows(blocks: Sequence[Block]) -> list[Block]:
    """Blocks with one letter for the time of a blow: that of the state just before it."""
    same: dict[str, str] = {}
    kept: list[Block] = []
    for block in blocks:
        names = _carried(block, BLOW)
        if len(names) < 2:
            kept.append(block)
        else:
            same |= {name: same.get(names[-1], names[-1]) for name in names[:-1]}
    return renamed(kept, same) if same else kept


def _carried(block: Block, remark: str) -> list[str]:
    """The letters of states that are equal as nothing happens to them in a blow, t_3 = t_2."""
    if not isinstance(block, Equation) or block.note != (Text(remark),):
        return []
    return [s.expr.name for s in block.sides if isinstance(s, Math) and s.expr.is_Symbol]


def without_unused_places(blocks: Sequence[Block], given: Collection[Fraction] = ()) -> Iterator[Block]:
    """Blocks without a place that a blow does not change, or that is drawn, where nothing else speaks of it; of an
    angle that is `given`, in degrees, formulas may have the number: 0.15 cos 60°.
    """
    spoken = Counter(name for block in blocks for name in _letters(block))
    kept: list[Block] = []
    for block in blocks:
        names = _carried(block, STILL)
        if len(names) == 2 and spoken[names[0]] == 1:
            continue
        own = _drawn(block)
        idle = own is not None and (spoken[own] == 1 or (_is_given(block, given) and _in_numbers_alone(own, blocks)))
        if own is not None and idle and not _is_put_in(block, own, spoken):
            continue
        if not _is_unused_meaning(block, spoken):
            kept.append(block)
    return _with_meanings_needed(list(_without_unused_angles(kept, spoken)))


def _with_meanings_needed(blocks: Sequence[Block]) -> Iterator[Block]:
    """Blocks without what only the lines left out spoke of; where an angle counts clockwise, so does its rate."""
    spoken = Counter(name for block in blocks for name in _letters(block))
    above = False
    for block in blocks:
        if not _is_unused_meaning(block, spoken) and not (above and _says_the_sense(block)):
            yield block
            above = _is_meaning(block)


def _is_unused_meaning(block: Block, spoken: Mapping[str, int]) -> bool:
    """Does it only say what an angle is of which nothing else speaks, at no state, nor of its rate?"""
    match block:
        case Paragraph((Math(expr), Text(text))) if expr.is_Symbol and text.startswith(MEANS):
            family = [n for n in spoken if n == expr.name or n.startswith((f"{expr.name}__", f"{expr.name}_d"))]
            return sum(spoken[n] for n in family) <= 1
    return False


def _is_meaning(block: Block) -> bool:
    """Does it only say what an angle is?"""
    match block:
        case Paragraph((Math(), Text(text))):
            return text.startswith(MEANS)
    return False


def _says_the_sense(block: Block) -> bool:
    """Does it only say in which sense a rotation counts?"""
    match block:
        case Paragraph((Math(), Text(text))):
            return text.startswith(CLOCKWISE)
    return False


def _without_unused_angles(blocks: Sequence[Block], spoken: Mapping[str, int]) -> Iterator[Block]:
    """Blocks in which a condition of a state stands by itself, `At 3, x_G = 0.`, where nothing else speaks of the angle
    that it gives.
    """
    left = 0
    for i, block in enumerate(blocks):
        if left:
            left -= 1
            continue
        after = blocks[i + 1 : i + 3]
        words = _leading(block)
        if words and isinstance(block, Paragraph) and len(after) == 2 and _gives_an_angle(after[0], after[1], spoken):
            yield Paragraph((*block.line[:-1], Text(f"{words.removesuffix(':')}.")))
            left = 3 if any(isinstance(b, Paragraph) and tells_of_others(b) for b in blocks[i + 3 : i + 4]) else 2
        else:
            yield block


def _gives_an_angle(condition: Block, given: Block, spoken: Mapping[str, int]) -> bool:
    """Is it an equation in an angle of a state, and its solution, of which nothing else speaks?"""
    if not isinstance(condition, Equation) or not isinstance(given, Equation) or condition.number or given.number:
        return False
    own, last = given.sides[0], given.sides[-1]
    turned = isinstance(own, Math) and own.expr.is_Symbol and isinstance(last, Value) and last.unit in ("deg", "rad")
    if not turned or not isinstance(own, Math) or condition.lead:
        return False
    name = own.expr.name
    return name in _letters(condition) and spoken[name] == 2 and not _is_put_in(given, name, spoken)


def _drawn(block: Block) -> str | None:
    """The letter of a line that only says what it is in the given position, or where a point is in a state."""
    if not isinstance(block, Equation) or block.number is not None or not block.lead:
        return None
    first, lead = block.sides[0], _words(Paragraph(block.lead))
    if not isinstance(first, Math) or not first.expr.is_Symbol:
        return None
    placed = first.expr.name.startswith(PLACES) and lead.startswith("At ") and lead.endswith(":")
    return first.expr.name if placed or lead.endswith(DRAWN) else None


def angles_given(problem: Problem) -> set[Fraction]:
    """The angles in degrees at which points of the file are placed: OA = r at 60°."""
    angles = [p.place.angle for p in problem.points if isinstance(p.place, Polar)]
    return {a.value for a in angles if isinstance(a, Number) and a.unit == "deg" and a.sense > 0}


def _is_given(block: Block, given: Collection[Fraction]) -> bool:
    """Is it a letter and such an angle?"""
    last = block.sides[-1] if isinstance(block, Equation) and len(block.sides) == 2 else None
    return isinstance(last, Value) and last.unit == "deg" and Fraction(round(last.number, FIGURES)) in given


def _in_numbers_alone(own: str, blocks: Sequence[Block]) -> bool:
    """Does a letter stand as itself in one line only?"""
    pieces = [p for block in blocks for p in pieces_of(block)]
    letters = (s.name for p in pieces if isinstance(p, Math) for s in p.expr.free_symbols - set(p.values or ()))
    return [*letters, *(p.name for p in pieces if isinstance(p, Name))].count(own) == 1


def _is_put_in(block: Block, own: str, spoken: Mapping[str, int]) -> bool:
    """Is it an angle of whole quarters of a turn, of which lines hold the sine, where other states have it?"""
    last = block.sides[-1] if isinstance(block, Equation) else None
    if not isinstance(last, Value) or last.unit != "deg" or not round(last.number) or round(last.number, 12) % QUARTER:
        return False
    general = own.partition(STATE)[0]
    return any(name != own and name.startswith(f"{general}{STATE}") for name in spoken)


def _letters(block: Block) -> set[str]:
    """The letters of which a block speaks."""
    return set(names_in(block))


def without_told_values(blocks: Sequence[Block]) -> list[Block]:
    """Blocks without a letter and its value alone where a line above ended with that value, and without a heading under
    which nothing else stood.
    """
    values: dict[str, str] = {}
    found: list[Block] = []
    for block, after in zip(blocks, [*blocks[1:], None], strict=True):
        if not isinstance(block, Equation):
            found.append(block)
            continue
        name = str(worded(block)[0])
        last = block.sides[-1]
        value = quantity(last.number, last.unit, last.figures) if isinstance(last, Value) else ""
        again = block.number is None and len({*map(str, worded(block))}) == 2 and not block.note
        if not again or not value or values.get(name) != value:
            values[name] = value
            found.append(block)
        elif found and _leading(found[-1]) and not isinstance(after, Equation):
            found.pop()
    return found


def _leading(block: Block) -> str:
    """The last words of a sentence that leads to what follows; "" of anything else."""
    last = block.line[-1] if isinstance(block, Paragraph) and block.line else None
    return last.text if isinstance(last, Text) and last.text.endswith(":") else ""


def with_roots_beside(blocks: Sequence[Block]) -> list[Block]:
    """Blocks in which the reason of a root stands beside it; beside the equation that it solves, where something else
    stands there already. A root that only tells of a state before stands beside the equation, before the one sought.
    """
    found: list[Block] = []
    for block in blocks:
        if isinstance(block, Paragraph) and tells_the_root(block):
            last, before = [*found[:-3:-1], None, None][:2]
            if _is_bare(last):
                found[-1] = replace(last, note=block.line)
                continue
            if _is_bare(before) and before.number is not None:
                found[-2] = replace(before, note=block.line)
                continue
        if isinstance(block, Paragraph) and tells_a_state(block) and len(found) > 1:
            before = found[-2]
            if _is_bare(before) and before.number is not None:
                found[-2] = replace(before, note=block.line)
                continue
        if isinstance(block, Paragraph) and tells_of_others(block) and found and _is_bare(found[-1]):
            # Of a phase, ω t = π, the choice is made there, not where the time follows from it.
            last, before = [*found[:-3:-1], None][:2]
            if _is_bare(before) and _is_bare(last) and _is_its_phase(before, last):
                found[-2] = replace(before, note=block.line)
            elif _is_bare(last):
                found[-1] = replace(last, note=block.line)
            continue
        found.append(block)
    return found


def _is_its_phase(phase: Equation, date: Equation) -> bool:
    """Is one ω t = π, and the other its t = …?"""
    product, time = phase.sides[0], date.sides[0]
    if phase.number is not None or phase.lead or not isinstance(product, Math) or not isinstance(time, Math):
        return False
    return bool(product.expr.is_Mul and time.expr.is_Symbol) and time.expr in product.expr.free_symbols


def _is_bare(block: Block | None) -> TypeGuard[Equation]:
    """Is it an equation with nothing beside it?"""
    return isinstance(block, Equation) and not block.note
