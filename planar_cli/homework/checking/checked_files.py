"""Many problem files checked: on all cores, with what came of each as it comes, taken up again where a run was ended.

A worker that dies over a file costs nobody else theirs; that file is tried once more, by another worker.
"""

from __future__ import annotations

import contextlib
import hashlib
from collections.abc import Callable, Generator, Mapping, Sequence
from dataclasses import fields, replace
from decimal import Decimal
from typing import Any

from planar_cli import __version__
from planar_cli.errors import PlanarError
from planar_cli.homework.checking.checking import AGREES, DISAGREES, FAULT, UNDECIDED, Checked, check_file
from planar_cli.homework.checking.verdict import Verdict
from planar_cli.homework.tasks.interrupts import number_of, terminated
from planar_cli.homework.tasks.results import Line, ResultsFile, line_with, lines_of
from planar_cli.homework.tasks.supervisor import Heard, Supervisor
from planar_cli.problem.nodes.nodes import regular_bytes
from planar_cli.problem.nodes.show import visible
from planar_cli.records import record

KEPT = (AGREES, DISAGREES)
"""What is taken up from an earlier run; what went wrong with another file is told anew."""
KEY = f"planar {__version__}"
"""What an earlier version made of a file is no result of this one."""


@record
class _Item:
    """A file in its place, and whether a worker has died over it."""

    number: int
    path: str
    again: bool = False


def check_files(
    paths: Sequence[str],
    jobs: int,
    timeout: float,
    hear: Callable[[Checked], None],
    told: Callable[[int], None],
    results: str | None = None,
) -> int:
    """Check all files, each within `timeout` seconds (0: none); the number of the signal that ended that early, else 0.

    `hear` gets what came of each in the order of the files, as soon as all before it are known; `told`, how many are.
    `results`: a file of JSON lines that is added to; what stands there, of the same content, is not solved again.
    Raises PlanarError for a results file that is none.
    """
    written = ResultsFile(results) if results is not None else None
    held: dict[int, Checked] = {}
    heard = 0

    def let_go() -> None:
        nonlocal heard
        while heard in held:
            hear(held.pop(heard))
            heard += 1

    try:
        digests = {path: _digest(path) for path in paths} if written is not None else {}
        before = _done_before(results, digests) if results is not None else {}
        held = {i: before[path] for i, path in enumerate(paths) if path in before}
        items = [_Item(i, path) for i, path in enumerate(paths) if i not in held]
        with terminated(), contextlib.closing(_as_they_end(items, jobs, timeout)) as ended:
            let_go()
            for number, checked in ended:
                # Before it is kept: what an interrupt finds in the results file is printed too.
                held[number] = checked
                if written is not None:
                    written.write(_line(checked, digests[checked.path]))
                let_go()
                told(heard + len(held))
    except KeyboardInterrupt as stop:
        for number in sorted(held):
            hear(held[number])
        return number_of(stop)
    finally:
        if written is not None:
            written.close()
    return 0


def _as_they_end(items: Sequence[_Item], jobs: int, timeout: float) -> Generator[tuple[int, Checked], None, None]:
    supervisor = Supervisor(_check, jobs, timeout)
    try:
        for heard in supervisor.stream(items):
            item: _Item = heard.item
            if heard.verdict == "crashed" and not item.again:
                supervisor.again(replace(item, again=True))
            else:
                yield item.number, _checked(item.path, heard)
    finally:
        supervisor.close()


def _check(item: _Item) -> Checked:
    return check_file(item.path)


def _checked(path: str, heard: Heard) -> Checked:
    if isinstance(heard.result, Checked):
        return replace(heard.result, seconds=heard.seconds)
    outcome = FAULT if heard.verdict in ("fault", "crashed") else UNDECIDED
    more = "; `planar solve` tells what it was working on" if heard.verdict == "timeout" else ""
    return Checked(path, "", outcome, (), f"{heard.result}{more}", (), heard.seconds)


# --- results that are kept -------------------------------------------------------------------------------------------


def _digest(path: str) -> str:
    """Of the content; of what cannot be read, empty: checking tells why."""
    try:
        return hashlib.sha256(regular_bytes(path)).hexdigest()
    except (OSError, ValueError):
        return ""


def _line(one: Checked, digest: str) -> Line:
    """What came of a file as a line of a results file: of one part, and of no student."""
    found = {
        "student": "",
        "problem": one.title,
        "outcome": one.outcome,
        "verdicts": [_as_data(v) for v in one.verdicts],
        "message": one.message,
        "seconds": round(one.seconds, 3),
    }
    return line_with({"result": found}, one.path, (0, 1), (digest, KEY))


def _as_data(verdict: Verdict) -> dict[str, Any]:
    found: dict[str, Any] = {f.name: getattr(verdict, f.name) for f in fields(Verdict)}
    return found | {"error": None if verdict.error is None else str(verdict.error)}


def _done_before(name: str, digests: Mapping[str, str]) -> dict[str, Checked]:
    """By file what an earlier run of this version has found of the same content."""
    found: dict[str, Checked] = {}
    for line in lines_of(name):
        path, result = line["file"], line["result"]
        if "outcome" not in result:
            raise PlanarError(f"{visible(name)} has results of submissions, not of problem files")
        found.pop(path, None)
        if (line["key"], line["content"]) == (KEY, digests.get(path)) and result["outcome"] in KEPT:
            verdicts = tuple(_verdict(v) for v in result["verdicts"])
            found[path] = Checked(path, result["problem"], result["outcome"], verdicts, seconds=result["seconds"])
    return found


def _verdict(data: Mapping[str, Any]) -> Verdict:
    error = data["error"]
    return Verdict(**{**data, "error": None if error is None else Decimal(error)})
