"""Every kind of joint and load in a motion over time: solved, agreeing with known results, checked by other roads."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.registry import members

SCENES: dict[str, str | None] = yaml.safe_load((Path(__file__).parent / "moving_scenes.yaml").read_text())
MOVING = sorted(kind for kind, text in SCENES.items() if text)


def test_every_kind_has_a_scene() -> None:
    assert set(SCENES) == {*members("joints"), *members("loads")}


@pytest.mark.parametrize("kind", MOVING)
def test_a_kind_in_a_motion(kind: str, tmp_path: Path) -> None:
    text = SCENES[kind]
    assert text is not None
    path = tmp_path / f"{kind}.yaml"
    path.write_text(text, encoding="utf-8")
    solution, verdicts = solve_and_compare(read(str(path)))
    problem = solution.problem
    assert kind in {m.kind for m in (*problem.joints, *problem.loads)} | {"weight"}
    assert len(verdicts) == len(problem.answers)
    assert not [v.message for v in verdicts if not v.agrees]
