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


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_more_mutants(seed: int) -> None:
    files = sorted(str(p) for p in (ROOT / "problems").rglob("*.yaml") if p.stat().st_size < 1200)
    results = mutations.run(random.Random(seed).sample(files, 40), mutations.KINDS, 200, seed, 2, 60)
    faults = [r for r in results if r[1] == mutations.FAULT]
    assert offenders(faults) == []
