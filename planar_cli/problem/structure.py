"""Nodes to a typed `Problem`: every section read, every case merged, everything wrong gathered.

path -> nodes -> read sections (read_points, read_bodies, read_members, read_cases) -> Problem -> checks
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from planar_cli.errors import Diagnostic
from planar_cli.joints.base import Joint
from planar_cli.loads.base import Load
from planar_cli.problem.checks.checks import check
from planar_cli.problem.implied.assumed_of_unknowns import with_assumed
from planar_cli.problem.implied.called_by_points import with_joints_called
from planar_cli.problem.implied.customary import is_us
from planar_cli.problem.implied.drawn_directions import DrawnDirections
from planar_cli.problem.implied.from_rest import with_ways_from_rest
from planar_cli.problem.implied.grounds import Floor, with_floor
from planar_cli.problem.implied.guided_points import with_guided_points
from planar_cli.problem.implied.not_negative import with_coefficients
from planar_cli.problem.implied.open_ends import with_open_ends
from planar_cli.problem.implied.osculating import with_osculating_circles
from planar_cli.problem.implied.placed_particles import with_placed_particles
from planar_cli.problem.implied.points_at_rest import RestingPoints
from planar_cli.problem.implied.touching_points import with_later_meetings, with_touching_points
from planar_cli.problem.implied.unnamed_places import free_name, free_names, with_named_places
from planar_cli.problem.implied.whose_load import with_bodies
from planar_cli.problem.nodes import reading
from planar_cli.problem.nodes.fields import Fields
from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar, read_file, read_text
from planar_cli.problem.nodes.placeholders import check_placeholders
from planar_cli.problem.nodes.reading import Report
from planar_cli.problem.scene.order_of_states import in_order
from planar_cli.problem.scene.scene import Body, Case, Point, Problem, Surface, Symbol
from planar_cli.problem.sections import read_sections as sections
from planar_cli.problem.sections.read_bodies import read_bodies
from planar_cli.problem.sections.read_cases import OWN, merged
from planar_cli.problem.sections.read_members import read_joints, read_loads
from planar_cli.problem.sections.read_points import read_points, read_surfaces
from planar_cli.problem.sections.read_values import Names
from planar_cli.problem.sections.variations import variations_of, with_first_values
from planar_cli.registry import modules

Scene = tuple[tuple[Point, ...], tuple[Surface, ...], tuple[Body, ...], tuple[Joint, ...], tuple[Load, ...]]

WORDS = ("title", "text", "source", "note")
KEYS = (
    *WORDS,
    *(
        "plane",
        "given",
        "symbols",
        "unknowns",
        "assume",
        "coordinates",
        "points",
        "surfaces",
        "bodies",
        "joints",
        "loads",
    ),
    *("motion", "instant", "states", "find", "cases", "answers", "tolerance", "method", "variants", "figure"),
)
CASE_KEYS = tuple(key for key in KEYS if key not in OWN or key == "find")
HOMEWORK_SET = "this is a homework set, which lists problem files, and no problem file itself"
SCENE_KEYS = ("points", "surfaces", "bodies", "joints", "loads")
SLIPS = {
    "forces": "write `loads:` and below it `- force: {body: b, at: A, magnitude: 50 N, angle: 30 deg}`",
    "constraints": "write them in `joints`, `motion` or `instant`",
    "gravity": "write `plane: vertical`; weight then acts by itself",
    "g": "write `given: {g: 1.62 m/s^2}`; without it g is 9.81 m/s^2",
    "initial": "write `instant: [at rest]`, or the first of the `states`",
    "conditions": "write `instant: [at rest]`, or `states`",
    "parameters": "write `given` for numbers, `symbols` for letters",
    "constants": "write `given` for numbers, `symbols` for letters",
    "variables": "write `unknowns`, or `coordinates` for positions that vary",
    "solve": "write `find: {name: quantity}`",
    "solution": "write `answers: {name: value}`",
    "description": "write `text: >-` and indented lines",
    "name": "write `title: …`",
    "units": "units follow each number; a find may end with `in km/h`",
}


def load(path: str) -> tuple[Problem | None, list[Diagnostic], str]:
    """Read a problem file (`-`: standard input).

    Returns the problem (None where there is none to speak of), all that is wrong in the order of the file, and the text
    of the file for messages. The problem is fit for use only when nothing is wrong.
    """
    source, node, wrong = read_file(path)
    return (*problem_of(path, node, wrong), source)


def load_text(text: str, file: str = "<text>") -> tuple[Problem | None, list[Diagnostic]]:
    """As `load`, from a text already at hand."""
    node, wrong = read_text(text, file)
    return problem_of(file, node, wrong)


def problem_of(file: str, node: Node | None, wrong: list[Diagnostic]) -> tuple[Problem | None, list[Diagnostic]]:
    """As `load`, from the nodes of a file, of which something may be `wrong` already."""
    report = Report()
    for diagnostic in wrong:
        report.take(diagnostic)
    if node is None:
        return None, report.sorted()
    if isinstance(node, Mapping) and node.get("problems") is not None and node.get("find") is None:
        return None, [Diagnostic(node.mark, "PL345", HOMEWORK_SET, "use `planar key` or `planar check --set`")]
    problem = read_problem(file, node, report)
    for diagnostic in check(problem, unread=_unread(node, report.sorted())):
        report.take(diagnostic)
    found = report.sorted()
    return (None if found else problem), found


def _unread(node: Node, wrong: list[Diagnostic]) -> bool:
    """Is something wrong outside the bodies, where it is told what holds and drives them?"""
    keys = [key for key, _ in node.pairs] if isinstance(node, Mapping) else []
    sections = ([k.text for k in keys if (k.mark.line, k.mark.column) <= (d.mark.line, d.mark.column)] for d in wrong)
    return any(before and before[-1] != "bodies" for before in sections)


def read_problem(file: str, node: Node, report: Report) -> Problem:
    """The whole file, with its cases."""
    if not isinstance(node, Mapping):
        report.add(
            node.mark,
            "PL301",
            f"a problem file holds names with values, not {reading.shape_of(node)}",
            "begin with `title: …`",
        )
        node = Mapping((), node.mark)
    varying = {v.name for v in variations_of(node, report) if v.in_given}
    check_placeholders(node, report)
    node = with_first_values(node)
    assert isinstance(node, Mapping)
    whole = Fields(node, KEYS, "a problem file", report, SLIPS)
    base = _read(file, whole)
    base = replace(base, given=tuple(replace(s, varies=s.name in varying) for s in base.given)) if varying else base
    cases = _cases(file, node, whole)
    # Numbers of one case are used in others: all are counted in the same units.
    us = all(case.problem.us for case in cases) if cases else base.us
    energy = _letter_of_energy([base, *(case.problem for case in cases)])
    cases = [replace(case, problem=replace(case.problem, us=us, kinetic_energy=energy)) for case in cases]
    hidden = sections.hidden(whole)
    cases = [replace(case, problem=replace(case.problem, hidden=hidden)) for case in cases]
    answers = sections.answers(whole)
    return replace(base, cases=tuple(cases), answers=answers, us=us, kinetic_energy=energy, hidden=hidden)


def _letter_of_energy(parts: Iterable[Problem]) -> str:
    """T, where no part of the file calls a tension or a period so."""
    named: set[str] = set()
    for part in parts:
        letters = (*part.given, *part.symbols, *part.unknowns, *part.coordinates)
        named |= {s.name for s in letters} | {f.name for f in part.find}
    return "E_k" if any(n == "T" or n.startswith("T_") for n in named) else "T"


def _cases(file: str, base: Mapping, whole: Fields) -> list[Case]:
    node = whole.node("cases")
    if node is None:
        return []
    known = Mapping(tuple(pair for pair in base.pairs if pair[0].text in KEYS), base.mark)
    read: list[Case] = []
    for key, value in reading.pairs(node, "cases", whole.report, "cases: {smooth: {given: {mu: 0}, find: {…}}}"):
        name = reading.name(key, "a name of a case", whole.report)
        what = f"the case {key.text}"
        if not isinstance(value, Mapping):
            reading.pairs(value, what, whole.report, "find: {…}")
            continue
        Fields(value, CASE_KEYS, what, whole.report, SLIPS)
        allowed = Mapping(tuple(pair for pair in value.pairs if pair[0].text in CASE_KEYS), value.mark)
        problem = _read(file, Fields(merged(known, allowed), KEYS, what, whole.report))
        if name:
            read.append(Case(name, problem, key.mark))
    return read


def _read(file: str, whole: Fields) -> Problem:
    """One file, or one case of it, without its cases and answers."""
    given = sections.given(whole)
    symbols, unknowns, coordinates = (sections.with_units(whole, key) for key in ("symbols", "unknowns", "coordinates"))
    numbers = frozenset(s.name for s in (*given, *symbols, *unknowns, *coordinates))
    points, surfaces, bodies, joints, loads = _scene(whole, given, numbers)
    resting = RestingPoints(bodies, points)
    title, text, source, note = (sections.words(whole, key) for key in WORDS)
    problem = Problem(
        file=file,
        title=title,
        text=text,
        source=source,
        note=note,
        plane=sections.one_of(whole, "plane", sections.PLANES),
        given=given,
        symbols=symbols,
        unknowns=unknowns,
        coordinates=coordinates,
        assume=sections.statements(whole, "assume") or (),
        points=points,
        surfaces=surfaces,
        bodies=bodies,
        joints=joints,
        loads=loads,
        motion=sections.motion(whole),
        instant=resting.statements(sections.statements(whole, "instant")),
        states=resting.states(in_order(sections.states(whole))),
        find=sections.finds(whole),
        cases=(),
        answers=(),
        tolerance=whole.side("tolerance"),
        method=sections.one_of(whole, "method", modules("principles")),
        us=False,
    )
    problem = with_open_ends(replace(problem, us=is_us(problem)))
    problem = with_ways_from_rest(with_osculating_circles(problem))
    problem = with_guided_points(with_placed_particles(with_assumed(problem)))
    return with_coefficients(with_joints_called(with_later_meetings(problem)))


def _scene(whole: Fields, given: tuple[Symbol, ...], numbers: frozenset[str]) -> Scene:
    """Points, surfaces, bodies, joints and loads."""
    everything = [node for key in KEYS if (node := whole.node(key)) is not None]
    sections = with_named_places({key: whole.node(key) for key in SCENE_KEYS}, everything)
    points, surfaces, bodies, joints, loads = (sections[key] for key in SCENE_KEYS)
    report = whole.report
    read_surface = () if surfaces is None else read_surfaces(surfaces, report)
    read_body = () if bodies is None else read_bodies(bodies, report, numbers)
    own = whole.node("points")
    unnamed = {*points.keys()} if isinstance(points, Mapping) else set()
    unnamed -= {b.name for b in read_body} | ({*own.keys()} if isinstance(own, Mapping) else set())
    names = Names(frozenset(b.name for b in read_body), frozenset(s.name for s in read_surface), frozenset(unnamed))
    read_joint = () if joints is None else read_joints(joints, names, report)
    names_c, plane = free_names("C", everything), whole.node("plane")
    said = plane.text if isinstance(plane, Scalar) else None
    named = [node for key in KEYS if key not in WORDS and (node := whole.node(key)) is not None]
    floor = Floor(said, free_name("floor", named), names_c)
    read_point = () if points is None else read_points(points, report)
    standing = with_floor(read_joint, read_body, read_point, floor, report)
    read_surface = (*read_surface, *standing.surfaces)
    touching = with_touching_points(
        standing.joints, read_body, read_surface, DrawnDirections(given, read_point), names_c, report
    )
    read_point = tuple(replace(p, unnamed=p.name in unnamed) for p in read_point)
    return (
        (*read_point, *(replace(p, unnamed=True) for p in (*standing.points, *touching[1]))),
        read_surface,
        read_body,
        touching[0],
        () if loads is None else with_bodies(read_loads(loads, names, report), touching[0], read_body, report),
    )
