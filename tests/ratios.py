"""What accuracy costs in time: the figures of README, "What accuracy costs", in one run (install the extra `peers`).

    .venv/bin/python tests/ratios.py [runs]

Whole processes are compared by the processor time that they take (user and system), medians of interleaved runs: what
else the machine does matters little, and ratios mean something on any machine. Each process computes the answer to an
error below the target, with the largest tolerance of the ladder from which on all errors are below it. No test asserts
a time. The reference values have twenty digits and more, by Taylor series with 113 bits; those of the chain of ten
links are from two runs of ours at 1e-15, which differ by 3e-13.
"""

from __future__ import annotations

import math
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path

import pinned

from planar_cli.errors import PlanarError
from planar_cli.motion.regime.regime import Regime
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.structure import load
from planar_cli.simulate.run import Run, Settings, follow, simulate

ROOT = Path(__file__).parent.parent
LADDER = tuple(m * 10.0**-k for k in range(6, 14) for m in (1.0, 0.3))
RUNS = 7
STATES = "states:\n  1: [t = 0, {start}]\n  2: [t = {end} s]\n"

SCIPY = """
import sys
from planar_cli.problem.structure import load
from planar_cli.simulate.run import prepared
import scipy.integrate
file, tolerance, end = sys.argv[1], float(sys.argv[2]), float(sys.argv[3])
scene = prepared(load(file)[0], {})
part = scene.model.regime().reduced(0.0, scene.start.y)
allowed = [tolerance * s for s in part.part(scene.model.scale)]
found = scipy.integrate.solve_ivp(lambda t, y: part.rates(t, y.tolist()), (0.0, end), part.part(scene.start.y),
                                  method="DOP853", rtol=2.3e-14, atol=allowed)
print(repr(found.y[:, -1].tolist()))
"""
"""SciPy's method on the same generated code, nothing else: once, without an estimate of the error."""
KANE = """
import sys, math
import sympy as sp
import sympy.physics.mechanics as me
import scipy.integrate, numpy
n, angle, tolerance, end = int(sys.argv[1]), float(sys.argv[2]), float(sys.argv[3]), float(sys.argv[4])
q, u = me.dynamicsymbols(f"q:{n}"), me.dynamicsymbols(f"u:{n}")
frame, point = me.ReferenceFrame("N"), me.Point("O")
point.set_vel(frame, 0)
bodies, loads = [], []
for i in range(n):
    own = frame.orientnew(f"B{i}", "Axis", (q[i], frame.z))
    own.set_ang_vel(frame, u[i] * frame.z)
    centre, tip = point.locatenew(f"C{i}", -own.y / 2), point.locatenew(f"P{i}", -own.y)
    centre.v2pt_theory(point, frame, own)
    tip.v2pt_theory(point, frame, own)
    bodies.append(me.RigidBody(f"b{i}", centre, own, 1, (me.inertia(own, 0, 0, sp.Rational(1, 12)), centre)))
    loads.append((centre, -sp.Rational(981, 100) * frame.y))
    point = tip
kane = me.KanesMethod(frame, q_ind=q, u_ind=u, kd_eqs=[a.diff() - b for a, b in zip(q, u)])
kane.kanes_equations(bodies, loads)
f = sp.lambdify((*q, *u), [list(kane.mass_matrix), list(kane.forcing)], "math", cse=True)
def rates(t, y):
    mass, force = f(*y.tolist())
    return [*y[n:], *numpy.linalg.solve(numpy.array(mass, float).reshape(n, n), numpy.array(force, float).reshape(n))]
found = scipy.integrate.solve_ivp(rates, (0.0, end), [angle] * n + [0.0] * n, method="DOP853", rtol=2.3e-14,
                                  atol=tolerance)
print(repr(found.y[:, -1].tolist()))
"""


@dataclass(frozen=True)
class Case:
    """A motion whose end is known."""

    name: str
    text: str
    end: float
    """To when it is followed [s]."""
    target: float
    """The error of the answers [rad]."""
    answers: Mapping[str, float]
    """What is true, by find."""
    links: int = 0
    """Of a chain: KanesMethod applies."""
    angle: float = 0.0
    """Of all links at the beginning, from the downward vertical [rad]."""


