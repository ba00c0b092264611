"""The figure of a sheet in questions of course systems: the scene as it is given, a file of SVG, and its letters."""

from __future__ import annotations

from planar_cli.homework.exports._text import as_attribute, one_line
from planar_cli.homework.sets.paper import Task
from planar_cli.records import record

SVG, WORDS = "svg", "words"
"""Under these names the scene of a task has the figure itself, and what it shows in words."""
SUFFIX = ".svg"


@record
class Figure:
    """A figure of a question. `words`: what it shows; `letters`: what its letters are, in HTML for MathJax and, in
    `dollars`, for systems that have formulas between dollars.
    """

    data: bytes
    words: str
    letters: str
    dollars: str

    def shown(self, address: str) -> str:
        """As HTML, with its letters below. `address`: where the system finds the file."""
        return f'<p><img src="{address}" alt="{as_attribute(self.words)}"/></p>{self.letters}'


def figure_of(task: Task) -> Figure | None:
    """None: there is no figure, or none is wanted."""
    scene = task.scene
    if SVG not in scene:
        return None
    words = one_line(scene.get(WORDS, ""))
    return Figure(scene[SVG].encode(), words, scene.get("mathjax", ""), scene.get("dollars", ""))
