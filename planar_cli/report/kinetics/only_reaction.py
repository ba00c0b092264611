"""The size of a reaction that has one component: that of its letter, in whatever direction it acts."""

from __future__ import annotations

from planar_cli.equation.system.system import System
from planar_cli.problem.language.expression import Quantity
from planar_cli.report.document.blocks import Line, line
from planar_cli.report.words.words import Phrases


def size_of_only(q: Quantity, system: System, phrases: Phrases) -> Line:
    """|N| of a joint whose only reaction that is not zero is N, without bars where it is positive; empty: it has
    others, or something else is meant.
    """
    if q.word != "reaction" or system.reactions is None:
        return ()
    names = {p.name for p in system.pushes if p.joint == q.things[0]}
    acting = [e for p, e in system.reactions.pushes if p.name in names and e != 0]
    if len(acting) != 1 or not acting[0].is_Symbol:
        return ()
    size = phrases.value.known(acting[0])
    letter = phrases.math(acting[0])
    return line(letter) if size is not None and size > 0 else line("|", letter, "|")
