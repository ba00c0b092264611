"""Numbers that do not fulfil an equation of their instant are no answer: the refusal says which one, and where."""

from __future__ import annotations

from decimal import Decimal
from pathlib import Path

import pytest

from planar_cli import cli
from planar_cli.solve.instant import verify

BLOCK = """title: Block on a slope
plane: vertical
points: {P: [0, 0]}
surfaces: {slope: {through: P, angle: 17 deg}}
bodies: {block: {particle: P, mass: 3 kg}}
joints:
  - contact: {between: [block, slope], at: P, mu: 0}
instant: [at rest]
find: {a: a(block).mag, N: N(P)}
"""


def test_what_is_left_over_has_a_place(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    # Sixty digits leave something in the last ones, which is no remainder but here.
    monkeypatch.setattr(verify, "AGREE", Decimal("1e-80"))
    path = tmp_path / "block.yaml"
    path.write_text(BLOCK, encoding="utf-8")
    assert cli.run(["solve", str(path)]) == cli.UNDECIDED
    told = capsys.readouterr()
    assert not told.out
    assert "block.yaml:" in told.err
    assert "PL721 the numbers that were found do not fulfil " in told.err
    assert "of the size of its terms is left over" in told.err
    assert "^" in told.err
