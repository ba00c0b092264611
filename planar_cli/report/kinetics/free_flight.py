"""A particle on which its weight alone acts, and whose mass is open as it cancels, is in free flight: no diagram is
drawn for what everybody knows.

    a_x = 0
    a_y = -g = -9.81 m/s²                               only the weight acts

Nor is one drawn of bodies on which no force acts at all: A stays at rest, B keeps its velocity.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from planar_cli.problem.nodes.reading import listed
from planar_cli.problem.scene.scene import with_article
from planar_cli.report.document.blocks import Block, Equation, Forces, Heading, Line, Math, Paragraph, Text, line
from planar_cli.report.equations.steps import KINETICS, is_ritual
from planar_cli.report.words.stretches import stretches
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.solved_problem import PartSolution

FREE, ALONE = "Free flight", "Motion without forces"
SO_THAT = ", so that "
NOTHING = Text("0")
"""Stands in a diagram for no forces."""
PAIR = 2
WEIGHT = line("only the weight acts:")
"""Stands before what it says of the acceleration; a page has it behind."""


def in_free_flight(blocks: Sequence[Block], part: PartSolution, instant: InstantSolution) -> list[Block]:
    """The blocks of a general position; its step of forces as the accelerations of a flight, where it is one."""
    problem = instant.instant.scene.problem
    start = next((i for i, b in enumerate(blocks) if isinstance(b, Heading) and b.text == KINETICS), None)
    if start is None:
        return list(blocks)
    step, heading = blocks[start + 1 :], blocks[start]
    drawn = [b for b in step if isinstance(b, Forces)]
    assert isinstance(heading, Heading)
    if drawn and all(b.left == (NOTHING,) and b.right != (NOTHING,) for b in drawn):
        at_once = all(_is_of_form(b) for b in step) and all(_acceleration(b) for b in step if isinstance(b, Equation))
        said = without_forces([b.body for b in drawn], part, instant)
        return [*blocks[:start], replace(heading, text=ALONE, aside=""), said] if at_once else list(blocks)
    open_masses = {b.name for b in problem.bodies if b.any_mass}
    if problem.plane != "vertical" or len(drawn) != 1 or drawn[0].body not in open_masses:
        return list(blocks)
    if not _is_weight(drawn[0].left):
        return list(blocks)
    found = [e for b in step if (e := _acceleration(b)) is not None]
    if not found or not all(_is_of_form(b) for b in step) or {b.number for b in found} != {None}:
        return list(blocks)
    falls = [e for e in found if len(e.sides) > 1 and e.sides[1] != line("0")]
    told = [replace(e, lead=WEIGHT if e in falls else ()) for e in found]
    return [*blocks[:start], replace(heading, text=FREE, aside=""), *told]


def without_forces(bodies: Sequence[str], part: PartSolution, instant: InstantSolution) -> Paragraph:
    """What bodies do on which no force acts: A stays at rest, B keeps its velocity."""
    motion = part.motion
    assert motion is not None
    own = motion.regime(instant).stretches
    resting = [b for b in bodies if all(_rests(b, start, motion, instant) for start, _ in own)]
    turning = [b.name for b in motion.problem.bodies if b.name in bodies and not b.is_particle]
    whole = own[0][0] == motion.states[0] and own[-1][1] in ("", motion.states[-1])
    during = listed(stretches(part, instant).split(", "), "and")
    span = "No force" if whole and len(own) == 1 else f"{during[0].upper()}{during[1:]} no force"
    words = f"{span} acts on {listed(map(with_article, bodies), 'and')}: "
    if len(bodies) > 1 and not resting and not turning:
        return Paragraph(line(f"{words}{'both keep' if len(bodies) == PAIR else 'all keep'} their velocity."))
    keeps = {b: f"keeps its velocity{' and its angular velocity' if b in turning else ''}" for b in bodies}
    does = (f"{with_article(b)} {'stays at rest' if b in resting else keeps[b]}" for b in bodies)
    return Paragraph(line(f"{words}{listed(does, 'and')}."))


def _rests(body: str, start: str, motion: MotionTrace, instant: InstantSolution) -> bool:
    """Does a free body neither move nor turn from a state on?"""
    here = {g: own for own, g in motion.general.items() if motion.ledger.roles[own].at == start}
    still = {s for s, own in here.items() if motion.route.plain.get(own) == 0}
    edge = next((e for e in instant.trial.system.tree.edges if e.body == body), None)
    return edge is not None and {edge.slide, edge.rise} | ({edge.spin} - {None}) <= still


def is_flight(page: Sequence[Block]) -> bool:
    """Does a page tell of a free flight, and of no other forces?"""
    headed = any(isinstance(b, Heading) and b.text == FREE for b in page)
    return headed and not any(isinstance(b, Forces) for b in page)


def _is_weight(acting: Line) -> bool:
    match acting:
        case (Math(), Text(text)):
            return text.strip() == "↓"
    return False


def _is_of_form(block: Block) -> bool:
    """Is it the diagram, a sum of forces, or what follows from one?"""
    if isinstance(block, Heading):
        return is_ritual(block)
    return isinstance(block, Forces | Equation) or (isinstance(block, Paragraph) and len(block.line) == 1)


def _acceleration(block: Block) -> Equation | None:
    """a_x = 0 of `0 = m a_x, so that a_x = 0`; a_y = -g, which an equation gave."""
    if not isinstance(block, Equation):
        return None
    match block.sides[-1]:
        case (*_, Text(text), Math() as letter, Text(" = 0")) if text == SO_THAT:
            return Equation((letter, line("0")))
    solved = block.number is None and isinstance(block.sides[0], Math) and block.sides[0].expr.is_Symbol
    return block if solved else None
