"""What to write where an impact takes part in a motion whose states do not tell it."""

from __future__ import annotations

from planar_cli.errors import FileProblem, refuse
from planar_cli.problem.scene.scene import Problem


def unnamed_impact(problem: Problem) -> FileProblem:
    """An impact happens at no state of the file, so that no equation relates what is before and after."""
    joint = next(j for j in problem.joints if j.strikes and j.during is None)
    hint = "write `during: 1->2`, and `2: [just after 1]`; or follow the motion with `planar simulate`"
    return refuse(joint.mark, "PL433", f"the {joint.kind} does not say when it happens", hint)


def pressing_impact(problem: Problem) -> FileProblem:
    """Bodies rest on each other by an impact alone, and following the motion does not answer everything."""
    joint = next(j for j in problem.joints if j.strikes)
    hint = "add a `contact` where they touch at the start; or follow the motion with `planar simulate`"
    return refuse(joint.mark, "PL433", f"the {joint.kind} has to carry its bodies before they strike", hint)