def hanging(links: int, angle: float, end: float, truth: Sequence[float]) -> str:
    """A chain let go at rest; what is asked are angles from the downward vertical."""
    finds = ", ".join(f"theta_{i}: theta(rod{i}) @ 2 + 90 deg in rad" for i in range(len(truth)))
    rest = STATES.format(start="at rest", end=end) + f"find: {{{finds}}}"
    return pinned.chain(links, angle - math.pi / 2, rest)


def chain_case(name: str, links: int, angle: float, end: float, target: float, truth: Sequence[float]) -> Case:
    """The same as a case."""
    answers = {f"theta_{i}": v for i, v in enumerate(truth)}
    return Case(name, hanging(links, angle, end, truth), end, target, answers, links, angle)


def cases() -> list[Case]:
    """The three motions of the table."""
    squeezer = (ROOT / "problems/hard/andrews-squeezer.yaml").read_text(encoding="utf-8")
    return [
        chain_case("double pendulum", 2, 2.0, 10.0, 1e-6, (1.15669981380890820601716, 16.5027013733208995444428934)),
        chain_case("chain of ten links", 10, 1.2, 5.0, 1e-8, (0.4975565115143, 0.6589197974651, 0.8226078780117)),
        Case("Andrews' squeezer", squeezer, 0.03, 1e-8, {"beta": 15.8724850851680, "gamma": -0.414457579043426}),
    ]


def main(runs: int) -> None:
    """Print all tables."""
    with tempfile.TemporaryDirectory() as folder:
        whole_processes(Path(folder), runs)
        estimates(Path(folder))
        four_bars(Path(folder))
        growing(Path(folder))
        effects(Path(folder))
        stiff(Path(folder))


def problem_of(folder: Path, text: str) -> Problem:
    """A problem from its text."""
    path = folder / "scene.yaml"
    path.write_text(text, encoding="utf-8")
    problem, wrong, _ = load(str(path))
    assert problem is not None, wrong
    return problem


# --- whole processes --------------------------------------------------------------------------------------------------


def whole_processes(folder: Path, runs: int) -> None:
    """From the file to the answers with an error below the target."""
    peers = find_spec("scipy") is not None
    commands: dict[tuple[str, str], list[str]] = {}
    for case in cases():
        file = folder / f"{case.links}.yaml"
        file.write_text(case.text, encoding="utf-8")
        simulated = [sys.executable, "-m", "planar_cli", "simulate", str(file), "--tolerance"]
        commands[case.name, "planar"] = [*simulated, repr(reaching(case, folder, "auto"))]
        if peers:
            same = reaching(case, folder, "scipy_dop853")
            commands[case.name, "same by SciPy"] = [*simulated, repr(same), "--integrator", "scipy_dop853"]
            commands[case.name, "SciPy alone"] = [sys.executable, "-c", SCIPY, str(file), repr(same), repr(case.end)]
        if peers and case.links:
            chain = [str(case.links), repr(case.angle), repr(same), repr(case.end)]
            commands[case.name, "Kane and SciPy"] = [sys.executable, "-c", KANE, *chain]
    times: dict[tuple[str, str], list[float]] = {key: [] for key in commands}
    bare = []
    for k in range(runs + 1):
        # One run of each in turn; the first one fills caches.
        bare.append(processor([sys.executable, "-c", "pass"]))
        for key, command in commands.items():
            taken = processor(command)
            if k:
                times[key].append(taken)
    print(f"Whole processes, s of processor time ({runs} runs; python -c pass: {statistics.median(bare):.3f})\n")
    for case in cases():
        own = statistics.median(times[case.name, "planar"])
        tolerance = commands[case.name, "planar"][-1]
        print(f"  {case.name}, error below {case.target:g}: {own:.3f} (tolerance {float(tolerance):g})")
        for (name, kind), taken in times.items():
            if name == case.name and kind != "planar":
                other = statistics.median(taken)
                print(f"    {kind:<16}{other:8.3f}   ratio {own / other:.2f}")
    print()


