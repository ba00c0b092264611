"""Ten thousand files, one in a hundred hostile: right verdicts, level memory, nothing lost and nothing twice."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

import pytest
from graders import grader
from test_batches_here import workers

from planar_cli.homework.submissions.batches import grade_files
from planar_cli.homework.submissions.grader import Grading

NUMBER = 10_000
ENDED = {"hang": "timeout", "power": "timeout", "eat": "memory", "exit": "crashed", "raise": "crashed"}
UNREAD = {
    "deep": "[" * 50_000,
    "long": "x" * 300_000,
    "alias": "a: &a [x]\nb: [*a]\n",
    "nul": "answers: {p.a: \x00}",
    "twice": "answers: {p.a: 1, p.a: 2}",
}
RUN = """
import resource, sys
from graders import grader
from planar_cli.homework.submissions.batches import grade_files
from planar_cli.homework.submissions.grader import Grading
if __name__ == "__main__":
    sizes = []
    def take(line):
        if not len(sizes) or line.student.endswith("00"):
            sizes.append(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
    ran = grade_files([sys.argv[1]], Grading(grader, "key", 5.0), 2, sys.argv[2], take=take)
    print(ran.graded, ran.skipped, sizes[len(sizes) // 10], sizes[-1], flush=True)
"""


def hand_in(folder: Path) -> dict[str, str]:
    """The files; what kind each is."""
    folder.mkdir()
    hostile = [*ENDED, *UNREAD]
    kinds = {}
    for i in range(NUMBER):
        kind = hostile[i // 100 % len(hostile)] if i % 100 == 50 else ("5 N" if i % 3 else "6 N")
        kinds[f"s{i:05}"] = kind
        text = UNREAD.get(kind) or "answers:\n  p:\n" + "".join(f"    {x}: {kind}\n" for x in "abcdef")
        (folder / f"s{i:05}.yaml").write_text(text)
    return kinds


@pytest.mark.slow
def test_ten_thousand_files(tmp_path: Path) -> None:
    kinds = hand_in(tmp_path / "in")
    (tmp_path / "run.py").write_text(RUN)
    file = tmp_path / "r"
    environment = {**os.environ, "MARKER": tmp_path.name, "PYTHONPATH": str(Path(__file__).parent)}
    command = [sys.executable, str(tmp_path / "run.py"), str(tmp_path / "in"), str(file)]
    done = 0
    for _ in range(2):
        # Killed in the middle, twice: as hard as can be.
        with subprocess.Popen(command, env=environment, stdout=-1, text=True) as process:
            begun = done
            while process.poll() is None and done < begun + NUMBER // 4:
                time.sleep(0.1)
                done = file.read_bytes().count(b"\n") if file.exists() else 0
            process.send_signal(signal.SIGKILL)
        for _ in range(100):
            if not workers(tmp_path.name):
                break
            time.sleep(0.1)
        assert workers(tmp_path.name) == []
        done = file.read_bytes().count(b"\n")
    with subprocess.Popen(command, env=environment, stdout=-1, text=True) as process:
        out, _ = process.communicate()
    graded, skipped, early, late = map(int, out.split())
    print(f"\n{skipped} done when it was killed, {graded} afterwards; {early} kB, in the end {late} kB")
    assert (graded + skipped, skipped) == (NUMBER, done)
    assert late < early + 10_000
    lines = [json.loads(text) for text in file.read_text().splitlines()]
    assert Counter(line["result"]["student"] for line in lines) == Counter(list(kinds))
    for line in lines:
        kind = kinds[line["result"]["student"]]
        assert line["ended"] == ENDED.get(kind, "ok"), line
        verdicts = {g["verdict"] for g in line["result"]["graded"]}
        assert verdicts == {{"5 N": "right", "6 N": "wrong"}.get(kind, "ungradable")}, line
        assert bool(line["result"]["wrong"]) is (kind not in ("5 N", "6 N"))
    assert grade_files([str(tmp_path / "in")], Grading(grader, "key"), 1, str(file)).skipped == NUMBER
