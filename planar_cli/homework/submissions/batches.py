"""Many submissions graded: in batches, on workers here or on a cluster, with results as they come.

Nothing is kept but the names of what is done, so that memory does not grow with the class. A worker that ends over a
submission, or takes too long, costs nobody else theirs: that one is tried once more alone, and then told as ungradable
with the reason; what stood behind it in its batch is graded by another worker.
"""

from __future__ import annotations

import contextlib
import hashlib
import itertools
import os
import pickle
import re
import threading
import zlib
from collections import Counter
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from dataclasses import replace
from functools import partial

from planar_cli.errors import PlanarError, Undecided
from planar_cli.homework.submissions.grader import Batch, Begun, Grader, Grading, Piece, Told, given_up
from planar_cli.homework.submissions.in_order import InOrder
from planar_cli.homework.submissions.submissions import contents, submission_files
from planar_cli.homework.tasks.interrupts import number_of, terminated
from planar_cli.homework.tasks.results import Index, Line, ResultsFile
from planar_cli.homework.tasks.supervisor import Heard, Supervisor
from planar_cli.problem.nodes.show import visible
from planar_cli.records import record

SIZE = 64
"""Files in a batch: what it costs to hand one over is then small beside grading it."""
AHEAD = 64
"""Batches that a cluster is given beyond those whose results have come."""


@record
class Ran:
    """What came of a run: submissions graded in it by how that ended, and those that were done before.

    `interrupted`: the number of the signal that ended it early, 0 if none did; `left`: so many files are not done then.
    """

    graded: int
    skipped: int
    ended: Mapping[str, int]
    twice: tuple[str, ...]
    interrupted: int = 0
    left: int = 0


def grade_files(
    names: Sequence[str],
    grading: Grading,
    jobs: int,
    results: str | None = None,
    shard: tuple[int, int] = (1, 1),
    executor: Executor | None = None,
    take: Callable[[Line], None] = lambda line: None,
) -> Ran:
    """Grade all submissions of files and folders, but those that the results file `results` has already.

    `take` hears each line in the order of the files, and of the rows of a table, as soon as all before it are written.
    `executor`: a cluster, else `jobs` workers work here. An interrupt or SIGTERM ends the run early, with all lines
    written and no worker left. Raises PlanarError for names that are not there, a results file that is none, and a
    cluster that fails.
    """
    written = ResultsFile(results) if results is not None else None
    index = written.index if written is not None else Index()
    before: list[int] = []
    ended: Counter[str] = Counter()
    own = os.path.abspath(results) if results is not None else ""

    def files() -> Iterator[str]:
        return (p for p in submission_files(names) if in_shard(p, shard) and os.path.abspath(p) != own)

    order = InOrder(take)
    batches = batches_of(order.expecting(_undone(files(), index, grading.key, before.append)))
    lines = graded_here(grading, batches, jobs) if executor is None else graded_by(executor, batches, grading)
    interrupted = 0
    try:
        with terminated(), contextlib.closing(lines):
            for line in lines:
                if written is not None:
                    written.write(line)
                else:
                    index.enter(line)
                ended[line.ended] += 1
                order.hear(line)
    except KeyboardInterrupt as stop:
        interrupted = number_of(stop)
    finally:
        if written is not None:
            written.close()
        order.close()
    left = sum(1 for _ in _undone(files(), index, grading.key, lambda _: None)) if interrupted else 0
    return Ran(sum(ended.values()), sum(before), dict(sorted(ended.items())), tuple(index.twice()), interrupted, left)


# --- what is to be done ----------------------------------------------------------------------------------------------


def shard_of(text: str) -> tuple[int, int]:
    """`3/40`: the third of forty shards. Raises PlanarError."""
    found = re.fullmatch(r"([0-9]{1,6})/([0-9]{1,6})", text)
    if found is None or not 1 <= int(found[1]) <= int(found[2]):
        raise PlanarError(f"`{visible(text)}` is no shard: write `3/40` for the third of forty")
    return int(found[1]), int(found[2])


def in_shard(path: str, shard: tuple[int, int]) -> bool:
    """Does a file belong to a shard? Its own name decides, not its folder: the same on every machine."""
    which, of = shard
    digest = hashlib.sha256(os.fsencode(os.path.basename(path))).digest()
    return of == 1 or int.from_bytes(digest, "big") % of == which - 1


def batches_of(pieces: Iterable[Piece], size: int = SIZE) -> Iterator[Batch]:
    """The pieces in batches."""
    rest = iter(pieces)
    for number in itertools.count():
        some = tuple(itertools.islice(rest, size))
        if not some:
            return
        yield Batch(number, some)


def _undone(paths: Iterable[str], index: Index, key: str, skip: Callable[[int], None]) -> Iterator[Piece]:
    """What is not done yet, or was done with another content or key; `skip` hears of how many submissions are."""
    for path in paths:
        done = index.files.get(path)
        if done is None or (done.content, done.key) != (contents(path).digest, key):
            yield Piece(path)
            continue
        skip(len(done.have))
        missing = done.missing()
        if missing:
            yield Piece(path, missing, done.content, done.parts)


# --- workers here ----------------------------------------------------------------------------------------------------


def graded_here(grading: Grading, batches: Iterable[Batch], jobs: int) -> Generator[Line, None, None]:
    """A line for each submission, as it is graded; close the iterator, and no worker is left."""
    supervisor = _supervisor(grading, jobs)
    try:
        yield from _lines(supervisor, batches, grading.key)
    finally:
        supervisor.close()


