"""Angles that a file writes as numbers are those of a file with letters, for what students do wrong with them."""

from __future__ import annotations

from pathlib import Path

import pytest
from homework_made import mistakes_of

from planar_cli.homework.variants.literal_data import with_names
from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar, read_text

SLOPE = """
title: Crate down a slope, pulled back by a cord
plane: vertical
points: {O: [0, 0], A: [0, 0]}
surfaces: {slope: {through: O, angle: -30 deg}}
bodies: {crate: {particle: A, mass: 12 kg}}
joints: [contact: {between: [crate, slope], at: A, mu: 0.2}]
loads: [force: {body: crate, magnitude: 10 N, angle: 165 deg}]
instant: [at rest]
find: {a: a(crate).mag, N: N(A)}
"""
NAMED = (
    SLOPE.replace("plane: vertical", "plane: vertical\ngiven: {beta: 30 deg, delta: 15 deg}")
    .replace("-30 deg", "-beta")
    .replace("165 deg", "180 deg - delta")
)


def mistakes(folder: Path, text: str) -> dict[str, list[tuple[str, str, tuple[float, ...]]]]:
    return {e.find: sorted((m.name, m.feedback, m.values) for m in e.mistakes) for e in mistakes_of(folder, text)}


def test_mistakes_with_numbers_are_those_with_letters(tmp_path: Path) -> None:
    written, named = mistakes(tmp_path, SLOPE), mistakes(tmp_path, NAMED)
    for find, expected in named.items():
        told = [(n, f.replace("β", "30°").replace("δ", "15°")) for n, f, _ in expected]
        assert sorted((n, f) for n, f, _ in written[find]) == sorted(told)
    assert any(n == "sine-for-cosine" for n, _, _ in written["a"])
    assert any(n == "degrees-as-radians" for n, _, _ in written["a"])


@pytest.mark.parametrize(
    ("angle", "named"),
    [
        ("30 deg", "literal_angle_30"),
        ("-30 deg", "-literal_angle_30"),
        ("150 deg", "180 deg - literal_angle_30"),
        ("210 deg", "180 deg + literal_angle_30"),
        ("-150 deg", "-180 deg + literal_angle_30"),
        ("22.5 deg", "literal_angle_22p5"),
        ("90 deg", "90 deg"),
        ("0", "0"),
        ("beta", "beta"),
    ],
)
def test_angles_count_from_the_nearest_level_line(angle: str, named: str) -> None:
    node, _ = read_text(f"surfaces: {{s: {{through: [0, 0], angle: {angle}}}}}\n", "x")
    assert node is not None
    assert text_at(with_names(node), "surfaces", "s", "angle") == named


def text_at(node: Node | None, *keys: str) -> str:
    for key in keys:
        assert isinstance(node, Mapping)
        node = node.get(key)
    assert isinstance(node, Scalar)
    return node.text
