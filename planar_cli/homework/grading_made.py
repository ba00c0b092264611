"""How a worker comes to grade: by the papers of a set, its rules, and the equations by which errors are carried."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from planar_cli.homework.carried_verdicts import Carry
from planar_cli.homework.grading import Remembered, grade
from planar_cli.homework.paper import Expected, Paper, Result, Submission, Task
from planar_cli.homework.ready import Homework
from planar_cli.homework.rules import Rules
from planar_cli.homework.set_file import HomeworkSet
from planar_cli.records import record


@record
class MakeGrade:
    """Crosses processes; called once in each worker."""

    papers: Mapping[int, Paper]
    rules: Rules
    students: Mapping[str, int]
    """The variants that the set gives to students."""
    carrying: Mapping[str, bytes]

    def __call__(self) -> Callable[[Submission], Result]:
        return _Grade(self)


class _Grade:
    def __init__(self, made: MakeGrade) -> None:
        self.made = made
        self._carrier: Callable[[int], Carry] | None = None
        self._remembered = Remembered()

    def __call__(self, submission: Submission) -> Result:
        made = self.made
        own = made.students.get(submission.student)
        if own is not None and submission.variant not in (0, own):
            why = f"variant {submission.variant} was answered, but the set gives variant {own} to this student"
            submission = replace(submission, wrong=(*submission.wrong, why))
        if own is None and made.students and not submission.variant:
            # The numbers of the files as they are belong to nobody.
            why = "this student is not in the list of the set, and no variant is given: not graded"
            return Result(submission.student, 0, (), submission.source, (*submission.wrong, why))
        variant = submission.variant if own is None else own
        handed = replace(submission, variant=variant)
        carry = _Lazily(self, variant) if made.rules.carried else None
        return grade(handed, made.papers, made.rules, carry, self._remembered)

    def carrier(self, variant: int) -> Carry:
        """Carrying needs SymPy and NumPy: only a wrong answer behind a wrong answer imports them."""
        if self._carrier is None:
            from planar_cli.homework.carried_errors import Carrier, unpickled

            self._carrier = Carrier(unpickled(self.made.carrying)).for_variant
        return self._carrier(variant)


class _Lazily:
    """A carrier that is made when it is first needed."""

    def __init__(self, grade_of: _Grade, variant: int) -> None:
        self.grade_of, self.variant = grade_of, variant

    def __call__(
        self, task: Task, expected: Expected, own: Mapping[str, tuple[float, ...]]
    ) -> tuple[tuple[float, ...], tuple[str, ...]] | None:
        return self.grade_of.carrier(self.variant)(task, expected, own)


def grading_of(homework_set: HomeworkSet, homework: Homework) -> MakeGrade:
    """What workers of a set are made from."""
    students = {s: v for s in homework_set.students if (v := homework_set.variant_of(s)) is not None}
    return MakeGrade(homework.papers, homework_set.rules, students, homework.carrying)
