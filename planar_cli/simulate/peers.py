"""Other packages that follow motions, as far as they are installed and can express a scene; to compare with.

heyoka takes the generated equations of motion of one regime. exudyn and MuJoCo build the scene anew from its rigid
bodies, pins and weights; they know nothing of our equations. All of them are told the end of the motion only.
"""

from __future__ import annotations

import math
import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from importlib.util import find_spec
from typing import Any, ClassVar

from planar_cli.errors import PlanarError
from planar_cli.motion.regime.regime import Regime
from planar_cli.records import record
from planar_cli.simulate.mechanism import GROUND, Mechanism
from planar_cli.simulate.run import Run

Numbers = tuple[float | None, ...]
"""A state, with None for what a package does not tell."""


@record
class Followed:
    """What a peer found."""

    end: Numbers
    seconds: float
    """Of the following alone, without import and preparation."""


class Peer(ABC):
    """One package."""

    name: ClassVar[str]
    tolerances: ClassVar[tuple[float, ...]] = ()
    steps: ClassVar[tuple[float, ...]] = ()
    """In parts of the scene's time scale."""

    def available(self) -> bool:
        """Is it installed?"""
        return find_spec(self.name) is not None

    @abstractmethod
    def follow(self, run: Run, setting: float) -> Followed:
        """To the end of our own run, with a tolerance or a step [s]. Raises PlanarError where it can not express it."""


class Heyoka(Peer):
    """Taylor series of high order, compiled."""

    name: ClassVar[str] = "heyoka"
    tolerances: ClassVar[tuple[float, ...]] = (1e-6, 1e-9, 1e-12, 1e-15)

    def follow(self, run: Run, setting: float) -> Followed:
        import heyoka

        segments = run.trajectory.segments
        regime = segments[0].regime
        if (
            not isinstance(regime, Regime)
            or run.trajectory.transitions
            or any(s.regime is not regime for s in segments)
        ):
            raise PlanarError("heyoka follows one regime: here it changes on the way, or something strikes")
        names = [f"y{i}" for i in range(len(segments[0].start))]
        variables = heyoka.make_vars(*names)
        functions: dict[str, Any] = {
            n: getattr(heyoka, n) for n in ("sin", "cos", "tan", "exp", "log", "sqrt", "atan2")
        }
        rates = _as_formulas(regime.source, functions)(heyoka.time, variables)
        system = [(v, heyoka.expression(r)) for v, r in zip(variables, rates, strict=True)]
        taylor = heyoka.taylor_adaptive(system, list(segments[0].start), tol=setting, compact_mode=True)
        taylor.time = segments[0].t0
        began = time.perf_counter()
        # The step is limited: where its last two coefficients vanish by symmetry it would leap (performance notes).
        taylor.propagate_until(segments[-1].t1, max_delta_t=run.model.time_scale)
        return Followed(tuple(float(v) for v in taylor.state), time.perf_counter() - began)


def _as_formulas(source: str, functions: dict[str, Any]) -> Callable[[Any, Sequence[Any]], list[Any]]:
    """The generated code for numbers as code for formulas: without its checks of pivots."""
    lines = [line for line in source.splitlines() if not line.lstrip().startswith("if ")]
    space: dict[str, Any] = dict(functions)
    exec(compile("\n".join(lines), "<equations of motion>", "exec"), space)
    found: Callable[[Any, Sequence[Any]], list[Any]] = space["f"]
    return found


