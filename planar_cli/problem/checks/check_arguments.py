"""What each quantity takes in its bracket: points, bodies, joints, loads, states; and with a span or at an instant."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from planar_cli.errors import Diagnostic
from planar_cli.joints.base import Joint
from planar_cli.problem.checks.check_names import missing_state
from planar_cli.problem.checks.scope import Member, Scope
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.nodes.reading import did_you_mean, listed
from planar_cli.problem.scene.scene import ALL, GROUND, Composite, Particle
from planar_cli.records import record
from planar_cli.registry import members

SPANNED = frozenset("work impulse heat path_length mean count".split())
STATED = frozenset("reached period frequency stable".split())


FRAMED = frozenset("x y r v a rho path".split())
"""Quantities that are seen from a point or from a body."""

RELATIVE = frozenset("x y r v a theta omega alpha coriolis rho path path_length IC".split())
"""What is asked of one thing as seen from another."""

OWN = "own"
"""Stands for the kinds of joints and loads among whose `quantities` a word is."""


@record
class Takes:
    """`first`, `second`: what may stand there, of point, body, all, ground, and joints and loads (`joint`, `load` for
    every kind; OWN for those that answer to the word). No `second`: only one thing. `both`: the second must be there.
    """

    first: str
    second: str = ""
    both: bool = False


POINT_WORDS = dict.fromkeys("x y r v a".split(), Takes("point body all", "point body ground"))
BODY_WORDS = dict.fromkeys("theta omega alpha".split(), Takes("body", "body ground"))
TAKES: dict[str, Takes] = {
    **POINT_WORDS,
    **BODY_WORDS,
    "coriolis": Takes("point body", "body", both=True),
    "rho": Takes("point body", "point body"),
    "IC": Takes("body", "body"),
    "path": Takes("point body", "point body"),
    "hodograph": Takes("point body"),
    "N": Takes(OWN, "body"),
    "friction": Takes(OWN, "body"),
    "reaction": Takes("joint load", "body"),
    "moment": Takes("joint load", "body"),
    "tension": Takes(OWN, "body"),
    "force": Takes("load", "body"),
    "mode": Takes(OWN, "body"),
    "mass": Takes("body all"),
    "I": Takes("body all", "point body"),
    "KE": Takes("body all"),
    "PE": Takes("body all spring"),
    "momentum": Takes("body all"),
    "H": Takes("body all", "point body", both=True),
    "power": Takes("load joint body all", "body"),
    "work": Takes("load joint body all", "body"),
    "impulse": Takes("load joint body all", "point body"),
    "heat": Takes("joint all"),
    "path_length": Takes("point body", "point body"),
}


def answering(word: str) -> list[str]:
    """The kinds of joints, then of loads, of which a quantity may be asked that not all of them have."""
    kinds: list[tuple[str, Any]] = [*members("joints").items(), *members("loads").items()]
    return [kind for kind, member in kinds if word in member.quantities]


def arguments(quantity: Quantity, scope: Scope) -> Iterator[Diagnostic]:
    """What is wrong with the bracket and the instant of one quantity."""
    yield from _instant(quantity)
    if quantity.word in STATED:
        for name in quantity.things:
            yield from missing_state(name, scope, quantity.mark)
        return
    takes = TAKES.get(quantity.word)
    if takes is None or not quantity.things:
        return
    if quantity.word in BODY_WORDS:
        yield from _turning(quantity, scope)
    if quantity.word in (*POINT_WORDS, "I") and quantity.things[0] == ALL:
        yield from _mass_centre(quantity, scope)
    yield from _thing(quantity, 0, takes.first, scope)
    if len(quantity.things) > 1:
        yield from _second(quantity, takes, scope)
        yield from _seen_from(quantity, scope)
    elif takes.both:
        example = {"coriolis": "coriolis(P/b)", "H": "H(b/P)"}[quantity.word]
        message = f"{quantity.word}({quantity.things[0]}) leaves open about or against what"
        yield Diagnostic(quantity.mark, "PL421", message, f"write `{example}`")


def _turning(quantity: Quantity, scope: Scope) -> Iterator[Diagnostic]:
    """A particle has no angle of its own, so that nothing can be said of how it turns."""
    for name in quantity.things:
        if name in scope.bodies and isinstance(scope.bodies[name].shape, Particle):
            text = f"{name} is a particle: it has no angle, so `{quantity.word}({name})` says nothing"
            hint = f"name a body that turns, or write `r({name}).angle` for the direction in which {name} lies"
            yield Diagnostic(quantity.mark, "PL420", text, hint)


def _mass_centre(quantity: Quantity, scope: Scope) -> Iterator[Diagnostic]:
    """The whole system is where its mass centre is."""
    if all(b.is_massless and not isinstance(b.shape, Composite) for b in scope.problem.bodies):
        text = f"no body has mass, so that `{quantity.word}(all)` says nothing: the whole has no mass centre"
        yield Diagnostic(quantity.mark, "PL420", text, "name a point or a body, or give masses")


def _second(quantity: Quantity, takes: Takes, scope: Scope) -> Iterator[Diagnostic]:
    if not takes.second:
        hint = f"write `{quantity.word}({quantity.things[0]})`"
        yield Diagnostic(quantity.mark, "PL421", f"{quantity.word}(…) takes one thing, not two", hint)
        return
    yield from _thing(quantity, 1, takes.second, scope)
    one, other = quantity.things
    if one == other and quantity.word in RELATIVE:
        message = f"{quantity.word}({one}/{other}) is always zero: {one} as seen from itself"
        hint = f"name what moves against {one}, or write `{quantity.word}({one})`"
        yield Diagnostic(quantity.mark, "PL421", message, hint)
    if quantity.word == "impulse" and one in scope.bodies and one not in scope.members and other in scope.bodies:
        yield from _of_two_bodies(quantity, scope)


def _of_two_bodies(quantity: Quantity, scope: Scope) -> Iterator[Diagnostic]:
    """`impulse(ledge/bar)`: what one body does to the other is that of their joint."""
    one, other = quantity.things
    between = [m for named in scope.members.values() for m in named if {one, other} <= set(scope.partners(m))]
    if not between and other in scope.points:
        return  # about the place of a particle
    hint = f"write `impulse({one})` for that of all forces on {one}, or a point about which it is taken"
    if between:
        joint = between[0]
        alone = len(scope.members[joint.name]) == 1
        name = joint.name if alone else f"{joint.kind}_1"
        hint = f"the impulse of the {joint.kind} between them on {other} is `impulse({name}/{other})`"
        hint += "" if alone else f", with `name: {name}` at the {joint.kind}"
    yield Diagnostic(quantity.mark, "PL421", f"impulse({one}/{other}) names two bodies", hint)


def _instant(quantity: Quantity) -> Iterator[Diagnostic]:
    """A span where one is due, an instant where one is due."""
    word, at = quantity.word, quantity.at
    if word in SPANNED and not isinstance(at, tuple):
        yield Diagnostic(
            quantity.mark, "PL422", f"{word}(…) is taken over a span of states", f"write `{word}(…) @ 1->2`"
        )
    if word not in SPANNED and isinstance(at, tuple):
        hint = f"write `{word}(…) @ {at[1]}`, or `mean({word}(…)) @ {at[0]}->{at[1]}`"
        yield Diagnostic(quantity.mark, "PL422", f"{word}(…) is taken at one state, not over a span", hint)
    if word in STATED and isinstance(at, str):
        yield Diagnostic(quantity.mark, "PL422", f"{word}(…) names its state in the bracket", f"write `{word}({at})`")


def _thing(quantity: Quantity, index: int, allowed: str, scope: Scope) -> Iterator[Diagnostic]:
    name = quantity.things[index]
    if allowed == OWN and (own := [m for m in scope.members.get(name, ()) if quantity.word in m.quantities]):
        yield from _ambiguous(quantity, own, scope)
        return
    # Only who errs is told all kinds.
    kinds = answering(quantity.word) if allowed == OWN else allowed.split()
    if not name or _is_plain_thing(name, kinds, scope):
        return
    meant = [m for m in scope.members.get(name, ()) if _fits(m, kinds)]
    if meant:
        yield from _ambiguous(quantity, meant, scope)
        return
    yield Diagnostic(quantity.mark, "PL420", _no_fit(quantity, name, kinds), _hint(quantity, name, kinds, scope))


def _is_plain_thing(name: str, kinds: list[str], scope: Scope) -> bool:
    return (
        ("point" in kinds and name in scope.points)
        or ("body" in kinds and name in scope.bodies)
        or (ALL in kinds and name == ALL)
        or ("ground" in kinds and name == GROUND)
    )


def _fits(member: Member, kinds: list[str]) -> bool:
    shelf = "joint" if isinstance(member, Joint) else "load"
    return shelf in kinds or member.kind in kinds


def _ambiguous(quantity: Quantity, members: list[Member], scope: Scope) -> Iterator[Diagnostic]:
    """Several joints of one name must be told apart by the body; forces between moving bodies name theirs."""
    joints = members
    if len(quantity.things) > 1:
        joints = [m for m in members if quantity.things[1] in scope.partners(m) or not scope.partners(m)] or members
    elif len(members) > 1:
        joints = [m for m in members if GROUND in scope.partners(m)] or members
    name = quantity.things[0]
    if len(joints) > 1:
        lines = listed(f"line {m.mark.line} ({m.kind})" for m in joints)
        message = f"{quantity.word}({name}) may mean those of {lines}"
        yield Diagnostic(quantity.mark, "PL423", message.replace(" or ", " and "), "give each a `name:` and use it")
        return
    yield from _on_whom(quantity, joints[0], scope)


def _seen_from(quantity: Quantity, scope: Scope) -> Iterator[Diagnostic]:
    """`v(P/A)` is seen from the point A or from the body A: not the same where both are called A and the body turns."""
    if quantity.word not in FRAMED or len(quantity.things) < 2:
        return
    name = quantity.things[1]
    body = scope.bodies.get(name)
    if body is None or isinstance(body.shape, Particle) or name not in scope.points:
        return
    message = f"{quantity.word}({quantity.things[0]}/{name}) is seen from the point {name} or from the body {name}"
    yield Diagnostic(quantity.mark, "PL427", message, f"give the body another name than that of its point {name}")


def _on_whom(quantity: Quantity, joint: Member, scope: Scope) -> Iterator[Diagnostic]:
    """Between two moving bodies a vector must say on which it acts."""
    partners = scope.partners(joint)
    if len(quantity.things) > 1 or not isinstance(joint, Joint):
        return
    name = quantity.things[0]
    body = scope.bodies.get(name) if name in partners else None
    of_body = body is not None and (isinstance(body.shape, Particle) or name not in scope.points)
    if of_body and quantity.word != "impulse":
        return  # called by one of its bodies, the joint tells what it does to that one
    if quantity.word in ("reaction", "friction", "moment", "impulse") and len(partners) > 1 and GROUND not in partners:
        message = f"{quantity.word}({name}) leaves open on which body: {listed(partners)}"
        yield Diagnostic(
            quantity.mark, "PL424", message, f"write `{quantity.word}({name}/{partners[0]})` for that on {partners[0]}"
        )


def _no_fit(quantity: Quantity, name: str, kinds: list[str]) -> str:
    words = {"all": "the whole system `all`", "impact": "an impact"}
    wanted = listed(words.get(kind, f"a {kind}") for kind in kinds if kind != "ground")
    return f"{quantity.word}(…) takes {wanted}; '{name}' is none"


def _hint(quantity: Quantity, name: str, kinds: list[str], scope: Scope) -> str:
    if "body" in kinds and "point" not in kinds and name in scope.points:
        return f"'{name}' is a point; name its body"
    if name in scope.members:
        member = scope.members[name][0]
        other = "it has no modes" if quantity.word == "mode" else _alternative(member, name)
        return f"'{name}' is a {member.kind}; {other}"
    return did_you_mean(name, sorted(_known(kinds, scope)), "there are ") or "the file has none"


def _known(kinds: list[str], scope: Scope) -> set[str]:
    """All names of things of these kinds."""
    known: set[str] = set()
    if "point" in kinds:
        known |= set(scope.points)
    if "body" in kinds:
        known |= set(scope.bodies)
    return known | {n for n, named in scope.members.items() if n and any(_fits(m, kinds) for m in named)}


def _alternative(member: Member, name: str) -> str:
    if "N" in member.quantities:
        return f"its forces are `N({name})` and `friction({name})`"
    if "tension" in member.quantities:
        return f"its force is `tension({name})`"
    return f"its force is `{'reaction' if isinstance(member, Joint) else 'force'}({name})`"
