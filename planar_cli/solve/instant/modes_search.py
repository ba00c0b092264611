"""Which choices of modes hold at an instant, and which of those that hold are one motion."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from functools import partial

from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import Undecided
from planar_cli.problem.scene.facts import Row, Skid, relative
from planar_cli.problem.scene.geometry import Vec
from planar_cli.solve.instant.instant import MOST_MODES, TINY, Instant, Trial


def search(instant: Instant) -> tuple[list[Trial], list[Trial]]:
    """As `search_modes`; of letters draws are taken with which a choice holds, where the first ones have none."""
    held, rejected = search_modes(instant, instant.scene.valuations)
    doubtful = [t.choice for t in rejected if t.tests] if instant.scene.ledger.symbolic and not held else []
    for choice in doubtful:
        if instant.scene.redraw(partial(instant.holds_at, choice)):
            return search_modes(instant, instant.scene.valuations)
    return held, rejected


def search_modes(instant: Instant, valuations: tuple[Valuation, ...]) -> tuple[list[Trial], list[Trial]]:
    """All choices that hold, told apart by their motion, and those that do not, in natural order."""
    held: list[Trial] = []
    rejected: list[Trial] = []
    for count, choice in enumerate(instant.choices()):
        if count >= MOST_MODES:
            if not held:
                raise Undecided(f"none of the first {MOST_MODES} combinations of contact modes holds; there are more")
            break
        trial = instant.try_choice(choice, valuations)
        if trial.objection:
            rejected.append(trial)
        elif not any(same_motion(trial, other) for other in held):
            held.append(trial)
    held = [t for t in held if not leaves_open(t)] or held
    return [t for t in held if not any(begins(instant, t, other) for other in held)], rejected


def leaves_open(trial: Trial) -> bool:
    """Are accelerations open? `N(Q) = 0` says what is sought where Q only just touches, and nothing where it is apart:
    of both the first is meant.
    """
    open_columns = {j for v in trial.outcomes[0].solved.null.values() for j, c in enumerate(v) if c}
    return any(isinstance(key, tuple) and j in open_columns for key, j in trial.outcomes[0].assembly.columns.items())


def begins(instant: Instant, trial: Trial, other: Trial) -> bool:
    """Would a slip have to begin in `trial` where friction can hold in `other`? From rest it begins only beyond the
    static limit, so that the other one counts.
    """
    differs = False
    for (_, modes), i, j in zip(instant.modes, trial.choice, other.choice, strict=True):
        if i != j:
            differs = True
            if modes[j].name != "stick" or modes[i].name != "slip":
                return False
            rows = [modes[i].sliding, *(row for skid in modes[i].facts.skids for row in _apart(skid))]
            sliding = [row for row in rows if row is not None]
            if not sliding or any(abs(trial.outcomes[0].assembly.row_speed(row)) > TINY for row in sliding):
                return False
    return differs


def _apart(skid: Skid) -> Iterator[Row]:
    """How fast a body moves along x and y over what it slides on."""
    for along in (Vec(1, 0), Vec(0, 1)):
        yield Row(skid.joint, "", relative(skid.body, skid.base, skid.point, along))


def same_motion(a: Trial, b: Trial) -> bool:
    """Do two choices give the same accelerations?"""
    one, other = a.outcomes[0], b.outcomes[0]
    for key, column in one.assembly.columns.items():
        if isinstance(key, tuple):
            x, y = one.solved.values[column], other.solved.values[other.assembly.columns[key]]
            if abs(x - y) > TINY * max(abs(x), abs(y), Decimal(1)):
                return False
    return True
