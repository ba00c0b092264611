"""Motions are checked by the law of a coordinate alone, with numbers that agree on both sides."""

from __future__ import annotations

import re

import pytest
from conftest import PROBLEMS
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.narrate import narrate

FILES = {p.stem: p for p in PROBLEMS}


def _page(stem: str) -> str:
    return " ".join(Terminal(300).render(narrate(worked(FILES[stem])[0])).split())


def test_mean_speed() -> None:
    page = _page("car-three-phases")
    found = re.search(
        r"mean velocity times the time, x of the car: \((\S+) \+ (\S+)\)/2 · (\S+) = (\S+) m; x_car,cruise = (\S+) m",
        page,
    )
    assert found is not None
    v, u, time, way, same = (float(x) for x in found.groups())
    assert (v + u) / 2 * time == pytest.approx(way, rel=1e-3)
    assert way == same


def test_energy_by_newton_where_the_acceleration_is_constant() -> None:
    found = re.search(
        r"θ̈ = (.*?) is constant, 2 θ̈ Δθ = 2 · (\S+) · (\S+) = (\S+) rad²/s²; ω_2² = (\S+)", _page("yo-yo")
    )
    assert found is not None
    _, a, way, product, square = found.groups()
    assert 2 * float(a) * float(way) == pytest.approx(float(product), rel=1e-3)
    assert product == square


def test_simpsons_rule() -> None:
    rates, result = r"from (\S+), (\S+), (\S+) rad/s at the start", r"half-way and the end ≈ (\S+) s; (.*?) = (\S+) s"
    found = re.search(rf"∫ dθ/θ̇ by Simpson's rule {rates}, {result}", _page("body-ladder-drawn-away"))
    assert found is not None
    first, half, last, time, _, other = found.groups()
    # θ goes from 135° to 153.4° there.
    mean = (1 / float(first) + 4 / float(half) + 1 / float(last)) / 6
    assert 0.32175 * mean == pytest.approx(float(time), rel=2e-3)
    assert float(time) == pytest.approx(float(other), rel=5e-3)


def test_what_is_rounding_is_zero() -> None:
    """A disk that is at rest in the end, and a spring without force in the first state."""
    page = _page("block-between-two-springs")
    assert "Simpson's rule from 0, " in page
    assert "×10⁻" not in page


def test_none_in_letters() -> None:
    page = _page("atwood-let-go")
    assert "times the time" not in page
    assert "is constant" not in page
