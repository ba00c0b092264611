"""An internal fault is told as a fault, never as something that was not decided."""

from __future__ import annotations

from decimal import Decimal
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from answered import solve

from planar_cli import cli
from planar_cli.equation.values.exact import Unvalued, Valuation
from planar_cli.errors import NotReached, NoValue, Undecided
from planar_cli.solve import run

PUSHED = """
title: Block that is pushed
plane: horizontal
given: {m: 2 kg, F: 6 N}
bodies: {b: {particle: [0, 0], mass: m}}
loads:
  - force: {body: b, magnitude: F, angle: 0 deg}
instant: [at rest]
find: {a: a(b).x}
"""
FAULTS = [
    AssertionError("x"),
    KeyError("x"),
    IndexError("x"),
    ZeroDivisionError("x"),
    Unvalued("v_2"),
    TypeError("x"),
]


def failing(error: Exception) -> Any:
    def solve_part(*arguments: Any) -> Any:
        raise error

    return solve_part


@pytest.mark.parametrize("error", FAULTS, ids=lambda e: type(e).__name__)
def test_a_fault_stays_a_fault(error: Exception, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(run, "solve_part", failing(error))
    with pytest.raises(type(error)):
        solve(PUSHED)


@pytest.mark.parametrize("error", FAULTS, ids=lambda e: type(e).__name__)
def test_a_fault_has_an_exit_status_of_its_own(
    error: Exception, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(run, "solve_part", failing(error))
    monkeypatch.delenv("PLANAR_DEBUG", raising=False)
    file = tmp_path / "pushed.yaml"
    file.write_text(PUSHED, encoding="utf-8")
    assert cli.run(["solve", str(file)]) == cli.FAULT
    assert f"a fault of planar itself: {type(error).__name__}" in capsys.readouterr().err


def test_a_method_that_stops_says_where(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(run, "solve_part", failing(NotReached("not searched beyond 3 s")))
    with pytest.raises(Undecided, match=r":9: `a`: not decided, not searched beyond 3 s"):
        solve(PUSHED)


@pytest.mark.parametrize("text", ["1/x - 1/x**2", "log(x - 1)", "sqrt(x - 1)", "x*log(x)"])
def test_what_has_no_real_value_is_no_division_by_zero(text: str) -> None:
    x = sp.Symbol("x", real=True)
    with pytest.raises(NoValue) as told:
        Valuation({x: Decimal(0)})(sp.sympify(text, locals={"x": x}))
    assert not isinstance(told.value, ZeroDivisionError)
