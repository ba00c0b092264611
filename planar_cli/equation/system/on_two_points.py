"""A rigid body that stands on two points: where it parts at one of them, it tips about the other."""

from __future__ import annotations

from planar_cli.equation.system.system import System


def on_two_points(system: System, joint: str) -> tuple[str, str] | None:
    """The body that presses at a contact, and the point about which it tips where it parts there; None: it stands on
    no other point, or on several.
    """
    stands = {
        name: mode.facts.joinings[0]
        for name, mode in system.modes.items()
        if not mode.parted and len(mode.facts.joinings) == 1 and any(p.kind == "normal" for p in mode.facts.pushes)
    }
    own = stands.get(joint)
    if own is None or not system.scene.rigid(own.mover):
        return None
    others = [j.place for name, j in stands.items() if j.mover == own.mover and name != joint]
    return (own.mover, others[0]) if len(others) == 1 else None
