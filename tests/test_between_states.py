"""Laws between states: work and kinetic energy, impulse and momentum; which of them leads to what is asked."""

from __future__ import annotations

import json
from decimal import Decimal
from math import pi, sqrt
from pathlib import Path
from typing import Any

import pytest
from answered import Answers, assert_close, first, solve
from conftest import PROBLEMS
from test_problems import equations_text
from worked import assert_golden, name_of, worked

from planar_cli import cli
from planar_cli.errors import FileProblem
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import Voice, narrate
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import PartSolution

G = 9.81


def example(number: str) -> Path:
    """A worked example of the textbook."""
    return next(p for p in PROBLEMS if p.stem == f"ex-{number}")


def told(path: Path) -> str:
    """A printed solution, its spaces made equal."""
    return " ".join(Terminal().render(narrate(worked(path)[0], Voice(verbose=True))).split())


def part_of(text: str, method: str | None = None) -> PartSolution:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    return solve_problem(problem, method).parts[0]


def answers(text: str, method: str | None = None) -> Answers:
    return {f.name: f for f in part_of(text, method).found}


def laws_used(part: PartSolution) -> set[str]:
    """The kinds of law on the way that is told, data and geometry left out."""
    kinds = {e.kind for step in part.motion.route.steps for e in step.relations}
    return kinds & {"energy", "momentum", "blow", "v(t)", "v(q)", "q(t)", "t(v)", "q(v)", "t(q)"}


# --- the textbook ----------------------------------------------------------------------------------------------------

# What the book finds, or where it errs what two principles find (see the notes of the files), in SI units.
BOOK = [
    ("4-08", "omega", -sqrt(2 * 100 * 0.75 * 2 / 0.45 / (50 * (0.45**2 + 0.2**2)))),
    ("4-09", "F", 1728.902),
    ("4-09", "tension_A", 40 * (G + 0.4**2 / 1.2)),
    ("4-10", "omega", 8.52139),
    ("4-11", "x_max", 4 * G / 250),
    ("4-12", "omega", -10 * 25 * 0.75 / (50 * (0.45**2 + 0.2**2))),
    ("4-13", "omega_1", 45 / 16),
    ("4-13", "phi_max", 62.45516 * pi / 180),
    ("4-14", "v_G", 1.875),
    ("4-14", "omega", -4.6875),
    ("4-14", "e", 0.875),
    ("4-17", "omega", -1.214688),
    ("4-18", "v", 100 * 0.35 / (75 * 0.35**2 + 0.4)),
]
LAWS = [
    ("4-08", {"energy"}),
    ("4-11", {"energy"}),
    ("4-12", {"momentum"}),
    ("4-13", {"blow", "energy"}),
    ("4-14", {"blow"}),
    ("4-17", {"energy"}),
    ("4-18", {"momentum"}),
]
SAID = [
    ("4-08", "From 1 to 2, work and kinetic energy"),
    ("4-08", "U of the pull = P (R + r) θ_2"),
    ("4-08", "T_1 + U = T_2: P (R + r) θ_2 = 1/2 m (R² + k_G²) ω_2²"),
    ("4-11", "U of the spring AD"),
    ("4-11", "At 2, y_D is smallest"),
    ("4-12", "angular impulse and momentum about C"),
    ("4-13", "momentum before + impulses = momentum after"),
    ("4-13", "↺ H_A: J AS = I_A ω_2"),
    ("4-13", "T_2 + U = T_3: m g AG (cos φ_max - 1) + 1/2 I_A ω_2² = 0"),
    ("4-13", "in numbers: 117.7 cos φ_max - 54.44 = 0"),
    ("4-17", "let go by itself it does not reach state 2; the balance of energy relates the two states all the same"),
    ("4-18", "From 1 to 2, rear: angular impulse and momentum about O_A"),
    ("4-18", "From 1 to 2, frame, rear, front: impulse and momentum"),
]


@pytest.mark.parametrize(("number", "find", "value"), BOOK)
def test_numbers_of_the_book(number: str, find: str, value: float) -> None:
    solution, _ = worked(example(number))
    found = next(f for part in solution.parts for f in part.found if f.name == find)
    assert first(found) == pytest.approx(value, rel=2e-6)


