"""Checks of what formulas name: numbers, time, states, and the arguments of quantities."""

from __future__ import annotations

import re
from collections.abc import Iterator

from planar_cli.errors import Diagnostic, Mark
from planar_cli.problem.checks.check_arguments import arguments
from planar_cli.problem.checks.check_names import missing_state
from planar_cli.problem.checks.formulas import Formula, formulas
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.expression import (
    AtRest,
    Equilibrium,
    Function,
    Grouped,
    JustAfter,
    Name,
    PointPair,
    Quantity,
    Side,
)
from planar_cli.problem.language.walk import Tree, children
from planar_cli.problem.language.words import CONSTANTS, OF_ALL, QUANTITIES
from planar_cli.problem.nodes.reading import did_you_mean
from planar_cli.problem.scene.headings import off_body
from planar_cli.problem.scene.masses import PLACES
from planar_cli.problem.scene.scene import GROUND
from planar_cli.units import ATOMS

SUBSCRIPTED = re.compile(r"([A-Za-z]+)_([A-Za-z0-9]\w*)")


def formulas_name_known_things(scope: Scope) -> Iterator[Diagnostic]:
    """Every name, state and argument in a formula stands for something, and stands where it may."""
    for formula in formulas(scope.problem):
        yield from formula_names(formula, scope)


def formula_names(formula: Formula, scope: Scope) -> Iterator[Diagnostic]:
    """The same for one formula."""
    yield from _tree(formula.tree, formula, scope, False)


def _tree(tree: Tree, formula: Formula, scope: Scope, direction: bool) -> Iterator[Diagnostic]:
    match tree:
        case Name():
            yield from _name(tree, formula, scope, direction)
        case Quantity():
            yield from _quantity(tree, formula, scope)
        case PointPair():
            for point in (tree.to, tree.origin):
                if point not in scope.point_like:
                    yield _no_thing(point, "point", sorted(scope.points), tree.mark)
            if tree.to == tree.origin:
                text = f"from {tree.to} to itself there is no direction"
                yield Diagnostic(tree.mark, "PL421", text, "name two points")
        case JustAfter():
            yield from missing_state(tree.state, scope, tree.mark)
        case AtRest(body=str(body)) | Equilibrium(body=str(body)):
            if body not in scope.point_like and body != "all":
                yield _no_thing(body, "body", sorted(scope.point_like), tree.mark)
        case Function(at=str(at)) | Grouped(at=str(at)):
            yield from missing_state(at, scope, tree.mark)
        case _:
            pass
    if isinstance(tree, Quantity):
        below: list[tuple[Tree, bool]] = [] if tree.argument is None else [(tree.argument, False)]
        below += [(part.direction, True) for part in tree.parts if part.direction is not None]
    else:
        below = [(child, False) for child in children(tree)]
    for child, is_direction in below:
        yield from _tree(child, formula, scope, is_direction)


def _no_thing(name: str, what: str, known: list[str], mark: Mark) -> Diagnostic:
    return Diagnostic(mark, "PL403", f"there is no {what} '{name}'", did_you_mean(name, known, "there are "))


def _name(name: Name, formula: Formula, scope: Scope, direction: bool) -> Iterator[Diagnostic]:
    if not name.name:
        return
    if name.at is not None:
        yield from missing_state(name.at, scope, name.mark)
    if name.name in CONSTANTS:
        if name.name == "t" and not formula.time:
            hint = "`t` may stand in `motion`, `states`, `find`, in magnitudes of loads, streams and masses"
            yield Diagnostic(name.mark, "PL411", f"{formula.what} cannot depend on the time t", hint)
        return
    known = {*scope.numbers, *formula.locals, "g"}
    if name.name in known or (direction and (name.name in scope.bodies or name.name == GROUND)):
        return
    if "." in name.name:
        yield from _case_find(name, scope)
        return
    yield Diagnostic(
        name.mark,
        "PL410",
        f"there is no name '{name.name}' in this file",
        _name_hint(name.name, known, scope, direction),
    )


def _case_find(name: Name, scope: Scope) -> Iterator[Diagnostic]:
    if name.name in scope.case_finds:
        return
    case, find = name.name.split(".", 1)
    if case in scope.point_like:
        hint = f"a part belongs to a quantity: `r({case}).{find}`"
    else:
        hint = did_you_mean(name.name, scope.case_finds, "known are ") or "`case.find` names a find of an earlier case"
    yield Diagnostic(name.mark, "PL412", f"there is no find '{find}' of an earlier case '{case}'", hint)


def _name_hint(name: str, known: set[str], scope: Scope, direction: bool) -> str:
    """What is most likely meant: `v_A` for v(A), a point for its place, a misspelt name."""
    match = SUBSCRIPTED.fullmatch(name)
    things = {*scope.point_like, *scope.members}
    if match and match[1] in QUANTITIES and match[2] in things:
        return f"a quantity is written with a bracket: `{match[1]}({match[2]})`"
    if name in OF_ALL:
        return f"write `{name}(all)` for the whole system, `{name}(b)` for a body"
    if name in ATOMS:
        return f"a value is a number with its unit: `5 {name}`"
    if name in scope.surfaces and direction:
        return "a direction is an angle, a body, or two points such as `B/A`"
    if name in scope.bodies:
        return f"'{name}' is a body; a quantity of it is written `omega({name})`"
    if name in scope.points:
        return f"'{name}' is a point; its place is `r({name})`, `x({name})`, `y({name})`"
    if name in scope.states:
        return f"'{name}' is a state; write `… @ {name}`"
    if name in {find.name for find in scope.problem.find}:
        return "a find is no name for formulas; write what it asks for, or use `case.find` in a later case"
    told = next((known for known in scope.case_finds if known.endswith(f".{name}")), None)
    if told is not None:
        return f"write `{told}` for the find of the earlier case"
    if name in scope.file_finds:
        hint = "a case may use what an earlier case found, not what the file itself asks for; "
        return f"{hint}ask for it in a case, `first: {{find: {{{name}: …}}}}`, and write `first.{name}` in a later one"
    return did_you_mean(name, sorted(known)) or "give it in `given` (value), `symbols` or `unknowns` (unit)"


def _quantity(quantity: Quantity, formula: Formula, scope: Scope) -> Iterator[Diagnostic]:
    place = quantity.word in PLACES and quantity.at is None
    turned = formula.turns and isinstance(formula.tree, Side) and off_body(formula.tree) is not None
    if not formula.quantities and not turned and not (formula.places and place):
        hint = "quantities may stand in `motion`, `instant`, `states`, `find`, magnitudes of loads and streams"
        if formula.places:
            hint = "a mass may use `t`, coordinates, and the places `x(P)`, `y(P)`, `theta(b)`"
        elif formula.turns and quantity.word == "theta":
            hint = "a direction that turns with a body is counted from its angle: `theta(b)`, `theta(b) + 90 deg`"
        elif formula.angle and quantity.word == "theta":
            hint = "a direction that turns with a body is written with the coordinate by which the body is placed: "
            hint += "`B: {from: A, distance: l, angle: phi}` with `coordinates: {phi: deg}`, and here `phi + 90 deg`; "
            hint += "a point beside a line through others is `{from: A, towards: B, distance: l, offset: h}`"
        yield Diagnostic(quantity.mark, "PL413", f"{formula.what} cannot use {quantity.word}(…)", hint)
    for state in (quantity.at,) if isinstance(quantity.at, str) else quantity.at or ():
        yield from missing_state(state, scope, quantity.mark)
    yield from arguments(quantity, scope)
