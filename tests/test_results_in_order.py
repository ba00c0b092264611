"""Results are told in the order of the files and of the rows in them, however the workers come to them."""

from __future__ import annotations

from planar_cli.homework.submissions.grader import Piece
from planar_cli.homework.submissions.in_order import InOrder
from planar_cli.homework.tasks.results import Line


def line(file: str, part: int = 0, parts: int = 1) -> Line:
    return Line(file, part, parts, "content", "key", "ok", f"{file}{part}", "")


def told(pieces: list[Piece], lines: list[Line]) -> list[list[str]]:
    """What was told after each line, and at the end."""
    heard: list[str] = []
    order = InOrder(lambda one: heard.append(one.student))
    assert list(order.expecting(pieces)) == pieces
    found = []
    for one in lines:
        order.hear(one)
        found.append(list(heard))
    order.close()
    return [*found, heard]


def test_what_comes_too_early_waits_for_what_stands_before_it() -> None:
    pieces = [Piece("a"), Piece("b"), Piece("c")]
    assert told(pieces, [line("b"), line("a"), line("c")]) == [[], ["a0", "b0"], ["a0", "b0", "c0"], ["a0", "b0", "c0"]]


def test_rows_of_a_table_go_on_as_they_come() -> None:
    pieces = [Piece("t"), Piece("u")]
    rows = [line("u"), line("t", 0, 3), line("t", 2, 3), line("t", 1, 3)]
    assert [len(one) for one in told(pieces, rows)] == [0, 1, 1, 4, 4]


def test_of_a_table_that_was_begun_only_the_rest_is_expected() -> None:
    pieces = [Piece("t", (1, 3), "content", 4), Piece("u")]
    assert told(pieces, [line("t", 3, 4), line("t", 1, 4), line("u")])[-2] == ["t1", "t3", "u0"]


def test_a_table_that_was_changed_meanwhile_is_expected_as_it_is() -> None:
    pieces = [Piece("t", (1,), "before", 4), Piece("u")]
    assert told(pieces, [line("t", 0, 2), line("t", 1, 2), line("u")])[-2] == ["t0", "t1", "u0"]


def test_a_file_that_is_named_twice_is_told_twice() -> None:
    assert told([Piece("a"), Piece("a")], [line("a"), line("a")])[-1] == ["a0", "a0"]


def test_a_run_that_ends_early_tells_what_has_come() -> None:
    assert told([Piece("a"), Piece("b"), Piece("c")], [line("c"), line("b")]) == [[], [], ["b0", "c0"]]
