"""Checks of instants: `instant` or `states`, never both; statements and times where they may stand; no circles."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping

from planar_cli.errors import Diagnostic, Mark
from planar_cli.joints.base import Joint
from planar_cli.problem.checks.check_names import missing_state, points_of_place
from planar_cli.problem.checks.formulas import formulas
from planar_cli.problem.checks.scope import Scope, members_of
from planar_cli.problem.language.expression import Extreme, Grouped, JustAfter, Name, Quantity, Relation, Word
from planar_cli.problem.language.walk import Tree, children, is_endless, walk, written_alike
from planar_cli.problem.nodes.reading import listed
from planar_cli.problem.scene.order_of_states import runs_back
from planar_cli.problem.scene.scene import Symbol


def instant_or_states(scope: Scope) -> Iterator[Diagnostic]:
    """`instant` never stands beside `states`."""
    p = scope.problem
    if p.instant is not None and p.states:
        mark = p.instant[0].mark if p.instant else p.states[0].mark
        hint = "one instant: `instant`; several: `states`, of which the first may be this one"
        yield Diagnostic(mark, "PL430", "a file has either `instant` or `states`", hint)


def statements_in_place(scope: Scope) -> Iterator[Diagnostic]:
    """`just after` belongs to states, `is largest` to instants; mode words to a relation with `mode(j)`."""
    p = scope.problem
    for law in p.motion:
        if isinstance(law.statement, Extreme | JustAfter):
            yield Diagnostic(
                law.statement.mark, "PL431", f"'{law.statement.text}' does not hold all the time", "write it in a state"
            )
        elif isinstance(law.statement, Relation) and law.statement.operator != "=":
            text = f"'{law.statement.text}' drives nothing: `motion` has equations"
            hint = "write it in a state, where it chooses; between letters under `assume`"
            yield Diagnostic(law.statement.mark, "PL431", text, hint)
    for statement in p.instant or ():
        if isinstance(statement, JustAfter):
            yield Diagnostic(
                statement.mark,
                "PL431",
                f"'{statement.text}' stands in `states`",
                "write `states: {1: […], 2: [just after 1]}`",
            )
    known = {s.name for s in (*p.given, *p.symbols)}
    for statement in (*(p.instant or ()), *(s for state in p.states for s in state.relations)):
        if isinstance(statement, Extreme) and _is_known(statement.side, known):
            text = f"'{statement.text}': its value is given, so that nothing is largest or smallest"
            hint = "declare it under `unknowns`"
            if scope.case:
                text = f"case {scope.case}: {text}"
                hint = (
                    "what the file states holds in every case: write it in the case that asks for it and gives no value"
                )
            yield Diagnostic(statement.mark, "PL431", text, hint)
    for statement in p.assume:
        if not isinstance(statement, Relation):
            yield Diagnostic(
                statement.mark, "PL431", f"'{statement.text}' is no relation between names", "write `assume: [a < g]`"
            )
    for formula in formulas(p):
        yield from _words(formula.tree)


def sides_differ(scope: Scope) -> Iterator[Diagnostic]:
    """A relation whose two sides are written alike says nothing, or can not be true."""
    p = scope.problem
    stated = (*(law.statement for law in p.motion), *(p.instant or ()), *p.assume)
    for relation in (*stated, *(r for state in p.states for r in state.relations)):
        if isinstance(relation, Relation) and written_alike(relation.left, relation.right):
            says = "is never true" if relation.operator in "<>" else "says nothing"
            text = f"'{relation.text}' {says}: both sides are the same"
            yield Diagnostic(relation.mark, "PL439", text, "compare with something else, or leave it out")


def _is_known(tree: Tree, known: set[str]) -> bool:
    """Does a formula rest on numbers of the file alone?"""
    nodes = list(walk(tree))
    asked = any(isinstance(n, Quantity) for n in nodes)
    return not asked and all(n.name in known for n in nodes if isinstance(n, Name))


def _words(tree: Tree) -> Iterator[Diagnostic]:
    """A mode word that does not stand opposite `mode(j)`."""
    if isinstance(tree, Relation):
        sides = (tree.left, tree.right)
        for side, other in (sides, sides[::-1]):
            if isinstance(side, Word) and isinstance(other, Quantity) and other.word == "mode":
                yield from _words(other)
                return
    if isinstance(tree, Word):
        yield Diagnostic(
            tree.mark, "PL432", f"'{tree.word}' stands only after `mode(j) =`", f"write `mode(C) = {tree.word}`"
        )
    for child in children(tree):
        yield from _words(child)


def blows_have_spans(scope: Scope) -> Iterator[Diagnostic]:
    """Impulses say between which states they happen; the second is `just after` the first. An impact that does not say
    so happens whenever its bodies strike each other; at one instant nothing does.
    """
    p = scope.problem
    after = {s.name: r.state for s in p.states for r in s.relations if isinstance(r, JustAfter)}
    for member in members_of(p):
        if not member.strikes:
            continue
        if member.during is None and (not isinstance(member, Joint) or p.instant is not None):
            yield Diagnostic(
                member.mark, "PL433", f"the {member.kind} does not say when it happens", "write `during: 1->2`"
            )
        elif (
            member.during is not None
            and set(member.during) <= set(scope.states)
            and after.get(member.during[1]) != member.during[0]
        ):
            start, end = member.during
            message = f"the {member.kind} takes no time, but state {end} is not just after state {start}"
            yield Diagnostic(member.mark, "PL433", message, f"write `{end}: [just after {start}]`")


def spans_in_order(scope: Scope) -> Iterator[Diagnostic]:
    """A span runs from a state to a later one; a mean over it, to one that has a time."""
    acting: list[tuple[tuple[str, str], Mark]] = [
        (law.during, law.statement.mark) for law in scope.problem.motion if law.during
    ]
    acting += [(m.during, m.mark) for m in members_of(scope.problem) if m.during and not m.strikes]
    spans = [*acting, *((m.during, m.mark) for m in members_of(scope.problem) if m.during and m.strikes)]
    for formula in formulas(scope.problem):
        quantities = [node for node in walk(formula.tree) if isinstance(node, Quantity)]
        yield from _endless_means(quantities, scope)
        spans += [(q.at, q.mark) for q in quantities if isinstance(q.at, tuple)]
    for law in scope.problem.motion:
        for state in law.during or ():
            yield from missing_state(state, scope, law.statement.mark)
    for (start, end), mark in spans:
        known = start in scope.states and end in scope.states
        if known and start == end:
            yield Diagnostic(mark, "PL434", f"the span {start}->{end} has no length", "write two different states")
    for (start, end), mark in acting:
        known = start in scope.states and end in scope.states and start != end
        if known and runs_back((start, end), scope.problem.states):
            text = f"during {start}->{end} nothing acts: state {end} comes before state {start}"
            yield Diagnostic(mark, "PL434", text, f"write `during: {end}->{start}`, or the states that are meant")


def _endless_means(quantities: Iterable[Quantity], scope: Scope) -> Iterator[Diagnostic]:
    endless = {state.name for state in scope.problem.states if is_endless(state.relations)}
    for q in quantities:
        if q.word == "mean" and isinstance(q.at, tuple) and q.at[1] in endless:
            text = f"state {q.at[1]} is never reached: a mean up to it is over a time without end"
            yield Diagnostic(q.mark, "PL434", text, "end it at a state that has a time, such as `[t = 10 s]`")


def lengths_taken_up(scope: Scope) -> Iterator[Diagnostic]:
    """What joins two points from a later state on keeps the distance that they have there."""
    for joint in scope.problem.joints:
        length = getattr(joint, "length", None)
        if length is None or joint.during is None or scope.problem.holds_at_first(joint.during):
            continue
        text = f"{joint.name} takes hold at state {joint.during[0]} and keeps the distance that its ends have then"
        hint = "leave `length` out; where the distance is sought, a relation of that state tells it"
        yield Diagnostic(joint.mark, "PL438", text, hint)


def one_mode_at_a_time(scope: Scope) -> Iterator[Diagnostic]:
    """A joint has one mode at an instant."""
    p = scope.problem
    for statements in (p.instant or (), *(state.relations for state in p.states)):
        told: dict[tuple[str, ...], Word] = {}
        for relation in statements:
            if not isinstance(relation, Relation) or relation.operator != "=":
                continue
            for one, other in ((relation.left, relation.right), (relation.right, relation.left)):
                if isinstance(one, Quantity) and one.word == "mode" and one.at is None and isinstance(other, Word):
                    first = told.setdefault(one.things, other)
                    if first.word != other.word:
                        text = f"`{relation.text}` contradicts `mode({'/'.join(one.things)}) = {first.word}`"
                        yield Diagnostic(relation.mark, "PL437", text, "a joint has one mode at an instant; keep one")


def finds_say_when(scope: Scope) -> Iterator[Diagnostic]:
    """In a file with states a find of the time says at which."""
    if not scope.states:
        return
    for find in scope.problem.find:
        for name in _open_times(find.found.what):
            states = listed(f"`t @ {state}`" for state in scope.states)
            yield Diagnostic(
                name.mark, "PL435", f"the find {find.name} asks for the time, but not of which state", f"write {states}"
            )


def states_of_what_varies(scope: Scope) -> Iterator[Diagnostic]:
    """`N(C)/W @ 1` and `N(C)/(m*g) @ 1` read at state 1 what is the same at every state, and leave open at which N(C)
    is meant.
    """
    constants = {s.name for s in (*scope.problem.given, *scope.problem.symbols) if _is_constant(s)}
    for find in scope.problem.find if scope.states else ():
        what = find.found.what
        idle = next((n for n in walk(what) if _is_idle(n, constants)), None)
        if isinstance(idle, Name | Grouped) and (open_one := next(_without_state(what), None)) is not None:
            asked = f"{open_one.word}({'/'.join(open_one.things)})"
            told = idle.name if isinstance(idle, Name) else "(…)"
            named = told if isinstance(idle, Name) else "what stands in the bracket"
            text = f"`{told} @ {idle.at}`: {named} is the same at every state, and {asked} has none"
            hint = f"`@` belongs to what stands just before it: `{open_one.word}(…) @ {idle.at}/{told}`"
            yield Diagnostic(idle.mark, "PL435", text, hint)


def _is_idle(node: Tree, constants: Collection[str]) -> bool:
    """Is a state told of a constant, or of a bracket in which there are only constants?"""
    if isinstance(node, Name):
        return node.at is not None and node.name in constants
    if not isinstance(node, Grouped):
        return False
    inside = list(walk(node.operand))
    return not any(
        isinstance(n, Quantity) or (isinstance(n, Name) and n.name not in {*constants, "g", "pi"}) for n in inside
    )


def _is_constant(symbol: Symbol) -> bool:
    """Does its value rest on numbers alone?"""
    return symbol.value is None or not any(isinstance(n, Quantity | Name) for n in walk(symbol.value))


def _without_state(tree: Tree) -> Iterator[Quantity]:
    """The quantities of a find of which no state is told."""
    if isinstance(tree, Grouped) and tree.at is not None:
        return
    if isinstance(tree, Quantity):
        if tree.at is None and tree.things:
            yield tree
        return
    for child in children(tree):
        yield from _without_state(child)


def _open_times(tree: Tree) -> Iterator[Name]:
    if isinstance(tree, Grouped) or (isinstance(tree, Quantity) and tree.at is not None):
        return
    if isinstance(tree, Name) and tree.name == "t" and tree.at is None:
        yield tree
    for child in children(tree):
        yield from _open_times(child)


def no_circles(scope: Scope) -> Iterator[Diagnostic]:
    """No given value and no point is defined by itself, however far round."""
    values = {s.name: (s.mark, _names(s.value)) for s in scope.problem.given if s.value is not None}
    yield from _circles(values, "the value of", "PL436")
    points = {p.name: (p.mark, points_of_place(p.place)) for p in scope.problem.points}
    yield from _circles(points, "the point", "PL436")


def _names(tree: Tree) -> tuple[str, ...]:
    return tuple(node.name for node in walk(tree) if isinstance(node, Name))


def _circles(graph: Mapping[str, tuple[Mark, tuple[str, ...]]], what: str, code: str) -> Iterator[Diagnostic]:
    """One diagnostic for each circle of references."""
    done: set[str] = set()
    for start in graph:
        trail: list[str] = []
        circle = _find_circle(start, graph, trail, done)
        if circle:
            around = " -> ".join((*circle, circle[0]))
            yield Diagnostic(
                graph[circle[0]][0],
                code,
                f"{what} {circle[0]} is defined by itself: {around}",
                "define one of them anew",
            )


def _find_circle(
    name: str, graph: Mapping[str, tuple[Mark, tuple[str, ...]]], trail: list[str], done: set[str]
) -> list[str]:
    if name in trail:
        return trail[trail.index(name) :]
    if name in done or name not in graph:
        return []
    trail.append(name)
    for other in graph[name][1]:
        circle = _find_circle(other, graph, trail, done)
        if circle:
            done.update(circle)
            return circle
    trail.pop()
    done.add(name)
    return []
