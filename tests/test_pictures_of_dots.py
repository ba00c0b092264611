"""A figure as a picture of dots: no row of it is left out, and none is there twice."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator
from itertools import pairwise

import pytest

from planar_cli.typeset import png

pytest.importorskip("typst", reason="pictures of dots need the extra `pdf`")
MARGIN = 12
"""Dots of the page on each side."""


@pytest.mark.parametrize(("wide", "high"), [(489.43, 154.54), (187.0, 231.0), (440.0, 392.0), (97.31, 300.7)])
def test_every_row_is_there(wide: float, high: float) -> None:
    """Strips as high as a dot, black and white by turns, are black and white by turns on the picture."""
    shown = list(_column(png(_strips(wide, high))))[MARGIN : MARGIN + int(high * 1.5)]
    assert set(shown) == {0, 255}
    assert all(one != next_ for one, next_ in pairwise(shown))


def _strips(wide: float, high: float) -> str:
    dot = 2 / 3
    rows = "".join(
        f'<rect x="0" y="{k * dot}" width="{wide}" height="{dot}" fill="#000"/>' for k in range(0, int(high / dot), 2)
    )
    size = f'viewBox="0 0 {wide} {high}" width="{wide}" height="{high}"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size}>{rows}</svg>'


def _column(data: bytes) -> Iterator[int]:
    """How bright the dots of a picture are (red), from above, in its middle column."""
    wide, high, depth, colour = struct.unpack(">IIBB", data[16:26])
    assert (depth, colour) == (8, 6)
    chunks, at = b"", 8
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at : at + 8])
        chunks += data[at + 8 : at + 8 + length] if name == b"IDAT" else b""
        at += length + 12
    raw, row = zlib.decompress(chunks), 4 * wide
    above = bytearray(row)
    for y in range(high):
        start = y * (row + 1)
        above = _unfiltered(raw[start], raw[start + 1 : start + 1 + row], above)
        yield above[wide // 2 * 4]


def _unfiltered(kind: int, line: bytes, above: bytearray) -> bytearray:
    """A row as it was before each byte became its difference from what its neighbours foretell (PNG, section 9)."""
    found = bytearray()
    for i, byte in enumerate(line):
        left, corner = (found[i - 4], above[i - 4]) if i >= 4 else (0, 0)
        guess = left + above[i] - corner
        nearest = min(
            (abs(guess - left), 0, left), (abs(guess - above[i]), 1, above[i]), (abs(guess - corner), 2, corner)
        )
        foretold = (0, left, above[i], (left + above[i]) // 2, nearest[2])[kind]
        found.append((byte + foretold) % 256)
    return found
