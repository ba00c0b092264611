"""Which finite forces have no impulse to speak of in a blow: those that act then on the bodies that are drawn."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

import sympy as sp

from planar_cli.equation.system.two_force import acts_on
from planar_cli.loads.base import Load
from planar_cli.problem.language.expression import Name as Letter
from planar_cli.problem.scene.acting import acting_loads
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import record
from planar_cli.report.document.blocks import Forces, Line, Name, Text, line
from planar_cli.solve.solution import InstantSolution

UNCOUNTED = ("drag",)
"""Kinds of loads that have no plural."""
FORCE = "force"
"""The kind of load that is called by its letter, as in the diagrams."""
ROUGH = ("contact",)
"""Kinds of joints whose friction grows with what presses."""
NOT_LEVEL = "↑↓↖↗↘↙↺↻"
"""The arrows of what is not horizontal."""


@record
class FiniteForces:
    """The finite forces of a problem; `states`: its states in their order."""

    problem: Problem
    states: tuple[str, ...]

    def beside(self, since: str, struck: InstantSolution, nil: Collection[sp.Symbol], rows: Sequence[Forces]) -> Line:
        """` (the impulses of the weights, the spring and R are negligible)` in the blow after a state; () where no
        finite force acts then. `nil`: the impulses that are zero, as those of a contact on which nothing presses;
        `rows`: the diagrams of the blow; where all in them is horizontal, weights are no matter.
        """
        scene, bodies = struck.instant.scene, [row.body for row in rows]
        level = not any(arrow in _said(row) for row in rows for arrow in NOT_LEVEL)
        counts: dict[str, int] = {}
        letters: list[str] = []
        for load in acting_loads(self.problem):
            finite = type(load).impulses is Load.impulses and self._acts(load.during, since)
            absent = load.kind == "weight" and (level or self.problem.plane != "vertical")
            if absent or not finite or not acts_on(load, scene, bodies):
                continue
            if letter := _letter(load):
                letters.append(letter)
            else:
                counts[load.kind] = counts.get(load.kind, 0) + 1
        letters += self._friction(since, bodies)
        named = [line(f"the {kind}{'s' if n > 1 and kind not in UNCOUNTED else ''}") for kind, n in counts.items()]
        named += [line(Name(letter)) for letter in dict.fromkeys(letters)]
        named += _contacts(struck, nil, bodies)
        one, many = (" (the impulse of ", " is negligible)"), (" (the impulses of ", " are negligible)")
        begin, end = many if len(named) > 1 else one
        return line(begin, *_listed(named), end) if named else ()

    def _acts(self, during: tuple[str, str] | None, since: str) -> bool:
        """Does something act in the blow after a state, or from that blow on?"""
        if during is None or since not in self.states:
            return True
        at = self.states.index(since)
        return during[0] in self.states[: at + 2] and during[1] not in self.states[: at + 1]

    def _friction(self, since: str, bodies: Collection[str]) -> Iterator[str]:
        """The letters of friction of a fixed size: that of a pressure grows with the blow."""
        for joint in self.problem.joints:
            size = getattr(joint, "friction", None)
            touched = set(getattr(joint, "between", ())) & set(bodies)
            if isinstance(size, Letter) and touched and self._acts(joint.during, since):
                yield size.name


def _contacts(struck: InstantSolution, nil: Collection[sp.Symbol], bodies: Collection[str]) -> list[Line]:
    """The forces of rough contacts that keep what they are in the blow: the normal force and the friction at C."""
    system = struck.trial.system
    assert system.reactions is not None
    rough = {j.name for j in system.scene.problem.joints if j.kind in ROUGH and getattr(j, "mu", None) is not None}
    own = (p for p, e in system.reactions.pushes if p.kind == "normal" and p.joint in rough and e in nil)
    named = (p.place for p in own if any(a.body in bodies for a in p.actions))
    places = dict.fromkeys(named)
    return [force for p in places for force in (line("the normal force"), line("the friction at ", Name(p)))]


def _said(row: Forces) -> str:
    """The words and arrows of a diagram."""
    return "".join(p.text for p in (*row.left, *row.right) if isinstance(p, Text))


def _listed(named: Sequence[Line]) -> Line:
    last = len(named) - 1
    return line(*(p for i, n in enumerate(named) for p in (" and " if i == last else ", ", *n)[i == 0 :]))


def _letter(load: Load) -> str:
    """The letter of the magnitude of a force, else the name that the author gave it; "": it has neither."""
    if load.kind != FORCE:
        return ""
    magnitude = getattr(load, "magnitude", None)
    if isinstance(magnitude, Letter):
        return magnitude.name
    return "" if load.name in (getattr(load, "body", ""), getattr(load, "at", ""), FORCE) else load.name
