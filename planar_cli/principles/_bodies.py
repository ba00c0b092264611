"""The family of equations of every body, which Newton, d'Alembert and impulse and momentum share."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.equation.kinetics import body_residuals
from planar_cli.principles.base import BodyFamily, Position


def body_families(position: Position) -> Iterator[BodyFamily]:
    """Σ F - m a_G along x and y, and Σ M - (r_G × m a_G + I_G α) about the origin."""
    for body in position.system.scene.bodies:
        yield BodyFamily(body, *body_residuals(position.system, body))
