"""Which way the force of a guide acts that is negative: a guide holds from both sides, so that its joint counts the
force in a sense of its own.

N = -1.2 lbf, that is 1.2 lbf downward;  N_circle = -2.704 N, that is 2.704 N away from the centre Q
"""

from __future__ import annotations

from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.system.system import System
from planar_cli.equation.values.ledger import display
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, Circle
from planar_cli.report.document.blocks import Line, Value, line
from planar_cli.report.notation.numbers import vector_words
from planar_cli.report.words.words import Phrases, told_unit
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution


def guide_sense_words(found: Found, part: PartSolution, phrases: Phrases) -> Line:
    """What stands behind the negative number: the size and the direction of the force on what slides; empty of other
    answers, and where the force is asked over time.
    """
    what = found.find.found.what if found.find is not None else None
    if not isinstance(what, Quantity) or what.word != "N" or len(found.values or ()) != 1 or what.at is not None:
        return ()
    if part.motion is not None or part.tale is not None or len(part.instants) != 1 or phrases.symbolic:
        return ()
    assert found.values is not None
    number = display(found.values[0], found.unit, phrases.ledger.us)
    guide = what.things[0] if len(what.things) == 1 else ""
    acts = _acts(part.instants[0].trial.system, guide) if number < 0 else None
    if acts is None:
        return ()
    point, force = acts
    words = _about_centre(part.instants[0].instant.scene, guide, point, force, phrases) or vector_words(
        phrases.certain(force.x), phrases.certain(force.y)
    )
    return line(", that is ", Value(-number, told_unit(found.unit, found.energy), phrases.figures), f" {words}")


def _acts(system: System, guide: str) -> tuple[Vec, Vec] | None:
    """Where a guide acts on what slides in it, and which way where its force is negative; None: it is no guide."""
    if not any(j.kind == "guide" and j.name == guide for j in system.scene.problem.joints):
        return None
    pushes = [p for p in system.pushes if p.joint == guide and p.kind == "normal"]
    if len(pushes) != 1:
        return None
    # The first action is that on what slides, as the answer counts it.
    action = pushes[0].actions[0]
    return None if action.force is None else (action.point, -action.force)


def _about_centre(scene: Scene, guide: str, point: Vec, force: Vec, phrases: Phrases) -> str:
    """Of a circular track, whether the force points to the centre; empty of any other."""
    along = next((getattr(j, "along", None) for j in scene.problem.joints if j.name == guide), None)
    surface = scene.surfaces.get(str(getattr(along, "name", along) or ""))
    if surface is None or not isinstance(surface.shape, Circle):
        return ""
    centre = surface.shape.center
    inward = phrases.certain((scene.carried(surface.body or GROUND, centre) - point).dot(force))
    return f"{'towards' if inward > 0 else 'away from'} the centre {centre}" if inward else ""
