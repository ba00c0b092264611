"""That another solution gave the same is said once on a page of several cases: under the last of them."""

from __future__ import annotations

from collections.abc import Sequence

from planar_cli.report.blocks import Answer, Block, Check, Heading, line
from planar_cli.report.checks import INDEPENDENT

CASE = "CASE"
CHECKED = Check(line(INDEPENDENT))
ALL = Check(line(f"all answers {INDEPENDENT}"))


def checked_once(page: Sequence[Block]) -> list[Block]:
    """The blocks of a page. As they are where a part has no such check, or has it of some answers only."""
    parts: list[list[Block]] = [[]]
    for block in page:
        if isinstance(block, Heading) and block.label == CASE:
            parts.append([])
        parts[-1].append(block)
    # Before the first case there may be the opening alone. An answer without a check was not compared.
    of_answers = [part for part in parts if any(isinstance(b, Answer | Check) for b in part)]
    started = of_answers == parts or of_answers == parts[1:]
    if len(of_answers) < 2 or not started or not all(CHECKED in part for part in of_answers):
        return list(page)
    kept = [[b for b in part if b != CHECKED] for part in parts[:-1]]
    last = [ALL if b == CHECKED else b for b in parts[-1]]
    return [b for part in (*kept, last) for b in part]
