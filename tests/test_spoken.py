"""Statements of a file are said as mechanics is written, without the dots and brackets of the file."""

from __future__ import annotations

import pytest

from planar_cli.report.document.blocks import Name, Text
from planar_cli.report.words.spoken import spoken


@pytest.mark.parametrize(("stated", "said"), [
    ("v(P).along(210 deg) = v_0", "the component along the direction 210° of <v_P> = <v_0>"),
    ("v(stone).across(beta) = 0", "the component across the direction <beta> of <v_stone> = 0"),
    ("r(stone/O).across(beta) = 0", "the component across the direction <beta> of <r_stone/O> = 0"),
    ("v(S/gun).along(gun) = u", "the component along gun of the velocity of S relative to gun = u"),
    ("reaction(A).along(pole) = 0", "the component along pole of the reaction at A = 0"),
    ("a(car).t = 1.5 m/s^2", "<a_car_t> = 1.5 m/s²"),
    ("r(A/B).x = 0", "<x_A> - <x_B> = 0"),
    ("r(A/B).mag is smallest", "the distance of A from B is smallest"),
    ("v(boy_A/raft).x = -u", "the velocity of boy_A relative to raft along x = -u"),
])  # fmt: skip
def test_said(stated: str, said: str) -> None:
    pieces = spoken(stated, {"v_0", "beta"})
    text = "".join(f"<{p.name}>" if isinstance(p, Name) else p.text for p in pieces if isinstance(p, Name | Text))
    assert text == said


def test_a_size_stands_between_bars() -> None:
    said = "".join(getattr(p, "text", getattr(p, "name", "")) for p in spoken("v(ball).mag = 4 m/s", ()))
    assert said == "|v_ball| = 4 m/s"
