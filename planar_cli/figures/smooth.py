"""Ways so finely sampled that they look smooth, however often they turn round; a circle is gone round once."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import pairwise

from planar_cli.figures.rings import extent_of
from planar_cli.report.document.marks import Spot

TURN = math.radians(10)
"""From piece to piece a way that is smooth turns by no more."""
MOST = 4096
"""A way of more places would be a blot."""
SHORT, DEEP = 1e-4, 10
"""A piece is halved so often, and only while it is longer than this part of the whole: at a corner the turn stays."""
BACK = 1e-6
"""What turns back so exactly, rad, runs along a line."""
ROUND = 1e-5
"""Places that are so near to a circle, in parts of its radius, are on it."""
PROBES = (0.137, 0.461, 0.829)
"""Where it is looked whether equal steps take a whole number of turns each, which would hide them."""
HIDDEN = 2
"""So often all pieces are halved for that."""

Seen = tuple[float, Spot]


def smooth(place: Callable[[float], Spot | None], steps: int) -> tuple[Spot, ...]:
    """Places along a way, from its begin to its end, that turns by no more than `TURN` from piece to piece, but for its
    corners. `place`: that at a share of it, from 0 to 1, None: nothing tells it; `steps`: the fewest pieces. A circle
    that is gone round more than once ends where the way ends, and is gone round once. None: it turns too often.
    """
    seen = _seen(place, [i / steps for i in range(steps + 1)])
    if len(seen) < 3:
        return tuple(s for _, s in seen)
    for _ in range(HIDDEN):
        if any(_is_hidden(place, seen, share) for share in PROBES):
            seen = _halved(place, seen, set(range(len(seen) - 1)))
    for _ in range(DEEP):
        coarse = _coarse(seen)
        if not coarse:
            break
        if len(seen) + len(coarse) > MOST:
            return _circle(seen) or ()
        seen = _halved(place, seen, coarse)
    return (_circle(seen) if abs(_turned(seen)) > 2 * math.pi else ()) or tuple(s for _, s in seen)


def _seen(place: Callable[[float], Spot | None], shares: Sequence[float]) -> list[Seen]:
    told = ((share, place(share)) for share in shares)
    return [(share, spot) for share, spot in told if spot is not None]


def _halved(place: Callable[[float], Spot | None], seen: Sequence[Seen], pieces: set[int]) -> list[Seen]:
    middles = _seen(place, [(seen[i][0] + seen[i + 1][0]) / 2 for i in sorted(pieces)])
    return sorted([*seen, *middles])


def _is_hidden(place: Callable[[float], Spot | None], seen: Sequence[Seen], share: float) -> bool:
    """Is a place of a way far off the piece to which it belongs?"""
    spot = place(share)
    i = next(i for i in range(len(seen) - 1) if i == len(seen) - 2 or seen[i + 1][0] >= share)
    (_, start), (_, end) = seen[i], seen[i + 1]
    if spot is None:
        return False
    around = math.dist(start, spot) + math.dist(spot, end)
    return around > 1.1 * math.dist(start, end) and around > SHORT * extent_of([s for _, s in seen])


def _turns(seen: Sequence[Seen]) -> list[float]:
    """By how much a way turns at each place but its ends, rad; 0 where it turns back along a line."""
    pieces = [complex(b[0] - a[0], b[1] - a[1]) for (_, a), (_, b) in pairwise(seen)]
    turns = []
    for one, other in pairwise(pieces):
        along = other * one.conjugate()
        turn = math.atan2(along.imag, along.real)
        turns.append(0.0 if math.pi - abs(turn) < BACK else turn)
    return turns


def _turned(seen: Sequence[Seen]) -> float:
    """By how much in all, with what its ends take."""
    turns = _turns(seen)
    return math.fsum(turns) + (turns[0] + turns[-1]) / 2 if turns else 0.0


def _coarse(seen: Sequence[Seen]) -> set[int]:
    """The pieces at whose ends a way turns too far."""
    least = SHORT * extent_of([s for _, s in seen])
    found = {k for i, turn in enumerate(_turns(seen)) if abs(turn) > TURN for k in (i, i + 1)}
    return {k for k in found if math.dist(seen[k][1], seen[k + 1][1]) > least}


def _circle(seen: Sequence[Seen]) -> tuple[Spot, ...]:
    """The whole circle on which all places are, round to the end of the way; none: they are on none."""
    spots = [s for _, s in seen]
    found = _through(spots[0], *_apart(spots))
    if found is None:
        return ()
    (x, y), radius = found
    if any(abs(math.dist((x, y), s) - radius) > ROUND * radius for s in spots):
        return ()
    sense, steps = math.copysign(1.0, _turned(seen)), round(2 * math.pi / TURN) * 2
    last = math.atan2(spots[-1][1] - y, spots[-1][0] - x)
    ways = (last + sense * 2 * math.pi * i / steps for i in range(steps + 1))
    return tuple((x + radius * math.cos(w), y + radius * math.sin(w)) for w in ways)


def _apart(spots: Sequence[Spot]) -> tuple[Spot, Spot]:
    """The place farthest from the first one, and that farthest from both."""
    far = max(spots, key=lambda s: math.dist(s, spots[0]))
    return far, max(spots, key=lambda s: min(math.dist(s, spots[0]), math.dist(s, far)))


def _through(a: Spot, b: Spot, c: Spot) -> tuple[Spot, float] | None:
    """Centre and radius of the circle through three places; None: they are in line."""
    p, q = complex(b[0] - a[0], b[1] - a[1]), complex(c[0] - a[0], c[1] - a[1])
    across = 2 * (p.conjugate() * q).imag
    if abs(across) < ROUND * abs(p) * abs(q) or across == 0:
        return None
    middle = 1j * (p * abs(q) ** 2 - q * abs(p) ** 2) / across
    return (a[0] + middle.real, a[1] + middle.imag), abs(middle)
