"""Names of a file as they are printed: `mu_k` as μ_k, `omega_AB` as ω_AB."""

from __future__ import annotations

import re

from planar_cli.greek import GREEK

LETTERS = {**{sign: word for word, sign in GREEK.items()}, "ϕ": "phi", "ϑ": "theta", "ϵ": "epsilon", "Ω": "Omega"}
"""The word of each Greek letter, also of its other forms."""

ANGLE, LENGTH, POINT = "literal_angle_", "literal_length_", "p"
"""What the file writes as a number has such a name: `literal_angle_22p5` for 22.5°, `literal_length_0p5_m`."""

DOTS = {"dot": "\u0307", "ddot": "\u0308"}
"""What stands over a letter for its derivatives."""


def printed(name: str) -> str:
    """A name with Greek letters for their words, in it and in its subscripts, of which a state may be one."""
    if name.startswith(ANGLE):
        return f"{name.removeprefix(ANGLE).replace(POINT, '.')}°"
    if name.startswith(LENGTH):
        number, _, unit = name.removeprefix(LENGTH).partition("_")
        return f"{number.replace(POINT, '.')} {unit}"
    return "_".join(_letter(part) for part in name.replace("__", "_").split("_"))


def printed_rate(name: str) -> str:
    """The name of a velocity or acceleration, without its state; of a coordinate's, with dots: `phi_dot__1` as φ̇."""
    plain, _, last = name.partition("__")[0].rpartition("_")
    return printed(plain) + DOTS[last] if plain and last in DOTS else printed(name.partition("__")[0])


def _letter(part: str) -> str:
    word = re.match("[A-Za-z]*", part)
    letters = word[0] if word else ""
    return GREEK.get(letters, letters) + part[len(letters) :]
