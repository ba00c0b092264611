"""What a motion can not do, told by exceptions inside the engine; `follow` turns them into outcomes."""

from __future__ import annotations


class Singular(Exception):
    """The accelerations are not determined at this place; `joint` names where, "" if it can not be told."""

    def __init__(self, joint: str = "") -> None:
        self.joint = joint
        super().__init__(joint)
