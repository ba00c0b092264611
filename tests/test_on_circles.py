"""A point that slides along a turning body on a fixed circle: its acceleration towards the centre, by products."""

from __future__ import annotations

import math

import pytest
from test_letters_apart import _page
from test_letters_of_bodies import ARM

BEFORE = "(2) -0.8660 a_P/OC = 0.256 - 0.096 - 0.064 = 0.096 in m/s²"


def test_towards_the_centre() -> None:
    page = _page(ARM.replace("LETTER", "omega_0"))
    assert "n = [-0.5, -0.8660] towards Q: e · n = -0.8660, (k × e) · n = -0.5, r_P/O · n = -0.6 m" in page
    assert "a_P · n = v_P²/R = (0.2771² + 0.16²)/0.4 = 0.256 m/s² -ω² r_P/O · n = -0.4² (-0.6) = 0.096 m/s²" in page
    assert "(2 ω × v_P/OC e) · n = 2 · 0.4 (-0.16) (-0.5) = 0.064 m/s²" in page
    assert BEFORE in page
    assert page.index(BEFORE) < page.index("a_P/OC = -0.096/0.8660 = -0.1109 m/s²")


def test_asked_acceleration_stands_behind_what_it_rests_on() -> None:
    page = _page(ARM.replace("LETTER", "omega_0").replace("find: {", "find: {a: a(P).mag, "))
    assert page.index(BEFORE) < page.index("= [-0.6 · 0.4²")


@pytest.mark.parametrize(
    ("angle", "rate"), [(20, "0.4 rad/s"), (50, "0.7 rad/s"), (-35, "0.5 rad/s cw"), (40, "2 rad/s")]
)
def test_numbers_at_other_places(angle: int, rate: str) -> None:
    text = ARM.replace("LETTER: 0.4 rad/s", f"omega_0: {rate}").replace("30 deg", f"{angle} deg")
    page, size = _page(text.replace("LETTER", "omega_0")), float(rate.split(maxsplit=1)[0])
    left, _, rest = page.partition("(2) ")[2].partition(" a_P/OC = ")
    told, _, whole = rest.partition(" in m/s²")[0].partition(" = ")
    terms = [float(t) for t in told.replace("- ", "-").replace("+ ", "").split()]
    assert sum(terms) == pytest.approx(float(whole), rel=2e-3)
    # On the circle through O the arm drives P with the speed 2 R ω.
    assert terms[0] == pytest.approx(4 * 0.4 * size**2, rel=1e-3)
    relative = -2 * 0.4 * math.cos(math.radians(angle)) * size**2
    assert float(whole) / float(left) == pytest.approx(relative, rel=2e-3)
    assert page.index("v_P = ω × r_P/O + v_P/OC e = [") < page.index("a_P · n = v_P²/R")


def test_rate_of_turning_that_changes() -> None:
    text = ARM.replace("LETTER", "omega_0").replace("motion: ", "instant: ")
    assert "a_P · n" not in _page(text.replace("= omega_0]", "= omega_0, alpha(OC) = 1 rad/s^2]"))
