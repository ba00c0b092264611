"""The letter for the impulse of a reaction says at which point it acts."""

from __future__ import annotations

import pytest
from worked import page_of_file

from planar_cli.problem.scene.impulse_letters import of_reaction


@pytest.mark.parametrize(("force", "impulse"), [
    ("N_C", "J_N_C"), ("B_x", "J_B_x"), ("O_A_x", "J_OA_x"), ("T_cord", "J_T_cord"), ("F_A", "J_F_A"),
])  # fmt: skip
def test_a_point_with_an_index_is_written_in_one(force: str, impulse: str) -> None:
    assert of_reaction(force) == impulse


def test_on_a_page() -> None:
    assert "J_OAx → at O_A, J_F,A → at A" in page_of_file("ex-4-18")
