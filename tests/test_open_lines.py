"""The diagram of a body that a guide keeps from turning: its moments balance with the force of the guide where it acts,
and where the page does not say where that is, the force has no point.
"""

from __future__ import annotations

from decimal import Decimal

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.document.blocks import Math
from planar_cli.report.kinetics.forces import drawn_bodies, force_rows
from planar_cli.report.kinetics.open_lines import NOT_NEEDED, open_line
from planar_cli.report.page.narrate import narrate
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import InstantSolution

NEAR = Decimal("1e-15")


@pytest.mark.parametrize(
    ("name", "body"),
    [
        ("momentum/block-down-a-free-wedge", "wedge"),
        ("particles/block-on-wedge", "wedge"),
        ("systems/block-and-weight-on-a-free-wedge", "wedge"),
    ],
)
def test_the_moments_of_what_translates_balance(name: str, body: str) -> None:
    """About the mass centre, with the force of the guide beside the named point and no couple of the guide."""
    instant = worked(ROOT / "problems" / f"{name}.yaml")[0].parts[0].instants[0]
    stage = instant.stages[-1]
    used = {s for block in stage.blocks for w in block.equations for s in w.residual.free_symbols}
    system, outcome, value = instant.trial.system, instant.trial.outcomes[0], instant.trial.outcomes[0].value
    center = instant.instant.scene.center(body)
    moments = [
        value((w.point - center).cross(w.force)) for w in system.wrenches if w.body == body and w.force is not None
    ]
    unplaced = 0
    for push, _ in system.reactions.pushes:
        for action in (a for a in push.actions if a.body == body and a.force is not None):
            found = open_line(instant.trial, push, body, used, value)
            unplaced += found is not None
            place = action.point if found is None else found.place(action)
            moments.append(value((place - center).cross(action.force)) * outcome.push(push.name))
    assert unplaced == 1
    assert abs(sum(moments)) < NEAR * sum(map(abs, moments))
    assert NOT_NEEDED in _row(instant, body)


def test_frictions_that_only_their_sum_tells_leave_it_open_too() -> None:
    """What the crate does to the cart turns it about K, where its guide is named."""
    instant = worked(ROOT / "problems/friction/crate-on-cart.yaml")[0].parts[0].instants[0]
    assert f"N_cart ↑{NOT_NEEDED}" in _row(instant, "cart")


def test_what_nothing_turns_keeps_its_point() -> None:
    """All forces on the gun act through its mass centre."""
    page = Terminal(width=110).render(narrate(worked(ROOT / "problems/momentum/gun-on-rails.yaml")[0]))
    assert "N_rails ↑ at G" in page


def _row(instant: InstantSolution, body: str) -> str:
    """The forces on a body as the page has them."""
    phrases = Phrases(instant.instant.scene.ledger, instant.value, 4, False)
    assert body in drawn_bodies(instant, instant.stages[-1])
    row = force_rows(instant, instant.stages[-1], phrases, inertia_as_force=False, bodies=(body,))[0]
    return "".join(str(p.expr) if isinstance(p, Math) else getattr(p, "text", "") for p in row.left)