def processor(command: Sequence[str]) -> float:
    """User and system time of a whole process, its output thrown away [s]."""
    # As an installed program runs: modules are compiled once.
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, cwd=ROOT, env=environment, stdout=subprocess.DEVNULL, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def reaching(case: Case, folder: Path, integrator: str) -> float:
    """The largest tolerance from which on all errors are below the target."""
    problem, best = problem_of(folder, case.text), LADDER[-1]
    for tolerance in reversed(LADDER):
        if errors(problem, case, tolerance, integrator)[0] > case.target:
            break
        best = tolerance
    return best


def errors(problem: Problem, case: Case, tolerance: float, integrator: str = "auto") -> tuple[float, float]:
    """The largest true error of an answer, and the largest estimated one; without an estimate for others' methods."""
    own = integrator == "auto"
    found = simulate(problem, Settings(tolerance=tolerance, integrator=integrator, estimate=own))
    true = max(abs(a.values[0] - case.answers[a.name]) for a in found.answers)
    return true, max(a.error or 0.0 for a in found.answers)


# --- errors -----------------------------------------------------------------------------------------------------------


def estimates(folder: Path) -> None:
    """Estimated errors beside the true ones."""
    print("Estimated errors in parts of the true ones\n")
    for case in cases():
        problem, parts, least = problem_of(folder, case.text), [], math.inf
        for tolerance in LADDER:
            true, told = errors(problem, case, tolerance)
            least = min(least, true)
            # Where the reference has no more digits nothing can be compared.
            if true > 3e-13 * max(1.0, *map(abs, case.answers.values())):
                parts.append(told / true)
        print(f"  {case.name:<20} from {min(parts):.2f} to {max(parts):.2f}; least true error {least:.1e} rad")
    print()


FOUR_BARS = {2: 31.7505971869861018170813, 10: 31.6217298227818726150515, 40: 31.5974337439857377198724}
"""The angle of the cranks after 10 s [rad]."""


def four_bars(folder: Path) -> None:
    """Linkages through their singular positions for ten seconds."""
    print("Four-bars in a row for 10 s\n")
    print(
        "  number  tolerance  angle error [rad]  energy drift [J]  joints, at steps / inside them  processor time [s]"
    )
    for number, truth in FOUR_BARS.items():
        rest = STATES.format(start="v(B0).x = 1 m/s", end=10) + "find: {phi: -theta(crank0) @ 2 + 90 deg in rad}"
        problem = problem_of(folder, pinned.four_bars(number, rest))
        for tolerance in (1e-6, 1e-10):
            began = time.process_time()
            try:
                run = follow(problem, Settings(tolerance=tolerance))
            except PlanarError as refused:
                print(f"  {number:>6}  {tolerance:9.0e}  refused: {refused}")
                continue
            taken = time.process_time() - began
            layout = run.model.layout
            theta = layout.frames["crank0"].theta
            assert theta is not None
            angle = math.pi / 2 - run.trajectory.at(10.0)[theta]
            energy, ends, inside = drifts(run)
            off = abs(angle - truth)
            words = run.trajectory.outcome.words if run.trajectory.outcome.refused else ""
            joints = f"{ends:17.1e}{inside:9.1e}"
            print(
                f"  {number:>6}  {tolerance:9.0e}  {off:11.1e}  {energy:9.1e}{joints}  {taken:18.2f}  {words}".rstrip()
            )
    print()


def drifts(run: Run) -> tuple[float, float, float]:
    """By how much the energy changes at most [J]; the largest residual of a joint where steps end, and inside them."""
    energy, ends, inside = 0.0, 0.0, 0.0
    first: float | None = None
    for segment in run.trajectory.segments:
        regime = segment.regime
        assert isinstance(regime, Regime)
        for step in segment.steps:
            now = regime.energy(step.t1, step.y1)
            first = regime.energy(step.t0, step.y0) if first is None else first
            energy = max(energy, abs(now - first))
            ends = max([ends, *map(abs, regime.residuals(step.t1, step.y1))])
            for k in (1, 2, 3):
                t = step.t0 + k / 4 * (step.t1 - step.t0)
                inside = max([inside, *map(abs, regime.residuals(t, segment.at(t)))])
    return energy, ends, inside


