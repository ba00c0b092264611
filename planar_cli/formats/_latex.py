"""Pieces of a document in LaTeX mathematics, for formats that have formulas in it."""

from __future__ import annotations

from planar_cli.report.document.blocks import Equation, Inline, Line, Math, Name, Relation, Text, Value
from planar_cli.report.notation import latex
from planar_cli.report.notation.names import latex_name
from planar_cli.report.notation.numbers import significant
from planar_cli.units import pretty_unit


def equation(told: Equation) -> str:
    """A display equation with its lead, its note and its number."""
    relation = latex.relation(told.relation)
    left, *others = [display(s) for s in told.sides]
    formulas = left + "".join(f" {relation if i == 0 else '='} {side}" for i, side in enumerate(others))
    tag = rf" \tag{{{told.number}}}" if told.number is not None else ""
    lead = display(told.lead) + r" \quad " if told.lead else ""
    note = r" \qquad " + display(told.note) if told.note else ""
    return f"{lead}{formulas}{note}{tag}"


def display(side: Inline | Line) -> str:
    """One side of an equation, or words beside it."""
    parts = side if isinstance(side, tuple) else (side,)
    match parts:
        case (Name(name), Text(", x" | ", y" as axis)):
            return latex_name(f"{name}_{axis[-1]}")
    told = [formula(p) for p in parts]
    return "".join(map(_spaced, parts, told, [*told[1:], ""]))


def _spaced(part: Inline, told: str, following: str) -> str:
    """A space before words would be lost in a formula."""
    return r"\ " if isinstance(part, Text) and part.text.isspace() and following.startswith(r"\text{") else told


def formula(part: Inline) -> str:
    """A part inside a formula."""
    match part:
        case Text(text):
            return latex.words(text)
        case Name(name):
            return latex_name(name)
        case Value(number, unit, figures):
            return _quantity(significant(number, figures), unit)
        case Relation(left, relation, right):
            return f"{formula(left)} {latex.relation(relation)} {formula(right)}"
        case Math(expr, values):
            from planar_cli.report.notation import notation  # SymPy is loaded only where there is a formula

            return notation.latex(expr, values)


def _quantity(number: str, unit: str) -> str:
    shown = pretty_unit(unit) if unit not in ("", "1") else ""
    if shown == "°":
        return latex.numeral(number + shown)
    return latex.numeral(number) + (rf"~\mathrm{{{latex.numeral(shown)}}}" if shown else "")
