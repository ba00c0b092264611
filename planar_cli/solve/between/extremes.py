"""`X is largest` in a state whose time is fixed by something else: the freedom is a constant that is sought."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.solve.instant.stationary_point import eliminated, unchanged
from planar_cli.solve.regimes.equations import Equation

PLAIN = ("given", "drawn", "start", "turn", "motion", "link", "loop", "handed", "q(t)", "v(t)")


def stationary(
    equations: Sequence[Equation],
    objective: sp.Expr,
    unknowns: frozenset[sp.Symbol],
    kept: frozenset[sp.Symbol],
    like: Equation,
    sought: frozenset[sp.Symbol],
) -> list[Equation]:
    """The equations left when all linear unknowns but `kept` (times and sought constants) are eliminated, and the
    condition that the objective is stationary; each as an equation of the motion. `sought`: constants of the file.
    """
    plain = [e.residual for e in equations if e.kind in PLAIN]
    related, aim, letters, condition = eliminated(plain, objective, unknowns, kept, sought)
    if not related and aim in (letters[0], letters[0] ** 2) and "__" not in letters[0].name:
        text = f"{like.words}: no equation bounds it, only inequalities may"
        hint = "state the limit itself: `N(P) = 0` where contact is just kept, `v(P).mag = 0` where it just arrives; "
        hint += "or ask for it at one instant in a case before this one, `instant: [mode(C) = stick, mu is smallest]`, "
        hint += "and give it in this one: `given: {mu: limit.mu}`"
        raise NoSolution([Diagnostic(like.mark, "PL623", text, hint)])
    free = [x.name for x in letters if x in kept and "__" not in x.name]
    words = f"{like.words}, so {unchanged(free, objective)}"
    found = [Equation(p, "link", "what is left when the others are put in", like.stop) for p in related]
    return [*found, Equation(condition, "extreme", words, like.stop, mark=like.mark)]
