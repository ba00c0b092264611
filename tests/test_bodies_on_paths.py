"""What is told of bodies and particles that a path leads: which point has which acceleration, along which direction."""

from __future__ import annotations

from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.narrate import narrate


def _page(name: str) -> str:
    return Terminal(width=140).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


def test_only_the_led_point_of_a_turning_body_moves_along_the_path() -> None:
    page = _page("rigid-bodies/bar-on-two-slanting-cords")
    assert "a_A = a_At e_t = [" in page
    assert "a_G = a_A + α × r_G/A = [-1.307, -7.546] m/s²" in page
    assert "ρ" not in page, "at rest there is no normal acceleration"


def test_a_particle_in_a_turning_tube_is_summed_along_the_tube() -> None:
    page = _page("motion/ball-in-a-rotating-tube-in-letters")
    assert "m a_P,tube ↗,  2 m v_P,tube ω ↖,  m (r_0 + s_P) ω² ↙" in page, "one arrow for each part"
    assert "ball, along tube:" in page
    assert "0 = m a_P,tube - m (r_0 + s_P) ω²" in page


def test_a_bead_on_a_turning_hoop_is_summed_along_the_wire() -> None:
    page = _page("oscillations/bead-on-a-turning-hoop")
    assert "0 = m a_P,hoop,t + m R ω² sin φ" in page
    assert "m OP ω²" in page, "the distance from the pivot by its ends"


def test_a_block_on_a_free_smooth_wedge_is_summed_along_it() -> None:
    assert "-m g sin β = m a_P,wedge + m a_W cos β" in _page("particles/block-on-wedge")


def test_the_size_of_what_is_positive_is_itself() -> None:
    assert "/|" not in _page("kinematics/car-that-brakes-in-a-bend")
