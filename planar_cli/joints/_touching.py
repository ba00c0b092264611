"""The modes of a contact: smooth or rough; at a corner, a round rim, or a whole face that may tip."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from planar_cli.errors import Mark
from planar_cli.joints._tangency import (
    away,
    away_from_base,
    beyond_the_line,
    demand_above,
    demand_common_tangent,
    middle_of,
)
from planar_cli.problem.scene.facts import (
    Facts,
    Joining,
    Law,
    Mode,
    Outline,
    Path,
    Push,
    Rolling,
    Row,
    Test,
    center_of,
    opposed,
    relative,
)
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.outlines import demand_there, meeting_place
from planar_cli.problem.scene.setting import Setting
from planar_cli.records import record


@record
class ContactPlace:
    """Where a contact is and between whom, as the file names it."""

    name: str
    """The joint's name."""
    between: tuple[str, ...]
    """The two partners: bodies, or a body and a surface."""
    at: str
    """The point where they touch."""
    mark: Mark
    """The place of the entry in the file."""
    during: tuple[str, str] | None = None
    """The states between which it acts; None: always."""


@record
class Friction:
    """What a contact resists sliding with; None: not given."""

    static: Any = None
    """The coefficient of static friction, dimensionless."""
    kinetic: Any = None
    """The coefficient of kinetic friction, dimensionless."""
    limit: Any = None
    """The largest friction force whatever the normal force, N."""


