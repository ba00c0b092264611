"""Bodies in figures: each has an outline, what it stands on lies under it, and forces begin on it."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from conftest import PROBLEMS
from worked import worked

from planar_cli.figures.drawn import Drawn
from planar_cli.figures.illustrated import figures_of, illustrated
from planar_cli.figures.outlines import outlines
from planar_cli.figures.rings import inside, meets
from planar_cli.formats._on_paper import Scale, on_paper
from planar_cli.formats._paper import Stroke
from planar_cli.formats._svg import papers_of
from planar_cli.report.document.blocks import Name, line
from planar_cli.report.document.marks import (
    Angle,
    Arc,
    Arrow,
    Coil,
    Dashpot,
    Dimension,
    Figure,
    Hatched,
    Panel,
    Polyline,
    Slot,
    Spot,
    Symbol,
    Tag,
    Turn,
)
from planar_cli.report.page.narrate import narrate


def drawings(name: str) -> dict[str, Figure]:
    path = next(p for p in PROBLEMS if p.match(f"{name}.yaml"))
    solution = worked(path)[0]
    return dict(figures_of(illustrated(narrate(solution), solution)))


def areas(figure: Figure) -> list[tuple[Spot, ...]]:
    return [m.places for m in figure.panels[0].marks if isinstance(m, Polyline) and m.closed and m.style == "body"]


def test_a_wedge_reaches_from_its_face_to_the_floor_under_it() -> None:
    found = drawings("particles/block-on-wedge")
    (wedge,) = areas(found["scene"])
    (floor,) = (m.places for m in found["scene"].panels[0].marks if isinstance(m, Hatched))
    assert min(y for _, y in wedge) == pytest.approx(floor[0][1]) == pytest.approx(floor[1][1])
    assert inside(wedge, (0.0, 0.0), 0.01), "the mass centre"
    assert any(abs(d) < 1e-9 for d in meets(wedge, (0.0, 1.0), 0.0)), "the block stands on the face"
    assert [m.kind for m in found["scene"].panels[0].marks if isinstance(m, Symbol) and m.kind == "block"]
    (drawn,) = areas(found["wedge"])
    for arrow in (m for m in found["wedge"].panels[0].marks if isinstance(m, Arrow)):
        on_edge = any(abs(d) < 1e-6 for d in meets(drawn, arrow.at, arrow.angle))
        assert on_edge or inside(drawn, arrow.at), arrow


@pytest.mark.parametrize(
    ("name", "body", "center"),
    [("textbook/ex-4-18", "frame", "G"), ("friction/car-with-locked-wheels", "car", "G")],
)
def test_a_carrier_is_a_box_with_its_mass_centre_inside(name: str, body: str, center: str) -> None:
    path = next(p for p in PROBLEMS if p.match(f"{name}.yaml"))
    instant = next(i for part in worked(path)[0].parts for i in part.instants)
    drawn = Drawn.as_in_the_file(instant)
    (box,) = outlines(drawn, drawn.scene.bodies[body])
    at = drawn.spot(drawn.scene.points[center])
    assert len(box.places) == 4
    assert at is not None
    assert inside(box.places, at, 0.01)


def test_a_guided_box_stands_on_a_floor_and_no_rail_runs_through_it() -> None:
    (panel,) = drawings("friction/crate-on-cart")["scene"].panels
    assert not [m for m in panel.marks if isinstance(m, Symbol) and m.kind in ("rail", "slider")]
    (floor,) = (m.places for m in panel.marks if isinstance(m, Hatched))
    assert floor[0][1] == pytest.approx(-0.15)


def test_a_piston_keeps_its_rails() -> None:
    (panel,) = drawings("kinematics/slider-crank-offset")["scene"].panels
    assert sum(isinstance(m, Slot) for m in panel.marks) == 1
    assert [m.kind for m in panel.marks if isinstance(m, Symbol)].count("slider") == 1


def test_a_point_over_which_a_rope_runs_is_a_wheel_that_hangs_from_above() -> None:
    (panel,) = drawings("particles/moving-pulley")["scene"].panels
    wheels = [m for m in panel.marks if isinstance(m, Arc) and m.style in ("body", "thin")]
    assert sorted(w.center for w in wheels) == [(pytest.approx(0.13, abs=0.01), -1.2), (0.4, 0.0)]
    (hanger,) = (m for m in panel.marks if isinstance(m, Symbol) and m.kind == "hanger")
    assert (hanger.at[0], hanger.angle) == (0.4, pytest.approx(math.pi / 2))
    ropes = [m.places for m in panel.marks if isinstance(m, Polyline) and m.style == "rope"]
    assert all(math.dist(ropes[1][i], wheels[i].center) == pytest.approx(wheels[i].radius) for i in (0, 1))
    (wall,) = (m for m in panel.marks if isinstance(m, Symbol) and m.kind == "wall")
    assert math.sin(2 * wall.angle) == pytest.approx(0, abs=1e-9), "upright, or level"


def test_an_arrow_along_a_bar_lies_on_a_light_bar() -> None:
    figure = drawings("textbook/ex-4-06")["rod"]
    assert {m.style for p in figure.panels for m in p.marks if isinstance(m, Polyline)} == {"slim"}


def test_each_dimension_line_has_its_words_within_it() -> None:
    (paper,) = papers_of(drawings("systems/rear-wheel-drive")["scene"])
    lengths = [p for p in paper.placed if p.words.within]
    assert len(lengths) >= 2
    for placed in lengths:
        x, y = placed.words.anchor
        assert placed.box.left < x < placed.box.right
        assert placed.box.top < y < placed.box.bottom


def test_the_arrow_of_a_couple_keeps_off_the_rim_about_which_it_is() -> None:
    wheel, couple = Arc((0.0, 0.0), 0.17, "body"), Turn((0.0, 0.0), 1, "force", line("M"))
    paper = on_paper(Panel((wheel, couple, couple)), Scale(100.0))
    strokes = [s for s in paper.strokes if isinstance(s, Stroke) and s.kind == "force"]
    radii = sorted(math.hypot(*s.places[0]) for s in strokes)
    assert all(abs(b - a) >= 5.0 for a, b in pairwise(radii))
    assert all(abs(r - 17.0) >= 5.0 for r in radii)


def test_spring_and_damper_lie_side_by_side_and_end_at_the_body() -> None:
    (panel,) = drawings("oscillations/quarter-car-on-a-washboard")["scene"].panels
    coil, damper = (next(m for m in panel.marks if isinstance(m, kind)) for kind in (Coil, Dashpot))
    assert abs(coil.lane - damper.lane) >= 15.0
    (block,) = (m for m in panel.marks if isinstance(m, Symbol) and m.kind == "block")
    assert coil.cuts[0] > 0.0, "at the box of the wheel"
    assert (coil.end, block.angle) == (block.at, 0.0), "under the car"


def test_a_buffer_ends_at_its_own_length_with_a_plate() -> None:
    (panel,) = drawings("energy/block-down-a-slope-onto-a-buffer")["scene"].panels
    coil = next(m for m in panel.marks if isinstance(m, Coil) and not m.later)
    plate = next(m for m in panel.marks if isinstance(m, Symbol) and m.kind == "plate")
    (block,) = (m for m in panel.marks if isinstance(m, Symbol) and m.kind == "block")
    assert plate.at == coil.end
    assert math.dist(plate.at, block.at) > math.dist(coil.start, coil.end)
    assert abs(coil.aside) == abs(plate.aside) == 10.0


@pytest.mark.parametrize("name", ["systems/slab-on-rollers", "friction/crate-on-cart"])
def test_a_face_that_is_an_edge_of_its_body_is_not_drawn_beyond_it(name: str) -> None:
    (panel,) = drawings(name)["scene"].panels
    assert not [m for m in panel.marks if isinstance(m, Polyline) and not m.closed and m.style == "body"]


def test_a_crawler_has_an_endless_belt_round_its_wheels() -> None:
    (panel,) = drawings("systems/crawler-track")["scene"].panels
    belts = [m.places for m in panel.marks if isinstance(m, Polyline) and len(m.places) > 10]
    assert [belt[0] == belt[-1] for belt in belts] == [True]


def test_a_stream_is_drawn_with_its_speed() -> None:
    (panel,) = drawings("momentum/pipe-bend")["scene"].panels
    flows = [m for m in panel.marks if isinstance(m, Arrow) and m.style == "velocity"]
    assert [str(m.words) for m in flows] == [str((Name("v_A"),)), str((Name("v_B"),))]


def test_a_belt_runs_over_rollers_and_has_an_arrow() -> None:
    (panel,) = drawings("kinematics/wheel-on-conveyor")["scene"].panels
    assert not [m for m in panel.marks if isinstance(m, Hatched)]
    assert (Name("u"),) in [m.words for m in panel.marks if isinstance(m, Arrow)]


def test_a_frame_of_reference_has_axes() -> None:
    (panel,) = drawings("kinematics/car-seen-from-a-bend")["scene"].panels
    assert [m.words for m in panel.marks if isinstance(m, Arrow) and m.style == "axis"] == [
        (Name("x\u2032"),),
        (Name("y\u2032"),),
    ]


@pytest.mark.parametrize(
    "name",
    [
        "particles/moving-pulley",
        "systems/two-stage-atwood-machine",
        "kinematics/three-blocks-on-one-cable",
        "energy/load-on-four-strands",
        "systems/heavy-disk-in-the-bight-of-a-rope",
        "motion/hoist-after-three-seconds",
    ],
)
def test_ropes_of_one_direction_are_drawn_parallel(name: str) -> None:
    marks = drawings(name)["scene"].panels[0].marks
    ropes = [m.places for m in marks if isinstance(m, Polyline) and m.style == "rope"]
    assert len(ropes) > 2
    assert all(abs(a[0] - b[0]) < 1e-3 * math.dist(a, b) for a, b in ropes)
    spots = [m.at for m in marks if isinstance(m, Symbol) and m.kind in ("particle", "block", "slider", "wall")]
    radii = [(m.center, m.radius) for m in marks if isinstance(m, Arc)]
    for end in (s for rope in ropes for s in rope):
        held = any(math.dist(end, s) < 1e-6 for s in spots)
        assert held or any(math.dist(end, c) == pytest.approx(r, rel=1e-3) for c, r in radii)


def test_a_couple_between_two_bodies_turns_each_its_way() -> None:
    turns = [m for m in drawings("textbook/ex-4-18")["scene"].panels[0].marks if isinstance(m, Turn)]
    assert [t.sense for t in turns] == [1, -1]
    assert turns[0].at != turns[1].at
    assert repr(turns[0].words) == repr(turns[1].words)


@pytest.mark.parametrize("name", ["textbook/ex-4-10", "textbook/ex-4-13"])
def test_an_angle_that_is_negative_is_drawn_with_the_sign_of_its_letter(name: str) -> None:
    (angle,) = (m for m in drawings(name)["scene"].panels[0].marks if isinstance(m, Angle) and Name("theta") in m.words)
    assert angle.sweep < 0
    assert angle.words == line("-", Name("theta"))


def test_a_length_below_the_axis_is_told_without_its_sign() -> None:
    marks = drawings("motion/atwood-let-go")["scene"].panels[0].marks
    (drop,) = (m.words for m in marks if isinstance(m, Dimension))
    assert drop[1:] == line(" + ", Name("s"))


@pytest.mark.parametrize(
    ("name", "above"),
    [("textbook/ex-4-13", True), ("impact/bullet-into-a-hanging-panel", True), ("kinematics/quick-return", False)],
)
def test_a_support_lies_on_the_side_away_from_what_hangs_on_it(name: str, above: bool) -> None:
    marks = drawings(name)["scene"].panels[0].marks
    supports = [m for m in marks if isinstance(m, Symbol) and m.kind == "support"]
    assert supports
    assert all((math.cos(m.angle) < 0) is above for m in supports)


def test_the_name_of_a_body_stands_beside_it() -> None:
    marks = drawings("kinematics/planetary-gear")["scene"].panels[0].marks
    at = {"".join(getattr(p, "text", "") for p in m.words): m.at for m in marks if isinstance(m, Tag)}
    assert 0.06 < math.hypot(*at["annulus"]) <= 0.1201, "not within the sun"
    assert math.hypot(*at["sun"]) < 0.06
    marks = drawings("kinematics/quick-return")["scene"].panels[0].marks
    at = {"".join(getattr(p, "text", "") for p in m.words): m.at for m in marks if isinstance(m, Tag)}
    bars = {m.places[0]: m.places for m in marks if isinstance(m, Polyline) and m.style == "body"}
    (pin,) = (m.at for m in marks if isinstance(m, Symbol) and m.kind == "slider")
    for name in ("arm", "crank"):
        near = [
            bar
            for bar in bars.values()
            if math.dist(bar[0], at[name]) + math.dist(at[name], bar[-1]) < math.dist(bar[0], bar[-1]) * 1.001
        ]
        assert len(near) == 1, "on its own bar, and not where both are"
        assert math.dist(at[name], pin) > 0.05


def test_a_rotation_about_a_fixed_pin_is_drawn_there() -> None:
    marks = drawings("kinematics/pin-where-two-slots-cross")["scene"].panels[0].marks
    supports = {m.at for m in marks if isinstance(m, Symbol) and m.kind == "support"}
    assert {m.at for m in marks if isinstance(m, Turn)} == supports
    marks = drawings("kinematics/planetary-gear")["scene"].panels[0].marks
    told = {repr(m.words) for m in marks if isinstance(m, Turn)}
    assert len(told) == 2
    assert all("omega_" in words for words in told), "whose each is, where two turn about one place"


def test_a_block_on_a_wedge_slides_between_its_guides() -> None:
    marks = drawings("friction/wedge-driven-under-a-block")["scene"].panels[0].marks
    (walls,) = (m for m in marks if isinstance(m, Symbol) and m.kind == "guides")
    (block,) = (m for m in marks if isinstance(m, Symbol) and m.kind == "block")
    assert abs(math.sin(walls.angle)) == pytest.approx(1)
    assert block.at == walls.at
    assert math.sin(block.angle + block.lean + math.pi / 2) == pytest.approx(1), "its sides are upright"


def test_the_ground_is_not_where_a_surface_presses_a_particle() -> None:
    marks = drawings("bead-in-loop")["scene"].panels[0].marks
    (loop,) = (m.places for m in marks if isinstance(m, Hatched))
    middle = len(loop) // 2
    (x, y), (u, v) = loop[middle], loop[middle + 1]
    assert -(x * (v - y) - y * (u - x)) < 0, "counterclockwise about O: hatched on its outside"


def test_a_curve_is_drawn_from_where_its_formula_begins() -> None:
    marks = drawings("textbook/ex-1-13")["scene"].panels[0].marks
    (track,) = (m.places for m in marks if isinstance(m, Polyline) and m.style == "lane")
    assert min(x for x, _ in track) < 0
    assert max(x for x, _ in track) > 2


def test_a_cord_in_a_horizontal_plane_runs_straight_to_a_hole() -> None:
    marks = drawings("momentum/puck-drawn-in-through-a-hole")["scene"].panels[0].marks
    assert not [m for m in marks if isinstance(m, Symbol) and m.kind == "hanger"]
    ropes = [m.places for m in marks if isinstance(m, Polyline) and m.style == "rope"]
    assert ropes[0][1] == ropes[1][0]


def test_what_hangs_over_a_peg_hangs_straight_down() -> None:
    marks = drawings("wheel-pulled-uphill")["scene"].panels[0].marks
    ropes = [m.places for m in marks if isinstance(m, Polyline) and m.style == "rope"]
    hangs = [(a, b) for a, b in ropes if abs(a[0] - b[0]) < 1e-9 * math.dist(a, b)]
    assert hangs
    ground = next(m.places for m in marks if isinstance(m, Hatched))
    slope = math.atan2(ground[-1][1] - ground[0][1], ground[-1][0] - ground[0][0])
    others = [math.atan2(b[1] - a[1], b[0] - a[0]) for a, b in ropes if (a, b) not in hangs]
    assert others
    assert all(math.sin(way - slope) == pytest.approx(0, abs=1e-6) for way in others), "parallel to the slope"


@pytest.mark.parametrize("name", ["cart-with-a-block-on-top-and-one-in-front", "rope-pulled-by-a-walker"])
def test_a_rope_over_a_corner_runs_as_it_does_in_the_file(name: str) -> None:
    marks = drawings(name)["scene"].panels[0].marks
    ropes = [m.places for m in marks if isinstance(m, Polyline) and m.style == "rope"]
    upright = [(a, b) for a, b in ropes if abs(a[0] - b[0]) < 1e-9 * math.dist(a, b)]
    level = [(a, b) for a, b in ropes if abs(a[1] - b[1]) < 1e-9 * math.dist(a, b)]
    assert upright
    assert level or name == "rope-pulled-by-a-walker"