@pytest.mark.parametrize(("number", "laws"), LAWS)
def test_laws_of_the_book(number: str, laws: set[str]) -> None:
    assert laws_used(worked(example(number))[0].parts[0]) == laws


@pytest.mark.parametrize(("number", "words"), SAID)
def test_what_is_told(number: str, words: str) -> None:
    assert words in told(example(number))


@pytest.mark.parametrize("number", ["4-08", "4-11", "4-13", "4-18"])
def test_golden(number: str) -> None:
    """The same files as those of test_problems.py."""
    path = example(number)
    assert_golden(f"{name_of(path)}.equations.txt", equations_text(worked(path)[0]))
    assert_golden(f"{name_of(path)}.solution.txt", Terminal().render(narrate(worked(path)[0])))


# --- which method leads there ----------------------------------------------------------------------------------------

CRATE = """
title: Crate slides to a stop
plane: vertical
given: {m: 20 kg, mu: 0.3, v_0: 4 m/s}
points: {C: [0, 0]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {crate: {particle: C, mass: m}}
joints:
  - contact: {between: [crate, floor], at: C, mu: mu}
states: {1: [t = 0, v(crate).x = v_0], 2: [v(crate).x = 0]}
"""
WAY = CRATE + "find: {way: x(crate) @ 2, heat: heat(C) @ 1->2, work: work(C) @ 1->2}\n"
TIME = CRATE + "find: {time: t @ 2, impulse: impulse(C).x @ 1->2}\n"
PUSHED = """
title: Block pushed by a force that grows
plane: vertical
given: {m: 4 kg, mu: 0.2, q: 30 N/s}
points: {C: [0, 0]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {block: {particle: C, mass: m}}
joints:
  - contact: {between: [block, floor], at: C, mu: mu}
loads:
  - force: {body: block, magnitude: q*t, angle: 0 deg}
states: {1: [t = 0, v(block).x = 3 m/s], 2: [t = 1.5 s]}
find: {v: v(block).x @ 2}
"""
BELT = """
title: Parcel laid on a belt
plane: vertical
given: {m: 2 kg, mu: 0.25, u: 3 m/s}
points: {C: [0, 0]}
surfaces: {belt: {through: C, angle: 0 deg, speed: u}}
bodies: {parcel: {particle: C, mass: m}}
joints:
  - contact: {between: [parcel, belt], at: C, mu: mu}
states: {1: [t = 0, v(parcel).x = 0], 2: [v(parcel).x = u]}
"""
BUFFER = """
title: Crate slides against a buffer
plane: vertical
given: {m: 3 kg, mu: 0.2, k: 200 N/m, d: 1 m}
points: {C: [0, 0], W: [2*d, 0]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {crate: {particle: C, mass: m}}
joints:
  - contact: {between: [crate, floor], at: C, mu: mu}
loads:
  - spring: {name: buffer, between: [C, W], stiffness: k, natural_length: d, acts: push}
states: {1: [t = 0, v(crate).x = 4 m/s], 2: [v(crate).x = 0]}
find: {pressed: x(crate) @ 2 - d, heat: heat(C) @ 1->2}
"""
PUCK = """
title: Puck on an elastic cord
plane: horizontal
given: {m: 0.4 kg, k: 50 N/m, l: 0.6 m, v_0: 6 m/s}
coordinates: {r: m, phi: deg}
points: {O: [0, 0], P: {from: O, distance: r, angle: phi}}
bodies: {puck: {particle: P, mass: m}}
loads:
  - spring: {between: [O, P], stiffness: k, natural_length: l}
states: {1: [t = 0, r = l, phi = 0, v(P).x = 0, v(P).y = v_0], 2: [r = 1.2*l]}
find: {v: v(P).mag @ 2, across: v(P/O).theta @ 2}
"""
BOWL = """
title: Ball in a bowl on wheels
plane: vertical
given: {M: 5 kg, m: 2 kg, R: 0.6 m}
points: {O: [0, 0], P: [-R, 0]}
bodies: {cart: {points: [O], center: O, mass: M}, ball: {particle: P, mass: m}}
surfaces: {bowl: {center: O, radius: R, body: cart}}
joints:
  - guide: {body: cart, along: 0 deg, name: floor}
  - guide: {point: P, along: bowl, name: groove}
states: {1: [t = 0, at rest], 2: [x(P) = x(O)]}
find: {u: v(O).x @ 2, v: v(P).x @ 2}
"""
UPRIGHT = """
title: Rod that stands upright
plane: vertical
given: {m: 2 kg, l: 0.5 m}
points: {O: [0, 0], A: [0, l]}
bodies: {rod: {rod: [O, A], mass: m}}
joints:
  - pin: {at: O, between: [ground, rod]}
states: {1: [at rest], 2: [y(A) = -l]}
find: {omega: omega(rod) @ 2}
"""
SWAYING = """
title: Bob on a spring
plane: vertical
points: {O: [0, 0], P: [0.5 m, -0.6 m]}
bodies: {bob: {particle: P, mass: 2 kg}}
loads:
  - spring: {between: [O, P], stiffness: 80 N/m, natural_length: 0.6 m}
states: {1: [t = 0, at rest], 2: [t = 0.4 s]}
find: {v: v(P).x @ 2}
"""


