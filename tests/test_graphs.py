"""Graphs: axes with round ticks, the curves that were followed, states by name, words that do not collide."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest
from conftest import ROOT
from figure_demands import demand_figure
from test_figures import illustrated_page
from test_simulate import CRATE
from worked import worked

from planar_cli import cli
from planar_cli.figures.illustrated import figures_of
from planar_cli.formats._graph import COLOURS, ticked
from planar_cli.formats._labels import clashes
from planar_cli.formats._small_plot import small_plot
from planar_cli.formats._svg import PRINT, papers_of
from planar_cli.formats.html import Html
from planar_cli.homework.checking.checking import read
from planar_cli.problem.structure import load_text
from planar_cli.report.document.blocks import Name, line
from planar_cli.report.document.graphs import Graph
from planar_cli.report.document.marks import Figure
from planar_cli.simulate.energies import NAMES, energies, off
from planar_cli.simulate.run import Settings, follow


def path_of(stem: str) -> Path:
    return next((ROOT / "problems").rglob(f"{stem}.yaml"))


def graphs_of(figure: Figure) -> list[Graph]:
    return [m for panel in figure.panels for m in panel.marks if isinstance(m, Graph)]


@pytest.mark.parametrize(
    ("low", "high", "numbers"),
    [
        (0.0, 2.0, ["0", "0.5", "1.0", "1.5", "2.0"]),
        (-0.1, 0.083, ["−0.10", "−0.05", "0", "0.05", "0.10"]),
        (3.0, 3.0, ["1", "2", "3", "4", "5"]),
        (0.0, 3.2e6, ["0", "1", "2", "3", "4"]),
    ],
)
def test_ticks_stand_at_round_numbers(low: float, high: float, numbers: list[str]) -> None:
    axis = ticked(low, high, 4)
    assert [axis.told(t) for t in axis.ticks] == numbers
    assert axis.low <= low <= high <= axis.high


@pytest.mark.parametrize("stem", ["ball-that-comes-to-rest", "block-that-rocks", "puck-whose-string-winds-up"])
def test_a_motion_that_was_integrated_has_its_graph(stem: str) -> None:
    page = illustrated_page(path_of(stem))
    figure = dict(figures_of(page))["motion"]
    states = [s.name for s in worked(path_of(stem))[0].problem.states]
    assert graphs_of(figure)
    for graph in graphs_of(figure):
        told = ", ".join("".join(str(getattr(p, "text", "")) for p in dot.words) for dot in graph.dots)
        assert told.split(", ") == states
        assert all(math.isfinite(v) for c in graph.curves for piece in c.pieces for spot in piece for v in spot)
    assert not any(clashes(paper) for paper in papers_of(figure))
    demand_figure(figure)
    assert 'class="stroke curve c0"' in Html().render(page)


def test_a_curve_is_what_was_followed() -> None:
    """A ball falls 1 m: y = 1 - g t²/2 until it strikes at 0.45 s."""
    figure = dict(figures_of(illustrated_page(path_of("ball-that-comes-to-rest"))))["motion"]
    (graph,) = graphs_of(figure)
    first = graph.curves[0].pieces[0]
    assert all(abs(y - (1 - 9.81 * t * t / 2)) < 1e-7 for t, y in first)
    assert abs(first[-1][0] - 0.451523641) < 1e-8


def drawn(capsys: pytest.CaptureFixture[str], picture: Path, stem: str, *args: str, status: int = 0) -> str:
    assert cli.run(["simulate", str(path_of(stem)), "--plot", str(picture), *args]) == status, capsys.readouterr().err
    return picture.read_text(encoding="utf-8")


def test_ways_and_portraits(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = drawn(capsys, tmp_path / "m.svg", "double-pendulum-let-go-level", "--plot-of", "path", "--plot-of", "phase")
    words = re.sub(r"<[^>]*>", "", text)
    assert all(name in words for name in ("upper", "lower", "ω", "θ", "x in m", "y in m"))


def test_a_part_of_a_force_is_titled_as_a_page_calls_it(capsys: pytest.CaptureFixture[str]) -> None:
    asked = ("-q", "reaction(A).mag", "-q", "reaction(A).x", "-q", "reaction(A)")
    assert (
        cli.run(
            ["simulate", str(ROOT / "problems" / "energy" / "plate-let-go-at-a-corner.yaml"), "--rows", "2", *asked]
        )
        == 0
    )
    told = capsys.readouterr().out
    assert all(f"\n  {t} in N\n" in told for t in ("size of the reaction at A", "x component of the reaction at A"))
    assert "\n  reaction at A in N\n" in told


def test_the_ledger_of_energy_adds_up() -> None:
    """A ball that bounces loses all it had; friction on a belt takes what the belt supplies and the spring does not."""
    for stem, names in (
        ("ball-that-comes-to-rest", ["kinetic", "potential", "dissipated", "sum"]),
        ("block-that-sticks-and-slips", ["kinetic", "spring", "dissipated", "supplied", "sum"]),
        ("double-pendulum-let-go-level", ["kinetic", "potential", "sum"]),
    ):
        accounts = energies(follow(read(str(path_of(stem))), Settings()), 200)
        assert [a.name for a in accounts] == names
        assert off(accounts) < 1e-7


def test_a_spring_that_is_free_stores_nothing() -> None:
    """A block of 2 kg at 3 m/s that runs into a buffer gives it all its 9 J, and has them again."""
    accounts = energies(follow(read(str(path_of("block-runs-into-a-spring"))), Settings()), 200)
    assert {a.name: round(a.largest, 3) for a in accounts} == {"kinetic": 9.0, "spring": 9.0, "sum": 9.0}
    assert accounts[1].pieces[0][0] == (0.0, 0.0)


def test_friction_and_the_force_that_pulls_are_told_apart() -> None:
    """10 N over 2 s on 2 kg, μ = 0.3: x = (5 - 0.3 g) · 2, of the work 10 x friction takes 0.3 · 2 g x."""
    problem, wrong = load_text(
        "{plane: vertical, points: {P: [0, 0]}, bodies: {crate: {particle: P, mass: 2 kg}}, "
        "joints: [guide: {point: P, along: 0 deg, mu: 0.3}], loads: [force: {at: P, magnitude: 10 N, angle: 0 deg}], "
        "states: {0: [t = 0, at rest], 1: [t = 2 s]}, find: {x: x(P) @ 1}}"
    )
    assert problem is not None, wrong
    largest = {a.name: a.largest for a in energies(follow(problem, Settings()), 50)}
    x = (5 - 0.3 * 9.81) * 2
    expected = {"kinetic": (10 - 0.6 * 9.81) * x, "dissipated": 0.6 * 9.81 * x, "supplied": 10 * x, "sum": 0.0}
    assert largest == pytest.approx(expected, abs=1e-7)


def test_each_account_of_energy_has_a_colour_of_its_own() -> None:
    found = re.findall(r"\.c(\d)\{stroke:(.*?)\}", PRINT)
    assert [int(number) for number, _ in found] == list(range(COLOURS))
    assert len({colour for _, colour in found}) == COLOURS >= len(NAMES)


def test_a_motion_without_an_effect_is_dashed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "scene.yaml"
    path.write_text(CRATE, encoding="utf-8")
    picture = tmp_path / "m.svg"
    assert cli.run(["simulate", str(path), "--plot", str(picture), "--without", "drag", "--until", "0.5 s"]) in (0, 3)
    assert 'class="stroke curve c0 dashed"' in picture.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    "args",
    [["--plot", "m.pdf"], ["--plot-of", "path"], ["--plot", "m.svg", str(ROOT / "problems/hard/comet.yaml")]],
)
def test_what_no_picture_can_come_of_is_refused(args: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["simulate", str(path_of("double-pendulum-let-go-level")), *args]) == 2
    assert "picture" in capsys.readouterr().err


def test_a_mechanism_that_is_driven_has_graphs_of_what_is_asked() -> None:
    figure = figure_of("body-slider-crank-over-time")
    assert [g.up.unit for g in graphs_of(figure)] == ["mm", "m/s", "m/s²"]
    assert [d.at[0] for d in graphs_of(figure)[0].dots][1] == pytest.approx(0.008)


def test_a_motion_found_by_integration_has_its_graph_in_the_unit_of_its_answers() -> None:
    *_, angle = graphs_of(figure_of("bar-with-spring-and-damper"))
    assert angle.up.unit == "°"
    assert angle.curves[0].pieces[0][0][1] == pytest.approx(12)


def test_a_vibration_with_states_on_its_way_is_drawn_from_its_start() -> None:
    *_, place = graphs_of(figure_of("quarter-car-on-a-washboard"))
    assert place.across.low == 0
    assert len(place.dots) == 5


def figure_of(stem: str) -> Figure:
    """The first graphs of a page."""
    return dict(figures_of(illustrated_page(path_of(stem))))["motion"]


def test_a_motion_in_letters_has_its_shape_with_letters_at_the_axes() -> None:
    graphs = graphs_of(figure_of("boat-driven-from-rest-and-cut-in-letters"))
    assert [[w for _, w in g.across.letters] for g in graphs] == [[line("0"), line(Name("t__cut"))]] * 3
    assert [[w for _, w in g.up.letters] for g in graphs[1:]] == [
        [line("0"), line(Name("v__cut"))],
        [line("0"), line(Name("x__cut"))],
    ]
    assert not any(g.across.unit or g.up.unit for g in graphs)
    _, speed, _ = graphs
    assert max(y for p in speed.curves[0].pieces for _, y in p) == pytest.approx(speed.up.letters[1][0])
    plot = small_plot(speed, 60)
    assert not any(c.isdigit() and c != "0" for row in plot for c in row)


def test_a_given_letter_stands_at_its_place() -> None:
    _, speed, _ = graphs_of(figure_of("ball-up-with-drag-in-letters"))
    assert line(Name("v_0")) in [w for _, w in speed.up.letters]
