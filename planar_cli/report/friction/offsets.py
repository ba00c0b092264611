"""How far beside the middle of a face its normal force acts: M = N x, by the moments of the loads about that point.

x = P y/N_C = 235.4 · 0.5/588.6 = 0.2 m < b/2 = 0.3 m      it slips before it tips
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import Valuation
from planar_cli.problem.scene.facts import Push
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record
from planar_cli.report.document.blocks import Line, Math, Name, line
from planar_cli.solve.instant.instant import Trial

LONGEST, NEAR = 12, Decimal("1e-20")


def offset_letter(system: System, push: Push) -> sp.Symbol:
    """x of the couple of a face, or x_N where the file has an x; of several faces with the joint as index."""
    names = {*system.scene.ledger.symbols, *system.scene.points}
    letter = "x_N" if "x" in names else "x"
    return sp.Symbol(f"{letter}_{push.joint}" if len(_faces(system)) > 1 else letter, positive=True)


def normal_of(system: System, push: Push) -> Push | None:
    """The normal force that a couple on a face belongs to; None: it is no such couple."""
    if push.kind != "couple":
        return None
    return next((p for p in system.pushes if p.joint == push.joint and p.kind == "normal"), None)


def moment_of_loads(trial: Trial, push: Push, size: Decimal) -> sp.Expr | None:
    """The couple of a face by the moments of the loads about the middle of the face, of a body in equilibrium on which
    nothing else presses. None: it is not, or that is long. `size`: the number that it has to be.
    """
    system = trial.system
    normal = normal_of(system, push)
    action = next((a for a in normal.actions if a.body != GROUND), None) if normal is not None else None
    if action is None or not system.balanced(action.body):
        return None
    if any(a.body == action.body for p in system.pushes if p.joint != push.joint for a in p.actions):
        return None
    loads = [w for w in system.wrenches if w.body == action.body]
    turning = [w.couple + ((w.point - action.point).cross(w.force) if w.force is not None else 0) for w in loads]
    whole = simplified(sp.Add(*turning))
    number = trial.outcomes[0].value.known(whole) if not longer(whole, LONGEST) and whole.free_symbols else None
    if number is None or abs(abs(number) - size) > NEAR * size:
        return None
    return whole if number > 0 else -whole


@record
class Offset:
    """How far beside the middle of a face its normal force acts: the couple is `sense` N x, with x > 0. It turns
    counterclockwise where `counter` is 1, clockwise where it is -1.

    `way`: from the middle to where it acts; `value`: of x [m]; None: it has none, as a mass that cancels; `far`: of x
    where it is drawn [m].
    """

    letter: sp.Symbol
    couple: sp.Symbol
    normal: sp.Symbol
    sense: int
    counter: int
    place: str
    way: Vec
    value: Decimal | None
    far: Decimal

    @property
    def moment(self) -> sp.Expr:
        """What stands for the couple."""
        return self.sense * self.normal * self.letter

    def beside(self, middle: Vec) -> Vec:
        """Where it acts."""
        along: Vec = self.way * sp.Rational(str(self.far))
        return Vec(middle.x + along.x, middle.y + along.y)

    def told(self, arrow: str) -> Line:
        """` at x to the right of C`. `arrow`: of the way."""
        beside = {"→": "to the right of", "←": "to the left of"}.get(arrow, f"{arrow} from")
        return line(" at ", Math(self.letter), f" {beside} ", Name(self.place))


def offsets(trial: Trial, value: Valuation) -> Iterator[Offset]:
    """Of each face on which a normal force acts beside its middle; of several with the joint as index."""
    if not trial.outcomes:
        return
    system, outcome = trial.system, trial.outcomes[0]
    for push, normal in _faces(system):
        size, press = outcome.push(push.name), outcome.push(normal.name)
        (own, pressed) = push.actions[0], normal.actions[0]
        if not size or not press or press < 0 or pressed.force is None or own.body != pressed.body:
            continue
        turns = 1 if value(sp.sympify(own.couple)) > 0 else -1
        counter = turns if size > 0 else -turns
        way = Vec(pressed.force.y * counter, -pressed.force.x * counter)
        couple, force = system.symbols[push.name], system.symbols[normal.name]
        moment, force_there = value.known(couple), value.known(force)
        told = None if moment is None or not force_there else abs(moment / force_there)
        # In numbers that are drawn for letters x is that of the position that is drawn.
        far = abs(size / press) if told is None else told
        letter, sense = offset_letter(system, push), counter * turns
        yield Offset(letter, couple, force, sense, counter, normal.place, way, told, far)


def _faces(system: System) -> list[tuple[Push, Push]]:
    """The couple of each face, with its normal force."""
    couples = [p for p in system.pushes if p.kind == "couple" and not _is_guide(system, p)]
    return [(p, n) for p in couples if (n := normal_of(system, p)) is not None]


def _is_guide(system: System, push: Push) -> bool:
    """A guide holds on both sides, so that its couple is not that of its normal force alone."""
    return any(j.kind == "guide" and j.name == push.joint for j in system.scene.problem.joints)
