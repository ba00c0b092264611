"""SciPy's Radau: Radau IIA with three stages, implicit."""

from __future__ import annotations

from typing import ClassVar, final

from planar_cli.integrators._scipy import FromSciPy


@final
class SciPyRadau(FromSciPy):
    """SciPy's Radau: Radau IIA with three stages, implicit.

    Meaning
        The peer to compare `radau` with. Ends of steps are projected for output only: SciPy goes on from its own.

    Valid when
        SciPy is installed.

    Reference
        scipy.integrate.Radau
    """

    kind: ClassVar[str] = "scipy_radau"
    order: ClassVar[int] = 5
    method: ClassVar[str] = "Radau"
    implicit: ClassVar[bool] = True
