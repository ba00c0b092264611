"""What a diagram shows beside its forces: points of moments, which directions are assumed."""

from __future__ import annotations

import math
import re

import pytest
from conftest import PROBLEMS
from test_figures import illustrated_page

from planar_cli.figures.lanes import in_lanes
from planar_cli.formats._drawn_small import small_drawing
from planar_cli.formats._svg import panels, svg
from planar_cli.formats._tikz import tikz
from planar_cli.formats.html import Html
from planar_cli.report.document.blocks import Document, Drawing, Forces, Inline, Math, Name, Text, line
from planar_cli.report.document.marks import Angle, Arc, Arrow, Dimension, Figure, Polyline, Symbol, Tag, Turn

DASHED = "dashed: direction assumed"
NOTES = ("", DASHED, f"{DASHED}; found: F_D to the left")
PULLEY = ("found: a_Ay*m_A downward", "", "found: I_pulley*alpha clockwise, a_Ay*m_A downward")


def plain(piece: Inline) -> str:
    return piece.text if isinstance(piece, Text) else str(piece.expr) if isinstance(piece, Math) else ""


def diagrams(stem: str) -> list[Figure]:
    page = illustrated_page(next(p for p in PROBLEMS if p.stem == stem))
    pairs = zip(page.blocks, page.blocks[1:], strict=False)
    return [b.figure for before, b in pairs if isinstance(before, Forces) and isinstance(b, Drawing)]


def styles(figure: Figure) -> list[str]:
    """That of the arrows of each panel."""
    return [style for p in figure.panels for style in dict.fromkeys(m.style for m in p.marks if isinstance(m, Arrow))]


@pytest.mark.parametrize(
    ("stem", "dashed"),
    [
        ("ex-4-16", ([2, 0],)),
        ("ladder-leaving-the-wall", ([2, 0], [1, 1])),
        ("ladder-sliding", ([2, 0],)),
    ],
)
def test_the_point_of_moments_is_in_both_diagrams_with_the_lines_that_meet_there(
    stem: str, dashed: tuple[list[int], ...]
) -> None:
    """Of each body of the group; of a normal force with its friction it is the line of the total reaction."""
    found = diagrams(stem)
    assert all(
        sum(isinstance(m, Tag) and m.words == line(Name("C")) for m in p.marks) == 1 for f in found for p in f.panels
    )
    ways = [[sum(isinstance(m, Polyline) and m.style == "way" for m in p.marks) for p in f.panels] for f in found]
    assert ways == [*dashed]


def test_a_point_of_the_file_about_which_moments_are_taken_stands_in_both() -> None:
    (free, kinetic) = diagrams("toppling-pole-whose-foot-slips")[0].panels
    assert all(any(isinstance(m, Tag) and m.words == line(Name("A")) for m in p.marks) for p in (free, kinetic))


@pytest.mark.parametrize(
    ("stem", "dashed", "notes"),
    [
        ("ball-pushed-without-friction", [1], ["dashed: direction assumed; found: F_C to the left"]),
        ("bicycle-driven-and-braked", [0, 1, 1], [*NOTES]),
        ("ex-4-16", [0], ["found: a_Gy*m downward"]),
        ("double-pulley", [0, 0, 0], [*PULLEY]),
        ("box-that-tips-over", [0], ["found: J_x to the left"]),
        ("pipe-bend", [0], ["found: flange_x to the left"]),
    ],
)
def test_an_assumed_direction_is_dashed_and_told_where_it_came_out_opposite(
    stem: str, dashed: list[int], notes: list[str]
) -> None:
    """Also in a motion, of a force that stays what it is; of accelerations and impulses as well."""
    found = diagrams(stem)
    assert [sum(isinstance(m, Arrow) and m.assumed for p in f.panels for m in p.marks) for f in found] == dashed
    assert ["".join(plain(p) for p in f.note) for f in found] == notes


def test_the_note_stands_under_a_figure_in_each_format() -> None:
    page = illustrated_page(next(p for p in PROBLEMS if p.stem == "ball-pushed-without-friction"))
    (one,) = (b for b in page.blocks if isinstance(b, Drawing) and b.figure.note)
    assert "dashed: direction assumed; found: FC to the left" in re.sub("<[^>]*>", "", svg(one.figure))
    assert all("assumed" not in panel for panel in panels(one.figure))
    assert "dashed: direction assumed; found: " in tikz(one.figure)
    assert "<figcaption>dashed: direction assumed; found: <math" in Html().render(page)
    assert "  dashed: direction assumed; found: F_C to the left" in small_drawing(one.figure, 80)


