"""Numbers of joints, loads and wheels get the letters that every page writes: μ, μ_s, μ_k, e, k, c, F, M, r.

A file may give them as numbers where they stand (`mu: 0.3`). A formula needs the letter: F = μ N, not F = 0.3 N.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from planar_cli.problem.checks.scope import Member, members_of
from planar_cli.problem.language.expression import Name, Number
from planar_cli.problem.scene.keys import keys_of
from planar_cli.problem.scene.scene import Body, Problem, Round, Symbol
from planar_cli.records import record

LETTERS = {
    "radius": "r",
    "stiffness": "k",
    "natural_length": "l_0",
    "coefficient": "c",
    "mu": "mu",
    "mu_s": "mu_s",
    "mu_k": "mu_k",
    "restitution": "e",
}
"""The letters that every page writes for such a key."""
OF_LOADS = {("Force", "magnitude"): "F", ("Torque", "moment"): "M"}
LENGTHS = ("natural_length",)
RADIUS = "radius"
RESERVED = ("g", "t", "pi", "infinity")


@record
class _Literal:
    """A number that stands where a joint or load needs it. `owner`: kind and name of that, `key`: where it stands."""

    owner: tuple[str, str]
    key: str
    number: Number

    @property
    def letter(self) -> str:
        return _letter(self.owner[0], self.key)

    @property
    def size(self) -> tuple[object, ...]:
        return self.number.value, self.number.unit, self.number.sense


def lettered(problem: Problem) -> Problem:
    """The problem and its cases with those numbers among the given."""
    cases = tuple(replace(case, problem=lettered(case.problem)) for case in problem.cases)
    # Beside letters without numbers a number stays: the answer is a formula of those letters.
    literals = [] if problem.symbols else [x for m in members_of(problem) for x in _literals(m)]
    literals += [] if problem.symbols else list(_radii(problem))
    given: dict[str, Symbol] = {}
    names: dict[tuple[tuple[str, str], str], str] = {}
    taken = _taken(problem)
    for x in literals:
        same = {other.size for other in literals if other.letter == x.letter}
        name = x.letter if len(same) == 1 else f"{x.letter}_{x.owner[1]}"
        # Members without a name of their own are called alike: their numbers stay.
        alike = {other.size for other in literals if other.letter == x.letter and other.owner[1] == x.owner[1]}
        if name not in taken and len(alike) == 1:
            names[x.owner, x.key] = name
            given.setdefault(name, Symbol(name, x.number, None, x.number.mark))
    if not given:
        return replace(problem, cases=cases) if cases else problem
    return replace(
        problem,
        given=(*problem.given, *given.values()),
        bodies=tuple(_with_radius(b, names) for b in problem.bodies),
        joints=tuple(_with_letters(j, names, given) for j in problem.joints),
        loads=tuple(_with_letters(x, names, given) for x in problem.loads),
        cases=cases,
    )


def _literals(member: Member) -> list[_Literal]:
    """The numbers of one joint or load. Nought, as of a smooth contact, and one, as of an elastic blow, are no letters;
    nor is a length, which cancels against places.
    """
    kind = type(member).__name__
    found = ((s.name, getattr(member, s.name)) for s in keys_of(type(member)) if _letter(kind, s.name))
    return [
        _Literal(_owner(member), key, value)
        for key, value in found
        if isinstance(value, Number) and value.value not in (0, 1)
    ]


def _radii(problem: Problem) -> Iterator[_Literal]:
    """The radii of wheels: arms of their rims are told by them."""
    for body in problem.bodies:
        shape = body.shape
        if isinstance(shape, Round) and isinstance(shape.radius, Number):
            yield _Literal((RADIUS, body.name), RADIUS, shape.radius)


def _with_radius(body: Body, names: dict[tuple[tuple[str, str], str], str]) -> Body:
    name = names.get(((RADIUS, body.name), RADIUS))
    if name is None or not isinstance(body.shape, Round) or not isinstance(body.shape.radius, Number):
        return body
    return replace(body, shape=replace(body.shape, radius=Name(name, None, body.shape.radius.mark)))


def _letter(kind: str, key: str) -> str:
    """The letter for a key of such a joint or load; empty: it has none."""
    return "" if key in LENGTHS else LETTERS.get(key, OF_LOADS.get((kind, key), ""))


def _owner(member: Member) -> tuple[str, str]:
    return type(member).__name__, member.name


def _taken(problem: Problem) -> set[str]:
    """Names that stand for something else in the file."""
    numbers = (*problem.given, *problem.symbols, *problem.unknowns, *problem.coordinates)
    others = (*problem.points, *problem.bodies, *problem.surfaces, *problem.states, *members_of(problem))
    return {x.name for x in (*numbers, *others)} | {f.name for f in problem.find} | set(RESERVED)


def _with_letters(member: Any, names: dict[tuple[tuple[str, str], str], str], given: dict[str, Symbol]) -> Any:
    """A joint or load with letters for its numbers; another one of the same name may have other numbers."""
    own = {k: n for (o, k), n in names.items() if o == _owner(member) and _same(getattr(member, k), given[n].value)}
    changed = {key: Name(name, None, getattr(member, key).mark) for key, name in own.items()}
    return replace(member, **changed) if changed else member


def _same(one: Any, other: Any) -> bool:
    """Are they the same number?"""
    both = isinstance(one, Number) and isinstance(other, Number)
    return both and (one.value, one.unit, one.sense) == (other.value, other.unit, other.sense)
