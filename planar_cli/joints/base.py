"""The contract of the shelf of joints.

A joint is what keeps bodies from moving freely past each other. A member is one file with one final class:

    @dataclass(frozen=True, slots=True, kw_only=True)
    class Pin(Joint):
        '''manual page: Meaning, YAML, Equations, Signs, Valid when, Reference'''

        kind: ClassVar[str] = "pin"
        at: str = key(PointKey(), "the common point")

The fields that every entry of a file has stand in `problem/scene/entry.py`.

What the rest of the program must know of a kind stands in class variables: `quantities` are words that may be asked of
it and not of every joint, `touches` and `unilateral` say how it meets its partner.

A member states facts only and does not import SymPy at module level, so that reading a file stays quick.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from planar_cli.errors import Diagnostic
from planar_cli.problem.scene.blows import in_a_blow
from planar_cli.problem.scene.entry import Entry
from planar_cli.problem.scene.facts import Mode
from planar_cli.problem.scene.residuals import Residual
from planar_cli.problem.scene.setting import Setting, StruckSetting, WrittenScene


@dataclass(frozen=True, slots=True, kw_only=True)
class Joint(Entry, ABC):
    """What every joint has beside its own keys; the module's docstring is the contract."""

    touches: ClassVar[bool] = False
    """Do two outlines touch at the point `at`, which then stays with the centres, not with a rim?"""
    guides: ClassVar[bool] = False
    """Does it keep a point of a body on a line, along which it may go on beyond a corner?"""
    unilateral: ClassVar[bool] = False
    """Does it press from one side alone, on which the body is drawn?"""

    @property
    def drawn_beside(self) -> bool:
        """Are its points drawn beside the lines on which it acts? The moments that this leaves go to what keeps the
        bodies on their ways, outside the scene.
        """
        return False

    def holder(self) -> str | None:
        """What holds the other partner where no key `between` names it: a body, a surface, the ground."""
        return None

    def fixes(self) -> str | None:
        """The name of the point of a body that it keeps in its place on the ground all the time."""
        return None

    def objections(self, scene: WrittenScene) -> Iterable[Diagnostic]:
        """What is wrong with it in this problem, beyond what its keys and names tell."""
        return ()

    def told(self, constants: Mapping[str, float]) -> Joint:
        """The joint with the constants that it leaves open and that a blow has told, by their names."""
        return self

    @abstractmethod
    def modes(self, scene: Setting) -> tuple[Mode, ...]:
        """The ways in which the joint may act, the natural assumption first; each with the facts that it states."""

    def blows(self, scene: StruckSetting) -> tuple[Mode, ...]:
        """The ways in which the joint may act in a blow: pushes are impulses, accelerations the velocities after it."""
        return tuple(in_a_blow(mode) for mode in self.modes(scene))

    def restitutes(self, scene: StruckSetting) -> Any:
        """By how much more slowly its partners part after a blow than they approached, 0 to 1; None: it tells none."""
        return None

    @abstractmethod
    def residuals(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        """The same joint once more, in one of its modes, as places that it keeps; written from geometry alone.

        The independent check differentiates these itself, so nothing in them may come from the facts of `modes`.
        """

    def presumes(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        """What it takes for granted of places, and no force of it keeps: that the parts of a rope stay parallel. The
        title tells of a residual that changes what it does then.
        """
        return ()


def distinct(joints: Sequence[Joint]) -> tuple[Joint, ...]:
    """Joints that share a name (both called by their point) are told apart by a number."""
    seen: dict[str, int] = {}
    found = []
    for joint in joints:
        seen[joint.name] = seen.get(joint.name, 0) + 1
        found.append(joint if seen[joint.name] == 1 else replace(joint, name=f"{joint.name}_{seen[joint.name]}"))
    return tuple(found)
