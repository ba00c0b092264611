"""What a lesson says beside the solution: what each step of this page is for, and which trap it avoids; no equation."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from typing import TypeGuard

from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Heading, Paragraph, Text, line
from planar_cli.report.equations.steps import EQUILIBRIUM, KINETICS, SOLVING
from planar_cli.report.notation.names import plain_name
from planar_cli.report.page.uses import Uses
from planar_cli.solve.law import RELATIVE
from planar_cli.solve.passages import ALONG, CURVE, PLACES, RADIAL, RATES, ROLLING

KINEMATICS = "Kinematic analysis"
WELDED = ", what is stuck together as one where nobody asks for the force between"


@record
class Lesson:
    """Words about a step, told once on a page."""

    steps: tuple[str, ...]
    """With one of these the heading of the step begins; empty: any step of a motion."""
    words: Callable[[Uses], Iterator[str]]


def with_lessons(blocks: Sequence[Block], uses: Uses, told: set[str]) -> list[Block]:
    """The blocks of a part with the words of the lesson behind the headings of its steps; of a part without steps at
    its beginning. The first step of a motion that needs no other has the words of kinematics too. `told`: on the page
    before.
    """
    found: list[Block] = []
    alone = not any(_is_step(b) for b in blocks)
    moving = not any(_is_step(b) and b.text in (KINEMATICS, KINETICS, EQUILIBRIUM, SOLVING) for b in blocks)
    for block in blocks:
        if alone and isinstance(block, Paragraph | Equation):
            found += _new([*_words(KINEMATICS, uses), *_words("", uses)], told)
            alone = False
        found.append(block)
        if _is_step(block):
            found += _new(_words(KINEMATICS, uses) if moving else [], told)
            found += _new(_words(block.text, uses), told)
    return found


def _is_step(block: Block) -> TypeGuard[Heading]:
    return isinstance(block, Heading) and block.label.startswith("STEP")


def _new(words: Sequence[str], told: set[str]) -> list[Block]:
    """The words that were not told before, each as a paragraph."""
    new = [w for w in words if w not in told]
    told.update(new)
    return [Paragraph(line(Text(w, "muted"))) for w in new]


def _words(title: str, uses: Uses) -> list[str]:
    of_motion = title not in (KINEMATICS, KINETICS, EQUILIBRIUM, SOLVING)
    own = [x for x in LESSONS if (title in x.steps if x.steps else of_motion)]
    return [words for lesson in own for words in lesson.words(uses)]


def _listed(names: Collection[str]) -> str:
    *first, last = dict.fromkeys(plain_name(n) for n in names)
    return f"{', '.join(first)} and {last}" if first else last


# --- kinematics ------------------------------------------------------------------------------------------------------


def _why_kinematics(uses: Uses) -> Iterator[str]:
    if uses.kinetic:
        yield (
            "Motion comes before force: each relation between accelerations that is found here is one "
            "unknown less later."
        )
    if uses.at_rest and uses.kinetic:
        turned = ", and with them every normal acceleration" if uses.axles or uses.moments or uses.rolling else ""
        yield (
            f"Released from rest: all velocities are zero{turned}. "
            "The trap is to take the accelerations for zero too: the motion is only about to begin."
        )


def _rolling(uses: Uses) -> Iterator[str]:
    for mover, base, place in uses.rolling:
        on = "the ground" if base == "ground" else base
        yield (
            f"{mover} rolls on {on}: at {place} the velocities of both agree, and the accelerations "
            "along the contact. "
            "The trap is to equate the accelerations across it: the point of contact is accelerated "
            "towards the centre."
        )


def _sliding(uses: Uses) -> Iterator[str]:
    if not uses.sliding:
        return
    bases = _listed([base for _, base in uses.sliding])
    one = len(uses.sliding) == 1
    where = _listed([f"{place} {'slides ' if one else ''}along {base}" for place, base in uses.sliding])
    yield (
        f"{'' if one else 'There slides '}{where}, and {bases} {'turns' if one else 'turn'}. To the acceleration of "
        "the point of that body under it and the relative one comes a third part, twice the angular velocity times the "
        "relative velocity. It is there even where the point slides at a constant rate; to leave it out is the usual "
        "mistake."
    )


def _component(uses: Uses) -> Iterator[str]:
    places: dict[str, list[str]] = {}
    for place, unknown in uses.left_out:
        places.setdefault(place, []).append(plain_name(unknown))
    for place, unknowns in places.items():
        at = f"At {place} the" if place else "The"
        does = "does not enter" if len(set(unknowns)) == 1 else "do not enter"
        yield (
            f"{at} component is taken in which {_listed(unknowns)} {does}, so that one equation has one unknown. "
            "The trap is to let a link that moves as a whole circle about its other end: that holds of the relative "
            "motion only."
        )


def _cords(uses: Uses) -> Iterator[str]:
    if uses.cords:
        yield (
            f"{_listed(uses.cords)}: the length stays the same, so that what runs in at one end runs out at the other. "
            "The trap is the sign; only the components along the straight parts count."
        )
    if uses.wound:
        on = list(dict.fromkeys(drum for _, drum in uses.wound))
        yield (
            f"{_listed([cord for cord, _ in uses.wound])}: where the cord leaves {_listed(on)} it moves as the rim on "
            "which it is wound. The trap is the radius: it is that of the winding, whatever the radius of the body."
        )
    if uses.links:
        yield (
            f"{_listed(uses.links)}: the distance of both ends stays the same, so that along the line between them "
            "their velocities agree. The trap is to let the accelerations agree too, which they do at rest alone."
        )


PASSAGES = {
    PLACES: (
        "A position vector is put together from known ones, tip to tail. The trap is the order: from A to B counts "
        "what B has more than A."
    ),
    RATES: (
        "The place is written for any instant, and then differentiated. The trap is to put numbers in before: what is "
        "a number has no rate."
    ),
    ALONG: (
        "Along the path counts the change of the speed, across it the speed squared over the radius. The trap is to "
        "leave out the second where the speed is constant."
    ),
    RADIAL: (
        "In polar coordinates the unit vectors turn with the point, and each turning adds a term. The trap is to take "
        "the second rates of the coordinates for the components of the acceleration."
    ),
    CURVE: (
        "Both coordinates are known as functions of one parameter, which is eliminated. The trap is the range: the "
        "point may run over a part of the curve only."
    ),
    ROLLING: (
        "A wheel that rolls advances by the arc that it unrolls. The trap is the angle: it counts in radians, and from "
        "the place where the rolling began."
    ),
}


def _passages(uses: Uses) -> Iterator[str]:
    places = {PLACES} if uses.asked and uses.asked <= {"r", "x", "y"} and not uses.relations else set()
    yield from (words for kind, words in PASSAGES.items() if kind in uses.passages | places)
    if uses.beside and not uses.sliding:
        yield (
            "A velocity relative to something that moves is the difference of both, as vectors. The trap is to take "
            "the difference of the speeds, or the vectors in the wrong order."
        )


def _axles(uses: Uses) -> Iterator[str]:
    if uses.axles and not uses.kinetic and not uses.left_out:
        yield (
            "A point of a body that turns about a fixed axis moves on a circle: its velocity is across the radius. The "
            "trap is the normal acceleration, which is there even at a constant rate and points to the axis."
        )


# --- kinetics --------------------------------------------------------------------------------------------------------


def _why_kinetics(uses: Uses) -> Iterator[str]:
    if uses.forces and uses.at_balance:
        yield "Each body is drawn alone, with all forces that act on it; at rest they balance, and so do their moments."
    elif uses.forces and not uses.inertial:
        yield (
            f"Each body is drawn alone{WELDED if uses.welded else ''}, with all forces that act on it on the left and "
            "what they amount to on the right. "
            "The trap is to draw mass times acceleration among the forces: it is what they come to, and no force."
        )
    if uses.inertial and not uses.at_balance:
        yield "Inertial forces are drawn against the accelerations; with them each body is in equilibrium."
    if uses.streams:
        yield (
            "A stream presses with the mass that arrives in a second times the change of its velocity. The trap is "
            "that mass: what counts is the velocity of the stream relative to what it meets."
        )
    if uses.singles:
        yield "An equation for the whole, into which no reaction comes, leads straight to the accelerations."


def _moments(uses: Uses) -> Iterator[str]:
    if uses.at_balance and uses.moments:
        yield BALANCED.format(_listed([m.about for m in uses.moments]))
        return
    for kind, words in (
        ("pivot", PIVOT),
        ("", ANYWHERE),
        ("centre", CENTRE),
    ):
        points = [m.about for m in uses.moments if m.kind == kind]
        if points and not uses.inertial:
            yield words.format(_listed(points))


BALANCED = "Moments about {}: what passes through that point has no arm and does not enter."
PIVOT = (
    "Moments about the fixed point {}: the reactions there drop out, and on the right stands the moment "
    "of inertia about "
    "that point. The trap is to count the moment of mass times acceleration once more: it is in that "
    "moment of inertia."
)
ANYWHERE = (
    "Moments about {}, through which unknown forces pass, so that these do not enter. The trap: on the "
    "right mass times "
    "acceleration of the mass centre has a moment about that point too; the angular acceleration alone is not enough."
)
CENTRE = (
    "Moments about the mass centre {}: on the right the angular acceleration stands alone. The trap is to leave out a "
    "reaction: each one enters that does not pass through that point."
)


def _groups(uses: Uses) -> Iterator[str]:
    if uses.groups:
        yield (
            f"{_listed(max(uses.groups, key=len))} are taken together: the forces between them cancel. "
            "The trap is to leave "
            "out on the right what one of them contributes."
        )


def _friction(uses: Uses) -> Iterator[str]:
    if uses.sticking and uses.at_limit:
        yield (
            f"At {_listed(uses.sticking)} nothing slips yet. Only at the limit is friction the coefficient times the "
            "normal force, and it acts against the slip that is about to begin."
        )
    elif uses.sticking:
        yield (
            f"At {_listed(uses.sticking)} nothing slips: the friction is what the equations demand, and "
            "is compared with "
            "its limit afterwards. The trap is to take it for the coefficient times the normal force at once."
        )
    if uses.slipping:
        yield (
            f"At {_listed(uses.slipping)} the surfaces slip: the friction is the coefficient times the "
            "normal force, and "
            "acts on each body against its sliding over the other. The trap is the normal force: it is "
            "seldom the weight."
        )


def _solving(uses: Uses) -> Iterator[str]:
    if uses.together > 1:
        yield (
            "As many equations as unknowns. Where several hang together, all but one are put in terms "
            "of that one; the "
            "numbers come last, as a formula can be tested by its units and by simple cases."
        )
    else:
        yield "The equations are taken one at a time: each is solved for one unknown that none before it has told."


# --- motions ---------------------------------------------------------------------------------------------------------


def _energies(uses: Uses) -> Iterator[str]:
    if not uses.energies:
        return
    states = f"{uses.energies[0].since} and {uses.energies[0].stop}"
    brought = [words for b in uses.energies for words, _ in b.brought]
    trap = ""
    if uses.turning_energy:
        trap = " The trap is to forget the kinetic energy of a rotation."
    elif any("weight" in words for words in brought):
        trap = " The trap is to take the way along the path for the difference of the heights."
    yield (
        f"Between {states} neither time nor acceleration is needed: work and kinetic energy. Forces at points at rest "
        f"and forces across the motion do no work.{trap}"
    )
    if any("spring" in words for words in brought):
        yield (
            "The work of a spring is that of its stretch squared at both ends. The trap is to square the difference."
        )


def _momenta(uses: Uses) -> Iterator[str]:
    if uses.momenta:
        kept = any(b.gain == 0 for b in uses.momenta)
        yield (
            "Momentum is taken of bodies, along a direction or about a point, where no unknown force has an impulse"
            + (": there it stays as it is." if kept else ".")
            + " The trap is to conclude that the kinetic energy stays too."
        )


def _blows(uses: Uses) -> Iterator[str]:
    if uses.blows:
        yield (
            "A blow is so short that nothing changes its place meanwhile, and that weights and springs "
            "have no impulse worth "
            "naming; the reactions of supports have. The trap is to use the energy across it: a blow "
            "takes some of it away."
        )
    if uses.restitution:
        yield (
            "The restitution compares velocities along the common normal only, of the points that "
            "touch. The trap is to "
            "take those of the mass centres."
        )


LAWS = {
    "v(t)": "The acceleration depends on the time: its integral over time is the change of speed.",
    "q(t)": "The speed is known as a function of time: its integral is the way.",
    "v(q)": "The time is not asked: over the way the acceleration changes the square of the speed.",
    "t(v)": (
        "The acceleration depends on the speed: the speed and its share of the law go to one side, time to the other."
    ),
    "q(v)": (
        "The acceleration depends on the speed, and the time is not asked: the way is an integral over the speed."
    ),
    "t(q)": "The speed depends on the place: the time is the integral of the way divided by the speed.",
}


def _laws(uses: Uses) -> Iterator[str]:
    if "constant" in uses.laws:
        yield (
            "The acceleration is constant: of time, speed and place two relations tell the third. "
            "The trap is to use them beyond the states between which it is."
        )
    if RELATIVE in uses.laws:
        yield (
            "Both have the same acceleration: seen from one of them the other moves straight and at constant speed. "
            "The trap is to write down both ways, which nobody asks."
        )
    told = [words for kind, words in LAWS.items() if kind in uses.laws]
    if told:
        yield " ".join(told) + " The trap is the limits: both integrals go from the same state to the same state."
    if uses.integrated:
        yield (
            "No formula gives the motion; it is followed in small steps from the start, each with the acceleration of "
            "its own place. The trap is to take the acceleration of the start for all the way."
        )
    if uses.extreme:
        yield (
            "Where something is largest or smallest its derivative is zero. The trap is to put the numbers in before "
            "differentiating, and to forget the ends, where it may be larger still."
        )


def _swings(uses: Uses) -> Iterator[str]:
    if uses.swings:
        yield (
            "Near an equilibrium only the linear part of the force counts; its factor and the inertia "
            "give the frequency. "
            "The trap is to count the coordinate from elsewhere: the weight drops out only if it counts "
            "from equilibrium."
        )


LESSONS = (
    *(Lesson((KINEMATICS,), f) for f in (_why_kinematics, _passages, _axles, _rolling, _sliding, _component, _cords)),
    *(Lesson((KINETICS, EQUILIBRIUM), f) for f in (_why_kinetics, _moments, _groups, _friction)),
    Lesson((SOLVING,), _solving),
    *(Lesson((), f) for f in (_energies, _momenta, _blows, _laws, _swings)),
)
"""In the order in which they are told under one heading."""
