"""What vanishes on a page: what a relation says is zero leaves the diagrams and equations that follow it."""

from __future__ import annotations

import re

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


def _page(name: str) -> str:
    return Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


@pytest.mark.parametrize(
    ("name", "letter"),
    [
        ("rigid-bodies/cabinet-on-casters", "α"),
        ("rigid-bodies/plate-on-parallel-links", "α"),
        ("friction/car-with-locked-wheels", "α"),
        ("systems/slab-on-rollers", "α_slab"),
        ("systems/rear-wheel-drive", "α_car"),
        ("kinematics/wheel-that-pushes-a-rod", "α_wheel"),
    ],
)
def test_a_body_that_can_not_turn(name: str, letter: str) -> None:
    """The relation that keeps it from turning is told with what it says; no m r α and no I α follow."""
    first = _page(name).split("CASE ", 2)
    pattern = rf"(hence|\(\d+\)) +{letter} += 0\b"
    page = next(part for part in first if re.search(pattern, part))
    after = re.split(pattern, page, maxsplit=1)[-1]
    assert not re.search(rf"{letter}(?![\w,])", after.split("Answer")[0])


@pytest.mark.parametrize(
    ("name", "force", "words"),
    [
        ("friction/car-with-locked-wheels", "N_A", "the contact is about to part"),
        ("systems/rear-wheel-drive", "N_D", "the contact is about to part"),
        ("systems/flat-faced-follower-about-to-lift", "N_touch", "the contact is about to part"),
        ("friction/crate-on-cart", "N_B", "crate is about to tip about A"),
    ],
)
def test_a_contact_that_is_about_to_part(name: str, force: str, words: str) -> None:
    """N = 0 is a line where it is put in, and the diagram has neither N nor its friction."""
    page = _page(name)
    assert f": {force} vanishes, {words}:" in page
    before, _, _ = page.partition(f": {force} vanishes")
    diagram = before.rsplit("free-body diagram = kinetic diagram", 1)[1]
    assert f"{force} " not in diagram
    assert f"F{force[1:]} " not in diagram


def test_friction_that_the_file_puts_at_its_limit() -> None:
    """A statement F = μ N is read as what it means, beside the forces."""
    page = _page("systems/rear-wheel-drive")
    assert "At the limit: friction at C reaches its limit" in page
    assert "Given: friction" not in page


def test_a_letter_that_drops_out() -> None:
    """A moment of inertia without a number leaves numbers where no equation has it; a mass that cancels is closed."""
    assert "a_A = P/m = 100/20 = 5 m/s²" in _page("rigid-bodies/cabinet-on-casters")
    assert re.search(r"N_B = .* = .*118\.9 N", _page("rigid-bodies/cabinet-on-casters"), re.DOTALL)
    assert "a_0 = g b/h = 9.81 · 0.9 / 1.5 = 5.886 m/s²" in _page("friction/crate-on-a-truck-that-starts")


def test_a_radius_that_is_sought_has_no_number_before_it_is_found() -> None:
    page = _page("textbook/ex-4-05")
    assert "k_G² = R r\n" in page
    assert "k_G² = 50 · 0.3674²" not in page
