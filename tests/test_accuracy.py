"""Studies of accuracy on motions with given rates."""

from __future__ import annotations

import csv
import io
import json
import math
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import combinations
from pathlib import Path

import motions
import pytest

from planar_cli.figures.accuracy_plot import accuracy_plot
from planar_cli.formats._svg import papers_of, svg
from planar_cli.integrators.base import Setting
from planar_cli.motion.follow.estimate import shifts
from planar_cli.motion.trajectory.drive import drive
from planar_cli.problem.structure import load
from planar_cli.simulate.accuracy import Ran, Row, Study, Wanted, study
from planar_cli.simulate.accuracy_report import Told, as_csv, as_data, as_markdown, as_text
from planar_cli.simulate.diagram import HEIGHT
from planar_cli.simulate.subject import SceneSubject

PROBLEMS = Path(__file__).parent.parent / "problems"


@dataclass(frozen=True)
class Plain:
    """A motion as the subject of a study."""

    motion: motions.Motion
    closed: tuple[float, ...] | None = None
    time_scale: float = 0.3

    def run(self, kind: str, tolerance: float, step: float | None = None, shift: float = 0.0) -> Ran:
        motion, begun = self.motion, time.perf_counter()
        start = [a + b for a, b in zip(motion.start, shifts(motion.scale, shift), strict=True)]
        setting = Setting(motion.scale, tolerance=tolerance, step=step, most_steps=20_000)
        run = drive(motion.rates, 0.0, start, motion.end, setting, kind=kind)

        def path(t: float) -> list[float]:
            return [a / s for a, s in zip(run.at(t), motion.scale, strict=True)]

        seconds = time.perf_counter() - begun
        counts = run.counts
        return Ran(tuple(path(run.t1)), path, 0.0, run.t1, (), 0.0, 0.0, counts.steps, counts.evaluations, seconds)

    def exact(self) -> tuple[float, ...] | None:
        return self.closed

    def peers(self) -> Iterator[Iterator[Row]]:
        steps = (0.1, 0.01)
        yield (Row("elsewhere", None, step, step, None, math.nan, math.nan, 0, 0, 0.1 / step) for step in steps)


WANTED = Wanted(("auto", "dop853", "rk4"), tolerances=(1e-4, 1e-7, 1e-10, 1e-12), steps=(0.1, 0.03, 0.01))


@pytest.fixture(scope="module")
def swing() -> Study:
    return study(Plain(motions.pendulum(2.0, 5.0)), WANTED)


def test_errors_fall_and_are_estimated(swing: Study) -> None:
    rows = [r for r in swing.rows if r.integrator == "dop853"]
    assert [r.tolerance for r in rows] == list(WANTED.tolerances)
    errors = [r.error for r in rows if r.error is not None]
    assert errors == sorted(errors, reverse=True)
    for row in rows[:3]:
        assert row.error is not None
        assert row.estimated == pytest.approx(row.error, rel=9.0)
    fixed = [r for r in swing.rows if r.integrator == "rk4"]
    assert [r.step for r in fixed] == pytest.approx([0.03, 0.009, 0.003])


def test_the_reference_is_checked_by_another_method(swing: Study) -> None:
    assert "radau" in swing.reference.words
    assert swing.reference.uncertainty < 1e-12


def test_a_closed_form_is_the_reference_where_there_is_one() -> None:
    oscillator = motions.Motion(lambda t, y: [y[1], -y[0]], [1.0, 0.0], 2.0, [1.0, 1.0], {})
    found = study(Plain(oscillator, (math.cos(2.0), -math.sin(2.0))), Wanted(("dop853",), tolerances=(1e-6, 1e-9)))
    assert found.reference.words == "closed form"
    assert all(r.error is not None and r.error < 1e-4 for r in found.rows)


def test_settings_are_recommended(swing: Study) -> None:
    assert [a.digits for a in swing.advice] == [3, 6, 10]
    for advice in swing.advice:
        assert advice.row is not None
        assert advice.row.error is not None
        assert advice.row.error <= 10.0**-advice.digits


def test_the_horizon_of_a_chaotic_motion() -> None:
    found = study(Plain(motions.double_pendulum()), Wanted(("dop853",), tolerances=(1e-6,)))
    assert found.growth.factor > 1e5
    assert "mean nothing beyond" in as_text(Told("double pendulum", found))


def test_a_method_beyond_its_budget_is_not_refined() -> None:
    found = study(Plain(motions.pendulum(2.0, 5.0)), Wanted(("rk4",), steps=(0.1, 0.01, 0.001), budget=0.0))
    assert len(found.rows) == 1