class Touching:
    """One contact: who slides on whom, the normal that pushes the mover away, and all modes that may be."""

    def __init__(self, contact: ContactPlace, scene: Setting, friction: Friction) -> None:
        self.contact, self.scene = contact, scene
        self.static, self.kinetic, self.limit = friction.static, friction.kinetic, friction.limit
        self.name, self.place = contact.name, meeting_place(scene, contact.between, contact.at)
        demand_there(scene, contact.between, contact.at, contact.mark)
        self.mover, self.base = self._roles()
        tangent = self.base.tangent or Vec(1, 0)
        left = tangent.turned()
        self.left = left
        self._face((scene.faced(self.name) if self.either_side else 0) or self._outward(left))
        demand_above(self.base, self.normal, contact.between, contact.at, scene, contact.mark)
        self.words = f"{self.mover.body} at {contact.at}"

    def _face(self, outward: Any) -> None:
        """Let the mover be on the left (+1) or right (-1) of the base's tangent."""
        self.outward = outward
        self.normal = self.left * outward
        self.tangent = -self.normal.turned()

    @property
    def either_side(self) -> bool:
        """A particle drawn on a circle, fixed or on a body, may be inside or outside, one that comes to a line later on
        above or below: the side on which it presses counts.
        """
        if self.mover.kind != "corner" or self.scene.rigid(self.mover.body):
            return False
        if self.base.kind == "arc":
            return self.base.center is not None and self.base.body not in self.contact.between
        later = self.contact.during is not None and self.base.on_line is not None
        return later and not self.scene.is_zero(self.scene.as_drawn(self._off_line()))

    def _off_line(self) -> Any:
        """How far the mover is to the left of the line."""
        assert self.base.on_line is not None, "only a straight surface has a line"
        return (self.scene.center(self.mover.body) - self.base.on_line).dot(self.left)

    @property
    def smooth(self) -> bool:
        return self.limit is None and (self.static is None or self.scene.is_zero(self.static))

    @property
    def face(self) -> bool:
        return self.mover.kind == "straight" and self.base.kind == "straight"

    def _roles(self) -> tuple[Outline, Outline]:
        """Mover and base: a corner or rim slides on the other outline; of two rims, the moving one on the fixed one."""
        scene, contact = self.scene, self.contact
        spots = [(p, scene.spot(p, self.place, contact.during)) for p in contact.between]
        a, b = (scene.outline(p, spot, contact.mark) for p, spot in spots)
        demand_common_tangent(contact.between, contact.at, a, b, scene, contact.mark)
        if (
            a.body == "ground"
            or (b.kind == "corner" and a.kind != "corner")
            or (a.kind == "straight" and b.kind == "arc")
        ):
            a, b = b, a
        if a.kind == "corner" and b.kind != "corner" and scene.contacts(*contact.between) == 1:
            a = self._flush_edge(a, b)
        both_straight = a.kind == "straight" and b.kind == "straight"
        if both_straight and (not self._parallel(a, b) or scene.contacts(*contact.between) > 1):
            a = replace(a, kind="corner", tangent=None)
        if a.kind == b.kind == "corner":
            raise scene.refuse(
                contact.mark,
                "PL527",
                f"{self.name}: two corners touch, the direction of the contact is open",
                "contact needs a rim, an edge or a surface on one side",
            )
        if a.body == "ground":
            a, b = b, a
        return a, b

    def _flush_edge(self, corner: Outline, base: Outline) -> Outline:
        """The edge that lies flush on the base when the contact is named at its corner."""
        for edge in self.scene.edges(corner.body, self.place):
            if base.kind == "straight" and self._parallel(edge, base):
                return edge
        return corner

    def _parallel(self, a: Outline, b: Outline) -> bool:
        """Do two straight edges run along the same line?"""
        return a.tangent is not None and b.tangent is not None and self.scene.is_zero(a.tangent.cross(b.tangent))

    def _outward(self, left: Vec) -> int:
        """+1 when the mover is on the left of the base's tangent.

        By their shapes, else by where most of the mover is, else by that of its partner, else upward. A particle as
        high as the centre of a circle is inside: where nothing presses it will press there, and not outside.
        """
        scene, place = self.scene, self.place
        shapes, center = away(self.mover, self.base, place, scene), middle_of(self.mover.body, scene) - place
        inward = self.base.center - place if self.either_side and self.base.center is not None else Vec(0, 0)
        later = beyond_the_line(self.base, place, scene.center(self.mover.body), left, scene)
        # The rest of the drawing tells it last of all, as it was drawn: later on things move to the other side.
        rest = scene.middle() - place
        drawn = Vec(scene.as_drawn(rest.x), scene.as_drawn(rest.y))
        for towards in (
            later,
            shapes,
            center,
            away_from_base(self.base, self.contact.between, place, scene),
            Vec(0, 1),
            inward,
            drawn,
        ):
            side = scene.sign(towards.dot(left))
            if side:
                return side
        return 1

    # --- the relative motion -----------------------------------------------------------------------------------------

    def _sliding_joining(self) -> Joining:
        """The mover's corner, centre or face slides along the outline of the base (or a curve parallel to it).

        Where a straight edge slides over a fixed rim, it is the rim's centre that slides along the edge.
        """
        center = center_of(self.base, self.place)
        if self.mover.kind == "straight" and self.base.kind == "arc" and center is not None:
            path, place = Path(-self.tangent, 0), self.base.center_name or self.contact.at
            return Joining(self.name, self.base.body, self.mover.body, center, place, path)
        point, place, curvature = self.place, self.contact.at, self._base_curvature()
        if self.mover.kind == "arc" and self.mover.center is not None:
            point, place = self.mover.center, self.mover.center_name
            # As high as the radius, in letters that no root of a sum of squares hides.
            sense = self.scene.sign((point - self.place).dot(self.normal) * self.mover.curvature)
            curvature = curvature / (1 - curvature * sense / self.mover.curvature)
        return Joining(
            self.name,
            self.mover.body,
            self.base.body,
            point,
            place,
            Path(self.tangent, curvature),
            turns=not self.face,
            keeps=self.face,
        )

    def _base_curvature(self) -> Any:
        """The base's curvature along our tangent (which may run the other way)."""
        return self.base.curvature * self._same(self.base)

    def _same(self, outline: Outline) -> int:
        return self.scene.sign(outline.tangent.dot(self.tangent)) if outline.tangent is not None else 1

    def _sticking_joining(self) -> Joining:
        drift = self.base.drift
        joining = Joining(
            self.name,
            self.mover.body,
            self.base.body,
            self.place,
            self.contact.at,
            turns=not self.face,
            drift=drift,
            keeps=self.face,
        )
        if "arc" in (self.mover.kind, self.base.kind) and self.mover.kind != "corner":
            rolling = Rolling(self.tangent, self.mover.curvature * self._same(self.mover), self._base_curvature())
            joining = replace(joining, rolling=rolling)
        return joining

    def _sliding(self, point: Vec) -> Row:
        drift = self.base.drift
        pulls = relative(self.mover.body, self.base.body, point, self.tangent)
        rate = drift.dot(self.tangent) if drift is not None else 0
        return Row(self.name, f"{self.words} does not slip", pulls, rate=rate)

    # --- pushes ------------------------------------------------------------------------------------------------------

    def _pushes(self, point: Vec, with_couple: bool) -> tuple[Push, ...]:
        found = [self._push("N", "normal", point, self.normal)]
        if not self.smooth:
            found.append(self._push("F", "friction", point, self.tangent))
        if with_couple and self.scene.rigid(self.mover.body):
            actions = opposed(self.mover.body, self.base.body, point, None, 1)
            found.append(Push(f"M_{self.name}", "couple", self.name, self.contact.at, actions, "N*m"))
        return tuple(found)

    def _push(self, stem: str, kind: str, point: Vec, direction: Vec) -> Push:
        actions = opposed(self.mover.body, self.base.body, point, direction)
        return Push(f"{stem}_{self.name}", kind, self.name, self.contact.at, actions)

    def _law(self, direction: int) -> tuple[Law, ...]:
        if self.smooth:
            return ()
        if self.limit is not None:
            return (Law(f"F_{self.name}", -direction * self.limit, None),)
        return (Law(f"F_{self.name}", -direction * self.kinetic, f"N_{self.name}"),)

    # --- tests -------------------------------------------------------------------------------------------------------

    def _pressed(self) -> Test:
        return Test(self.name, f"N_{self.name} presses", ((f"N_{self.name}", 1),))

    def _within(self) -> tuple[Test, ...]:
        """|F| ≤ mu_s N, or ≤ the fixed limit."""
        words = f"friction at {self.contact.at} within its limit"
        if self.limit is not None:
            return tuple(Test(self.name, words, ((f"F_{self.name}", s),), self.limit) for s in (-1, 1))
        return tuple(Test(self.name, words, ((f"N_{self.name}", self.static), (f"F_{self.name}", s))) for s in (-1, 1))

    def _inside(self) -> tuple[Test, ...]:
        """The resultant stays within the face: x N = M with -behind ≤ x ≤ ahead (t × n = 1)."""
        extent = self._extent()
        if not self.face or extent is None or not self.scene.rigid(self.mover.body):
            return ()
        n, m = f"N_{self.name}", f"M_{self.name}"
        words = f"the normal force at {self.contact.at} acts inside the face"
        return (Test(self.name, words, ((n, extent[1]), (m, -1))), Test(self.name, words, ((n, extent[0]), (m, 1))))

    def _extent(self) -> tuple[Any, Any] | None:
        """Distances from the point to the ends of the common face, behind and ahead along our tangent."""
        found: list[tuple[Any, Any]] = []
        for outline in (self.mover, self.base):
            if outline.extent is not None:
                behind, ahead = outline.extent
                found.append((behind, ahead) if self._same(outline) > 0 else (ahead, behind))
        if not found:
            return None
        if len(found) == 1:
            return found[0]
        shorter = [one if self.scene.sign(other - one) >= 0 else other for one, other in zip(*found, strict=True)]
        return shorter[0], shorter[1]

    # --- modes -------------------------------------------------------------------------------------------------------

    def modes(self) -> tuple[Mode, ...]:
        if not self.either_side:
            return (*self._pressing(), self._apart())
        told = self.scene.pressed(self.name)
        sides = (told,) if told else (self.outward, -self.outward)
        found = []
        came = None if self.base.kind == "arc" else self.scene.came_from(self.name, self._off_line())
        for side in sides:
            self._face(side)
            # What comes to a line presses on the side from which it has come, where a motion tells that.
            words = f"{self.words} comes from that side"
            there = () if came is None else (Test(self.name, words, (), side * came, strict=True),)
            found += [replace(m, side=side, where=self._where(), tests=(*there, *m.tests)) for m in self._pressing()]
        self._face(sides[0] if came is None else came)
        return (*found, self._apart())

    def _where(self) -> str:
        """On which side of the circle, by its name in the file; of a line nothing is said."""
        if self.base.center is None:
            return ""
        inside = self.scene.sign((self.base.center - self.place).dot(self.normal)) > 0
        return f"{'inside' if inside else 'outside'} {next(p for p in self.contact.between if p != self.mover.body)}"

    def _pressing(self) -> list[Mode]:
        stick = [] if self.smooth else [self._stick()]
        return [*stick, *self._slips(), *(self._tips() if self.face else [])]

    def _stick(self) -> Mode:
        joining = self._sticking_joining()
        words = f"{self.words} rolls without slipping" if joining.rolling else f"{self.words} does not slip"
        facts = Facts((joining,), pushes=self._pushes(self.place, self.face))
        return Mode(
            "stick", words, facts, (self._pressed(), *self._within(), *self._inside()), self._sliding(self.place)
        )

    def _slips(self) -> list[Mode]:
        joining, sliding = self._sliding_joining(), self._sliding(self.place)
        pushes = self._pushes(self.place, self.face)
        if self.smooth:
            facts = Facts((joining,), pushes=pushes)
            return [Mode("slip", f"{self.words} stays in contact", facts, (self._pressed(), *self._inside()))]
        found = []
        for direction in (1, -1):
            moves = Test(self.name, f"{self.words} slips as assumed", row=sliding, sense=direction, strict=True)
            facts = Facts((joining,), (), pushes, self._law(direction))
            found.append(
                Mode(
                    "slip", f"{self.words} slips", facts, (self._pressed(), moves, *self._inside()), sliding, direction
                )
            )
        return found

    def _tips(self) -> list[Mode]:
        """The face lifts, all but its corner ahead or behind."""
        extent = self._extent()
        if extent is None or not self.scene.rigid(self.mover.body):
            return []
        found = []
        # The point at which the file lets them touch is no corner.
        touching, at = Facts((self._sliding_joining(),)), f"{self.contact.at}_edge"
        for end, distance in ((1, extent[1]), (-1, -extent[0])):
            corner = self.place + self.tangent * distance
            lifts = Row(self.name, f"{self.words} tips", spins=((self.mover.body, -end), (self.base.body, end)))
            opens = Test(self.name, f"{self.words} tips as assumed", row=lifts, strict=True)
            pushes, sliding = self._pushes(corner, False), self._sliding(corner)
            if not self.smooth:
                joining = Joining(self.name, self.mover.body, self.base.body, corner, at, drift=self.base.drift)
                tests = (self._pressed(), *self._within(), opens)
                found.append(
                    Mode(
                        "tip",
                        f"{self.words} tips about its edge",
                        Facts((joining,), pushes=pushes),
                        tests,
                        sliding,
                        touching=touching,
                    )
                )
            joining = Joining(self.name, self.mover.body, self.base.body, corner, at, Path(self.tangent, 0))
            for direction in (1, -1) if not self.smooth else (0,):
                moves = Test(self.name, f"{self.words} slips as assumed", row=sliding, sense=direction, strict=True)
                tests = (self._pressed(), opens, *((moves,) if direction else ()))
                facts = Facts((joining,), (), pushes, self._law(direction) if direction else ())
                found.append(
                    Mode(
                        "tip",
                        f"{self.words} tips and slips",
                        facts,
                        tests,
                        sliding if direction else None,
                        direction,
                        touching,
                    )
                )
        return found

    def _apart(self) -> Mode:
        # A fixed limit of friction acts as long as they touch, pressed or not.
        grips = self.limit is not None
        words = f"{self.words} does not press into its partner"
        parts = Test(self.name, words, joining=self._sliding_joining(), strict=grips)
        return Mode("apart", f"{self.words} lifts off", Facts(), (parts,), touching=Facts((self._sliding_joining(),)))
