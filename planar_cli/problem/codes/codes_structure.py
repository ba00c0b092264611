"""What each diagnostic code of structure (PL3xx) and of the checks (PL4xx) means, for `planar explain PL310`."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

_FORM = {
    "PL301": (
        "Here stand names with values, one for each line: `given:` and below it `m: 50 kg`, or `{m: 50 kg, l: 2 m}`."
    ),
    "PL302": (
        "Here stands a list: `[at rest, v(A).x = 2 m/s]`, or lines that begin with `- `. Joints and loads are"
        " lists too."
    ),
    "PL303": "Here stands one word or one line, not a list and not names with values.",
    "PL304": (
        "A name is a letter, then letters, digits and `_`: `m_A`, `theta2`. The name of a state may begin with a digit."
    ),
    "PL305": "A span of states has both ends: `during: 1->2`.",
    "PL307": (
        "Relations are lines of a list, so `omega(CD): 3 rad/s` is written `- omega(CD) = 3 rad/s`. Only "
        "`given`, `find` and the like hold names with values."
    ),
    "PL310": "This key is not one of those that may stand here. The hint says which one was probably meant.",
    "PL311": "A key that must be there is missing.",
    "PL312": (
        "An entry of `joints` or `loads` is one kind with its keys: `- pin: {at: A, between: [ground, AB]}`. "
        "When the keys stand on lines of their own, they are indented below the kind."
    ),
    "PL313": (
        "There is no joint or load of this kind; `planar list` shows those that there are. Weight is never "
        "written: it acts by itself on every body with mass, when `plane: vertical`."
    ),
    "PL314": (
        "Of several keys one is chosen, or a fixed group of them. A contact says `mu` (0 is smooth), or "
        "`mu_s` and `mu_k`, or `friction: 25 N`; a guide has `point` or `body`; a force has `angle`, or "
        "`towards`, or `angle` and `relative_to`."
    ),
    "PL315": "`between` takes two partners (a pin two or more): bodies, surfaces, or `ground`.",
    "PL316": "A table is a list of rows of an instant and a value: `{table: [[0 s, 0 N], [2 s, 50 N]]}`.",
    "PL317": "Only certain words may stand at this key.",
    "PL318": (
        "The path of a rope is a list of stops: a point, `over D`, `under E`, and at an end `T on drum`: "
        "wound on the body drum, leaving it at the rim point T. `planar explain rope` has a drawing."
    ),
    "PL320": "A point has coordinates `[0, 0.2 m]`, or is described from other points; see `planar explain points`.",
    "PL321": "These keys of a point belong to different ways of describing it; see `planar explain points`.",
    "PL322": "Here stand two things in a list: `midpoint: [A, B]`, `rod: [A, B]`, `line: [A, 30 deg]`.",
    "PL323": "A point is fixed by exactly two facts out of x, y, a line, and distances from other points.",
    "PL324": "Where two places fit, `side` says which: left, right, above or below (the other one).",
    "PL325": (
        "A surface is a line, a circle or a curve: `{through: P, angle: 0 deg}`, `{center: O, radius: R}`, "
        "`{y: c*x^2}`, `{r: b*theta}`; beside that it may have `body` and `speed`."
    ),
    "PL330": (
        "A body has exactly one shape: particle, rod, disk, ring, sphere, sector, plate, points (any other "
        "shape) or parts."
    ),
    "PL331": (
        "This key belongs to another shape. A body of any shape with a known mass centre is `points: [A, B], "
        "center: G`; a wheel whose mass centre is not its middle is `disk: O, radius: R, center: G`."
    ),
    "PL332": "The mass is said once, by `mass` or `weight`; so is the inertia, by `inertia` or `radius_of_gyration`.",
    "PL333": (
        "`about` names the point about which `inertia` or `radius_of_gyration` is given; without these it says nothing."
    ),
    "PL340": (
        "`symbols`, `unknowns` and `coordinates` give each name a unit, `1` for a pure number. A value goes "
        "under `given`."
    ),
    "PL341": "The answer of a vector is a pair: `[3 m, 4 m]`.",
    "PL342": "YAML readers differ on what `yes`, `no`, `on` and `off` are. Answers say `true` or `false`.",
    "PL343": "Variants are values of given names: a range `m: {from: 2 kg, to: 5 kg, step: 0.5 kg}`, or a list "
    "`l: [3 m, 4 m]`, under `variants`, or in `given` itself, there a list as `{one_of: [3 m, 4 m]}`. "
    "Each value has a unit of the same kind as the given value: `beta: [20 deg, 25 deg]`.",
    "PL344": "A name in braces in `text` stands for the value of a given name: `{m}` is printed as 2 kg.",
    "PL345": "A homework set lists problem files under `problems`. `planar key` makes its sheets and key, `planar "
    "check --set` grades submissions; its problems are solved one by one. See `planar explain homework`.",
}

_NAMES = {
    "PL401": (
        "This word has a meaning in the language and cannot be a name: t, pi, ground, all, infinity, stick, "
        "slip, at, in, sin, true and the like."
    ),
    "PL402": (
        "All names of a file differ: values, points, surfaces, bodies, and names given to joints and loads. "
        "Only a particle may share the name of its own point. States and finds are apart."
    ),
    "PL403": "The file has no point, surface or body of that name.",
    "PL404": "The finds of the file and of all its cases are answered side by side, so their names differ.",
    "PL405": (
        "The file has no state of that name. States are declared under `states`, in the order in which they happen."
    ),
    "PL410": (
        "A name in a formula is declared under `given` (with a value), `symbols`, `unknowns` or `coordinates`"
        " (with a unit). The velocity of a point A is `v(A)`, not `v_A`."
    ),
    "PL411": (
        "The time t may stand in `motion`, `states` and `find`, in the magnitudes of loads, in streams, in masses "
        "and moments of inertia; everything else is as drawn and does not change."
    ),
    "PL412": "`case.find` names a find of a case that stands earlier in the file.",
    "PL413": (
        "Quantities such as `v(P)` may stand in `motion`, `instant`, `states`, `find`, magnitudes and streams, "
        "places such as `y(P)` also in masses. Given values, points and sizes use names only."
    ),
    "PL420": (
        "Each quantity takes things of its own in its bracket: `v(P)` a point or body, `omega(b)` a body, "
        "`N(j)` a contact or guide, `tension(j)` a rope or link, `force(f)` a load. See `planar explain "
        "quantities`."
    ),
    "PL421": "Some quantities need two things, such as `H(b/P)`, about P; some take only one, such as `mass(b)`.",
    "PL422": (
        "work, impulse, heat, path_length, mean and count are taken over a span, `@ 1->2`; all others at a "
        "state, `@ 2`."
    ),
    "PL423": (
        "Several joints are called by the same point. Give each a `name:` of its own, or say on which body: `N(A/AB)`."
    ),
    "PL424": "Between two moving bodies a force acts on both, in opposite directions: `reaction(B/AB)` is that on AB.",
    "PL425": (
        "This part does not belong to that quantity. Parts .x .y .mag .angle .along(…) .across(…) belong to "
        "vectors, .t and .n to v and a, .r and .theta to r, v and a; angles, N, tension and moments are "
        "numbers."
    ),
    "PL426": (
        "A vector stands where a number is due, or a number beside a vector. Ask for a part: `v(P).x`, `v(P).mag`."
    ),
    "PL427": (
        "A disk or plate may have the name of its centre. `v(P/A)` is then seen either from a frame that moves with "
        "the point A and does not turn, or from the body A: give the body another name."
    ),
    "PL430": (
        "`instant` says what holds at the one instant asked about; `states` names several. A file has one of the two; "
        "a case may have the other one in its place."
    ),
    "PL431": (
        "This statement cannot stand here: `just after` belongs to `states`, `is largest` to `instant` and "
        "`states`, and `motion` holds what is true all the time."
    ),
    "PL432": "stick, slip, apart, tip, taut and slack are compared with a mode: `mode(C) = stick`.",
    "PL433": (
        "Impacts and impulses take no time. They act between two states, `during: 1->2`, of which the second "
        "is `just after` the first. A force that acts for some time is a `force` with `during`. In a file that asks "
        "nothing an impact may leave `during` out: it happens whenever the bodies meet."
    ),
    "PL434": (
        "A span runs from one state to another; what acts `during` it, to a later one; and a mean over it ends at a "
        "state that is reached."
    ),
    "PL435": (
        "In a file with states the time of one of them is `t @ 2`. `@` belongs to the quantity, name or bracket just "
        "before it: `N(C) @ 1/W`, or `(N(C)/W) @ 1`."
    ),
    "PL436": "Something is defined by itself, perhaps through others. Then its value cannot be found.",
    "PL437": "One joint has two modes at the same instant. Keep the one that is meant; another state may have others.",
    "PL438": (
        "A link that begins at a later state joins its ends where they are then: its length is the distance that they "
        "have. A `length` is for a link of the first state, whose ends the drawing leaves open."
    ),
    "PL439": (
        "Both sides of a relation are written alike: as an equation it is always true and tells nothing. Perhaps one "
        "of them was meant to name another point, body or state."
    ),
}

_PHYSICS = {
    "PL450": (
        "Where a body has mass and weight may have a part, the file says `plane: vertical` (weight acts, -y) or "
        "`plane: horizontal` (seen from above). Places, a motion that is told as such, and "
        "moments of inertia need none."
    ),
    "PL451": (
        "A particle without mass cannot be moved by forces. Give it a mass (`mass: any` where it cancels), or"
        " say in `motion` how it moves, or in every state which velocity it has."
    ),
    "PL452": "Coefficients of friction are not negative, and the kinetic one is not larger than the static one.",
    "PL453": "The coefficient of restitution lies between 0 (they stay together) and 1 (no energy is lost).",
    "PL454": (
        "A size, a mass or a stiffness is more than zero. Only a part of a composite body, a hole, may have minus "
        "mass. A natural length may be zero, and g is a size: weights act downward by themselves."
    ),
    "PL455": "A joint is between two different things, of which at least one can move, and of shapes that fit it.",
    "PL456": "`flat` is a body lying on another in a horizontal plane, seen from above.",
    "PL457": (
        "One rope has one tension: it slides over the pulleys that it passes `over` or `under`. A pulley with mass "
        "that turns with the rope has two ropes wound on it; one that is smooth has `inertia: 0`."
    ),
    "PL458": (
        "A rope, a link, a spring or a damper holds a body by one of its points. A point that only stands where a "
        "corner of a plate is, or a rim, belongs to no body: name it under `points` of that body."
    ),
    "PL459": (
        "An unknown is declared, and nothing uses it: no body, joint, load or find, and no relation that has more in "
        "it than numbers. Say what it is, such as `x(P) = s`, ask for it under `find`, or leave it out."
    ),
    "PL460": "Every name under `answers` is that of a find, of the file or of one of its cases.",
    "PL461": (
        "The answer is of another kind than what is asked: number, vector `[x, y]`, `true` or `false`, or a mode word."
    ),
    "PL462": (
        "A tolerance is a part of the value, a pure number between 0 and 1: `tolerance: 0.01` lets an answer be one "
        "per cent off."
    ),
    "PL463": (
        "A joint, a spring or a damper holds bodies, or points that are fixed. A point that is written with a "
        "coordinate and belongs to no body would move without anything that moves it: put a particle there, or name "
        "it under `points` of its body."
    ),
    "PL464": (
        "A mass that is written with places, `mass: rho*y(end)`, changes as the body moves: matter comes to it or goes "
        "from it, with a velocity that a `stream` tells. What is left behind leaves with `speed: 0 m/s`."
    ),
    "PL465": (
        "A particle has one place, at which everything acts on it. A force on it `at` a point of another body is meant "
        "for that body, or for another particle; a pin holds it where it is."
    ),
    "PL466": "A particle has no size and no angle, so that no moment turns it. Name the body that turns.",
    "PL467": (
        "A point of two bodies is one point as long as a joint holds them together there. Of bodies that turn about "
        "a pin elsewhere, or of which a pin holds only some, it is two points as soon as they move: name a second "
        "one at the same place."
    ),
    "PL468": (
        "A mass that is written with the time changes while its stream flows. Before and after that it stays what it "
        "is in the state in which the stream begins or ends, so that this state has a time, `[t = 20 s]`."
    ),
}

CODES_STRUCTURE: Mapping[str, str] = MappingProxyType({**_FORM, **_NAMES, **_PHYSICS})
