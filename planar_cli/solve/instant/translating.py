"""Bodies that translate at one instant only: what their equations leave out, ω = 0, has to be told."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from planar_cli.solve.instant.instant import Trial


def translating(trial: Trial, used: Iterable[sp.Expr]) -> set[sp.Symbol]:
    """The angular velocities that are zero, without the file saying so, of bodies that move and begin to turn."""
    motion, values, outcome = trial.system.motion, trial.velocities[0].values, trial.outcomes[0]
    symbols = {s for e in used for s in e.free_symbols}
    given = [row for c in trial.system.velocity_conditions() if c.kind == "given" for row in c.rows()]
    said = {s for row in given for s in row.free_symbols}
    found = set()
    for e in trial.system.tree.edges:
        if motion is None or e.spin is None or e.spin_rate not in symbols or e.spin in said or values.get(e.spin) != 0:
            continue
        v, column = motion.velocities[e.body].linear, outcome.assembly.columns.get((e.body, "turn"))
        begins = column is not None and outcome.solved.values[column] != 0
        if begins and (v.x, v.y) != (0, 0):
            found.add(e.spin)
    return found
