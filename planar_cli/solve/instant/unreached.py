"""What is asked and no equation tells."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from planar_cli.errors import FileProblem, Mark, refuse
from planar_cli.solve.instant.stages import Stage


def unreached(stages: Iterable[Stage], exprs: list[sp.Expr]) -> list[sp.Symbol]:
    """What these expressions need and no equation of the stages tells."""
    inside = set().union(*(sp.sympify(e).free_symbols for e in exprs)) if exprs else set()
    return sorted({s for stage in stages for s in stage.undetermined} & inside, key=lambda s: s.name)


def not_reached(method: str | None, names: Iterable[str], mark: Mark) -> FileProblem:
    """A method that was named does not lead to something that is asked."""
    if method is None:
        text = f"no equation that is written here leads to {', '.join(names)}"
        return refuse(mark, "PL570", text, "ask for something else of the same motion; `planar simulate` may give it")
    text = f"method {method} alone does not reach {', '.join(names)}"
    hint = "leave `method` out: the plan then takes the laws that lead there; `--compare` lists what each reaches"
    return refuse(mark, "PL570", text, hint)
