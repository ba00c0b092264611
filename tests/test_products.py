"""A body that takes up matter at rest: impulse and momentum of all that is there, in one line, and no law for it.

A law that is linear in its speed is told as the derivative of a product, where no balance of momentum holds.
"""

from __future__ import annotations

from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

BRINGS_SOME = """
title: Wagon into which a jet runs
plane: vertical
given: {M: 800 kg, q: 40 kg/s, c: 9 m/s}
points: {P: [0, 0]}
bodies: {wagon: {particle: P, mass: M + q*t}}
joints:
  - guide: {point: P, along: 0 deg, name: rails}
loads:
  - stream: {body: wagon, rate: q, enters: {at: P, speed: c - v(wagon).x, angle: 0 deg}, name: jet}
states:
  1: [t = 0, at rest]
  2: [t = 15 s]
find: {v: v(wagon).x @ 2}
"""


def page(text: str) -> str:
    problem, wrong = load_text(text)
    assert not wrong
    return " ".join(Terminal().render(narrate(solve_problem(problem))).split())


def test_what_falls_in_brings_no_momentum_along_the_rails() -> None:
    told = page_of_file("sand-wagon")
    head = "From 1 to 2, wagon: impulse and momentum (what enters has no velocity along x):"
    assert f"{head} (1) → F t_2 = v_2 (M + q t_2) (1): v_2 = F t_2 / (M + q t_2) =" in told
    assert "Likewise at any time, with t for t_2: v = F t / (M + q t) From 1 to 2, dx = v dt" in told
    kept = "conservation of momentum (what enters has no velocity along x): (1) → M v_1 = v_2 (M + q t_2)"
    assert kept in told
    assert "as given: v_1" not in told
    assert "F - v q" not in told


def test_what_leaks_takes_its_momentum_with_it() -> None:
    leaking = page_of_file("sand-wagon").partition("CASE leaking")[2].partition("CASE coasting")[0]
    assert "(1) → ΣF_x: F = a (M - q t)" in leaking
    assert "impulse and momentum" not in leaking


def test_the_impulse_of_the_weight_of_what_grows_has_no_number_in_letters() -> None:
    told = page_of_file("drop-that-grows-in-mist")
    assert "impulse = ∫[0 → T] (M g + g q t) dt = T g (M + 1/2 T q) (2) ↓" in told


def test_a_jet_brings_its_own_momentum() -> None:
    told = page(BRINGS_SOME)
    assert "(1) → c q t_2 = v_2 (M + q t_2)" in told
    assert "has no velocity along" not in told


def test_newtons_law_alone_is_integrated_as_the_derivative_of_a_product() -> None:
    rained_on = BRINGS_SOME.replace("c - v(wagon).x, angle: 0 deg", "v(wagon).x, angle: 180 deg")
    told = page(rained_on.replace("at rest", "v(wagon).x = c") + "method: newton\n")
    product = "d[(M + q t) v_P]/dt = (M + q t) dv_P/dt + v_P q = 0 so that the momentum of wagon is conserved:"
    assert f"{product} (M + q t) v_P = M c" in told
