"""What keeps prescribed motions going, as the multipliers of their relations."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from planar_cli.problem.scene.facts import Push
from planar_cli.solve.multibody.sparse import CONSTANT, Line
from planar_cli.solve.multibody.time_jets import Slopes


def exerted_by(
    drives: Mapping[Push, int],
    stated: Sequence[tuple[str, Line]],
    count: int,
    through: Callable[[str], Slopes | None],
) -> dict[Push, Slopes]:
    """The generalized force of a unit of each drive: the coefficients of its relation between the accelerations of
    bodies, the first `count` columns; of a relation of coordinates, by its text, what works `through` them. Nothing
    where neither is found. `stated`: the relations of the file, by their text.
    """
    found: dict[Push, Slopes] = {}
    for text in dict.fromkeys(p.place for p in drives):
        own = [p for p in drives if p.place == text]
        lines = [{i: c for i, c in line.items() if i != CONSTANT} for title, line in stated if title == text]
        of_bodies = len(lines) == len(own) and all(i < count for line in lines for i in line)
        found |= {p: lines[k] if of_bodies else through(text) or {} for k, p in enumerate(own)}
    return found