def test_a_blow_is_momentum_before_and_impulses_and_momentum_after() -> None:
    """Each in its colour; what is at rest before the blow has no momentum there, and what looks the same in a later
    case is drawn once.
    """
    block, (bullet, _) = diagrams("ball-hits-a-hanging-rod")[0], diagrams("bullet-in-a-hanging-block")
    assert [styles(f) for f in (block, bullet)] == [["force", "velocity"], ["velocity", "force", "velocity"]]
    assert [f.between for f in (block, bullet)] == ["=", "+="]
    assert [p.head for p in bullet.panels] == [line(h) for h in ("momentum before", "impulses", "momentum after")]
    assert re.findall(r'class="between">(.)', Html().render(Document("", (Drawing(bullet),)))) == ["+", "="]
    assert any(re.search(r" \+ .* =", row) for row in small_drawing(bullet, 80))
    assert {"+", "="} <= {row.strip() for row in small_drawing(bullet, 24)}
    drawn = [f for f in diagrams("rod-that-slips-down-until-it-lies-flat") if len(f.panels) > 1]
    assert styles(drawn[0]) == ["force", "inertia"]


def test_forces_along_one_line_stand_side_by_side() -> None:
    """Both strands of a cord on both sides of the weight."""
    told = [Arrow((0.0, 0.0), -math.pi / 2, "force", line(word)) for word in ("T", "m g", "T")]
    asides = [m.aside for m in in_lanes(told) if isinstance(m, Arrow)]
    assert asides[0] == -asides[2] != 0 == asides[1]


@pytest.mark.parametrize(("case", "far"), [(0, 0.2), (1, 0.3)])
def test_a_normal_force_beside_the_middle_of_its_face_stands_where_it_was_found(case: int, far: float) -> None:
    marks = diagrams("crate-that-slips-or-tips")[case].panels[0].marks
    (normal,) = [m for m in marks if isinstance(m, Arrow) and plain(m.words[0]) == "N_C"]
    (x,) = [m for m in marks if isinstance(m, Dimension)]
    assert x.start == (0.0, 0.0)
    assert x.end == normal.at == pytest.approx((far, 0.0))


def test_a_force_of_which_the_line_is_not_needed_presses_on_its_body() -> None:
    """From below, on what lies within it; the line itself lies beside the carriage."""
    marks = diagrams("jet-on-a-vane")[0].panels[0].marks
    (normal,) = [m for m in marks if isinstance(m, Arrow) and plain(m.words[0]) == "N_track"]
    (base, *_) = [m.places for m in marks if isinstance(m, Polyline) and m.closed and len(m.places) == 4]
    assert min(x for x, _ in base) < normal.at[0] < max(x for x, _ in base)
    assert normal.inward
    assert normal.at[1] == pytest.approx(min(y for _, y in base))


def test_a_group_of_bodies_has_its_diagram_without_the_forces_between_them() -> None:
    """All bodies in their places; the point about which the group's moments are taken in no other diagram."""
    disk, rod, both = diagrams("rod-on-a-rolling-disk")
    free, kinetic = (["".join(map(plain, m.words)) for m in p.marks if isinstance(m, Arrow)] for p in both.panels)
    assert sorted(free) == ["F_C", "N_C", "g*m_D", "g*m_R"]
    assert len(kinetic) == 3
    assert sum(isinstance(m, Symbol) and m.kind == "centre" for m in both.panels[0].marks) == 2
    named = [[m.words for m in f.panels[1].marks if isinstance(m, Tag)] for f in (disk, rod, both)]
    assert [line(Name("C")) in words for words in named] == [False, False, True]


def test_what_is_given_against_its_letter_is_drawn_the_way_it_is() -> None:
    """The ball comes down, as the file says: -m v_y downward, and no word under it."""
    blow = next(f for f in diagrams("ball-on-a-rough-floor") if len(f.panels) > 2)
    arrows = [m for m in blow.panels[0].marks if isinstance(m, Arrow)]
    told = {"".join(map(plain, m.words)): round(math.sin(m.angle), 9) for m in arrows}
    assert told == {"m*v_Gx__1": 0, "-m*v_Gy__1": -1}
    assert blow.note == ()


def test_a_spring_that_only_pushes_is_drawn_pushing_with_a_positive_size() -> None:
    """Two nested springs on which a weight has fallen: k (l - y) upward, as the equations count them."""
    free = diagrams("weight-dropped-on-nested-springs")[0].panels[0]
    arrows = [m for m in free.marks if isinstance(m, Arrow)]
    told = {"".join(map(plain, m.words)): round(math.degrees(m.angle)) for m in arrows}
    assert told == {"W": -90, "k_1*(l_1 - y_P)": 90, "k_2*(l_2 - y_P)": 90}


