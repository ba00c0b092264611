"""What the integrators of SciPy share, an extra to compare with: `pip install 'planar-cli[peers]'`."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from importlib.util import find_spec
from typing import Any, ClassVar

from planar_cli.errors import PlanarError
from planar_cli.integrators.base import EPSILON, Integrator, Rates, Setting, Step, StepTooSmall, Vector

SMALLEST = 100 * EPSILON
"""The relative tolerance of all of them: tolerances here are those of the scales, but they allow no smaller one."""


class FromSciPy(Integrator):
    """A method of scipy.integrate, with the tolerance of each component as its absolute one."""

    adaptive: ClassVar[bool] = True
    peer: ClassVar[str] = "scipy"
    method: ClassVar[str]
    """The name of its class in scipy.integrate."""
    costly: ClassVar[bool] = False
    """Does its dense output ask for the rates? Then it is made when first asked for, by taking the step again."""

    def available(self) -> bool:
        return find_spec("scipy") is not None

    def steps(self, f: Rates, t0: float, y0: Sequence[float], t1: float, setting: Setting) -> Iterator[Step]:
        """SciPy's own steps; `setting.step` limits their length."""
        if not self.available():
            raise PlanarError(f"{self.kind} needs SciPy: pip install 'planar-cli[peers]'")
        if t1 == t0:
            return
        import scipy.integrate

        y, counts = list(y0), self.counts

        def rates(t: float, z: Any) -> Vector:
            counts.evaluations += 1
            return f(t, z.tolist())

        allowed = [setting.tolerance * s for s in setting.scale]
        longest = min(setting.longest_from(y), setting.step or setting.longest)
        options = {"rtol": SMALLEST, "atol": allowed, "max_step": longest}
        if setting.first is not None:
            options["first_step"] = min(setting.first, abs(t1 - t0), longest)
        solver = getattr(scipy.integrate, self.method)(rates, t0, y, t1, **options)
        before = f(t0, list(y))
        counts.evaluations += 1
        while solver.status == "running":
            t = float(solver.t)
            if setting.limit is not None:
                solver.max_step = min(setting.longest_from(y), setting.step or setting.longest)
            message = solver.step()
            if solver.status == "failed" or counts.steps > setting.most_steps:
                raise StepTooSmall(
                    f"SciPy's {self.method} gave up at t = {t:.9g} s ({message or 'too many steps'})", t, y
                )
            new, end = solver.y.tolist(), float(solver.t)
            if setting.project is not None:
                new = setting.project(end, new)
            after = f(end, new)
            counts.evaluations += 1
            counts.steps += 1
            yield Step(t, y, before, end, new, after, self._inside(solver, rates, options))
            y, before = new, after

    def _inside(
        self, solver: Any, rates: Callable[[float, Any], Vector], options: dict[str, Any]
    ) -> Callable[[float], Vector]:
        """Dense output of the solver's last step."""
        if not self.costly:
            dense = solver.dense_output()
            return lambda t: _listed(dense(t))
        made: list[Any] = []
        t0, y0, t1 = solver.t_old, solver.y_old.copy(), solver.t

        def inside(t: float) -> Vector:
            if not made:
                same = type(solver)(rates, t0, y0, t1, **{**options, "first_step": abs(t1 - t0)})
                same.step()
                made.append(same.dense_output())
            return _listed(made[0](t))

        return inside


def _listed(values: Any) -> Vector:
    found: Vector = values.tolist()
    return found
