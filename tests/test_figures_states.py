"""Figures of motions: every state is drawn where the page has it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
import sympy as sp
from conftest import PROBLEMS, ROOT
from worked import name_of, worked

from planar_cli.cli import UNDECIDED
from planar_cli.commands.draw import command
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.illustrated import figures_of, illustrated
from planar_cli.figures.positions import JOINED
from planar_cli.report.document.blocks import Name, Text, line
from planar_cli.report.document.marks import (
    Angle,
    Arc,
    Arrow,
    Axes,
    Coil,
    Dimension,
    Figure,
    Hatched,
    Mark,
    Polyline,
    Symbol,
    Tag,
)
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.solved_problem import PartSolution

EVERY = 24
"""Of so many problem files one is drawn in each run, as in test_figures.py."""
DOTS = ("point", "particle", "place", "pin", "ring")


def named(stem: str) -> Path:
    return next(p for p in PROBLEMS if p.stem == stem)


SEVERAL_REGIMES = [named("cylinder-down-a-slope-and-on-along-a-floor"), named("there-and-back")]


def places_of(motion: MotionTrace) -> Iterator[tuple[str, str, sp.Symbol, int]]:
    """The places of mass centres that have symbols of their own: state, body, symbol of the state, x (0) or y (1)."""
    for regime in motion.regimes:
        for name, body in regime.solution.instant.scene.bodies.items():
            for axis, general in enumerate((body.center.x, body.center.y)):
                own = (x for x, g in motion.general.items() if g == general)
                yield from ((str(motion.ledger.roles[x].at), name, x, axis) for x in own)


@pytest.mark.parametrize("path", [*PROBLEMS[::EVERY], *SEVERAL_REGIMES], ids=name_of)
def test_a_body_is_drawn_where_the_page_has_it(path: Path) -> None:
    for part in worked(path)[0].parts:
        if part.motion is None:
            continue
        for state, body, symbol, axis in places_of(part.motion):
            there = Drawn.in_state(part.motion, state)
            if there is not None and (told := part.motion.value.known(symbol)) is not None:
                spot = there.spot(there.scene.bodies[body].center)
                assert spot is not None
                assert spot[axis] == pytest.approx(float(told), abs=1e-9), (state, body)


@cache
def scene_of(path: Path) -> tuple[Figure, PartSolution] | None:
    """The arrangement of a file with the part of its solution that it shows."""
    solution = worked(path)[0]
    drawn = dict(figures_of(illustrated(narrate(solution), solution)))
    part = next((part for part in solution.parts if part.instants), None)
    return (drawn["scene"], part) if "scene" in drawn and part is not None else None


@pytest.mark.parametrize("path", [*PROBLEMS[::EVERY], *SEVERAL_REGIMES], ids=name_of)
def test_every_state_whose_places_are_known_is_drawn_once(path: Path) -> None:
    found = scene_of(path)
    if found is None:
        return
    figure, part = found
    tags = [(m.at, m.words) for m in figure.panels[0].marks if isinstance(m, Tag)]
    assert len(set(tags)) == len(tags)
    words = {w.text for _, told in tags for w in told if isinstance(w, Text)}
    told = {name for text in words for name in text.split(JOINED)}
    for name in part.motion.states if part.motion is not None else ():
        there, first = (Drawn.in_state(part.motion, s) for s in (name, part.motion.states[0]))
        if there is not None and first is not None and name in {s.name for s in part.motion.problem.states}:
            moved = any(far(there, first, body) for body in there.scene.bodies)
            assert not moved or name.replace("_", " ") in told, (name, told)


def far(there: Drawn, first: Drawn, body: str) -> bool:
    """Is a body in another place, so that it is seen?"""
    here, before = (d.spot(d.scene.bodies[body].center) for d in (there, first))
    size = max(map(abs, before or (0.0, 0.0)))
    return here is not None and before is not None and max(map(abs, here)) > 10 * size + 1e-3


@pytest.mark.parametrize("path", [*PROBLEMS[::EVERY], *SEVERAL_REGIMES], ids=name_of)
def test_no_scene_is_some_dots(path: Path) -> None:
    """Beside points and names there are at least two marks, or a way."""
    found = scene_of(path)
    if found is None:
        return
    (panel,) = found[0].panels
    seen = [m for m in panel.marks if not isinstance(m, Tag | Axes) and not (isinstance(m, Symbol) and m.kind in DOTS)]
    assert len(seen) > 1 or any(isinstance(m, Polyline) for m in seen), panel.marks


def test_a_throw_has_its_way_its_velocity_its_heights_and_the_ground() -> None:
    found = scene_of(named("hose-over-a-wall"))
    assert found is not None
    marks = found[0].panels[0].marks
    assert sum(isinstance(m, Polyline) and m.style == "way" for m in marks) == 3
    assert [m.words for m in marks if isinstance(m, Arrow)] == [line(Name("v_0"))]
    assert [m.words for m in marks if isinstance(m, Dimension)] == [line(Name(n)) for n in ("h", "d", "x_ground")]
    assert len([m for m in marks if isinstance(m, Hatched)]) == 1


def test_bodies_that_meet_are_side_by_side() -> None:
    """A comes from the left, B from the right, along a line of 30 degrees."""
    found = scene_of(named("pucks-at-an-angle"))
    assert found is not None
    (first, second) = (m.at for m in found[0].panels[0].marks if isinstance(m, Symbol) and m.kind == "particle")
    assert first[0] < second[0]
    assert math.dist(first, second) > 0
    assert (second[1] - first[1]) / (second[0] - first[0]) == pytest.approx(math.tan(math.radians(30)))


@pytest.mark.parametrize(
    ("stem", "letter", "start", "sense"),
    [
        ("ladder-leaving-the-wall", "theta", 0.0, 1),
        ("simple-pendulum", "theta", -math.pi / 2, 1),
        ("bob-on-a-cart", "phi", -math.pi / 2, 1),
        ("rod-in-a-carriage", "beta", -math.pi / 2, -1),
        ("burn-into-a-round-orbit", "gamma", math.pi / 2, -1),
    ],
)
def test_an_angle_is_drawn_from_its_zero(stem: str, letter: str, start: float, sense: int) -> None:
    found = scene_of(named(stem))
    assert found is not None
    (angle,) = (m for m in found[0].panels[0].marks if isinstance(m, Angle))
    assert letter in str(angle.words)
    assert angle.start == pytest.approx(start)
    assert angle.sweep * sense > 0


def test_a_motion_that_is_followed_in_numbers_alone_has_its_scene() -> None:
    """A block that rocks about one edge and then about the other: in every state a corner is on the floor."""
    solution = worked(ROOT / "problems" / "hard" / "block-that-rocks.yaml")[0]
    assert not any(part.instants for part in solution.parts)
    scene = dict(figures_of(illustrated(narrate(solution), solution)))["scene"]
    outlines = [m for m in scene.panels[0].marks if isinstance(m, Polyline) and m.closed]
    assert len(outlines) == 3
    for outline in outlines:
        assert min(y for _, y in outline.places) == pytest.approx(0, abs=1e-6)


def test_a_ball_that_only_strikes_the_floor_is_no_block_on_it() -> None:
    solution = worked(ROOT / "problems" / "hard" / "ball-that-comes-to-rest.yaml")[0]
    marks = dict(figures_of(illustrated(narrate(solution), solution)))["scene"].panels[0].marks
    assert [m.kind for m in marks if isinstance(m, Symbol)] == ["particle", "point", "place"]


def test_nothing_to_draw_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "pulse.yaml"
    text = (
        "coordinates: {x: m}\nmotion: [dot(x) = 2 m/s]\nstates: {1: [t = 0, x = 0], 2: [t = 1 s]}\nfind: {x: x @ 2}\n"
    )
    path.write_text(text)
    assert command.callback is not None
    assert command.callback((str(path),), str(tmp_path), "svg", 60.0) == UNDECIDED
    assert "nothing to draw" in capsys.readouterr().err


def marks_of(stem: str) -> tuple[Mark, ...]:
    found = scene_of(named(stem))
    assert found is not None
    return found[0].panels[0].marks


def test_a_rope_that_is_slack_at_first_hangs_in_waves() -> None:
    ropes = [m for m in marks_of("falling-rod-caught-by-a-cord") if isinstance(m, Polyline) and m.style == "rope"]
    assert [len(rope.places) > 20 for rope in ropes] == [True]


def test_what_a_body_hangs_on_is_drawn_in_later_states_too() -> None:
    hidden = [m for m in marks_of("bullet-in-a-hanging-block") if isinstance(m, Polyline) and m.style == "hidden"]
    assert [m.places[0] for m in hidden] == [(0, 0)]


def test_a_groove_goes_through_the_ball_in_it() -> None:
    (groove,) = (m for m in marks_of("ball-in-a-forked-slot") if isinstance(m, Polyline) and m.style == "lane")
    assert min(math.dist(spot, (-0.8, 0)) for spot in groove.places) < 1e-6
    assert math.dist(groove.places[0], groove.places[-1]) < 1e-6


def test_a_point_beside_its_rod_is_held_and_one_on_it_is_seen() -> None:
    coupler = [m for m in marks_of("coupler-point-of-a-four-bar") if isinstance(m, Polyline) and m.style == "thin"]
    assert [len(m.places) for m in coupler] == [3]
    rings = [m for m in marks_of("slider-crank-offset") if isinstance(m, Symbol) and m.kind == "ring"]
    assert len(rings) == 1


def test_a_hoop_is_no_disk() -> None:
    assert [m.hollow for m in marks_of("bead-on-a-turning-hoop") if isinstance(m, Arc)] == [True]


def test_an_acceleration_that_rests_on_the_velocity_is_given_too() -> None:
    """a = -k v has a name in the figure, and no number of its own."""
    assert any(isinstance(m, Arrow) for m in marks_of("boat-coasting"))


def test_what_stands_on_a_slope_is_on_its_upper_side() -> None:
    (slope,) = (m for m in marks_of("body-block-sent-up-a-slope") if isinstance(m, Hatched))
    assert slope.places[0][0] < slope.places[-1][0]


def test_the_instant_of_a_motion_in_time_is_drawn_at_its_time_with_the_way_to_it() -> None:
    """r = 2 m + t/2, θ = t²/5 at t = 2 s: 3 m at 0.8 rad."""
    marks = marks_of("polar-motion")
    (way,) = (m.places for m in marks if isinstance(m, Polyline) and m.style == "way")
    assert way[0] == pytest.approx((2, 0))
    assert way[-1] == pytest.approx((3 * math.cos(0.8), 3 * math.sin(0.8)))
    assert any(isinstance(m, Symbol) and m.at == pytest.approx(way[-1]) for m in marks)


def test_a_way_by_coordinates_that_are_formulas_of_the_time() -> None:
    """x = 3 t, y = 4 t - t²/2, where P is at t = 2 s; the path that is asked for goes on beyond it."""
    (way,) = (m.places for m in marks_of("parabola-in-time") if isinstance(m, Polyline) and m.style == "way")
    assert way[0] == pytest.approx((0, 0))
    assert way[len(way) // 2] == pytest.approx((6, 6))
    assert way[-1] == pytest.approx((12, 8))


def test_a_bob_goes_round_the_nail_on_the_circle_of_the_short_cord() -> None:
    ways = [
        m.places for m in marks_of("bob-whose-cord-catches-on-a-nail") if isinstance(m, Polyline) and m.style == "way"
    ]
    assert len(ways) == 2
    nail, last = (0.0, -1.2), ways[1]
    assert all(math.dist(nail, s) == pytest.approx(0.8) for s in last)
    assert last[0] == pytest.approx((0.0, -2.0))
    assert min(x for x, _ in last) == pytest.approx(-0.8, abs=0.01), "on to the left, as it came"


def test_a_flight_is_a_parabola_where_it_is_broken_too() -> None:
    (way,) = (m.places for m in marks_of("ball-on-a-rough-floor") if isinstance(m, Polyline) and m.style == "way")
    rise, length = max(y for _, y in way) - way[0][1], way[-1][0] - way[0][0]
    assert rise / length == pytest.approx(3 / 4.6 / 4, rel=1e-3), "v_y / v_x / 4"


def test_flights_in_a_scene_of_letters_are_bent() -> None:
    marks = marks_of("ex-1-15")
    ways = [m.places for m in marks if isinstance(m, Polyline) and m.style == "way"]
    assert all(math.dist(way[-1], ways[0][-1]) < 1e-9 for way in ways), "they meet"
    a = next(w for w in ways if w[0] != (0.0, 0.0))
    first = (a[1][0] - a[0][0], a[1][1] - a[0][1])
    assert math.degrees(math.atan2(first[1], first[0])) == pytest.approx(30, abs=1), "as it is thrown"
    assert max(y for _, y in a) > a[-1][1] + 0.05


def test_what_acts_later_or_is_nothing_only_at_first_is_drawn() -> None:
    """A blow between two states; a force that grows with the time."""
    for stem in ("ex-4-13", "ex-4-12"):
        solution = worked(named(stem))[0]
        scene = dict(figures_of(illustrated(narrate(solution), solution)))["scene"]
        arrows = [m for m in scene.panels[0].marks if isinstance(m, Arrow) and m.style == "force"]
        assert len(arrows) == 1, stem


def test_what_is_drawn_nearer_goes_on_in_its_own_sense() -> None:
    """A truck runs 50 m to the right and stands, a crate slides on it by 13 m and 5 m more."""
    marks = marks_of("crate-that-slides-on-a-braking-truck")
    tags = {tuple(m.words): m.at[0] for m in marks if isinstance(m, Tag) and m.at[1] < 0.5}
    assert tags[line("2")] == tags[line("3")] > tags[line("1")]


def test_springs_of_later_states_do_not_lie_beside_the_first_as_further_ones() -> None:
    marks = marks_of("weight-dropped-on-nested-springs")
    coils = [m for m in marks if isinstance(m, Coil)]
    assert len(coils) == 2
    assert coils[0].lane * coils[1].lane < 0, "the two are beside each other"
    plates = [m.aside for m in marks if isinstance(m, Symbol) and m.kind == "plate"]
    assert plates[0] * plates[1] < 0, "with the plates at their ends"


def test_what_will_stick_is_drawn_where_it_comes_from() -> None:
    """A bullet before the side of the block; a bag that is thrown into a cart from above, along its way."""
    for stem, angle in (("bullet-stays-in-a-block", 0), ("sandbag-into-a-cart", -40)):
        marks = marks_of(stem)
        (particle,) = [m for m in marks if isinstance(m, Symbol) and m.kind == "particle"]
        (way,) = [m for m in marks if isinstance(m, Arrow) and m.inward]
        assert math.degrees(way.angle) == pytest.approx(angle), stem
        assert particle.at[0] < 0 < particle.at[1], stem
        assert not any(isinstance(m, Symbol) and m.kind == "weld" for m in marks), stem


def test_links_on_one_pin_have_one_support() -> None:
    """One hangs and one slants: the support is above both."""
    (support,) = [m for m in marks_of("two-pendulums-that-collide") if isinstance(m, Symbol) and m.kind == "support"]
    assert support.angle == math.pi


def test_opposite_arrows_on_one_line_have_one_side_each() -> None:
    """A jet that comes to a vane, and the force that holds it."""
    comes, force = (m for m in marks_of("jet-on-a-vane") if isinstance(m, Arrow) and m.at == (0.0, 0.0))
    assert (comes.inward, force.inward) == (True, False)
    assert comes.aside == force.aside > 0


def test_a_straight_path_of_a_linkage_is_drawn_as_far_as_it_goes() -> None:
    marks = marks_of("straight-line-linkage-of-peaucellier")
    (way,) = (m.places for m in marks if isinstance(m, Polyline) and m.style == "way")
    assert [x for x, _ in way] == pytest.approx([0.54] * len(way))
    (p,) = (m.at for m in marks if isinstance(m, Tag) and m.words == line(Name("P")))
    assert way[0][1] < p[1] < way[-1][1] or way[0][1] > p[1] > way[-1][1]


def test_an_edge_that_a_body_strikes_is_a_step_in_the_ground() -> None:
    """A kerb of the height that is given; a sill before a lower corner; neither has a pin."""
    for stem, rises in (("wheel-over-a-kerb", 0.06), ("box-that-tips-over", None)):
        marks = marks_of(stem)
        (ground,) = [m.places for m in marks if isinstance(m, Hatched)]
        assert not any(isinstance(m, Symbol) and m.kind == "support" for m in marks), stem
        assert ground[0][1] == ground[1][1], stem
        assert ground[1][0] == ground[2][0] > ground[0][0], stem
        assert ground[-1][1] - ground[0][1] == pytest.approx(rises or 0.0), stem


def test_a_force_that_is_written_with_a_minus_is_drawn_the_way_it_acts() -> None:
    """The two parts of a shell push each other away."""
    one, other = (m for m in marks_of("shell-that-bursts-in-two") if isinstance(m, Arrow) and m.style == "force")
    assert one.words == other.words == line(Name("J"))
    assert math.cos(one.angle - other.angle) == pytest.approx(-1)


def test_the_height_of_a_particle_at_a_place_without_a_name_is_dimensioned() -> None:
    told = [m.words for m in marks_of("throw-at-a-basketball-ring") if isinstance(m, Dimension)]
    assert line(Name("h")) in told
    beside = [m.words for m in marks_of("pucks-at-an-angle") if isinstance(m, Dimension)]
    assert not beside, "drawn beside their place, which is where they meet"
    broken = [m for m in marks_of("ball-through-a-window") if isinstance(m, Symbol) and m.kind == "break"]
    assert not broken, "no larger, as a scene, than the ball"


def test_a_mechanism_that_starts_in_a_dead_position_is_drawn_in_another_one() -> None:
    marks = marks_of("body-slider-crank-over-time")
    assert [m.words for m in marks if isinstance(m, Angle)] == [line(Name("theta"))]
    names = {"".join(p.text for p in m.words if isinstance(p, Text)) for m in marks if isinstance(m, Tag)}
    assert names >= {"start", "at 8", "fastest", "inner"}
