"""Formulas as a person would write them: R - r for r - R where the file assumes r < R, and what follows from that.

(R - r)/(r - R) becomes -1, |R - r| and √(R² + r² - 2 R r) become R - r, R φ̇² - r φ̇² becomes (R - r) φ̇², and fractions
inside a bracket are put together. No value changes: a sign is taken from what the file assumes, from the numbers that
it gives, or from a root that must be real. Each sum that stands as a factor is one letter while a product is put
together, so that SymPy itself cancels.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import sympy as sp

from planar_cli.equation.algebra.bounds import certain_sign, with_positive_divisors
from planar_cli.equation.algebra.common_factors import factor_terms
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Kind, Ledger
from planar_cli.report.notation.binomials import multiplied
from planar_cli.report.notation.divided import divided_out
from planar_cli.report.notation.durations import over_durations
from planar_cli.report.notation.logarithms import of_ratios
from planar_cli.report.notation.nested import below, holds_fraction, holds_quotient, is_nested
from planar_cli.report.notation.notation import plain
from planar_cli.report.notation.pythagoras import of_one
from planar_cli.report.notation.relative_speeds import with_differences
from planar_cli.report.notation.spread import spread
from planar_cli.report.notation.static_roots import with_static_roots
from planar_cli.report.notation.total_masses import with_totals

LONGEST = 90
"""A product of more operations stays as it is."""
FEW_TERMS = 3, 8
"""Among so many terms a square is looked for."""
TURNED = 3
"""So many characters may be spent for the positive one of two differences."""


class Neat:
    """Writes formulas of one ledger neatly. `value`: numbers, perhaps drawn ones."""

    def __init__(self, ledger: Ledger, value: Valuation) -> None:
        self.ledger, self.value = ledger, value

    def __call__(self, expr: sp.Expr) -> sp.Expr:
        """The formula, term by term. One that does not get shorter stays as it is."""
        return with_static_roots(with_differences(spread(self._neat(expr)), self.ledger, self.sign))

    def _neat(self, expr: sp.Expr) -> sp.Expr:
        expr = with_totals(with_positive_divisors(expr), self.ledger)
        expr = of_one(multiplied(divided_out(of_ratios(expr, self.ledger))))
        if isinstance(expr, sp.Add | sp.Mul) and (times := self._times(expr)):
            expr = over_durations(expr, times)
        if not isinstance(expr, sp.Add | sp.Mul | sp.Pow | sp.Abs) or not self._promising(expr):
            return expr
        whole = self.collected(expr)
        terms = [self.term(t) for t in sp.Add.make_args(whole)]
        same = whole is expr and all(a is b for a, b in zip(terms, sp.Add.make_args(whole), strict=True))
        return expr if same else terms[0] if len(terms) == 1 else sp.Add(*terms)

    def _times(self, expr: sp.Expr) -> list[sp.Symbol]:
        """The times of states in a formula, the last one first."""
        time, roles = self.ledger.symbols.get("t"), self.ledger.roles
        found = [s for s in expr.free_symbols if time is not None and s in roles and roles[s].of == time]
        return sorted(found, key=lambda s: (-(self.value.known(s) or 0), s.name))

    def sides(self, left: sp.Expr, right: sp.Expr, turns: bool = False) -> tuple[sp.Expr, sp.Expr]:
        """Both sides of an equation, without the factors of all their terms that are surely positive. `turns`: nor
        with sines and cosines, by which a relation that tells something may be divided.
        """
        left, right = self(left), self(right)
        common = self.shared(left, right, turns)
        if not common:
            return left, right
        return _without(left, common), _without(right, common)

    def shared(self, left: sp.Expr, right: sp.Expr, turns: bool) -> list[sp.Expr]:
        """The factors of all terms of both sides that are surely positive, and with `turns` sines and cosines."""
        terms = [t for side in (left, right) for t in sp.Add.make_args(side) if t != 0]
        found = (
            [f for f in sp.Mul.make_args(terms[0]) if self._is_positive(f) or (turns and _turns(f))]
            if len(terms) > 1
            else []
        )
        return [f for f in found if all(f in sp.Mul.make_args(t) for t in terms[1:])]

    def _is_positive(self, factor: sp.Expr) -> bool:
        """Is a factor no number, and surely positive?"""
        return not factor.is_number and bool(factor.is_positive or (factor.is_Add and self.sign(factor) > 0))

    def _promising(self, expr: sp.Expr) -> bool:
        """Is there a root, a size, a fraction, a difference of known sign or a sum with a common factor at all?"""
        if any(d.free_symbols <= expr.free_symbols for d in self.ledger.above_zero):
            return True
        return any(
            isinstance(p, sp.Abs)
            or (p.is_Pow and (_holds_sum(p.base) or isinstance(p.base, sp.sin)))
            or (p.is_Mul and any(_shares(a) or (_may_turn(a) and self._is_turned(a)) for a in p.args))
            or (p.is_Add and (_square_inside(p) is not None or holds_quotient(p)))
            for p in sp.preorder_traversal(expr)
        )

    def term(self, term: sp.Expr) -> sp.Expr:
        """One term; it stays as it is where nothing gets shorter and no difference is turned."""
        if not (term.is_Mul or term.is_Pow or isinstance(term, sp.Abs)) or longer(term, LONGEST):
            return term
        sums = set(_sums(term))
        if not sums and not any(isinstance(p, sp.Abs) for p in sp.preorder_traversal(term)):
            return term
        nested = is_nested(term, sums)
        flat = simplified(term) if nested else term
        forms = dict.fromkeys((term, flat, *(self._put_together(f) for f in {flat: 0, term: 0})))
        return min(forms, key=self._effort) if len(forms) > 1 else term

    def _effort(self, term: sp.Expr) -> int:
        """How long a term is on the page, its spaces apart. Bars count twice, as they hide a sign; r - R counts more
        than -(R - r), and so does a fraction under a fraction stroke.
        """
        text = plain(term).replace(" ", "")
        turned_over = TURNED * sum(map(holds_fraction, below(term)))
        # That 1 comes before cos θ decides only between two that are as long.
        turned = sum(1 if s.as_coeff_Add()[0] else TURNED for s in _sums(term) if self._is_turned(s))
        return len(text) + text.count("|") + turned + turned_over

    def _is_turned(self, total: sp.Expr) -> bool:
        """Is it r - R or -R - r, surely negative, with a minus that can be put before it?"""
        return self.sign(total) < 0 and any(t.could_extract_minus_sign() for t in total.args)

    def _put_together(self, term: sp.Expr) -> sp.Expr:
        """A product with each sum that is a factor of it as one letter."""
        first = _Letters(self, {})
        written = first.written(term)
        if first.under_roots:
            first = _Letters(self, first.under_roots)
            written = first.written(term)
        return first.opened(written)

    def sign(self, total: sp.Expr) -> int:
        """1 or -1 where a sum surely has that sign; 0: it is not known."""
        single = total.primitive()[1] if self.ledger.above_zero else total
        for known in self.ledger.above_zero:
            if single in (known, -known):
                return 1 if single == known else -1
        number, rest = total.as_coeff_Add()
        if number and _at_most(rest, abs(number)):
            return 1 if number > 0 else -1
        if all(self._is_fixed(s) for s in total.free_symbols):
            value = self.value.known(total)
            return 0 if value is None or self.value.is_zero(total) else 1 if value > 0 else -1
        return certain_sign(total)

    def _is_fixed(self, symbol: sp.Symbol) -> bool:
        """Has a symbol one number: a given of the file, what is made of such ones, or the value at a state where no
        letter is drawn?
        """
        if (made := self.ledger.definitions.get(symbol)) is not None:
            return all(map(self._is_fixed, made.free_symbols))
        role = self.ledger.roles.get(symbol)
        given = self.ledger.values.get(symbol)
        fixed = role is not None and role.kind is Kind.STATE and not self.value.drawn
        return fixed or (given is not None and given.is_number)

    def collected(self, total: sp.Expr) -> sp.Expr:
        """R x - r x as (R - r) x, for the differences of letters that are known to be positive; sin² + cos² as 1."""
        total = self._with_square(_with_one(total)) if total.is_Add else total
        for known in self.ledger.above_zero if total.is_Add else ():
            if len(known.args) != 2:
                continue
            positive, negative = sorted(known.args, key=lambda a: bool(a.could_extract_minus_sign()))
            if positive.is_Symbol and (-negative).is_Symbol:
                total = _with_difference(total, positive, -negative, known)
        return total

    def _with_square(self, total: sp.Expr) -> sp.Expr:
        """a² + b² - 2 a b + c as (a - b)² + c."""
        found = _square_inside(total)
        if found is None:
            return total
        factor, root, rest = found
        square = factor * (-root if self.sign(root) < 0 else root) ** 2
        return square if rest == 0 else square + rest


class _Letters:
    """Letters for the sums of one product. `positive`: the signs of those that stand under roots."""

    def __init__(self, neat: Neat, positive: dict[sp.Expr, int]) -> None:
        self.neat, self.positive = neat, positive
        self.sums: dict[sp.Symbol, sp.Expr] = {}
        self.letters: dict[sp.Expr, sp.Symbol] = {}
        self.under_roots: dict[sp.Expr, int] = {}

    def written(self, expr: sp.Expr) -> sp.Expr:
        """A product, power, root or size, in letters for its sums."""
        if expr.is_Mul:
            return sp.Mul(*(self.written(a) for a in expr.args))
        if expr.is_Pow and expr.exp.is_Rational:
            base = self.written(expr.base)
            if expr.exp.q == 2:
                self._look_under(base)
            return base**expr.exp
        if isinstance(expr, sp.Abs):
            return _size(self.written(expr.args[0]))
        return self._letter(expr) if expr.is_Add else expr

    def _letter(self, total: sp.Expr) -> sp.Expr:
        """A sum as its common factor times a letter, or as a square of one."""
        total = self.neat.collected(sp.Add(*(self.neat.term(t) for t in total.args)))
        common = _factored_out(total) if total.is_Add else total
        if not common.is_Add:
            return sp.Mul(*(self._letter(a) if a.is_Add else self.written(a) for a in sp.Mul.make_args(common)))
        root = _square_root(common)
        if root is not None:
            return self._letter(root) ** 2
        if -common in self.letters:
            return -self.letters[-common]
        if common not in self.letters:
            sign = self.positive.get(common) or self.neat.sign(common)
            kept = -common if sign < 0 else common
            letter = sp.Dummy(positive=True) if sign else sp.Dummy(real=True)
            self.letters[kept], self.sums[letter] = letter, kept
            return -letter if sign < 0 else letter
        return self.letters[common]

    def _look_under(self, base: sp.Expr) -> None:
        """Of what stands under a root, the one factor of unknown sign has the sign with which the root is real."""
        factors = sp.Mul.make_args(base)
        unknown = [f for f in factors if not f.is_positive and not f.is_negative]
        letter, power = unknown[0].as_base_exp() if len(unknown) == 1 else (sp.S.One, sp.S.One)
        if letter in self.sums and power.is_Integer and power % 2:
            self.under_roots[self.sums[letter]] = -1 if sum(bool(f.is_negative) for f in factors) % 2 else 1

    def opened(self, expr: sp.Expr) -> sp.Expr:
        """The sums again for their letters; a number stays before a sum."""
        if expr in self.sums:
            return self.sums[expr]
        if not expr.args or not isinstance(expr, sp.Mul | sp.Pow | sp.Abs):
            return expr
        args = [self.opened(a) for a in expr.args]
        return expr.func(*args, evaluate=False) if expr.is_Mul and len(args) == 2 else expr.func(*args)


def _turns(factor: sp.Expr) -> bool:
    """Is it a sine or cosine?"""
    return isinstance(factor, sp.sin | sp.cos)


def _size(inside: sp.Expr) -> sp.Expr:
    """|√x y| is √x |y|."""
    factors = sp.Mul.make_args(inside)
    rooted = [f for f in factors if f.is_Pow and f.exp.is_Rational and f.exp.q == 2]
    return sp.Mul(*rooted, sp.Abs(sp.Mul(*(f for f in factors if f not in rooted))))


def _holds_sum(expr: sp.Expr) -> bool:
    """Is a factor of it a sum?"""
    return any(f.is_Add or (f.is_Pow and f.base.is_Add) for f in sp.Mul.make_args(expr))


def _factored_out(total: sp.Expr) -> sp.Expr:
    """A sum with what its terms have in common before it. Fractions that are shorter in the terms stay there, as in
    R² (1/2 - 16/(9 π²)).
    """
    found = factor_terms(total)
    number, rest = found.as_coeff_Mul()
    if found.is_Add or number.is_Integer or not number.is_Rational:
        return found
    sums = [f for f in sp.Mul.make_args(rest) if f.is_Add]
    if len(sums) != 1 or any(sp.gcd(t.as_coeff_Mul()[0], number.q) == 1 for t in sums[0].args):
        return found
    inside = sp.Add(*(t / number.q for t in sums[0].args))
    others = [f for f in sp.Mul.make_args(rest) if not f.is_Add]
    return sp.Mul(number.p, *others, inside, evaluate=False) if others or number.p != 1 else inside


def _shares(total: sp.Expr) -> bool:
    """Have all terms of a sum a letter as factor?"""
    letters = ({f.base if f.is_Pow else f for f in sp.Mul.make_args(t)} for t in total.args)
    return total.is_Add and any(f.is_Symbol for f in set.intersection(*letters))


def _sums(term: sp.Expr) -> Iterator[sp.Expr]:
    """The sums that stand as factors, under roots or between bars, and those inside them."""
    if term.is_Add:
        yield term
    if term.is_Add or term.is_Mul or term.is_Pow or isinstance(term, sp.Abs):
        for a in term.args:
            yield from _sums(a)


def _square_root(total: sp.Expr) -> sp.Expr | None:
    """a - b of a² + b² - 2 a b, or a + b; None: it is no such square of products."""
    if len(total.args) != 3:
        return None
    for one, other in combinations(total.args, 2):
        (rest,) = (a for a in total.args if a not in (one, other))
        a, b = _root_of(one), _root_of(other)
        if a is not None and b is not None and rest in (2 * a * b, -2 * a * b):
            return a + b if rest == 2 * a * b else a - b
    return None


def _square_inside(total: sp.Expr) -> tuple[sp.Expr, sp.Expr, sp.Expr] | None:
    """c, a - b and r of c (a - b)² + r among the terms of a longer sum in letters; None: there is no such square."""
    if not total.is_Add or not FEW_TERMS[0] <= len(total.args) <= FEW_TERMS[1]:
        return None
    squared = [x for x in total.free_symbols if any(_has_power(t, x, 2) for t in total.args)]
    for a, b in combinations(sorted(squared, key=lambda s: s.name), 2):
        if not any(_has_power(t, a, 1) and _has_power(t, b, 1) for t in total.args) or not total.is_polynomial(a, b):
            continue
        own = sp.Poly(total, a, b)
        one, other, mixed = (own.coeff_monomial(m) for m in (a**2, b**2, a * b))
        if one != 0 and sp.expand(one - other) == 0 and sp.expand(mixed**2 - 4 * one**2) == 0:
            root = a - b if sp.expand(mixed + 2 * one) == 0 else a + b
            rest = (own - sp.Poly(one * root**2, a, b)).as_expr()
            return factor_terms(one), root, rest
    return None


def _has_power(term: sp.Expr, letter: sp.Symbol, power: int) -> bool:
    """Is a power of a letter a factor of a term?"""
    return letter**power in sp.Mul.make_args(term)


def _may_turn(total: sp.Expr) -> bool:
    """Is it two letters, one less the other or both with a minus, or cos θ - 1?"""
    if not total.is_Add or len(total.args) != 2:
        return False
    number, rest = total.as_coeff_Add()
    return all(t.is_Symbol or (-t).is_Symbol for t in total.args) or bool(number and _turns(rest))


def _root_of(term: sp.Expr) -> sp.Expr | None:
    """a of the product a²."""
    number, rest = term.as_coeff_Mul()
    root = sp.sqrt(number)
    pairs = [f.as_base_exp() for f in sp.Mul.make_args(rest)] if rest != 1 else []
    if not root.is_Rational or not all(k.is_Integer and k > 0 and k % 2 == 0 for _, k in pairs):
        return None
    return sp.Mul(root, *(b ** (k / 2) for b, k in pairs))


def _at_most(rest: sp.Expr, bound: sp.Expr) -> bool:
    """Is it a sine or cosine times a number, never larger than a bound?"""
    number, function = rest.as_coeff_Mul()
    return isinstance(function, sp.sin | sp.cos) and bool(abs(number) <= bound)


def _with_one(total: sp.Expr) -> sp.Expr:
    """x sin² θ + x cos² θ as x."""
    terms = list(total.args)
    for term in total.args:
        for f in sp.Mul.make_args(term):
            if f.is_Pow and f.exp == 2 and isinstance(f.base, sp.sin) and term in terms:
                partner = term / f * sp.cos(*f.base.args) ** 2
                if partner in terms:
                    terms = [t for t in terms if t not in (term, partner)] + [term / f]
    return sp.Add(*terms) if len(terms) < len(total.args) else total


def _with_difference(total: sp.Expr, larger: sp.Expr, smaller: sp.Expr, difference: sp.Expr) -> sp.Expr:
    """larger x - smaller x as difference · x wherever both terms stand in a sum that has other terms too."""
    terms = list(total.args)
    made: list[sp.Expr] = []
    for term in total.args:
        partner = -term * smaller / larger
        if term in terms and partner in terms and larger in sp.Mul.make_args(term):
            terms = [t for t in terms if t not in (term, partner)]
            made.append(sp.Mul(term / larger, difference, evaluate=not (term / larger).is_Number))
    return sp.Add(*terms, *made) if made and (terms or len(made) > 1) else total


def _without(side: sp.Expr, factors: list[sp.Expr]) -> sp.Expr:
    """A side without factors of each of its terms."""
    terms = (sp.Mul(*(f for f in sp.Mul.make_args(t) if f not in factors)) for t in sp.Add.make_args(side))
    return side if side == 0 else sp.Add(*terms)
