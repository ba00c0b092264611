"""The arrangement: bodies, what joins and moves them, what the file gives, in the position in which it draws them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from planar_cli.figures.arms import turned_arm
from planar_cli.figures.belts import belt_marks, frame_marks
from planar_cli.figures.carried import shifted
from planar_cli.figures.dead_positions import out_of_line
from planar_cli.figures.deflected import angles_there, at_equilibrium, deflected, swings_alone
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.edges_struck import step_of
from planar_cli.figures.fixed_edges import fixed_edges, holds_an_edge
from planar_cli.figures.floors import blocks_on_faces
from planar_cli.figures.given_motion import Found, Moving, Told, arrows_apart, given_motion_marks
from planar_cli.figures.hanging import hanging, hangs_along, under_axles
from planar_cli.figures.held_later import slack_marks
from planar_cli.figures.joints_drawn import one_support, sketch_marks
from planar_cli.figures.measures import measure_marks
from planar_cli.figures.motions_in_states import moving_in
from planar_cli.figures.names import names_of_bodies
from planar_cli.figures.orbits import on_orbits
from planar_cli.figures.outlines import edges
from planar_cli.figures.parallel import with_parallel_ropes
from planar_cli.figures.partners import between, is_slot, partners, sketch_of, sliders, touching
from planar_cli.figures.paths import course_of, curve_of, pole_of
from planar_cli.figures.points_only import lines_of_points
from planar_cli.figures.positions import (
    Later,
    asked_places,
    brought_near,
    followed_positions,
    position_marks,
    positions,
    positions_of_instants,
    slid_to,
)
from planar_cli.figures.rings import extent_of, way_of
from planar_cli.figures.ropes import bends
from planar_cli.figures.shapes import body_marks
from planar_cli.figures.side_by_side import BOX, EDGE, POINT, guided, is_apart, scale_of, side_by_side
from planar_cli.figures.springs import settled
from planar_cli.figures.state_measures import lengths_of_ways, state_measures
from planar_cli.figures.sunk import sunk
from planar_cli.figures.surfaces import surface_marks
from planar_cli.figures.uncrowded import uncrowded
from planar_cli.figures.unguided import is_idle, led_blocks
from planar_cli.figures.within import within
from planar_cli.joints.base import Joint
from planar_cli.loads.base import Load
from planar_cli.problem.scene.scene import GROUND, Circle, Line, Particle, Problem, Round, Surface
from planar_cli.problem.scene.sketches import Cord, Slide
from planar_cli.report.document.blocks import Name, line
from planar_cli.report.document.marks import (
    Angle,
    Arrow,
    Axes,
    Dimension,
    Hatched,
    Mark,
    Panel,
    Polyline,
    Spot,
    Symbol,
    Tag,
    Turn,
    spots_of,
)
from planar_cli.solve.solved_problem import PartSolution

if TYPE_CHECKING:
    from planar_cli.simulate.run import Run

MORE = 2
"""Positions that are drawn in one figure."""
ON = 1e-6
"""What is so near to a bar, in parts of its length, is on it."""
PRESSED = 0.1
"""So far beside a surface, in parts of the scene, a body is taken to be that is drawn on it as a point."""
ALONE = 1.0
"""The size of a scene that is one point, m."""


def arrangement(part: PartSolution, whole: Mapping[str, tuple[Spot, ...]]) -> Panel:
    """The scene of a part where the file draws its first instant; of a motion where it begins; and where its bodies are
    in later states. `whole`: the paths that are asked for.
    """
    instant, motion = part.instants[0], part.motion
    problem, states = instant.instant.scene.problem, [s.name for s in instant.instant.scene.problem.states]
    drawn, moving = _first(part)
    whole_time = motion.problem if motion is not None else problem
    drawn = with_parallel_ropes(drawn, whole_time.joints)
    moving = replace(moving, drawn=drawn) if moving is not None else None
    timed = motion is not None and states
    places = positions(drawn, motion, states) if motion and timed else positions_of_instants(drawn, part.instants)
    swing = deflected(drawn, motion) if motion is not None and swings_alone(motion, states) else None
    places += [swing] if swing is not None else []
    if len(places) < MORE and not timed:
        bodies = drawn.scene.bodies
        particles = [name for name, body in bodies.items() if isinstance(body.shape, Particle)]
        curves = [whole.get(name) or curve_of(drawn, name) or course_of(drawn, name) for name in particles]
        curves += [way for name, way in whole.items() if drawn.scene.owner(name) not in (GROUND, *particles)]
        ways = [Polyline(curve, "way") for curve in curves if len(curve) > 1]
        marks = tuple(_marks(drawn, moving, problem))
        return _panel(problem, (*marks, *ways, *_pole(drawn, marks, ways), *_arms(drawn, particles)))
    size = _size(_marks(drawn, moving, whole_time))
    places = brought_near(places, size)
    marks = tuple(_marks(drawn, moving, whole_time, places[1:]))
    later = (*position_marks(places, motion, part.run, marks), *asked_places(places, problem))
    later = (*later, *lengths_of_ways(places, problem, later))
    later = (*later, *(angles_there(swing, motion) if swing is not None and motion is not None else ()))
    return _panel(problem, (*marks, *on_orbits(later, part), *state_measures(places, problem, marks)))


def _first(part: PartSolution) -> tuple[Drawn, Found | None]:
    """The position that is drawn, and the motion there."""
    instant, motion = part.instants[0], part.motion
    drawn = Drawn.as_in_the_file(instant)
    if motion is None:
        return drawn, Found.of(drawn, (instant,))
    states = [s.name for s in drawn.scene.problem.states]
    # The one instant of a motion in time is a state without a name: what is asked at a time is drawn at that time.
    there = Drawn.in_state(motion, (states or motion.states)[0])
    placed = moving_in(part, "") if there is None and not states else None
    if placed is not None and placed.drawn.is_placed:
        return placed.drawn, placed
    there = out_of_line(motion, there, states[1:]) if there is not None else None
    drawn = there or (at_equilibrium(drawn, motion) if swings_alone(motion, states) else drawn)
    return drawn, Found.of(drawn, (*(r.solution for r in motion.regimes), instant))


def arranged(drawn: Drawn) -> Panel:
    """A scene in one position."""
    drawn = with_parallel_ropes(drawn, drawn.scene.problem.joints)
    return _panel(drawn.scene.problem, tuple(_marks(drawn, Told(drawn), drawn.scene.problem)))


def followed_arrangement(run: Run) -> Panel | None:
    """The scene of a motion that was followed in numbers alone; None: the file does not draw where it begins."""
    drawn = Drawn.at_first(run.problem, run.settings.values)
    if drawn is None:
        return None
    drawn = with_parallel_ropes(drawn, run.problem.joints)
    size = _size(_marks(drawn, Told(drawn), run.problem))
    places = brought_near(followed_positions(drawn, run), size)
    marks = tuple(_marks(drawn, Told(drawn), run.problem, places[1:]))
    return _panel(
        run.problem, (*marks, *position_marks(places, None, run, marks), *state_measures(places, run.problem, marks))
    )


def _size(marks: Iterable[Mark]) -> float:
    """How large a scene is, m; 0: it is a point, however high above the ground."""
    told = list(marks)
    apart = [s for m in told if not isinstance(m, Dimension) for s in spots_of(m)]
    return extent_of([s for m in told for s in spots_of(m)]) if extent_of(apart) else 0.0


def _panel(problem: Problem, whole: tuple[Mark, ...]) -> Panel:
    """Bodies that meet, and nothing else, are at one point although they are drawn side by side."""
    marks = uncrowded(whole, {f.name for f in problem.find})
    placed = extent_of([s for m in marks for s in spots_of(m)])
    signs = all(isinstance(m, Symbol | Arrow | Turn | Tag | Angle | Axes) for m in marks)
    return Panel(tuple(settled(sunk(marks))), least=ALONE if signs and placed < 3 * BOX / POINT else 0.0)


def _marks(drawn: Drawn, moving: Moving | None, whole: Problem, later: Sequence[Later] = ()) -> Iterator[Mark]:
    """`whole`: with all joints and loads, whenever they act; `later`: further positions, to which surfaces go on."""
    scene, problem, joints = drawn.scene, drawn.scene.problem, whole.joints
    points = {n: s for n, p in scene.points.items() if (s := drawn.spot(p)) is not None}
    masses = {n: s for n, b in scene.bodies.items() if (s := drawn.spot(b.center)) is not None}
    centers, named = list(masses.values()), {**masses, **points}
    size = extent_of([*points.values(), *centers]) or ALONE
    standing = {**blocks_on_faces(drawn), **fixed_edges(drawn, joints)}
    inner, edges_of = list[Mark](under_axles(drawn)), dict[str, tuple[Spot, ...]]()
    shaped = frozenset[str]().union(*(edges(drawn, body) for body in scene.bodies.values()))
    for surface in problem.surfaces:
        if surface.name in shaped or _is_rim(drawn, surface):
            continue
        places = [named[p] for p in touching(problem, surface, joints) if p in named]
        near_it = [b for b in partners(problem, surface, joints) if b in scene.bodies]
        near = [s for b in near_it if (s := drawn.spot(scene.bodies[b].center)) is not None]
        near += _pressed(drawn, moving, surface, joints, size)
        beside = scene.bodies if isinstance(surface.shape, Line | Circle) else near_it
        seen = [[*body_marks(drawn, scene.bodies[b])] for b in beside]
        seen += [p.marks(b) for p in later for b in beside if b in p.spots]
        for mark in surface_marks(drawn, surface, places, seen, near or centers, size):
            if surface.body is not None:
                inner += within(mark, [*body_marks(drawn, scene.bodies[surface.body])], is_slot(surface, joints))
                continue
            yield from belt_marks(drawn, surface, mark)
            if isinstance(mark, Hatched):
                edges_of[surface.name] = mark.places
                along = way_of(mark.places[0], mark.places[-1])
                on_it = [name for name in sliders(problem, surface) if name in masses]
                standing |= {name: Symbol("block", masses[name], along) for name in on_it}
    aside = side_by_side(drawn, moving, joints, standing)
    hung = {n: block for n, block in {**led_blocks(drawn), **hanging(drawn)}.items() if n not in standing}
    sketched = [*arrows_apart(one_support(list(_sketched(drawn, whole, later, hung, aside))), ())]
    sliding = {m.at for m in sketched if isinstance(m, Symbol) and m.kind in ("slider", "rail", "block")}
    for name, body in scene.bodies.items():
        for mark in body_marks(drawn, body):
            here = shifted(mark, aside.get(name, (0.0, 0.0)))
            if isinstance(here, Symbol) and (here.at in sliding or name in hung):
                continue
            yield standing.get(name, here) if isinstance(here, Symbol) else here
    yield from (*inner, *sketched, *hung.values(), *frame_marks(drawn), *slack_marks(drawn, joints))
    written = [p for p in problem.points if not p.unnamed and p.name not in problem.hidden]
    shown = {p.name: points[p.name] for p in written if p.name in points}
    bars = [m for n in scene.bodies.values() for m in body_marks(drawn, n) if isinstance(m, Polyline) and not m.closed]
    yield from _points(drawn, shown.values(), bars, sketched)
    tagged = {**shown, **_particles(drawn, problem, shown, aside)}
    tagged |= {name: (tagged[name][0] + x, tagged[name][1] + y) for name, (x, y) in aside.items() if name in tagged}
    measures = [*lines_of_points(drawn, tagged), *measure_marks(drawn, problem, tagged, edges_of)]
    yield from (*measures, *_origin(measures, tagged))
    if moving is not None:
        given = given_motion_marks(moving, problem, aside, guided(drawn, joints), EDGE * scale_of(drawn))
        yield from arrows_apart(given, sketched)
    yield Axes(problem.plane == "vertical")
    yield from names_of_bodies(drawn, problem, tagged)


def _sketched(
    drawn: Drawn, whole: Problem, later: Sequence[Later], hung: Mapping[str, Symbol], aside: Mapping[str, Spot]
) -> Iterator[Mark]:
    """Joints and loads. `hung`: loads on ropes; `aside`: by so much bodies are drawn beside their places, m."""
    problem = drawn.scene.problem
    for entry in (*problem.joints, *_loads(problem, whole)):
        for sketch in sketch_of(drawn, entry):
            hidden = is_apart(entry, aside) or holds_an_edge(drawn, entry, whole.joints)
            if not (hidden or hangs_along(drawn, sketch, hung) or is_idle(drawn, entry, sketch)):
                step = step_of(drawn, entry, sketch)
                marks = [step] if step else sketch_marks(drawn, sketch, line(entry.name), slid_to(later, entry, sketch))
                yield from (shifted(m, aside.get(getattr(entry, "body", ""), (0.0, 0.0))) for m in marks)


def _loads(problem: Problem, whole: Problem) -> tuple[Load, ...]:
    """Those that act at first, then those that act later, such as a blow."""
    first = {load.name for load in problem.loads}
    return (*problem.loads, *(load for load in whole.loads if load.name not in first))


def _pressed(
    drawn: Drawn, moving: Moving | None, surface: Surface, joints: Sequence[Joint], size: float
) -> Iterator[Spot]:
    """Places beside a fixed surface where it presses a body: on that side there is none of the ground. Not of a guide,
    which holds on both sides.
    """
    touched = [j for j in joints if surface.name in between(j)] if moving is not None and surface.body is None else []
    for joint in touched:
        if moving is None or any(isinstance(s, Slide) for s in sketch_of(drawn, joint)):
            continue
        for (x, y), (u, v) in moving.pressed(joint.name):
            reach = PRESSED * size / (math.hypot(u, v) or 1.0)
            yield x + reach * u, y + reach * v


def _points(drawn: Drawn, spots: Iterable[Spot], bars: Sequence[Polyline], sketched: Sequence[Mark]) -> Iterator[Mark]:
    """The points of a scene: on a bar each is a ring, where nothing else is drawn; none where a rope bends round a
    wheel beside its point.
    """
    pinned = {m.at for m in sketched if isinstance(m, Symbol)}
    cords = (s for joint in drawn.scene.problem.joints for s in sketch_of(drawn, joint) if isinstance(s, Cord))
    beside = {s for cord in cords for s in bends(drawn, cord)}
    for spot in spots:
        bare = spot not in pinned and any(_is_on(spot, bar) for bar in bars)
        if spot not in beside:
            yield Symbol("ring" if bare else "point", spot)


def _origin(measures: Sequence[Mark], tagged: dict[str, Spot]) -> Iterator[Mark]:
    """Where coordinates are measured from, if both x and y are and no point with a name lies there."""
    level = [m for m in measures if isinstance(m, Dimension) and m.level]
    across = {abs(m.start[0] - m.end[0]) > abs(m.start[1] - m.end[1]) for m in level}
    if len(across) == 2 and all(math.hypot(*s) > 1e-9 for s in tagged.values()):
        yield Symbol("origin", (0.0, 0.0))
        yield Tag((0.0, 0.0), line(Name("0" if "O" in tagged else "O")))


def _arms(drawn: Drawn, particles: Sequence[str]) -> Iterator[Mark]:
    """r and θ of particles whose polar coordinates the file tells."""
    for name in particles:
        pole, at = pole_of(drawn, name), drawn.spot(drawn.scene.bodies[name].center)
        if pole is not None and at is not None and math.dist(pole, at) > ON:
            yield from turned_arm(pole, at)


def _pole(drawn: Drawn, marks: Sequence[Mark], ways: Sequence[Polyline]) -> Iterator[Mark]:
    """The origin, from which formulas of the time tell a way, if nothing with a name lies there."""
    told = any(course_of(drawn, name) for name, body in drawn.scene.bodies.items() if isinstance(body.shape, Particle))
    named = {m.words for m in marks if isinstance(m, Tag) and math.hypot(*m.at) < ON}
    letters = {m.words for m in marks if isinstance(m, Tag)}
    if ways and told and not named and line(Name("O")) not in letters:
        yield Symbol("origin", (0.0, 0.0))
        yield Tag((0.0, 0.0), line(Name("O")))


def _is_rim(drawn: Drawn, surface: Surface) -> bool:
    """Is a surface the rim of the round body that carries it, which is drawn already?"""
    body = drawn.scene.bodies.get(surface.body or "")
    if body is None or not isinstance(body.shape, Round) or not isinstance(surface.shape, Circle):
        return False
    radii = (drawn.length(surface.shape.radius), drawn.length(body.shape.radius))
    return surface.shape.center == body.shape.center and radii[0] == radii[1]


def _is_on(spot: Spot, bar: Polyline) -> bool:
    """Is a place on a bar?"""
    around = math.dist(spot, bar.places[0]) + math.dist(spot, bar.places[-1])
    return around < math.dist(bar.places[0], bar.places[-1]) * (1 + ON)


def _particles(drawn: Drawn, problem: Problem, shown: dict[str, Spot], aside: Mapping[str, Spot]) -> dict[str, Spot]:
    """Particles that are at no point with a name of its own, or are drawn beside it, by their names."""
    found = {}
    for body in problem.bodies:
        spot = drawn.spot(drawn.scene.bodies[body.name].center)
        alone = spot not in shown.values() or (body.name in aside and body.name not in shown)
        if alone and spot is not None and isinstance(body.shape, Particle) and body.name not in problem.hidden:
            found[body.name] = spot
    return found
