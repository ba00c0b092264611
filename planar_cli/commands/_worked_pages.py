"""What rests on a problem alone, of the pages of a homework: the figure of its sheet, and its worked solution."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from planar_cli.homework.sets.paper import Printed
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import record
from planar_cli.registry import member
from planar_cli.solve.solved_problem import Solution

if TYPE_CHECKING:
    from planar_cli.report.document.blocks import Block

FOR_COURSES = ("mathjax", "dollars")
MARKDOWN = "markdown"


@record
class Pressed:
    """Prints in the form of sheets and key ("": none) and, if `exports`, of course systems; `below`: so many levels of
    headings a worked solution stands below the key; `pictures`: the text of Markdown has files beside it;
    `figures`, `audience`: of worked solutions.
    """

    form: str
    exports: bool
    solves: bool
    below: int
    pictures: bool
    figures: int = 4
    audience: str = "student"

    def scene(self, problem: Problem) -> Printed:
        """The figure of a sheet, for course systems as a file of its own."""
        from planar_cli.figures.handed_out import handed_out, letters_told
        from planar_cli.formats._svg import svg
        from planar_cli.report.document.blocks import Drawing, Paragraph

        figure = handed_out(problem) if self.form or self.exports else None
        if figure is None:
            return {}
        letters = letters_told(figure, problem)
        told = [Paragraph(letters)] if letters else []
        alone = {"svg": svg(figure), "words": figure.words} if self.exports else {}
        return {**alone, **self._for_courses(told), **self._printed([Drawing(figure), *told])}

    def worked(self, solution: Solution) -> Printed:
        """A worked solution."""
        from planar_cli.figures.illustrated import illustrated
        from planar_cli.report.document.blocks import Title
        from planar_cli.report.page.narrate import Voice, narrate

        page = illustrated(narrate(solution, Voice(self.figures, self.audience)), solution)
        blocks = (Title(page.title), *page.blocks)
        return {**self._for_courses(blocks), **self._printed(blocks)}

    def _for_courses(self, blocks: Sequence[Block]) -> dict[str, str]:
        """As course systems show them."""
        from planar_cli.formats._course_html import course_html

        return {way: course_html(blocks, way) for way in FOR_COURSES} if self.exports else {}

    def _printed(self, blocks: Sequence[Block]) -> dict[str, str]:
        """In the form of sheets and key."""
        from planar_cli.formats._svg import picture
        from planar_cli.report.document.blocks import Drawing

        if not self.form:
            return {}
        called = self.pictures and self.form == MARKDOWN
        form: Any = member("formats", self.form)
        text = (form(self.below, called) if called else form(self.below)).part(blocks)
        drawn = dict(picture(b.figure) for b in blocks if isinstance(b, Drawing)) if called else {}
        return {self.form: text, **drawn} if text else {}
