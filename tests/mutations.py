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

A file is worked out once, in a process of its own. Most mutants are refused as they are read, there; each of the others
is worked out in a child of that process, which remembers what it knows of the file and has a limit of processor time.
The page is written where the answers are the same. With `--results` each outcome is added to a file at once (a line of
JSON); a run that was broken off goes on from there, and judges the offenders among them anew.
"""

from __future__ import annotations

import argparse
import gc
import hashlib
import importlib
import json
import os
import pickle
import pkgutil
import random
import resource
import select
import signal
import tempfile
import time
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path

from mutants import KINDS, Mutant, mutants, mutated

import planar_cli
from planar_cli.errors import Diagnostic, FileProblem, NoSolution, Undecided
from planar_cli.homework.checking import solve_and_compare
from planar_cli.problem import nodes
from planar_cli.problem.checks import check
from planar_cli.problem.reading import Report
from planar_cli.problem.scene import Problem
from planar_cli.problem.structure import read_problem
from planar_cli.registry import members
from planar_cli.report.json_document import solution_data
from planar_cli.report.narrate import Voice, narrate
from planar_cli.solve.where_asked import has_place

GROUPS = {"statement": 0, "number": 0, "sign": 0, "name": 1, "unit": 2, "key": 2}
"""Those of which most is learnt come first."""
SOLVED, UNCHANGED, FAULT, UNDECIDED = "solved", "unchanged", "fault", "undecided"
WAITING = 20
"""A child that gets little of the processor has so many times its limit."""
MEMORY = 2 * 1024**3


@dataclass(frozen=True, slots=True)
class Outcome:
    """What came of a file or mutant. `answers`: to all digits, by name; `page`: all that is told."""

    kind: str
    detail: str = ""
    answers: str = ""
    page: str = ""


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


# --- one mutant -------------------------------------------------------------------------------------------------------


def read(file: str, root: nodes.Node, mutant: Mutant | None) -> Problem | Outcome:
    """The problem of a file as it stands, or with one change; or the refusal."""
    tree = root if mutant is None else mutated(root, mutant.at, mutant)
    assert tree is not None
    report = Report()
    problem = read_problem(file, tree, report)
    for diagnostic in check(problem):
        report.take(diagnostic)
    found = report.sorted()
    return _failed("refused", found) if found else problem


def _failed(kind: str, diagnostics: Sequence[Diagnostic]) -> Outcome:
    place = "" if diagnostics and diagnostics[0].mark.line else "no place: "
    return Outcome(kind, place + ", ".join(sorted({d.code for d in diagnostics})))


def solved(problem: Problem, other_than: str | None = None) -> Outcome:
    """A problem worked out; its page only where the answers are not `other_than` these."""
    try:
        solution, verdicts = solve_and_compare(problem)
    except (FileProblem, NoSolution) as error:
        return _failed("refused" if isinstance(error, FileProblem) else "no solution", error.diagnostics)
    except Undecided as error:
        return Outcome(UNDECIDED, ("" if has_place(error, problem.file) else "no place: ") + str(error))
    answers = json.dumps(solution_data(solution, verdicts, 12, None)["answers"], default=str, sort_keys=True)
    if other_than is not None and answers != other_than:
        return Outcome(SOLVED, "", answers)
    page = members("formats")["markdown"]().render(narrate(solution, Voice(12)))
    return Outcome(SOLVED, "", answers, page)


def judged(mutant: Mutant, base: Outcome, outcome: Outcome) -> tuple[str, str]:
    """The outcome of a mutant in a word or two, and what more there is to say."""
    if outcome.kind != SOLVED:
        return outcome.kind, outcome.detail
    if outcome.answers != base.answers:
        return "another answer", ""
    if outcome.page != base.page:
        return "told", ""
    return mutant.reason or UNCHANGED, ""


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
        try:
            problem = read(self.file, self.root, mutant)
        except Exception as error:
            return FAULT, f"{type(error).__name__}: {error}"
        if isinstance(problem, Outcome):
            return judged(mutant, problem, problem)
        if self.base.kind != SOLVED:
            return UNDECIDED, f"the file itself: {self.base.kind} {self.base.detail}"
        return self._in_a_child(mutant, problem)

    @property
    def base(self) -> Outcome:
        """The file itself, worked out as soon as a mutant is not refused; its children remember all of it."""
        if self._base is None:
            problem = read(self.file, self.root, None)
            self._base = problem if isinstance(problem, Outcome) else solved(problem)
            gc.collect()
            gc.freeze()
        return self._base

    def _in_a_child(self, mutant: Mutant, problem: Problem) -> tuple[str, str]:
        ours, theirs = os.pipe()
        child = os.fork()
        if child == 0:
            os.close(ours)
            _serve(theirs, problem, mutant, self.base, self.limit)
        os.close(theirs)
        told = b""
        end = time.monotonic() + WAITING * self.limit
        while select.select([ours], [], [], max(0.0, end - time.monotonic()))[0]:
            part = os.read(ours, 1 << 16)
            if not part:
                break
            told += part
        else:
            os.kill(child, signal.SIGKILL)
        os.close(ours)
        _, status, used = os.wait4(child, 0)
        self.seconds += used.ru_utime + used.ru_stime
        if told and not status:
            outcome: tuple[str, str] = pickle.loads(told)
            return outcome
        if os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGXCPU, signal.SIGKILL):
            return UNDECIDED, f"not decided within {self.limit:g} s"
        return FAULT, f"the process ended with status {status}"


def _serve(pipe: int, problem: Problem, mutant: Mutant, base: Outcome, limit: float) -> None:
    """The life of a child: one mutant, within its limits."""
    status = 1
    try:
        _, most = resource.getrlimit(resource.RLIMIT_AS)
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY if most == resource.RLIM_INFINITY else min(MEMORY, most), most))
        resource.setrlimit(resource.RLIMIT_CPU, (max(1, round(limit)), resource.RLIM_INFINITY))
        try:
            found = judged(mutant, base, solved(problem, base.answers))
        except MemoryError:
            found = UNDECIDED, "more than 2 GB of memory"
        except Exception as error:
            found = FAULT, f"{type(error).__name__}: {error}"
        os.write(pipe, pickle.dumps((found[0], found[1][:4000])))
        status = 0
    finally:
        os._exit(status)


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
) -> list[Judged]:
    """Every mutant of a sample with its outcome. `results`: the file of outcomes, to which those that lack go."""
    known = [m for file in files for m in mutants(file) if m.kind in kinds]
    if sample is not None and sample < len(known):
        known = sorted(random.Random(seed).sample(known, sample), key=known.index)
    digests = {file: hashlib.sha256(Path(file).read_bytes()).hexdigest()[:12] for file in files}
    wanted = {(m.file, digests[m.file], m.kind, m.place, m.what): m for m in known}
    done = {j.key for j in judged_before(results) if not j.offends}
    left = [m for key, m in wanted.items() if key not in done]
    _import_all()
    running: set[int] = set()
    for own in _tasks(left):
        if len(running) == jobs:
            running.discard(os.wait()[0])
        child = os.fork()
        if child == 0:
            _serve_file(own, digests[own[0].file], limit, results)
        running.add(child)
    while running:
        running.discard(os.wait()[0])
    return [j for j in judged_before(results) if j.key in wanted]


def judged_before(results: Path) -> list[Judged]:
    """The lines of a file of outcomes; of a mutant that was judged several times the last."""
    lines = results.read_text(encoding="utf-8").splitlines() if results.exists() else []
    found = {j.key: j for j in (Judged(**json.loads(line)) for line in lines)}
    return list(found.values())


def _tasks(left: Iterable[Mutant]) -> Iterator[list[Mutant]]:
    """The mutants of one file and one kind after the other."""
    groups: dict[tuple[int, str], list[Mutant]] = {}
    for m in left:
        groups.setdefault((GROUPS[m.kind], m.file), []).append(m)
    yield from (groups[key] for key in sorted(groups))


def _serve_file(own: Sequence[Mutant], digest: str, limit: float, results: Path) -> None:
    """The life of the process of a file."""
    try:
        task = FileRun(own[0].file, limit)
        with results.open("a", encoding="utf-8") as out:
            for m in own:
                before = task.seconds + time.process_time()
                outcome, detail = task.judged(m)
                seconds = round(task.seconds + time.process_time() - before, 3)
                line = Judged(m.file, digest, m.kind, m.place, m.what, outcome, detail, seconds)
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
    parser.add_argument("--count", action="store_true", help="count what the file of outcomes holds, run nothing")
    wanted = parser.parse_args()
    files = sorted({str(f) for p in map(Path, wanted.files) for f in ([p] if p.is_file() else p.rglob("*.yaml"))})
    files = [file for file in files if Path(file).stat().st_size <= wanted.largest]
    kinds = wanted.kind or KINDS
    with tempfile.TemporaryDirectory() as folder:
        results = wanted.results or Path(folder) / "results.jsonl"
        if wanted.count:
            found = [j for j in judged_before(results) if j.kind in kinds]
        else:
            found = run(files, kinds, wanted.sample, wanted.seed, results, jobs=wanted.jobs, limit=wanted.limit)
    told(found)


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
