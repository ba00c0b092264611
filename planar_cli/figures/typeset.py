"""Pictures of dots from SVG, by typst (the extra `pdf`): the template is ours, the figure is handed over as data."""

from __future__ import annotations

from importlib.util import find_spec

from planar_cli.errors import PlanarError

TEMPLATE = b"""#set page(width: auto, height: auto, margin: 6pt, fill: white)
#image(bytes(sys.inputs.figure), format: "svg")
"""
DOTS = 144.0
"""Of an inch."""


def png(svg: str) -> bytes:
    """Raises PlanarError where typst is not installed."""
    if find_spec("typst") is None:
        raise PlanarError("a picture needs typst: install planar with its extra `pdf`, or take `--format svg`")
    import typst

    made = typst.compile(TEMPLATE, format="png", ppi=DOTS, sys_inputs={"figure": svg})
    assert isinstance(made, bytes)
    return made
