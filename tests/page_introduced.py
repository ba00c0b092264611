"""Which letters of an equation nothing on its page has introduced before.

A letter is introduced by what is given or asked, a sentence, a diagram, what stands before a formula, or as the left
side of a formula. By the conventions of the course nothing more is needed for the place, velocity, acceleration, angle
and turning of a point or body that the page has named, their components and their values at states, for the time, for
energies and work, and for arms from point to point.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from page_rules import Page, symbols

KINEMATIC = frozenset("v a x y r s ω α θ φ δ".split())
KNOWN = frozenset("t U V H L p e e_t e_n e_r e_θ e_φ u n i j d dt ρ a_rel v_rel a_cor y″ y′ C".split())
DOTS = str.maketrans("ẋẏṡṙẍÿ", "xysrxy", "\u0307\u0308")
DIFFERENTIAL = re.compile(r"^d(?=[^\W\d])|^Δ")


UNITS = frozenset("m N J W s kg ft in lb lbf slug rad rev rpm mm cm km h min Hz kW hp mph kN kJ deg".split())
FUNCTIONS = frozenset("cosh sinh tanh arcosh arsinh artanh".split())
PROSE = re.compile(r"[a-z]{2,}|[A-Z]?[a-z]{3,}")


def unintroduced(page: Page) -> Iterator[str]:
    """The letters that come from nowhere, each once."""
    words: set[str] = set()
    known: set[str] = set()
    told: set[str] = set()
    for r in page.rows:
        text = r.lead if r.kind == "equation" else r.text
        known |= set(_letters(text))
        words |= set(re.findall(r"\w+", text))
        sides = [_letters(side) for side in r.sides] if r.kind == "equation" else []
        known |= {side[0] for side in sides if len(side) == 1}
        for letter in (x for side in sides for x in side):
            if letter not in known and letter not in told and not _by_convention(letter, words):
                told.add(letter)
                yield letter


def _letters(text: str) -> list[str]:
    """The letters of a formula without its words and units; both of a quotient, r_B/A and v_B/A as they are."""
    found = []
    for whole in symbols(text):
        relative = re.match(r"[rva]_", whole) and re.search(r"/[A-Z]", whole)
        found += [whole] if relative else whole.split("/")
    return [x for x in found if not PROSE.fullmatch(x) and x not in UNITS and x not in FUNCTIONS]


def _by_convention(letter: str, words: set[str]) -> bool:
    plain = DIFFERENTIAL.sub("", letter.translate(DOTS)).rstrip("′")
    stem, _, index = plain.partition("_")
    if plain in KNOWN or stem == "t" or (stem in "rva" and "/" in index):
        return True
    places = [re.sub(r"(?<=[A-Z\d])[xytnr]$", "", p) for p in re.split(r"[,/]", index) if p]
    return stem in KINEMATIC and all(_named(p, words) for p in places)


def _named(place: str, words: set[str]) -> bool:
    """A body, a point, a state or an axis; AB between two points."""
    ends = re.findall(r"[A-Z]\d*", place)
    between = len(ends) == 2 and "".join(ends) == place and all(any(e in w for w in words) for e in ends)
    return place in words or between or place in {"x", "y", "t", "n", "r", "θ", "G", "max", "min"}
