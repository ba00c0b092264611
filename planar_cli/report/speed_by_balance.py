"""The speed at any time by a balance of momentum up to then, which a way is integrated from: no law is told for it.

From 1 to 2, wagon: impulse and momentum:         (1) F t_2 = (M + q t_2) v_2
Likewise at any time, with t for t_2:   v = F t/(M + q t)
"""

from __future__ import annotations

from planar_cli.equation.factoring import factored
from planar_cli.equation.plain import derivative, identically_zero, simplified
from planar_cli.report.blocks import Block, Equation, Paragraph, line
from planar_cli.report.words import Phrases
from planar_cli.solve.between.trace import BalanceTrace, MotionTrace, Relation

MOMENTUM = "momentum"


def speed_by_balance(e: Relation, found: MotionTrace, phrases: Phrases) -> list[Block]:
    """The speed as a function of time; empty: no balance tells it."""
    if e.kind != "q(t)" or e.law is None or e.span is None or e.span.explicit is None:
        return []
    general, route = dict(found.general), found.route
    own = [s for s in general if s.name.endswith(f"__{e.stop}")]
    speed = next((s for s in own if general[s] in (e.law.v, e.law.speed)), None)
    t = next((s for s in own if general[s].name == "t"), None)
    if speed is None or t is None:
        return []
    rate = derivative(e.span.explicit, t)
    relations = (r for leg in route.steps for r in leg.relations if (r.since, r.stop) == (e.since, e.stop))
    balances = (r for r in relations if isinstance(r.source, BalanceTrace) and r.kind == MOMENTUM)
    growing = (r for r in balances if derivative(r.residual, speed).has(t))
    if not any(identically_zero(r.residual.xreplace({speed: rate})) for r in growing):
        return []
    rest = {s: route.plain.get(s, s) for s in rate.free_symbols if s != t}
    at_any = factored(simplified(rate.xreplace(rest).xreplace({t: general[t]})))
    told = Equation((phrases.math(general[speed]), phrases.math(at_any)))
    return [Paragraph(line("Likewise at any time, with t for ", phrases.math(route.plain.get(t, t)), ":")), told]
