"""Diagrams of a blow with the velocities that the file gives by its letters: m_C u → and m_C w ←."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.report.document.blocks import Forces, Line, Math, Text

OPPOSITE = dict(zip("→←↑↓↗↙↖↘↺↻", "←→↓↑↙↗↘↖↻↺", strict=True))


def by_given_letters(row: Forces, plain: Mapping[sp.Symbol, sp.Expr]) -> Forces:
    """A diagram in which velocities that are a letter of the file, or its opposite, are that letter. `plain`: letters
    that are data, with what they are.
    """
    given = {s: e for s, e in plain.items() if e.is_Symbol or (-e).is_Symbol}
    return replace(row, left=_lettered(row.left, given), right=_lettered(row.right, given))


def _lettered(side: Line, given: Mapping[sp.Symbol, sp.Expr]) -> Line:
    pieces: list[Any] = []
    turned = False
    for piece in side:
        if isinstance(piece, Math) and not piece.values and piece.expr.free_symbols & given.keys():
            put = piece.expr.xreplace(dict(given))
            turned = put.could_extract_minus_sign()
            pieces.append(Math(-put if turned else put))
        elif isinstance(piece, Text) and turned and (arrow := next((c for c in piece.text if c in OPPOSITE), "")):
            pieces.append(replace(piece, text=piece.text.replace(arrow, OPPOSITE[arrow], 1)))
            turned = False
        else:
            pieces.append(piece)
    return tuple(pieces)
