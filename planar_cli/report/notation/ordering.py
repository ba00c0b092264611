"""The order in which a reader expects the factors of a product and the terms of a sum.

m g sin θ, R ω², m (R² + k_G²) α, 1/2 m v², v_0 t cos θ: coefficients, masses and stiffnesses, forces, accelerations and
speeds, lengths, rotations, time, then functions.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from sympy import Function

from planar_cli.greek import GREEK
from planar_cli.report.notation.names import stem

_GROUPS = (
    ("mu", "e", "eta", "zeta"),
    ("m", "M", "rho"),
    ("I", "J", "k", "c"),
    ("P", "F", "N", "T", "Q", "W", "G", "S", "H", "V"),
    ("g",),
    ("a", "v", "u"),
    ("L", "l", "R", "r", "d", "D", "h", "H", "b", "s", "x", "y", "w"),
    ("alpha", "omega", "Omega"),
    ("theta", "phi", "psi", "Delta", "xi"),
    ("t", "tau", "dt"),
)
_RANKS = {name: rank for rank, names in reversed(list(enumerate(_GROUPS))) for name in names}
_OTHER_LETTERS = 6
_TIME = len(_GROUPS) - 1
_FUNCTIONS = len(_GROUPS)
_NUMBERS = -1
_DEVIATIONS = ("delta", "delta_dot", "delta_ddot")
"""A small deviation from an equilibrium stands behind what it is multiplied by: k l² δ, m g (l - a) δ."""
NUMBER = "#"
"""With this the name of a symbol begins that stands for a number as it is printed."""
HELD = f"{NUMBER}unit"
"""The name of a number that holds a unit, among letters."""
BEHIND = f"{NUMBER}behind"
"""With this the name of such a number begins that stands behind the letters: P (3 ft)."""

Key = tuple[float, bool, str, str, float]


@lru_cache(maxsize=20_000)
def factor_key(factor: Any) -> Key:
    """Sorts the factors of a product."""
    base, exponent = factor.as_base_exp() if factor.is_Pow else (factor, 1)
    power = -float(exponent) if getattr(exponent, "is_number", True) else 0.0
    if base.is_Number or base.is_NumberSymbol:
        return (_NUMBERS, False, "", str(base), power)
    if base.is_Symbol:
        name = base.name
        if name.startswith(BEHIND):
            return (_FUNCTIONS + 1, False, "", name, power)
        if name in _DEVIATIONS:
            return (_FUNCTIONS + 0.5, False, "", name, power)
        if name.startswith(NUMBER):
            return (_NUMBERS, False, "", name, power)
        # ξ stands before η, as x before y.
        sorted_by = "_".join("ei" if piece == "xi" else piece for piece in name.casefold().split("_"))
        return (_rank(name), "_" in name, sorted_by, name, power)
    if base.is_Add or base.is_Mul:
        # A bracket stands behind the letters of its own kind: (m_1 + m_2) g, P (R + r), m (R² + k_G²) α.
        ranks = [_rank(s.name) for s in base.free_symbols]
        if base.atoms(Function):
            ranks.append(_FUNCTIONS)
        # The time between two states counts as a time: x_2 + v (t_3 - t_2).
        time = bool(ranks) and min(ranks) == max(ranks) == _TIME
        return (_TIME if time else max(ranks, default=-1) + 0.5, False, "", str(base), power)
    return (_FUNCTIONS, False, base.func.__name__[::-1], str(base), power)


def in_order(factors: tuple[Any, ...]) -> list[Any]:
    """The factors of a product. e is a coefficient of restitution and stands first, but beside α or ω² it is an
    eccentricity: m e R ω².
    """
    if not (any(map(_is_e, factors)) and any(map(_is_turned_by, factors))):
        return sorted(factors, key=factor_key)
    return sorted(factors, key=lambda f: (_RANKS["R"], *factor_key(f)[1:]) if _is_e(f) else factor_key(f))


def _is_e(factor: Any) -> bool:
    return bool(factor.is_Symbol and stem(factor.name) == "e")


def _is_turned_by(factor: Any) -> bool:
    """Is it α, or ω²: what an arm is multiplied by in an acceleration?"""
    base, exponent = factor.as_base_exp()
    wanted = {"alpha": 1, "omega": 2}.get(stem(base.name)) if base.is_Symbol else None
    return bool(wanted == exponent)


def term_key(term: Any) -> tuple[float, list[Key]]:
    """Sorts the terms of a sum: by powers of time, then as their factors sort."""
    factors = term.args if term.is_Mul else (term,)
    keys = sorted(factor_key(f) for f in factors if not f.is_Rational)
    return (-sum(k[-1] for k in keys if k[0] == _TIME), keys)


def _rank(name: str) -> float:
    first = stem(name)
    if first == "k" and name[2:3].isupper():
        return _RANKS["R"]  # k_G is a radius of gyration, k and k_1 are stiffnesses
    if first in GREEK and "dot" in name:
        return _RANKS["omega"]  # (R - r) φ̇, as r ω
    if "ddot" in name:
        return _RANKS["a"]  # 2 s̈ s, as 2 a s
    return _RANKS.get(first, _OTHER_LETTERS)
