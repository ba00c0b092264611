"""Nothing that a problem file states is ignored: every statement, number, key, unit and name is changed in turn.

    .venv/bin/python tests/mutations.py [--kind number] [--sample 2000] [--seed 1] [--files problems/friction]
    nice -n 19 .venv/bin/python tests/mutations.py --jobs 1 --results /tmp/mutations.jsonl      (all: many hours)

A mutant is refused, has no solution, has another answer, or has the same answer and another page ("told": a mass that
cancels stands in the equations). It may have the very same page for a reason:

    implied   a statement follows from others: its contrary is refused or changes something; so does that of a bound,
              and that of a joint where places are written and nothing has mass: at another point it does not fit; that
              of a guide along which a body moves anyhow: at right angles to it; so does a number of a statement with
              the other sign, where a little more of it changes nothing: a count
    drawn     a place or size on which nothing rests: where a floor goes through, the radius of a disk on a pin; also
              told by a name
    even      a sign that has no meaning: of an angle in a cosine, of the direction of a straight line, of half a turn,
              of what is squared; or in a statement, where another number with the old sign changes something
    assumed   what is only assumed of letters, and no answer rests on it
    asked     a find asks for another thing of the same value
    a name    a name that nothing else uses is spelt otherwise

What is none of it ("unchanged"), ends in a fault, or is refused or left undecided without a place is an offender and
is listed.

First all mutants are read: most are refused there. Then each file is worked out once, in a process of its own, and the
mutants that are left in a child of it, which remembers what it knows of the file and has a limit of processor time for
each. What offends is judged again in a fresh child. The page is written where all answers are the same. With
`--results` each outcome is added to a file at once (a line of JSON); a run that was broken off goes on from there, and
judges the offenders among them anew, and what was not decided within a smaller limit. The files come in an order that
is drawn: part of a run is a sample.
"""

from __future__ import annotations

import argparse
import gc
import hashlib
import importlib
import json
import os
import pkgutil
import random
import tempfile
import time
import traceback
from collections import Counter
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import mutation_record
from mutant_outcomes import FAULT, SOLVED, UNCHANGED, UNDECIDED, Outcome, judged, read, solved
from mutants import KINDS, Mutant, mutants
from mutation_child import Child
from mutation_record import Part

import planar_cli
from planar_cli.problem.nodes import nodes
from planar_cli.problem.scene.scene import Problem

TOO_LONG = "not decided within "


@dataclass(frozen=True, slots=True)
class Judged:
    """A line of the results. `digest`: of the file as it was; `seconds`: of processor time."""

    file: str
    digest: str
    kind: str
    place: str
    what: str
    outcome: str
    detail: str
    seconds: float

    @property
    def key(self) -> tuple[str, ...]:
        return self.file, self.digest, self.kind, self.place, self.what

    @property
    def offends(self) -> bool:
        """Is it a fault, a change that nothing notices, or a refusal without a place?"""
        return self.outcome in (UNCHANGED, FAULT) or self.detail.startswith("no place")

    def is_done(self, limit: float) -> bool:
        """Need it not be judged anew?"""
        stopped = self.detail.removeprefix(TOO_LONG) if self.detail.startswith(TOO_LONG) else ""
        return not self.offends and not (stopped and float(stopped.split()[0]) < limit)


# --- one file ---------------------------------------------------------------------------------------------------------


