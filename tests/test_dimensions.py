"""Dimension inference: what agrees, what does not, and where."""

from __future__ import annotations

import pytest

from planar_cli import units
from planar_cli.errors import Diagnostic, Mark
from planar_cli.problem.codes.codes import CODES
from planar_cli.problem.language.dimensions import (
    ANGLE,
    Kind,
    check_found,
    check_side,
    check_statement,
    dimension_of,
)
from planar_cli.problem.language.expression import Name, Quantity
from planar_cli.problem.language.parser import parse_found, parse_side, parse_statement

START = Mark("f", 1, 1)
NAMES = {
    "m": Kind(units.MASS),
    "l": Kind(units.LENGTH),
    "F": Kind(units.FORCE),
    "g": Kind(units.ACCELERATION),
    "k": Kind(units.STIFFNESS),
    "theta": ANGLE,
}


def lookup(node: Name | Quantity) -> Kind | None:
    return NAMES.get(node.name) if isinstance(node, Name) else None


def problems(text: str) -> list[Diagnostic]:
    report: list[Diagnostic] = []
    check_statement(parse_statement(text, START), lookup, report)
    return report


@pytest.mark.parametrize(
    "text",
    [
        "F = m*g",
        "F - m*g = 0",
        "l = 0",
        "theta = 0.5*pi",
        "theta = 30 deg",
        "sin(theta) = 0.5",
        "sqrt(2*g*l) = 3 m/s",
        "mode(C) = stick",
        "omega(b) = (pi/4) rad/s",
        "dot(theta) = 3 rad/s",
        "ddot(r(P).mag) = 3 m/s^2",
        "v(P).angle = 45 deg",
        "v(B/A).along(theta) = 3 km/h",
        "KE(P) @ 2/KE(P) @ 1 = 0.5",
        "omega(A)/omega(B) = 2",
        "moment(A) = 2 N*m",
        "F = 2 lbf",
        "l < infinity",
        "k*l^2/2 = work(s) @ 1->2",
        "impulse(f/P) @ 1->2 = 3 N*m*s",
        "impulse(f).x @ 1->2 = 3 N*s",
        "count(x(P) = 0) @ 1->2 = 3",
        "a(P).n = v(P).mag^2/rho(P)",
        "x(P) = unknown_name*3",
        "t = 4 s",
        "mean(F) @ 1->2 = 3 N",
        "atan(1) = theta",
        "exp(-l/(2 m)) = 0.5",
        "y(P) is largest",
        "at rest",
    ],
)
def test_agrees(text: str) -> None:
    assert problems(text) == []


@pytest.mark.parametrize(
    ("text", "code", "column", "words"),
    [
        ("F = m*l", "PL221", 1, "a force (N) is set equal to a quantity in kg*m"),
        ("F < l", "PL221", 1, "compared with a length"),
        ("F = 3", "PL225", 5, "a force (N)"),
        ("theta = 30", "PL225", 9, "an angle"),
        ("F + l = 0", "PL220", 3, "a length (m) is added to a force (N)"),
        ("F - l = 0", "PL220", 3, "subtracted from"),
        ("F + 3 = 0", "PL220", 3, "a pure number"),
        ("sin(l) = 1", "PL222", 5, "a length"),
        ("v(P).along(2*l) = 3 m/s", "PL222", 12, "a direction"),
        ("l^m = 3", "PL223", 3, "a mass"),
        ("l^theta = 3", "PL223", 3, "a length"),
        ("(3 m) m = l", "PL224", 2, "a pure number"),
        ("mode(C) = 3", "PL226", 1, "a mode"),
        ("mode(C) > slip", "PL226", 1, "a mode"),
        ("stick + 1 = 2", "PL226", 1, "a mode"),
        ("path(P) = 3 m", "PL226", 1, "a curve"),
        ("count(x(P) = F) @ 1->2 = 3", "PL221", 7, "a length"),
    ],
)
def test_disagrees(text: str, code: str, column: int, words: str) -> None:
    found = problems(text)
    assert found
    assert (found[0].code, found[0].mark.column) == (code, column)
    assert words in found[0].message
    assert code in CODES


def test_hints_for_units_taken_for_something_else() -> None:
    assert "lbf" in problems("F = 2 lb")[0].hint
    assert "2*g" in problems("g = 2 g")[0].hint
    assert "hour" in problems("l = 2 h")[0].hint


def test_expected_dimension() -> None:
    report: list[Diagnostic] = []
    for text in ("30", "30 N", "0", "3 kg", "infinity"):
        check_side(parse_side(text, START), units.MASS, lookup, report)
    assert [d.code for d in report] == ["PL225", "PL224"]
    report.clear()
    for text in ("30", "30 deg", "0", "pi/4"):
        check_side(parse_side(text, START), units.PURE, lookup, report, angle=True)
    assert [d.code for d in report] == ["PL225"]
    report.clear()
    check_side(parse_side("0.3", START), units.PURE, lookup, report)
    assert report == []


def test_finds() -> None:
    report: list[Diagnostic] = []
    assert check_found(parse_found("v(P) @ 2 in km/h", START), lookup, report).dimension == units.VELOCITY
    assert check_found(parse_found("mode(C) = stick", START), lookup, report).word == "true or false"
    assert check_found(parse_found("stable(1)", START), lookup, report).word == "true or false"
    assert report == []
    check_found(parse_found("v(P) @ 2 in N", START), lookup, report)
    check_found(parse_found("mode(C) in N", START), lookup, report)
    assert [d.code for d in report] == ["PL227", "PL227"]


def test_angle_is_remembered() -> None:
    kinds = {"theta/t": True, "theta/2": True, "theta/theta": False, "theta*l": False}
    # In parts of pi it is a number of turns.
    kinds |= {"theta/(2*pi)": False, "theta/pi": False, "theta*pi": True, "theta/(pi*t)": True}
    found = {text: dimension_of(parse_side(text, START), lookup).angle for text in kinds}
    assert found == kinds


@pytest.mark.parametrize(
    "text",
    [
        "l*log(m) - g/2*t^2 - l*log(m - 2 kg)",
        "-(log(F) - log(m) - log(g))",
        "2*log(l) - log(F/k*l)",
        "log(m)*l - l*(log(2*m) + 3)",
    ],
)
def test_logarithms_that_make_up_for_each_other(text: str) -> None:
    report: list[Diagnostic] = []
    dimension_of(parse_side(text, START), lookup, report)
    assert not report


@pytest.mark.parametrize("text", ["log(m)", "log(m) + log(m)", "log(F) - log(m)", "l*log(m) - 2*l*log(m)"])
def test_logarithms_that_depend_on_the_unit(text: str) -> None:
    report: list[Diagnostic] = []
    dimension_of(parse_side(text, START), lookup, report)
    assert {d.code for d in report} == {"PL222"}
