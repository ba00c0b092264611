"""The static coefficient of friction stands where the kinetic one belongs, or the reverse."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

from planar_cli.homework.mistakes.base import Mistake, Model
from planar_cli.problem.language.expression import Name
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations


@final
class StaticForKinetic(Mistake):
    """The static and the kinetic coefficient of friction are exchanged.

    In the equations
        The static and the kinetic coefficient of friction change places.
    """

    kind: ClassVar[str] = "static-for-kinetic"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        for member in (*problem.joints, *problem.loads):
            names = [s.name if isinstance(s := getattr(member, k, None), Name) else "" for k in ("mu_s", "mu_k")]
            if all(n in equations.inputs for n in names):
                static, kinetic = (equations.inputs[n] for n in names)
                yield Model(
                    "the static and the kinetic coefficient of friction are exchanged",
                    equations,
                    {static: kinetic, kinetic: static},
                )
