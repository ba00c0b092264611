"""That another solution gave the same is said once on a page of several cases: under the last of them."""

from __future__ import annotations

from collections.abc import Sequence

from planar_cli.report.checks.checks import INDEPENDENT
from planar_cli.report.document.as_printed import read_alike
from planar_cli.report.document.blocks import Answer, Block, Check, Heading, line

CASE = "CASE"
CHECKED = Check(line(INDEPENDENT))
ALL = Check(line(f"all answers {INDEPENDENT}"))


def checked_once(page: Sequence[Block]) -> list[Block]:
    """The blocks of a page. As they are where a part has no such check, or has it of some answers only; but without a
    check by hand that an earlier part has had word for word.
    """
    parts: list[list[Block]] = [[]]
    had: set[str] = set()
    for block in page:
        if isinstance(block, Heading) and block.label == CASE:
            parts.append([])
            had |= {read_alike(b) for b in parts[-2] if isinstance(b, Check) and not _is_test(b)}
        parts[-1] += [] if isinstance(block, Check) and read_alike(block) in had else [block]
    # Before the first case there may be the opening alone. An answer without a check was not compared.
    of_answers = [part for part in parts if any(isinstance(b, Answer | Check) for b in part)]
    started = of_answers == parts or of_answers == parts[1:]
    if len(of_answers) < 2 or not started or not all(CHECKED in part for part in of_answers):
        return [b for part in parts for b in part]
    kept = [[b for b in part if b != CHECKED] for part in parts[:-1]]
    last = [ALL if b == CHECKED else b for b in parts[-1]]
    return [b for part in (*kept, last) for b in part]


def _is_test(check: Check) -> bool:
    """Is it a condition of what the part assumes, or of another solution: what holds of each part by itself?"""
    said = "".join(str(getattr(piece, "text", "")) for piece in check.line)
    return INDEPENDENT in said or any(sign in said for sign in (">", "<", "≤", "≥"))
