"""The length of a rope as a function of places: free parts, arcs on pulleys, and what is wound on drums.

The free part between two stops touches both rims; with d from centre to centre, and the centres at ρ to the left of
the running rope (ρ = ±radius), it has the length L = √(d² - (ρ_2 - ρ_1)²). On a pulley the rope lies along an arc
ρ (φ_out - φ_in), where φ is the direction of a free part; on a drum one of these is a mark that turns with it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

from planar_cli.joints._rope_path import Stop
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.residuals import Poses, Residual
from planar_cli.records import record


@record
class _Rim:
    """A stop in numbers: its centre's place, and ρ; `wound`: the rope is fastened to the rim."""

    body: str
    center: Vec
    rho: Any
    wound: bool


def rope_length(title: str, stops: Sequence[Stop], along: Vec | None) -> Residual:
    """The whole rope keeps its length. `along`: a fixed direction of all its parts, pulleys without size."""

    def stretch(poses: Poses) -> Any:
        rims = [_rim(poses, stops, i, along) for i in range(len(stops))]
        free = [_free(poses, a, b, along) for a, b in pairwise(rims)]
        total = sum((length for length, _ in free), poses.time * 0)
        directions = [poses.angle(rims[0].body), *(phi for _, phi in free), poses.angle(rims[-1].body)]
        for rim, before, after in zip(rims, directions, directions[1:], strict=False):
            if rim.rho and (along is None or rim.wound):
                total = total + (after - before) * rim.rho
        return poses.change(total)

    return Residual(title, stretch)


def rope_directions(stops: Sequence[Stop], names: Sequence[str], along: Vec) -> tuple[Residual, ...]:
    """Every part stays parallel to a direction: its ends keep their distance across it. `names` of the stops."""
    return tuple(
        Residual(f"its part from {one} to {other} does not keep its direction `along`", _across(a, b, along))
        for (a, b), (one, other) in zip(pairwise(stops), pairwise(names), strict=True)
    )


def _across(start: Stop, end: Stop, along: Vec) -> Callable[[Poses], Any]:
    def across(poses: Poses) -> Any:
        reach = poses.point(end.body, end.center) - poses.point(start.body, start.center)
        return poses.change(poses.vector(along).cross(reach))

    return across


def _rim(poses: Poses, stops: Sequence[Stop], index: int, along: Vec | None) -> _Rim:
    """The side on which a drum's centre lies follows from where the rope goes (or comes from) at its rim point."""
    stop = stops[index]
    center = poses.point(stop.body, stop.center)
    if stop.rim is None:
        return _Rim(stop.body, center, poses.number(stop.side * stop.radius), False)
    arm = poses.vector(stop.rim) - poses.vector(stop.center)
    radius = poses.root(arm.dot(arm))
    other = stops[1] if index == 0 else stops[index - 1]
    reach = poses.vector(other.rim or other.center) - poses.vector(stop.rim)
    running = reach if index == 0 else -reach
    if along is not None:
        direction = poses.vector(along)
        running = direction if poses.positive(running.dot(direction)) else -direction
    left = poses.positive(arm.cross(running))
    return _Rim(stop.body, center, radius if left else -radius, True)


def _free(poses: Poses, a: _Rim, b: _Rim, along: Vec | None) -> tuple[Any, Any]:
    """Length and turning of the direction of a free part."""
    reach = b.center - a.center
    if along is not None:
        direction = poses.vector(along)
        length = reach.dot(direction)
        return (length if poses.positive(length) else -length), poses.angle("ground")
    offset = b.rho - a.rho
    length = poses.root(reach.dot(reach) - offset * offset)
    return length, poses.turned(reach * length - reach.turned() * offset)