# --- cost of an evaluation --------------------------------------------------------------------------------------------


def growing(folder: Path) -> None:
    """Operations and time of one evaluation with the number of bodies."""
    print("One evaluation: bodies, operations and microseconds for each body\n")
    for name, made, numbers in (
        ("chain", lambda n: pinned.chain(n, -0.3), (5, 10, 20, 40, 80)),
        ("four-bars", pinned.four_bars, (2, 5, 10, 20, 40)),
    ):
        for number in numbers:
            run = follow(problem_of(folder, made(number)), Settings(until=1e-3, tolerance=1e-3))
            bodies, operations, cost = len(run.problem.bodies), *evaluation(run)
            print(f"  {name:<10}{bodies:4}{operations / bodies:8.1f}{cost / bodies:8.2f}")
    print()


def evaluation(run: Run) -> tuple[int, float]:
    """Operations and time [µs] of the rates at the beginning."""
    segment = run.trajectory.segments[0]
    regime = segment.regime
    assert isinstance(regime, Regime)
    t, y = segment.t0, list(segment.start)
    part = regime.reduced(t, y)
    rates, z = (regime.rates, y) if part is None else (part.rates, part.part(y))
    return regime.operations, 1e6 * min(_seconds(lambda: rates(t, z)) for _ in range(5))


def _seconds(call: Callable[[], object]) -> float:
    began, number = time.process_time(), 300
    for _ in range(number):
        call()
    return (time.process_time() - began) / number


BLOCK = """plane: vertical
points: {{O: [0, 0], P: [2 m, 1 m], Q: [0, 1 m]}}
bodies: {{block: {{particle: P, mass: 2 kg}}}}
surfaces: {{floor: {{through: Q, angle: 0 deg}}}}
joints:
  - {joint}
{loads}instant: [v(P).x = 3 m/s]
"""


def effects(folder: Path) -> None:
    """What single effects cost on a block that slides."""
    guide = "guide: {point: P, along: 0 deg}"
    scenes = {
        "a block on a rail": (guide, ""),
        "with a spring": (guide, "spring: {between: [O, P], stiffness: 10 N/m, natural_length: 1 m}"),
        "with a drag": (guide, "drag: {body: block, magnitude: (0.1 kg/m)*v(P).mag^2}"),
        "with friction": ("guide: {point: P, along: 0 deg, mu: 0.1}", ""),
        "on a smooth floor instead": ("contact: {at: P, between: [block, floor], mu: 0}", ""),
    }
    print("What effects cost: operations and microseconds of an evaluation, things watched\n")
    for name, (joint, pull) in scenes.items():
        text = BLOCK.format(joint=joint, loads=f"loads:\n  - {pull}\n" if pull else "")
        run = follow(problem_of(folder, text), Settings(until=1e-3, tolerance=1e-3))
        operations, cost = evaluation(run)
        watched = len(run.trajectory.segments[0].regime.guards)
        print(f"  {name:<30}{operations:6}{cost:8.2f}{watched:4}")
    print()


def stiff(folder: Path) -> None:
    """The time of a block on a spring, a thousand times as stiff and more."""
    text = (ROOT / "problems/hard/stiff-spring.yaml").read_text(encoding="utf-8").partition("note:")[0]
    text = text.replace("t = 0.01 s", "t = 1 s")
    print("Block on a spring for 1 s: stiffness [N/m], processor time [s]\n")
    for k in ("1e2", "1e4", "1e6", "1e8", "1e10"):
        problem = problem_of(folder, text.replace("k: 1e10", f"k: {k}"))
        taken = min(timed(problem) for _ in range(3))
        print(f"  {k:>6}{taken:10.4f}")
    print()


def timed(problem: Problem) -> float:
    """The processor time of one following [s]."""
    began = time.process_time()
    follow(problem, Settings(tolerance=1e-6))
    return time.process_time() - began


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else RUNS)
