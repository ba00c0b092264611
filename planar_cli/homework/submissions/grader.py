"""What a worker does with a batch of submissions: it reads each file, grades what is in it, and tells each result."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from planar_cli.homework.sets.paper import Result, Submission
from planar_cli.homework.submissions.submissions import Contents, contents, submissions
from planar_cli.homework.submissions.submitted import student_of_file
from planar_cli.homework.tasks.memory import MEMORY
from planar_cli.homework.tasks.results import Line, line_of
from planar_cli.records import record

Grade = Callable[[Submission], Result]
OK, CRASHED = "ok", "crashed"
TIMEOUT = 10.0


@record
class Grading:
    """How submissions are graded; crosses processes by pickling.

    `make` is called once in each worker and gives the function that grades one submission; `key` is the digest of what
    it grades by. `timeout` [s] is for one submission, its file read, 0 is none; `memory` [bytes] is a worker's.
    """

    make: Callable[[], Grade]
    key: str
    timeout: float = TIMEOUT
    memory: int = MEMORY


@record
class Piece:
    """A file, or of a table some parts; these belong to the content with the digest `content`, and are of `total`.

    `tried`: it was with a worker that ended over it. `ended`, `why`: it is not tried again, and why.
    """

    path: str
    parts: tuple[int, ...] = ()
    content: str = ""
    total: int = 1
    tried: bool = False
    ended: str = ""
    why: str = ""


@record
class Batch:
    """Pieces that a worker does one after the other; no two batches of a run have the same number."""

    number: int
    pieces: tuple[Piece, ...]


@record
class Begun:
    """A table was read: which parts of it are graded now."""

    piece: int
    parts: tuple[int, ...]
    content: str
    total: int


@record
class Told:
    """One submission was graded."""

    piece: int
    line: Line


class Grader:
    """The function of a worker."""

    def __init__(self, grading: Grading) -> None:
        self.grade, self.key = grading.make(), grading.key

    def __call__(self, batch: Batch) -> Iterator[Begun | Told]:
        for number, piece in enumerate(batch.pieces):
            read = contents(piece.path)
            handed = submissions(read)
            known = piece.parts and piece.content == read.digest and piece.total == len(handed)
            parts = piece.parts if known else tuple(range(len(handed)))
            if len(parts) > 1:
                yield Begun(number, parts, read.digest, len(handed))
            for part in parts:
                yield Told(number, self._line(handed[part], (part, len(handed)), read, piece))

    def _line(self, handed: Submission, place: tuple[int, int], read: Contents, piece: Piece) -> Line:
        ended, why = piece.ended or OK, piece.why
        if piece.ended:
            handed = without_answers(handed, piece.ended, piece.why)
        digests = read.digest, self.key
        try:
            return line_of(self._graded(handed), place, digests, ended, why)
        except MemoryError:
            raise
        except Exception as error:
            # Of the student's answers, or of ours; with the reason alone none of them is told to the student.
            ended, why = CRASHED, f"{type(error).__name__}: {error}"
        handed = without_answers(handed, ended, "grading it failed")
        try:
            return line_of(self._graded(handed), place, digests, ended, why)
        except MemoryError:
            raise
        except Exception:
            return line_of(ungraded(handed), place, digests, ended, why)

    def _graded(self, handed: Submission) -> Result:
        """The result; whatever graded it, it is of this file."""
        return replace(self.grade(handed), source=handed.source)


def without_answers(handed: Submission, ended: str, why: str) -> Submission:
    """A submission that nobody looks at any more, and why."""
    return replace(handed, answers=(), wrong=(*handed.wrong, f"ungradable ({ended}): {why}"))


def ungraded(handed: Submission) -> Result:
    """What is told of a submission that even without its answers is not graded."""
    return Result(handed.student, handed.variant, (), handed.source, handed.wrong)


def given_up(piece: Piece, ended: str, why: str, key: str) -> Line:
    """What is told of a file over which every worker ends."""
    part = piece.parts[0] if piece.parts else 0
    student = student_of_file(piece.path) + (f" #{part + 1}" if piece.total > 1 else "")
    handed = without_answers(Submission(student, 0, (), piece.path), ended, why)
    digests = piece.content or contents(piece.path).digest, key
    return line_of(ungraded(handed), (part, piece.total), digests, ended, why)