def refusal(text: str, method: str) -> str:
    with pytest.raises(FileProblem) as caught:
        part_of(text, method)
    (diagnostic,) = caught.value.diagnostics
    assert diagnostic.code == "PL570"
    assert "leave `method` out" in diagnostic.hint
    return diagnostic.message


@pytest.mark.parametrize("method", [None, "newton", "energy"])
def test_a_way_by_energy(method: str | None) -> None:
    found = answers(WAY, method)
    assert first(found["way"]) == pytest.approx(16 / (2 * 0.3 * G))
    assert first(found["heat"]) == pytest.approx(160)
    assert first(found["work"]) == pytest.approx(-160)


@pytest.mark.parametrize("method", [None, "newton", "momentum"])
def test_a_time_by_momentum(method: str | None) -> None:
    found = answers(TIME, method)
    assert first(found["time"]) == pytest.approx(4 / (0.3 * G))
    assert first(found["impulse"]) == pytest.approx(-80)


def test_what_a_method_does_not_reach() -> None:
    """Energy knows no time, momentum no place; each says what it lacks."""
    assert refusal(TIME, "energy") == "method energy alone does not reach t_2"
    assert refusal(WAY, "momentum") == "method momentum alone does not reach x_C_2"
    assert refusal(PUSHED, "energy") == "method energy alone does not reach v_C_2"


def test_the_method_of_the_file() -> None:
    """It holds unless another one is asked for."""
    by_energy = TIME.replace("find:", "method: energy\nfind:")
    assert refusal(by_energy, "energy") == "method energy alone does not reach t_2"
    with pytest.raises(FileProblem, match="energy alone"):
        part_of(by_energy)
    assert first(answers(by_energy, "momentum")["time"]) == pytest.approx(4 / (0.3 * G))


@pytest.mark.parametrize("method", ["energy", "momentum"])
def test_one_instant_has_no_laws_between_states(method: str) -> None:
    text = CRATE[: CRATE.index("states:")] + "instant: [v(crate).x = v_0]\nfind: {a: a(crate).x}\n"
    with pytest.raises(FileProblem, match="it relates two states, and this problem asks about one instant"):
        part_of(text, method)


@pytest.mark.parametrize("method", ["newton", "momentum"])
def test_a_force_that_grows(method: str) -> None:
    assert first(answers(PUSHED, method)["v"]) == pytest.approx(3 + 15 * 1.5**2 / 4 - 0.2 * G * 1.5)


def test_a_support_that_moves_does_work() -> None:
    """A parcel on a belt: its friction works along its own way, and as much again is heat."""
    by_energy = BELT + "find: {way: x(parcel) @ 2}\n"
    assert laws_used(part_of(by_energy, "energy")) == {"energy"}
    assert first(answers(by_energy, "energy")["way"]) == pytest.approx(9 / (2 * 0.25 * G))
    found = answers(BELT + "find: {work: work(parcel) @ 1->2, heat: heat(C) @ 1->2, gain: KE(parcel) @ 2}\n")
    assert [first(found[n]) for n in ("work", "heat", "gain")] == pytest.approx([9, 9, 9])


