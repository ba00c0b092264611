"""The decision that an exercise in friction turns on, as the last line of its solution: what a contact needs beside
what it can give.

|F_A| = 108.8 N < μ_s N_A = 0.4 · 341.7 = 136.7 N                      crate at A does not slip
x = P y/N_C = 235.4 · 0.5/588.6 = 0.2 m < b/2 = 0.3 m                  it slips before it tips
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field, replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.system.on_two_points import on_two_points
from planar_cli.equation.values.exact import ZERO
from planar_cli.problem.scene.facts import Mode, Push, Test
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Heading, Line, Math, Name, Value, line
from planar_cli.report.friction.offsets import moment_of_loads, normal_of, offset_letter, offsets
from planar_cli.report.friction.presses import bounded_in, sum_of_forces
from planar_cli.report.friction.what_it_needs import Presses, Working, presses, working
from planar_cli.report.words.mode_words import words_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.distribution import possible
from planar_cli.solve.instant.instant import Trial
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import LENGTH, parse_unit

NEAR = Decimal("1e-20")
FORCES_ALONE = "free-body diagram; ΣF = 0"
HAPPENS = {"slip": "slips", "tip": "tips", "part": "lifts off"}


@record
class Needed:
    """What the friction or the couple at a contact has to be, and what it can be at most.

    `size`, `limit`: numbers, SI; `formula`: of the limit; `own`: of the size, by what is known; None: nothing short.
    `press`: of the couple of a normal force, how far beside the middle that acts (a letter), and the force.
    `pushes`: the forces on which the limit rests, as they are in this case; `working`: of a case that is rejected,
    where its own accelerations tell the size; `presses`: the normal force on which the limit of that case rests.
    """

    symbol: sp.Symbol
    unit: str
    size: Decimal
    limit: Decimal
    formula: sp.Expr
    own: sp.Expr | None = None
    press: tuple[sp.Symbol, sp.Symbol, Decimal] | None = None
    working: Working | None = None
    presses: Presses | None = None
    pushes: Mapping[sp.Symbol, Decimal] = field(default_factory=dict)

    def wants(self, sign: str, phrases: Phrases) -> Line:
        """The same as a sentence, what its size rests on before it."""
        first = () if self.presses is None else self.presses.told(phrases)
        before = () if self.working is None else self.working.told(phrases)
        parts = (*first, *(["; "] if first else []), *before, *(["; "] if before else []))
        return line(*parts, "it would need ", *self.told(sign, phrases))

    def shown(self, phrases: Phrases) -> tuple[Value, Value]:
        """Size and limit with their unit."""
        dimension = parse_unit(self.unit).dimension
        return phrases.of_dimension(self.size, dimension), phrases.of_dimension(abs(self.limit), dimension)

    def told(self, sign: str, phrases: Phrases) -> Line:
        """|F| = P cos β = 181.3 N, then the sign, then μ N = 0.4 · 307.9 = 123.2 N."""
        if self.press is not None:
            return self._offset(*self.press, sign, phrases)
        shown, most = self.shown(phrases)
        size = line("|", Math(self.symbol), "|", *self.worked(phrases), " = ", shown)
        there = replace(phrases, value=phrases.value.extended(self.pushes))
        numbers = [piece for side in there.substituted(self.formula, most) for piece in (" = ", side)]
        return line(*size, sign, phrases.math(self.formula), *numbers, " = ", most)

    def worked(self, phrases: Phrases) -> Line:
        """` = m a = 5 · 5.942`, of the size; empty where it has no formula."""
        if self.own is None:
            return ()
        there = phrases if self.working is None else replace(phrases, value=self.working.value)
        numbers = [piece for side in there.substituted(self.own, self.shown(phrases)[0]) for piece in (" = ", side)]
        return line(" = ", there.math(self.own), *numbers)

    def _offset(self, letter: sp.Symbol, force: sp.Symbol, press: Decimal, sign: str, phrases: Phrases) -> Line:
        """x = P y/N = 235.4 · 0.5/588.6 = 0.2 m, the sign, b/2 = 0.3 m."""
        there = replace(phrases, value=phrases.value.extended({force: press, self.symbol: self.size}))
        at, most = (there.of_dimension(abs(n) / press, LENGTH) for n in (self.size, self.limit))
        formula, edge = (self.symbol if self.own is None else self.own) / force, simplified(self.formula / force)
        numbers = [p for side in there.substituted(formula, at) for p in (" = ", side)]
        told = () if formula == letter else (" = ", there.math(formula), *numbers)
        return line(Math(letter), *told, " = ", at, sign, there.math(edge), " = ", most)


def needed(trial: Trial, test: Test) -> Needed | None:
    """What a test of friction, or of the couple of a normal force, compares. None: it has no numbers, or is about
    something else.
    """
    system, outcome = trial.system, trial.outcomes[0]
    values = {name: outcome.push(name) for name, _ in test.pushes}
    name = bounded_in(system, test)
    if name is None or outcome.value is None or any(v is None for v in values.values()):
        return None
    limit, formula = outcome.value(sp.sympify(test.constant)), sp.sympify(test.constant)
    for other, factor in test.pushes:
        if other != name:
            limit += outcome.value(factor) * (values[other] or ZERO)
            formula += factor * system.symbols[other]
    push = next(p for p in system.pushes if p.name == name)
    normal = normal_of(system, push)
    force = None if normal is None else values.get(normal.name)
    press = None
    if normal is not None and force is not None and force > 0 and not test.constant:
        press = offset_letter(system, push), system.symbols[normal.name], force
    forces = {system.symbols[n]: v for n, v in values.items() if n != name and v is not None}
    size = abs(values[name] or ZERO)
    return Needed(system.symbols[name], push.unit, size, limit, formula, press=press, pushes=forces)


def worked_out(found: Needed, trial: Trial, instant: InstantSolution, phrases: Phrases) -> Needed:
    """The same with the formula of its friction."""
    push = next(p for p in trial.system.pushes if trial.system.symbols.get(p.name) == found.symbol)
    letters = {found.symbol, found.press[0]} if found.press is not None else {found.symbol}
    solved = any(letters & set(b.unknowns) for s in instant.stages for b in s.blocks) and trial is instant.trial
    own = None
    if solved and found.press is not None:
        own = found.press[0] * found.press[1]
    elif not solved and found.press is not None:
        own = moment_of_loads(trial, push, found.size)
    elif not solved and push.kind == "friction":
        own = _formula(replace(instant, trial=trial), push, found.size, phrases)
        if (
            own is None
            and trial is not instant.trial
            and (way := working(trial, push, found.size, instant)) is not None
        ):
            return replace(found, own=way.size, working=way)
    return replace(found, own=own)


def of_rejected(found: Needed, trial: Trial, instant: InstantSolution, phrases: Phrases) -> Needed:
    """The same of a case that is rejected, with the normal force on which its limit rests."""
    worked = worked_out(found, trial, instant, phrases)
    pressed = None if found.press is not None else presses(trial, found.formula, instant)
    # A letter that is told with a positive size for its opposite does not stand beside itself.
    turned = worked.working.senses.keys() if worked.working is not None else set()
    apart = pressed is None or not turned & dict(pressed.letters).keys()
    return replace(worked, presses=pressed) if apart else worked


def _formula(instant: InstantSolution, push: Push, size: Decimal, phrases: Phrases) -> sp.Expr | None:
    """The size of a friction by the sum of forces along it, without what is zero."""
    symbols = instant.trial.system.symbols
    outcome = instant.trial.outcomes[0]
    zeros = {symbols[p.name]: sp.S.Zero for p in instant.trial.system.pushes if outcome.push(p.name) == 0}
    zeros |= {s: sp.S.Zero for s, number in instant.value.values.items() if number == 0}
    for whole in sum_of_forces(instant, push, symbols[push.name]):
        formula = whole.xreplace(zeros)
        number = phrases.value.known(formula)
        if number is not None and abs(abs(number) - size) <= NEAR * size and formula.free_symbols:
            return formula if number > 0 else -formula
    return None


def with_decisions(blocks: list[Block], instant: InstantSolution, phrases: Phrases, decides: bool) -> list[Block]:
    """The blocks of an instant with these lines behind them; a sum of moments among them is one of equilibrium too."""
    told = [line for _, line in decision_lines(instant, phrases, decides)]
    if not any(isinstance(piece, Name) and piece.name.startswith("ΣM") for b in told for piece in b.lead):
        return [*blocks, *told]
    return [
        replace(b, aside=f"{b.aside}, ΣM = 0") if isinstance(b, Heading) and b.aside == FORCES_ALONE else b
        for b in (*blocks, *told)
    ]


def decision_lines(instant: InstantSolution, phrases: Phrases, decides: bool) -> Iterator[tuple[sp.Symbol, Equation]]:
    """One line for each contact that sticks where that is asked (`decides`), or where something is largest or smallest
    that another limit than its own bounds; with the letter of its friction or couple.
    """
    largest = bool(instant.instant.statements.extremes)
    if not (largest or decides) or phrases.symbolic or phrases.lettered or not instant.trial.outcomes:
        return
    trial = _settled(instant.trial)
    limits = [w.lead for s in instant.stages for b in s.blocks for w in b.equations if w.source == "limit"]
    happens = next((HAPPENS[k] for words in limits for k in HAPPENS if f"about to {k}" in words), "")
    for mode, test in limits_of(trial):
        found = needed(trial, test)
        if found is None or found.size >= found.limit * (1 - NEAR):
            continue
        words = _instead(test, happens) if largest else _holds(mode, test, trial)
        if words:
            worked = worked_out(found, trial, instant, phrases)
            yield from _moments(worked, trial, instant)
            yield found.symbol, Equation((line(*worked.told(" < ", phrases)),), None, (), line(words))
    if largest and happens == "slips":
        yield from _stands(trial, phrases)


def _moments(found: Needed, trial: Trial, instant: InstantSolution) -> Iterator[tuple[sp.Symbol, Equation]]:
    """↺ ΣM_C: N x - P y = 0, of which no equation before gave the distance."""
    own = next((o for o in offsets(trial, instant.value) if o.couple == found.symbol), None)
    if own is None or found.own is None or found.press is None or found.own.has(found.press[0]):
        return
    whole = Math(own.normal * own.letter - found.own)
    lead = line(f"{'↺' if own.counter > 0 else '↻'} ", Name(f"ΣM_{own.place}"), ":")
    yield found.symbol, Equation((whole, Math(sp.S.Zero)), None, lead)


def _stands(trial: Trial, phrases: Phrases) -> Iterator[tuple[sp.Symbol, Equation]]:
    """`N_B > 0   it slips before it tips`, of the two points on which a body stands the one that presses less."""
    system, outcome = trial.system, trial.outcomes[0]
    forces: dict[str, list[tuple[Decimal, sp.Symbol]]] = {}
    for push in system.pushes:
        size = outcome.push(push.name)
        found = on_two_points(system, push.joint) if push.kind == "normal" else None
        if found is not None and size is not None:
            forces.setdefault(found[0], []).append((size, system.symbols[push.name]))
    for own in forces.values():
        size, symbol = min(own, key=lambda f: f[0])
        if size > 0:
            value = phrases.of_dimension(size, parse_unit("N").dimension)
            yield (
                symbol,
                Equation((line(Math(symbol), " = ", value, " > 0"),), None, (), line("it slips before it tips")),
            )


def at_limit(instant: InstantSolution) -> set[sp.Symbol]:
    """The letters in equations that put something at its limit."""
    written = (w for s in instant.stages for b in s.blocks for w in b.equations)
    found = {s for w in written if w.source == "limit" for s in w.residual.free_symbols}
    return found | {o.couple for o in offsets(instant.trial, instant.value) if o.letter in found}


def _holds(mode: Mode, test: Test, trial: Trial) -> str:
    """What does not happen, as there is enough."""
    slides = _of_friction(test)
    return words_of(mode, trial.system) if mode.name == "stick" and slides else f"it does not {slides or 'tip'}"


def _of_friction(test: Test) -> str:
    """Slip, of a test of friction; empty of that of a couple, which keeps a face from tipping."""
    return "slip" if test.words.endswith("within its limit") else ""


def _instead(test: Test, happens: str) -> str:
    """What happens first."""
    other = f"{_of_friction(test) or 'tip'}s"
    return f"it {happens} before it {other}" if happens and happens != other else ""


def limits_of(trial: Trial) -> Iterator[tuple[Mode, Test]]:
    """The tests that bound frictions and couples, one for each, in the sense that it has."""
    for mode in trial.system.modes.values():
        by_name: dict[str, Test] = {}
        for test in mode.tests:
            name = bounded_in(trial.system, test)
            if name is not None and not test.strict and (name not in by_name or _bounds(trial, test, name)):
                by_name[name] = test
        yield from ((mode, test) for test in by_name.values())


def _bounds(trial: Trial, test: Test, name: str) -> bool:
    """Does a test bound a push in the sense that it has?"""
    return bool(dict(test.pushes)[name] * (trial.outcomes[0].push(name) or ZERO) < 0)


def _settled(trial: Trial) -> Trial:
    """With the friction that is not unique only because what bounds one of them is zero, as where a contact is about to
    part.
    """
    outcome = trial.outcomes[0]
    idle = [t for _, t in limits_of(trial) if _limit(trial, t) == 0]
    beside = possible(trial.system, outcome) if 0 < len(outcome.solved.null) <= len(idle) else None
    return trial if beside is None else replace(trial, outcomes=(beside,))


def _limit(trial: Trial, test: Test) -> Decimal | None:
    """What the other pushes of a test allow; None: they have no values."""
    outcome, name = trial.outcomes[0], bounded_in(trial.system, test)
    others = [(outcome.push(n), factor) for n, factor in test.pushes if n != name]
    if outcome.value is None or any(v is None for v, _ in others):
        return None
    return sum((outcome.value(factor) * (v or ZERO) for v, factor in others), outcome.value(sp.sympify(test.constant)))
