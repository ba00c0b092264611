"""What the equations of a motion cost, by their kind: the route through them takes the cheapest."""

from __future__ import annotations

from planar_cli.solve.law import AT_MIDPOINT, HALF_SWINGS, MIRRORED, RELATIVE

COSTS = {"given": 0.1, "turn": 0.2, "drawn": 0.1, "start": 0.1, "motion": 0.5, "link": 0.6, "loop": 1.2, "extreme": 0.8}
COSTS |= {
    "mass centre": 1.6,
    "followed": 5.0,
    "blow": 1.0,
    "handed": 0.3,
    "orbit": 1.1,
    "anomaly": 1.2,
    "arc": 1.0,
    RELATIVE: 1.0,
}
COSTS |= {MIRRORED: 0.3, AT_MIDPOINT: 0.3, HALF_SWINGS: 0.3}
NO_MASS = 0.5
"""What a law of energy or momentum costs where the file gives no mass."""
COSTS |= {"q(t)": 1.0, "v(t)": 1.0, "v(q)": 1.05, "t(v)": 1.5, "q(v)": 1.1, "t(q)": 1.3}
LAST = 10.0
"""What a law costs that needs an integrating factor: more than energy and momentum together, whatever these need."""
BESIDE = 1.2
"""What t = ∫ dq/v costs more where the speed is given: a loop and a constant velocity beside it are plainer."""
HIDDEN = 1.5
"""What it costs to solve for an unknown inside sines or exponentials."""
