"""Scenes in which nothing holds, as they say something else than was meant: which side, or what is held at rest."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from planar_cli.problem.language.expression import Number, Quantity, Relation
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Particle, Problem, Round
from planar_cli.solve.instant.instant import Instant


def otherwise_meant(instant: Instant, said: Iterable[str]) -> tuple[str, str] | None:
    """What the file says, and what to write for what may be meant; None: there is no such doubt."""
    problem, objections = instant.scene.problem, list(said)
    contacts = {j.name: tuple(getattr(j, "between", ())) for j in problem.joints if j.kind == "contact"}
    told = [*_outside(problem, contacts, objections), *_held(instant, contacts, objections)]
    return told[0] if told else None


def _outside(problem: Problem, contacts: Mapping[str, tuple[str, ...]], said: list[str]) -> Iterator[tuple[str, str]]:
    """A particle on the rim of a round body lies outside of it, and is not pressed from there."""
    shapes = {b.name: b.shape for b in problem.bodies}
    for name, between in contacts.items():
        if not any(f"N_{name} presses" in words for words in said):
            continue
        for small, large in (between, between[::-1]):
            shape = shapes.get(large)
            if isinstance(shapes.get(small), Particle) and isinstance(shape, Round):
                wall = f"surfaces: {{wall: {{center: {shape.center}, radius: …, body: {large}}}}}"
                text = f"`{small}` is taken to lie outside of `{large}`, and nothing presses it on it there"
                yield text, f"for the inside write `{wall}` and `between: [{small}, wall]`"


def _held(instant: Instant, contacts: Mapping[str, tuple[str, ...]], said: list[str]) -> Iterator[tuple[str, str]]:
    """What does not slip on what is fixed has no acceleration along it, though one is stated."""
    problem = instant.scene.problem
    fixed = {"ground", *(s.name for s in problem.surfaces if not s.body)}
    stated = [r for r, _ in instant.statements.relations if isinstance(r, Relation)]
    nodes = (n for r in problem.instant or () for n in walk(r))
    sticking = {n.things[0] for n in nodes if isinstance(n, Quantity) and n.word == "mode"}
    for name, between in contacts.items():
        base = next((p for p in between if p in fixed), None)
        body = next((p for p in between if p not in fixed), "")
        if base is None or name not in sticking or not said:
            continue
        own = next((r for r in stated if _accelerates(r, body)), None)
        if own is not None:
            text = f"`{body}` does not slip on `{base}`, which is fixed: it stays at rest, but `{own.text}` is stated"
            yield text, f"let a body carry `{base}`, by `body:` in `surfaces`, and give the acceleration to that body"


def _accelerates(relation: Relation, body: str) -> bool:
    """Does it state an acceleration of a body that is not nought?"""
    q, other = relation.left, relation.right
    return (
        isinstance(q, Quantity)
        and (q.word, q.things) == ("a", (body,))
        and not (isinstance(other, Number) and other.value == 0)
    )
