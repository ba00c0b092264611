"""What a worked solution says of one instant, in numbers: what the independent road is compared with."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.kinematics.motion import Edge
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import ZERO, Valuation
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record
from planar_cli.solve.instant.study import Outcome

PARTS = ("x", "y", "turn")
Twist = tuple[Vec, Decimal]


@record
class Worked:
    """Velocities, accelerations and pushes of one instant.

    `velocities`, `accelerations`: of each body's mass centre, with ω and α. `pushes`: the value of each by its name.
    `numbers`: values of everything else, sought loads among it.
    """

    velocities: dict[str, Twist]
    accelerations: dict[str, Twist]
    pushes: dict[str, Decimal]
    numbers: Valuation

    @staticmethod
    def of_motion(system: System, numbers: Valuation) -> Worked:
        """From a settled system, where every unknown (and the symbol of every push) has a number."""
        motion, reactions = system.motion, system.reactions
        if motion is None or reactions is None:
            raise ValueError("the velocities of the system are not settled")
        velocities, accelerations = {}, {}
        for name, body in system.scene.bodies.items():
            v, a = motion.velocity(body.center, name), motion.acceleration(body.center, name)
            velocities[name] = (Vec(numbers(v.x), numbers(v.y)), numbers(motion.velocities[name].angular))
            accelerations[name] = (Vec(numbers(a.x), numbers(a.y)), numbers(motion.accelerations[name].angular))
        pushes = {push.name: numbers(expr) for push, expr in reactions.pushes}
        return Worked(velocities, accelerations, pushes, numbers)

    @staticmethod
    def of_solution(system: System, outcome: Outcome, solved: Mapping[sp.Symbol, Decimal]) -> Worked:
        """From what a plan has `solved`; unknowns that it did not need have the values of the chosen modes' numbers."""
        numbers = outcome.value.extended({**unknowns_of(system, outcome), **solved})
        return Worked.of_motion(system, numbers)


def _accelerations(system: System, outcome: Outcome) -> dict[str, Twist]:
    columns, values = outcome.assembly.columns, outcome.solved.values
    found = {}
    for body in system.scene.bodies:
        x, y, turn = (values[columns[body, p]] if (body, p) in columns else ZERO for p in PARTS)
        found[body] = (Vec(x, y), turn)
    return found


def unknowns_of(system: System, outcome: Outcome) -> dict[sp.Symbol, Decimal]:
    """The unknowns of the tree, of pushes, coordinates and sought loads, as the numbers of one choice of modes say."""
    columns, values = outcome.assembly.columns, outcome.solved.values
    accelerations = _accelerations(system, outcome)
    found: dict[sp.Symbol, Decimal] = {}
    for edge in system.tree.edges:
        found |= _rates(edge, outcome, accelerations)
    for name, symbol in system.symbols.items():
        if name in columns:
            found[symbol] = values[columns[name]]
    rates = system.scene.evaluator.second_rates
    found |= {s: values[columns[s.name]] for s in (*system.scene.ledger.sought, *rates) if s.name in columns}
    return found


def _rates(edge: Edge, outcome: Outcome, accelerations: dict[str, Twist]) -> dict[sp.Symbol, Decimal]:
    """What one body adds to the tree: its α, and the acceleration of its slide along the path (or its a_x, a_y)."""
    found: dict[sp.Symbol, Decimal] = {}
    linear, angular = accelerations[edge.body]
    if edge.spin_rate is not None:
        found[edge.spin_rate] = angular * edge.turn
    if edge.components is not None and edge.slide_rate is not None and edge.rise_rate is not None:
        axis = outcome.assembly.number(edge.components.axis)
        found[edge.slide_rate], found[edge.rise_rate] = linear.dot(axis), linear.dot(axis.turned())
    elif edge.rise_rate is not None and edge.slide_rate is not None:
        found[edge.slide_rate], found[edge.rise_rate] = linear.x * edge.rightward, linear.y * edge.upward
    elif edge.slide_rate is not None and edge.joining is not None and edge.joining.path is not None:
        point, tangent = (outcome.assembly.number(v) for v in (edge.joining.point, edge.joining.path.tangent))
        ends = [_at(point, body, outcome, accelerations) for body in (edge.joining.mover, edge.joining.base)]
        found[edge.slide_rate] = (ends[0] - ends[1]).dot(tangent)
    return found


def _at(point: Vec, body: str, outcome: Outcome, accelerations: dict[str, Twist]) -> Vec:
    """a of a body's material point."""
    if body == GROUND:
        return Vec(ZERO, ZERO)
    (linear, angular), arm = accelerations[body], point - outcome.assembly.centers[body]
    return linear + arm.turned() * angular - arm * outcome.assembly.spin(body) ** 2
