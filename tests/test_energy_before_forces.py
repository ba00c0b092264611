"""Where energy alone leads from state to state, it stands before forces that are the same all the time."""

from __future__ import annotations

from pathlib import Path

from conftest import PROBLEMS
from worked import page_of_file, page_of_text


def test_energy_stands_before_the_forces_of_the_yo_yo() -> None:
    page = page_of_file("yo-yo").partition("CASE")[0]
    places = [page.index(words) for words in ("Assume", "Work and energy states", "v_2 = r ω_2 =", "Kinetic analysis")]
    assert places == sorted(places)
    assert page.index("T_thread = m (g - a_G)") < page.index("T_thread is the same at every instant.")


def test_turning_follows_from_the_stated_speed_of_the_centre() -> None:
    page = page_of_file("yo-yo").partition("CASE")[2]
    assert "ω_2 = v_G,2/r = 1/0.01 = 100 rad/s T is the instantaneous centre of yoyo" in page
    assert page.count("T is the instantaneous centre") == 1


def test_forces_asked_at_an_end_are_called_constant() -> None:
    assert "T_left and T_right are the same at every instant." in page_of_file("body-atwood-with-heavy-pulley")


def test_forces_asked_at_a_state_on_the_way_are_called_constant(tmp_path: Path) -> None:
    (path,) = (p for p in PROBLEMS if p.stem == "yo-yo")
    text = path.read_text(encoding="utf-8").partition("cases:")[0]
    text = text.replace("2: [y(G) = -h]", "2: [y(G) = -h]\n  3: [y(G) = -2*h]").replace(
        "  share", "  v_3: v(G).mag @ 3\n  share"
    )
    assert "T_thread is the same at every instant." in page_of_text(tmp_path, text)


def test_forces_that_change_are_not() -> None:
    assert "at every instant" not in page_of_file("plank-on-a-tree-trunk")
