"""Accelerations and velocities that are the same all the time, by their own letters.

Once a page has told α = 0.05/0.3 = 0.1667 rad/s², what follows over time is told in α, and not in its numbers again.
"""

from __future__ import annotations

from collections.abc import Collection, Container, Iterator, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import letters, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Kind, Ledger, Role
from planar_cli.records import record
from planar_cli.solve.law import Law
from planar_cli.solve.regimes.equations import Laws, Link
from planar_cli.solve.regimes.regime import Regime

Constant = tuple[sp.Symbol, sp.Expr]
"""The letter of a rate that does not change, and what it is."""


@record
class ConstantRates:
    """The laws of the regimes of a motion, with letters for rates that are constant."""

    laws: tuple[Laws, ...]
    """By regime: its laws in these letters."""
    formulas: Mapping[sp.Symbol, sp.Expr]
    """What the letters are, in numbers and names of the file."""
    names: Mapping[int, Mapping[sp.Symbol, sp.Symbol]]
    """By the id of a regime: the letters of its general position, and those of the whole motion."""


def constant_rates(
    laws: Sequence[Laws],
    regimes: Sequence[Regime],
    states: Sequence[str],
    value: Valuation,
    ledger: Ledger,
    made: dict[tuple[int, sp.Symbol, str], sp.Symbol],
) -> ConstantRates:
    """Write the laws in letters. One that has another number in another regime is named after the state from which it
    has it. `states`: where the regimes begin; `value`: numbers of what is given; `made`: letters of earlier tries.
    """
    varying = {s for r in regimes for s in r.letters}
    found = [
        {law.coordinate.symbol: _constant(law, r, value, varying) for law in own.laws}
        for r, own in zip(regimes, laws, strict=True)
    ]
    several: dict[sp.Symbol, set[sp.Expr]] = {}
    for regime, own in zip(regimes, laws, strict=True):
        for law in own.laws:
            if law.f != 0 and (letter := _letter(law, regime)) is not None:
                several.setdefault(letter, set()).add(law.f)
    formulas: dict[sp.Symbol, sp.Expr] = {}
    names: dict[int, dict[sp.Symbol, sp.Symbol]] = {}
    written = []
    for regime, own, rates, state in zip(regimes, laws, found, states, strict=True):
        mine = names.setdefault(id(regime), {})
        for letter, formula in filter(None, rates.values()):
            if letter not in mine:
                scene = regime.general.instant.scene.ledger
                ledger.know(letter, scene.units[letter], scene.roles[letter])
                mine[letter] = letter if len(several[letter]) == 1 else _from(letter, state, ledger, made)
            formulas[mine[letter]] = formula
        links = tuple(_drifting(link, regime, regimes, value, varying) for link in own.links)
        for letter, formula in (x for _, inside in links for x in inside.items()):
            scene = regime.general.instant.scene.ledger
            ledger.know(letter, scene.units[letter], scene.roles[letter])
            formulas[letter] = formula
        laws_here = tuple(_lettered(own.laws, rates, mine))
        written.append(replace(own, laws=laws_here, links=tuple(link for link, _ in links)))
    return ConstantRates(tuple(written), formulas, names)


def _drifting(
    link: Link, regime: Regime, regimes: Sequence[Regime], value: Valuation, varying: Container[sp.Symbol]
) -> tuple[Link, dict[sp.Symbol, sp.Expr]]:
    """A coordinate that follows others, with letters for velocities in its drift that are constant."""
    if link.drift == 0 or letters(link.drift) & set(regime.letters):
        return link, {}
    lasting = lasting_letters(list({id(r): r for r in regimes}.values()), value).numbers
    constant = {s: e for s, (e, _) in constants_of(regime, value).items() if s in lasting and s not in varying}
    kept = frozenset(s for s in constant if s in regime.general.instant.scene.ledger.units)
    rate = regime.closed(link.coordinate.rate, kept)
    drift = simplified(rate.xreplace(dict.fromkeys(regime.free, sp.S.Zero)))
    inside = {s: constant[s] for s in letters(drift) & kept}
    return (replace(link, drift=drift), inside) if inside else (link, {})


