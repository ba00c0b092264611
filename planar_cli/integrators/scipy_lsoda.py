"""SciPy's LSODA: Adams' methods, or backward differences where the motion is stiff."""

from __future__ import annotations

from typing import ClassVar, final

from planar_cli.integrators._scipy import FromSciPy


@final
class SciPyLSODA(FromSciPy):
    """SciPy's LSODA: Adams' methods, or backward differences where the motion is stiff.

    Meaning
        A multistep method of order up to 12: few evaluations, larger errors for the same tolerance. Ends of steps are
        projected for output only: SciPy goes on from its own.

    Valid when
        SciPy is installed.

    Reference
        L. Petzold, SIAM J. Sci. Stat. Comput. 4 (1983) 136; scipy.integrate.LSODA
    """

    kind: ClassVar[str] = "scipy_lsoda"
    order: ClassVar[int] = 12
    method: ClassVar[str] = "LSODA"
    implicit: ClassVar[bool] = True