def test_rows_of_other_packages() -> None:
    plain = Plain(motions.pendulum(2.0, 5.0))
    found = study(plain, Wanted(("dop853",), peers=True, tolerances=(1e-6,), budget=0.5))
    assert [r.step for r in found.rows if r.integrator == "elsewhere"] == [0.1]
    assert all(a.row is None or a.row.integrator == "dop853" for a in found.advice)
    assert "elsewhere" in as_text(Told("Pendulum", found))


def test_what_can_not_be_followed_is_a_row_with_its_reason() -> None:
    """Equal steps too short to be taken."""
    found = study(Plain(motions.pendulum(2.0, 5.0)), Wanted(("rk4",), steps=(1e-7,)))
    assert found.rows[0].error is None
    assert "more than 20000 steps" in found.rows[0].note


def test_as_text(swing: Study) -> None:
    text = as_text(Told("Pendulum", swing))
    lines = text.splitlines()
    assert lines[0] == "Pendulum"
    assert len([line for line in lines if " |" in line]) == HEIGHT + 1
    assert "6 digits: " in text
    assert max(map(len, lines)) <= 120


def test_as_markdown(swing: Study) -> None:
    rows = [line for line in as_markdown(Told("Pendulum", swing)).splitlines() if line.startswith("|")]
    assert len(rows) == 2 + len(swing.rows)
    assert len({row.count("|") for row in rows}) == 1


def test_as_csv_and_json(swing: Study) -> None:
    rows = list(csv.DictReader(io.StringIO(as_csv([Told("Pendulum", swing)]))))
    assert [float(r["error"]) for r in rows] == [r.error for r in swing.rows]
    data = json.loads(json.dumps(as_data(Told("Pendulum", swing)), allow_nan=False))
    assert [r["integrator"] for r in data["rows"]] == [r.integrator for r in swing.rows]
    assert [a["digits"] for a in data["recommended"]] == [3, 6, 10]


@pytest.mark.parametrize("titles", [("<script> $ \\frac",), ("one", "two")])
def test_as_a_picture(swing: Study, titles: tuple[str, ...]) -> None:
    """Every run is a dot of its integrator, and every power of ten that is shown is a whole one."""
    figure = accuracy_plot([(title, swing) for title in titles])
    drawn = svg(figure)
    assert drawn.count("<circle") == len(titles) * sum(r.error is not None for r in swing.rows)
    assert "<script" not in drawn
    words = [run.text for p in papers_of(figure) for placed in p.placed for run in placed.words.runs]
    assert {"auto", "dop853", "rk4"} <= set(words)
    ticks = [w for w in words if w.startswith("10")]
    assert len(ticks) > 6 * len(titles)
    assert all(set(w[2:]) <= set("⁻⁰¹²³⁴⁵⁶⁷⁸⁹") for w in ticks)
    boxes = [placed.box for p in papers_of(figure) for placed in p.placed]
    assert not [(a, b) for a, b in combinations(boxes, 2) if a.overlaps(b)]


@pytest.mark.parametrize("kind", ["semi_implicit_euler", "rk4"])
def test_the_estimate_is_of_the_run_that_is_reported(kind: str) -> None:
    """Half the step errs by 2^-p as much: of a method of first order the difference shows only half of the error."""
    found = study(Plain(motions.pendulum(2.0, 5.0)), Wanted((kind,), steps=(0.01, 0.003)))
    for row in found.rows:
        assert row.error is not None
        assert row.estimated == pytest.approx(row.error, rel=0.03)


@dataclass(frozen=True)
class Lone(Plain):
    """A motion that one setting only can follow."""

    def run(self, kind: str, tolerance: float, step: float | None = None, shift: float = 0.0) -> Ran:
        ran = Plain.run(self, kind, tolerance, step, shift)
        return ran if (kind, tolerance) == ("auto", 1e-14) else replace(ran, met=(f"{kind} {tolerance}",))


def test_why_nothing_is_recommended() -> None:
    """The diagram had no lower end, and nothing was said of why."""
    found = study(Lone(motions.pendulum(2.0, 5.0)), Wanted(("rk4",), steps=(0.1,)))
    text = as_text(Told("Swing", found))
    assert "it is not checked" in text
    assert "3 digits: none is recommended, as the reference is not checked" in text


def test_a_state_that_comes_soon_is_met_by_equal_steps() -> None:
    """How far a state is looked for is no reason to refuse: only steps that are made count."""
    problem, wrong, _ = load(str(PROBLEMS / "hard/parallelogram-through-its-change-point.yaml"))
    assert problem is not None, wrong
    for tolerance, step in ((1e-9, 1e-3), (1e-3, None)):
        ran = SceneSubject(problem).run("rk4" if step else "auto", tolerance, step)
        assert (ran.met, ran.refused) == (("2", "reached"), "")
        assert ran.t1 == pytest.approx(math.pi / 3, rel=1e-9)
