"""From which state to which the forces of a motion act, in words: from 1 to 2, from top on."""

from __future__ import annotations

from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.solved_problem import PartSolution


def stretches(part: PartSolution, instant: InstantSolution) -> str:
    """From which state to which a regime acts; in a blow nothing moves on, unless it acts in blows alone."""
    assert part.motion is not None
    moving, own = {(since, stop) for since, stop, _ in part.motion.stretches}, part.motion.regime(instant).stretches
    told = [s for s in own if s in moving or s[0] == s[1] or not s[1]]
    whole: list[tuple[str, str]] = []
    for since, stop in told or own:
        goes_on = bool(whole) and since == whole[-1][1] != stop
        whole = [*whole[:-1], (whole[-1][0], stop)] if goes_on else [*whole, (since, stop)]
    return ", ".join(_stretch(since, stop) for since, stop in whole)


def only_after(part: PartSolution, instant: InstantSolution) -> bool:
    """Does a regime act only from the last state on?"""
    assert part.motion is not None
    last = part.motion.states[-1]
    return all((since, stop) == (last, "") for since, stop in part.motion.regime(instant).stretches)


def _stretch(since: str, stop: str) -> str:
    if since == stop:
        return f"in {since}"
    return f"from {since} to {stop}" if stop else f"from {since} on"
