"""Andrews' squeezer against its reference values, and what one evaluation of chains and four-bars costs."""

from __future__ import annotations

import pytest
from conftest import ROOT
from pinned import chain, followed, four_bars, model_of

from planar_cli.motion.start.start import start_of

SQUEEZER = (ROOT / "problems" / "hard" / "andrews-squeezer.yaml").read_text(encoding="utf-8")
BETA, GAMMA, DELTA, EPSILON = -0.0617138900142764496, 0.455279819163070380, 0.487364979543842550, 1.23054744454982119
TURNED = {
    "K1": 15.8107711951537070971 - BETA,
    "K3": 0.04082224011964580486 - GAMMA,
    "K5": 0.52440996587995406937 - DELTA,
    "K7": 1.04808074104193787307 - EPSILON,
}
"""By how much bodies have turned at 0.03 s: a Taylor method with 113 bits (published ones have 10 digits)."""


def test_the_squeezer_starts_with_the_published_accelerations() -> None:
    model = model_of(SQUEEZER)
    start, regime = start_of(model), model.regime()
    rates, half = regime.rates(start.time, start.state), model.layout.count
    alpha = {b: rates[half + f.theta] for b, f in model.layout.frames.items() if f.theta is not None}
    assert alpha["K1"] == pytest.approx(14222.4439199541138705911625887, rel=1e-13)
    assert alpha["K2"] - alpha["K1"] == pytest.approx(-10666.8329399655854029433719415, rel=1e-13)
    forces = dict(zip((p.name for p in regime.reactions), regime.forces(start.time, start.state), strict=True))
    # λ1, λ2 are the force of K2 on K3 in E.
    assert abs(forces["E_K3_x"]) == pytest.approx(98.5668703962410896057654982170, rel=1e-11)
    assert abs(forces["E_K3_y"]) == pytest.approx(6.12268834425566265503114393122, rel=1e-10)


@pytest.mark.parametrize(("tolerance", "error"), [(1e-6, 1e-4), (1e-9, 1e-7), (1e-13, 1e-11)])
def test_the_squeezer_at_30_ms(tolerance: float, error: float) -> None:
    found = followed(model_of(SQUEEZER), 0.03, tolerance)
    for body, angle in TURNED.items():
        assert found.at(f"theta_{body}") == pytest.approx(angle, abs=error)
    assert found.drift <= 1e-12


def test_what_an_evaluation_costs() -> None:
    chains = {n: model_of(chain(n, -0.3)).regime().operations for n in (20, 80)}
    bars = {n: model_of(four_bars(n)).regime().operations for n in (10, 40)}
    # What hand-tuned generators of the same kind need is 2240; 2470 and 9944; 850 operations.
    assert chains[20] <= 2240
    assert bars[10] <= 2470
    assert bars[40] <= 9944
    assert model_of(SQUEEZER).regime().operations <= 850
    # For each body about the same, whether there are 20 or 80.
    assert chains[80] / 80 <= 1.1 * chains[20] / 20
    assert bars[40] / 81 <= 1.1 * bars[10] / 21
