"""A check of a moment of inertia that was found by way of the mass centre: each part about the point itself.

moments of inertia about O, part by part: 1.57 - 0.2437 = 1.326 kg·m²
"""

from __future__ import annotations

from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.language.expression import Quantity
from planar_cli.report.document.blocks import Line, line
from planar_cli.report.in_numbers.sums import agree, chain
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import INERTIA

MOST = 6
"""Parts that fit a line."""


def inertia_check(part: PartSolution, phrases: Phrases) -> Line:
    """Of the first that is asked about a point which is not the mass centre; empty where there is none."""
    if phrases.symbolic or part.motion is not None or not part.instants:
        return ()
    scene = part.instants[-1].instant.scene
    return next((told for found in part.found if (told := _told(found, scene, phrases))), ())


def _told(found: Found, scene: Scene, phrases: Phrases) -> Line:
    what = found.find.found.what if found.find is not None else None
    match what:
        case Quantity(word="I", things=(body, point)) if body in scene.bodies:
            model, about, known = scene.bodies[body], scene.point(point), phrases.value.known
        case _:
            return ()
    arm = model.center - about
    if not 2 <= len(model.parts) <= MOST or phrases.value.is_zero(arm.dot(arm)):
        return ()
    arms = [(mass, own, centre - about) for mass, own, centre in model.parts]
    terms = [known(own + mass * r.dot(r)) for mass, own, r in arms]
    whole, numbers = known(found.asked[0]), [t for t in terms if t is not None]
    if whole is None or len(numbers) < len(terms) or not agree(numbers, [whole]):
        return ()
    unit = coherent_unit(INERTIA, False, phrases.ledger.us)
    return line(f"moments of inertia about {point}, part by part: ", *chain(numbers, unit, phrases))
