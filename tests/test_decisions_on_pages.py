"""Answers by yes and no stand beside the two values that were compared."""

from __future__ import annotations

import re

import pytest
from conftest import ROOT
from printed import read_number
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.narrate import narrate

NUMBER = r"(-?[\d.]+(?:×10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?)"
COMPARED = re.compile(rf"= {NUMBER} [\w·/²]+ ([<>≤≥])(?: [^=<>≤≥:]* =)? {NUMBER} [\w·/²]+")


def _page(name: str) -> str:
    text = Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))
    return re.sub(r"\s+", " ", text)


@pytest.mark.parametrize(
    ("name", "line"),
    [
        ("friction/crate-that-slips-or-tips", "|M_C| = 200 N·m > 1/2 N_C b = 176.6 N·m"),
        ("friction/crate-that-slips-or-tips", "|M_C| = 117.7 N·m ≤ 1/2 N_C b = 176.6 N·m"),
        ("friction/crate-that-slips-or-tips", "|F_C| = 250 N > μ N_C = 235.4 N"),
        ("friction/stacked-blocks", "|F_A| = 6.633 N ≤ μ_A N_A = 14.715 N"),
        ("energy/block-with-a-fading-push", "|F_P| = F_0 exp(-x_P,stop/b) = 0.03381 N ≤ μ N_P = 4.4145 N"),
        ("motion/body-block-sent-up-a-slope", "stays: |F_P| = m g sin β = 24.525 N ≤ μ N_P = 29.73 N"),
        ("momentum/two-wheels-pressed-together", "mode_3: |F_C| = 0 N ≤ μ N_C = 12.5 N"),
        ("motion/ball-through-a-window", "above_sill: y_ball,wall = 10.62 m > 10 m"),
        ("motion/ball-through-a-window", "below_lintel: y_ball,wall = 10.62 m < 11.5 m"),
    ],
)
def test_what_decides_is_printed(name: str, line: str) -> None:
    assert line in _page(name)


@pytest.mark.parametrize(
    "name",
    [
        "friction/crate-that-slips-or-tips",
        "friction/crate-pulled",
        "friction/spool-rolls-or-slips",
        "friction/wheel-dropped-on-conveyor",
        "friction/block-held-on-slope",
        "plans/ladder-slips",
        "motion/body-block-sent-up-a-slope",
        "momentum/two-wheels-pressed-together",
        "motion/ball-through-a-window",
    ],
)
def test_what_is_compared_is_so(name: str) -> None:
    """The signs are those of the numbers printed."""
    found = [m.groups() for m in COMPARED.finditer(_page(name))]
    assert found
    for one, sign, other in found:
        difference = read_number(one) - read_number(other)
        assert difference < 0 if sign == "<" else difference > 0 if sign == ">" else True
        assert sign != "≤" or difference <= 1e-9
        assert sign != "≥" or difference >= -1e-9
