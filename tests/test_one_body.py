"""What is welded together is drawn, and has its energy, as one body, where nobody asks about what acts inside it."""

from __future__ import annotations

from pathlib import Path

from conftest import PROBLEMS
from worked import page_of_file, page_of_text, worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import Voice, narrate

CARRIER = "block-shot-along-a-carrier"


def test_a_bullet_in_a_block_is_drawn_with_it() -> None:
    page = page_of_file(CARRIER)
    assert "bullet, block: (m_0 + m_B) g ↓, N_K ↑, μ N_K ← = (m_0 + m_B) a_B →" in page
    assert "embed_x" not in page


def test_in_the_blow_that_joins_them_each_has_its_momentum() -> None:
    first, second = page_of_file(CARRIER).split("momentum before + impulses = momentum after")[1:3]
    assert "bullet, block: m_0 v_0 → at B, J_N,K ↑ at B, μ J_N,K ← at B" in first
    assert "bullet, block, carrier: (m_0 + m_B) (v_B,carrier,3 + v_G,3) → at B" in second


def test_their_kinetic_energy_and_the_work_of_their_weights_are_one() -> None:
    assert "T_3 of bullet, block = 1/2 (m_0 + m_B) v_B,3²" in page_of_file(CARRIER)
    page = page_of_file("bullet-in-a-hanging-block")
    assert "U of the weights of block, bullet = (m_block + m_bullet) g (y_P,2 - y_P,3)" in page
    assert "T = (m_block + m_bullet) (g + v_P,2²/l) = (2.4 + 0.012) (9.81 + 2.388²/1.5) = 32.83 N" in page
    assert "S_cord (normal to the motion) does no work: E_k" in page


def test_weights_by_letters_stay_apart() -> None:
    page = page_of_file("impact/pile-driver")
    assert "hammer, pile: W_1 ↓, N_g1 ←, W_2 ↓, R ↑, N_g2 ← = (m_hammer + m_pile) a_A ↓" in page


def test_one_line_of_an_acceleration_that_two_bodies_have() -> None:
    assert page_of_file(CARRIER).count("a_B = a_B,carrier + a_G") == 1


def test_a_force_inside_that_is_asked_parts_them(tmp_path: Path) -> None:
    (path,) = (p for p in PROBLEMS if p.stem == "bullet-stays-in-a-block")
    text = path.read_text(encoding="utf-8")
    text = text[: text.index("find:")] + "find: {F: reaction(P_2/bullet).x @ after}\n"
    page = page_of_text(tmp_path, text.replace("- weld: {at: P,", "- weld: {at: P, name: P_2,"))
    assert "bullet: m g ↓, P_2,x ←, P_2,y ↑ = m a_P" in page or "bullet: m g ↓, P_2,x →, P_2,y ↑ = m a_P" in page


def test_a_lesson_says_that_they_are_drawn_as_one() -> None:
    (path,) = (p for p in PROBLEMS if p.stem == "bullet-stays-in-a-block")
    page = " ".join(Terminal().render(narrate(worked(path)[0], Voice(audience="lesson"))).split())
    assert "drawn alone, what is stuck together as one where nobody asks for the force between, with all forces" in page
