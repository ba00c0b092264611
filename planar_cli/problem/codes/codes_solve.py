"""What each diagnosis of a scene means, for `planar explain PL604`."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

_SOLVE = {
    "PL513": (
        "The place of a point is described by two facts that no point satisfies: the circles about the named "
        "points do not meet, or the line passes too far away. Check the distances; a link cannot be shorter "
        "than the gap it spans."
    ),
    "PL601": (
        "Every assumption about contacts and ropes (stick or slip, apart, taut or slack) leads to something "
        "that contradicts it: a contact that would have to pull, a slip against the friction that causes it. "
        "Rigid bodies with dry friction may have no consistent solution at all; a rod that is pushed over a "
        "very rough floor jams (the paradox of Painlevé). The message lists each assumption with what speaks "
        "against it."
    ),
    "PL602": (
        "Equations contradict each other: together they say that zero is not zero. The message names the "
        "relations of the file, the joints and the bodies whose equations take part. Leave one out, or let "
        "one of its values be unknown."
    ),
    "PL603": (
        "More supports than equations: the motion is determined, but some reactions can change together "
        "without changing it, such as the three vertical reactions of a beam on three supports. The message "
        "says which can, and which reactions (or directions of them) are unique all the same. Ask for these, "
        "or leave a support out."
    ),
    "PL604": (
        "Nothing in the file says how fast the mechanism moves at this instant. Give one of the velocities "
        "that the message lists (they depend on each other, so that one is enough for each datum missing), or "
        "say `at rest`."
    ),
    "PL605": (
        "The velocities are known, but the accelerations are not determined: no motion is prescribed, and "
        "what moves has no mass. `omega(b) = 2 rad/s` under `instant` says nothing about its rate; under "
        "`motion` it is constant. Give an acceleration, or masses and forces."
    ),
    "PL606": (
        "A constant declared under `unknowns` is not determined by the equations: a force without the "
        "acceleration that it causes, a coefficient of friction without a contact that is at its limit. One "
        "more datum is needed. A largest or smallest value is asked for with `mu is smallest` and `mode(C) = "
        "stick`."
    ),
    "PL607": (
        "Two given velocities contradict each other: the joints make one of them follow from the others, and "
        "it comes out different. The message says how large it would have to be. Leave one out."
    ),
    "PL608": (
        "A given acceleration or force contradicts the equations of motion: it follows from them, and comes "
        "out different. Leave it out, or declare what causes it (a load, a torque) under `unknowns`."
    ),
    "PL609": (
        "A relation about places does not hold as drawn. Points are given as drawn at the instant; a relation "
        "cannot move them. Correct one of the two, or write the points with a coordinate and give or seek its "
        "value."
    ),
    "PL610": (
        "Dead centre: the given speed does not depend, in this very position, on how fast the other parts "
        "turn, although it does next to it. A crank cannot be driven by its slider there: 0 · omega = v. Give "
        "the speed of the crank."
    ),
    "PL611": (
        "Change point: in this position the equations of the joints depend on each other, although they do "
        "not next to it, and the linkage can go on in several ways: a parallelogram stretched along its base "
        "leaves as a parallelogram or crossed. Draw the position just before or after it."
    ),
    "PL612": (
        "Several assumptions about contacts and ropes are consistent, and they lead to different motions; "
        "rigid bodies with dry friction may leave that open. The message describes each. Say which one is "
        "meant with `mode(C) = slip`."
    ),
    "PL613": (
        "What is to be largest or smallest has no extreme value: no assumption of a contact, rope or guide "
        "reaches its limit, however far it is taken. State what must not be lost, such as `mode(C) = stick`. Or the "
        "other relations fix it already, so that there is nothing to choose."
    ),
    "PL614": (
        "The answer depends on a mass or a moment of inertia that the file does not give: `mass: any` is for "
        "masses that cancel, and a body of `points:` has no shape from which its moment of inertia could "
        "follow."
    ),
    "PL615": (
        "A link, rod or rope does not have the length that the file gives it: the drawn distance of its ends "
        "is another one. Correct one of the two, or leave the length out."
    ),
    "PL616": (
        "A relation between numbers that are known already does not hold. The message gives the values of "
        "both sides. Correct one of them, or let one of them be sought under `unknowns`."
    ),
    "PL617": (
        "An inequality of the file rejects every outcome: all that the joints and loads allow makes it false. "
        "The message gives the values of both sides."
    ),
    "PL618": (
        "What is given holds both ways, as a speed without its direction does, and the answers differ. The "
        "message gives them, and the relation that would choose, such as `v(B).x > 0`."
    ),
    "PL625": (
        "A body is rigid: two of its points keep their distance. Places written with a coordinate always hold: "
        "where one point moves so and the other is written as fixed, write the second from the first, with the "
        "length of the body, or let it have a coordinate of its own, which the body then ties to the first."
    ),
    "PL619": (
        "The data of a blow make a coefficient of restitution that is not between 0 and 1: bodies would part faster "
        "than they approached, or pass through each other. Correct the speeds or the masses."
    ),
}

CODES_SOLVE: Mapping[str, str] = MappingProxyType(_SOLVE)
