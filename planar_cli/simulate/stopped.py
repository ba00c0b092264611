"""A motion of which nothing is known: it is refused at its place in the file, and there is no table of it."""

from __future__ import annotations

from planar_cli.errors import Diagnostic, Mark, NoSolution, Undecided
from planar_cli.joints.base import distinct
from planar_cli.motion.trajectory.trajectory import Outcome, Trajectory
from planar_cli.problem.scene.scene import Problem

CONTRADICTIONS = ("PL539", "PL700", "PL701", "PL708", "PL714", "PL715", "PL717", "PL718")
"""Codes of outcomes in which the scene contradicts itself, or has none or several ways to go on."""


class NotFollowed(Undecided):
    """A motion that could not be followed at all; located diagnostics say why."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        self.diagnostics = (diagnostic,)
        super().__init__(diagnostic.message)


def refusal(problem: Problem, trajectory: Trajectory) -> NoSolution | NotFollowed | None:
    """What to say of a motion that ends where it begins; None: some of it was followed, or it ended as it should."""
    outcome = trajectory.outcome
    if not outcome.refused or trajectory.segments or trajectory.transitions:
        return None
    found = Diagnostic(_place(problem, outcome), outcome.code, outcome.words)
    return NoSolution([found]) if outcome.code in CONTRADICTIONS else NotFollowed(found)


def _place(problem: Problem, outcome: Outcome) -> Mark:
    """The line of the joint or body where the motion ends, else that of the state in which it begins."""
    here = [j.mark for j in distinct(problem.joints) if j.name == outcome.joint]
    here += [b.mark for b in problem.bodies if b.name == outcome.joint]
    return next(iter([*here, *(s.mark for s in problem.states[:1])]), Mark(problem.file, 1, 1))
