"""The contact in which a plastic impact leaves its partners: from the state just after it on, as long as they press.

A particle then slides without friction, or with that of the impact, along the straight line across the common normal,
of a line or where the file states the normal. Other outlines change the direction of their normal as they move along
each other; of them a `contact` tells.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from planar_cli.equation.scene.meeting import meeting_of, partner_of
from planar_cli.equation.scene.scene import Scene
from planar_cli.joints.base import Joint
from planar_cli.problem.language.expression import JustAfter, Side
from planar_cli.problem.scene.facts import Facts, Joining, Law, Mode, Path, Push, Row, Test, opposed, relative
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.headings import heading
from planar_cli.problem.scene.known_values import KnownValues
from planar_cli.problem.scene.residuals import Residual
from planar_cli.problem.scene.scene import GROUND, Line, Particle, Problem, State


@dataclass(frozen=True, slots=True, kw_only=True)
class LastingContact(Joint):
    """Partners of an impact that touch; the modes have the names that the motion followed by itself gives them."""

    kind: ClassVar[str] = "lasting"

    between: tuple[str, ...]
    """The partners of the impact."""
    normal: Side | None
    """The direction of their common normal, where the file gives it."""
    mu: Side | None
    """The coefficient of friction of the impact; None: it is smooth."""

    def modes(self, scene: Any) -> tuple[Mode, ...]:
        """Apart first; then in contact, sticking or slipping where it is rough."""
        mover, base, point, normal = self._place(scene)
        words = " and ".join(sorted((mover, base), key=lambda b: b == GROUND))
        parts = self._row(mover, base, point, normal, f"{self.name}: apart")
        tests = (Test(self.name, f"{words} are apart", row=parts),)
        apart = Mode("apart", f"{words} are apart", Facts(), tests, touching=Facts(rows=(parts,)))
        joining = Joining(self.name, mover, base, point, mover, Path(normal.turned(), 0))
        press = self._push("N", "normal", joining, normal)
        pressed = Test(self.name, f"{words} press on each other", ((press.name, 1),))
        mu = scene.value(self.mu) if self.mu is not None else 0
        if scene.is_zero(mu):
            slides = Facts((joining,), pushes=(press,))
            return (apart, Mode("slip", f"{words} stay in contact", slides, (pressed,)))
        return (apart, *self._rough(joining, press, pressed, mu, words))

    def residuals(self, scene: Any, mode: Mode) -> tuple[Residual, ...]:
        """Across the normal nothing is kept, along it the distance."""
        if mode.name == "apart":
            return ()
        mover, base, point, normal = self._place(scene)

        def apart(poses: Any) -> Vec:
            found: Vec = poses.point(mover, point) - poses.point(base, point)
            return found

        def distance(poses: Any) -> Any:
            return poses.change(apart(poses).dot(poses.direction(base, normal)))

        if mode.name == "stick":
            return (Residual(f"{self.name}: place", apart),)
        return (Residual(f"{self.name}: distance", distance),)

    def _place(self, scene: Scene) -> tuple[str, str, Vec, Vec]:
        """Who slides on whom, where, and the unit vector that pushes the first away from the second."""
        normal = None if self.normal is None else heading(scene, self.normal)
        meeting = meeting_of(scene, self.between, normal, self.mark)
        first, second = (partner_of(scene, name) for name in self.between)
        if first.particle and not (second.particle and first.body == GROUND):
            return first.body, second.body, meeting.point, -meeting.normal
        return second.body, first.body, meeting.point, meeting.normal

    def _rough(self, joining: Joining, press: Push, pressed: Test, mu: Any, words: str) -> Iterator[Mode]:
        assert joining.path is not None
        along = joining.path.tangent
        friction = self._push("F", "friction", joining, along)
        sliding = self._row(joining.mover, joining.base, joining.point, along, f"{words} do not slide on each other")
        within = tuple(
            Test(self.name, f"friction between {words} within its limit", ((press.name, mu), (friction.name, s)))
            for s in (-1, 1)
        )
        still = replace(joining, path=None)
        held = Facts((still,), pushes=(press, friction))
        yield Mode("stick", f"{words} stick together", held, (pressed, *within), sliding)
        for direction in (1, -1):
            slips = f"{words} slide on each other"
            moves = Test(self.name, f"{slips} as assumed", row=sliding, sense=direction, strict=True)
            law = (Law(friction.name, -direction * mu, press.name),)
            facts = Facts((joining,), pushes=(press, friction), laws=law)
            yield Mode("slip", slips, facts, (pressed, moves), sliding, direction)

    def _row(self, mover: str, base: str, point: Vec, along: Vec, title: str) -> Row:
        return Row(self.name, title, relative(mover, base, point, along))

    def _push(self, stem: str, kind: str, joining: Joining, along: Vec) -> Push:
        actions = opposed(joining.mover, joining.base, joining.point, along)
        return Push(f"{stem}_{self.name}", kind, self.name, joining.place, actions)


def lasting_from(problem: Problem, state: State) -> tuple[LastingContact, ...]:
    """The contacts that plastic impacts have left when a state has been reached, where no other joint joins them."""
    order = {s.name: i for i, s in enumerate(problem.states)}
    here = order.get(state.name, 0)
    struck = [i for i, s in enumerate(problem.states) if any(isinstance(r, JustAfter) for r in s.relations)]
    joined = [set(_partners(j)) for j in problem.joints if not j.strikes]
    last = problem.states[-1].name if problem.states else ""
    found = []
    for joint in problem.joints:
        if not joint.strikes or not _slides(problem, joint) or set(_partners(joint)) in joined:
            continue
        after = [order[joint.during[1]]] if joint.during is not None else struck
        begins = next((i for i in after if i <= here), None)
        if begins is not None:
            contact = LastingContact(
                name=joint.name,
                during=(problem.states[begins].name, last),
                mark=joint.mark,
                between=_partners(joint),
                normal=_side(joint, "normal"),
                mu=_side(joint, "mu"),
            )
            found.append(contact)
    return tuple(found)


def _partners(joint: Joint) -> tuple[str, ...]:
    found: tuple[str, ...] = getattr(joint, "between", ())
    return found


def _side(joint: Joint, key: str) -> Side | None:
    found: Side | None = getattr(joint, key, None)
    return found


def _slides(problem: Problem, joint: Joint) -> bool:
    """Is it plastic, between a particle and a particle, a straight line, or what it meets along a stated normal?"""
    said = _side(joint, "normal") is not None
    shapes = {b.name: isinstance(b.shape, Particle) or said for b in problem.bodies}
    shapes |= {s.name: isinstance(s.shape, Line) for s in problem.surfaces}
    particles = [b.name for b in problem.bodies if isinstance(b.shape, Particle)]
    straight = all(shapes.get(name, False) for name in _partners(joint))
    restitution = _side(joint, "restitution")
    if not straight or restitution is None or not any(n in particles for n in _partners(joint)):
        return False
    return KnownValues({g.name: g for g in problem.given}).value(restitution) == 0
