"""Answers by yes and no stand beside the two values that were compared."""

from __future__ import annotations

import re
from decimal import Decimal
from pathlib import Path

import pytest
from conftest import ROOT
from printed import read_number
from worked import page_of_file, page_of_text, worked

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.instant.distribution import point_within

NUMBER = r"(-?[\d.]+(?:×10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?)"
PUT_IN = r"(?: [\d.·/() -]+ =)?"
COMPARED = re.compile(rf"= {NUMBER} [\w·/²]+ ([<>≤≥])(?: [^=<>≤≥:]* ={PUT_IN})? {NUMBER} [\w·/²]+")


def _page(name: str) -> str:
    text = Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))
    return re.sub(r"\s+", " ", text)


@pytest.mark.parametrize(
    ("name", "line"),
    [
        ("friction/crate-pushed-too-hard", "x = P y/N_C = 200 · 1 / 588.6 = 0.3398 m > b/2 = 0.3 m"),
        ("friction/crate-that-slips-or-tips", "x = P y/N_C = 235.4 · 0.5 / 588.6 = 0.2 m < b/2 = 0.3 m"),
        ("friction/crate-pushed-too-hard", "|F_C| = P = 250 N > μ N_C = 0.4 · 588.6 = 235.4 N"),
        ("friction/crate-pulled", "it would need |F_A| = P cos 25° = 200 cos 25° = 181.3 N > μ_s N_A"),
        ("friction/stacked-blocks", "then a_B = (P - μ_B N_B)/(m_A + m_B) = (90 - 0.1 · 127.5)/(5 + 8) = 5.942 m/s²;"),
        ("friction/stacked-blocks", "it would need |F_A| = m_A a_B = 5 · 5.942 = 29.71 N > μ_A N_A"),
        ("friction/spool-rolls-or-slips", "it would need |F_C| = P - m R α = 120 - 20 · 0.4 · 5.3933 = 76.85 N >"),
        ("friction/ladder-sliding", "it would need |F_A| = N_B = 56.96 N > μ_A N_A = 0.2 · 141.45 = 28.29 N"),
        ("systems/block-on-a-table-and-a-moving-pulley", "then T = 1/2 m_B g = 1/2 · 10 · 9.81 = 49.05 N; it would"),
        ("friction/stacked-blocks", "|F_A| = 6.633 N < μ_A N_A = 0.3 · 49.05 = 14.715 N"),
        ("energy/block-with-a-fading-push", "|F_P| = F_0 exp(-x_P,stop/b) = 0.03381 N ≤ μ N_P = 4.4145 N"),
        ("motion/body-block-sent-up-a-slope", "stays: |F_P| = m g sin β = 24.525 N ≤ μ N_P = 29.73 N"),
        ("momentum/two-wheels-pressed-together", "mode_3: |F_C| = 0 N ≤ μ N_C = 12.5 N"),
        ("motion/ball-through-a-window", "above_sill: y_wall = 10.62 m > 10 m"),
        ("motion/ball-through-a-window", "below_lintel: y_wall = 10.62 m < 11.5 m"),
    ],
)
def test_what_decides_is_printed(name: str, line: str) -> None:
    assert line in _page(name)


@pytest.mark.parametrize(
    "name",
    [
        "friction/crate-pushed-too-hard",
        "friction/crate-pulled",
        "friction/spool-rolls-or-slips",
        "friction/wheel-dropped-on-conveyor",
        "friction/block-held-on-slope",
        "plans/ladder-slips",
        "motion/body-block-sent-up-a-slope",
        "momentum/two-wheels-pressed-together",
        "motion/ball-through-a-window",
    ],
)
def test_what_is_compared_is_so(name: str) -> None:
    """The signs are those of the numbers printed."""
    found = [m.groups() for m in COMPARED.finditer(_page(name))]
    assert found
    for one, sign, other in found:
        difference = read_number(one) - read_number(other)
        assert difference < 0 if sign == "<" else difference > 0 if sign == ">" else True
        assert sign != "≤" or difference <= 1e-9
        assert sign != "≥" or difference >= -1e-9


STAYS = """
title: Block left on a slope
plane: vertical
given: {m: 2 kg, beta: 20 deg, mu: 0.5}
points: {A: [0, 0]}
surfaces: {slope: {through: A, angle: beta}}
bodies: {block: {particle: A, mass: m}}
joints:
  - contact: {between: [block, slope], at: A, mu: mu}
instant: [at rest]
find: {stays: mode(A) = stick}
answers: {stays: true}
"""


def test_that_it_stays_rests_on_a_comparison(tmp_path: Path) -> None:
    """Nothing else is asked; friction and its limit are found all the same."""
    path = tmp_path / "stays.yaml"
    path.write_text(STAYS, encoding="utf-8")
    page = Terminal(width=110).render(narrate(solve_and_compare(read(str(path)))[0]))
    assert "= 6.710 N < μ N_A" in page


def test_friction_that_is_not_unique_is_compared_in_one_distribution() -> None:
    """W sin β/cos β = 176.3 N below the wedge if there is none above it."""
    page = page_of_file("wedge-driven-under-a-block")
    assert "as with |F_F| = 176.3 N ≤ μ N_F = 204 N, |F_S| = 0 N ≤ μ N_S = 203.1 N" in page


@pytest.mark.parametrize(
    ("bounds", "free"),
    [
        ([(-3, {0: 1}), (5, {0: -1})], [0]),
        ([(-1, {0: 1}), (-1, {1: 1}), (3, {0: -1, 1: -1})], [0, 1]),
        ([(-1, {0: 1})], [0]),
        ([(-1, {0: -1})], [0]),
    ],
)
def test_a_distribution_fulfils_all_bounds(bounds: list[tuple[int, dict[int, int]]], free: list[int]) -> None:
    exact = [(Decimal(value), {k: Decimal(s) for k, s in slopes.items()}) for value, slopes in bounds]
    found = point_within(exact, free)
    assert found is not None
    assert all(value + sum(s * found[k] for k, s in slopes.items()) >= 0 for value, slopes in exact)


def test_there_is_no_distribution_where_bounds_exclude_each_other() -> None:
    assert point_within([(Decimal(-3), {0: Decimal(1)}), (Decimal(2), {0: Decimal(-1)})], [0]) is None


def test_a_relation_of_a_motion_that_is_read_off_has_both_sides() -> None:
    """The cord pulls past the axis of the post on which it winds up: the angular momentum halves."""
    assert "conserved: -0.3000 kg·m²/s ≠ -0.6 kg·m²/s" in page_of_file("puck-whose-string-winds-up")


ROD_LET_GO = """\
title: Rod let go on a rough floor
plane: vertical
given: {m: 10 kg, l: 2 m, theta: 60 deg, mu: 0.2}
points: {A: [0, 0], B: {from: A, distance: l, angle: theta}}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies: {rod: {rod: [A, B], mass: m}}
joints:
  - contact: {between: [rod, floor], at: A, mu: mu}
instant: [at rest]
find: {N: N(A), alpha: alpha(rod)}
"""


def test_a_limit_has_the_normal_force_of_its_own_case(tmp_path: Path) -> None:
    """N = 79.71 N while it would not slip, 65.83 N as it slips."""
    page = page_of_text(tmp_path, ROD_LET_GO)
    assert "= 31.86 N > μ N = 0.2 · 79.71 = 15.94 N" in page
    assert "N = 65.83 N" in page
