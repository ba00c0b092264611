"""Terms with other terms in the place of their variables."""

from __future__ import annotations

from collections.abc import Mapping

from planar_cli.motion.terms.terms import Graph, Term, ordered


def replaced(term: Term, by: Mapping[Term, Term]) -> Term:
    """The term with other terms in the place of some of its variables."""
    found: dict[Term, Term] = {}
    for t in ordered([term]):
        args = tuple(found[a] for a in t.args)
        if t in by:
            found[t] = by[t]
        else:
            found[t] = t if args == t.args else _again(t.graph, t.op, args)
    return found[term]


def _again(graph: Graph, op: str, args: tuple[Term, ...]) -> Term:
    """The same operation on other operands."""
    match op:
        case "+":
            return graph.add(*args)
        case "*":
            return graph.multiply(*args)
        case "/":
            return graph.divide(*args)
        case "**":
            return graph.power(*args)
    return graph.call(op, *args)
