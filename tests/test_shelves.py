"""The shelves of joints and loads: every member is registered once, documented, and its example can be read."""

from __future__ import annotations

import dataclasses
import textwrap
from typing import Any

import pytest

from planar_cli.manual import explanation
from planar_cli.problem.keys import keys_of
from planar_cli.problem.structure import load_text
from planar_cli.registry import members, modules

HEADINGS = ["Meaning", "YAML", "Equations", "Signs", "Valid when", "Reference"]
MEMBERS = [(shelf, kind) for shelf in ("joints", "loads") for kind in members(shelf)]
IN_LANGUAGE = {
    "joints": "pin weld guide link rolling belt contact flat rope impact",
    "loads": "weight force torque spring damper drag impulse stream",
}


def member(shelf: str, kind: str) -> Any:
    return members(shelf)[kind]


@pytest.mark.parametrize("shelf", ["joints", "loads"])
def test_one_member_a_file_and_all_of_the_language(shelf: str) -> None:
    assert set(members(shelf)) == set(IN_LANGUAGE[shelf].split())
    assert set(modules(shelf)) == set(members(shelf))


@pytest.mark.parametrize(("shelf", "kind"), MEMBERS)
def test_a_member_is_a_final_frozen_dataclass(shelf: str, kind: str) -> None:
    cls = member(shelf, kind)
    assert dataclasses.is_dataclass(cls)
    assert cls.__dataclass_params__.frozen
    assert "__slots__" in vars(cls)
    assert cls.__name__.lower() == kind
    declared = {spec.name for spec in keys_of(cls)}
    for choice in cls.choices:
        assert choice.names() <= declared


@pytest.mark.parametrize(("shelf", "kind"), MEMBERS)
def test_manual_page(shelf: str, kind: str) -> None:
    page = explanation(kind)
    lines = page.splitlines()
    assert [line for line in lines if line in HEADINGS] == HEADINGS
    assert max(len(line) for line in lines) <= 120
    for spec in keys_of(member(shelf, kind)):
        assert spec.doc
        assert f"    {spec.name} " in page


@pytest.mark.parametrize(("shelf", "kind"), MEMBERS)
def test_the_example_of_the_page_is_a_valid_file_that_uses_the_member(shelf: str, kind: str) -> None:
    page = explanation(kind)
    snippet = page.partition("\nYAML\n")[2].partition("\nEquations\n")[0]
    problem, wrong = load_text(textwrap.dedent(snippet), f"{kind}.yaml")
    assert wrong == []
    assert problem is not None
    if kind != "weight":
        assert kind in {m.kind for m in (*problem.joints, *problem.loads)}


def test_rope_begins_with_a_drawing() -> None:
    page = explanation("rope")
    assert page.index("over D") < page.index("Meaning")
    assert page.index("T on drum") < page.index("Meaning")
