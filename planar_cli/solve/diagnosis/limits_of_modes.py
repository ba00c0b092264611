"""Limits that only the inequalities of modes set, as the least friction with which something sticks: they are looked
for at one instant alone, not among the equations of a motion.
"""

from __future__ import annotations

from collections.abc import Collection

from planar_cli.errors import Diagnostic, Mark, NoSolution
from planar_cli.problem.language.expression import Extreme, Name
from planar_cli.problem.scene.scene import State

OPEN = "PL623"
LIMIT = (
    "state the limit itself: `friction(C/b).mag = mu*N(C)` where b is about to slip, `N(C) = 0` where it is only just "
    "pressed on, `v(P).mag = 0` where it just arrives"
)


def unbounded(words: str, mark: Mark, of_state: bool) -> NoSolution:
    """What to say of an extreme that no equation bounds. `of_state`: of one of a motion."""
    hint = f"{LIMIT}; or {_as_case('mode(C) = stick, mu is smallest', 'mu')}" if of_state else LIMIT
    return NoSolution([Diagnostic(mark, OPEN, f"{words}: no equation bounds it, only inequalities may", hint)])


def sought_at_start(state: State, names: Collection[str]) -> NoSolution | None:
    """What to say of a constant that stays open though the first state asks for its extreme; None: it does not."""
    for r in state.relations:
        if isinstance(r, Extreme) and isinstance(r.side, Name) and r.side.name in names:
            text = f"state {state.name}: `{r.text}` is not found beside a motion: only inequalities bound it there"
            said = ", ".join(s.text for s in state.relations)
            return NoSolution([Diagnostic(r.mark, OPEN, text, _as_case(said, r.side.name))])
    return None


def _as_case(said: str, name: str) -> str:
    first = f"ask for it at one instant in a case before this one, `instant: [{said}]`"
    return f"{first}, and give it in this one: `given: {{{name}: limit.{name}}}`"
