"""The half line of physics beside a free-body diagram: why friction acts where it does, how a stream pushes."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from planar_cli.equation.system.system import System
from planar_cli.loads.base import Load
from planar_cli.problem.scene.acting import acting_loads
from planar_cli.report.document.blocks import Paragraph, line

ALL_OF_IT = "the velocity is the same at all its points, so that the friction acts through its mass centre, against it"


def sentences(system: System, bodies: Collection[str], inertial: bool) -> Iterator[Paragraph]:
    """About the bodies of which diagrams are told. `inertial`: with inertial forces among what acts."""
    moving = [b for b in bodies if inertial and system.motion is not None and not system.balanced(b)]
    if moving and system.motion is not None:
        turning = any(system.motion.accelerations[b].angular != 0 for b in moving)
        couples = ", the inertial couple I α the angular acceleration" if turning else ""
        yield Paragraph(line(f"The inertial force m a opposes the acceleration{couples}."))
    for body in bodies:
        skids = any(w.kind == "skid" and w.body == body for w in system.wrenches)
        still = system.motion is not None and system.motion.velocities[body].angular == 0
        if skids and still and system.scene.rigid(body):
            yield Paragraph(line(f"{body} does not turn now: {ALL_OF_IT}"))
    told: list[Paragraph] = []
    pressing = {(w.kind, w.name) for w in system.wrenches}
    for load in acting_loads(system.scene.problem):
        if load.brings_mass and getattr(load, "body", "") in bodies:
            own = Paragraph(line(_stream(load, (load.kind, load.name) in pressing)))
            if own not in told:
                told.append(own)
    yield from told


def _stream(load: Load, presses: bool) -> str:
    """What a stream does to its body."""
    comes, goes = getattr(load, "enters", None), getattr(load, "leaves", None)
    body = getattr(load, "body", "")
    if not presses:
        way = "enters" if comes is not None else "leaves"
        return f"What {way} has no velocity relative to {body}: it does not push"
    if comes is not None and goes is not None:
        return (
            f"Momentum of the stream per second: where it enters, it pushes {body} in its own direction; where it "
            "leaves, in the opposite one"
        )
    if comes is not None:
        return f"Bringing what enters to the velocity of {body} takes mass per second times relative velocity"
    return (
        f"What leaves takes momentum with it. Thrust: mass per second times its velocity relative to {body}, in the "
        "opposite direction"
    )