def test_energy_through_a_change_of_the_forces() -> None:
    """One balance over both stretches, though the buffer acts only in the second."""
    truth = (-0.6 * G + sqrt((0.6 * G) ** 2 + 400 * (24 - 0.6 * G))) / 200
    for method in (None, "newton", "energy"):
        found = answers(BUFFER, method)
        assert first(found["pressed"]) == pytest.approx(truth)
        assert first(found["heat"]) == pytest.approx(0.6 * G * (1 + truth))


def test_angular_momentum_about_a_centre_of_force() -> None:
    """With energy it tells both parts of a velocity; neither law does so alone."""
    part = part_of(PUCK)
    assert laws_used(part) == {"energy", "momentum"}
    found = {f.name: f for f in part.found}
    assert_close(found["across"], 5)
    assert_close(found["v"], (Decimal(36) - 125 * Decimal("0.12") ** 2).sqrt())
    assert refusal(PUCK, "energy").startswith("method energy gives one equation for the rate of")


def test_momentum_in_one_direction() -> None:
    """Nothing acts along the floor: the cart goes back as the ball comes down."""
    part = part_of(BOWL)
    assert laws_used(part) == {"energy", "momentum"}
    found = {f.name: f for f in part.found}
    apart = sqrt(2 * G * 0.6 * 7 / 5)
    assert first(found["u"]) == pytest.approx(-2 / 7 * apart)
    assert first(found["v"]) == pytest.approx(5 / 7 * apart)
    assert refusal(BOWL, "newton").startswith("method newton alone does not reach v_O_2")


def test_energy_alone_relates_states() -> None:
    """A rod that stands upright stays there; slightly touched it falls, as fast as the energy alone tells."""
    touched = part_of(UPRIGHT)
    assert abs(first(touched.found[0])) == pytest.approx(sqrt(6 * G / 0.5))
    assert "released at rest in an unstable equilibrium: the limit of a slight touch" in touched.motion.checks
    part = part_of(UPRIGHT, "energy")
    assert abs(first(part.found[0])) == pytest.approx(sqrt(6 * G / 0.5))
    words = "let go by itself it does not reach state 2; the balance of energy relates the two states all the same"
    assert words in part.motion.checks
    assert not any("no motion leads" in c for c in part_of(PUSHED).motion.checks)


def test_what_only_numbers_tell_is_newtons() -> None:
    """No law leads to a bob that sways and bounces, but its equations of motion can be followed."""
    assert first(answers(SWAYING)["v"]) == first(answers(SWAYING, "newton")["v"])
    assert refusal(SWAYING, "energy").startswith("method energy alone does not reach v_Px_2")


# --- side by side ----------------------------------------------------------------------------------------------------


def compared(tmp_path: Path, capsys: pytest.CaptureFixture[str], text: str) -> dict[str, dict[str, Any]]:
    """The rows of `planar solve --compare` by method, in their order."""
    file = tmp_path / "scene.yaml"
    file.write_text(text)
    assert cli.run(["solve", str(file), "--compare", "--format", "json"]) == 0
    rows = json.loads(capsys.readouterr().out)["methods"]
    return {row["method"]: row for row in rows}


