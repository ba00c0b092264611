"""Signs that formulas have whatever their letters are, and sizes that are none."""

from __future__ import annotations

from pathlib import Path

import pytest

from planar_cli.problem.structure import load

ROD = """plane: vertical
given: {k: 2, n: -3, z: 0 m}
symbols: {R: m, d: m}
points: {A: [0, 0], B: [R, 0]}
bodies: {rod: {rod: [A, 0 deg], length: LENGTH, mass: 2 kg}}
joints:
  - pin: {at: A, between: [ground, rod]}
instant: [at rest]
find: {al: alpha(rod)}
"""


@pytest.mark.parametrize(
    "length", ["-2*R", "n*R", "-(R + d)", "-R - d", "R/n", "-sqrt(R*d)", "z", "-exp(k)*R", "R*n^2*n"]
)
def test_sizes_that_are_none(length: str, tmp_path: Path) -> None:
    path = tmp_path / "rod.yaml"
    path.write_text(ROD.replace("LENGTH", length), encoding="utf-8")
    found = load(str(path))[1]
    assert [(d.code, d.message) for d in found] == [("PL454", "the length of the body rod is not more than zero")]


@pytest.mark.parametrize("length", ["2*R", "R - d", "n^2*R", "-n*R", "R + d/n", "sqrt(R*d)", "R*cos(k)", "k*R"])
def test_sizes_that_may_be(length: str, tmp_path: Path) -> None:
    path = tmp_path / "rod.yaml"
    path.write_text(ROD.replace("LENGTH", length), encoding="utf-8")
    assert [d for d in load(str(path))[1] if d.code == "PL454"] == []
