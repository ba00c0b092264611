"""Data are no numbered equations, and what stands under Given is not said again."""

from __future__ import annotations

import re
from decimal import Decimal

import pytest
from worked import page_of_file

from planar_cli.report.document.blocks import Equation, Heading, Name, Note, Paragraph, Value, line
from planar_cli.report.given.data import GIVEN
from planar_cli.report.page.data_numbers import without_numbered_data, without_restated_data


def _datum(name: str, number: int | None = None) -> Equation:
    return Equation((line(Name(name)), Value(Decimal(2), "m/s")), number, GIVEN)


def _relation(number: int | None, lead: str = "") -> Equation:
    return Equation((line(Name("v_B")), line(Name("v_A"))), number, line(lead) if lead else ())


def test_what_stands_behind_a_datum_moves_up() -> None:
    told = [
        _datum("v_A", 1),
        _relation(2),
        _relation(3),
        _relation(None, "(2) in (3):"),
        Heading("STEP 2", "", "(2) to (3)"),
    ]
    *_, last, heading = found = without_numbered_data(told, True)
    assert [b.number for b in found if isinstance(b, Equation)] == [None, 1, 2, None]
    assert isinstance(last, Equation)
    assert last.lead == line("(1) in (2):")
    assert isinstance(heading, Heading)
    assert heading.aside == "(1) to (2)"


@pytest.mark.parametrize("called", ["(1) in (2):", "(1) to (3):"])
def test_a_datum_that_is_called_keeps_its_number(called: str) -> None:
    told = [_datum("v_A", 1), _datum("v_C", 2), _relation(3), _relation(None, called)]
    assert without_numbered_data(told, True) == told


def test_each_state_counts_its_own() -> None:
    one = [Heading("STATE", "1"), _datum("v_A", 1), _relation(2)]
    found = without_numbered_data([*one, *one], False)
    assert [b.number for b in found if isinstance(b, Equation)] == [None, 1, None, 1]


def test_what_stands_under_given_is_not_said_again() -> None:
    given = Note(
        "Given",
        line(Name("v_A"), " = ", Value(Decimal(2), "m/s"), "; 2: ", Name("v_B"), " = ", Value(Decimal(2), "m/s")),
    )
    head = Paragraph(line("Velocities:"))
    assert without_restated_data([given, head, _datum("v_A"), Heading("STEP 2", "")]) == [given, Heading("STEP 2", "")]
    # What calls it by another letter, or calls it by its number, needs the line.
    told = without_restated_data([given, head, _datum("v_D"), _datum("v_A", 1)])
    assert told == [given, head, Equation(_datum("v_D").sides, None, (), line("given")), _datum("v_A", 1)]


def test_pages_number_no_datum_that_nothing_calls() -> None:
    assert "given" not in page_of_file("ex-2-09").partition("STEP 1")[2]
    assert not re.findall(r"\(\d+\) given:", page_of_file("slider-crank-offset"))
    assert "v_P = v constant speed" in page_of_file("ex-1-13")
