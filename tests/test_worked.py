"""Pages of several workers: a golden file stands for its page only where the same run compares it with that."""

from __future__ import annotations

from pathlib import Path

import pytest
import worked
from conftest import PROBLEMS

STONE = next(p for p in PROBLEMS if p.stem == "stone-in-well")


@pytest.mark.parametrize("held", [True, False])
def test_a_golden_file_that_nothing_holds_is_no_page(
    held: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / f"{worked.name_of(STONE)}.solution.txt").write_text("as it was once", encoding="utf-8")
    monkeypatch.setattr(worked, "GOLDEN", tmp_path)
    monkeypatch.setattr(worked, "HELD", {STONE} if held else set())
    monkeypatch.setenv(worked.SEVERAL_WORKERS, "gw0")
    monkeypatch.delenv(worked.UPDATE, raising=False)
    assert (worked.page_of_file("stone-in-well") == "as it was once") is held
