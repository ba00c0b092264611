"""The shelves: every member is registered once, documented, and its example can be read; principles solve theirs.

That every joint and load stands in a scene and in a motion is demanded in test_joint_residuals and test_moving_shelves.
"""

from __future__ import annotations

import dataclasses
import textwrap
from typing import Any

import pytest

from planar_cli.manual import explanation
from planar_cli.problem.scene.keys import keys_of
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.structure import load_text
from planar_cli.registry import members, modules
from planar_cli.solve.run import solve_problem

HEADINGS = ["Meaning", "YAML", "Equations", "Signs", "Valid when", "Reference"]
MEMBERS = [(shelf, kind) for shelf in ("joints", "loads") for kind in members(shelf)]
PRINCIPLES = sorted(members("principles"))
IN_LANGUAGE = {
    "joints": "pin weld guide link rolling belt contact flat rope impact",
    "loads": "weight force torque spring damper drag impulse stream",
}
"""What a problem file may name."""


def example(kind: str) -> Problem:
    """The file that the manual page of a member shows."""
    snippet = explanation(kind).partition("\nYAML\n")[2].partition("\nEquations\n")[0]
    problem, wrong = load_text(textwrap.dedent(snippet), f"{kind}.yaml")
    assert wrong == []
    assert problem is not None
    return problem


def member(shelf: str, kind: str) -> Any:
    return members(shelf)[kind]


@pytest.mark.parametrize(("shelf", "kinds"), IN_LANGUAGE.items())
def test_all_of_the_language_is_there(shelf: str, kinds: str) -> None:
    """A member may be added without a word here; none of these may be missing."""
    assert set(kinds.split()) <= set(members(shelf))


@pytest.mark.parametrize("shelf", ["joints", "loads", "principles"])
def test_one_member_a_file(shelf: str) -> None:
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


@pytest.mark.parametrize("kind", [*(kind for _, kind in MEMBERS), *PRINCIPLES])
def test_manual_page(kind: str) -> None:
    lines = explanation(kind).splitlines()
    assert [line for line in lines if line in HEADINGS] == HEADINGS
    assert max(len(line) for line in lines) <= 120


@pytest.mark.parametrize(("shelf", "kind"), MEMBERS)
def test_the_manual_page_names_every_key(shelf: str, kind: str) -> None:
    page = explanation(kind)
    for spec in keys_of(member(shelf, kind)):
        assert spec.doc
        assert f"    {spec.name} " in page


@pytest.mark.parametrize(("shelf", "kind"), MEMBERS)
def test_the_example_of_the_page_is_a_valid_file_that_uses_the_member(shelf: str, kind: str) -> None:
    problem = example(kind)
    if kind != "weight":
        assert kind in {m.kind for m in (*problem.joints, *problem.loads)}


@pytest.mark.parametrize("kind", PRINCIPLES)
def test_the_example_of_a_principle_is_solved_by_it(kind: str) -> None:
    problem = example(kind)
    assert problem.method == kind
    (part,) = solve_problem(problem).parts
    assert len(part.found) == len(problem.find)


@pytest.mark.parametrize("kind", PRINCIPLES)
def test_a_principle_offers_equations(kind: str) -> None:
    principle = member("principles", kind)
    assert any(principle.offers(when) for when in ("at_instant", "over", "across"))


def test_one_principle_is_the_usual_one() -> None:
    assert sum(member("principles", kind).usual for kind in PRINCIPLES) == 1


def test_rope_begins_with_a_drawing() -> None:
    page = explanation("rope")
    assert page.index("over D") < page.index("Meaning")
    assert page.index("T on drum") < page.index("Meaning")
