"""What turns a body back that rocks on its round end: where its mass centre is when it has turned by δ, and its moment
of inertia about the point of contact.

G lies below O, above C; turned by δ it is (r - y_G) sin δ ≈ (r - y_G) δ to the right of C: the weight turns it back.
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.scene.centres import centre_of
from planar_cli.equation.values.ledger import display
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Name, Paragraph, Value, line
from planar_cli.report.kinematics.rolled_points import centre_on_a_line
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.oscillation.linearised import DEVIATION
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.oscillation_trace import NearRest
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import INERTIA


@record
class Rocking:
    """A body on a round end near its equilibrium: `told` before its sum of moments about the point of contact, and the
    right side of that by I_C; None: it stays as it is, where only its sign counts.
    """

    told: tuple[Block, ...]
    right: sp.Expr | None


def rocking(
    near: NearRest, instant: InstantSolution, phrases: Phrases, constants: Phrases | None = None
) -> Rocking | None:
    """None: the one sum of the page is of another kind, or G is not right above or below the middle. `constants`:
    speaks of what has a number all the time.
    """
    system, value, at = instant.trial.system, instant.value, dict(near.places)
    scene, motion = system.scene, system.motion
    if motion is None or not system.tree.edges:
        return None
    edge = system.tree.edges[0]
    alpha, j, model = motion.accelerations[edge.body].angular, edge.joining, scene.bodies[edge.body]
    middle = None if j is None or j.rolling is None else centre_on_a_line(system, j, phrases)
    coefficient = near.inertia.coeff(alpha)
    if j is None or middle is None or len(system.tree.edges) > 1 or model.mass == 0 or coefficient == 0:
        return None

    def placed(vector: Vec) -> Vec:
        return Vec(*(simplified(sp.sympify(p).xreplace(at)) for p in (vector.x, vector.y)))

    name, _, place = middle
    off, arm = placed(model.center - place), placed(model.center - j.point)
    whole = model.inertia + model.mass * arm.dot(arm)
    weight = model.mass * scene.gravity
    rests = value.vanishes(off.x) and value.vanishes(arm.x) and value.known(off.y) is not None
    if not rests or not all(map(value.vanishes, (near.slope - weight * off.y, whole - coefficient))):
        return None
    below = value(off.y) < 0
    lever, letter = simplified(near.slope / weight) * (-1 if below else 1), f"I_{j.place}"
    if letter in scene.ledger.symbols or (value.known(lever) or 0) <= 0:
        return None
    inertia = sp.Symbol(letter, positive=True)
    contact = Name(j.place)
    where = line(Name(centre_of(scene, edge.body)), f" lies {'below' if below else 'above'} ", Name(name))
    aside = (phrases.math(lever * sp.sin(DEVIATION)), " ≈ ", phrases.math(lever * DEVIATION))
    side = f" to the {'right' if below else 'left'} of "
    then = f": the weight turns it {'back' if below else 'further'}"
    words = line(
        *where,
        ", in line with ",
        contact,
        "; turned by ",
        phrases.math(DEVIATION),
        " it is ",
        *aside,
        side,
        contact,
        then,
    )
    if not below:
        return Rocking((Paragraph(words),), None)
    about = _about_contact(edge.body, inertia, whole, j.place, constants or phrases)
    return Rocking((Paragraph(words), about), inertia * alpha)


def _about_contact(body: str, letter: sp.Symbol, whole: sp.Expr, place: str, phrases: Phrases) -> Equation:
    """I_C = I + m CG², with its numbers, or in the letters of the file."""
    lead = line(f"moment of inertia of {body} about ", Name(place), ", parallel axes:")
    if phrases.has_numbers(whole):
        unit = coherent_unit(INERTIA, False, phrases.ledger.us)
        shown = Value(display(phrases.value(whole), unit, phrases.ledger.us), unit.text, phrases.figures)
        sides: list[Inline | Line] = [phrases.math(letter), phrases.math(whole)]
        sides += [*phrases.substituted(whole, shown), shown]
        return Equation(tuple(sides), None, lead)
    if not phrases.ledger.symbolic:
        return Equation((phrases.math(letter), phrases.math(whole)), None, lead)
    closed = whole.xreplace({s: phrases.ledger.behind(s) for s in whole.free_symbols})
    return Equation((phrases.math(letter), phrases.math(whole), phrases.math(simplified(closed))), None, lead)