def notes(stem: str) -> list[str]:
    return ["".join(map(plain, figure.note)) for figure in diagrams(stem)]


def test_a_size_in_letters_is_told_against_its_arrow_where_its_angles_are_as_drawn() -> None:
    """A ball thrown off a wedge to the left; and a cut cord, where with the sense of one vector that of all is told."""
    assert notes("ball-on-a-sliding-wedge") == ["", *["found: m*v_ball_x__2 to the left"] * 2]
    told = "found: m*(L*alpha/2) downward, I*alpha clockwise; as drawn here: a_A_t*m down to the left"
    assert notes("bar-when-one-of-its-cords-is-cut")[1] == told


def test_what_is_against_its_arrow_in_states_of_a_motion_is_told_of_them() -> None:
    told = notes("pendulum-on-a-wagon"), notes("rod-falling-on-a-smooth-floor")
    assert told == (
        ["", "at 1 opposite to its arrow: a_ball_wagon_t*m"],
        ["at 2 opposite to their arrows: m*(alpha*l/2), I*alpha"],
    )


def test_a_given_acceleration_is_drawn_the_way_it_is() -> None:
    """a_wedge = -a, to the left: m a."""
    kinetic = diagrams("block-carried-by-an-accelerated-wedge")[0].panels[1]
    (arrow,) = [m for m in kinetic.marks if isinstance(m, Arrow)]
    assert ("".join(map(plain, arrow.words)), round(math.degrees(arrow.angle))) == ("a*m", 180)


def test_near_an_equilibrium_the_body_is_drawn_turned() -> None:
    """The weight has an arm about the point of contact, which is one point in both diagrams."""
    first = diagrams("half-disk-rocking")[0]
    assert next(plain(p) for p in first.note).startswith("drawn turned by δ")
    tags = [[(m.words[0], m.at) for m in panel.marks if isinstance(m, Tag)] for panel in first.panels]
    places = [{w.name: at for w, at in own if isinstance(w, Name)} for own in tags]
    assert places[0]["C"] == pytest.approx(places[1]["C"])
    assert places[0]["G"][0] - places[0]["C"][0] > 0.01


def corners(figure: Figure) -> list[int]:
    """Of the outlines in each panel."""
    rings = [m.places for p in figure.panels for m in p.marks if isinstance(m, Polyline) and m.closed]
    return [len({(round(x, 9), round(y, 9)) for x, y in ring}) for ring in rings]


def test_a_body_that_is_struck_has_its_shape_in_the_diagrams() -> None:
    """A wedge is a triangle."""
    assert corners(diagrams("ball-on-a-sliding-wedge")[0]) == [3, 3]


def test_where_a_body_is_pushed_at_a_height_that_is_sought_does_not_shape_it() -> None:
    """A cabinet is a box about its mass centre in all cases."""
    page = illustrated_page(next(p for p in PROBLEMS if p.stem == "cabinet-on-casters"))
    scenes = [b.figure for b in page.blocks if isinstance(b, Drawing) and b.figure.name == "scene"]
    boxes = {m.places for f in scenes for p in f.panels for m in p.marks if isinstance(m, Polyline) and m.closed}
    assert len(scenes) == 3
    assert [len(box) for box in boxes] == [4]


def test_a_long_rope_between_two_bodies_is_drawn_and_broken_alike_in_both_diagrams() -> None:
    """A load on the drum of a gear, as in the scene."""
    group = next(f for f in diagrams("hoist-driven-by-gears") if f.words.endswith("gear_B, load"))
    breaks = [[m.at for m in p.marks if isinstance(m, Symbol) and m.kind == "break"] for p in group.panels]
    ropes = [[m.places for m in p.marks if isinstance(m, Polyline) and m.style == "rope"] for p in group.panels]
    assert breaks[0] == breaks[1]
    assert ropes[0] == ropes[1]
    assert len(breaks[0]) == len(ropes[0]) == 1
    assert math.dist(*ropes[0][0]) < 1.0


def test_a_block_with_sides_alone_has_its_weight_in_its_middle_and_contacts_at_its_base() -> None:
    """What pulls does so at the side to which it pulls."""
    block = next(f for f in diagrams("stacked-blocks-joined-over-a-pulley") if f.words.endswith("block_B"))
    told = {"".join(map(plain, m.words)): m.at for p in block.panels for m in p.marks if isinstance(m, Arrow)}
    assert told["W_B"] == told["a_B*m_block_B"] == pytest.approx((0, 0.5))
    assert told["N_B"] == told["N_B*mu_2"] == pytest.approx((0, 0))
    assert (told["P"], told["T"]) == (pytest.approx((0.5, 0.5)), pytest.approx((-0.5, 0.5)))


