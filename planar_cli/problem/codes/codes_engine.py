"""What each diagnosis of a motion that is followed in numbers means, for `planar explain PL701`."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

_ENGINE = {
    "PL700": (
        "At this moment no choice of modes (stick, slip, apart, tip, taut, slack) goes on without contradiction, or "
        "no impulses fulfil the laws of an impact. Rigid bodies with large dry friction can jam so: a rod pushed "
        "along a floor against its slant (Painlevé). Real bodies yield a little. Make the coefficient of friction "
        "smaller, or let a spring take the load."
    ),
    "PL701": (
        "At this moment more than one motion is consistent with rigid bodies and dry friction, or an impact with "
        "friction has several outcomes; nothing in the file chooses one. It happens only with friction. Make the "
        "coefficient smaller, or begin from another state."
    ),
    "PL702": (
        "At this place the equations of motion do not determine the accelerations: a singular position, in which a "
        "mechanism may go on in several ways, or a body without mass that nothing holds. Begin beside it, or give "
        "the body a mass."
    ),
    "PL703": (
        "The steps of the integration became too small to make progress, or too many. A force grows without bound, "
        "a mass vanishes, or the scene is stiff beyond the method that was chosen: leave `--integrator` out."
    ),
    "PL704": (
        "A motion is followed from a state in which all places and velocities are known. Say in the first state "
        "what is missing: `at rest`, or the velocities of the bodies that are free to move. It is followed from there "
        "on."
    ),
    "PL705": (
        "A motion is followed in numbers, so that every letter needs one: move it from `symbols` or `unknowns` to "
        "`given`."
    ),
    "PL706": (
        "Bodies strike each other, and what follows is open, because the impact has no coefficient of restitution, or "
        "because bodies that have parted meet again and no impact is there. Write `restitution: 0.5`."
    ),
    "PL707": (
        "How far these two bodies are apart cannot be followed over time: their outlines can meet in ways that are "
        "not told apart: let one of them be a particle, a disk or a surface. Or a track is written with a coordinate "
        "and turns, though no body carries it: let it belong to a body."
    ),
    "PL708": (
        "Joints or drives that act from this moment on demand velocities that contradict each other. Let only one "
        "of them act, with `during`, or change what the file prescribes."
    ),
    "PL709": (
        "Impacts or changes of mode follow each other without end at one moment. Contacts whose restitution is 1 "
        "between bodies that are pressed together do that; give them a smaller one."
    ),
    "PL710": (
        "Energy or momentum does not add up over a part of the motion or in an impact, much more than the tolerance "
        "explains: what was computed is not shown. Ask for a smaller `--tolerance`; if that does not help, it is a "
        "fault of the program: please report it with the file."
    ),
    "PL711": (
        "An option of the command line can not be read, or names something that the scene does not have: a time is "
        "written `10 s`, a number for a letter `m=2 kg`, a quantity as in `find`, an effect as `planar simulate "
        "--effects` lists it."
    ),
    "PL712": (
        "A body has come to the pulley, or to the point, to which its part of a rope runs: that part has no length and "
        "no direction any more. What follows, a blow or a body drawn over the pulley, the file does not say. End the "
        "motion before it, with `--until` or a last state."
    ),
    "PL713": (
        "Whether something sticks, presses or holds depends on forces that are not unique, because constraints are "
        "redundant: two crates tied to each other share the friction that holds them. Some choice of these forces may "
        "fulfil all conditions; it is not looked for step by step. Leave one of the redundant joints out."
    ),
    "PL714": (
        "A plastic impact, with the restitution 0, leaves its partners without relative velocity along the normal. "
        "What comes then the file must say, where they are drawn beside each other or are points without faces: do "
        "they stay together (`weld: {between: [bullet, block], at: P, during: 1->3}`, from the state before the "
        "impact), or does a contact with a surface keep them apart?"
    ),
    "PL715": (
        "The partners of an impact that acts between two states only meet once more, later, and nothing is said of "
        "that. An `impact` without `during` acts whenever they meet: give the meeting a state, and one `just after` "
        "it. A `contact` keeps them from passing through each other. Or let the last state come before."
    ),
    "PL716": (
        "The size of an acceleration is prescribed for all the time, and with it alone a motion can go on in two ways. "
        "Give its components in `motion`; at one instant, under `instant`, a size and a sense are enough."
    ),
    "PL717": (
        "A joint that begins with a state (`during: 2->3`) would change a velocity at once: a cord that is straight "
        "while its end still moves along it, a floor onto which something falls. That is a blow, and the velocities "
        "before and after it differ: write a state `3: [just after 2]`. A corner between two surfaces is taken as "
        "rounded where one way is left to move; the speed is kept there."
    ),
    "PL718": (
        "A contact, or a wheel that rolls, begins with a state in which its partners do not touch. Let what the state "
        "says be the place where they meet: for a wheel that comes down to a floor at y = 0, the height of its centre "
        "is its radius."
    ),
    "PL719": (
        "The motion begins where a force or an acceleration is infinite, as it is divided by a speed or a length that "
        "is zero: constant power from rest. A motion over time that has a formula is solved all the same; step by "
        "step it is followed from a small speed on: write `v(car).x = 0.001 m/s` in the first state."
    ),
    "PL720": (
        "A motion that was solved is followed once more by independent facts, step by step, and an answer comes out "
        "otherwise: nothing is printed as an answer. The message gives both values, and when. It is a fault of the "
        "program, or the file can be read in two ways: please report it with the file (planar explain checks)."
    ),
    "PL721": (
        "The numbers that were found are put into every equation of the instant, also into those that the solution "
        "does without. One of them is not fulfilled, so nothing is printed as an answer. The message says which: a "
        "relation of the file there, or a part of the drawing, is usually at odds with the rest."
    ),
    "PL722": (
        "An answer is worked out by two roads, and they lead to different values: the scene is put together once more "
        "as a plain multibody system, or the places that the file writes are differentiated beside what the joints "
        "say. Nothing is printed as an answer. Usually the file can be read in two ways: a point that belongs to two "
        "bodies which no joint holds together there is one point of the drawing, and two points as soon as they move."
    ),
    "PL723": (
        "A motion is followed from its first state on, at t = 0 where that gives no time: no other state is at an "
        "earlier one. Often a minus sign slipped in."
    ),
    "PL724": (
        "`x is largest` at t = infinity is asked of the steady vibration, which is left when the start has died away. "
        "It is looked for in numbers; without damping the start never dies away, and at resonance there is no end."
    ),
}

CODES_ENGINE: Mapping[str, str] = MappingProxyType(_ENGINE)
