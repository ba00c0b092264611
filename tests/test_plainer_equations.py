"""Equations of one body that are plainer than others with as few unknowns; checks that the page has not used."""

from __future__ import annotations

from pathlib import Path

from worked import page_of_file, page_of_text

POLE = """
title: Pole pushed at rest
plane: vertical
given: {m: 45 kg, l: 3 m, F: 100 N, h: 1 m, mu_s: 0.3, mu_k: 0.2}
points: {A: [0, 0], B: [0, l], H: [0, h]}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies: {pole: {rod: [A, B], mass: m, points: [H]}}
joints: [{contact: {between: [pole, floor], at: A, mu_s: mu_s, mu_k: mu_k}}]
loads: [{force: {body: pole, at: H, magnitude: F, angle: 0 deg}}]
instant: [at rest]
find: {alpha: alpha(pole), N: N(A), f: friction(A).x}
cases: {harder: {given: {F: 400 N}, find: {alpha_2: alpha(pole), a_A: a(A).x}}}
"""


def test_friction_by_moments_where_forces_would_need_another_acceleration(tmp_path: Path) -> None:
    first, _, harder = page_of_text(tmp_path, POLE).partition("CASE harder")
    assert "pole, moments about G: (4) ↻ ΣM_G: F (h - l/2) + 1/2 F_A l = I α" in first
    assert "3 unknowns: N, α, F_A" in first
    assert "ΣM_G =" not in first, "no check repeats it"
    assert "(4) → ΣF_x: F - μ_k N = m a_G" in harder, "where all forces are known"


def test_the_force_of_a_pin_stays_with_the_sum_of_forces() -> None:
    assert "↓ ΣF_y: m g - A_y = m a_G" in page_of_file("ex-4-06")


def test_no_check_repeats_an_equation() -> None:
    """The mass centre is called G on the page, whatever the file calls the body."""
    for page in (page_of_file("crate-pushed-too-hard"), page_of_file("spool-rolls-or-slips")):
        for part in page.split("CASE"):
            solved, _, check = part.partition("Check")
            assert not ("ΣM_G:" in solved and "ΣM_G =" in check)


def test_no_equation_is_taken_that_needs_another_unknown() -> None:
    """The normal force of the sliding end serves tests alone: moments about that end tell its acceleration."""
    assert "plank, moments about A: (2) ↺ ΣM_A:" in page_of_file("plank-whose-upper-end-drops")


def test_the_line_of_a_blow_stays_for_both_bodies_together() -> None:
    assert "A, B, momentum along the line: (8) ↗" in page_of_file("rope-that-jerks-taut")