def test_a_rope_pulls_where_its_strand_leaves_the_rim() -> None:
    """Away from its body; of a wheel that only the drawing has, that wheel is in both diagrams."""
    boom = [m for m in diagrams("boom-when-its-rope-breaks")[0].panels[0].marks if isinstance(m, Arrow)]
    assert [m.inward for m in boom if plain(m.words[0]) == "T"] == [False]
    for stem, body in (("moving-pulley", "B"), ("block-on-a-table-and-a-moving-pulley", "load")):
        free, kinetic = next(f for f in diagrams(stem) if f.words.endswith(body)).panels
        (rim,) = [m for m in free.marks if isinstance(m, Arc)]
        pulls = [m for m in free.marks if isinstance(m, Arrow) and plain(m.words[0]).startswith("T")]
        assert sorted(m.at[0] - rim.center[0] for m in pulls) == pytest.approx([-rim.radius, rim.radius])
        assert [m for m in kinetic.marks if isinstance(m, Arc)] == [rim]


def test_what_has_a_shorter_name_on_the_page_is_told_against_its_arrow() -> None:
    """The force of the rod is asked for in one case alone, and has one name in both."""
    told = notes("collar-drawn-up-from-its-rod-by-a-spring")
    assert told == ["found: N downward", "found: N downward, N*mu to the left"]


def test_lines_that_meet_far_away_tell_where_they_go() -> None:
    """The bodies stay large: only the beginnings are drawn, of two in one line the nearer one."""
    group = next(f for f in diagrams("roller-with-a-drag-bar") if f.words.endswith("roller, bar"))
    free, kinetic = group.panels
    ways = [m for m in free.marks if isinstance(m, Polyline) and m.style == "way"]
    assert [m.at for m in free.marks if isinstance(m, Tag) and m.words == line("to ", Name("K"))] == [
        m.places[1] for m in ways
    ]
    assert len(ways) == 2
    assert not any(m.style == "way" for m in kinetic.marks if isinstance(m, Polyline))


def test_what_stays_the_same_all_the_time_is_told_by_its_shorter_name_too() -> None:
    """The only body's acceleration, a_y on the page."""
    assert notes("ball-off-a-smooth-wall")[0] == "found: a_y*m downward"


def test_senses_that_rest_on_a_restitution_or_on_another_case_are_told() -> None:
    """(e - 3) v is negative for every e from 0 to 1; of an impulse that only the first case finds the figure of the
    second says the same, and is not drawn again; what slants is told by its quadrant.
    """
    assert notes("level-rod-caught-by-an-edge") == ["found: m*v_Gy__2 downward, I*omega__2 clockwise"]
    assert notes("wheel-over-a-kerb") == ["found: J_K_x to the left"]
    assert "found: F_P up to the left" in notes("package-on-the-end-drum-of-a-conveyor")[0]


def test_a_guide_presses_on_an_edge_of_what_slides_in_it_and_holds_with_no_couple_that_is_nought() -> None:
    """The floor strikes a wedge from below, straight under the place where the ball hits it."""
    wedge = diagrams("ball-on-a-sliding-wedge")[0].panels[0].marks
    assert not any(isinstance(m, Turn) for m in wedge)
    (push,) = [m for m in wedge if isinstance(m, Arrow) and plain(m.words[0]) == "J_N_floor"]
    (face,) = [m.places for m in wedge if isinstance(m, Polyline) and m.closed]
    assert push.inward
    assert push.at == pytest.approx((0.0, min(y for _, y in face)))
    (hit,) = [m for m in wedge if isinstance(m, Arrow) and plain(m.words[0]) == "J_N_hit"]
    assert hit.inward, "and the ball from outside, though the file has no other place of the wedge"


def test_the_angle_of_a_radius_stands_in_the_diagram_of_what_it_places() -> None:
    """From the direction from which the page counts it to a force along the radius, or the way to one at the rim."""
    ball, bob = (
        diagrams(stem)[0].panels[0].marks
        for stem in ("ball-rolling-round-a-loop", "swing-from-which-the-cord-just-holds")
    )
    (angle,) = [m for m in ball if isinstance(m, Angle)]
    (normal,) = [m for m in ball if isinstance(m, Arrow) and plain(m.words[0]) == "N_C"]
    assert angle.words == line(Name("phi"))
    assert angle.start == pytest.approx(-math.pi / 2)
    assert math.cos(angle.start + angle.sweep - normal.angle) == pytest.approx(-1)
    (angle,) = [m for m in bob if isinstance(m, Angle)]
    (tension,) = [m for m in bob if isinstance(m, Arrow) and plain(m.words[0]) == "S_cord"]
    assert math.cos(angle.start + angle.sweep - tension.angle) == pytest.approx(1)
