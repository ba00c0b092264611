"""A sample of the mutants of `tests/mutations.py`: no fault, and nothing that is stated is ignored. More are slow."""

from __future__ import annotations

import random
from collections import Counter
from dataclasses import replace
from pathlib import Path

import mutants
import mutation_record
import mutations
import pytest
from conftest import ROOT
from mutation_record import Part

from planar_cli.problem.nodes import nodes

FILES = (
    "friction/crate-pulled",
    "kinematics/slider-crank-offset",
    "motion/block-fading-force",
    "particles/atwood-machine",
    "rigid-bodies/gyration-from-test",
    "textbook/ex-4-05",
)
SAMPLE = 20


def offenders(results: list[mutations.Judged]) -> list[str]:
    return [f"{j.file}:{j.place} {j.what}: {j.outcome} {j.detail}" for j in results if j.offends]


def test_a_sample_of_mutants(tmp_path: Path) -> None:
    files = [str(ROOT / "problems" / f"{name}.yaml") for name in FILES]
    results = tmp_path / "results.jsonl"
    judged = mutations.run(files, mutants.KINDS, SAMPLE, 1, results)
    assert len(judged) == SAMPLE
    assert offenders(judged) == []


def test_a_run_goes_on_where_it_broke_off(tmp_path: Path) -> None:
    results = tmp_path / "results.jsonl"
    files = [str(ROOT / "problems" / f"{FILES[0]}.yaml")]
    whole = mutations.run(files, ["unit", "name"], None, 1, results)
    lines = results.read_text().splitlines()
    offender = lines[0].replace('"outcome": "refused"', '"outcome": "fault"')
    results.write_text("\n".join([offender, *lines[1:-1]]) + "\n")
    again = mutations.run(files, ["unit", "name"], None, 1, results)
    assert {(j.key, j.outcome) for j in again} == {(j.key, j.outcome) for j in whole}
    # One that was left and one that offended were judged, no other.
    assert len(results.read_text().splitlines()) == len(lines) + 1


def test_a_record_leaves_out_what_it_tells(tmp_path: Path) -> None:
    """A file of which all mutants of a kind were judged has a line; one that lacks a mutant or has an offender none."""
    file = str(ROOT / "problems" / f"{FILES[0]}.yaml")
    whole = mutations.run([file], ["unit", "name"], None, 1, tmp_path / "results.jsonl")
    digest = mutations.digest_of(file)
    there = Counter(Part(file, digest, j.kind) for j in whole)
    record = mutation_record.extended({}, whole, there)
    assert {part.kind for part in record} == {"unit", "name"}
    assert sum(counts.total() for counts in record.values()) == len(whole)
    mutation_record.write(tmp_path / "record.tsv", record)
    assert mutation_record.recorded(tmp_path / "record.tsv") == record
    unit = [j for j in whole if j.kind == "unit"]
    assert {part.kind for part in mutation_record.extended({}, unit[1:], there)} == set()
    fault = [replace(unit[0], outcome="fault"), *unit[1:]]
    assert mutation_record.extended({}, fault, there) == {}
    assert mutations.run([file], ["unit", "name"], None, 1, tmp_path / "more.jsonl", recorded=record) == []


def test_a_fault_in_reading_is_judged_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(*_: object) -> mutations.Outcome:
        raise KeyError("x")

    monkeypatch.setattr(mutations, "read", fails)
    results = tmp_path / "results.jsonl"
    judged = mutations.run([str(ROOT / "problems" / f"{FILES[0]}.yaml")], ["unit"], None, 1, results)
    assert {j.outcome for j in judged} == {mutations.FAULT}
    assert len(results.read_text().splitlines()) == len(judged)


def test_what_comes_of_a_child(monkeypatch: pytest.MonkeyPatch) -> None:
    """A fault is told with its name, one that takes too long is killed."""
    file = str(ROOT / "problems" / f"{FILES[0]}.yaml")
    (mutant, *_) = [m for m in mutants.mutants(file) if m.kind == "number"]
    task = mutations.FileRun(file, 1)
    assert task.base.kind == mutations.SOLVED

    def fails(*_: object) -> mutations.Outcome:
        raise KeyError("x")

    monkeypatch.setattr(mutations, "solved", fails)
    outcome, detail = task.judged(mutant)
    assert outcome == mutations.FAULT
    assert detail.startswith("KeyError: 'x' (test_mutations.py:")

    def never_ends(*_: object) -> mutations.Outcome:
        while True:
            pass

    monkeypatch.setattr(mutations, "solved", never_ends)
    assert task.judged(mutant)[0] == mutations.UNDECIDED