def test_compare(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The shortest plan first; a method that fails says why."""
    rows = compared(tmp_path, capsys, example("4-08").read_text())
    assert list(rows) == ["energy", "newton", "dalembert", "lagrange", "momentum"]
    assert [rows[m]["equations"] for m in ("energy", "newton", "dalembert")] == [1, 2, 2]
    assert all(rows[m]["answers"] == ["omega"] for m in ("energy", "newton", "dalembert"))
    assert rows["momentum"]["answers"] == []
    assert rows["momentum"]["objection"] == "method momentum alone does not reach omega_2"


def test_compare_tells_what_is_reached_in_part(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    rows = compared(tmp_path, capsys, CRATE + "find: {way: x(crate) @ 2, time: t @ 2}\n")
    assert rows["newton"]["answers"] == ["way", "time"]
    assert (rows["energy"]["answers"], rows["momentum"]["answers"]) == (["way"], ["time"])
    assert rows["energy"]["objection"] == "method energy alone does not reach t_2"


WAGON = """
title: Wagon with a pendulum
plane: vertical
given: {M: 3 kg, m: 1 kg, l: 2 m, beta: 40 deg}
points: {W: [0, 0], P: {from: W, distance: l, angle: beta - 90 deg}}
bodies: {wagon: {particle: W, mass: M}, bob: {particle: P, mass: m}}
joints:
  - guide: {point: W, along: 0 deg}
  - rope: {path: [W, P]}
states: {1: [t = 0, at rest], 2: [x(bob) = x(wagon)]}
find: {V: v(wagon).x @ 2}
"""


def test_compare_tells_what_only_several_laws_reach(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    rows = compared(tmp_path, capsys, WAGON)
    assert next(iter(rows)) == "together"
    assert rows["together"]["answers"] == ["V"]
    assert all(row["objection"] for method, row in rows.items() if method != "together")


def test_compare_as_a_table(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["solve", str(example("4-18")), "--compare"]) == 0
    lines = [line.split() for line in capsys.readouterr().out.splitlines() if line.strip()]
    assert lines[1][:3] == ["Method", "Equations", "Largest"]
    assert {line[0] for line in lines[3:]} >= {"newton", "energy", "momentum"}
    assert next(line for line in lines if line[0] == "momentum")[-2:] == ["v", "-"]


KNEE = """
title: Two rods with a knee
plane: vertical
points: {O: [0, 0], A: [1 m, 0], B: [2 m, 0]}
bodies: {OA: {rod: [O, A], mass: 2 kg}, AB: {rod: [A, B], mass: 1 kg}}
joints:
  - pin: {at: O, between: [ground, OA]}
  - pin: {at: A, between: [OA, AB], name: knee}
instant: [omega(OA) = 2 rad/s, omega(AB) = 1 rad/s]
find: {on_AB: power(knee/AB), on_OA: power(knee/OA), both: power(knee), F: reaction(knee/AB).y, v: v(A).y}
"""


def test_power_on_one_of_two_bodies() -> None:
    """The force in the knee drives one rod and brakes the other; together it does nothing."""
    problem, wrong = load_text(KNEE)
    assert problem is not None, wrong
    found = {f.name: f for f in solve_problem(problem).parts[0].found}
    assert first(found["on_AB"]) == pytest.approx(first(found["F"]) * first(found["v"]))
    assert first(found["on_OA"]) == -first(found["on_AB"])
    assert first(found["both"]) == 0


LET_GO = """
title: Wheel driven up and let go
plane: vertical
points: {O: [0, 0]}
bodies: {wheel: {disk: O, radius: 0.2 m, mass: 2 kg}}
joints: [pin: {at: O, between: [ground, wheel]}]
loads: [torque: {body: wheel, moment: -0.1 N*m, name: drag}, %s]
states: {1: [t = 0, omega(wheel) = 0], 2: [t = 2 s]%s}
find: {a: alpha(wheel) @ 2, w: omega(wheel) @ 2}
"""


@pytest.mark.parametrize("later", ["", ", 3: [t = 3 s]"])
@pytest.mark.parametrize(
    ("drive", "speed"),
    [
        ("torque: {body: wheel, moment: 0.3 N*m, name: motor, during: 1->2}", 10),
        ("torque: {body: wheel, moment: 0.02 N*m, name: motor}]\nmotion: [alpha(wheel) = 2 rad/s^2 during 1->2", 4),
    ],
)
def test_what_ends_with_the_last_state_does_not_act_there(drive: str, speed: float, later: str) -> None:
    """Accelerations are those just after, whether or not another state follows; I = 0.04 kg m²."""
    found = solve(LET_GO % (drive, later))
    torque = -0.1 if "0.3" in drive else -0.08
    assert first(found["w"]) == pytest.approx(speed)
    assert first(found["a"]) == pytest.approx(torque / 0.04)


def test_a_law_that_ends_with_the_last_state_is_the_last_that_is_known() -> None:
    found = solve("""
title: Car that speeds up
coordinates: {s: m}
motion: ["ddot(s) = 2 m/s^2 during 1->2"]
states: {1: [t = 0, s = 0, dot(s) = 0], 2: [t = 2 s]}
find: {a: ddot(s) @ 2}
""")
    assert first(found["a"]) == pytest.approx(2)


def test_no_letter_is_derived_twice() -> None:
    """Energy and momentum together tell both speeds; a law for one of them alone is not written besides."""
    part = part_of(BOWL)
    assert part.motion is not None
    told = [r.unknown for step in part.motion.route.steps for r in step.results]
    assert len(told) == len(set(told))
