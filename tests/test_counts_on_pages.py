"""What is counted has a line: what happens, when, and how often, under the name that is asked for."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(("stem", "line"), [
    ("there-and-back", "⇒ v = 0 at 1 s, 3 s: stops = 2"),
    ("body-flywheel-of-many-turns", "1.772 s, 2.047 s, 2.288 s, 2.507 s, …, 5.967 s: n = 34"),
])  # fmt: skip
def test_how_often_something_happens(stem: str, line: str) -> None:
    assert line in page_of_file(stem)