def _from(
    letter: sp.Symbol, state: str, ledger: Ledger, made: dict[tuple[int, sp.Symbol, str], sp.Symbol]
) -> sp.Symbol:
    """The letter of a rate from a state on."""
    key = (id(ledger), letter, state)
    if key not in made:
        role = Role(Kind.STATE, letter, state)
        made[key] = ledger.fresh(f"{letter.name}__{state}", ledger.units[letter].text, role=role)
    return made[key]


def _lettered(
    laws: Sequence[Law], rates: Mapping[sp.Symbol, Constant | None], names: Mapping[sp.Symbol, sp.Symbol]
) -> Iterator[Law]:
    for law in laws:
        rate = rates[law.coordinate.symbol]
        if rate is None:
            yield law
        else:
            letter = names[rate[0]]
            yield replace(law, f=law.factor * letter, constant=(letter, rate[1]))


def _constant(law: Law, regime: Regime, value: Valuation, varying: Container[sp.Symbol]) -> Constant | None:
    """The letter of a law and its formula, where that is more than a name of the file or its opposite. `varying`:
    letters that vary in some regime.
    """
    letter, inside = _letter(law, regime), letters(law.f)
    if letter is None or letter in varying or law.f == 0 or inside & {*regime.letters, law.v}:
        return None
    formula = law.f / law.factor
    scene = regime.general.instant.scene.ledger
    if _is_name(formula) or letter not in scene.units or letter not in scene.roles:
        return None
    settled = value.without(value.drawn).known(formula) is not None
    return (letter, formula) if settled and value.known(letter) is None else None


def _letter(law: Law, regime: Regime) -> sp.Symbol | None:
    """The unknown of the general position that a law gives."""
    if law.order == 2:
        found = None if law.speed is None else regime.general.rate_of(law.speed)
        return found if found is not None and found.is_Symbol else None
    rate = law.coordinate.rate
    return rate if rate.is_Symbol and rate not in regime.letters else None


def _is_name(formula: sp.Expr) -> bool:
    """Is it a name of the file, or the opposite of one?"""
    return bool(formula.is_Symbol or (-formula).is_Symbol)


@record
class LastingLetters:
    """Unknowns that are the same all the time, apart from those that are names of the file."""

    numbers: Mapping[sp.Symbol, Decimal]
    """Of those that have one number in the whole motion."""
    several: Mapping[int, Collection[sp.Symbol]]
    """By the id of a regime: those that have another number elsewhere."""


def constants_of(regime: Regime, value: Valuation) -> dict[sp.Symbol, tuple[sp.Expr, Decimal]]:
    """Formulas and numbers of the unknowns of a general position that are the same all the time; not of those that are
    zero. `value`: numbers of what is given.
    """
    settled, varying = value.without(value.drawn), set(regime.letters)
    found: dict[sp.Symbol, tuple[sp.Expr, Decimal]] = {}
    for algebra in (stage.algebra for stage in regime.general.stages):
        for letter in {**algebra.explicit, **algebra.formulas}:
            closed = regime.in_letters(letter)
            number = None if letters(closed) & varying else settled.known(closed)
            if number and not settled.is_zero(closed):
                found[letter] = (closed, number)
    return found


def lasting_letters(regimes: Sequence[Regime], value: Valuation) -> LastingLetters:
    """The unknowns of some regimes that are the same all the time. `value`: numbers of what is given."""
    every = {id(r): constants_of(r, value) for r in regimes}
    numbers: dict[sp.Symbol, Decimal] = {}
    for letter, (closed, number) in ((x, c) for of_regime in every.values() for x, c in of_regime.items()):
        known = [every[id(r)].get(letter) for r in regimes if _has(r, letter)]
        if not _is_name(closed) and all(k is not None and k[1] == number for k in known):
            numbers[letter] = number
    several = {key: {x for x, (e, _) in c.items() if x not in numbers and not _is_name(e)} for key, c in every.items()}
    return LastingLetters(numbers, several)


def _has(regime: Regime, letter: sp.Symbol) -> bool:
    """Is it an unknown of this regime at all?"""
    algebras = [stage.algebra for stage in regime.general.stages]
    return letter in regime.letters or any(letter in {**a.explicit, **a.formulas} for a in algebras)