class FileRun:
    """The mutants of one file, in a process of its own."""

    def __init__(self, file: str, limit: float) -> None:
        self.file, self.limit = file, limit
        _, root, wrong = nodes.read_file(file)
        assert root is not None, wrong
        self.root = root
        self.seconds = 0.0
        """Processor time of all children."""
        self._base: Outcome | None = None
        self._child: Child | None = None

    def refusal(self, mutant: Mutant) -> tuple[str, str] | None:
        """What came of a mutant that is refused as it is read, or is a fault there; None: it is not."""
        try:
            problem = read(self.file, self.root, mutant)
        except Exception as error:
            return FAULT, told_of(error)
        return judged(mutant, problem, problem) if isinstance(problem, Outcome) else None

    def judged(self, mutant: Mutant) -> tuple[str, str]:
        """What came of a mutant; `undecided` also where the file itself has no solution."""
        outcome, detail = self._judged(mutant)
        if outcome != UNCHANGED or not mutant.contrary:
            return outcome, detail
        at = mutant.at if mutant.against is None else mutant.against
        other, detail = self._judged(replace(mutant, at=at, new=mutant.contrary))
        excuse = "even" if mutant.kind == "sign" else "implied"
        return (other, detail) if other in (UNCHANGED, FAULT) else (excuse, detail)

    def _judged(self, mutant: Mutant) -> tuple[str, str]:
        if (refusal := self.refusal(mutant)) is not None:
            return refusal
        if self.base.kind != SOLVED:
            return UNDECIDED, f"the file itself: {self.base.kind} {self.base.detail}"
        fresh = self._child is None
        found = self._in_a_child(mutant)
        if found[0] in (FAULT, UNCHANGED) and not fresh:
            # What was worked out before must not be why.
            self.end()
            found = self._in_a_child(mutant)
        return found

    @property
    def base(self) -> Outcome:
        """The file itself, worked out as soon as a mutant is not refused; its children remember all of it."""
        if self._base is None:
            problem = read(self.file, self.root, None)
            self._base = problem if isinstance(problem, Outcome) else solved(problem)
            gc.collect()
            gc.freeze()
        return self._base

    def _in_a_child(self, mutant: Mutant) -> tuple[str, str]:
        if self._child is None:
            self._child = Child(self._work, self.limit)
        told = self._child.ask(mutant)
        self.seconds += told.seconds
        if told.ended:
            self._child = None
        if told.answer is not None:
            outcome: tuple[str, str] = told.answer
            return outcome
        if told.too_long:
            return UNDECIDED, f"{TOO_LONG}{self.limit:g} s"
        return FAULT, f"the process ended with status {told.status}"

    def _work(self, mutant: Mutant) -> tuple[tuple[str, str], bool]:
        """What a child does with a mutant, and is it fit for another?"""
        try:
            problem = read(self.file, self.root, mutant)
            assert isinstance(problem, Problem)
            return judged(mutant, self.base, solved(problem, self.base)), True
        except MemoryError:
            return (UNDECIDED, "more than 2 GB of memory"), False
        except Exception as error:
            return (FAULT, told_of(error)[:4000]), False

    def end(self) -> None:
        """Its child goes."""
        if self._child is not None:
            self._child.end()
            self._child = None


def told_of(error: Exception) -> str:
    """A fault with the place in the code."""
    frames = traceback.extract_tb(error.__traceback__)
    where = f" ({Path(frames[-1].filename).name}:{frames[-1].lineno})" if frames else ""
    return f"{type(error).__name__}: {error}{where}"


# --- all files --------------------------------------------------------------------------------------------------------


def run(
    files: Sequence[str],
    kinds: Sequence[str],
    sample: int | None,
    seed: int,
    results: Path,
    *,
    jobs: int = 1,
    limit: float = 20,
    recorded: Collection[Part] = (),
) -> list[Judged]:
    """Every mutant of a sample with its outcome. `results`: the file of outcomes, to which those that lack go;
    `recorded`: what need not be judged.
    """
    digests = {file: digest_of(file) for file in files}
    known = [m for file in files for m in mutants(file) if m.kind in kinds]
    known = [m for m in known if Part(m.file, digests[m.file], m.kind) not in recorded]
    if sample is not None and sample < len(known):
        known = [known[i] for i in sorted(random.Random(seed).sample(range(len(known)), sample))]
    wanted = {(m.file, digests[m.file], m.kind, m.place, m.what): m for m in known}
    _import_all()
    done = {j.key for j in judged_before(results) if j.is_done(limit)}
    begun = len(_lines(results))
    for serve, some in PASSES:
        done |= {j.key for j in judged_before(results, begun)}
        left: dict[str, list[Mutant]] = {}
        for key, m in wanted.items():
            if m.kind in some and key not in done:
                left.setdefault(m.file, []).append(m)
        running: set[int] = set()
        for file in random.Random(seed).sample(sorted(left), len(left)):
            if len(running) == jobs:
                running.discard(os.wait()[0])
            child = os.fork()
            if child == 0:
                _serve_file(serve, file, limit, left[file], digests[file], results)
            running.add(child)
        while running:
            running.discard(os.wait()[0])
    return [j for j in judged_before(results) if j.key in wanted]


def digest_of(file: str) -> str:
    """What tells a file from one that was changed."""
    return hashlib.sha256(Path(file).read_bytes()).hexdigest()[:12]


def judged_before(results: Path, since: int = 0) -> list[Judged]:
    """The lines of a file of outcomes, from one on; of a mutant that was judged several times the last."""
    found = {j.key: j for j in (Judged(**json.loads(line)) for line in _lines(results)[since:])}
    return list(found.values())


