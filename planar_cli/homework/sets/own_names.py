"""Names to which a case gives a value of its own: what varies in the file does not vary there."""

from __future__ import annotations

from planar_cli.problem.scene.scene import Problem


def own_names(part: Problem, whole: Problem) -> frozenset[str]:
    """The names that a case gives itself, be it with the value that the file has; `part`: the file as the case sees it.
    None of the file itself.
    """
    of_file = {s.name: s.mark for s in whole.given}
    return frozenset(s.name for s in part.given if of_file.get(s.name) != s.mark)
