"""Members that somebody adds: a file in a folder is on the shelf, and the whole program knows what it does."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from answered import assert_close

from planar_cli.errors import FileProblem
from planar_cli.motion.regime.model import Model
from planar_cli.motion.scene.scene import MovingScene
from planar_cli.problem.structure import load_text
from planar_cli.registry import extended, members
from planar_cli.report.page.effects import effects
from planar_cli.simulate.effects import ledger
from planar_cli.simulate.run import Settings, Simulation, simulate
from planar_cli.solve.compare import compare_methods
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import Solution

MAGNET = '''
    """A magnet."""

    from __future__ import annotations

    from dataclasses import dataclass
    from typing import Any, ClassVar

    from planar_cli.loads.base import Load
    from planar_cli.problem.language.expression import Side
    from planar_cli.problem.scene.facts import Effect, Wrench
    from planar_cli.problem.scene.keys import PointPairKey, SideKey, key
    from planar_cli.problem.scene.setting import MovingSetting, Setting


    @dataclass(frozen=True, slots=True, kw_only=True)
    class Magnet(Load):
        """Two points attract each other with k / d²."""

        kind: ClassVar[str] = "magnet"
        effect: ClassVar[Effect] = Effect("magnetic force", "magnets")

        between: tuple[str, str] = key(PointPairKey(), "the two points")
        strength: Side = key(SideKey("N*m^2"), "k")

        def wrenches(self, scene: MovingSetting) -> tuple[Wrench, ...]:
            start, end = (scene.point(p) for p in self.between)
            away = end - start
            distance = scene.length(away)
            size = scene.value(self.strength) / distance**2
            ends = ((self.between[0], start, away), (self.between[1], end, -away))
            return tuple(
                Wrench(self.name, "magnet", scene.owner(p), at, d * (size / distance), 0, size) for p, at, d in ends
            )

        def potential(self, scene: Setting) -> Any:
            start, end = (scene.point(p) for p in self.between)
            return -scene.value(self.strength) / scene.length(end - start)
'''

MESH = '''
    """Meshing wheels."""

    from __future__ import annotations

    from dataclasses import dataclass
    from typing import Any, ClassVar

    from planar_cli.joints.base import Joint
    from planar_cli.problem.language.expression import Side
    from planar_cli.problem.scene.facts import Action, Facts, Mode, Push, Row
    from planar_cli.problem.scene.keys import PartnersKey, SideKey, key
    from planar_cli.problem.scene.residuals import Residual
    from planar_cli.problem.scene.setting import Setting


    @dataclass(frozen=True, slots=True, kw_only=True)
    class Mesh(Joint):
        """Two wheels of a train turn in a given ratio; the housing on the ground takes what their couples leave."""

        kind: ClassVar[str] = "mesh"

        between: tuple[str, ...] = key(PartnersKey(), "the wheels")
        ratio: Side = key(SideKey("1"), "turns of the first for one of the second")

        def modes(self, scene: Setting) -> tuple[Mode, ...]:
            (a, b), ratio = self.between, scene.value(self.ratio)
            row = Row(self.name, f"{a} and {b} turn together", spins=((a, 1), (b, -ratio)))
            wheels = (Action(a, scene.center(a), None, 1), Action(b, scene.center(b), None, -ratio))
            actions = (*wheels, Action("ground", scene.center(b), None, ratio - 1))
            push = Push(f"M_{self.name}", "couple", self.name, self.name, actions, "N*m")
            return (Mode("", "", Facts(rows=(row,), pushes=(push,))),)

        def residuals(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
            (a, b), ratio = self.between, scene.value(self.ratio)

            def creep(poses: Any) -> Any:
                return poses.angle(a) - poses.angle(b) * poses.number(ratio)

            return (Residual(f"{self.name}: arcs on both rims", creep),)
'''

POWER = '''
    """The power of all forces."""

    from __future__ import annotations

    from collections.abc import Iterator
    from typing import ClassVar, final

    import sympy as sp

    from planar_cli.principles.base import Balance, Position, Principle, Single, Source


    @final
    class Power(Principle):
        """The power of all forces is the rate of the kinetic energy."""

        kind: ClassVar[str] = "power"
        diagram: ClassVar[str] = "power of all forces"

        def at_instant(self, position: Position) -> Iterator[Single]:
            scene, motion = position.system.scene, position.motion
            gain = []
            for name, body in scene.bodies.items():
                v, a = motion.velocity(body.center, name), motion.acceleration(body.center, name)
                turn = motion.velocities[name].angular * motion.accelerations[name].angular
                gain.append(body.mass * v.dot(a) + body.inertia * turn)
            left = sp.Add(*(power for _, power in powers(position)))
            yield Single(left, sp.Add(*gain), "The power of all forces", "P", cost=0.5)

        def over(self, position: Position, chosen: bool) -> Iterator[Balance]:
            scene, motion = position.system.scene, position.motion
            amounts = []
            for name, body in scene.bodies.items():
                v, spin = motion.velocity(body.center, name), motion.velocities[name].angular
                amounts.append((name, body.mass * v.dot(v) / 2 + body.inertia * spin**2 / 2))
            sources = tuple(Source(name, power) for name, power in powers(position))
            yield Balance(
                words="power, integrated",
                name="",
                amounts=tuple(amounts),
                sources=sources,
                cost=2.0,
                letter="E",
                bring="P",
                timeless=True,
            )


    def powers(position: Position) -> Iterator[tuple[str, sp.Expr]]:
        motion = position.motion
        for w in position.system.wrenches:
            moved = sp.S.Zero if w.force is None else w.force.dot(motion.velocity(w.point, w.body))
            yield f"{w.kind} {w.name}", moved + w.couple * motion.velocities[w.body].angular
'''

NAMED_ONLY = '''
    """A name."""

    from typing import ClassVar, final

    from planar_cli.principles.base import Principle


    @final
    class Least(Principle):
        """Of all motions the real one has the least action."""

        kind: ClassVar[str] = "least"
'''

TRAIN = """
title: Two wheels of a train
plane: horizontal
given: {I_1: 2 kg*m^2, I_2: 3 kg*m^2, M: 10 N*m}
points: {A: [0, 0], B: [1 m, 0]}
bodies:
  one: {disk: A, radius: 0.2 m, mass: 5 kg, inertia: I_1}
  two: {disk: B, radius: 0.4 m, mass: 8 kg, inertia: I_2}