def test_every_kind_of_change_is_made() -> None:
    made = [m for name in FILES for m in mutants.mutants(str(ROOT / "problems" / f"{name}.yaml"))]
    assert {m.kind for m in made} == set(mutants.KINDS)
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
    "energy/cylinder-down-a-slope-and-on-along-a-floor.yaml:22:29": ("(-4) m", "PL621"),
    "kinematics/disk-in-circular-track.yaml:17:52": ("rho(G) -> ", "PL637"),
    "kinematics/ball-in-a-forked-slot.yaml:11:20": ("P -> O", "PL467"),
    "energy/sledge-down-a-slope-and-out-over-level-snow.yaml:15:5": ("without {contact", "PL621"),
    "kinematics/belt-drive.yaml:13:17": ("A -> B", "PL467"),
    "hard/cradle-of-three-balls.yaml:10:18": ("B -> C", "PL528"),
    "oscillations/block-coming-to-rest-by-dry-friction.yaml:7:58": ("-0.4 m", "PL454"),
    "impact/three-carriages.yaml:9:68": ("-32.2", "PL454"),
    "momentum/bicycle-driven-and-braked.yaml:32:11": ("-10", "PL723"),
    "systems/gas-force-on-piston.yaml:23:31": ("B -> O", "PL465"),
    "motion/car-on-a-circle.yaml:13:10": ("without", "PL451"),
    "motion/parachutist.yaml:7:22": ("-0.24", "PL454"),
    "motion/train-braking-on-a-curve.yaml:16:18": ("(-54)", "PL454"),
}
"""Mutants that once ended in a fault: where, what is changed, and what they are told now."""


LEFT_OPEN = {
    "energy/yo-yo.yaml:25:11": ("without y(G) = -h", "PL623"),
    "energy/crate-winched-up-a-slope.yaml:21:7": ("without s = 0", "PL623"),
}
"""Mutants that leave something open, of which many values were tried."""


@pytest.mark.slow
@pytest.mark.parametrize("where", FAULTS | LEFT_OPEN)
def test_mutants_that_have_no_answer(where: str) -> None:
    name, _, place = where.partition(":")
    file, (what, codes) = str(ROOT / "problems" / name), (FAULTS | LEFT_OPEN)[where]
    (mutant,) = [m for m in mutants.mutants(file) if m.place == place and what in m.what]
    _, root, _ = nodes.read_file(file)
    assert root is not None
    read = mutations.read(file, root, mutant)
    outcome = read if isinstance(read, mutations.Outcome) else mutations.solved(read)
    assert outcome.kind in ("refused", "no solution")
    assert outcome.detail == codes


IMPLIED = {
    "motion/pin-in-circular-groove.yaml:19:5": "without {guide",
    "motion/pin-in-circular-groove.yaml:18:20": "P -> O",
    "kinematics/geneva-wheel.yaml:18:5": "without {pin",
}
"""Statements that follow from others, by which their contraries are refused."""


@pytest.mark.parametrize("where", IMPLIED)
def test_what_is_implied_can_not_be_denied(where: str) -> None:
    name, _, place = where.partition(":")
    file = str(ROOT / "problems" / name)
    (mutant,) = [m for m in mutants.mutants(file) if m.place == place and IMPLIED[where] in m.what]
    assert mutations.FileRun(file, 60).judged(mutant)[0] == "implied"


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_more_mutants(seed: int, tmp_path: Path) -> None:
    files = sorted(str(p) for p in (ROOT / "problems").rglob("*.yaml") if p.stat().st_size < 1200)
    some, results = random.Random(seed).sample(files, 40), tmp_path / "results.jsonl"
    judged = mutations.run(some, mutants.KINDS, 200, seed, results, jobs=2, limit=60)
    assert offenders([j for j in judged if j.outcome == mutations.FAULT]) == []
