"""Vectors as students write them without brackets, brought to those: text to text.

v_x = 2.73 m/s, v_y = -1.27 m/s    A_y = 74.4 lbf, A_x = 0    2.73 m/s, -1.27 m/s    3.02 m/s, -25°
"""

from __future__ import annotations

import re

_NUMBER = r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?(?![0-9.])"
_APART = re.compile(r"\s*;\s*|\s+and\s+|\s*,\s+(?:and\s+)?|\s*,(?=[^\W\d])")
"""Between two components; a comma between digits may be a decimal point."""
_NAMED = re.compile(rf"\\?[^\W\d][\w{{}}]*?([xy])\}}?\s*[=≈]\s*({_NUMBER}\s*[^,;=]*)")
_PLAIN = re.compile(rf"{_NUMBER}\s*(?:[A-Za-z(1][A-Za-z0-9*/^(). -]*)?")
_ANGLE = re.compile(rf"{_NUMBER}\s*(?:deg|degrees|°|rad)")


def in_brackets(text: str, vector: bool) -> str:
    """Two components in brackets, x first; any other text as it is. `vector`: one is asked, so that two numbers without
    names are its components, and a number with an angle its magnitude and direction.
    """
    parts = _APART.split(text)
    if len(parts) != 2:
        return text
    named = [_NAMED.fullmatch(part) for part in parts]
    found = {match[1]: match[2].strip() for match in named if match is not None}
    if len(found) == 2:
        return f"[{found['x']}, {found['y']}]"
    if not vector or _PLAIN.fullmatch(parts[0]) is None:
        return text
    if _ANGLE.fullmatch(parts[1]) is not None:
        return text if _ANGLE.fullmatch(parts[0]) is not None else f"{parts[0]} at {parts[1]}"
    return f"[{parts[0]}, {parts[1]}]" if _PLAIN.fullmatch(parts[1]) is not None else text
