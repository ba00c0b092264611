"""What reads alike on a page, whatever the digits and the order of factors behind it."""

from __future__ import annotations

import re
from decimal import Decimal

from planar_cli.report.document.blocks import Forces, Inline, Line, Math, Name, Text, Value
from planar_cli.report.notation.names import plain_name
from planar_cli.report.notation.notation import plain
from planar_cli.report.notation.numbers import quantity

NUMBER = re.compile(r"Decimal\('([^']+)'\)")


def read_alike(piece: object) -> str:
    """What tells pieces that read alike: the last digits of a number are not seen in print."""
    return NUMBER.sub(lambda found: f"{Decimal(found[1]):.10g}", repr(piece))


def diagram(row: Forces) -> str:
    """The diagram of a body as it is printed: m a_B is the same by its name and as a product."""
    return f"{row.body}: {as_text(row.left)} = {as_text(row.right)} {row.heads}"


def as_text(side: Inline | Line) -> str:
    """A piece, or the pieces of a line, as they are printed."""
    match side:
        case tuple():
            return "".join(map(as_text, side))
        case Text(text):
            return text
        case Name(name):
            return plain_name(name)
        case Math(expr, values):
            return plain(expr, values)
        case Value(number, unit, figures):
            return quantity(number, unit, figures)
    return read_alike(side)
