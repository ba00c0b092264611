"""Impact of two bodies."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, ClassVar

from planar_cli.joints.base import Joint
from planar_cli.problem.language.expression import Number, Side
from planar_cli.problem.scene.facts import FAR, Facts, Law, Meeting, Mode, Push, Row, Test, opposed, relative
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.keys import PartnersKey, PointKey, SideKey, key
from planar_cli.problem.scene.residuals import Residual
from planar_cli.problem.scene.setting import Setting, StruckSetting


@dataclass(frozen=True, slots=True, kw_only=True)
class Impact(Joint):
    """Two bodies collide.

    Meaning
        Between the states of `during` (the second is `just after` the first) the two bodies strike each other; without
        `during` whenever they meet: in every blow in which they touch and approach, and on the way between states.
        Places that a motion or the state itself tells, and bodies that are drawn with their sizes, must touch; a
        particle may be drawn beside what it strikes. They meet where a particle is, where a round rim touches, or with
        the end of a rod or the corner of a plate: that which `at` names, else the nearest on which the body does not
        stand already. Elsewhere `at` is checked. `normal` is the direction of the
        common normal, an angle or one that is counted from that of a body, `theta(rod) + 90 deg`; it stands where the
        shapes leave it open (particles at one place, corners), and is checked where they do not. A fixed edge is a
        particle that is welded to the ground. `restitution` is the ratio of the speeds of separation and approach along
        it; left out, it is unknown, and something is stated of the velocities after it. `mu` adds a friction impulse;
        without it the impact is smooth. Several impacts in one blow happen at once, each with its own restitution:
        planar explain blows. After a plastic impact (`restitution: 0`) the bodies stay in contact as long as they press
        on each other; a `weld` that begins with the impact keeps them together for good. Two particles that would then
        slide along each other need it, for points have no faces.

    YAML
        title: Two balls collide head on
        plane: horizontal
        points: {A: [0, 0], B: [1 m, 0]}
        bodies:
          A: {particle: A, mass: 2 kg}
          B: {particle: B, mass: 1 kg}
        joints:
          - impact: {between: [A, B], normal: 0 deg, restitution: 0.8, during: 1->2}
        states:
          1: [v(A).x = 3 m/s, v(A).y = 0, B at rest]
          2: [just after 1]
        find: {v_A: v(A).x @ 2, v_B: v(B).x @ 2}

    Equations
        (v_B2 - v_A2) · n = -e (v_B1 - v_A1) · n, of the points that touch; equal and opposite impulses along n. Across
        it none, or a friction impulse: mu times the normal one against the sliding, or less where the points stick at
        the end.

    Signs
        `impulse(j/b) @ 1->2` is the impulse on b, a vector.

    Valid when
        The impact is so short that nothing moves meanwhile; 0 <= restitution <= 1.

    Reference
        An Introduction to Planar Dynamics, 3.7.1 (direct), 3.7.2 (oblique), 3.7.3 (with constraints), 4.6.
    """

    kind: ClassVar[str] = "impact"
    quantities: ClassVar[tuple[str, ...]] = ("N", "friction")
    strikes: ClassVar[bool] = True

    between: tuple[str, ...] = key(PartnersKey(), "the two bodies, or a body and a surface")
    at: str = key(PointKey(), "the point where they touch; left out where the shapes tell it", default="")
    normal: Side | None = key(SideKey("deg", angle=True, turns=True), "direction of the common normal", default=None)
    restitution: Side | None = key(SideKey("1"), "coefficient of restitution, 0 to 1; left out: unknown", default=None)
    mu: Side | None = key(SideKey("1"), "coefficient of friction during the impact", default=None)

    @property
    def open_name(self) -> str:
        """The name of the restitution where it is left out."""
        return f"e_{self.name}"

    def restitutes(self, scene: StruckSetting) -> Any:
        """The coefficient of restitution."""
        return scene.unknown(self.open_name, "1") if self.restitution is None else scene.value(self.restitution)

    def told(self, constants: Mapping[str, float]) -> Impact:
        """With the restitution that a blow has told."""
        if self.restitution is not None or self.open_name not in constants:
            return self
        return replace(self, restitution=Number(Fraction(constants[self.open_name]), None, 1, self.mark))

    def modes(self, scene: Setting) -> tuple[Mode, ...]:
        """Nothing: an impact acts only in the blow."""
        return (Mode("", "", Facts()),)

    def residuals(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        """None: an impact keeps no places."""
        return ()

    def blows(self, scene: StruckSetting) -> tuple[Mode, ...]:
        meeting = scene.meeting(self.between, self.normal, self.mark, self.at, self.during)
        a, b = (scene.carrier(p) for p in self.between)
        far = (Mode(FAR, f"{self.between[0]} and {self.between[1]} are apart", Facts()),) if self.during is None else ()
        if meeting.told:
            return (*self._hits(scene, a, b, meeting), self._missed(scene, a, b, meeting), *far)
        # What meets may come from either side: the one from which it presses.
        other = replace(meeting, normal=-meeting.normal)
        return (*self._hits(scene, a, b, meeting), *self._hits(scene, a, b, other), *far)

    def _hits(self, scene: StruckSetting, a: str, b: str, meeting: Meeting) -> list[Mode]:
        """They press on each other along this normal."""
        pushes = [self._push("N", "normal", a, b, meeting.point, meeting.normal)]
        rough = self.mu is not None and not scene.is_zero(scene.value(self.mu))
        if rough:
            pushes.append(self._push("F", "friction", a, b, meeting.point, meeting.normal.turned()))
        facts = Facts(rows=(self._rebound(scene, a, b, meeting),), pushes=tuple(pushes))
        pressed = (Test(self.name, f"N_{self.name} presses", ((f"N_{self.name}", 1),)),)
        return self._rough(scene, facts, pressed, a, b, meeting) if rough else [Mode("", "", facts, pressed)]

    def _push(self, stem: str, kind: str, a: str, b: str, point: Vec, along: Vec) -> Push:
        """On the second body along the direction, reversed on the first."""
        actions = opposed(b, a, point, along)
        return Push(f"{stem}_{self.name}", kind, self.name, self.at or self.name, actions)

    def _approach(self, scene: StruckSetting, a: str, b: str, meeting: Meeting) -> Any:
        """(v_b1 - v_a1) · n, negative where they approach."""
        return (scene.arriving(meeting.point, b) - scene.arriving(meeting.point, a)).dot(meeting.normal)

    def _apart(self, a: str, b: str, meeting: Meeting, along: Vec, title: str, pace: Any = 0) -> Row:
        pulls = relative(b, a, meeting.point, along)
        return Row(self.name, title, pulls, pace=pace)

    def _rebound(self, scene: StruckSetting, a: str, b: str, meeting: Meeting) -> Row:
        e = self.restitutes(scene)
        title = f"restitution between {self.between[0]} and {self.between[1]}, along the common normal"
        return self._apart(a, b, meeting, meeting.normal, title, -e * self._approach(scene, a, b, meeting))

    def _rough(
        self, scene: StruckSetting, facts: Facts, pressed: tuple[Test, ...], a: str, b: str, meeting: Meeting
    ) -> list[Mode]:
        """The touching points stick at the end of the blow, or still slide."""
        assert self.mu is not None
        mu, n, f = scene.value(self.mu), f"N_{self.name}", f"F_{self.name}"
        words = f"{self.between[0]} and {self.between[1]}"
        sliding = self._apart(a, b, meeting, meeting.normal.turned(), f"{words} do not slide on each other")
        within = tuple(Test(self.name, "friction impulse within its limit", ((n, mu), (f, s))) for s in (-1, 1))
        stuck = replace(facts, rows=(*facts.rows, sliding))
        found = [Mode("stick", f"{words} do not slide at the end of the blow", stuck, (*pressed, *within), sliding)]
        for direction in (1, -1):
            moves = Test(self.name, f"{words} slide as assumed", row=sliding, sense=direction)
            slipping = replace(facts, laws=(Law(f, -direction * mu, n),))
            found.append(
                Mode("slip", f"{words} slide throughout the blow", slipping, (*pressed, moves), sliding, direction)
            )
        return found

    def _missed(self, scene: StruckSetting, a: str, b: str, meeting: Meeting) -> Mode:
        """They do not approach, and part."""
        words = f"{self.between[0]} and {self.between[1]} do not approach each other"
        row = self._apart(a, b, meeting, meeting.normal, words)
        tests = (
            Test(self.name, words, (), self._approach(scene, a, b, meeting)),
            Test(self.name, words, row=row),
        )
        return Mode("apart", words, Facts(), tests)
