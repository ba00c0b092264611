"""Where a scene is in equilibrium whose first state says that it is, and not at which values of its coordinates.

Everything is drawn anew at trial values, as what is relaxed or just long enough as drawn goes with them; sought are
values at which the coordinates, at rest, have no accelerations. One coordinate is looked for wherever it may be: over
one turn, or from a hundredth to a hundred times the lengths of the file; of several places the file must choose one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise

from planar_cli.base_units import in_base
from planar_cli.errors import Diagnostic, FileProblem, Mark, NoSolution
from planar_cli.motion.regime.model import Model, always
from planar_cli.motion.scene.scene import MovingScene
from planar_cli.motion.start.start import start_of
from planar_cli.motion.terms.crossings import root
from planar_cli.motion.terms.source import compiled
from planar_cli.problem.checks.check_dimensions import Kinds
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.dimensions import dimension_of
from planar_cli.problem.language.expression import Equilibrium, Statement
from planar_cli.problem.scene.order_of_states import struck_at_once
from planar_cli.problem.scene.scene import Problem, Symbol
from planar_cli.units import LENGTH, parse_unit

PLACES = (0.01, 0.03, 0.1, 0.2, 0.35, 0.5, 0.7, 1.0, 1.4, 2.0, 3.0, 5.0, 10.0, 30.0, 100.0)
"""Where a length is looked for, either side of zero, in parts of the largest length that the file gives."""
TURN = 36
"""An angle is looked for at so many places of one turn."""
CLOSE = 1e-6
"""An acceleration below this part of its scale is none."""
SAME = 1e-6
"""Places nearer to each other than this part of their scale are one."""

Residual = Callable[[float], float]


def in_equilibrium(problem: Problem, values: Mapping[str, float]) -> Mapping[str, float]:
    """The values, and those of the coordinates that only the equilibrium of the first state tells."""
    statement = next((s for s in _first(problem) if isinstance(s, Equilibrium) and s.body is None), None)
    if statement is None:
        return values
    scene = MovingScene(problem, values)
    open_ones = [c for c in problem.coordinates if c.name in scene.reference.open]
    if len(open_ones) != 1:
        # None, or what start_of refuses by name.
        return values
    return {**values, open_ones[0].name: _Search(problem, values, open_ones[0], statement.mark).place(scene)}


def _first(problem: Problem) -> Sequence[Statement]:
    """What the file says of its beginning."""
    if problem.instant is not None:
        return problem.instant
    return problem.states[0].relations if problem.states else ()


class _Search:
    """Looks for one coordinate."""

    def __init__(self, problem: Problem, values: Mapping[str, float], sought: Symbol, mark: Mark) -> None:
        self.problem, self.values, self.sought, self.mark = problem, values, sought, mark
        self.angle = sought.unit is not None and parse_unit(sought.unit).angle
        self._known: dict[float, float] = {}

    def place(self, scene: MovingScene) -> float:
        """The only value at which there is equilibrium."""
        size = 1.0 if self.angle else self._length(scene)
        tried = [(x, self.acceleration(x)) for x in self._places(size)]
        found: list[float] = []
        for (a, at_a), (b, at_b) in pairwise(tried):
            if math.isnan(at_a) or math.isnan(at_b):
                continue
            if at_a == 0 or (at_a > 0) != (at_b > 0):
                x = a if at_a == 0 else root(self.acceleration, a, b)
                real = abs(self.acceleration(x)) <= CLOSE * max(abs(at_a), abs(at_b))
                if real and not any(abs(x - y) <= SAME * size for y in found):
                    found.append(x)
        if len(found) == 1:
            return found[0]
        name = self.sought.name
        if not found:
            text = f"no place of equilibrium was found for {name}"
            raise NoSolution([Diagnostic(self.mark, "PL704", text, f"give {name} in the first state")])
        unit = parse_unit(self.sought.unit or "1")
        factor = in_base(unit, self.problem.us)
        told = [x / factor if abs(x) > SAME * size else 0.0 for x in found[:4]]
        shown = ", ".join(f"{x:.6g} {unit.text}" for x in told)
        text = f"there is equilibrium at several values of {name}: {shown}{' …' if len(found) > 4 else ''}"
        raise FileProblem([Diagnostic(self.mark, "PL704", text, f"choose one: `{name} > …`")])

    def acceleration(self, value: float) -> float:
        """Of the coordinate, at rest there; nan where the file excludes the place."""
        if value not in self._known:
            self._known[value] = self._accelerated(value)
        return self._known[value]

    def _accelerated(self, value: float) -> float:
        scene = MovingScene(self.problem, {**self.values, self.sought.name: value})
        lasting = not struck_at_once(self.problem.states)
        model = Model(
            scene, lambda m: always(m) or (lasting and not m.strikes and self.problem.holds_at_first(m.during))
        )
        try:
            start = start_of(model)
        except NoSolution:
            # An inequality, or another relation, of the first state does not hold there.
            return math.nan
        layout, asked = model.layout, model.asked
        rate = asked.quantities.rate(scene.coordinates[self.sought.name][1])
        accelerations = model.regime().rates(start.time, start.state)[layout.count :]
        code = compiled([rate], [*layout.state, *asked.accelerations], layout.time)
        (found,) = code.function(start.time, [*start.state, *accelerations])
        return found if math.isfinite(found) else math.nan

    def _places(self, size: float) -> Iterator[float]:
        """Where to look, in order."""
        if self.angle:
            # Not at the right angles, where accelerations may vanish or be infinite by symmetry alone.
            yield from (math.tau * (k + 0.37) / TURN - math.pi for k in range(TURN + 1))
        else:
            yield from (-size * x for x in reversed(PLACES))
            yield from (size * x for x in PLACES)

    def _length(self, scene: MovingScene) -> float:
        """The largest length that the file gives [m]."""
        kinds = Kinds(Scope(self.problem, ()))
        found = [
            abs(scene.sides.value(s.value).value)
            for s in self.problem.given
            if s.value is not None and dimension_of(s.value, kinds.of).dimension == LENGTH
        ]
        return max(found, default=0.0) or scene.extent
