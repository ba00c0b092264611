"""The unknown pushes and the loads of one choice of modes, by name: what N(C), reaction(A/b), force(f) ask."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from planar_cli.errors import refuse
from planar_cli.loads.base import Load
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.acting import kind_of
from planar_cli.problem.scene.facts import Action, Push, Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record


@record
class Reactions:
    """The pushes of one choice of modes and all loads, over any kind of number."""

    pushes: tuple[tuple[Push, Any], ...]
    """Each with its size: its symbol, or what a friction law makes of it."""
    wrenches: tuple[Wrench, ...]
    """Of all loads."""
    joints: dict[str, str]
    """Our own name of each joint to the file's; several may share one name of the file."""
    zero: Any
    """Nothing, in the caller's kind of number."""

    def _none(self) -> Vec:
        return Vec(self.zero, self.zero)

    def _of(self, q: Quantity) -> list[tuple[Push, Any]]:
        name = q.things[0]
        if name not in self.joints.values():
            text = f"{name} does not act then"
            hint = "ask at a state from the one in which it begins to act to the one in which it ends"
            raise refuse(q.mark, "PL557", text, hint)
        return [(p, e) for p, e in self.pushes if self.joints.get(p.joint) == name]

    def number(self, q: Quantity, kind: str) -> Any:
        """The normal force or tension of a joint; of a load that pulls along its line, its pull."""
        for wrench in self.wrenches:
            pulls = (kind_of(wrench) or Load).pulls
            if wrench.name == q.things[0] and kind == "tension" and pulls:
                return wrench.magnitude
        found = [e for p, e in self._of(q) if p.kind == kind]
        return found[0] if found else self.zero

    def couple(self, q: Quantity) -> Any:
        """The couple of a joint or a load on the named body."""
        total = self.zero
        if self._is_load(q):
            for wrench in self._of_load(q):
                total = total + wrench.couple
            return total
        for push, expr in self._of(q):
            if push.unit == "N*m":
                total = total + expr * self._action(push, self._body(q, _bodies([push]))).couple
        return total

    def force(self, q: Quantity, kinds: tuple[str, ...] | None) -> Vec:
        """The sum of a joint's forces of these kinds (None: all, of a load too) on the named body."""
        if kinds is None and self._is_load(q):
            return self.load(q)
        skids = [w for w in self.wrenches if w.kind == "skid" and self.joints.get(w.name) == q.things[0]]
        named = q.things[-1] if any(w.body == q.things[-1] for w in skids) else None
        for wrench in skids:
            if wrench.force is not None and (wrench.body == named or (named is None and len(q.things) == 1)):
                return wrench.force
        chosen = [(p, e) for p, e in self._of(q) if p.unit == "N" and (kinds is None or p.kind in kinds)]
        if not chosen:
            return self._none()
        body = self._body(q, _bodies(p for p, _ in chosen))
        total = self._none()
        for push, expr in chosen:
            for action in push.actions:
                if action.body == body and action.force is not None:
                    total = total + action.force * expr
        return total

    def _body(self, q: Quantity, bodies: list[str]) -> str:
        """On whom: the body after the slash, else the one beside the ground, else that of the joint's name. A size is
        the same on each.
        """
        if len(q.things) == 2:
            if q.things[1] not in bodies:
                raise refuse(
                    q.mark, "PL558", f"{q.things[1]} is not held by {q.things[0]}", f"it acts on {', '.join(bodies)}"
                )
            return q.things[1]
        moving = [b for b in bodies if b != GROUND]
        if len(moving) == 1:
            return moving[0]
        if q.things[0] in bodies:
            return q.things[0]
        if q.parts and q.parts[0].kind == "mag":
            return moving[0]
        raise refuse(
            q.mark,
            "PL559",
            f"{q.word}({q.things[0]}) acts on several bodies",
            f"say on which: {q.word}({q.things[0]}/{moving[0]})",
        )

    @staticmethod
    def _action(push: Push, body: str) -> Action:
        return next(a for a in push.actions if a.body == body)

    def _loads(self, name: str) -> list[Wrench]:
        """What the loads of that name do; a weight has the name of its body and is not asked for by it."""
        return [w for w in self.wrenches if w.name == name and kind_of(w) is not None and w.kind != "weight"]

    def _is_load(self, q: Quantity) -> bool:
        """Is a load meant, as no joint of that name acts?"""
        return q.things[0] not in self.joints.values() and bool(self._loads(q.things[0]))

    def load(self, q: Quantity) -> Vec:
        """The force of a load, on the named body, or on its only one; a stream pushes where it enters and leaves."""
        total = self._none()
        for wrench in self._of_load(q):
            if wrench.force is not None:
                total = total + wrench.force
        return total

    def _of_load(self, q: Quantity) -> list[Wrench]:
        """What a load does to the named body."""
        found = self._loads(q.things[0])
        if not found:
            return []
        body = self._body(q, list(dict.fromkeys(w.body for w in found)))
        return [w for w in found if w.body == body]

    def power(self, q: Quantity, velocity: Callable[[Vec, str], Vec], turn: Callable[[str], Any]) -> Any:
        """Σ F · v + M ω of a load, of a joint (`/b`: on b alone), of all forces on a body, or of everything.

        `velocity`: of a body's point at a place; `turn`: the angular velocity of a body.
        """
        total = self.zero
        for w in self.upon(q):
            if w.force is not None:
                total = total + w.force.dot(velocity(w.point, w.body))
            total = total + w.couple * turn(w.body)
        return total

    def upon(self, q: Quantity) -> tuple[Wrench, ...]:
        """What `q` names does: on every body, or on the one behind the stroke."""
        found = self.acting(q.things[0])
        return tuple(w for w in found if w.body == q.things[1]) if len(q.things) == 2 else found

    def acting(self, name: str) -> tuple[Wrench, ...]:
        """What a load, a joint, all forces on a body, or everything does: one wrench for each body and force."""
        found = [w for w in self.wrenches if name in (w.name, w.body, "all")]
        for push, expr in self.pushes:
            joint = self.joints.get(push.joint, push.joint)
            for a in push.actions:
                if name in (joint, a.body, "all"):
                    force = None if a.force is None else a.force * expr
                    found.append(Wrench(joint, push.kind, a.body, a.point, force, a.couple * expr))
        return tuple(found)


def _bodies(pushes: Iterable[Push]) -> list[str]:
    """All bodies on which some pushes act."""
    return list(dict.fromkeys(a.body for p in pushes for a in p.actions))
