"""How a worker comes to grade: by the papers of a set, its rules, and the equations by which errors are carried."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace

from planar_cli.homework.grading.carried_verdicts import Carry
from planar_cli.homework.grading.grading import Remembered, grade
from planar_cli.homework.sets.paper import Expected, Paper, Result, Submission, Task
from planar_cli.homework.sets.ready import Homework
from planar_cli.homework.sets.rules import Rules
from planar_cli.homework.sets.set_file import HomeworkSet
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
        self._names = _by_plain_names(made.students)

    def __call__(self, submission: Submission) -> Result:
        made = self.made
        submission = replace(submission, student=self._names.get(_plainly(submission.student), submission.student))
        own = made.students.get(submission.student)
        if own is not None and submission.variant not in (0, own):
            why = f"variant {submission.variant} was answered, but the set gives variant {own} to this student"
            submission = replace(submission, wrong=(*submission.wrong, why))
        if own is None and made.students and not submission.variant:
            # The numbers of the files as they are belong to nobody.
            why = "this student is not in the list of the set, and no variant is given: not graded"
            return Result(submission.student, 0, (), submission.source, (*submission.wrong, why))
        if own is None and made.students:
            why = "this student is not in the list of the set; graded by the variant that is given"
            submission = replace(submission, wrong=(*submission.wrong, why))
        variant = submission.variant if own is None else own
        handed = replace(submission, variant=variant)
        carry = _Lazily(self, variant) if made.rules.carried else None
        return grade(handed, made.papers, made.rules, carry, self._remembered)

    def carrier(self, variant: int) -> Carry:
        """Carrying needs SymPy and NumPy: only a wrong answer behind a wrong answer imports them."""
        if self._carrier is None:
            from planar_cli.homework.grading.carried_errors import Carrier, unpickled

            self._carrier = Carrier(unpickled(self.made.carrying)).for_variant
        return self._carrier(variant)


def _plainly(name: str) -> str:
    """A name as whoever types it may write it: capitals and spaces around it say nothing."""
    return " ".join(name.split()).casefold()


def _by_plain_names(students: Iterable[str]) -> dict[str, str]:
    """The names of the list by how they may be written, where that is one name's alone."""
    named: dict[str, list[str]] = {}
    for name in students:
        named.setdefault(_plainly(name), []).append(name)
    return {plain: names[0] for plain, names in named.items() if len(names) == 1}


class _Lazily:
    """A carrier that is made when it is first needed."""

    def __init__(self, grade_of: _Grade, variant: int) -> None:
        self.grade_of, self.variant = grade_of, variant

    def __call__(
        self, task: Task, expected: Expected, own: Mapping[str, tuple[float, ...]], way: int = 0
    ) -> tuple[tuple[float, ...], tuple[str, ...]] | None:
        return self.grade_of.carrier(self.variant)(task, expected, own, way)


def grading_of(homework_set: HomeworkSet, homework: Homework) -> MakeGrade:
    """What workers of a set are made from."""
    students = {s: v for s in homework_set.students if (v := homework_set.variant_of(s)) is not None}
    return MakeGrade(homework.papers, homework_set.rules, students, homework.carrying)