def _supervisor(grading: Grading, jobs: int) -> Supervisor:
    return Supervisor(None, jobs, grading.timeout, make=partial(Grader, grading), memory=grading.memory)


def _lines(supervisor: Supervisor, batches: Iterable[Batch], key: str) -> Iterator[Line]:
    """What the workers tell; what one ended over is given to others as it must be."""
    # Of each batch the piece that is worked on, and of a table what is still to be graded.
    at: dict[int, tuple[int, Begun | None]] = {}
    more = itertools.count(-1, -1)
    for heard in supervisor.stream(batches):
        batch: Batch = heard.item
        match heard.result:
            case Begun() as begun if heard.verdict == "part":
                at[batch.number] = begun.piece, begun
            case Told(piece, line) if heard.verdict == "part":
                left = _after(at.get(batch.number, (0, None))[1], piece, line.part)
                at[batch.number] = (piece, left) if left is not None else (piece + 1, None)
                yield line
            case _:
                number, left = at.pop(batch.number, (0, None))
                if heard.verdict != "ok" and number < len(batch.pieces):
                    lost, rest = _parted(batch.pieces[number], left)
                    again = (*rest, *batch.pieces[number + 1 :])
                    if again:
                        supervisor.again(Batch(next(more), again))
                    if lost.ended:
                        yield given_up(lost, lost.ended, lost.why, key)
                    else:
                        supervisor.again(Batch(next(more), (_once_more(lost, heard),)))


def _after(begun: Begun | None, piece: int, part: int) -> Begun | None:
    """What is left of a table behind a part; None: nothing."""
    if begun is None or begun.piece != piece or begun.parts[-1] == part:
        return None
    return replace(begun, parts=begun.parts[begun.parts.index(part) + 1 :])


def _parted(piece: Piece, left: Begun | None) -> tuple[Piece, tuple[Piece, ...]]:
    """What a worker ended over, and what is left of the same file."""
    if left is None:
        return piece, ()
    whole = replace(piece, content=left.content, total=left.total, tried=False, ended="", why="")
    alone = replace(whole, parts=left.parts[:1])
    # It was alone before only if this very part was.
    alone = replace(piece, content=left.content, total=left.total) if alone.parts == piece.parts else alone
    return alone, (replace(whole, parts=left.parts[1:]),) if left.parts[1:] else ()


def _once_more(lost: Piece, heard: Heard) -> Piece:
    """A worker may end for what came before; who ends a second one, alone, is not tried again."""
    if not lost.tried:
        return replace(lost, tried=True)
    ended = heard.verdict if heard.verdict in ("timeout", "memory") else "crashed"
    return replace(lost, ended=ended, why=str(heard.result))


# --- a cluster -------------------------------------------------------------------------------------------------------

_KEPT: list[tuple[bytes, str, Supervisor]] = []
"""Workers that wait for the next batch in a process of a cluster, behind what they grade by and the digest of it."""
_LOCK = threading.Lock()


def graded_by(
    executor: Executor, batches: Iterable[Batch], grading: Grading, ahead: int = AHEAD
) -> Generator[Line, None, None]:
    """The same on any executor, that of a cluster too: each of its tasks grades one batch, and kills what must be.

    Raises Undecided where the executor loses a batch twice: what has come until then is right.
    """
    # Papers of many variants are much alike, and are sent along with each batch.
    packed = zlib.compress(pickle.dumps(grading))
    waiting = iter(batches)
    running: dict[Future[list[Line]], tuple[Batch, bool]] = {}
    try:
        for batch in itertools.islice(waiting, ahead):
            running[executor.submit(graded_batch, packed, batch)] = batch, False
        while running:
            finished = wait(running, return_when=FIRST_COMPLETED).done
            for future in [f for f in running if f in finished]:
                batch, tried = running.pop(future)
                error = future.exception()
                if error is not None and tried:
                    raise Undecided(f"the cluster lost a batch twice: {visible(str(error) or type(error).__name__)}")
                if error is not None:
                    running[executor.submit(graded_batch, packed, batch)] = batch, True
                    continue
                yield from future.result()
                for following in itertools.islice(waiting, 1):
                    running[executor.submit(graded_batch, packed, following)] = following, False
    finally:
        for future in running:
            future.cancel()


def graded_batch(packed: bytes, batch: Batch) -> list[Line]:
    """The lines of one batch, by a worker of this process that is kept for the next."""
    key, supervisor = _kept(packed) or _new(packed)
    try:
        lines = list(_lines(supervisor, (batch,), key))
    except BaseException:
        supervisor.close()
        raise
    with _LOCK:
        _KEPT.append((packed, key, supervisor))
    return lines


def _new(packed: bytes) -> tuple[str, Supervisor]:
    grading: Grading = pickle.loads(zlib.decompress(packed))
    return grading.key, _supervisor(grading, 1)


def _kept(packed: bytes) -> tuple[str, Supervisor] | None:
    with _LOCK:
        ours = [kept for kept in _KEPT if kept[0] == packed]
        others = [kept for kept in _KEPT if kept[0] != packed]
        _KEPT[:] = ours[:-1]
    for _, _, supervisor in others:
        supervisor.close()
    return ours[-1][1:] if ours else None
