"""`planar solve` beside an earlier state of this repository, as ratios in one run.

    git worktree add ../earlier COMMIT && (cd ../earlier && python3 -m venv .venv && .venv/bin/pip install -q .)
    .venv/bin/python tests/earlier.py ../earlier [runs]

About forty problem files of all folders that have not changed since, three of each folder, those spread evenly over it.
Whole processes are compared by the processor time that they take (user and system), the least of several interleaved
runs: what else the machine does matters little. No test asserts a time.
"""

from __future__ import annotations

import os
import resource
import statistics
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

ROOT = Path(__file__).parent.parent
OF_EACH_FOLDER = 3
RUNS = 5


def main(earlier: Path, runs: int) -> None:
    """Print the ratio for each file, their median and that of the sums."""
    files = [f for f in unchanged(earlier) if all(solves(root, f) for root in (earlier, ROOT))]
    best = dict.fromkeys(((root, file) for root in (earlier, ROOT) for file in files), float("inf"))
    for _ in range(runs):
        for file in files:
            for root in (earlier, ROOT):
                best[root, file] = min(best[root, file], processor(root, file))
    ratios = {file: best[ROOT, file] / best[earlier, file] for file in files}
    for file in sorted(files, key=lambda f: ratios[f]):
        print(f"{ratios[file]:6.2f}  {best[earlier, file]:6.3f} s before, {best[ROOT, file]:6.3f} s now  {file}")
    before, now = (sum(best[root, file] for file in files) for root in (earlier, ROOT))
    print(f"\n{len(files)} files: median {statistics.median(ratios.values()):.2f}, sum {now / before:.2f}")


def unchanged(earlier: Path) -> list[str]:
    """Files of problems/ that read the same in both."""
    chosen: list[str] = []
    for folder in sorted(p for p in (ROOT / "problems").iterdir() if p.is_dir()):
        names = [str(p.relative_to(ROOT)) for p in sorted(folder.glob("*.yaml")) if same(p, earlier)]
        step = max(1, len(names) // OF_EACH_FOLDER)
        chosen += names[::step][:OF_EACH_FOLDER]
    return chosen


def same(path: Path, earlier: Path) -> bool:
    other = earlier / path.relative_to(ROOT)
    return other.exists() and other.read_bytes() == path.read_bytes()


def solves(root: Path, file: str) -> bool:
    """Whether that state solves the file; its modules are compiled on the way."""
    return run(root, file).returncode == 0


def processor(root: Path, file: str) -> float:
    """User and system time of one solution [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run(root, file)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def run(root: Path, file: str) -> subprocess.CompletedProcess[bytes]:
    # As an installed program runs: modules are compiled once.
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    command: Sequence[str] = (str(root / ".venv/bin/python"), "-m", "planar_cli", "solve", file)
    return subprocess.run(command, cwd=root, env=environment, capture_output=True, check=False)


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve(), int(sys.argv[2]) if len(sys.argv) > 2 else RUNS)
