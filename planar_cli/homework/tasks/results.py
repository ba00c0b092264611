"""Results on disk: a line of JSON for each submission, with the digests of its file and of the key.

What stands there is done: who grades the same files again takes up where it was left. A later line of the same
submission counts, and of a file that was changed only the lines of its last content.
"""

from __future__ import annotations

import contextlib
import json
import os
import stat
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field, fields
from typing import Any, BinaryIO

from planar_cli.errors import PlanarError
from planar_cli.homework.sets.paper import Graded, Result
from planar_cli.problem.nodes.show import visible
from planar_cli.records import changing, record

VERSION = 1
MOST_TOLD = 20
GRADED = tuple((f.name, f.default) for f in fields(Graded))


@record
class Line:
    """One submission graded: where it stands, how that ended (ok, timeout, memory, crashed), and its line of JSON.

    `part` of `parts`: a table has those of a class.
    """

    file: str
    part: int
    parts: int
    content: str
    key: str
    ended: str
    student: str
    text: str


def line_of(result: Result, place: tuple[int, int], digests: tuple[str, str], ended: str, why: str) -> Line:
    """The line of a result; `place`: part and parts, `digests`: of the file and of the key."""
    more = {"ended": ended, "why": why, "result": as_data(result)}
    return line_with(more, result.source, place, digests, ended, result.student)


def line_with(
    more: Mapping[str, Any],
    file: str,
    place: tuple[int, int],
    digests: tuple[str, str],
    ended: str = "ok",
    student: str = "",
) -> Line:
    """A line with `more` behind what tells its place."""
    head = dict(zip(("file", "part", "parts", "content", "key"), (file, *place, *digests), strict=True))
    # Only ASCII: no name of a file and nothing typed can break a line or a terminal.
    text = json.dumps(
        {"schema_version": VERSION, **head, **more}, ensure_ascii=True, allow_nan=False, separators=(",", ":")
    )
    return Line(file, *place, *digests, ended, student, text)


def as_data(result: Result) -> dict[str, Any]:
    """A result as JSON holds it; of each find only what says something."""
    return {
        "student": result.student,
        "variant": result.variant,
        "wrong": list(result.wrong),
        "graded": [
            {name: value for name, default in GRADED if (value := getattr(one, name)) != default}
            for one in result.graded
        ],
    }


def result_of(text: str | bytes) -> Result:
    """The result of a line."""
    line = json.loads(text)
    data = line["result"]
    if "graded" not in data:
        raise PlanarError(f"{visible(line['file'])}: the results are of problem files, not of submissions")
    graded = tuple(_graded(one) for one in data["graded"])
    return Result(data["student"], data["variant"], graded, line["file"], tuple(data["wrong"]))


def _graded(data: Mapping[str, Any]) -> Graded:
    known: dict[str, Any] = {n: data[n] for n, _ in GRADED if n in data}
    known = {n: tuple(v) if isinstance(v, list) else v for n, v in known.items()}
    return Graded(**known)


# --- what is done ----------------------------------------------------------------------------------------------------


@changing
class Done:
    """What is done of one file: for each part the student, and where its line begins."""

    content: str
    key: str
    parts: int
    have: dict[int, tuple[str, int, int]] = field(default_factory=dict)

    def missing(self) -> tuple[int, ...]:
        """The parts that are not there."""
        return tuple(part for part in range(self.parts) if part not in self.have)


class Index:
    """What is done of every file. It holds names and places, not results: those stay on disk."""

    def __init__(self) -> None:
        self.files: dict[str, Done] = {}

    def add(self, line: Mapping[str, Any], student: str, number: int = 0, offset: int = 0) -> None:
        """A line that begins at `offset` of the results file `number`."""
        done = self.files.get(line["file"])
        if done is None or (done.content, done.key, done.parts) != (line["content"], line["key"], line["parts"]):
            done = self.files[line["file"]] = Done(line["content"], line["key"], line["parts"])
        done.have[line["part"]] = student, number, offset

    def enter(self, line: Line) -> None:
        """A line that is written now."""
        self.add(
            {"file": line.file, "content": line.content, "key": line.key, "parts": line.parts, "part": line.part},
            line.student,
        )

    def twice(self) -> list[str]:
        """A sentence for each student who handed in several times."""
        files: dict[str, list[str]] = {}
        for name, done in sorted(self.files.items()):
            for student, _, _ in done.have.values():
                files.setdefault(student, []).append(name)
        several = [(student, names) for student, names in sorted(files.items()) if len(names) > 1]
        told = [
            visible(
                f"{student} handed in {len(names)} times: {', '.join(names[:4])}{', …' if names[4:] else ''}; "
                "all are graded, the last that can be counts in the average"
            )
            for student, names in several[:MOST_TOLD]
        ]
        more = len(several) - len(told)
        return [*told, f"{more} more students handed in several times"] if more else told


