"""Quotients of sums are divided out where a term has the whole divisor as a factor."""

from __future__ import annotations

import sympy as sp
from worked import page_of_file

from planar_cli.report.notation.divided import divided_out

M, g, q, t, u = sp.symbols("M g q t u", positive=True)


def test_a_term_with_the_divisor_stands_alone() -> None:
    whole = (u * q - g * (M - q * t)) / (M - q * t)
    assert divided_out(whole) == u * q / (M - q * t) - g
    assert divided_out((g * (M - q * t) - u * q) / (q * t - M)) == u * q / (M - q * t) - g
    assert divided_out(sp.Integral(whole, (t, 0, 1))) == sp.Integral(u * q / (M - q * t) - g, (t, 0, 1))


def test_other_quotients_stay() -> None:
    for other in ((u - g) / M, (M + q) / (M - q), M / (M - q), u + g):
        assert divided_out(other) is other


def test_a_root_is_divided_by_what_all_but_one_of_its_terms_have() -> None:
    root = sp.sqrt((2 * M * g * t - q * t**2) / M)
    assert divided_out(root) == sp.sqrt(2 * g * t - q * t**2 / M)
    assert divided_out(3 * root) == 3 * sp.sqrt(2 * g * t - q * t**2 / M)
    for other in (sp.sqrt((M * g + q + u) / M), sp.sqrt((M * g - q) / M) / t):
        assert divided_out(other) == other


def test_the_speed_of_a_rocket_is_seen_under_the_integral() -> None:
    page = page_of_file("rocket-up-and-along")
    assert "∫[0 → v_2] dv = ∫[0 → T] (u q / (M - q t) - g) dt" in page
    assert "v_2 = u ln(M/(M - T q)) = 2000 ln(" in page
    assert "Momentum of a stream: its force is the mass per second times its velocity." in page


def test_a_balance_of_momentum_counts_in_the_sense_of_its_terms() -> None:
    assert "(4) → m l φ̇_hit + J_N = m v_free" in page_of_file("pendulum-against-a-wall")
