"""The vectors of points at their places: to scale, in their real senses, in the axes in which they are asked for."""

from __future__ import annotations

import math
import re
from unicodedata import normalize

import pytest
from conftest import PROBLEMS
from worked import worked

from planar_cli.figures.illustrated import figures_of, illustrated
from planar_cli.formats._paper import runs_of
from planar_cli.formats._svg import svg
from planar_cli.report.document.blocks import Answer, Drawing, Line
from planar_cli.report.document.marks import Angle, Arrow, Figure, Panel, Polyline, Span, Spot
from planar_cli.report.page.narrate import narrate


def figures(stem: str) -> dict[str, Figure]:
    solution = worked(next(p for p in PROBLEMS if p.stem == stem))[0]
    return dict(figures_of(illustrated(narrate(solution), solution)))


def told(words: Line) -> str:
    return normalize("NFC", "".join(("_" if run.index else "") + run.text for run in runs_of(words)))


def vectors(panel: Panel) -> dict[str, Spot]:
    spans = (m for m in panel.marks if isinstance(m, Span))
    return {told(s.words): (s.end[0] - s.start[0], s.end[1] - s.start[1]) for s in spans}


def axes(panel: Panel) -> dict[str, float]:
    return {told(m.words): m.angle for m in panel.marks if isinstance(m, Arrow) and m.style == "axis"}


@pytest.mark.parametrize(
    ("stem", "point", "answers"),
    [
        ("polar-motion", "P", ({"v_r": 0.5, "v_θ": 2.4, "v_P": 2.45153}, {"a_r": -1.92, "a_θ": 2.0, "a_P": 2.77244})),
        ("car-on-a-circle", "car", ({"v_q": 16.1437}, {"a_t": 1.5, "a_n": 5.21239, "a_q": 5.42393})),
        ("ex-1-10", "B", ({"a_t": 0.1, "a_n": 0.2666666667, "a_B": 0.2848001248},)),
    ],
)
def test_components_are_to_scale_along_their_axes(stem: str, point: str, answers: tuple[dict[str, float], ...]) -> None:
    """One that is negative has its size beside its arrow, against its axis."""
    figure = figures(stem)[f"vectors of {point}"]
    for panel, values in zip(figure.panels, answers, strict=True):
        found, directions = vectors(panel), axes(panel)
        assert found.keys() == {name if value > 0 else f"|{name}|" for name, value in values.items()}
        scale = max(math.hypot(*v) for v in found.values()) / max(values.values())
        for name, value in values.items():
            x, y = found[name if value > 0 else f"|{name}|"]
            along = directions.get(f"e_{name[-1]}")
            size = math.hypot(x, y) if along is None else x * math.cos(along) + y * math.sin(along)
            assert size == pytest.approx(value * scale, rel=1e-4)


def test_the_whole_circle_is_drawn_on_which_a_point_runs() -> None:
    (panel, _) = figures("car-on-a-circle")["vectors of car"].panels
    (way,) = (m.places for m in panel.marks if isinstance(m, Polyline) and len(m.places) > 9)
    assert way[0] == pytest.approx(way[-1], abs=1e-6)
    assert all(math.hypot(*spot) == pytest.approx(50) for spot in way)


def test_they_stand_behind_the_step_that_finds_them() -> None:
    solution = worked(next(p for p in PROBLEMS if p.stem == "polar-motion"))[0]
    blocks = illustrated(narrate(solution), solution).blocks
    at = next(i for i, b in enumerate(blocks) if isinstance(b, Drawing) and b.figure.name == "vectors of P")
    assert at < next(i for i, b in enumerate(blocks) if isinstance(b, Answer))


@pytest.mark.parametrize(
    ("stem", "names", "size"), [("ex-1-12", ("path of P", "hodograph of P, pole o"), 1.0), ("ellipse-in-time", (), 0.0)]
)
def test_curves_that_are_asked_for_are_drawn_whole(stem: str, names: tuple[str, ...], size: float) -> None:
    """To scales of their own, each with the point on it or the velocity from the pole."""
    drawn = figures(stem)
    panels = drawn["curves of P"].panels
    assert len(panels) == 2
    if names:
        assert tuple(told(p.head) for p in panels) == names
    for panel in (*panels, drawn["scene"].panels[0]):
        (way,) = (m.places for m in panel.marks if isinstance(m, Polyline) and m.style == "way")
        assert way[0] == pytest.approx(way[-1], abs=1e-6)
        radii = [math.hypot(*spot) for spot in way]
        assert not size or max(radii) == pytest.approx(min(radii), rel=1e-6)
    (tip,) = (m.end for m in panels[1].marks if isinstance(m, Span))
    way = next(m.places for m in panels[1].marks if isinstance(m, Polyline) and m.style == "way")
    assert min(math.dist(tip, spot) for spot in way) < 0.03


@pytest.mark.slow
def test_a_hodograph_has_the_velocity_of_each_state() -> None:
    panel = figures("hodograph-of-a-throw")["curves of ball"].panels[1]
    found = vectors(panel)
    assert set(found) == {"v_ball,throw", "v_ball,top"}
    thrown, top = found["v_ball,throw"], found["v_ball,top"]
    assert thrown[0] == pytest.approx(top[0])
    assert thrown[1] / thrown[0] == pytest.approx(math.tan(math.radians(60)))
    assert top[1] == pytest.approx(0, abs=1e-6)


def test_the_whole_orbit_has_the_centre_of_attraction_at_its_focus() -> None:
    (way,) = (
        m.places
        for m in figures("satellite-perigee-apogee")["scene"].panels[0].marks
        if isinstance(m, Polyline) and m.style == "way"
    )
    other = (6370e3 + 439e3 - (6370e3 + 2384e3), 0.0)
    sums = [math.hypot(*spot) + math.dist(spot, other) for spot in way]
    assert max(sums) == pytest.approx(2 * 6370e3 + 439e3 + 2384e3, rel=1e-6)
    assert min(sums) == pytest.approx(max(sums), rel=1e-6)


def test_what_is_far_from_zero_is_drawn_near_it_on_paper() -> None:
    """A viewer counts with few digits."""
    drawn = svg(figures("burn-into-a-round-orbit")["sat"])
    assert max(abs(float(x)) for x in re.findall(r' (?:x|y|cx|cy)="([-\d.]+)"', drawn)) < 2000


def test_sizes_that_are_found_by_rates_of_coordinates_have_them_as_components() -> None:
    velocity, acceleration = figures("ex-1-12")["vectors of P"].panels
    assert {name.strip("|") for name in vectors(velocity)} == {"v_P", "ẋ_P", "ẏ_P"}
    assert {name.strip("|") for name in vectors(acceleration)} == {"a_P", "ẍ_P", "ÿ_P"}


def test_polar_coordinates_that_are_given_are_drawn_in_the_scene() -> None:
    marks = figures("polar-motion")["scene"].panels[0].marks
    (angle,) = (m for m in marks if isinstance(m, Angle))
    assert (angle.vertex, told(angle.words)) == ((0.0, 0.0), "θ")
    assert angle.sweep == pytest.approx(0.8)
    (way,) = (m.places for m in marks if isinstance(m, Polyline) and m.style == "thin")
    assert math.dist(*way) == pytest.approx(3.0)


def test_a_motion_that_is_followed_in_numbers_alone_is_drawn_without_a_curve_that_leads_it() -> None:
    assert "scene" in figures("dog-that-runs-at-a-cyclist")