def _lines(stream: BinaryIO, name: str) -> Iterator[tuple[int, bytes, dict[str, Any]]]:
    """Offset, text and content of each line, of a submission or of a problem file (a `result` of nobody); a last one
    that was cut off is none.
    """
    offset = 0
    for number, text in enumerate(stream, 1):
        if not text.endswith(b"\n"):
            return
        try:
            data = json.loads(text)
            _ = data["file"], data["content"], data["key"], data["parts"], data["part"], data["result"]["student"]
        except (ValueError, KeyError, TypeError, RecursionError):
            raise PlanarError(f"{visible(name)}:{number}: this is no line of results") from None
        yield offset, text, data
        offset += len(text)


class ResultsFile:
    """A results file that is added to, by one process at a time; raises PlanarError where that cannot be."""

    def __init__(self, name: str) -> None:
        self.name, self.index = name, Index()
        flags = os.O_RDWR | os.O_CREAT | os.O_APPEND | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
        try:
            self._descriptor = os.open(name, flags | getattr(os, "O_BINARY", 0), 0o666)
        except (OSError, ValueError) as error:
            reason = (error.strerror if isinstance(error, OSError) else None) or str(error)
            raise PlanarError(f"the results cannot be written to {visible(name)}: {reason}") from None
        try:
            self._take()
        except BaseException:
            self.close()
            raise

    def _take(self) -> None:
        if not stat.S_ISREG(os.fstat(self._descriptor).st_mode):
            raise PlanarError(f"the results cannot be written to {visible(self.name)}: it is not a regular file")
        try:
            _lock(self._descriptor, "LOCK_EX")
        except BlockingIOError:
            raise PlanarError(f"another run is writing to {visible(self.name)}") from None
        whole = 0
        with open(os.dup(self._descriptor), "rb") as stream:
            stream.seek(0)
            for offset, text, data in _lines(stream, self.name):
                self.index.add(data, data["result"]["student"], 0, offset)
                whole = offset + len(text)
        # The process that wrote here last may have been stopped within a line.
        os.ftruncate(self._descriptor, whole)

    def write(self, line: Line) -> None:
        """Add a line, in one piece: whoever is killed leaves whole lines."""
        data = line.text.encode("ascii") + b"\n"
        try:
            while data:
                data = data[os.write(self._descriptor, data) :]
        except OSError as error:
            raise PlanarError(f"the results cannot be written to {visible(self.name)}: {error.strerror}") from None
        self.index.enter(line)

    def close(self) -> None:
        """Give it free."""
        # A process forked meanwhile, by a pool, has the same descriptor and would hold the lock.
        _lock(self._descriptor, "LOCK_UN")
        os.close(self._descriptor)


def _lock(descriptor: int, how: str) -> None:
    """Take or free the lock on a file, at once or BlockingIOError; Windows has none of the kind."""
    with contextlib.suppress(ImportError):
        import fcntl

        fcntl.flock(descriptor, getattr(fcntl, how) | fcntl.LOCK_NB)


# --- read and merged -------------------------------------------------------------------------------------------------


def merge(names: Sequence[str]) -> Iterator[str]:
    """The lines of several results files, those of shards, in the order of their submissions; later ones count.

    Raises PlanarError where they were not graded with the same key.
    """
    index = Index()
    with contextlib.ExitStack() as stack:
        streams = [stack.enter_context(_opened(name)) for name in names]
        for number, (name, stream) in enumerate(zip(names, streams, strict=True)):
            for offset, _, data in _lines(stream, name):
                index.add(data, data["result"]["student"], number, offset)
        _refuse_other_keys(index, names)
        for _, done in sorted(index.files.items()):
            for _, (_, number, offset) in sorted(done.have.items()):
                streams[number].seek(offset)
                yield streams[number].readline().decode("ascii").rstrip("\n")


def results(names: Sequence[str]) -> Iterator[Result]:
    """What results files hold, one by one, in the order of their submissions; errors as of `merge`."""
    for text in merge(names):
        yield result_of(text)


def lines_of(name: str) -> Iterator[dict[str, Any]]:
    """The lines of a results file as they stand in it."""
    with _opened(name) as stream:
        for _, _, data in _lines(stream, name):
            yield data


def handed_in_twice(names: Iterable[str]) -> list[str]:
    """A sentence for each student of whom results files hold several submissions."""
    index = Index()
    for name in names:
        with _opened(name) as stream:
            for _, _, data in _lines(stream, name):
                index.add(data, data["result"]["student"])
    return index.twice()


def _opened(name: str) -> BinaryIO:
    try:
        return open(name, "rb")
    except (OSError, ValueError) as error:
        reason = (error.strerror if isinstance(error, OSError) else None) or str(error)
        raise PlanarError(f"the results in {visible(name)} cannot be read: {reason}") from None


def _refuse_other_keys(index: Index, names: Sequence[str]) -> None:
    first: tuple[str, str, str] | None = None
    for name, done in sorted(index.files.items()):
        results_file = names[min(done.have.values())[1]]
        if first is None:
            first = done.key, name, results_file
        elif done.key != first[0]:
            raise PlanarError(
                visible(
                    f"{first[1]} (in {first[2]}) and {name} (in {results_file}) were graded with different keys: "
                    "grade all with one key"
                )
            )
