"""What the coordinates are that the machine brings: one line where the first of their letters occurs."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

import sympy as sp

from planar_cli.equation.kinematics.line_of_centres import VERTICAL
from planar_cli.equation.kinematics.motion import Edge
from planar_cli.equation.scene.displacement import Coordinate
from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.scene.scene import GROUND, Rod, with_article
from planar_cli.report.document.blocks import Block, Heading, Line, Math, Name, Paragraph, Text, line
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.equations.steps import is_ritual
from planar_cli.report.laws.laws import counted
from planar_cli.report.motion.said_limits import with_limit_said
from planar_cli.report.notation.numbers import rotation_words
from planar_cli.report.recast.across_speeds import across_meanings, without_polar_velocities
from planar_cli.report.words.changes import CHANGE
from planar_cli.report.words.counted import clockwise, turning
from planar_cli.solve.between.trace.trace import MotionTrace

STEP, SHORT = "STEP", 2
ALIKE = (
    (re.compile(r": the angle by which (.+) has turned, (\w+)"), ": the angles by which {} have turned, "),
    (re.compile(r": the angle of the radius to (\w+) (from .+)"), ": the angles of the radii to {} "),
    (re.compile(r": the angle of (\w+) (from .+)"), ": the angles of {} "),
)
"""What is said of one angle, and of several that count alike."""
TURNS, WAY, CIRCLE = "angle of ", "way of ", " on its circle"


def with_meanings(blocks: Sequence[Block], found: MotionTrace, told: set[str]) -> Iterator[Block]:
    """The blocks of a motion, with what its coordinates are behind the heading of the step that speaks of them first.
    `told`: what stands on the page before. The solution of a single equation belongs to the step before it.
    """
    meanings = _meanings(found)
    blocks = with_limit_said(without_polar_velocities(blocks) if across_meanings(found) else blocks, found)
    for i, block in enumerate(blocks):
        yield block
        if isinstance(block, Heading) and block.label.startswith(STEP) and not is_ritual(block):
            stop = next((j for j in range(i + 1, len(blocks)) if _begins(blocks[j])), len(blocks))
            letters = _letters(blocks[i + 1 : stop])
            seen = {found.general.get(s, s) for s in letters} | _accelerated(meanings, letters, found)
            new = {s: words for s, words in meanings.items() if s in seen and str(words) not in told}
            turns = {s: words for s, words in _rotations(found).items() if s in seen and not told}
            new, turns = (new, turns) if new and found.problem.turning else (new or turns, {})
            told.update(map(str, (new | turns).values()))
            if own := _together(list(dict.fromkeys(new.values()))):
                yield Paragraph(line(*(p for k, words in enumerate(own) for p in (*(("; ",) if k else ()), *words))))
            # It is left out again beside an angle of which the page speaks.
            yield from map(Paragraph, turns.values())


def _together(meanings: Sequence[Line]) -> list[Line]:
    """Angles that count alike in one sentence: θ_A, θ_B: the angles by which A and B have turned, clockwise."""
    found: dict[str, list[tuple[Line, str]]] = {}
    for told in meanings:
        last = told[-1].text if isinstance(told[-1], Text) else ""
        key, what = str(told), ""
        for one, several in ALIKE:
            if (alike := one.fullmatch(last)) is not None:
                key, what = f"{several}{alike[2]}", alike[1]
                break
        found.setdefault(key, []).append((told, what))
    return [group[0][0] if len(group) == 1 else _of_several(group, key) for key, group in found.items()]


def _of_several(group: Sequence[tuple[Line, str]], words: str) -> Line:
    """`words`: those of all of them, with a place for what they are of."""
    letters = (p for k, (told, _) in enumerate(group) for p in (*((", ",) if k else ()), told[0]))
    *others, last = (what for _, what in group)
    return line(*letters, words.format(f"{', '.join(others)} and {last}"))


def _accelerated(coordinates: Iterable[sp.Symbol], letters: Iterable[sp.Symbol], found: MotionTrace) -> set[sp.Symbol]:
    """Ways of which s̈ or Δs stands on the page; the rates of an angle are told as ω and α."""
    names, units = {x.name for x in letters}, found.ledger.units
    rates = (s for s in coordinates if {f"{s.name}_ddot", f"{CHANGE}{s.name}"} & names)
    return {s for s in rates if s in units and not units[s].angle}


def _begins(block: Block) -> bool:
    return isinstance(block, Heading) and not is_ritual(block)


def _rotations(found: MotionTrace) -> dict[sp.Symbol, Line]:
    """The angular velocities that count clockwise, where no angle tells that."""
    edges = (e for regime in found.regimes for e in regime.solution.trial.system.tree.edges if e.turn < 0)
    told = _struck if found.problem.turning else _loaded
    return {e.spin: told(e.spin, e, found) for e in edges if e.spin is not None}


def _loaded(spin: sp.Symbol, edge: Edge, found: MotionTrace) -> Line:
    """Of what rolls on the ground among other bodies it is what is asked that tells how it counts, not its loads."""
    asked = len(found.problem.bodies) > 1 and edge.parent == GROUND
    return line(Math(spin), " is counted clockwise.") if asked else clockwise(Math(spin), edge)


def _struck(spin: sp.Symbol, edge: Edge, found: MotionTrace) -> Line:
    """Of what a blow turns; without a reason where it turns the other way for a while, as a ball struck low does."""
    own = [s for s, general in found.general.items() if general == spin and not found.value.vanishes(s)]
    back = any((number := found.value.known(s)) is not None and number < 0 for s in own)
    return line(Math(spin), " is counted clockwise.") if back else turning(Math(spin), edge)


def _letters(blocks: Sequence[Block]) -> set[sp.Symbol]:
    """The letters of formulas."""
    return {s for b in blocks for p in pieces_of(b) if isinstance(p, Math) for s in p.expr.free_symbols}


def _meanings(found: MotionTrace) -> dict[sp.Symbol, Line]:
    """By its letter what each coordinate is that the file does not declare."""
    own = {s.name for s in found.problem.coordinates}
    meanings: dict[sp.Symbol, Line] = across_meanings(found)
    for regime in found.regimes:
        scene = regime.solution.instant.scene
        for c in scene.displacement.coordinates if scene.displacement is not None else ():
            turn = regime.solution.trial.system.tree.turn((c.body,))
            words = "" if c.symbol.name in own else _meaning(c, scene, turn)
            if words:
                # The letter of a way may be told in short, like its rates.
                letter = Name(c.symbol.name) if c.words.startswith(WAY) else Math(c.symbol)
                meanings.setdefault(c.symbol, line(letter, f": {words}", *_by_place(c)))
    return meanings


def _by_place(c: Coordinate) -> Line:
    """`, s = h - y` of what counts its way downward from y = h; empty of what counts along an axis."""
    if not c.against:
        return ()
    zero = (Math(c.zero), " - ") if c.zero != 0 else ("-",)
    return line(", ", Name(c.symbol.name), " = ", *zero, Name(c.symbol.name.replace("s", c.against, 1)))


def _meaning(c: Coordinate, scene: Scene, turn: int) -> str:
    """What one coordinate is; empty where its name says it, as x_P does, or nothing short does. `turn`: -1 of an angle
    that counts clockwise.
    """
    if c.words.endswith(CIRCLE):
        place = c.words.removeprefix(TURNS).removesuffix(CIRCLE)
        if c.body not in (place, scene.owner(place)):
            return ""
        return f"the angle of the radius to {place} from the x axis, counterclockwise"
    if c.words.endswith(VERTICAL):
        return f"the {c.words}, counterclockwise"
    if c.against:
        return counted(c.words)
    if c.words.startswith(WAY):
        return f"the {c.words}, from where it is drawn"
    if c.words != f"{TURNS}{c.body}":
        return ""
    shape = next((b.shape for b in scene.problem.bodies if b.name == c.body), None)
    if isinstance(shape, Rod):
        ends = f"{shape.start}{shape.end}" if len(shape.start) <= SHORT and len(shape.end or "") <= SHORT else ""
        return f"the angle of {ends if shape.end and ends else c.body} from the x axis, counterclockwise"
    return f"the angle by which {with_article(c.body)} has turned, {rotation_words(turn)}" if c.drawn == 0 else ""
