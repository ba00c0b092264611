"""In which sense rotations count on a page: clockwise where a body is known to begin to turn that way."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.kinematics.motion import Edge
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import Valuation
from planar_cli.problem.implied.stated_clockwise import states_clockwise
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, with_article
from planar_cli.report.document.blocks import Block, Line, Math, Name, Paragraph, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.written import Written
from planar_cli.solve.solution import Found, InstantSolution
from planar_cli.solve.solved_problem import PartSolution


def sense_of(turn: int) -> str:
    """The arrow before a sum of moments."""
    return "↺" if turn > 0 else "↻"


def clockwise_letter(expr: sp.Expr, instant: InstantSolution) -> sp.Symbol | None:
    """The letter that counts clockwise, where an expression is that letter counted the other way; else None."""
    found = as_vector(sp.sympify(expr), instant.trial.system)
    return found if found != expr else None


def as_vector(expr: sp.Expr, system: System) -> sp.Expr:
    """ω or α before ×: the letter of the vector, whichever way its size counts."""
    clockwise = any(e.turn < 0 and -expr in (e.spin, e.spin_rate) for e in system.tree.edges)
    return -expr if clockwise else expr


def positive(part: tuple[Vec, sp.Expr]) -> tuple[Vec, sp.Expr]:
    """A component of an acceleration that is a letter with a minus, as that letter in the opposite direction."""
    direction, component = part
    return (-direction, -component) if (-sp.sympify(component)).is_Symbol else part


def as_given(part: tuple[Vec, sp.Expr], equations: Iterable[Written]) -> tuple[Vec, sp.Expr]:
    """A component of an acceleration of which a datum says what it is against its letter, as that in its own direction:
    m a to the left for a_wedge = -a.
    """
    direction, component = part
    letter = sp.sympify(component)
    data = (w.residual for w in equations if w.source == "given" and not w.times)
    own = [(d - letter * way, way) for d in data if abs(way := d.coeff(letter)) == 1] if letter.is_Symbol else []
    given = next((-rest / way for rest, way in own if not rest.has(letter)), sp.S.Zero)
    against = not given.is_number and given.could_extract_minus_sign()
    return (-direction, -given) if against else part


def as_counted(part: PartSolution) -> PartSolution:
    """The same finds, those that are a letter which counts clockwise in its sense."""
    if part.motion is None:
        return replace(part, found=tuple(_as_counted(f, part) for f in part.found))
    motion, found = part.motion, list(part.found)
    requests = []
    for r in motion.requests:
        letter = -r.parts[0] if len(r.parts) == 1 else sp.S.Zero
        general = motion.general.get(letter, letter)
        turned = any(clockwise_letter(-general, i) == general for i in part.instants) if letter.is_Symbol else False
        requests.append(replace(r, parts=(letter,)) if turned else r)
        if turned:
            found = [_turned(f, letter, motion.value) if f.find is r.find else f for f in found]
    return replace(part, found=tuple(found), motion=replace(motion, requests=tuple(requests)))


def _as_counted(found: Found, part: PartSolution) -> Found:
    (asked, *others) = found.asked or (sp.S.Zero,)
    counting = ((i, letter) for i in part.instants if (letter := clockwise_letter(asked, i)) is not None)
    instant, letter = next(counting, (None, asked))
    if instant is None or others:
        return found
    return _turned(found, letter, instant.value)


def _turned(found: Found, letter: sp.Symbol, value: Valuation) -> Found:
    """A find that is a letter which counts clockwise."""
    expressions = None if found.expressions is None else tuple(-e for e in found.expressions)
    values = None if found.values is None else (value.settled(letter, (expressions or (letter,))[0]),)
    return replace(found, asked=(letter,), expressions=expressions, values=values, turn=-1)


def counted(system: System, phrases: Phrases) -> Iterator[Block]:
    """What is said of it, once."""
    several = _rolling(system)
    for e in system.tree.edges:
        # What a blow turns is told where the angular velocity stands first.
        told = e.turn < 0 and e.spin_rate is not None and not system.scene.problem.turning
        if told and (len(several) < 2 or e is several[0]):
            words = _all_of(several, phrases, system) if len(several) > 1 else _clockwise(phrases, e, system)
            yield Paragraph(words)
        # What goes one way through a motion is told with its coordinate.
        if e.slide_rate is not None and e.body not in system.builder.going and (way := _way(e)):
            yield Paragraph(line(phrases.math(e.slide_rate), f" is counted {way}."))


def _clockwise(phrases: Phrases, edge: Edge, system: System) -> Line:
    """That a rotation counts clockwise, and why: the file states or asks it so, or the loads tell it."""
    letter, body = phrases.math(edge.spin_rate), with_article(edge.body)
    if states_clockwise(system.scene.problem):
        return line(phrases.math(edge.spin), " and ", letter, f" are counted clockwise, the way in which {body} turns.")
    if len(system.scene.bodies) > 1:
        return line(letter, f" is counted clockwise, the way in which {body} rolls along ", _centre(edge, system), ".")
    return clockwise(letter, edge)


def _rolling(system: System) -> list[Edge]:
    """The bodies of a scene of several that count clockwise as they roll."""
    if states_clockwise(system.scene.problem) or len(system.scene.bodies) < 2:
        return []
    return [e for e in system.tree.edges if e.turn < 0 and e.spin_rate is not None]


def _all_of(edges: Sequence[Edge], phrases: Phrases, system: System) -> Line:
    """α_rear, α_front are counted clockwise, the way in which the rear rolls along a_A, the front along a_B."""
    letters = (p for k, e in enumerate(edges) for p in (", " * bool(k), phrases.math(e.spin_rate)))
    ways: list[Any] = []
    for k, e in enumerate(edges):
        ways += [
            f", {with_article(e.body)} along " if k else f"{with_article(e.body)} rolls along ",
            _centre(e, system),
        ]
    return line(*letters, " are counted clockwise, the way in which ", *ways, ".")


def _centre(edge: Edge, system: System) -> Name:
    return Name(f"a_{system.scene.center_name(edge.body)}")


def clockwise(letter: Math, edge: Edge) -> Line:
    """That a rotation counts clockwise, as all loads turn the body that way about the point of the ground that holds
    it; of a body that others carry that it turns so.
    """
    if edge.parent != GROUND or edge.joining is None:
        return turning(letter, edge)
    why = f" is counted clockwise, the way in which the loads turn {with_article(edge.body)} about "
    return line(letter, why, Name(edge.joining.place.replace("_", ",")), ".")


def turning(letter: Math, edge: Edge) -> Line:
    """That a rotation counts clockwise, as the body turns so."""
    return line(letter, f" is counted clockwise, the way in which {with_article(edge.body)} turns.")


def _way(edge: Edge) -> str:
    """The direction in which a speed along a fixed axis counts, where it is against the axis: downward, to the left."""
    path = edge.joining.path if edge.joining is not None else None
    if path is None or path.curvature != 0 or edge.parent != GROUND:
        return ""
    tangent = path.tangent
    for across, along, words in ((tangent.x, tangent.y, "downward"), (tangent.y, tangent.x, "to the left")):
        if across == 0 and along == -1:
            return words
    return ""


def clockwise_too(w: Written, turn: int) -> Written:
    """A sum of moments in the sense in which its rotations count."""
    if turn > 0:
        return w
    return replace(w, left=opposite(w.left), right=opposite(w.right))


def one_way_round(w: Written, turn: int) -> tuple[Written, int]:
    """A sum of moments in the sense in which its terms are positive, where all have the other, or where the one moment
    of what is accelerated has; with that sense.
    """
    if w.law != "moment" or not counts_the_other_way(w.left, w.right):
        return w, turn
    return clockwise_too(w, -1), -turn


def counts_the_other_way(left: sp.Expr, right: sp.Expr, moments: bool = True) -> bool:
    """Are all terms of an equation negative? Or in a sum of moments that of what turns, and one of the others; or that
    alone, where the others are not negative the other way round?
    """
    told, gained = ([t.could_extract_minus_sign() for t in sp.Add.make_args(s) if t != 0] for s in (left, right))
    if all(told + gained):
        return True
    turned = (t.could_extract_minus_sign() for t in sp.Add.make_args(opposite(left)))
    return moments and gained == [True] and (any(told) or not any(turned))


def opposite(side: sp.Expr) -> sp.Expr:
    """A side of a sum of moments, each of which counts the other way."""
    return sp.Add(*(_opposite(t) for t in sp.Add.make_args(side)))


def _opposite(term: sp.Expr) -> sp.Expr:
    """A term with the other sign: F (h - R) instead of -F (R - h)."""
    factors = sp.Mul.make_args(term)
    arm = next((f for f in factors if f.is_Add and not term.could_extract_minus_sign()), None)
    if arm is None or len(arm.args) != 2 or not any(t.could_extract_minus_sign() for t in arm.args):
        return -term
    return sp.Mul(*(sp.Add(*(-t for t in arm.args)) if f == arm else f for f in factors))
