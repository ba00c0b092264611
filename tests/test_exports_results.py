"""What was graded, for Gradescope, for spreadsheets and for Canvas."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import replace
from typing import Any

import pytest
from exported import FORMULA, RESULTS, exported

from planar_cli.homework.sets.paper import Graded, Result

HEADER = "student,variant,problem,find,submitted,unit,expected,tolerance,score,max_score,status,message"
# What Gradescope's specification has.
TOP = {"score", "output", "output_format", "test_output_format", "tests", "extra_data"}
TEST = {"score", "max_score", "status", "name", "number", "output", "visibility"}


def gradescope(folder: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(exported("gradescope").files[f"{folder}/results.json"])
    return found


def rows(kind: str, results: Any = None, **others: Any) -> list[list[str]]:
    content, *_ = exported(kind, results, title="HW1", **others).files.values()
    return list(csv.reader(io.StringIO(content.decode("utf-8-sig"), newline="")))


def test_one_results_file_for_each_submission() -> None:
    assert len(exported("gradescope").files) == len(RESULTS)
    assert {"ada/results.json", "con_/results.json", "con-2/results.json"} <= exported("gradescope").files.keys()


@pytest.mark.parametrize("name", sorted(exported("gradescope").files))
def test_fields_are_those_of_the_specification(name: str) -> None:
    found = json.loads(exported("gradescope").files[name])
    assert found.keys() <= TOP
    assert "score" in found or found["tests"]
    for test in found["tests"]:
        assert test.keys() == TEST
        assert test["status"] in ("passed", "failed")
        assert isinstance(test["number"], str)
        assert 0 <= test["score"] <= test["max_score"]


def test_scores_are_rounded() -> None:
    assert gradescope("con_")["tests"][0]["score"] == 0.33333


def test_the_student_reads_no_key() -> None:
    contents = b"".join(exported("gradescope").files.values()).decode()
    assert "3.52 m/s²" not in contents
    assert "+0.25" not in contents


def test_output() -> None:
    first, second = gradescope("ada")["tests"]
    assert (first["number"], second["number"]) == ("1.1", "1.2")
    assert first["status"] == "passed"
    assert second["output"].splitlines() == [
        "wrong",
        "Read: -2.5",
        "-the value is not right",
        "Friction acts the other way.",
    ]


def test_what_follows_from_an_earlier_value_and_has_all_points_is_passed() -> None:
    def status(score: float) -> str:
        one = Graded("p", "a", "3 N", "wrong", score, 2.0, carried=("F",))
        content, *_ = exported("gradescope", (Result("s", 0, (one,)),), title="HW1").files.values()
        found: str = json.loads(content)["tests"][0]["status"]
        return found

    assert (status(2.0), status(1.0)) == ("passed", "failed")


def test_a_submission_without_answers_has_a_score() -> None:
    name = next(n for n in exported("gradescope").files if n.startswith("xxx"))
    found = json.loads(exported("gradescope").files[name])
    assert found["score"] == 0
    assert "no answers were found" in found["output"]


def test_the_gradebook_has_one_row_for_each_find() -> None:
    header, *others = rows("gradebook")
    assert ",".join(header) == HEADER
    assert len(others) == sum(len(r.graded) + len(r.wrong) for r in RESULTS)
    assert others[0] == ["ada", "1", "slider", "a_A", "3.52 m/s^2", "m/s^2", "3.52 m/s²", "0.01", "2", "2", "right", ""]


def test_formulas_of_spreadsheets_are_guarded_and_numbers_stay() -> None:
    _, *others = rows("gradebook")
    assert others[1][4] == "-2.5"
    assert others[1][11].startswith("'-the value")
    assert others[2][0] == f"'{FORMULA}"
    assert others[2][4] == "'@SUM(1)"
    assert others[3][6] == "+0.25"
    assert all(not cell.startswith(("=", "@", "\t", "\r")) for row in others for cell in row)


def test_what_cannot_be_graded_at_all_has_a_row() -> None:
    assert next(row for row in rows("gradebook") if row[0].startswith("xxx"))[10:] == [
        "ungradable",
        "'\tno answers were found",
    ]


def test_canvas_has_its_columns_and_points() -> None:
    header, points, first, *_ = rows("canvas")
    assert header == ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "HW1"]
    assert points == ["    Points Possible", "", "", "", "", "4"]
    assert first == ["ada", "", "", "ada", "", "2"]


def test_canvas_tells_who_has_no_score() -> None:
    ungraded = next(row for row in rows("canvas") if row[0].startswith("xxx"))
    assert ungraded[5] == ""
    told = exported("canvas").left_out
    assert any(s.endswith("no score, as nothing could be graded") for s in told)
    assert any("out of 2, not 4" in s for s in told)


def test_canvas_has_one_row_for_a_student_who_handed_in_twice() -> None:
    again = [replace(RESULTS[0], source=name) for name in ("b.csv", "c.csv")]
    lost = replace(RESULTS[0], graded=(), source="d.csv")
    first = replace(again[0], graded=())
    found = rows("canvas", (first, again[1], lost, *RESULTS[1:]))
    (own,) = (row for row in found if row[0] == RESULTS[0].student)
    assert float(own[-1]) == pytest.approx(again[1].score)
    assert any("3 submissions" in s for s in exported("canvas", (first, again[1], lost)).left_out)


def test_a_name_of_several_words_is_no_login() -> None:
    assert rows("canvas", (Result("Ada Lovelace", 0, ()),))[2][3] == ""


@pytest.mark.parametrize("kind", ["gradebook", "canvas"])
def test_a_byte_order_mark_only_where_it_is_asked_for(kind: str) -> None:
    plain, *_ = exported(kind).files.values()
    marked, *_ = exported(kind, excel=True).files.values()
    assert marked == b"\xef\xbb\xbf" + plain


def test_the_gradebook_has_a_row_with_the_total_of_each_student() -> None:
    _, totals = exported("gradebook").files.values()
    header, *others = totals.decode().splitlines()
    assert header == "student,variant,score,max_score"
    names = [row.split(",")[0] for row in others]
    assert len(names) == len(set(names)) > 1