def _lines(results: Path) -> list[str]:
    return results.read_text(encoding="utf-8").splitlines() if results.exists() else []


Line = tuple[Mutant, tuple[str, str], float]
"""A mutant, what came of it, and the processor time [s]."""


def _refusals(task: FileRun, own: Sequence[Mutant]) -> Iterator[Line]:
    """Those mutants of a file that are refused as they are read."""
    for m in own:
        before = time.process_time()
        if (found := task.refusal(m)) is not None:
            yield m, found, time.process_time() - before


def _judgements(task: FileRun, own: Sequence[Mutant]) -> Iterator[Line]:
    """All mutants of a file."""
    for m in own:
        before = task.seconds + time.process_time()
        found = task.judged(m)
        yield m, found, task.seconds + time.process_time() - before
    task.end()


Serve = Callable[[FileRun, Sequence[Mutant]], Iterator[Line]]
PASSES: tuple[tuple[Serve, tuple[str, ...]], ...] = (
    (_refusals, KINDS),
    (_judgements, tuple(kind for kind in KINDS if kind != "number")),
    (_judgements, ("number",)),
)
"""That a number changes the answer tells least, and comes last."""


def _serve_file(serve: Serve, file: str, limit: float, own: Sequence[Mutant], digest: str, results: Path) -> None:
    """The life of the process of a file."""
    try:
        lines = serve(FileRun(file, limit), own)
        with results.open("a", encoding="utf-8") as out:
            for m, (outcome, detail), seconds in lines:
                line = Judged(m.file, digest, m.kind, m.place, m.what, outcome, detail, round(seconds, 3))
                out.write(json.dumps(asdict(line)) + "\n")
                out.flush()
    finally:
        os._exit(0)


def _import_all() -> None:
    """Children of this process need not import anything."""
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    for module in pkgutil.walk_packages(planar_cli.__path__, "planar_cli."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)


def main() -> None:
    """Run, count, and list the offenders."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kind", action="append", choices=KINDS, help="only these kinds of mutants")
    parser.add_argument("--files", nargs="+", default=["problems"], help="files and folders")
    parser.add_argument("--largest", type=int, default=256_000, help="leave out files of more bytes")
    parser.add_argument("--sample", type=int, help="so many mutants, drawn by the seed")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--limit", type=float, default=20, help="seconds of processor time a mutant")
    parser.add_argument("--results", type=Path, help="a file of outcomes, to which those that lack are added")
    parser.add_argument("--record", type=Path, help="what was told of files before: it is left out, and added to")
    parser.add_argument("--count", action="store_true", help="count what the file of outcomes holds, run nothing")
    wanted = parser.parse_args()
    files = sorted({str(f) for p in map(Path, wanted.files) for f in ([p] if p.is_file() else p.rglob("*.yaml"))})
    files = [file for file in files if Path(file).stat().st_size <= wanted.largest]
    kinds = wanted.kind or KINDS
    record = mutation_record.recorded(wanted.record) if wanted.record else {}
    with tempfile.TemporaryDirectory() as folder:
        results = wanted.results or Path(folder) / "results.jsonl"
        if wanted.count:
            found = [j for j in judged_before(results) if j.kind in kinds]
        else:
            how = {"jobs": wanted.jobs, "limit": wanted.limit, "recorded": record}
            found = run(files, kinds, wanted.sample, wanted.seed, results, **how)
    told(found)
    if wanted.record:
        there = Counter(Part(file, digest_of(file), m.kind) for file in files for m in mutants(file))
        record = mutation_record.extended(record, found, there)
        mutation_record.write(wanted.record, record)
        print(f"{wanted.record}: {sum(c.total() for c in record.values())} of {there.total()} mutants")
        print(mutation_record.totals(record, KINDS))


def told(found: Sequence[Judged]) -> None:
    """The counts by kind, and the offenders."""
    counts = Counter((j.kind, j.outcome) for j in found)
    outcomes = sorted({outcome for _, outcome in counts})
    print(f"{len(found)} mutants of {len({j.file for j in found})} files")
    print("".join(f"{cell:>16}" for cell in ("", *outcomes)))
    for kind in KINDS:
        print("".join(f"{cell!s:>16}" for cell in (kind, *(counts[kind, o] for o in outcomes))))
    for j in found:
        if j.offends:
            print(f"{j.file}:{j.place} {j.kind} {j.outcome} {j.detail}: {j.what}")


if __name__ == "__main__":
    main()
