"""What keeps prescribed motions going, as the multipliers of their relations."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

from planar_cli.problem.facts import Action, Push
from planar_cli.solve.multibody.sparse import CONSTANT, Line
from planar_cli.solve.multibody.time_jets import Slopes


def exerted_by(
    drives: Mapping[Push, int],
    stated: Sequence[tuple[str, Line]],
    count: int,
    push: Callable[[Iterable[Action]], Slopes],
) -> list[tuple[int, Slopes]]:
    """The column of each drive, and the generalized force of a unit of it: the coefficients of its relation between the
    accelerations of bodies, the first `count` columns. Where the relation is one of coordinates, which leaves open
    where it is driven, it acts where the worked solution has it. `stated`: the relations of the file, by
    their text; `push`: the generalized force of actions.
    """
    found = []
    for text in dict.fromkeys(p.place for p in drives):
        own = [p for p in drives if p.place == text]
        lines = [{i: c for i, c in line.items() if i != CONSTANT} for title, line in stated if title == text]
        of_bodies = len(lines) == len(own) and all(i < count for line in lines for i in line)
        found += [(drives[p], lines[k] if of_bodies else push(p.actions)) for k, p in enumerate(own)]
    return found
