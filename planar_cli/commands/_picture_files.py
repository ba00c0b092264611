"""Graphs as files: pictures of SVG, or of dots."""

from __future__ import annotations

from typing import TYPE_CHECKING

from planar_cli.options import WrongUsage

if TYPE_CHECKING:
    from planar_cli.report.document.marks import Figure

PICTURES = (".svg", ".png")


def demand_picture(path: str | None, endings: tuple[str, ...] = PICTURES) -> None:
    """WrongUsage where a file of that name cannot be written; None: no picture is wanted."""
    if path is not None and not path.lower().endswith(endings):
        raise WrongUsage(f"a picture of this kind is written as {' or '.join(endings)}, not as {path}")


def picture_bytes(figure: Figure, path: str) -> bytes:
    """A figure as what `path` ends with. PlanarError: pictures of dots cannot be made here."""
    from planar_cli.formats._svg import svg

    if path.lower().endswith(".svg"):
        return svg(figure).encode()
    from planar_cli.typeset import png

    return png(svg(figure, "print"))
