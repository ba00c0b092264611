"""The whole problem files in the pages of the manual are solved, and agree with the answers that they state."""

from __future__ import annotations

from pathlib import Path

import pytest
from test_structure import whole_files

from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.manual import pages

TOPICS = {page: topic for topic, page in pages().items()}
FILES = [(f"{topic}-{i}", text) for page, topic in TOPICS.items() for i, text in enumerate(whole_files(page), 1)]


@pytest.mark.parametrize(("name", "text"), FILES, ids=[name for name, _ in FILES])
def test_a_file_of_a_page_is_solved(name: str, text: str, tmp_path: Path) -> None:
    path = tmp_path / f"{name}.yaml"
    path.write_text(text, encoding="utf-8")
    solution, verdicts = solve_and_compare(read(str(path)))
    assert not [v.message for v in verdicts if not v.agrees]
    assert all(part.found for part in solution.parts)
