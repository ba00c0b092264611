"""A message about a member that lacks its names says that they lack, not something about things without a name."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from planar_cli import cli

FILE = """title: Beam
plane: vertical
points: {A: [0, 1 m], C: [0.5 m, 0], D: [1 m, 0]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {beam: {rod: [C, D], mass: 10 kg}, w: {disk: [2 m, 1 m], radius: 0.5 m, mass: 2 kg}}
MEMBER
instant: [at rest]
find: {a: a(beam).y}
"""
BARE = [f"joints: [{kind}: {{}}]" for kind in "belt contact flat guide impact link pin rolling rope weld".split()]
BARE += [f"loads: [{kind}: {{}}]" for kind in "damper drag force impulse spring stream torque".split()]


@pytest.mark.parametrize("member", [
    *BARE, "joints: [link: {between: [A]}]", "joints: [link: {between: []}]", "joints: [pin: {at: C, between: []}]",
    "joints: [rope: {path: []}]", "joints: [belt: {between: [w]}]", "loads: [spring: {between: []}]",
])  # fmt: skip
def test_no_name_is_blank(member: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "beam.yaml"
    path.write_text(FILE.replace("MEMBER", member), encoding="utf-8")
    assert cli.run(["solve", str(path)]) == cli.BAD
    said = [m[1] for m in re.finditer(r"^\S+:\d+:\d+: PL\d+ (.*)$", capsys.readouterr().err, re.MULTILINE)]
    assert said
    blank = r"^ | and  |  |''|\b(?:of|to|from|between|on|point) (?:and|is|are)\b|\b(?:of|to|from|on) ?$"
    assert not [text for text in said if re.search(blank, text)]
