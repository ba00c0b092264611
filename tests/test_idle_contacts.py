"""Of a contact whose normal force no equation has nothing is assumed."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(("stem", "told"), [("ex-1-07", False), ("block-force-table", False), ("ex-4-16", True)])
def test_it_is_told_where_the_force_is_found(stem: str, told: bool) -> None:
    assert ("stays in contact" in page_of_file(stem)) is told
