"""One name for how fast a body turns: where a page says θ̈ = α, its θ̇ and θ̈ are ω and α throughout."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

from planar_cli.report.document.blocks import Answer, Block, Check, Equation, Heading, Math, Name, Paragraph, Text, line
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.laws.laws import FOR
from planar_cli.report.words.one_name import Renaming, letter_of_answer

RATES = {"_dot": "omega", "_ddot": "alpha"}
ANGLE = "theta"


def with_turning_rates(blocks: Sequence[Block], own: Iterable[str]) -> list[Block]:
    """The blocks of a part. `own`: names of coordinates that the file declares, whose rates are what its author asks
    for.
    """
    declared = set(own)
    angles = {a for b in blocks if isinstance(b, Equation) for a in _angles(b)} - declared
    called = sorted(a for a in declared if _is_called_so(a, blocks))
    angles |= set(called)
    names = {f"{a}{mark}": f"{stem}{a.removeprefix(ANGLE)}" for a in sorted(angles) for mark, stem in RATES.items()}
    if not names:
        return list(blocks)
    renaming = Renaming(names)
    answered = (renaming.answered(b) if isinstance(b, Answer) else renaming.of(b) for b in blocks)
    return _once(_defined([_shorter(b) for b in answered], called))


def _is_called_so(angle: str, blocks: Sequence[Block]) -> bool:
    """Is the rate of a declared angle asked for as ω, and is nothing else on the page called ω or α?"""
    if not angle.startswith(ANGLE):
        return False
    omega, alpha = (f"{stem}{angle.removeprefix(ANGLE)}" for stem in RATES.values())
    answers = [b for b in blocks if isinstance(b, Answer)]
    asked = [b for b in answers if b.name == omega and letter_of_answer(b.line) == f"{angle}_dot"]
    letters = {s.name for b in blocks for p in pieces_of(b) if isinstance(p, Math) for s in p.expr.free_symbols}
    others = {b.name for b in answers if b not in asked}
    return bool(asked) and not {omega, alpha} & (others | {x.partition("__")[0] for x in letters})


def _defined(blocks: list[Block], angles: Iterable[str]) -> list[Block]:
    """With ω = θ̇, α = θ̈ of these angles at the beginning of the solution."""
    told = [
        piece
        for a in angles
        for mark, stem in RATES.items()
        for piece in (", ", Name(f"{stem}{a.removeprefix(ANGLE)}"), " = ", Name(f"{a}{mark}"))
    ]
    first = next((i for i, b in enumerate(blocks) if isinstance(b, Heading)), None)
    if not told or first is None:
        return blocks
    return [*blocks[: first + 1], Paragraph(line(*told[1:])), *blocks[first + 1 :]]


def _once(blocks: Sequence[Block]) -> list[Block]:
    """Without a law that only repeats what the equations gave, α = 0.1667 rad/s², under a heading of its own; of one
    that says what α is in this motion, α = α_1 = 0.1667 rad/s², α_1 stands where it is first used.
    """
    found: list[Block] = []
    waiting: Equation | None = None
    for i, block in enumerate(blocks):
        heading = found[-1] if found else None
        law = isinstance(heading, Paragraph) and str(getattr(heading.line[0], "text", "")).startswith(FOR)
        if law and isinstance(block, Equation) and _repeats(block, found):
            found.pop()
        elif law and isinstance(block, Equation) and _is_of_motion(block) and _begins(blocks[i + 1 : i + 2]):
            found.pop()
            waiting = replace(block, sides=block.sides[1:])
        else:
            found.append(block)
            found += [waiting] if waiting is not None else []
            waiting = None
    return found


def _begins(following: Sequence[Block]) -> bool:
    """Is what follows the heading under which a law is used?"""
    return any(isinstance(b, Paragraph) for b in following)


def _is_of_motion(law: Equation) -> bool:
    """Is it α = α_1 = number?"""
    letters = _letters(law)
    return law.number is None and len(letters) == len(law.sides) - 1 == 2 and len({_own(x) for x in letters}) == 1


def _letters(equation: Equation) -> list[str]:
    """The sides of an equation that are single letters."""
    return [s.expr.name for s in equation.sides if isinstance(s, Math) and s.expr.is_Symbol]


def _repeats(law: Equation, before: Iterable[Block]) -> bool:
    """Does a law say nothing but a number that the page gave last for that letter, or for it in this motion, α_1?"""
    letters = _letters(law)
    told = {str(b.sides[0]): b.sides[-1] for b in before if isinstance(b, Equation)}
    same = len(letters) == len(law.sides) - 1 and len({_own(x) for x in letters}) == 1
    return law.number is None and same and told.get(str(law.sides[-2])) == law.sides[-1]


def _own(letter: str) -> str:
    """A letter without the state at which a motion begins."""
    return letter.partition("__")[0]


def _angles(equation: Equation) -> set[str]:
    """The angles of which an equation says that their rate is that of a body: θ̈ = α, or α_2 = θ̈."""
    letters = _letters(equation)
    found = set()
    for letter in letters:
        for mark, stem in RATES.items():
            angle = letter.removesuffix(mark)
            body = f"{stem}{angle.removeprefix(ANGLE)}"
            if letter.endswith(mark) and angle.startswith(ANGLE) and body in {x.partition("__")[0] for x in letters}:
                found.add(angle)
    return found


def _shorter(block: Any) -> Any:
    """A check without `α = α`."""
    if not isinstance(block, Check):
        return block
    kept: list[Any] = []
    for piece in block.line:
        equal = len(kept) > 1 and kept[-1] == Text(" = ") and kept[-2] == piece
        kept = kept[:-1] if equal else [*kept, piece]
    return replace(block, line=tuple(kept))