joints:
  - pin: {at: A, between: [ground, one]}
  - pin: {at: B, between: [ground, two]}
  - mesh: {between: [one, two], ratio: -2, name: teeth}
loads:
  - torque: {body: one, moment: M}
"""

PULLED = """
title: Pulled by a magnet
plane: horizontal
given: {k: 2 N*m^2, m: 2 kg}
points: {O: [0, 0], P: [1 m, 0]}
bodies: {b: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - magnet: {between: [O, P], strength: k}
"""

Put = Callable[[str, str, str], None]


@pytest.fixture
def put(tmp_path: Path) -> Iterator[Put]:
    """Puts a member, as the text of its file, on a shelf: shelf, name of the file, text."""
    with ExitStack() as stack:

        def on_shelf(shelf: str, name: str, text: str) -> None:
            folder = tmp_path / shelf
            folder.mkdir(exist_ok=True)
            (folder / f"{name}.py").write_text(textwrap.dedent(text).lstrip(), encoding="utf-8")
            stack.enter_context(extended(shelf, folder))

        yield on_shelf


def solution_of(text: str) -> Solution:
    problem, wrong = load_text(text)
    assert wrong == []
    assert problem is not None
    return solve_problem(problem)


def test_a_shelf_is_as_it_was_afterwards(put: Put) -> None:
    assert "magnet" not in members("loads")
    put("loads", "magnet", MAGNET)
    assert "magnet" in members("loads")


def test_an_added_load_acts_at_an_instant(put: Put) -> None:
    put("loads", "magnet", MAGNET)
    solution = solution_of(PULLED + "instant: [at rest]\nfind: {a: a(b).x, pe: PE(all)}\n")
    (part,) = solution.parts
    by_name = {f.name: f for f in part.found}
    assert_close(by_name["a"], -1)
    assert_close(by_name["pe"], -2)
    present, absent = effects(part.instants[0])
    assert "magnetic force" in present
    assert "magnets" not in absent


def test_an_added_load_that_does_not_act_is_told(put: Put) -> None:
    put("loads", "magnet", MAGNET)
    text = "plane: vertical\nbodies: {P: {particle: [0, 0], mass: 1 kg}}\ninstant: [at rest]\nfind: {a: a(P).y}\n"
    _, absent = effects(solution_of(text).parts[0].instants[0])
    assert "magnets" in absent


def test_the_potential_of_an_added_load_relates_states(put: Put) -> None:
    put("loads", "magnet", MAGNET)
    states = "states: {1: [at rest], 2: [x(b) = 0.5 m]}\nmethod: energy\nfind: {v: v(b).mag @ 2}\n"
    (part,) = solution_of(PULLED + states).parts
    # m v²/2 = k (1/0.5 - 1/1)
    assert_close(part.found[0], 2.0**0.5)
    assert "energy" in {e.kind for step in part.motion.route.steps for e in step.relations}


# --- a joint ---------------------------------------------------------------------------------------------------------


def test_an_added_joint_at_an_instant(put: Put) -> None:
    put("joints", "mesh", MESH)
    (part,) = solution_of(TRAIN + "instant: [at rest]\nfind: {a: alpha(two), M: moment(teeth/one)}\n").parts
    by_name = {f.name: f for f in part.found}
    # (I_2 + 4 I_1) alpha_2 = -2 M, and M + M_teeth = I_1 alpha_1
    assert_close(by_name["a"], -20 / 11)
    assert_close(by_name["M"], 80 / 11 - 10)


@pytest.mark.parametrize("method", ["newton", "energy"])
def test_an_added_joint_between_states(put: Put, method: str) -> None:
    put("joints", "mesh", MESH)
    states = f"states: {{1: [at rest], 2: [theta(one) = 3 rad]}}\nmethod: {method}\nfind: {{w: omega(two) @ 2}}\n"
    (part,) = solution_of(TRAIN + states).parts
    # (I_2 + 4 I_1) omega_2²/2 = M θ_1
    assert_close(part.found[0], -((60 / 11) ** 0.5))


# --- a principle -----------------------------------------------------------------------------------------------------

FALLING = """
title: Rod that falls
plane: vertical
given: {l: 2 m, m: 3 kg}
points: {O: [0, 0], B: [l, 0]}
bodies: {rod: {rod: [O, B], mass: m}}
joints:
  - pin: {at: O, between: [ground, rod]}
"""
G = 9.81


def test_an_added_principle_at_an_instant(put: Put) -> None:
    put("principles", "power", POWER)
    text = FALLING + "instant: [omega(rod) = 2 rad/s]\nmethod: power\nfind: {alpha: alpha(rod)}\n"
    (part,) = solution_of(text).parts
    assert_close(part.found[0], -3 * G / 4)
    (kinetic,) = (w for s in part.instants[0].stages for b in s.blocks for w in b.equations if w.law != "relation")
    assert kinetic.words == "The power of all forces"


def test_an_added_principle_between_states(put: Put) -> None:
    put("principles", "power", POWER)
    states = "states: {1: [at rest], 2: [theta(rod) = -90 deg]}\nmethod: power\nfind: {w: omega(rod) @ 2}\n"
    (part,) = solution_of(FALLING + states).parts
    assert_close(part.found[0], -((3 * G / 2) ** 0.5))
    used = {e.kind for step in part.motion.route.steps for e in step.relations if e.offered}
    assert used == {"power"}


def test_an_added_principle_is_one_of_those_compared(put: Put) -> None:
    put("principles", "power", POWER)
    problem, _ = load_text(FALLING + "instant: [omega(rod) = 2 rad/s]\nfind: {alpha: alpha(rod)}\n")
    assert problem is not None
    rows = {row.method: row for row in compare_methods(problem)}
    assert rows["power"].answers == ("alpha",)
    assert rows["power"].objection == ""


def test_a_principle_that_has_only_a_name_answers_nothing(put: Put) -> None:
    put("principles", "least", NAMED_ONLY)
    with pytest.raises(FileProblem, match="method least: it offers no equation"):
        solution_of(FALLING + "instant: [at rest]\nmethod: least\nfind: {alpha: alpha(rod)}\n")


# --- what is followed ------------------------------------------------------------------------------------------------

HEUN = '''
    """Heun's method."""

    from __future__ import annotations

    from typing import ClassVar, final

    from planar_cli.integrators._fixed import EqualSteps
    from planar_cli.integrators.base import Rates, Vector


    @final
    class Heun(EqualSteps):
        """Heun's method of order 2, with equal steps."""

        kind: ClassVar[str] = "heun"
        order: ClassVar[int] = 2
        cost: ClassVar[int] = 1

        def advance(self, f: Rates, t: float, y: Vector, r: Vector, h: float) -> Vector:
            after = f(t + h, [v + h * k for v, k in zip(y, r, strict=True)])
            return [v + h / 2 * (k + m) for v, k, m in zip(y, r, after, strict=True)]
'''
SWINGING = FALLING + "states: {1: [t = 0, at rest], 2: [t = 0.5 s]}\nfind: {w: omega(rod) @ 2}\n"


def followed(text: str, settings: Settings | None = None) -> Simulation:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    return simulate(problem, settings or Settings())


def code_of(text: str) -> str:
    """The straight-line code of a scene's rates."""
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    return Model(MovingScene(problem)).regime().source


def test_an_added_load_is_followed(put: Put) -> None:
    put("loads", "magnet", MAGNET)
    found = followed(PULLED + "states: {1: [at rest], 2: [x(b) = 0.5 m]}\nfind: {v: v(b).mag @ 2}\n")
    assert found.answers[0].values[0] == pytest.approx(2.0**0.5, rel=1e-8)
    entries, absent = ledger(found.run.problem)
    assert "magnetic force" in [e.words for e in entries]
    assert "drag" in absent


def test_an_added_joint_is_followed(put: Put) -> None:
    put("joints", "mesh", MESH)
    states = "states: {1: [at rest], 2: [theta(one) = 3 rad]}\nfind: {w: omega(two) @ 2, M: moment(teeth/one) @ 2}\n"
    speed, couple = (a.values[0] for a in followed(TRAIN + states).answers)
    assert speed == pytest.approx(-((60 / 11) ** 0.5), rel=1e-8)
    assert couple == pytest.approx(80 / 11 - 10, rel=1e-8)


def test_an_added_integrator_follows(put: Put) -> None:
    truth = followed(SWINGING).answers[0].values[0]
    put("integrators", "heun", HEUN)
    errors = [
        abs(followed(SWINGING, Settings(integrator="heun", step=step, check=False)).answers[0].values[0] - truth)
        for step in (0.001, 0.0005)
    ]
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.1)


def test_added_members_change_no_other_scene(put: Put) -> None:
    """The code of a scene is made of what its own bodies, joints and loads emit."""
    before = code_of(SWINGING)
    put("loads", "magnet", MAGNET)
    put("joints", "mesh", MESH)
    assert code_of(SWINGING) == before
