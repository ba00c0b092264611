"""A sample of the mutants of `tests/mutations.py`: no fault, and nothing that is stated is ignored. More are slow."""

from __future__ import annotations

import random

import mutations
import pytest
from conftest import ROOT

FILES = (
    "friction/crate-pulled",
    "kinematics/slider-crank-offset",
    "motion/block-fading-force",
    "particles/atwood-machine",
    "rigid-bodies/gyration-from-test",
    "textbook/ex-4-05",
)
SAMPLE = 60


def offenders(results: list[tuple[mutations.Mutant, str, str]]) -> list[str]:
    return [f"{m.file}:{m.place} {m.what}: {how} {why}" for m, how, why in results if mutations.offends(how, why)]


def test_a_sample_of_mutants() -> None:
    files = [str(ROOT / "problems" / f"{name}.yaml") for name in FILES]
    results = mutations.run(files, mutations.KINDS, SAMPLE, 1, 1, 60)
    assert len(results) == SAMPLE
    assert offenders(results) == []


def test_every_kind_of_change_is_made() -> None:
    made = [m for name in FILES for m in mutations.mutants(str(ROOT / "problems" / f"{name}.yaml"))]
    assert {m.kind for m in made} == set(mutations.KINDS)
    assert all(m.new != "" and m.what for m in made)


FAULTS = {
    "oscillations/block-falling-through-oil.yaml:26:47": ("without v(block).y", "PL604"),
    "friction/plate-sliding-on-table.yaml:16:11": ("without v(G).x", "PL604"),
    "friction/plate-sliding-on-table.yaml:16:29": ("without v(G).y", "PL604"),
    "friction/coin-on-a-table-that-gathers-speed.yaml:11:21": ("between ->", "PL310, PL311"),
    "friction/falling-pole.yaml:10:36": ("-40 deg", "PL601"),
    "momentum/sand-on-a-conveyor-belt.yaml:9:24": ("-1.2 m", "PL593"),
    "systems/double-pulley.yaml:19:27": ("S on A", "PL458"),
    "motion/car-three-phases.yaml:17:3": ("brake ->", "PL405"),
    "particles/slider-spring-damper.yaml:15:11": ("without", "PL604"),
}
"""Mutants that once ended in a fault: where, what is changed, and what they are told now."""


@pytest.mark.parametrize("where", FAULTS)
def test_mutants_that_ended_in_a_fault(where: str) -> None:
    name, _, place = where.partition(":")
    file, (what, codes) = str(ROOT / "problems" / name), FAULTS[where]
    (mutant,) = [m for m in mutations.mutants(file) if m.place == place and what in m.what]
    outcome = mutations.solved((file, mutant))
    assert outcome.kind in ("refused", "no solution")
    assert outcome.detail == codes


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_more_mutants(seed: int) -> None:
    files = sorted(str(p) for p in (ROOT / "problems").rglob("*.yaml") if p.stat().st_size < 1200)
    results = mutations.run(random.Random(seed).sample(files, 40), mutations.KINDS, 200, seed, 2, 60)
    faults = [r for r in results if r[1] == mutations.FAULT]
    assert offenders(faults) == []
