"""Whole-process times as ratios: what planar adds to the interpreter and to SymPy.

    .venv/bin/python tests/timing.py [runs]

The motions are the same generated code, followed by our DOP853 and by SciPy's (install the extra `peers`).

Prints the smallest of several runs of each command and the ratios of one with the other. Ratios of times taken side by
side mean something on any machine; seconds do not, so no test asserts either.
"""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).parent.parent
PROBLEM = "problems/textbook/ex-4-05.yaml"
DOUBLE, SQUEEZER = "problems/hard/double-pendulum-let-go-level.yaml", "problems/hard/andrews-squeezer.yaml"
PLANAR = (sys.executable, "-m", "planar_cli")
COMMANDS = {
    "python -c pass": (sys.executable, "-c", "pass"),
    "planar --help": (*PLANAR, "--help"),
    "planar validate": (*PLANAR, "validate", PROBLEM),
    "python -c 'import sympy'": (sys.executable, "-c", "import sympy"),
    "planar solve": (*PLANAR, "solve", PROBLEM),
    "simulate, two rods": (*PLANAR, "simulate", DOUBLE),
    "the same by SciPy": (*PLANAR, "simulate", DOUBLE, "--integrator", "scipy_dop853"),
    "simulate, squeezer": (*PLANAR, "simulate", SQUEEZER),
    "that one by SciPy": (*PLANAR, "simulate", SQUEEZER, "--integrator", "scipy_dop853"),
}
RATIOS = (
    ("planar --help", "python -c pass"),
    ("planar validate", "python -c pass"),
    ("planar solve", "python -c 'import sympy'"),
    ("simulate, two rods", "the same by SciPy"),
    ("simulate, squeezer", "that one by SciPy"),
)
RUNS = 7


def seconds(command: tuple[str, ...]) -> float:
    """One run of the whole process, its output thrown away."""
    started = time.perf_counter()
    subprocess.run(command, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    return time.perf_counter() - started


def main(runs: int) -> None:
    best = dict.fromkeys(COMMANDS, float("inf"))
    # One run of each in turn, so that a slow spell of the machine falls on all alike.
    for _ in range(runs):
        for name, command in COMMANDS.items():
            best[name] = min(best[name], seconds(command))
    for name, time_taken in best.items():
        print(f"{name:<28}{time_taken:8.3f} s")
    print()
    for above, below in RATIOS:
        print(f"{above + ' / ' + below:<44}{best[above] / best[below]:6.2f}")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else RUNS)
