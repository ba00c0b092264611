"""The equations of a solution carried out anew give its numbers, and those of the file with other data."""

from __future__ import annotations

import pytest
from conftest import ROOT
from homework_made import with_known_mistakes

from planar_cli.homework.variants.variants import variants_of
from planar_cli.homework.variants.worked_problem import base_expected, models_of, read_and_solve, with_numbers
from planar_cli.replay.numbers import Replay

SET = ROOT / "tests" / "homework"
FILES = sorted(p for p in SET.glob("*.yaml") if "problems:" not in p.read_text())
OTHERS = ("textbook/ex-4-05", "textbook/ex-2-09", "textbook/ex-4-14", "energy/block-down-a-slope-onto-a-buffer")


@pytest.mark.parametrize("path", [*FILES, *(ROOT / "problems" / f"{n}.yaml" for n in OTHERS)], ids=lambda p: p.stem)
def test_the_same_numbers(path: object) -> None:
    worked = read_and_solve(str(path), "p")
    expected = {e.find: e for e in base_expected(worked)}
    for part in worked.parts:
        assert part.replay is not None, part.why
        run = part.replay.run({})
        assert run.holds().all()
        for name in part.replay.equations.asked:
            numbers = [float(n[0]) for n in run.asked(name)]
            found = next(f for f in part.solution.found if f.name == name)
            assert numbers == pytest.approx([float(v) for v in found.values or ()], rel=1e-9, abs=1e-12)
            assert expected[name].values


@pytest.mark.parametrize("path", [p for p in FILES if p.stem in ("slope", "shot", "blow")], ids=lambda p: p.stem)
def test_variants_are_those_of_the_file_with_other_data(path: object) -> None:
    worked = read_and_solve(str(path), "p")
    found = variants_of(worked, 5, 5)
    assert len(found.taken) == 5
    assert not found.note
    middle = found.taken[2]
    anew = {e.find: e for e in base_expected(with_numbers(worked, dict(middle.draw.values)))}
    for expected in middle.expected:
        assert expected.values == pytest.approx(anew[expected.find].values, rel=1e-9)
        assert expected.text == anew[expected.find].text


def test_mistakes_come_to_what_a_hand_computes() -> None:
    """tan-free numbers of the slope: a = g (sin β ∓ μ cos β)."""
    worked = read_and_solve(str(SET / "slope.yaml"), "p")
    expected = with_known_mistakes(worked)
    # The first of each kind is that of all equations.
    a = {m.name: m.values[0] for m in reversed(expected[0].mistakes)}
    assert a["friction-left-out"] == pytest.approx(4.905)
    assert a["friction-reversed"] == pytest.approx(9.81 * (0.5 + 0.2 * 0.75**0.5))
    assert a["normal-force-is-weight"] == pytest.approx(9.81 * (0.5 - 0.2))
    assert a["sine-for-cosine"] == pytest.approx(9.81 * (0.75**0.5 - 0.2 * 0.5))


def test_parts_of_an_acceleration_can_be_left_out() -> None:
    """a = [-ω² d, 2 ω u] on a turning arm."""
    worked = read_and_solve(str(SET / "slot.yaml"), "p")
    expected = with_known_mistakes(worked)
    a = {m.name: m.values for m in expected[1].mistakes}
    assert a["coriolis-left-out"] == pytest.approx((-4.5, 0), abs=1e-12)
    assert a["centripetal-left-out"] == pytest.approx((0, 4.8), abs=1e-12)


def test_a_fixed_unknown_is_not_solved_for() -> None:
    worked = read_and_solve(str(SET / "rod.yaml"), "p")
    (part,) = worked.parts
    assert isinstance(part.replay, Replay)
    import numpy as np

    alpha = next(u for u in part.replay.equations.unknowns if "alpha" in u.name)
    right = part.replay.run({})
    run = part.replay.run({}, fixed={alpha: np.array([2 * part.replay.equations.value[alpha]])})
    assert float(run.asked("a_B")[0][0]) == pytest.approx(2 * float(right.asked("a_B")[0][0]))


def test_every_mistake_of_the_shelf_is_made_somewhere() -> None:
    from planar_cli.registry import members

    made: set[str] = set()
    for path in FILES:
        worked = read_and_solve(str(path), "p")
        made |= {name for name, _ in models_of(worked)}
        made |= {m.name for e in with_known_mistakes(worked) for m in e.mistakes}
    rare = {
        "given-not-converted",
        "static-for-kinetic",
        "other-root",
        "unit-not-converted",
        "moment-left-out",
        "parallel-axis-left-out",
    }
    assert set(members("homework.mistakes")) - made <= rare
