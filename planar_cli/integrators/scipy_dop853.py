"""SciPy's DOP853: the same method as `dop853`, on NumPy's arrays."""

from __future__ import annotations

from typing import ClassVar, final

from planar_cli.integrators._scipy import FromSciPy


@final
class SciPyDormandPrince853(FromSciPy):
    """SciPy's DOP853: the same method as `dop853`, on NumPy's arrays.

    Meaning
        The peer to compare our own with. Ends of steps are projected for output only: SciPy goes on from its own.

    Valid when
        SciPy is installed, and the motion is not stiff.

    Reference
        scipy.integrate.DOP853
    """

    kind: ClassVar[str] = "scipy_dop853"
    order: ClassVar[int] = 8
    method: ClassVar[str] = "DOP853"
    costly: ClassVar[bool] = True
