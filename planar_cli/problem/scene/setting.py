"""What joints and loads may ask of the scene when they state facts. The numbers are exact expressions in SI units."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any, Protocol

from planar_cli.errors import Mark
from planar_cli.problem.language.expression import Side, Statement
from planar_cli.problem.scene.facts import Meeting, Outline
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.keys import Table


class WrittenBody(Protocol):
    """A body as the file describes it."""

    @property
    def name(self) -> str: ...
    @property
    def mark(self) -> Mark: ...
    @property
    def is_round(self) -> bool: ...
    @property
    def is_disk(self) -> bool: ...
    @property
    def is_particle(self) -> bool: ...
    @property
    def hub_point(self) -> str | None: ...
    @property
    def is_massless(self) -> bool: ...
    @property
    def resists_turning(self) -> bool: ...


class WrittenScene(Protocol):
    """The scene as the file describes it, before any of it has a value."""

    @property
    def plane(self) -> str | None: ...
    @property
    def bodies(self) -> Sequence[WrittenBody]: ...


class Setting(Protocol):
    """The scene at one instant."""

    gravity: Any

    def point(self, name: str) -> Vec: ...
    def value(self, side: Side) -> Any: ...
    def unit(self, angle: Side) -> Vec: ...
    def length(self, v: Vec) -> Any: ...
    def reach_by_letter(self, reach: Vec, ends: tuple[str, str]) -> Any:
        """|r| from one point to another; a letter for it where both coordinates are letters with given values."""

    def direction(self, along: Side | str) -> Vec: ...
    def sign(self, expr: Any) -> int: ...
    def is_zero(self, expr: Any) -> bool:
        """Is it zero as drawn?"""

    def vanishes(self, expr: Any) -> bool:
        """Is it zero, and does it stay so wherever the scene may go? At one instant: is it zero?"""

    def carrier(self, partner: str) -> str: ...
    def spot(self, partner: str, point: Vec, during: tuple[str, str] | None) -> Vec:
        """Where a partner is touched by what is drawn at a point, by a joint that acts between these states."""

    def outline(self, partner: str, point: Vec, mark: Mark) -> Outline: ...
    def edges(self, body: str, point: Vec) -> list[Outline]: ...
    def rigid(self, body: str) -> bool: ...
    def owner(self, point: str, apart_from: str = "") -> str: ...
    @property
    def fixed(self) -> Collection[str]:
        """The points of bodies that joints keep in their places on the ground."""

    def center(self, body: str) -> Vec: ...
    def hub(self, body: str, point: Vec) -> Vec:
        """The centre of the rim through a point of a body, about which a cord there is wound."""

    def mass(self, body: str) -> Any: ...
    def center_name(self, body: str) -> str: ...
    def own_name(self, body: str) -> str:
        """The name of what its mass centre has alone, as an index."""

    def names_carrier(self, name: str) -> bool: ...
    def track(self, along: Side | str, point: Vec, mark: Mark) -> Outline:
        """What a point slides along there: a straight line, an arc or a curve, never a corner."""

    def drawn_by(self, body: str) -> Sequence[str]:
        """The points by which a body of no particular shape is drawn; of any other body none."""

    def pulley(self, stop: str) -> str: ...
    def heaviness(self, body: str) -> Any: ...
    def middle(self) -> Vec: ...
    def as_drawn(self, expr: Any) -> Any:
        """What varies, where the file draws it."""

    def radius(self, body: str) -> Any: ...
    def contacts(self, a: str, b: str) -> int: ...
    def pressed(self, joint: str) -> int:
        """On which side a contact presses that the drawing leaves open (Mode.side); 0: not known."""

    def faced(self, joint: str) -> int:
        """On which side such a contact is looked at first as drawn; 0: this is the drawing."""

    def came_from(self, joint: str, off: Any) -> Any:
        """+1 or -1: the side of a line, where `off` is positive or negative, from which a body has come to a contact;
        None: no motion tells it.
        """

    def root(self, square: Any) -> Any: ...
    def steady(self, direction: Vec) -> Vec | None:
        """A direction written with what moves, without it where it stays the same however things move."""

    def with_relations(self, relations: tuple[Statement, ...], expr: Any, ends: tuple[str, str]) -> Any: ...
    def refuse(self, mark: Mark, code: str, message: str, hint: str = "") -> Exception: ...


class MovingSetting(Setting, Protocol):
    """The scene once its velocities are known: what loads may ask."""

    def velocity(self, point: Vec, body: str) -> Vec: ...
    def turn(self, body: str) -> Any: ...
    def against(self, velocity: Vec, size: Any) -> Vec: ...
    def size(self, magnitude: Side | Table, mark: Mark) -> Any: ...
    def heading(self, angle: Any) -> Vec: ...
    def lettered_length(self, reach: Vec, name: str, words: str) -> Any: ...


class StruckSetting(Setting, Protocol):
    """The scene in a blow: bodies still have the velocities with which they arrive."""

    def arriving(self, point: Vec, body: str) -> Vec: ...
    def meeting(
        self,
        between: tuple[str, ...],
        normal: Side | None,
        mark: Mark,
        at: str = "",
        during: tuple[str, str] | None = None,
    ) -> Meeting: ...
    def unknown(self, name: str, unit: str) -> Any: ...
