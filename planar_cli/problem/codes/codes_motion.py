"""What each diagnosis of a motion over time means, for `planar explain PL621`."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

_TIME = {
    "PL590": (
        "Something stands where it has no value. A quantity over a span (work, impulse, heat, path_length, mean, "
        "count) and one about a state (reached, period, frequency, stable) need `states`; a mass, a load or a table "
        "that depends on the time needs an instant with a known time, `t = 2 s`. A place that `motion` gives by the "
        "time has no velocity of its own in a blow: give the velocity instead."
    ),
    "PL591": (
        "A body rocks with an edge or a flat side on a round rim or surface. Its motion at one instant is "
        "solved, but its places are not followed over time. Ask with `instant`, or let the body be round."
    ),
    "PL593": (
        "The magnitude, rate or speed of a load has no real value at this instant: a root or a logarithm of a negative "
        "number, or a division by a speed that is zero."
    ),
    "PL592": "Each instant of a table comes after the one before it: straight lines join the values between them.",
}

_STATES = {
    "PL620": (
        "What the states say can not all be true of one motion: the equations between them have no common solution "
        "in which the states follow each other in the order of the file, the inequalities hold, and every time but "
        "a given one is later than the one before it. Typical causes: a datum too many, states in the wrong order, "
        "an inequality that excludes the only root, a target out of reach. Whether a state occurs at all is asked "
        "with `reached(s)`."
    ),
    "PL621": (
        "The motion was followed from the state before, and the relations of this state never hold: it turns or "
        "comes to rest earlier, or what is to be `largest` grows for ever. Change a datum, or ask `reached(s)`: "
        "that a state does not occur is an answer too. A place that is approached without end is reached at "
        "`t = infinity`."
    ),
    "PL622": (
        "The motion has come to a place from which no assumption about contacts, guides and ropes (stick, slip, "
        "apart, taut, slack) goes on without contradiction. The message says why the first one fails; `planar "
        "explain PL601` tells how that may be. Friction too large for rigid bodies is one cause, a constraint that "
        "jams another."
    ),
    "PL623": (
        "A motion is known when the state from which it starts is: all places and velocities of one instant, and every "
        "constant of `unknowns`. Relations in later states may stand for what the first one leaves out, one for "
        "each. Here some are too few. A state that only says `y(P) < 0` has no instant: it needs a relation with `=`."
    ),
    "PL624": (
        "Two statements about one state can not both be true of this motion: a time and a place, say, that do not "
        "go together. Leave one out; or, if a datum was meant to be found from them, name it under `unknowns`."
    ),
    "PL633": (
        "A quantity over a span, `work(f) @ 1->2`, is an integral from the first state to the second, which must come "
        "later. In a state's own relations it must have a closed form, and the motion may not turn round meanwhile; "
        "put a state where it does."
    ),
    "PL634": (
        "A mass that varies, `mass: M - q*t`, is used up before this state. Either the time is wrong, or what flows "
        "out ends earlier: let the stream act `during: 1->2`, where state 2 has a time, `[t = T]`. From there on the "
        "mass stays what it is then."
    ),
    "PL626": (
        "A blow in which nothing strikes leaves all as it was. Bodies strike from the side on which they are drawn; a "
        "straight line has no end, and may be crossed on the way: an `impact` that acts `during` one later blow alone "
        "strikes it from the side from which the bodies come."
    ),
    "PL627": (
        "What is asked is determined, but no order of equations leads to it. In a blow this happens where a joint "
        "keeps the two bodies from approaching each other along the common normal, so that the impact does nothing: a "
        "ball that slides along a rod does not strike the side of the rod, but its end. Check `at` and `normal`."
    ),
}

_EQUILIBRIA = {
    "PL635": (
        "Something is to be largest (or smallest) over a constant that is sought, and it is so in several ways, each "
        "of them largest among those near it: a throw up a slope, and one down its other side. Give the side "
        "in the state, such as `x(P) > 0`. Or the motion passes all states with several values of what is sought, as "
        "two angles of a throw that lead to one place: `assume: [beta < 45 deg]` chooses."
    ),
    "PL636": (
        "The file gives the static coefficient of friction alone. Whether something slides, and what holds as long as "
        "it does not, follows from it; what moves after it has slid depends on the kinetic coefficient."
    ),
    "PL637": (
        "What is asked is divided by something that is zero at this instant, such as the radius of curvature of the "
        "path of a point that is at rest. Ask for it at another instant, or for another point."
    ),
    "PL638": (
        "Where the derivative of what is to be largest vanishes it is smallest, or the other way round, so that it has "
        "no such value between the limits. Ask for the other, or state the limit itself."
    ),
    "PL639": (
        "A law of `motion` begins in a state in which what it drives has another speed. That changes at once only in "
        "a blow, and what else takes part in it must be told: with an `impulse` of unknown magnitude, say, and a state "
        "`just after` the one before it. What is driven and carries nothing may change its speed so."
    ),
    "PL630": (
        "A state of equilibrium is solved on its own: free speeds and their rates vanish. Either no position does "
        "that, or several do; then say which is meant, by a coordinate or an inequality such as `x > 0`."
    ),
    "PL631": (
        "period(s), frequency(s) and stable(s) are about an equilibrium: a state that says `equilibrium`, in which "
        "something is free to move and the forces do not change with time. Dry friction and `motion` leave nothing "
        "free."
    ),
    "PL632": (
        "Nothing oscillates with one period about this equilibrium: it is unstable, so strongly damped that the "
        "motion creeps back, or has several freedoms, each with a period of its own, which a find by itself lists: "
        "`T: period(s)`. Else ask `stable(s)`."
    ),
}

_FORMULAS = {
    "PL650": (
        "A path or hodograph is one curve only if everything in it depends on one thing: the time, or one coordinate. "
        "Here it depends on several that nothing ties to each other. Say in `motion` how they move, give the start of "
        "the motion in `states`, or ask for the path in a frame in which only one of them varies: `path(B/A)` is seen "
        "from a frame that moves with A, `path(C/b)` from body b. Where the start is given, and no formula solves "
        "the equations of motion, ask for places at `states`."
    ),
    "PL651": (
        "A find without an instant is a formula in the time and the coordinates of the file. This one depends on a "
        "place or velocity that the file neither calls a coordinate nor gives as a function of time. Give the start "
        "of the motion in `states`, write the point with a coordinate, say in `motion` how it moves, or hold by a "
        "joint the body to which it belongs."
    ),
}

CODES_MOTION: Mapping[str, str] = MappingProxyType({**_TIME, **_STATES, **_EQUILIBRIA, **_FORMULAS})
