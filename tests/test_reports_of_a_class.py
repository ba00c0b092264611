"""What is told of a class by variant, and of rounding: places that the drawing gives are not rounded."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from planar_cli.commands._check_set import _print_report, _report_markdown
from planar_cli.homework.grading.class_report import ClassReport, by_variant
from planar_cli.homework.sets.paper import RIGHT, UNGRADABLE, WRONG, Graded, Result
from planar_cli.replay.equations import Asked, Equations, Step
from planar_cli.replay.numbers import Replay


def report() -> ClassReport:
    """Four submissions: of variant 1 one of two is right, of variants 2 and 3 the only one."""
    made = ClassReport()
    for student, variant, verdict in (
        ("a", 1, RIGHT),
        ("b", 1, WRONG),
        ("c", 2, RIGHT),
        ("d", 3, RIGHT),
        ("e", 2, WRONG),
    ):
        made.add(Result(student, variant, (Graded("p", "F", "", verdict, 0.0, 1.0),), student))
    return made


def test_each_find_is_counted_by_variant(capsys: pytest.CaptureFixture[str]) -> None:
    assert by_variant(report()) == {1: {("p", "F"): (1, 2)}, 2: {("p", "F"): (1, 2)}, 3: {("p", "F"): (1, 1)}}
    assert list(by_variant(report(), 2)) == [1, 2]
    assert "| 1 | 1 of 2 |\n| 2 | 1 of 2 |\n| 3 | 1 of 1 |" in _report_markdown("Sheet", report())
    _print_report(report())
    told = capsys.readouterr().out
    assert "variant 1: p.F 1/2 right\nvariant 2: p.F 1/2 right\n" in told
    assert "variant 3" not in told


def test_files_that_cannot_be_read_and_forms_of_answers_make_no_variant_suspicious() -> None:
    made = report()
    for k in range(6):
        unread = Graded("p", "F", "", UNGRADABLE, 0.0, 1.0, message="this cannot be graded: it is no YAML")
        made.add(Result(f"u{k}", 0, (unread,), f"u{k}", ("it is no YAML",)))
        made.add(Result(f"v{k}", 3, (Graded("p", "F", "about 5", UNGRADABLE, 0.0, 1.0),), f"v{k}"))
        made.add(Result(f"r{k}", 1, (Graded("p", "F", "5 N", RIGHT, 1.0, 1.0),), f"r{k}"))
    assert not list(made.suspicious())
    assert made.refused == 6
    assert made.finds["p", "F"].ungradable == 6
    assert by_variant(made)[3] == {("p", "F"): (1, 1)}


def test_what_is_exact_is_not_rounded() -> None:
    a, x, y, d = sp.symbols("a x y d", real=True)
    whole = Equations(
        "", {"a": a}, {x: a + 2, y: a + 1}, (Step((d,), (d - x + y,)),), {"d": Asked((d,))}, (), {a: 0.0, d: 1.0}
    )

    def rounding(numbers: np.ndarray) -> np.ndarray:
        return np.round(numbers / 5) * 5

    replay = Replay(whole)
    assert float(replay.run({}, rounding=rounding).asked("d")[0][0]) == 0.0
    assert replay.run({}, rounding=lambda n: n + 0.25, exact=frozenset({x, y})).asked("d")[0][0] == pytest.approx(1.25)
