"""What the codes PL501 to PL571 mean: a formula, a place, a contact or a quantity that the scene can not give."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

_FORMULAS = {
    "PL501": "A quantity such as v(B) stands where only numbers and names of `given` can: in `given`, points or sizes. "
    "Write its value, or state the relation in `instant` or `motion`.",
    "PL502": (
        "mode(C) is a word (stick, slip, apart, tip, taut, slack), no number. Compare it: `mode(C) = stick`, "
        "or ask it alone in `find`."
    ),
    "PL503": "`@ state` stands in a relation that is at its own instant. Leave it out; it belongs into `find`.",
    "PL504": (
        "A name has no value here. Give it in `given`, keep it as a letter in `symbols`, or seek it in `unknowns`."
    ),
    "PL505": "A formula divides by zero.",
    "PL506": "An exponent varies with time; only constant exponents can be differentiated.",
}

_PLACES = {
    "PL510": "`towards` a point that is the same place gives no direction.",
    "PL511": "A point by conditions needs just two facts of x, y, line and distances; each distance is one fact. "
    "Example: `B: {y: 0, distances: {A: l}, side: right}`.",
    "PL512": "The two lines that should meet in the point are parallel.",
    "PL514": (
        "A line and a circle, or two circles, meet twice. Say which place is meant: `side: left`, right, "
        "above or below, that is left, right, above or below the other place."
    ),
    "PL515": "Both places are equally far along the named side. Choose by the other axis.",
    "PL530": "The name is no point with a place.",
    "PL531": "The place of a point is given through itself, by way of others.",
    "PL532": "No numbers were found for the letters that satisfy `assume`, or with which every length is real.",
    "PL533": "A name of `given` is given through itself.",
}

_SCENE = {
    "PL520": (
        "The parts of a composite body have no mass: give each part its `mass:`; a hole has minus mass. Or a body "
        "whose mass varies has none at t = 0, where its moment of inertia is given: write `radius_of_gyration`; or "
        "none where it is drawn: a chain that is lifted begins with a short piece."
    ),
    "PL521": (
        "The point of contact is not on the surface. Let the line go through the point, or the circle have "
        "its distance as radius. What meets only later is joined from then on: `during: 2->3`, where state 2 is the "
        "one in which they meet. Where a curve comes to a point (a cusp) it has no direction, and nothing can touch it."
    ),
    "PL522": (
        "The point of contact is not on the rim or edge of the body: its distance from the centre is neither "
        "the radius nor the hub, or it is inside the rectangle. So must a cord leave a drum at a rim, at right angles "
        "to the radius there."
    ),
    "PL523": (
        "A corner can not roll, nor a body without a radius. Rolling needs a round rim on a rim, a rack or a surface."
    ),
    "PL524": "The point of a guide belongs to no body that could slide. Name it among the points of its body.",
    "PL525": "A rope can not end over or under a pulley; it ends at a point, or wound: `T on drum`.",
    "PL526": (
        "The stops before and after a pulley lie one above the other, so that `over` and `under` mean "
        "nothing. Move them, or write `along: 90 deg`."
    ),
    "PL529": (
        "An impact acts only between bodies that touch. Here the places of the state hold them apart: those to which a "
        "motion has led, those that the state gives, or those in which two bodies of given size are drawn. Put a state "
        "before it in which they meet, or correct the places. A particle may be drawn beside what it strikes."
    ),
    "PL528": (
        "Where two bodies strike each other, or in which direction, is open. A particle, a round rim, the end of a rod "
        "or the corner of a plate must meet the other body; where two particles are at one place, or two corners meet, "
        "write `normal: 0 deg`, the direction of the common normal."
    ),
    "PL536": (
        "The shapes tell where two bodies strike each other, and often the direction of the common normal: along the "
        "radius of a rim, across an edge. What the impact says of them, `at` and `normal`, must be the same."
    ),
    "PL527": "Two corners touch: the direction of the contact is open. One side needs a rim, an edge or a surface.",
    "PL534": (
        "A rim that touches something has its tangent there. Where the two cross, either the point does not lie where "
        "the radius is at right angles to the surface, or the surface has another direction."
    ),
    "PL535": (
        "A contact or rolling on the `ground` is on a horizontal floor, of a body that stands on it: a wheel, a "
        "particle, a plate, a rod with one end, or what touches it with the point `at`. Anything else needs a surface "
        "of its own: `surfaces: {wall: {through: B, angle: 90 deg}}`. A rod of which both ends are on a line, or none, "
        "needs `at`."
    ),
    "PL537": (
        "A pin or weld to the ground with `during` from a later state holds the point of the body that is drawn at its "
        "place. Where the body, drawn as it is at the first state, has nothing there, a place was meant to which it "
        "comes: which of its points is there by then must be told. Begin with the state in which it takes hold, or "
        "name the point that is caught among the `points` of the body."
    ),
    "PL538": (
        "A body that is drawn by points alone (`points: [A, B]`) has no line of its own; as drawn its angle is zero, "
        "as is that of a slot in it. Draw a bar as `rod: [A, B]`, or fix a line to the body: `surfaces: {slot: "
        "{through: A, angle: 30 deg, body: b}}`."
    ),
    "PL539": (
        "`along` of a rope says that all its parts are parallel to one direction. A part that is drawn across it, such "
        "as one over a table, would not count in the length of the rope: leave `along` out, and draw the pulleys. Nor "
        "may the ends of a part move aside from each other: a load that lags behind its trolley hangs aslant."
    ),
    "PL540": "The direction of a force is missing. Write `angle: 30 deg` or `towards: P`.",
    "PL541": (
        "The ends of a spring, damper, link or part of a rope, or the centres of the disks of a belt, are at the same "
        "place: its pull has no direction."
    ),
    "PL542": (
        "A relaxed position is given by values of the coordinates, `relaxed_at: [theta = 30 deg]`, by the angles of "
        "bodies on a pin of the ground, `relaxed_at: [theta(b) = 30 deg]`, by the places of particles at the ends, "
        "`relaxed_at: [x(P) = 2 m]`, or by the distance of the ends; each end of the spring must follow from it."
    ),
    "PL543": "`speed:` makes a belt that runs along a line. For a round surface that moves let a disk turn instead.",
    "PL544": (
        "The moment of inertia about a point A is I_G + m d², where d is the distance of the mass centre from A; the "
        "radius of gyration about A is at least d. Less is that of no body: it may be meant about the mass centre."
    ),
}

_QUANTITIES = {
    "PL550": "The quantity is a vector where a number is needed. Ask for a part: .x .y .mag .angle .along(30 deg).",
    "PL551": "A part such as .x of something that is a number already.",
    "PL552": "At one instant places, velocities and accelerations are known, but not their further rates.",
    "PL553": "The thing named has no rotation.",
    "PL554": "The Coriolis acceleration is seen from a turning body: coriolis(P/b).",
    "PL555": "Forces are not known before the motion is; a relation between velocities can not use them.",
    "PL556": (
        ".t and .n are along and across the velocity; where the speed is zero they mean nothing. On a circle "
        "use .across."
    ),
    "PL557": "N, friction, reaction, moment and tension take the name of what acts then, or up to then.",
    "PL558": "The joint does not act on the body after the slash.",
    "PL559": "The joint or load acts on two moving bodies; say on which its force is meant: reaction(B/AB).",
    "PL560": "In a file with `states` a find says at which state: v(P) @ 2.",
    "PL570": "The method has no equation that leads to what is asked: one that relates two states tells nothing of one "
    "instant, and Lagrange's equations tell no reaction that does no work.",
    "PL571": "The file has no `find`, neither of its own nor in a case: there is nothing to solve for.",
}

CODES_SCENE: Mapping[str, str] = MappingProxyType({**_FORMULAS, **_PLACES, **_SCENE, **_QUANTITIES})
