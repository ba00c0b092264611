"""The JSON Schema: it is one, it accepts every good file, and it refuses what editors can know to be wrong."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import jsonschema
import pytest
from conftest import PROBLEMS

from planar_cli.problem.nodes.nodes import Mapping, Node, Sequence, read_file, read_text
from planar_cli.problem.sections.schema import schema

VALIDATOR = jsonschema.Draft7Validator(schema())


def data(node: Node | None) -> Any:
    """A tree as JSON, scalars by the core rules of YAML 1.2 as far as the schema can see them."""
    match node:
        case Mapping():
            return {key.text: data(value) for key, value in node.pairs}
        case Sequence():
            return [data(item) for item in node.items]
        case None:
            return None
    if node.quoted or node.text not in ("true", "false"):
        try:
            return node.text if node.quoted else float(node.text)
        except ValueError:
            return node.text
    return node.text == "true"


def errors(text: str) -> list[str]:
    node, _ = read_text(text, "file.yaml")
    return [error.message for error in VALIDATOR.iter_errors(data(node))]


def test_it_is_a_schema() -> None:
    jsonschema.Draft7Validator.check_schema(schema())


@pytest.mark.parametrize("path", PROBLEMS, ids=lambda p: f"{p.parent.name}/{p.stem}")
def test_every_problem_file(path: Path) -> None:
    _, node, _ = read_file(str(path))
    assert [error.message for error in VALIDATOR.iter_errors(data(node))] == []


@pytest.mark.parametrize(
    "text",
    [
        "plain: vertical",
        "plane: diagonal",
        "points: {A: 3 m}",
        "points: {1A: [0, 0]}",
        "points: {A: {from: B, distance: 3 m}}",
        "bodies: {b: {plate: A}}",
        "bodies: {b: {rod: [A, B], radius: 3 m}}",
        "joints: [{hinge: {at: A, between: [ground, b]}}]",
        "joints: [{pin: {at: A, between: [ground]}}]",
        "joints: [{pin: {at: A, bodies: [ground, b]}}]",
        "joints: [{contact: {at: A, between: [a, b]}}]",
        "joints: [{contact: {at: A, between: [a, b], mu: 0.2, mu_s: 0.3, mu_k: 0.1}}]",
        "joints: [{guide: {point: A, body: b, along: 0 deg}}]",
        "joints: [{rope: {path: [A]}}]",
        "joints: [{belt: {between: [a, b], crossed: maybe}}]",
        "loads: [{weight: {body: b}}]",
        "loads: [{force: {body: b, at: A, magnitude: 3 N}}]",
        "loads: [{spring: {between: [A, B], stiffness: 3 N/m, natural_length: 3 m, acts: both}}]",
        "instant: {omega: 3}",
        "cases: {c: {answers: {x: 3}}}",
    ],
)
def test_refused(text: str) -> None:
    assert errors(text)


@pytest.mark.parametrize(
    "text",
    [
        "states: {1: [at rest], top: [y(P) is largest]}",
        "joints: [{contact: {at: A, between: [a, b], mu_s: 0.3, mu_k: 0.1, name: c, during: 1->2}}]",
        "joints: [{belt: {between: [a, b], crossed: true}}]",
        "loads: [{force: {body: b, wound_at: T, magnitude: {table: [[0 s, 0 N], [1 s, 2 N]]}, towards: P}}]",
        "answers: {a: 3 m, b: [1 m, 0], c: true, d: {value: 3 m, tolerance: 0.1}}",
        "bodies: {b: {parts: [{disk: A, radius: 1 m, mass: 2 kg}]}, P: {particle: free, mass: any}}",
    ],
)
def test_accepted(text: str) -> None:
    assert errors(text) == []
