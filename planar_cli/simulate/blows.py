"""What impacts add to quantities over a span: impulses, their work, and the heat that is lost.

The work of an impulse is J · (v_1 + v_2)/2, with the velocities just before and just after.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from planar_cli.errors import Mark
from planar_cli.motion.terms.terms import evaluate
from planar_cli.motion.trajectory.trajectory import Trajectory, Transition
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.expression import JustAfter, Quantity
from planar_cli.simulate.measures import Measures

HERE = Mark("<span>", 1, 1)


class Blows:
    """The impacts of one trajectory."""

    def __init__(self, measures: Measures, trajectory: Trajectory, scope: Scope) -> None:
        self.measures, self.trajectory, self.scope = measures, trajectory, scope
        self.layout = measures.model.layout

    def between(self, q: Quantity) -> Iterator[Transition]:
        """The impacts between the two states of a span. At their very time the velocities tell."""
        first, last = (self.measures.moments[s] for s in q.at or ())
        states = {s.name: s.relations for s in self.measures.model.scene.problem.states}
        after = any(isinstance(r, JustAfter) for r in states[(q.at or ("",))[-1]])
        begun = False
        for x in self.trajectory.transitions:
            if x.kind != "impact" or x.t < first.t:
                continue
            begun = begun or x.t > first.t or x.before == first.y
            arrived = x.t == last.t and x.before == last.y
            if x.t > last.t or (arrived and not (after and x.after == last.y)):
                return
            if begun:
                yield x

    def impulse(self, q: Quantity, about: str | None, x: Transition) -> list[float]:
        """What the joint or load named, or all forces on a body, give in one impact: on a body, or about a point."""
        # On a body only what a joint or load gives is told, also where that is called by another body.
        whole = self._owned(q.things[0]) and (len(q.things) == 1 or about is not None)
        change = self._given(q.things[0], x, whole)
        if whole:
            chosen = self._bodies(q.things[0])
        else:
            moved = [b for b in self.layout.frames if any(change[i] for i in self._numbers(b))]
            named = q.things[1] if len(q.things) == 2 and about is None else next(iter(moved), "")
            chosen = moved if about is not None else [named]
        parts = [self._parts(change, b, x, about) for b in chosen if b in self.layout.frames]
        return [sum(column) for column in zip(*parts, strict=True)] or [0.0, 0.0][: 1 if about else 2]

    def work(self, q: Quantity, x: Transition) -> float:
        """The work of a load or joint (`/b`: on b alone), of all forces on a body, or of everything [J]."""
        change = self._given(q.things[0], x, self._owned(q.things[0]) and len(q.things) == 1)
        bodies = [q.things[1]] if len(q.things) == 2 else self._bodies(q.things[0])
        return self._worked(change, [i for b in bodies for i in self._numbers(b)], x)

    def heat(self, q: Quantity, x: Transition) -> float:
        """What a joint, or all of them, take [J]."""
        name = q.things[0]
        joints = [j.name for j in self.measures.model.scene.problem.joints]
        keys = {key for j in (joints if name == "all" else [name]) for key in self._pressing(j, x)}
        every = range(self.layout.count)
        return -sum(self._worked(x.given[key], every, x) for key in sorted(keys))

    # --- parts -------------------------------------------------------------------------------------------------------

    def _owned(self, name: str) -> bool:
        """Is it a body, or everything, all forces on which are meant?"""
        return name == "all" or name in self.layout.frames

    def _bodies(self, name: str) -> list[str]:
        return [name] if name in self.layout.frames else list(self.layout.frames)

    def _given(self, name: str, x: Transition, whole: bool) -> Sequence[float]:
        """The change of the momentum that belongs to each velocity: all of it, or what a joint or load gives."""
        half = self.layout.count
        if whole:
            masses = evaluate([s.mass for s in self.layout.slots], self.layout.values(x.t, x.before))
            return [m * (a - b) for m, a, b in zip(masses, x.after[half:], x.before[half:], strict=True)]
        given = [x.given[key] for key in self._pressing(name, x)]
        return [sum(column) for column in zip(*given, strict=True)] or [0.0] * half

    def _pressing(self, name: str, x: Transition) -> list[str]:
        """Who gives it: the joint, each place where an impact strikes, or the contact through which it acts."""
        joints = self.measures.model.scene.problem.joints
        own = [key for key in x.given if key == name or key.rpartition("_")[0] == name]
        partners = [set(getattr(j, "between", ())) for j in joints if j.name == name and j.strikes]
        if own or not partners:
            return own
        return [j.name for j in joints if j.name in x.given and set(getattr(j, "between", ())) in partners][:1]

    def _worked(self, change: Sequence[float], numbers: Sequence[int], x: Transition) -> float:
        half = self.layout.count
        return sum(change[i] * (x.before[half + i] + x.after[half + i]) / 2 for i in numbers)

    def _numbers(self, body: str) -> list[int]:
        frame = self.layout.frames.get(body)
        return [] if frame is None else [n for n in (frame.x, frame.y, frame.theta) if n is not None]

    def _parts(self, change: Sequence[float], body: str, x: Transition, about: str | None) -> list[float]:
        frame = self.layout.frames[body]
        if about is None:
            return [change[frame.x], change[frame.y]]
        moment = next(m for m in self.measures.moments.values() if m.t <= x.t)
        there = Quantity("r", (about,), None, (), None, HERE)
        px, py = self.measures.function(there, moment.regime)(x.t, x.before)
        turning = 0.0 if frame.theta is None else change[frame.theta]
        return [turning + (x.before[frame.x] - px) * change[frame.y] - (x.before[frame.y] - py) * change[frame.x]]
