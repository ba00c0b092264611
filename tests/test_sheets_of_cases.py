"""What a sheet says of finds of a case, and of g in US units."""

from __future__ import annotations

from pathlib import Path

from planar_cli.cli import run

CRATE = """
title: Crate pulled, and pulled harder
text: A crate of {m} on a smooth floor is pulled by {P}.
plane: horizontal
given: {m: 40 kg, P: {one_of: [100 N, 200 N]}}
bodies: {crate: {particle: [0, 0], mass: m}}
loads: [force: {body: crate, magnitude: P, angle: 20 deg}]
instant: [at rest]
find: {a: a(crate).x}
cases:
  strong:
    given: {P: 300 N}
    find: {a_strong: a(crate).x}
"""
WEIGHT = """
title: Weight that falls
text: A weight falls through 10 ft. Find its speed.
plane: vertical
bodies: {W: {particle: [0, 10 ft], weight: 3 lbf}}
states: {1: [at rest], 2: [y(W) = 0]}
find: {v: v(W).mag @ 2}
"""


def sheet(folder: Path, text: str) -> str:
    (folder / "p.yaml").write_text(text)
    (folder / "set.yaml").write_text("problems: [p.yaml]\n")
    assert run(["key", str(folder / "set.yaml"), "-o", str(folder), "--format", "markdown"]) == 0
    return (folder / "sheet.md").read_text()


def test_a_case_is_told_with_its_data(tmp_path: Path) -> None:
    told = sheet(tmp_path, CRATE)
    assert "- $a$: x component of the acceleration of crate, in m/s²" in told
    assert "case strong (P = 300 N): x component of the acceleration of crate, in m/s²" in told


def test_gravity_has_the_units_of_the_file(tmp_path: Path) -> None:
    told = sheet(tmp_path, WEIGHT)
    assert "32.19" in told
    assert "9.81" not in told
