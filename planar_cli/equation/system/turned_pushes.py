"""Reactions that count the other way than their joint has them: what they do is reversed, and each test of them."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from planar_cli.problem.scene.facts import Action, Mode, Push


def with_turned(mode: Mode, names: Collection[str]) -> Mode:
    """A mode in which these pushes count the other way."""
    if not any(push.name in names for push in mode.facts.pushes):
        return mode
    pushes = tuple(_reversed(p) if p.name in names else p for p in mode.facts.pushes)
    tests = tuple(
        replace(t, pushes=tuple((n, -factor if n in names else factor) for n, factor in t.pushes)) for t in mode.tests
    )
    return replace(mode, facts=replace(mode.facts, pushes=pushes), tests=tests)


def _reversed(push: Push) -> Push:
    actions = (Action(a.body, a.point, None if a.force is None else -a.force, -a.couple) for a in push.actions)
    return replace(push, actions=tuple(actions))
