"""Two points drawn at one place: they come from the side from which they move; drawn apart, a plastic blow is open."""

from __future__ import annotations

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution

PUCKS = """
title: Two pucks at one place
plane: horizontal
bodies: {{A: {{particle: [0, 0], mass: 2 kg}}, B: {{particle: [0, 0], mass: 1 kg}}}}
joints:
  - impact: {{between: [{between}], normal: {normal} deg, restitution: 0.5, during: 1->2}}
states:
  1: [A at rest, v(B).x = {speed} m/s, v(B).y = 0]
  2: [just after 1]
find: {{v_A: v(A).x @ 2, v_B: v(B).x @ 2}}
"""
STAKE = """
title: Hammer on a stake
plane: vertical
points: {{P: [0, 0], H: [0, {height} m]}}
surfaces: {{soil: {{through: P, angle: 90 deg}}}}
bodies: {{hammer: {{particle: H, mass: 10 kg}}, stake: {{particle: P, mass: 4 kg}}}}
joints:
  - guide: {{body: hammer, along: 90 deg, name: way}}
  - contact: {{between: [stake, soil], friction: 9 kN, name: grip}}
  - impact: {{between: [{between}], normal: 90 deg, restitution: 0, name: blow{during}}}
states:
  1: [v(hammer).y = -6 m/s, stake at rest]
  2: [just after 1]
  3: [v(stake).y = 0]
find: {{depth: -y(stake) @ 3}}
"""


@pytest.mark.parametrize("between", ["A, B", "B, A"])
@pytest.mark.parametrize("normal", [0, 180])
@pytest.mark.parametrize("speed", [3, -3])
def test_the_side_is_that_from_which_they_come(between: str, normal: int, speed: int) -> None:
    found = solve(PUCKS.format(between=between, normal=normal, speed=speed))
    assert first(found["v_A"]) == pytest.approx(speed / 2)
    assert first(found["v_B"]) == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("between", ["hammer, stake", "stake, hammer"])
@pytest.mark.parametrize("during", ["", ", during: 1->2"])
def test_what_stays_in_contact_presses_from_above(between: str, during: str) -> None:
    # 10 · 6 = 14 v; (9000 - 14 · 9.81) d = 14 v²/2
    depth = 7 * (60 / 14) ** 2 / (9000 - 14 * 9.81)
    found = solve(STAKE.format(between=between, during=during, height=0))
    assert first(found["depth"]) == pytest.approx(depth)


@pytest.mark.parametrize("during", ["", ", during: 1->2"])
def test_drawn_apart_it_is_open_how_they_go_on(during: str) -> None:
    with pytest.raises(NoSolution) as caught:
        solve(STAKE.format(between="hammer, stake", during=during, height=0.2))
    assert [d.code for d in caught.value.diagnostics] == ["PL714"]
