"""Damped oscillations on the page: the damping ratio, how it returns, and a damper that a case leaves out."""

from __future__ import annotations

from pathlib import Path

from conftest import PROBLEMS
from worked import page_of_file, page_of_text


def _at_rest(tmp_path: Path, damping: str) -> str:
    """The page of the bar about its equilibrium alone."""
    (path,) = (p for p in PROBLEMS if p.stem == "bar-with-spring-and-damper")
    text = path.read_text(encoding="utf-8").replace("c: 20 N*s/m}", f"c: {damping} N*s/m}}")
    asked = "states: {rest: [theta = 0 deg, equilibrium]}\nfind: {T_d: period(rest), settles: stable(rest)}\n"
    return page_of_text(tmp_path, f"title: Bar\n{text[text.index('plane:') : text.index('cases:')]}{asked}")


def test_the_damping_ratio_says_of_which_kind_it_is(tmp_path: Path) -> None:
    page = _at_rest(tmp_path, "20")
    assert "ζ = 3 c/(8 m ω_0) = 3 · 20 / (8 · 3 · 14.14) = 0.1768 ζ < 1: light damping" in page
    assert "displaced, it returns, and its amplitude falls as exp(-3 c t/(8 m))." in page
    assert "ω_d = ω_0 √(1 - ζ²) = 14.14 √(1 - 0.1768²) = 13.92 rad/s" in page


def test_an_asked_damping_ratio_is_told_once() -> None:
    page = page_of_file("stiffness-and-damping-from-a-record")
    assert page.count("ζ = ln(1.6)/(T ω_0)") == 1


def test_critical_damping_has_no_line_of_its_ratio() -> None:
    page = page_of_file("hinged-beam-critical-damping")
    assert "It is critically damped, ζ = 1." in page
    assert "displaced, it returns without swinging." in page


def test_why_a_damped_equilibrium_is_unstable(tmp_path: Path) -> None:
    (path,) = (p for p in PROBLEMS if p.stem == "bar-with-spring-and-damper")
    text = path.read_text(encoding="utf-8")
    given = "vertical\ngiven: {m: 3 kg, l: 0.6 m, h: 0.4 m, k: 20 N/m, c: 2 N*s/m}\n"
    middle = text[text.index("coordinates:") : text.index("cases:")].replace("theta = 0 deg", "theta = 90 deg")
    middle = middle.replace("K: [l, -h]", "K: [-h, l]").replace("W: [l/2, -h]", "W: [-h, l/2]")
    asked = "states: {rest: [theta = 90 deg, equilibrium]}\nfind: {settles: stable(rest)}\n"
    page = page_of_text(tmp_path, f"title: Upright bar\nplane: {given}{middle}{asked}")
    assert "rest is unstable, as the coefficient of δ is negative: displaced, it moves further away." in page


def test_one_condition_is_assumed_once(tmp_path: Path) -> None:
    """The period needs 3 k/m > 9 c²/(64 m²), and that it returns the same."""
    (path,) = (p for p in PROBLEMS if p.stem == "bar-with-spring-and-damper")
    text = path.read_text(encoding="utf-8")
    letters = "horizontal\nsymbols: {m: kg, l: m, h: m, k: N/m, c: N*s/m}\n"
    asked = "states: {rest: [theta = 0 deg, equilibrium]}\nfind: {T_d: period(rest), settles: stable(rest)}\n"
    middle = text[text.index("coordinates:") : text.index("cases:")]
    page = page_of_text(tmp_path, f"title: Bar in letters\nplane: {letters}{middle}{asked}")
    assert "Assume 64 m k > 3 c² STEP 1" in page


def test_a_damper_of_no_strength_is_not_drawn(tmp_path: Path) -> None:
    page = _at_rest(tmp_path, "0")
    assert "F_coil ↓ at A, O_x → at O" in page


def test_the_linear_motion_stands_before_the_integration() -> None:
    page = page_of_file("bar-with-spring-and-damper").partition("CASE heavy")[0]
    places = [
        page.index(w) for w in ("θ̈ + 3 c θ̇/(4 m) + 3 k θ/m = 0", "t_2 ≈", "at most 1 %", "integration: ", "At 2:")
    ]
    assert places == sorted(places)
    for value in ("0.1256 s", "θ̇_2 ≈", "-6.825°", "-3.773°"):
        assert value in page


def test_heavy_damping_is_why_it_does_not_pass() -> None:
    page = page_of_file("bar-with-spring-and-damper").partition("CASE heavy")[2].partition("CASE undamped")[0]
    assert "= 1.591 ζ > 1: heavy damping" in page
    assert "θ falls to zero without passing it; nor does it in the integration below: state 2 is not reached." in page
    assert "= 3.060°" in page


def test_a_wide_swing_has_no_linear_motion() -> None:
    assert "the equation of motion is linear" not in page_of_file("pendulum-swinging-far")
