"""Unknowns in the language of the file, and numbers in its units: the words that a diagnosis is made of."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.kinematics.motion import Edge
from planar_cli.equation.system.setup import first_unit
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import ZERO
from planar_cli.equation.values.ledger import display
from planar_cli.problem.language.dimensions import dimension_of
from planar_cli.problem.language.expression import Name, Number, Quantity, Relation, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.nodes import reading
from planar_cli.problem.scene.facts import Push
from planar_cli.problem.scene.scene import GROUND, Problem
from planar_cli.solve.instant.instant import Instant
from planar_cli.units import Unit, parse_unit

Change = Mapping[sp.Symbol, Decimal]
"""How much each unknown changes along a freedom."""

KINDS = {"normal": "N", "friction": "friction", "tension": "tension", "couple": "moment"}


def listed(words: Iterable[str], last: str = "and") -> str:
    """`a`, `a and b`, `a, b and c`, each once."""
    return reading.listed(dict.fromkeys(words), last)


def named(symbol: sp.Symbol, titles: Mapping[sp.Symbol, str]) -> str:
    """An unknown in words, `the angular velocity of rod just after the blow`; else by its letter alone."""
    title = titles.get(symbol, "")
    if not title:
        return f"`{symbol.name.partition('__')[0]}`"
    blow = " just after"
    return f"the {title} the blow" if title.endswith(blow) else f"the {title}"


def one_of(words: Iterable[str]) -> str:
    """`give a`, or `give one of a, b`."""
    items = list(dict.fromkeys(words))
    return f"give {items[0]}" if len(items) == 1 else f"give one of {', '.join(items)}"


def of_limits(problem: Problem, names: Iterable[str]) -> str:
    """What else may be meant where a coefficient of friction is open: the least that there must be."""
    sides = [getattr(j, key, None) for j in problem.joints for key in ("mu", "mu_s")]
    known = {n.name for side in sides if side is not None for n in walk(side) if isinstance(n, Name)}
    return "".join(f", or ask for the limit: `{k} is smallest`" for k in names if k in known)


def in_general(problem: Problem) -> str:
    """What else may be meant where an instant leaves coordinates open: a formula in them."""
    if problem.instant is None or not problem.coordinates:
        return ""
    return f"; or leave `instant` out: then it is a formula in {listed([c.name for c in problem.coordinates])}"


def short(value: Decimal) -> str:
    """Four figures, without zeros that say nothing."""
    return f"{float(value):.4g}"


def in_unit(value: Decimal, unit: Unit, us: bool) -> str:
    """A number with its unit, such as `1.2 m/s`."""
    return f"{short(display(value, unit, us))} {unit.text}".removesuffix(" 1")


def unit_of(instant: Instant, *sides: Side) -> Unit:
    """The unit written in one of the sides, else the usual one of their dimension."""
    written = next((u for s in sides if (u := first_unit(s)) is not None), None)
    if written is not None:
        return parse_unit(written)
    return instant.setup.unit_for(dimension_of(sides[0], instant.setup.lookup))


def false_words(instant: Instant, relation: Relation, left: Decimal, right: Decimal) -> str:
    """A relation that does not hold, with the values of its sides; without them where letters stand for numbers."""
    if instant.scene.ledger.symbolic:
        return f"`{relation.text}` does not hold"
    sides = (relation.left, relation.right)
    # A bare zero has no unit of its own.
    unit = unit_of(instant, *sorted(sides, key=lambda s: isinstance(s, Number)))
    shown = " and ".join(in_unit(value, unit, instant.scene.ledger.us) for value in (left, right))
    return f"`{relation.text}` does not hold: the sides are {shown}"


def left_of(relation: Relation) -> str:
    """The left side of an equation as it is written."""
    return relation.text.split("=")[0].strip()


# --- pushes ----------------------------------------------------------------------------------------------------------


def on_whom(system: System, push: Push) -> str:
    """`C`, or `C/b` where the joint is between two moving bodies."""
    joint = system.aliases.get(push.joint, push.joint)
    bodies = list(dict.fromkeys(a.body for a in push.actions))
    return joint if GROUND in bodies or len(bodies) < 2 else f"{joint}/{bodies[0]}"


def push_name(system: System, push: Push) -> str:
    """N(C), friction(C), tension(cord), reaction(A).x …"""
    if push.kind == "drive":
        return f"the driving force of `{push.place or push.joint}`"
    if push.kind in KINDS:
        joint = system.aliases.get(push.joint, push.joint)
        return f"{KINDS[push.kind]}({joint if push.kind in ('normal', 'tension') else on_whom(system, push)})"
    stem, _, axis = push.name.rpartition("_")
    whole = f"reaction({on_whom(system, push)})"
    return f"{whole}.{axis}" if stem and axis in ("x", "y") else whole


def names_of(system: System, symbols: Collection[sp.Symbol], impulses: str = "") -> str:
    """Reactions by their symbols, as the file would ask for them; in a blow over the span `impulses` what they add up
    to.
    """
    named = [push_name(system, p) for p in system.pushes if system.symbols.get(p.name) in symbols]
    if impulses:
        named = [f"impulse{name[name.index('(') :]} @ {impulses}" if "(" in name else name for name in named]
    return ", ".join(dict.fromkeys(named)) or ", ".join(sorted(s.name for s in symbols))


# --- motions ---------------------------------------------------------------------------------------------------------


def moved_velocities(instant: Instant, system: System, change: Change) -> list[str]:
    """The velocities that a freedom changes: omega(OA), v(B), and constants that are sought."""
    base = instant.scene.valuations[0]
    still = dict.fromkeys((*system.tree.velocity_unknowns(), *_rates(instant, 0)), ZERO)
    zero, moving = base.extended(still), base.extended({**still, **change})

    def changes(expr: sp.Expr) -> bool:
        return abs(moving(expr) - zero(expr)) > Decimal("1e-25")

    rigid = [b for b in instant.scene.bodies if instant.scene.rigid(b)]
    found = [f"omega({b})" for b in rigid if changes(system.first.velocities[b].angular)]
    for body, model in instant.scene.bodies.items():
        if not instant.scene.rigid(body):
            v = system.first.velocity(model.center, body)
            axes = [axis for axis in ("x", "y") if changes(getattr(v, axis))]
            found += [f"v({body}).{axes[0]}"] if len(axes) == 1 else [f"v({body})"] if axes else []
    for edge in system.tree.edges:
        if edge.joining is None and instant.scene.rigid(edge.body):
            found += [f"v({edge.body}).{a}" for s, a in ((edge.slide, "x"), (edge.rise, "y")) if change.get(s, ZERO)]
    for point, body in _sliding_points(system):
        v = system.first.velocity(instant.scene.point(point), body)
        if changes(v.x) or changes(v.y):
            found.append(f"v({point})")
    return list(dict.fromkeys([*found, *_others(instant, change, 0)]))


def moved_accelerations(instant: Instant, system: System, change: Mapping[object, Decimal]) -> list[str]:
    """The accelerations that a freedom changes; `change` by (body, part) and by names."""
    found = [f"alpha({b})" for b in instant.scene.bodies if change.get((b, "turn"), ZERO)]
    for body in instant.scene.bodies:
        axes = [axis for axis in ("x", "y") if change.get((body, axis), ZERO)]
        free = any(e.body == body and e.joining is None for e in system.tree.edges)
        if axes and (free or not instant.scene.rigid(body)):
            found.append(f"a({body}).{axes[0]}" if len(axes) == 1 else f"a({body})")
    for point, body in _sliding_points(system):
        if any(change.get((body, part), ZERO) for part in ("x", "y", "turn")):
            found.append(f"a({point})")
    return list(dict.fromkeys(found))


def _sliding_points(system: System) -> list[tuple[str, str]]:
    """Points of bodies that slide along a fixed path: their speed is what is usually given."""
    scene = system.scene
    found = []
    for mode in system.modes.values():
        for joining in mode.facts.joinings:
            rod = joining.mover != GROUND and scene.rigid(joining.mover)
            if joining.path is not None and joining.base == GROUND and rod and joining.place in scene.points:
                found.append((joining.place, joining.mover))
    return found


def _rates(instant: Instant, level: int) -> list[sp.Symbol]:
    return instant.scene.evaluator.second_rates if level else instant.scene.evaluator.speeds


def _others(instant: Instant, change: Change, level: int) -> list[str]:
    """Rates of coordinates, and constants that are sought."""
    word = ("dot", "ddot")[level]
    rates = {m[level]: f"{word}({s.name})" for s, m in instant.scene.evaluator.motions.items()}
    names = {**rates, **{s: s.name for s in instant.scene.ledger.sought}}
    return [names[s] for s, v in change.items() if v and s in names]


def of_edge(edge: Edge, symbol: sp.Symbol) -> str:
    """A velocity unknown of the tree in the language of the file."""
    if symbol == edge.spin:
        return f"omega({edge.body})"
    if edge.joining is None:
        return f"v({edge.body}).{'x' if symbol == edge.slide else 'y'}"
    return f"v({edge.joining.place})"


def unknown_name(system: System, symbol: sp.Symbol) -> str:
    """Any unknown of a system in the language of the file."""
    for edge in system.tree.edges:
        if symbol in (edge.spin, edge.slide, edge.rise):
            return of_edge(edge, symbol)
        for rate, speed in ((edge.spin_rate, edge.spin), (edge.slide_rate, edge.slide), (edge.rise_rate, edge.rise)):
            if symbol == rate and speed is not None:
                return of_edge(edge, speed).replace("omega(", "alpha(").replace("v(", "a(")
    for push in system.pushes:
        if system.symbols.get(push.name) == symbol:
            return push_name(system, push)
    return str(symbol.name)


def has_magnitude(relation: Relation) -> bool:
    """Is a magnitude in it? Then its residual is the difference of squares."""
    return any(part.kind == "mag" for q in walk(relation) if isinstance(q, Quantity) for part in q.parts)
