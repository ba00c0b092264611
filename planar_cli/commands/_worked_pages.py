"""Worked solutions as a homework has them: parts of its key, and of what is exported."""

from __future__ import annotations

from planar_cli.homework.paper import Printed
from planar_cli.records import record
from planar_cli.registry import member
from planar_cli.solve.solved_problem import Solution

FOR_COURSES = ("mathjax", "dollars")


@record
class WorkedPages:
    """Prints a worked solution in some formats, so many levels of headings below the page that it is part of."""

    forms: tuple[str, ...]
    below: int

    def __call__(self, solution: Solution) -> Printed:
        from planar_cli.figures.illustrated import illustrated
        from planar_cli.formats._course_html import course_html
        from planar_cli.report.blocks import Title
        from planar_cli.report.narrate import narrate

        page = illustrated(narrate(solution), solution)
        blocks = (Title(page.title), *page.blocks)

        def printed(form: str) -> str:
            text: str = member("formats", form)(self.below).part(blocks)
            return text

        return {form: course_html(blocks, form) if form in FOR_COURSES else printed(form) for form in self.forms}
