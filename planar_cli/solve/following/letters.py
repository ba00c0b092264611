"""The letters of a regime for a state of the scene: its coordinates and free speeds, from where the bodies are."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from decimal import Decimal
from functools import cached_property

import sympy as sp

from planar_cli.equation.algebra.plain import derivative
from planar_cli.equation.kinematics.motion import Edge
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import NoValue
from planar_cli.motion.regime.model import Model
from planar_cli.motion.terms.dense import in_the_mean
from planar_cli.motion.terms.layout import Frame
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.scene import GROUND
from planar_cli.solve.between.roots.events import State
from planar_cli.solve.regimes.regime import Regime, number_function
from planar_cli.solve.regimes.speed_transfer import edges_of

ROUNDS = 40
"""Steps of Newton's method."""
CLOSE = 1e-14
"""A step below this part of the scale is the last."""
APART = 1e-6
"""Bodies that are off by more, in parts of the scale, are not where the regime can put them."""
FULL = 2 * math.pi


class Letters:
    """Reads the letters of one regime. `value`: numbers of everything that does not vary."""

    def __init__(self, regime: Regime, model: Model, value: Valuation) -> None:
        self.regime, self.model, self.value = regime, model, value
        self.layout = layout = model.layout
        self.half = layout.count
        self.scale = model.scale[: self.half]
        own = {*self.coordinates, regime.time}
        self.places = [(i, e) for i, e in self._places() if e.free_symbols & own]
        """What is compared: the number of a coordinate of the state, and the formula for it."""
        self.around = [layout.slots[i].kind == "theta" for i, _ in self.places]
        """Which of them count up to whole turns."""
        self.turns = [0.0] * len(self.places)
        """Whole turns of those that are counted, in the state beyond the letters."""

    def _places(self) -> Iterator[tuple[int, sp.Expr]]:
        """Where every body is, and coordinates of the file."""
        scene = self.regime.general.instant.scene
        for name, frame in self.layout.frames.items():
            body = scene.bodies[name]
            yield frame.x, self._in_letters(body.center.x)
            yield frame.y, self._in_letters(body.center.y)
            if frame.theta is not None:
                yield frame.theta, self._in_letters(body.theta)
        symbols = {s.name: s for s in self.coordinates}
        for name, (term, _) in self.model.scene.coordinates.items():
            if name in symbols and term in self.layout.numbers:
                yield self.layout.numbers[term], symbols[name]

    def _in_letters(self, place: sp.Expr) -> sp.Expr:
        """A place in t and coordinates that vary freely: one that `motion` gives as a function of time is no letter."""
        expr = sp.sympify(place)
        told = set(self.regime.general.instant.scene.ledger.coordinates) - set(self.coordinates)
        return self.regime.in_letters(expr) if expr.free_symbols & told else expr

    @property
    def coordinates(self) -> tuple[sp.Symbol, ...]:
        return tuple(c.symbol for c in self.regime.coordinates)

    @cached_property
    def _where(self) -> Callable[..., list[float]]:
        """The places, and their derivatives by each coordinate, row by row."""
        every = [e for _, e in self.places]
        slopes = [derivative(e, q) for e in every for q in self.coordinates]
        return self._numbers([*every, *slopes])

    @cached_property
    def _moving(self) -> Callable[..., list[float]]:
        """The velocities of the places."""
        return self._numbers([self.regime.derivative(e) for _, e in self.places])

    def _numbers(self, exprs: Sequence[sp.Expr]) -> Callable[..., list[float]]:
        return number_function(exprs, self.regime.letters, self.value)

    @staticmethod
    def exact(letters: Mapping[sp.Symbol, float]) -> dict[sp.Symbol, Decimal]:
        """Machine numbers as they stand."""
        return {s: Decimal(repr(float(v))) for s, v in letters.items()}

    def velocities(self, letters: Mapping[sp.Symbol, float]) -> dict[int, float]:
        """How fast the coordinates of the state change, by their numbers, where these are the letters."""
        found = self._moving(*(letters[s] for s in self.regime.letters))
        return {i: v for (i, _), v in zip(self.places, found, strict=True)}

    def recall(self, t: float) -> None:
        """Angles of the scene count their turns from what they were before a time."""
        self.model.recall(t)

    def at(self, t: float, y: Sequence[float], near: Mapping[sp.Symbol, float]) -> State:
        """The letters for a state. `near`: coordinates from which they are sought; angles keep the turns of these."""
        places = self._coordinates(t, y, [near[q] for q in self.coordinates])
        speeds = self._speeds(t, y, places)
        letters = self.regime.letters
        return dict(zip(letters, (t, *places, *speeds), strict=True))

    def turned_round(self, y: Sequence[float], letters: Mapping[sp.Symbol, float]) -> dict[str, int]:
        """Signs of speeds that a law gives by their size, where a state of the scene arrives the other way. `letters`:
        those of this state.
        """
        headed, coordinates = self.regime.general.instant.scene.headed, self.regime.coordinates
        if not headed or not coordinates or not self.places:
            return {}
        numbers = self._where(*(letters[s] for s in self.regime.letters))
        slopes, sizes = numbers[len(self.places) :], [self.scale[i] for i, _ in self.places]
        count, own = len(coordinates), self.velocities(letters)
        rows = [[x / s for x in slopes[k * count : (k + 1) * count]] for k, s in enumerate(sizes)]
        off = [(y[self.half + i] - own[i]) / s for (i, _), s in zip(self.places, sizes, strict=True)]
        rates = self._numbers([self.regime.rates[c.symbol] for c in coordinates])
        told = rates(*(letters[s] for s in self.regime.letters))
        found = {}
        for c, rate, missed in zip(coordinates, told, in_the_mean(rows, off), strict=True):
            for key, (way, speed) in headed.items():
                if c.speed == speed and rate * (rate + missed) < 0:
                    found[key] = -way
        return found

    def _coordinates(self, t: float, y: Sequence[float], found: list[float]) -> list[float]:
        count, still = len(found), [0.0] * len(self.regime.free)
        if not count:
            return found
        best, least = found, math.inf
        for _ in range(ROUNDS):
            numbers = self._where(t, *found, *still)
            off = self._off(y, numbers)
            sizes = [self.scale[i] for i, _ in self.places]
            error = max((abs(d) / s for d, s in zip(off, sizes, strict=True)), default=0.0)
            if error < least:
                best, least = found, error
            slopes = numbers[len(off) :]
            rows = [[x / s for x in slopes[k * count : (k + 1) * count]] for k, s in enumerate(sizes)]
            step = in_the_mean(rows, [d / s for d, s in zip(off, sizes, strict=True)])
            found = [q + d for q, d in zip(found, step, strict=True)]
            if all(abs(d) <= CLOSE * max(1.0, abs(q)) for d, q in zip(step, found, strict=True)):
                break
        if least > APART:
            raise NoValue(f"a regime does not put the bodies where they are ({least:.3g})")
        return best

    def _off(self, y: Sequence[float], numbers: Sequence[float]) -> list[float]:
        """By how much the places are missed."""
        found = [y[i] - v - turns for (i, _), v, turns in zip(self.places, numbers, self.turns, strict=False)]
        return [math.remainder(d, FULL) if around else d for d, around in zip(found, self.around, strict=True)]

    def count(self, t: float, y: Sequence[float], letters: Mapping[sp.Symbol, float]) -> None:
        """From here on, angles that grow with coordinates count their turns. `letters`: those of this state."""
        still = [0.0] * len(self.regime.free)
        numbers = self._where(t, *(letters[q] for q in self.coordinates), *still)
        for k, (i, expr) in enumerate(self.places):
            if self.layout.slots[i].kind == "theta" and not expr.has(sp.atan2, sp.atan, sp.asin, sp.acos):
                self.turns[k] = FULL * round((y[i] - numbers[k]) / FULL)
                self.around[k] = False

    def _speeds(self, t: float, y: Sequence[float], places: list[float]) -> list[float]:
        """Each free speed from the bodies that it belongs to."""
        free, still = self.regime.free, [0.0] * len(self.regime.free)
        if not free:
            return []
        where = iter(self._joined(t, *places, *still))
        found: dict[sp.Symbol, float] = {}
        for u, edge in self._edges.items():
            if u == edge.spin:
                found[u] = self._turning(edge.body, y) * edge.turn
            elif edge.joining is None:
                frame = self.layout.frames[edge.body]
                at, sense = (frame.x, edge.rightward) if u == edge.slide else (frame.y, edge.upward)
                found[u] = y[self.half + at] * sense
            else:
                found[u] = self._sliding(edge.joining, y, [next(where) for _ in range(8)])
        if len(found) < len(free):
            found = {**dict(zip(free, self._fitted(t, y, places), strict=True)), **found}
        return [found[u] for u in free]

    @cached_property
    def _edges(self) -> dict[sp.Symbol, Edge]:
        """The joints of the tree by the free speeds that are their own."""
        edges, frames = edges_of(self.regime.general.trial.system.tree), self.layout.frames
        own = {u: edges[u] for u in self.regime.free if u in edges}
        return {u: e for u, e in own.items() if e.body in frames and (u == e.spin or _is_along(e.joining, frames))}

    @cached_property
    def _joined(self) -> Callable[..., list[float]]:
        """Of every joint along which something slides: arms of the point, direction, drift."""
        scene = self.regime.general.instant.scene
        exprs: list[sp.Expr] = []
        for u, edge in self._edges.items():
            joining = edge.joining
            if u == edge.spin or joining is None:
                continue
            assert joining.path is not None
            for body in (joining.mover, joining.base):
                arm = joining.point - scene.bodies[body].center if body in self.layout.frames else joining.point
                exprs += [arm.x, arm.y]
            drift = joining.drift
            tangent = joining.path.tangent
            parts = [tangent.x, tangent.y, *((drift.x, drift.y) if drift is not None else (0, 0))]
            exprs += parts
        return self._numbers([self.regime.closed(sp.sympify(e)) for e in exprs])

    def _turning(self, body: str, y: Sequence[float]) -> float:
        frame = self.layout.frames.get(body)
        return 0.0 if frame is None or frame.theta is None else y[self.half + frame.theta]

    def _sliding(self, joining: Joining, y: Sequence[float], at: Sequence[float]) -> float:
        """The velocity of the mover's point over the base's, along the path."""
        relative = [-at[6], -at[7]]
        for body, sign, x, up in ((joining.mover, 1, at[0], at[1]), (joining.base, -1, at[2], at[3])):
            frame = self.layout.frames.get(body)
            if frame is not None:
                spin = self._turning(body, y)
                relative[0] += sign * (y[self.half + frame.x] - spin * up)
                relative[1] += sign * (y[self.half + frame.y] + spin * x)
        return relative[0] * at[4] + relative[1] * at[5]

    def _fitted(self, t: float, y: Sequence[float], places: list[float]) -> list[float]:
        """The free speeds that fit the velocities of all places best."""
        free = len(self.regime.free)
        still = self._moving(t, *places, *([0.0] * free))
        columns = []
        for k in range(free):
            one = [float(k == j) for j in range(free)]
            columns.append([a - b for a, b in zip(self._moving(t, *places, *one), still, strict=True)])
        wanted = [y[self.half + i] - b for (i, _), b in zip(self.places, still, strict=True)]
        sizes = [self.scale[i] for i, _ in self.places]
        rows = [[column[k] / s for column in columns] for k, s in enumerate(sizes)]
        return in_the_mean(rows, [w / s for w, s in zip(wanted, sizes, strict=True)])


def _is_along(joining: Joining | None, frames: Mapping[str, Frame]) -> bool:
    """Is what slides there told by the velocities of bodies?"""
    if joining is None:
        return True
    return joining.path is not None and all(b in frames or b == GROUND for b in (joining.mover, joining.base))
