"""Motions are checked by the law of a coordinate alone, with numbers that agree on both sides."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem


def test_mean_speed() -> None:
    page = page_of_file("car-three-phases")
    found = re.search(
        r"mean velocity times the time, x of the car: \((\S+) \+ (\S+)\)/2 · (\S+) = (\S+) m; x_cruise = (\S+) m",
        page,
    )
    assert found is not None
    v, u, time, way, same = (float(x) for x in found.groups())
    assert (v + u) / 2 * time == pytest.approx(way, rel=1e-3)
    assert way == same


def test_a_wave_that_crosses_its_chord_halfway_does_not_change_uniformly() -> None:
    problem, wrong = load_text("""
title: Slider with a given speed
points: {A: [2 m, 0 m]}
bodies: {B: {particle: A}}
motion: [v(B).x = 1.5 m/s + (2 m/s)*cos(pi*t/(4 s)), v(B).y = 0]
states: {0: [t = 0], 1: [t = 1 s], 2: [t = 3 s]}
find: {d: x(B) @ 2 - x(B) @ 1}
""")
    assert problem is not None, wrong
    page = " ".join(Terminal(300).render(narrate(solve_problem(problem))).split())
    assert "= 8.301 - 5.301 = 3 m" in page
    assert "uniformly" not in page


def test_energy_by_newton_where_the_acceleration_is_constant() -> None:
    found = re.search(
        r"θ̈ = (.*?) = (\S+) rad/s², constant; 2 θ̈ Δθ = 2 · (\S+) · (\S+) = (\S+) rad²/s²; ω_2² = (\S+)",
        page_of_file("yo-yo"),
    )
    assert found is not None
    _, given, a, way, product, square = found.groups()
    assert given == a
    assert 2 * float(a) * float(way) == pytest.approx(float(product), rel=1e-3)
    assert product == square


def test_simpsons_rule() -> None:
    """Where the law, which the line tells first, is no straight line."""
    found = re.search(
        r"φ̈ = -g sin φ / l; from \w+ to \w+: ∫ φ̈ dφ by Simpson's rule = (\S+)/6"
        r" \((\S+) - 4 · (\S+) \+ (\S+)\) ≈ (\S+) rad²/s²;"
        r" φ̇_1²/2 = (\S+) rad²/s²",
        page_of_file("swing-from-which-the-cord-just-holds"),
    )
    assert found is not None
    width, first, half, last, result, other = (float(x) for x in found.groups())
    assert width / 6 * (first - 4 * half + last) == pytest.approx(result, rel=1e-3)
    assert result == pytest.approx(other, rel=5e-3)


@pytest.mark.parametrize(
    ("stem", "words", "numbers"),
    [
        ("block-fading-force", "changes uniformly: mean acceleration times the time", "(4 + 0)/2 · 5 = 10 m/s"),
        ("ex-4-12", "mean angular acceleration times the time", "(0 + 6.186)/2 · 5 = 15.46 rad/s"),
        (
            "crate-on-a-floor-that-gets-rougher",
            "mean acceleration times the way",
            "(-0.981 - 4.9504)/2 · 2.6975 = -8 m²/s²",
        ),
    ],
)
def test_of_a_straight_line_the_mean_of_its_ends(stem: str, words: str, numbers: str) -> None:
    page = page_of_file(stem)
    assert f"{words}, {numbers}" in page
    assert "Simpson" not in page


def test_the_law_before_the_balance_by_which_the_speed_was_found() -> None:
    page = page_of_file("plate-let-go-at-a-corner")
    assert "∫ θ̈ dθ by Simpson's rule" in page
    assert "Check T_lowest" not in page


@pytest.mark.parametrize("stem", ["body-arm-driven-by-its-angle", "box-on-a-belt-tied-to-a-wall"])
def test_the_printed_numbers_give_the_printed_result(stem: str) -> None:
    found = re.search(r"times the (?:angle|way), \((\S+) ([+-]) (\S+)\)/2 · \(?(\S+?)\)? = (\S+) ", page_of_file(stem))
    assert found is not None
    first, sign, last, width, result = found.groups()
    mean = (float(first) + float(sign + last)) / 2
    assert f"{mean * float(width):.4g}" == result


def test_none_in_letters() -> None:
    page = page_of_file("atwood-let-go")
    assert "times the time" not in page
    assert ", constant;" not in page


BRAKED = """
title: A particle that is brought to rest by a deceleration with the root of its speed
bodies: {{P: {{particle: [0, 0]}}}}
joints: [{{guide: {{point: P, along: 0 deg}}}}]
motion: ["a(P).x = {law}"]
states:
  0: [t = 0, v(P).x = {since}]
  1: [v(P).x = 0]
find: {{t: t @ 1, d: x(P) @ 1}}
"""


@pytest.mark.parametrize(
    ("law", "since", "t", "d"),
    [
        ("-4 m^(1/2)/s^(3/2) * sqrt(v(P).x)", "36 m/s", 3.0, 36.0),
        ("-2 m^(1/2)/s^(3/2) * sqrt(v(P).x)", "9 m/s", 3.0, 9.0),
    ],
)
def test_a_rate_that_grows_without_bound_is_not_printed(
    tmp_path: Path, law: str, since: str, t: float, d: float
) -> None:
    """t = 2 √v/c, d = 2 v^(3/2)/(3 c); 1/a has no value where the particle stands."""
    path = tmp_path / "braked.yaml"
    path.write_text(BRAKED.format(law=law, since=since), encoding="utf-8")
    solution = solve_problem(read(str(path)))
    page = Terminal(200).render(narrate(solution))
    found = {f.name: float(f.values[0]) for part in solution.parts for f in part.found if f.values}
    assert found == {"t": pytest.approx(t), "d": pytest.approx(d)}
    assert "Simpson" not in page
