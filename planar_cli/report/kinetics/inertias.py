"""Moments of inertia on which energies and momenta between states rest, told once before them."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import are_zero, longer, simplified
from planar_cli.equation.scene.centres import centre_of
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.values.ledger import Kind, Ledger
from planar_cli.problem.scene.part_names import part_names
from planar_cli.problem.scene.scene import Body, Composite, Piece, Rod, Round, Sector
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Heading, Inline, Line, Math, Text, Value, line
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.numbers import significant
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import BalanceTrace, ImpactEquation, MotionTrace
from planar_cli.units import LENGTH, RATE, VELOCITY

PARALLEL = ", parallel axes"
LONGEST, FEW = 40, 6
"""A longer formula is told by its value; and in the letters of the file not at all."""


def with_inertias(
    blocks: Sequence[Block], motion: MotionTrace, scene: Scene, phrases: Phrases, told: Sequence[Block]
) -> list[Block]:
    """The blocks of a motion, and behind its first heading the moments of inertia that none of those `told` before
    gives; of one that was told in letters its number.
    """
    first = next((i for i, b in enumerate(blocks) if isinstance(b, Heading)), None)
    before = {b.lead: b for b in told if isinstance(b, Equation)}
    own: list[Equation] = []
    lines = _lines(motion, scene, phrases, _letters(blocks))
    for block in (*lines, *_of_blows(motion, phrases, {b.lead for b in lines})):
        known = before.get(block.lead)
        if known is None:
            own.append(block)
        elif isinstance(block.sides[-1], Value) and not any(isinstance(s, Value) for s in known.sides):
            own.append(replace(block, sides=tuple(s for s in block.sides if s not in known.sides[1:])))
    if first is None:
        return list(blocks)
    return [*blocks[: first + 1], *own, *(b for b in blocks[first + 1 :] if b not in own)]


def _letters(blocks: Sequence[Block]) -> set[sp.Symbol]:
    """The letters of all equations."""
    sides = [side for b in blocks if isinstance(b, Equation) for side in b.sides]
    pieces = [p for side in sides for p in (side if isinstance(side, tuple) else (side,))]
    return {s for p in pieces if isinstance(p, Math) for s in p.expr.free_symbols}


def _lines(motion: MotionTrace, scene: Scene, phrases: Phrases, used: set[sp.Symbol]) -> list[Equation]:
    """One for each moment of inertia of a turning body, and for what it is made of; what only another general position
    has named, the motion does without. `used`: letters of its equations.
    """
    ledger = scene.ledger
    centres = {f"moment of inertia of {body} about {c}, parallel axes" for body, c in _turning(motion)}
    wanted = {s for s, title in ledger.titles.items() if title in centres}
    wanted |= {s for s in used if ledger.titles.get(s, "").startswith("moment of inertia")}
    wanted |= {s for body, _ in _turning(motion) for s in scene.bodies[body].inertia.free_symbols}
    for symbol in reversed(list(ledger.definitions)):
        if symbol in wanted:
            wanted |= ledger.definitions[symbol].free_symbols
    return [
        inertia_line(symbol, expr, scene, phrases)
        for symbol, expr in ledger.definitions.items()
        if symbol in wanted
        and symbol in motion.ledger.definitions
        and (not expr.is_number or _is_reach(symbol, ledger))
    ]


def _is_reach(symbol: sp.Symbol, ledger: Ledger) -> bool:
    """Is it the distance of a part from the pin, which a page has no other word for?"""
    return ledger.titles[symbol].startswith("from ")


def _of_blows(motion: MotionTrace, phrases: Phrases, told: Collection[Line]) -> list[Equation]:
    """Those that only blows have: about the point at which a body is caught. `told`: the leads of others."""
    found: list[Equation] = []
    for source in (e.source for leg in motion.route.steps for e in leg.relations):
        if not isinstance(source, ImpactEquation) or source.impact.solution is None:
            continue
        solution = source.impact.solution
        scene = solution.instant.scene
        own = replace(phrases, ledger=scene.ledger, value=solution.value)
        inside = (source.left - source.right).free_symbols
        for symbol in reversed(list(scene.ledger.definitions)):
            if symbol in inside:
                inside |= scene.ledger.definitions[symbol].free_symbols
        for symbol, expr in ((s, e) for s, e in scene.ledger.definitions.items() if s in inside and not e.is_number):
            made = inertia_line(symbol, expr, scene, own)
            if made.lead not in told and made not in found:
                found.append(made)
    return found


def _stands(omega: sp.Expr, motion: MotionTrace) -> bool:
    """Does a body not turn where a state is, however fast the others go?"""
    units = motion.ledger.units
    speeds = [s for s in omega.free_symbols if s in units and units[s].dimension in (RATE, VELOCITY)]
    return bool(speeds) and motion.value.vanishes(omega) and all(motion.value.known(s) for s in speeds)


def _turning(motion: MotionTrace) -> set[tuple[str, str]]:
    """The bodies whose turning counts in a balance of the way to the answers, with the centre of its moments."""
    found: set[tuple[str, str]] = set()
    for source in (e.source for leg in motion.route.steps for e in leg.relations):
        if isinstance(source, BalanceTrace) and source.parts is not None:
            if are_zero((source.before, source.after), motion.route.formulas):
                continue
            turning = (m for m in source.parts.moving if m.inertia != 0 and m.omega != 0)
            found |= {(m.body, "") for m in turning if not _stands(sp.sympify(m.omega), motion)}
        elif isinstance(source, ImpactEquation) and source.law == "moment":
            found |= {(body, source.lead) for body in source.bodies}
    return found


def inertia_of(body: str, formula: sp.Expr, phrases: Phrases) -> sp.Expr:
    """The moment of inertia of a body by its letter, where that is told, else its formula."""
    ledger = phrases.ledger
    own = (s for s in ledger.definitions if ledger.titles.get(s, "") == f"moment of inertia of {body}")
    known = phrases.value.is_zero
    same = (s for s in own if not ledger.definitions[s].is_number and known(simplified(s - formula)))
    return next(same, formula)


def inertia_line(symbol: sp.Symbol, expr: sp.Expr, scene: Scene, phrases: Phrases) -> Equation:
    """symbol = formula = numbers = value."""
    settled = phrases.has_numbers(symbol) and not is_sought(symbol, phrases.ledger)
    sides: list[Inline | Line] = [phrases.math(symbol)]
    value = phrases.shown(symbol) if settled else None
    dimension = phrases.ledger.units[symbol].dimension
    sides += before_product(symbol, scene, phrases)
    if sized := by_size(symbol, scene, phrases, settled):
        sides += sized
    elif not settled or (not longer(expr, LONGEST) and is_clean(phrases.ledger, expr, dimension=dimension)):
        whole = in_one_product(symbol, expr, phrases) if value is not None else None
        # As the kinetics have it, where that of an apex comes first.
        own = expr if len(sides) > 1 and not settled else in_twelfths(expr)
        shown = [phrases.math(own), *([] if whole is None else [phrases.math(whole)])]
        put = own if whole is None else whole
        sides += [*shown, *(phrases.substituted(put, value) if value is not None else ())]
    sides += [] if value is None else [value]
    return Equation(tuple(sides), None, line(f"{scene.ledger.titles[symbol]}:"))


def in_twelfths(expr: sp.Expr) -> sp.Expr:
    """m (b² + h²)/12 for m (b²/12 + h²/12)."""
    found = sp.factor_terms(expr)
    return found if found.is_Mul and operations(found) < operations(expr) else expr


def in_one_product(symbol: sp.Symbol, expr: sp.Expr, phrases: Phrases) -> sp.Expr | None:
    """I_A in the letters of the file where it is one product, as 1/3 m l² is I + m (l/2)²; None: it is none, or it has
    moments of inertia of several parts.
    """
    ledger = phrases.ledger
    inside = {s for s in expr.free_symbols & ledger.definitions.keys() if _is_inertia(s, ledger)}
    if not ledger.titles.get(symbol, "").endswith(PARALLEL) or len(inside) != 1:
        return None
    (own,) = inside
    found = sp.factor_terms(simplified(expr.xreplace({own: ledger.definitions[own]})))
    clean = found.is_Mul and not longer(found, FEW) and not any(_is_inertia(s, ledger) for s in found.free_symbols)
    return found if clean and is_clean(ledger, found, dimension=ledger.units[symbol].dimension) else None


def _is_inertia(symbol: sp.Symbol, ledger: Ledger) -> bool:
    return ledger.titles.get(symbol, "").startswith("moment of inertia")


def by_size(symbol: sp.Symbol, scene: Scene, phrases: Phrases, settled: bool) -> list[Line]:
    """m l²/12, I + m AG² and the like of a body whose sizes are numbers of the file, with the numbers where it is
    `settled`; empty where its formula already has letters for them.
    """
    made = _of_body(symbol, scene) or _of_part(symbol, scene) or _shifted(symbol, scene)
    if made is None or not made.mass.is_Symbol or made.square == 0:
        return []
    if not made.square.is_number:
        return [] if settled else _by_distance(made, scene.ledger)
    length = sp.Symbol(made.letter, positive=True)
    formula = sp.Mul(made.factor, made.mass, length**2, evaluate=False)
    formula = formula if made.own == 0 else sp.Add(made.own, formula, evaluate=False)
    told = [line(Math(formula))]
    if settled:
        size = phrases.of_dimension(phrases.value(sp.sqrt(made.square)), LENGTH)
        texts = {s: _text(phrases.shown(s)) for s in (made.mass, made.own) if s != 0}
        told.append(line(Math(formula, {length: _text(size), **texts})))
    return told


def before_product(symbol: sp.Symbol, scene: Scene, phrases: Phrases) -> list[Line]:
    """A form that shows what a formula comes from, before it."""
    return about_apex(symbol, scene, phrases) or of_multiple(symbol, scene)


def of_multiple(symbol: sp.Symbol, scene: Scene) -> list[Line]:
    """1/12 (3 m) l² of a rod whose mass is 3 m; empty where mass or length are no such."""
    made = _of_body(symbol, scene)
    if made is None or not sp.sqrt(made.square).is_Symbol:
        return []
    factor, letter = made.mass.as_coeff_Mul()
    # A text stands as it is written: a letter with an index would lose it there.
    whole = factor.is_Integer and factor != 1 and letter.is_Symbol and "_" not in letter.name
    texts = {letter: f"{factor} {letter.name}"}
    return [line(Math(made.factor * letter * made.square, texts))] if whole else []


def about_apex(symbol: sp.Symbol, scene: Scene, phrases: Phrases) -> list[Line]:
    """1/2 m r² - m (4 r/(3 π))² of a half disk or another sector: about its apex, less that of its mass centre; empty
    of other bodies and where numbers alone would stand in it.
    """
    found = _sector(symbol, scene)
    if found is None:
        return []
    shape, mass = found
    radius, reach = sp.sympify(scene.value(shape.radius)), _to_centre(shape, scene)
    if not mass.is_Symbol or reach.is_number or longer(reach, FEW) or longer(radius, FEW):
        return []
    m = phrases.math(mass)
    return [line("1/2 ", m, " ", phrases.math(radius**2), " - ", m, " (", phrases.math(reach), ")²")]


def from_apex(symbol: sp.Symbol, scene: Scene, phrases: Phrases) -> Iterator[Equation]:
    """OG = 4 R/(3 π), before the moment of inertia of a body that is one half disk or another sector."""
    body = next((b for b in scene.problem.bodies if scene.bodies[b.name].inertia == symbol), None)
    if body is None or not isinstance(body.shape, Sector) or not about_apex(symbol, scene, phrases):
        return
    reach = _to_centre(body.shape, scene)
    own = sp.Symbol(f"{body.shape.apex}{centre_of(scene, body.name)}", positive=True)
    sides: list[Inline | Line] = [Math(own), phrases.math(reach)]
    if phrases.has_numbers(reach):
        value = phrases.of_dimension(phrases.value(reach), LENGTH)
        sides += [*phrases.substituted(reach, value), value]
    shape = "half disk" if simplified(scene.value(body.shape.span) - sp.pi) == 0 else "sector"
    yield Equation(tuple(sides), None, line(f"{shape}, from {body.shape.apex} to its mass centre:"))


def _to_centre(shape: Sector, scene: Scene) -> sp.Expr:
    """From the apex of a sector to its mass centre."""
    radius, span = (sp.sympify(scene.value(side)) for side in (shape.radius, shape.span))
    return simplified(4 * radius * sp.sin(span / 2) / (3 * span))


def _sector(symbol: sp.Symbol, scene: Scene) -> tuple[Sector, sp.Expr] | None:
    """The sector of which a letter is the moment of inertia about its mass centre, with its mass."""
    title = scene.ledger.titles[symbol].removeprefix(OF_BODY).removesuffix(" about its centre")
    for body in scene.problem.bodies:
        model = scene.bodies[body.name]
        given = body.inertia is not None or body.gyration is not None
        if isinstance(body.shape, Sector) and model.inertia == symbol and not given:
            return body.shape, model.mass
        if not isinstance(body.shape, Composite):
            continue
        named = zip(part_names(body, scene.problem), body.shape.pieces, model.parts, strict=False)
        for name, piece, (mass, _, _) in named:
            own = piece.inertia is None and piece.gyration is None
            if name == title and isinstance(piece.shape, Sector) and own:
                return piece.shape, mass
    return None


def _by_distance(made: _Made, ledger: Ledger) -> list[Line]:
    """I + m (L/4)² = 7/48 m L², where the distance of both points is a multiple of one length."""
    distance = sp.sqrt(simplified(made.square))
    if made.own == 0 or not made.own.is_Symbol or not distance.as_coeff_Mul()[1].is_Symbol:
        return []
    shift = sp.Mul(made.mass, sp.Pow(distance, 2, evaluate=False), evaluate=False)
    whole = simplified(ledger.behind(made.own) + made.mass * made.square)
    told = [sp.Add(made.own, shift, evaluate=False), *([] if longer(whole, FEW) else [whole])]
    return [line(Math(e)) for e in told]


def alike_together(lines: Sequence[Equation]) -> list[Equation]:
    """Equal bodies have one line: I_A = I_B = 1/12 m l² = …; of what is made otherwise each its own."""
    found: list[Equation] = []
    for equation in lines:
        same = found[-1] if found else None
        one = _body_of(equation)
        if (
            same is None
            or not one
            or not _body_of(same)
            or same.sides[-len(equation.sides) + 1 :] != equation.sides[1:]
        ):
            found.append(equation)
            continue
        bodies = f"{_body_of(same)}, {one}"
        letters = same.sides[: len(same.sides) - len(equation.sides) + 1]
        sides = (*letters, *equation.sides)
        found[-1] = replace(same, sides=sides, lead=line(f"{OF_BODIES}{bodies}:"))
    return found


OF_BODY, OF_BODIES = "moment of inertia of ", "moments of inertia of "


def _body_of(equation: Equation) -> str:
    """The body, or the bodies, whose moment of inertia about the mass centre a line gives; empty: it gives another."""
    words = "".join(p.text for p in equation.lead if isinstance(p, Text)).removesuffix(":")
    if len(equation.sides) < 2 or " about " in words or " of part " in words:
        return ""
    return words.removeprefix(OF_BODIES).removeprefix(OF_BODY) if words.startswith((OF_BODY, OF_BODIES)) else ""


def _text(value: Value) -> str:
    return significant(value.number, value.figures)


@record
class _Made:
    """I = own + factor · mass · letter², and the square that the letter stands for."""

    own: sp.Expr
    factor: sp.Expr
    mass: sp.Expr
    letter: str
    square: sp.Expr


def _of_body(symbol: sp.Symbol, scene: Scene) -> _Made | None:
    """The moment of inertia of a uniform body, or of one whose radius of gyration is given."""
    body = next((b for b in scene.problem.bodies if scene.bodies[b.name].inertia == symbol), None)
    size = None if body is None or body.inertia is not None or body.about is not None else _size(body)
    if body is None or size is None:
        return None
    factor, letter = size
    mass = scene.bodies[body.name].mass
    return _Made(sp.S.Zero, factor, mass, letter, scene.ledger.definitions[symbol] / mass / factor)


def _of_part(symbol: sp.Symbol, scene: Scene) -> _Made | None:
    """The same of a part about its own mass centre."""
    ledger = scene.ledger
    which, _, rest = ledger.titles[symbol].removeprefix(OF_BODY).partition(" about its ")
    end = rest.startswith("end ")
    whole = ((b, b.shape) for b in scene.problem.bodies if isinstance(b.shape, Composite))
    parts = (named for b, shape in whole for named in zip(part_names(b, scene.problem), shape.pieces, strict=True))
    piece = next((p for name, p in parts if name == which and (end or rest == "centre")), None)
    size = None if piece is None or piece.inertia is not None else _size(piece)
    # Its mass is a letter of the file, or has one of its own; a length in letters needs no other word.
    letters = ledger.definitions[symbol].free_symbols
    if size is None or len(letters) != 1:
        return None
    (factor, letter), (mass,) = size, letters
    factor *= 4 if end else 1
    return _Made(sp.S.Zero, factor, mass, letter, ledger.definitions[symbol] / mass / factor)


def _shifted(symbol: sp.Symbol, scene: Scene) -> _Made | None:
    """One about another point, by that about the mass centre and the distance of both."""
    title = scene.ledger.titles[symbol].removesuffix(", parallel axes")
    for name, model in scene.bodies.items():
        place = title.removeprefix(f"moment of inertia of {name} about ")
        if place != title and model.inertia.is_Symbol and model.inertia != symbol and model.mass != 0:
            rest = scene.ledger.definitions[symbol] - model.inertia
            letter = f"{place}{centre_of(scene, name)}"
            return _Made(model.inertia, sp.S.One, model.mass, letter, rest / model.mass)
    return None


def _size(body: Body | Piece) -> tuple[sp.Expr, str] | None:
    """The factor and the length of a moment of inertia m l²/12, m r²/2 or m k²."""
    shape = body.shape
    if body.gyration is not None:
        return sp.S.One, "k"
    if isinstance(shape, Rod):
        return sp.Rational(1, 12), f"{shape.start}{shape.end}" if shape.end is not None else "l"
    if isinstance(shape, Round) and shape.hub is None:
        return {"disk": sp.Rational(1, 2), "ring": sp.S.One, "sphere": sp.Rational(2, 5)}[shape.kind], "r"
    return None


def is_sought(symbol: sp.Symbol, ledger: Ledger) -> bool:
    """Does it rest on what the equations have yet to give?"""
    if ledger.roles[symbol].kind is Kind.SOUGHT:
        return True
    inside = ledger.definitions.get(symbol, ledger.values.get(symbol))
    return inside is not None and any(is_sought(s, ledger) for s in inside.free_symbols)
