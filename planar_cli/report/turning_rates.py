"""One name for how fast a body turns: where a page says θ̈ = α, its θ̇ and θ̈ are ω and α throughout."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

from planar_cli.report.blocks import Block, Check, Equation, Math, Paragraph, Text
from planar_cli.report.laws import FOR
from planar_cli.report.one_name import Renaming

RATES = {"_dot": "omega", "_ddot": "alpha"}
ANGLE = "theta"


def with_turning_rates(blocks: Sequence[Block], own: Iterable[str]) -> list[Block]:
    """The blocks of a part. `own`: names of coordinates that the file declares, whose rates are what its author asks
    for.
    """
    declared = set(own)
    angles = {a for b in blocks if isinstance(b, Equation) for a in _angles(b)} - declared
    names = {f"{a}{mark}": f"{stem}{a.removeprefix(ANGLE)}" for a in sorted(angles) for mark, stem in RATES.items()}
    if not names:
        return list(blocks)
    renaming = Renaming(names)
    return _once([_shorter(renaming.of(b)) for b in blocks])


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
