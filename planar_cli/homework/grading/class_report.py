"""How a class did: of each find how many were right, and which mistakes were made; what all miss is suspicious."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import field

from planar_cli.homework.sets.paper import MISSING, RIGHT, UNGRADABLE, Result
from planar_cli.records import changing, record

FEW, SUSPICIOUS = 5, 0.1
"""With at least so many answers, a find of which a smaller part is right may itself be wrong."""


@changing
class FindTally:
    """One find, over all variants."""

    answers: int = 0
    right: int = 0
    ungradable: int = 0
    missing: int = 0
    carried: int = 0
    mistakes: Counter[str] = field(default_factory=Counter)
    by_variant: dict[int, list[int]] = field(default_factory=dict)
    """Of each variant, how many gave an answer that can be graded and how many were right."""


@changing
class ClassReport:
    """All results, added one by one."""

    submissions: int = 0
    best: float = 0.0
    counted: dict[str, tuple[bool, str, float]] = field(default_factory=dict)
    """Of each student the submission that counts: was anything graded, its file, its score."""
    finds: dict[tuple[str, str], FindTally] = field(default_factory=dict)
    refused: int = 0

    def add(self, result: Result) -> None:
        """One more submission. Of several of one student the last in the order of the files counts in the average,
        of those of which anything could be graded; the finds are counted in all.
        """
        self.submissions += 1
        mine = *order_of(result), result.score
        before = self.counted.get(result.student)
        if before is None or mine[:2] >= before[:2]:
            self.counted[result.student] = mine
        self.best = max(self.best, result.max_score)
        self.refused += not is_graded(result)
        for one in result.graded if is_graded(result) else ():
            tally = self.finds.setdefault((one.problem, one.find), FindTally())
            if one.verdict == MISSING:
                tally.missing += 1
                continue
            tally.answers += 1
            tally.right += one.verdict == RIGHT
            tally.ungradable += one.verdict == UNGRADABLE
            tally.carried += bool(one.carried)
            tally.mistakes.update(one.mistakes if len(one.mistakes) == 1 else ())
            if one.verdict == UNGRADABLE:
                # How an answer was written says nothing of a variant.
                continue
            counts = tally.by_variant.setdefault(result.variant, [0, 0])
            counts[0] += 1
            counts[1] += one.verdict == RIGHT

    @property
    def students(self) -> int:
        return len(self.counted)

    @property
    def mean(self) -> float:
        """The average score of a student."""
        return sum(score for _, _, score in self.counted.values()) / max(self.students, 1)

    def suspicious(self) -> Iterator[tuple[str, str, str]]:
        """Finds that nearly everybody misses, with the reason in words."""
        for (problem, find), tally in self.finds.items():
            judged = tally.answers - tally.ungradable
            if judged >= FEW and tally.right <= SUSPICIOUS * judged:
                yield problem, find, f"{tally.right} of {judged} right: look whether the problem or the key is at fault"
                continue
            for variant, (answers, right) in sorted(tally.by_variant.items()):
                others = judged - answers
                if answers >= FEW and right <= SUSPICIOUS * answers and others and tally.right - right > others / 2:
                    yield problem, find, f"variant {variant}: {right} of {answers} right, of the others most"


def order_of(result: Result) -> tuple[bool, str]:
    """Of several submissions of a student that counts which is last by this: was anything graded, and its file."""
    return is_graded(result), result.source


def is_graded(result: Result) -> bool:
    """Was there anything to grade? Of a file that cannot be read no find was answered."""
    return any(one.verdict != UNGRADABLE or one.submitted for one in result.graded)


def counting(results: Iterable[Result]) -> dict[str, Result]:
    """Of each student the submission that counts, in the order in which the students appear."""
    found: dict[str, Result] = {}
    for result in results:
        before = found.get(result.student)
        if before is None or order_of(result) >= order_of(before):
            found[result.student] = result
    return found


@record
class Row:
    """One line of the table of a class."""

    problem: str
    find: str
    answers: int
    right: int
    ungradable: int
    carried: int
    mistakes: str


def rows(report: ClassReport) -> Iterable[Row]:
    """The table, find by find."""
    for (problem, find), tally in report.finds.items():
        told = ", ".join(f"{name} {count}" for name, count in tally.mistakes.most_common(4))
        yield Row(problem, find, tally.answers, tally.right, tally.ungradable, tally.carried, told)


def by_variant(report: ClassReport, least: int = 1) -> dict[int, dict[tuple[str, str], tuple[int, int]]]:
    """Of each variant that at least so many answered: of every find, by problem and name, how many were right and how
    many answers there are.
    """
    found: dict[int, dict[tuple[str, str], tuple[int, int]]] = {}
    for variant in sorted({v for tally in report.finds.values() for v in tally.by_variant}):
        counts = {name: tally.by_variant.get(variant, [0, 0]) for name, tally in report.finds.items()}
        if max(answers for answers, _ in counts.values()) >= least:
            found[variant] = {name: (right, answers) for name, (answers, right) in counts.items()}
    return found
