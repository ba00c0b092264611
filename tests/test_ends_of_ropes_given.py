"""Where an end of a rope is stands among the data where its velocity depends on it."""

from __future__ import annotations

from pathlib import Path

import pytest
from worked import page_of_text

COLLAR = """\
title: Collar with a rope over a pulley
plane: horizontal
given: {{u: 2 m/s}}
points: {{P: [0, 0], A: [{x}, -4 m], B: [0, -2 m]}}
bodies:
  collar: {{particle: A}}
  load: {{particle: B}}
joints:
  - guide: {{point: A, along: 90 deg}}
  - guide: {{point: B, along: 90 deg}}
  - rope: {{path: [A, P, B], name: cord}}
instant: [v(A).y = -u]
find: {{v_B: v(B).y}}
"""


@pytest.mark.parametrize(("x", "told"), [("3 m", True), ("0", False)])
def test_an_end_at_a_slant_is_given(x: str, told: bool, tmp_path: Path) -> None:
    assert ("A(3, -4) m (collar)" in page_of_text(tmp_path, COLLAR.format(x=x))) is told
