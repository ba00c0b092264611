"""Hints at keys that a joint has not, and no second message about what an unreadable find asks."""

from __future__ import annotations

import pytest

from planar_cli.problem.structure import load_text

ARM = """
title: A ball on an arm
plane: vertical
points: {O: [0, 0], P: [1 m, 0], C: [2 m, 0]}
bodies:
  OC: {rod: [O, C]}
  ball: {particle: P, mass: 1 kg}
joints:
  - pin: {at: O, between: [ground, OC]}
  - JOINT
instant: [at rest]
find: {F: N(P), a: ASKED}
answers: {a: 3 m/s^2}
"""
GUIDE = "guide: {point: P, along: OC}"


def told(joint: str, asked: str = "a(P).x") -> list[tuple[str, str, str]]:
    _, diagnostics = load_text(ARM.replace("JOINT", joint).replace("ASKED", asked))
    return [(d.code, d.message, d.hint) for d in diagnostics]


@pytest.mark.parametrize(
    ("joint", "key", "hint"),
    [
        ("guide: {point: P, on: OC}", "on", "write `point: P, along: OC`"),
        ("guide: {point: P, direction: 30 deg}", "direction", "write `point: P, along: 30 deg`"),
        ("contact: {between: [ball, OC], mu: 0, on: OC}", "on", "write both in `between: [spool, floor], at: C`"),
        ("rope: {from: O, path: [O, P]}", "from", "write `path: [A, over D, B]`"),
        (
            "pin: {at: P, between: [OC, ball], k: 3 N/m}",
            "k",
            "allowed are at, between, friction_torque, name and during",
        ),
    ],
)
def test_a_hint_speaks_of_keys_that_the_member_has(joint: str, key: str, hint: str) -> None:
    found = next(d for d in told(joint) if d[0] == "PL310")
    assert found[1].startswith(f"unknown key '{key}' in the ")
    assert found[2] == hint


@pytest.mark.parametrize(
    ("joint", "message"),
    [
        (
            "contact: {between: [ball, OC]}",
            "the contact takes mu, or mu_s and mu_k, or mu_s, or mu_k, or friction; none of these is given",
        ),
        ("guide: {along: OC}", "the guide takes point, or body; neither is given"),
        ("guide: {point: P, body: ball, along: OC}", "the guide takes point, or body; here is body and point"),
    ],
)
def test_what_is_given_of_a_choice(joint: str, message: str) -> None:
    assert message in [m for code, m, _ in told(joint) if code == "PL314"]


@pytest.mark.parametrize("asked", ["coriolis(P, OC).mag", "v("])
def test_nothing_more_about_the_answer_to_an_unreadable_find(asked: str) -> None:
    assert len(told(GUIDE, asked)) == 1


def test_nothing_more_about_answers_to_a_list_of_finds() -> None:
    text = ARM.replace("JOINT", GUIDE).replace("{F: N(P), a: ASKED}", "[a(P).x]")
    _, diagnostics = load_text(text)
    assert [d.code for d in diagnostics] == ["PL301"]
