"""What each diagnostic code of homework sets means, for `planar explain PL801`."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

CODES_HOMEWORK: Mapping[str, str] = MappingProxyType(
    {
        "PL801": "A homework set lists problem files, what they count, and how they are graded: `title: Homework 3`, "
        "`problems: [slope.yaml, {file: gears.yaml, points: 4}]`, `variants: {number: 30, seed: 7}`. Credits are parts "
        "of the points, 0 to 1; names of problems and students stand once. See `planar explain homework`.",
        "PL802": "`points` of a problem of a set names finds of its file; another name scores nothing.",
        "PL803": "A problem of a set was not solved within its limits of time and memory. Solve it by itself with "
        "`planar solve`, or give it more time with `--timeout`.",
        "PL804": "A problem has values for variants, but with no combination of them the physics stays what it is: the "
        "same case, the same signs, no answer that hangs on the last digits, each typical mistake clearly wrong. Write "
        "values nearer to those of the file. See `planar explain variants`.",
    }
)
