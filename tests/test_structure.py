"""Reading: nodes to a typed Problem."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest
from conftest import PROBLEMS

from planar_cli.errors import Diagnostic
from planar_cli.joints.guide import Guide
from planar_cli.joints.pin import Pin
from planar_cli.joints.rope import Rope
from planar_cli.loads.force import Force
from planar_cli.manual import pages
from planar_cli.problem.language.expression import AtRest, Name, Number, Relation
from planar_cli.problem.scene.keys import RopeStop, Table
from planar_cli.problem.scene.scene import At, Composite, Particle, Polar, Problem, Rod, Round, TwoFacts
from planar_cli.problem.structure import load, load_text


def read(text: str) -> Problem:
    problem, diagnostics = load_text(text, "file.yaml")
    assert not diagnostics, diagnostics
    assert problem is not None
    return problem


def wrong(text: str) -> list[Diagnostic]:
    return load_text(text, "file.yaml")[1]


@pytest.mark.parametrize("path", PROBLEMS, ids=lambda p: f"{p.parent.name}/{p.stem}")
def test_every_problem_file_is_read(path: Path) -> None:
    problem, diagnostics, _ = load(str(path))
    assert diagnostics == []
    assert problem is not None


@pytest.mark.parametrize("topic", sorted(pages()))
def test_whole_files_in_the_pages_are_valid(topic: str) -> None:
    for file in whole_files(pages()[topic]):
        read(file)


def whole_files(page: str) -> list[str]:
    """The indented blocks of a page that begin with `title:`."""
    files: list[list[str]] = []
    inside = False
    for line in page.splitlines():
        if line.startswith("    title:"):
            files.append([])
            inside = True
        elif line and not line.startswith("    "):
            inside = False
        if inside:
            files[-1].append(line[4:])
    return ["\n".join(lines) + "\n" for lines in files]


SPOOL = whole_files(pages()["language"])[0].partition("cases:")[0]


def test_examples_are_found() -> None:
    assert len(whole_files(pages()["examples"])) >= 4


def test_sections() -> None:
    problem = read(SPOOL)
    assert problem.plane == "vertical"
    assert [s.name for s in problem.given] == ["m", "k_G", "R", "r", "P"]
    value = problem.given[2].value
    assert isinstance(value, Number)
    assert (value.value, value.unit) == (Fraction(45, 100), "m")
    assert isinstance(problem.points[1].place, At)
    spool = problem.bodies[0]
    assert isinstance(spool.shape, Round)
    assert (spool.shape.kind, spool.shape.center) == ("disk", "G")
    assert isinstance(spool.gyration, Name)
    assert problem.instant is not None
    assert isinstance(problem.instant[0], AtRest)
    assert [f.name for f in problem.find] == ["alpha", "friction"]
    assert problem.us is False


def test_members_are_called_by_point_or_body() -> None:
    problem = read(SPOOL)
    assert problem.joints[0].name == "C"
    load_ = problem.loads[0]
    assert isinstance(load_, Force)
    assert (load_.name, load_.wound_at, load_.at) == ("T", "T", None)


def test_points() -> None:
    problem = read(
        "given: {l: 2 m}\n"
        "points:\n"
        "  A: [0, 0]\n"
        "  B: {from: A, distance: l, angle: 30 deg}\n"
        "  C: {distances: {A: l, B: 1 m}, side: above}\n"
        "  D: {x: 1 m, line: [A, 30 deg]}\n"
        "find: {r: r(D)}\n"
    )
    places = {p.name: p.place for p in problem.points}
    assert isinstance(places["B"], Polar)
    c, d = places["C"], places["D"]
    assert isinstance(c, TwoFacts)
    assert [name for name, _ in c.distances] == ["A", "B"]
    assert c.side == "above"
    assert isinstance(d, TwoFacts)
    assert [line[0] for line in d.lines] == ["A"]


def test_shapes() -> None:
    problem = read(
        "plane: vertical\n"
        "coordinates: {beta: deg}\n"
        "points: {A: [0, 0], O: [0, 0]}\n"
        "bodies:\n"
        "  a: {rod: [A, beta], length: 2 m, mass: 1 kg}\n"
        "  b: {rod: [A, 30 deg], length: 2 m, mass: any}\n"
        "  P: {particle: free, weight: 20 N}\n"
        "  w: {parts: [{disk: O, radius: 1 m, mass: 3 kg}, {disk: A, radius: 0.2 m, mass: -1 kg}]}\n"
        "find: {a: a(P)}\n"
    )
    a, b, p, w = problem.bodies
    assert isinstance(a.shape, Rod)
    assert a.shape.end is None
    assert isinstance(a.shape.angle, Name)
    assert isinstance(b.shape, Rod)
    assert isinstance(b.shape.angle, Number)
    assert b.any_mass
    assert b.mass is None
    assert p.shape == Particle(None)
    assert isinstance(w.shape, Composite)
    assert len(w.shape.pieces) == 2


def test_joints_keep_what_is_written() -> None:
    problem = read(
        "points: {A: [0, 0], B: [1 m, 0], D: [1 m, 1 m], T: [2 m, 1 m]}\n"
        "bodies: {AB: {rod: [A, B]}, drum: {disk: D, radius: 1 m}}\n"
        "joints:\n"
        "  - pin: {at: A, between: [ground, AB], friction_torque: 2 N*m, name: axle}\n"
        "  - guide: {point: B, along: AB, mu: 0.2}\n"
        "  - rope: {path: [A, over D, under D, T on drum], along: 90 deg}\n"
        "find: {v: v(B)}\n"
    )
    pin, guide, rope = problem.joints
    assert isinstance(pin, Pin)
    assert pin.name == "axle"
    assert isinstance(guide, Guide)
    assert guide.along == "AB"
    assert guide.name == "B"
    assert isinstance(rope, Rope)
    assert rope.path == (
        RopeStop("point", "A"),
        RopeStop("over", "D"),
        RopeStop("under", "D"),
        RopeStop("on", "T", "drum"),
    )


def test_tables_and_spans() -> None:
    problem = read(
        "plane: horizontal\n"
        "bodies: {P: {particle: [0, 0], mass: 1 kg}}\n"
        "loads:\n"
        "  - force: {body: P, magnitude: {table: [[0 s, 0 N], [2 s, 50 N]]}, angle: 0 deg, during: 1->2}\n"
        "states: {1: [t = 0, at rest], 2: [t = 2 s]}\n"
        "motion: [a(P).y = 0 during 1 -> 2]\n"
        "find: {v: v(P) @ 2}\n"
    )
    force = problem.loads[0]
    assert isinstance(force, Force)
    assert isinstance(force.magnitude, Table)
    assert len(force.magnitude.rows) == 2
    assert force.during == ("1", "2")
    assert problem.motion[0].during == ("1", "2")
    assert [s.name for s in problem.states] == ["1", "2"]


def test_cases_lay_their_keys_over_the_file() -> None:
    problem = read(
        SPOOL
        + "cases:\n"
        + "  critical:\n"
        + "    unknowns: {k_G: m}\n"
        + "    instant: [friction(C).x = 0]\n"
        + "    find: {k: k_G}\n"
        + "  again:\n"
        + "    given: {k_G: critical.k, m: 80 kg}\n"
        + "    points: {T: [0, R - r]}\n"
        + "    find: {alpha_2: alpha(spool)}\n"
        + "answers: {k: 0.3674 m}\n"
    )
    critical, again = (case.problem for case in problem.cases)
    assert [s.name for s in critical.unknowns] == ["k_G"]
    assert "k_G" not in {s.name for s in critical.given}
    assert critical.instant is not None
    assert [type(s) for s in critical.instant] == [AtRest, Relation]
    assert [f.name for f in critical.find] == ["k"]
    assert [p.name for p in again.points] == ["C", "G", "T"]
    assert {s.name: s.mark.line for s in again.given}["m"] == 19
    assert [f.name for f in problem.find] == ["alpha", "friction"]


def test_a_file_that_asks_nothing_may_be_completed_by_its_cases() -> None:
    text = (
        "points: {A: [0, 0], B: {from: A, distance: l, angle: 0 deg}}\n"
        "cases:\n"
        "  short: {given: {l: 1 m}, find: {x1: x(B)}}\n"
        "  long: {given: {l: 2 m}, find: {x2: x(B)}}\n"
    )
    assert len(read(text).cases) == 2
    assert [d.code for d in wrong(text + "find: {x: x(B)}\n")] == ["PL410"]


@pytest.mark.parametrize(
    ("given", "us"),
    [
        ("{m: 3 lb, l: 2 ft, t_0: 3 s}", True),
        ("{m: 3 slug, g: 32.2 ft/s^2}", True),
        ("{m: 3 lb, l: 2 m}", False),
        ("{a: 30 deg}", False),
        ("{m: 3 kg}", False),
    ],
)
def test_us_customary(given: str, us: bool) -> None:
    assert read(f"given: {given}\npoints: {{A: [0, 0]}}\nfind: {{x: x(A)}}\n").us is us


def test_answers() -> None:
    problem = read(
        SPOOL
        + "answers:\n"
        + "  alpha: {value: 6.186 rad/s^2 cw, tolerance: 0.02}\n"
        + "  friction: 39.18 N\n"
        + "tolerance: 0.005\n"
        + "method: newton\n"
        + "variants: {m: {from: 1 kg, to: 5 kg, step: 1 kg}, R: [1 m, 2 m]}\n"
        + "figure: {hide: [floor]}\n"
    )
    assert [a.name for a in problem.answers] == ["alpha", "friction"]
    value = problem.answers[0].value
    assert isinstance(value, Number)
    assert value.sense == -1
    assert problem.answers[0].tolerance is not None
    assert problem.method == "newton"


def test_everything_wrong_is_told_at_once() -> None:
    found = wrong("plane: up\npoint: {A: [0, 0]}\njoints: [pin]\nmotion: {x: 1}\nfind: {x: y}\n")
    assert [d.code for d in found] == ["PL317", "PL310", "PL312", "PL307", "PL410"]
    assert [d.mark.line for d in found] == [1, 2, 3, 4, 5]


def test_empty_and_scalar_files() -> None:
    assert wrong("")
    assert [d.code for d in wrong("hello")] == ["PL301"]
    assert [d.code for d in wrong("bodies: 5\npoints: []\njoints: {}\nfind: 3\n")] == [
        "PL301",
        "PL301",
        "PL302",
        "PL301",
    ]
