"""Names of a file as they are printed: `mu_k` as μ_k, `omega_AB` as ω_AB."""

from __future__ import annotations

import re

from planar_cli.greek import GREEK

LETTERS = {**{sign: word for word, sign in GREEK.items()}, "ϕ": "phi", "ϑ": "theta", "ϵ": "epsilon", "Ω": "Omega"}
"""The word of each Greek letter, also of its other forms."""


def printed(name: str) -> str:
    """A name with Greek letters for their words, in it and in its subscripts."""
    return "_".join(_letter(part) for part in name.split("_"))


def _letter(part: str) -> str:
    word = re.match("[A-Za-z]*", part)
    letters = word[0] if word else ""
    return GREEK.get(letters, letters) + part[len(letters) :]