class Exudyn(Peer):
    """Generalized-alpha with equal steps, constraints at the level of accelerations."""

    name: ClassVar[str] = "exudyn"
    steps: ClassVar[tuple[float, ...]] = (0.03, 0.01, 0.003, 0.001)

    def follow(self, run: Run, setting: float) -> Followed:
        import exudyn
        import exudyn.itemInterface

        items = exudyn.itemInterface
        mechanism = Mechanism.of(run)
        system = exudyn.SystemContainer().AddSystem()
        ground = system.AddObject(items.ObjectGround(referencePosition=[0, 0, 0]))
        bodies, nodes = {GROUND: ground}, {}
        for b in mechanism.bodies:
            node = system.AddNode(
                items.NodeRigidBody2D(referenceCoordinates=[b.x, b.y, b.angle], initialVelocities=[b.vx, b.vy, b.omega])
            )
            body = items.ObjectRigidBody2D(mass=b.mass, inertia=b.inertia, nodeNumber=node)
            nodes[b.name], bodies[b.name] = node, system.AddObject(body)
            at = system.AddMarker(items.MarkerBodyPosition(bodyNumber=bodies[b.name], localPosition=[0, 0, 0]))
            system.AddLoad(items.LoadForceVector(markerNumber=at, loadVector=[0, -b.mass * mechanism.gravity, 0]))
        for pin in mechanism.pins:
            ends = [
                system.AddMarker(items.MarkerBodyPosition(bodyNumber=bodies[name], localPosition=[*local, 0]))
                for name, local in ((pin.a, pin.on_a), (pin.b, pin.on_b))
            ]
            system.AddObject(items.ObjectJointRevolute2D(markerNumbers=ends))
        system.Assemble()
        settings = exudyn.SimulationSettings()
        span = mechanism.end - mechanism.begin
        settings.timeIntegration.numberOfSteps = max(1, math.ceil(span / setting))
        settings.timeIntegration.endTime = span
        settings.timeIntegration.verboseMode = 0
        settings.solution.file.write = False
        settings.solution.sensors.writePeriod = span
        began = time.perf_counter()
        try:
            system.SolveDynamic(settings)
        except (RuntimeError, ValueError) as error:
            raise PlanarError(f"exudyn gave up: {str(error).strip().splitlines()[0]}") from error
        seconds = time.perf_counter() - began
        kinds = exudyn.OutputVariableType
        places, speeds = [], []
        for b in mechanism.bodies:
            moved = system.GetNodeOutput(nodes[b.name], kinds.Coordinates)
            places += [b.x + float(moved[0]), b.y + float(moved[1]), b.angle + float(moved[2])]
            speeds += [float(v) for v in system.GetNodeOutput(nodes[b.name], kinds.Coordinates_t)]
        return Followed((*places, *speeds), seconds)


class MuJoCo(Peer):
    """Fourth-order Runge-Kutta in the coordinates of the joints; loops are closed by soft constraints."""

    name: ClassVar[str] = "mujoco"
    steps: ClassVar[tuple[float, ...]] = (0.03, 0.01, 0.003, 0.001)

    def follow(self, run: Run, setting: float) -> Followed:
        import mujoco

        mechanism = Mechanism.of(run)
        span = mechanism.end - mechanism.begin
        number = max(1, math.ceil(span / setting))
        model = mujoco.MjModel.from_xml_string(mechanism.as_mjcf(span / number))
        data = mujoco.MjData(model)
        parents = mechanism.parents()
        rest = {b.name: b for b in mechanism.bodies}
        for b in mechanism.bodies:
            parent = parents[b.name]
            relative = b.omega - (rest[parent.a].omega if parent is not None and parent.a != GROUND else 0.0)
            data.joint(f"turn {b.name}").qvel[0] = relative
            if parent is None:
                data.joint(f"x {b.name}").qvel[0], data.joint(f"y {b.name}").qvel[0] = b.vx, b.vy
        began = time.perf_counter()
        mujoco.mj_step(model, data, number)
        seconds = time.perf_counter() - began
        mujoco.mj_kinematics(model, data)
        places: list[float | None] = []
        speeds: list[float | None] = []
        for b in mechanism.bodies:
            turned, omega, name = 0.0, 0.0, b.name
            while name != GROUND:
                turned += float(data.joint(f"turn {name}").qpos[0])
                omega += float(data.joint(f"turn {name}").qvel[0])
                parent = parents[name]
                name = parent.a if parent is not None else GROUND
            x, y, _ = data.body(b.name).xipos
            places += [float(x), float(y), b.angle + turned]
            speeds += [None, None, omega]
        return Followed((*places, *speeds), seconds)


PEERS: tuple[type[Peer], ...] = (Heyoka, Exudyn, MuJoCo)


def largest_of(found: Numbers, scaled: Sequence[float], scale: Sequence[float]) -> float:
    """The largest difference of what a peer tells from a state in parts of the scales."""
    pairs = zip(found, scaled, scale, strict=True)
    return max((abs(a / s - b) for a, b, s in pairs if a is not None), default=math.inf)
