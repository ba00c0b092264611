"""What hangs on ropes: how fast it sways about their upper ends."""

from __future__ import annotations

from planar_cli.motion.regime.model import Model
from planar_cli.motion.terms.terms import Term


def rates_across_ropes(model: Model) -> list[Term]:
    """The velocities across their straight parts, of one end as seen from the other, of all ropes that may be taut.

    What hangs and is not sent aside goes along with the upper end of its rope, and does not turn about it.
    """
    scene = model.scene
    taut = [modes[0].facts for modes in model.modes.values() if any(m.name == "taut" for m in modes)]
    ends = [(s.start, s.end, s.direction.turned()) for f in taut for row in f.rows for s in row.segments]
    ties = [(j, j.path) for f in taut for j in f.joinings if j.path is not None]
    rates = [(scene.velocity(b.point, b.body) - scene.velocity(a.point, a.body)).dot(d) for a, b, d in ends]
    rates += [(scene.velocity(j.point, j.mover) - scene.velocity(j.point, j.base)).dot(p.tangent) for j, p in ties]
    return [model.graph.of(rate) for rate in rates]
