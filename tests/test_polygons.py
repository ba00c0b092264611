"""Polygons of velocities and accelerations: they close, and each vector of an equation is drawn once, or told."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator
from itertools import combinations

import pytest
from conftest import PROBLEMS
from worked import worked

from planar_cli.figures.illustrated import figures_of, illustrated
from planar_cli.figures.polygons import polygons
from planar_cli.figures.vector_sums import vector_sums
from planar_cli.formats._on_paper import Scale, on_paper
from planar_cli.formats._paper import Stroke, runs_of
from planar_cli.formats._svg import papers_of
from planar_cli.report.document.blocks import Answer, Document, Drawing, Heading, Line, Name, line
from planar_cli.report.document.marks import Figure, Panel, Span, Spot
from planar_cli.report.page.narrate import narrate

BASES = {
    "car-seen-from-a-bend": ("v_B = v_B′ + v_rel", "v_B = v_A + v_B/A", "a_B = a_B′ + a_cor + a_rel"),
    "quick-return": ("v_P = v_P′ + v_rel", "a_P′ = α_arm CP + ω_arm² CP", "a_P = a_P′ + a_rel + a_cor"),
    "quick-return-stroke": ("v_P = v_P′ + v_rel", "a_P = a_P′ + a_rel + a_cor"),
    "rod-drawn-over-an-edge": ("v_D′ = v_A + ω AD", "a_B = α AB + ω² AB"),
    "slider-in-a-chord-of-a-disk": ("v_P = ω OP + v_P,disk", "a_P = α OP + ω² OP + a_P,disk + 2 ω × v_P,disk"),
    "ball-in-a-forked-slot": ("a_ball = α r_ball/O + ω² r_ball/O + a_ball,fork",),
    "cars-on-a-road-and-in-a-bend": ("v_taxi = v_taxi′ + v_rel", "a_taxi = a_taxi′ + a_rel"),
    "watts-sun-and-planet-gear": ("v_B = v_A + v_B/A",),
    "robot-arm-that-extends": ("v_B = v_A + v_B/A", "a_B = a_A + ω_AB² AB"),
    "coupler-point-of-a-four-bar": ("v_B = v_A + v_B/A", "a_B = α_rocker r_B/B0 + ω_rocker² r_B/B0"),
    "gripper-on-two-turning-arms": ("v_P = v_A + ω_AB AP + v_P/AB", "v_P = v_P′ + v_rel"),
    "straight-line-linkage-of-peaucellier": ("v_P = v_A + v_P/A", "v_P = v_B + v_P/B"),
    "planetary-gear": ("v_C = v_P + v_C/P",),
}
"""Some vector equations of a page, as the arrows of its figures call them."""


def drawn_page(stem: str) -> Document:
    solution = worked(next(p for p in PROBLEMS if p.stem == stem))[0]
    return illustrated(narrate(solution), solution)


def figures(stem: str) -> Iterator[Figure]:
    return (f for name, f in figures_of(drawn_page(stem)) if name.startswith(("velocities", "accelerations")))


def told(words: Line) -> str:
    return "".join(("_" if run.index else "") + run.text for run in runs_of(words))


def arrows(figure: Figure) -> dict[str, Span]:
    """By their names: one that has two of them stands under both."""
    spans = [m for m in figure.panels[0].marks if isinstance(m, Span)]
    names = Counter(name for s in spans for name in told(s.words).split(" = "))
    assert set(names.values()) <= {1} or all(
        n.startswith(("v_rel", "a_rel", "a_cor")) for n, c in names.items() if c > 1
    )
    return {name: s for s in spans for name in told(s.words).split(" = ")}


def way(span: Span) -> Spot:
    return span.end[0] - span.start[0], span.end[1] - span.start[1]


@pytest.mark.parametrize("stem", BASES)
def test_polygons_close(stem: str) -> None:
    drawn = [arrows(f) for f in figures(stem)]
    for equation in BASES[stem]:
        left, right = equation.split(" = ")
        spans = next(f for f in drawn if left in f and set(right.split(" + ")) <= f.keys())
        parts = [way(spans[name]) for name in right.split(" + ")]
        total = (sum(x for x, _ in parts), sum(y for _, y in parts))
        assert math.dist(total, way(spans[left])) < 1e-8 * max(math.hypot(*p) for p in parts)
        assert spans[left].start == (0.0, 0.0)


@pytest.mark.parametrize("stem", BASES)
def test_no_vector_lies_on_another(stem: str) -> None:
    for figure in figures(stem):
        spans = [m for m in figure.panels[0].marks if isinstance(m, Span)]
        assert len({(s.start, s.end) for s in spans}) == len(spans)
        for one, other in combinations(spans, 2):
            if along_one_line(one, other):
                same_way = sum(a * b for a, b in zip(way(one), way(other), strict=True)) > 0
                assert one.aside != (other.aside if same_way else -other.aside), (one, other)


def along_one_line(one: Span, other: Span) -> bool:
    """Would a part of one lie on the other?"""
    along, length = way(one), math.hypot(*way(one))
    ends = [(x - one.start[0], y - one.start[1]) for x, y in (other.start, other.end)]
    off = [abs(x * along[1] - y * along[0]) / length for x, y in ends]
    ahead = [(x * along[0] + y * along[1]) / length for x, y in ends]
    least = 1e-6 * length
    return max(off) < least and min(max(ahead), length) - max(min(ahead), 0.0) > least


def test_vectors_along_one_line_are_beside_each_other() -> None:
    figure = next(figures("planetary-gear"))
    spans = arrows(figure)
    paper = on_paper(Panel((spans["v_P"], spans["v_C"])), Scale(100.0))
    shafts = [s.places[0][0] for s in paper.strokes if isinstance(s, Stroke) and not s.closed]
    assert abs(shafts[0] - shafts[1]) > 40, "with room for what stands beside each"


def test_of_vectors_along_one_line_each_is_seen_and_named() -> None:
    _, figure = figures("planetary-gear")
    spans = arrows(figure)
    assert "a_P" in spans
    drawn = papers_of(figure)[0]
    heads = [s for s in drawn.strokes if isinstance(s, Stroke) and s.closed]
    assert len(heads) == len(set(map(id, spans.values())))
    assert len({s.aside for s in spans.values() if s is not spans["a_P"]} - {spans["a_P"].aside}) >= 2


def test_a_turning_that_is_part_of_a_motion_along_a_body_is_no_relative_velocity() -> None:
    velocities = arrows(next(figures("pin-where-two-slots-cross")))
    assert "v_P/A" not in velocities
    assert math.hypot(*way(velocities["ω_AE AP"])) == pytest.approx(4 * 0.5)


def test_the_coriolis_acceleration_is_twice_omega_across_the_relative_velocity() -> None:
    velocities, accelerations = map(arrows, figures("quick-return"))
    relative, coriolis = way(velocities["v_rel"]), way(accelerations["a_cor"])
    assert coriolis == pytest.approx((-2 * 1.3417 * relative[1], 2 * 1.3417 * relative[0]), rel=1e-4)
    assert math.hypot(*coriolis) == pytest.approx(1.8675, rel=1e-4)


def test_zero_vectors_are_told() -> None:
    heads = [told(f.panels[0].head) for f in figures("rod-drawn-over-an-edge")]
    assert [h.partition("pole o")[2] for h in heads] == [", v_D = 0", ", a_D = 0"]


def test_a_name_of_relative_motion_has_one_index() -> None:
    assert [(r.text, r.index) for r in runs_of(line(Name("v_B/A")))] == [("v", False), ("B/A", True)]


def test_nothing_is_drawn_of_equations_in_components() -> None:
    solution = worked(next(p for p in PROBLEMS if p.stem == "belt-drive"))[0]
    blocks = [b for b in narrate(solution).blocks if not vector_sums([b])]
    assert polygons(blocks, solution.parts[0].instants[0]) == []


def test_velocities_in_the_states_of_a_motion_stand_side_by_side() -> None:
    """The wind felt from the north at 12 km/h, from the north-east at 24 km/h."""
    (figure,) = figures("wind-felt-by-a-cyclist")
    assert [told(p.head) for p in figure.panels] == [
        f"polygon of velocities in state {s}, pole o" for s in ("slow", "fast")
    ]
    felt = [way(arrows(Figure((p,), ""))["v_air/cyclist"]) for p in figure.panels]
    assert felt[0] == pytest.approx((0.0, -12 / 3.6))
    assert felt[1] == pytest.approx((-12 / 3.6, -12 / 3.6))


def test_a_polygon_that_is_the_same_in_all_states_is_drawn_once() -> None:
    (figure,) = figures("river-crossing")
    assert [told(p.head) for p in figure.panels] == ["polygon of velocities in state start, pole o"]


def test_figures_stand_at_their_equations() -> None:
    """Behind the step that has the vector equation; a centre with which a check reasons, above the answer."""
    blocks = drawn_page("slider-crank-with-a-spring").blocks
    places = {b.figure.name: i for i, b in enumerate(blocks) if isinstance(b, Drawing)}
    steps = [i for i, b in enumerate(blocks) if isinstance(b, Heading) and b.label.startswith("STEP")]
    assert steps[0] < places["velocities"] < steps[1]
    assert steps[2] < places["accelerations"] < steps[3]
    blocks = drawn_page("six-bar-class-3").blocks
    (centre,) = (i for i, b in enumerate(blocks) if isinstance(b, Drawing) and b.figure.name.startswith("centre"))
    assert centre < next(i for i, b in enumerate(blocks) if isinstance(b, Answer))


def test_mass_centres_have_a_polygon_of_their_own_where_one_is_full() -> None:
    figure = next(f for f in figures("slider-crank-with-a-spring") if f.name == "accelerations")
    pins, centres = (arrows(Figure((panel,), "")) for panel in figure.panels)
    assert {"a_A", "a_B"} <= pins.keys()
    assert not any(name.startswith("a_G") for name in pins)
    assert {"a_A", "a_G,crank", "a_G,AB"} <= centres.keys()


def test_a_polygon_that_would_be_tiny_beside_that_of_another_state_has_its_own_scale() -> None:
    """The puck's accelerations grow 81 times."""
    first, last = (f for f in figures("puck-drawn-in-through-a-hole") if f.name == "accelerations")
    assert [told(p.head) for f in (first, last) for p in f.panels] == [
        f"polygon of accelerations in state {s}, pole o" for s in ("1", "2")
    ]
    assert told(first.note) == "to a larger scale than the others"
    assert last.note == ()


def test_a_polygon_that_a_later_step_repeats_is_drawn_once() -> None:
    names = [name for name, _ in figures_of(drawn_page("slider-crank-free"))]
    assert len([n for n in names if n.startswith("accelerations")]) == 1
