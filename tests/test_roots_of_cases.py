"""A root that another case asks for is not dropped: it is that of the other case."""

from __future__ import annotations

from conftest import PROBLEMS
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate

FILES = {p.stem: p for p in PROBLEMS}


def test_both_courses_of_a_boat() -> None:
    page = Terminal(100).render(narrate(worked(FILES["boat-with-two-courses"])[0]))
    words = " ".join(page.split())
    assert "the other root, 126.9°, is that of case slow" in page
    assert "(3), the other root: β = π - arcsin(v_stream,y/w) = 180° - arcsin(4/5) = 126.9°" in words
    assert "is that of case fast" not in page
    assert "other roots" not in page
    assert "w_min is smallest where v_boat/stream is perpendicular to v_boat: it then only cancels the part" in words


def test_a_root_that_no_case_asks_for() -> None:
    page = Terminal(100).render(narrate(worked(FILES["whirling-collar"])[0]))
    assert "other roots: -1.621 rad/s (given: w > 0)" in page
