"""One problem file solved for a homework: what is right, for the file itself and for any values of its given names,
and what typical mistakes give; all from its equations, which are solved once.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np
import sympy as sp

from planar_cli.base_units import in_base
from planar_cli.errors import FileProblem, Mark, PlanarError, Undecided
from planar_cli.homework.mistakes.base import Mistake, Model
from planar_cli.homework.sets.asked_words import asked_words, couples_of, in_case, is_energy, mode_asked
from planar_cli.homework.sets.key_text import key_text
from planar_cli.homework.sets.own_names import own_names
from planar_cli.homework.sets.paper import Expected
from planar_cli.homework.variants.headings import heading_of, lines_of
from planar_cli.homework.variants.literal_data import with_names
from planar_cli.homework.variants.marked_solution import has_letters, marked_solution, plainly_read
from planar_cli.homework.variants.own_gravity import gravity_of
from planar_cli.homework.variants.wrong_formulas import as_written, wrong_formulas
from planar_cli.problem.language.expression import Name, Quantity
from planar_cli.problem.language.parser import parse_side
from planar_cli.problem.nodes.nodes import Node, read_file
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.sections.variations import number_of, with_first_values, with_values
from planar_cli.records import changing, record
from planar_cli.registry import members
from planar_cli.replay.equations import Equations
from planar_cli.replay.numbers import Replay, Run
from planar_cli.replay.opened import NotWritten
from planar_cli.replay.solver import Numbers
from planar_cli.replay.writer import is_mode
from planar_cli.replay.written import equations_of
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution, Solution
from planar_cli.units import Unit

TURNING = ("omega", "alpha", "theta", "H", "moment", "I")
"""Quantities that count positive counterclockwise."""
MOVES = ("v", "a", "friction", "reaction", "force", "coriolis", "momentum")
"""Quantities of which a part along an axis is told to the right or left, upward or downward."""
COUNTERCLOCKWISE = "counterclockwise", "clockwise"
ALONG = {"x": ("to the right", "to the left"), "y": ("upward", "downward")}
AGREES, NEARLY_ZERO = 1e-6, 1e-9
"""Relative, and in base units: the equations carried out give what was found."""
APART = 3.0
"""A mistake tells something where it is off by so many tolerances."""


@record
class Part:
    """One part with its equations, ready to be carried out; None: they are not all written, `why`."""

    solution: PartSolution
    problem: Problem
    replay: Replay | None
    why: str = ""
    own: frozenset[str] = frozenset()
    """Names that the case gives itself, whatever a variant has."""


@changing
class WorkedProblem:
    """A file with its solution. `name`: in the set; `node`: its tree, from which variants are made."""

    name: str
    path: str
    node: Node
    problem: Problem
    solution: Solution
    parts: tuple[Part, ...]
    models: list[tuple[str, ModelOf]] | None = None
    """What `models_of` has made."""

    @property
    def is_written(self) -> bool:
        """Do all answers follow from equations that can be carried out anew? Modes stay while the tests hold."""
        return all(p.replay is not None and (f.name in p.replay.equations.asked or is_mode(f)) for p, f in self.finds)

    @property
    def finds(self) -> tuple[tuple[Part, Found], ...]:
        """Every find, with its part, in the order of the file."""
        return tuple((p, f) for p in self.parts for f in p.solution.found)


def read_and_solve(path: str, name: str) -> WorkedProblem:
    """A problem file. PlanarError: it cannot be read or has no solution."""
    _, node, wrong = read_file(path)
    if node is None or wrong:
        raise FileProblem(wrong)
    return worked(path, name, node)


def worked(path: str, name: str, node: Node) -> WorkedProblem:
    """The same from its tree."""
    plain = plainly_read(path, node)
    lettered = with_names(node)
    if lettered is not node and not has_letters(plain):
        with suppress(PlanarError, Disagreement):
            return _worked(name, path, node, plainly_read(path, lettered))
    return _worked(name, path, node, plain)


def _worked(name: str, path: str, node: Node, problem: Problem) -> WorkedProblem:
    solution = marked_solution(problem)
    parts = tuple(_part(p, _of_part(solution.problem, p), problem) for p in solution.parts)
    return WorkedProblem(name, path, node, problem, solution, parts)


def with_numbers(problem: WorkedProblem, values: Mapping[str, str]) -> WorkedProblem:
    """The file with other values of given names, solved anew."""
    return worked(problem.path, problem.name, with_values(with_first_values(problem.node), values))


def _of_part(problem: Problem, part: PartSolution) -> Problem:
    return next((c.problem for c in problem.cases if c.name == part.case), problem)


def _part(part: PartSolution, problem: Problem, whole: Problem) -> Part:
    """A part with its equations, for those finds of which they give what was found."""
    own = own_names(problem, whole)
    try:
        replay = Replay(equations_of(part))
    except NotWritten as why:
        return Part(part, problem, None, str(why), own)
    asked, run = replay.equations.asked, replay.run({})
    due = {f.name: [float(v) for v in f.values or ()] for f in part.found}
    same = {n: a for n, a in asked.items() if _agrees([float(v[0]) for v in run.asked(n)], due[n])}
    if len(same) < len(asked):
        # Instants that have the same letters for other numbers.
        equations = replace(replay.equations, asked=same)
        replay = Replay(equations, replay)
    told = "" if same else "its equations give other numbers"
    return Part(part, problem, replay if same else None, told, own)


def _agrees(numbers: Sequence[float], due: Sequence[float]) -> bool:
    size = max(map(abs, due), default=0.0)
    pairs = zip(numbers, due, strict=False)
    return len(numbers) == len(due) and all(abs(n - d) <= AGREES * size + NEARLY_ZERO for n, d in pairs)


# --- numbers of many variants ----------------------------------------------------------------------------------------


def base_numbers(problem: Problem, values: Mapping[str, str]) -> dict[str, float]:
    """Values as a file writes them, in the base units of the problem."""
    numbers = {name: _base_number(text, problem.us) for name, text in values.items()}
    return {name: number for name, number in numbers.items() if number is not None}


@lru_cache(maxsize=4096)
def _base_number(text: str, us: bool) -> float | None:
    """One value; None: it is no number. Many variants have few values."""
    number = number_of(parse_side(text, Mark("<variant>", 1, 1)))
    return None if number is None else float(number[0]) * in_base(number[1], us)


class Carried:
    """All parts of a problem carried out for many variants. `values`: numbers of given names, one for each variant."""

    def __init__(self, problem: WorkedProblem, values: Mapping[str, Numbers], model: ModelOf | None = None) -> None:
        self.problem, self.values, self.model = problem, values, model
        self.count = max(map(np.size, values.values()), default=1)
        self.runs: dict[str, Run] = {}
        self._earlier: dict[str, Numbers] = {}
        for part in problem.parts:
            if part.replay is not None:
                case = part.solution.case
                self.runs[case] = self._run(part, part.replay)
                for find in part.replay.equations.asked:
                    self._earlier[f"{case}.{find}"] = self.runs[case].asked(find)[0]

    def known(self, part: Part, replay: Replay) -> dict[sp.Symbol, Numbers]:
        """The inputs of a part that are others than in the file."""
        inputs = replay.equations.inputs
        varied = {n: v for n, v in self.values.items() if n not in part.own}
        return {inputs[n]: v for n, v in {**varied, **self._earlier}.items() if n in inputs}

    def _run(self, part: Part, replay: Replay) -> Run:
        known = self.known(part, replay)
        if self.model is None or self.model.case != part.solution.case:
            return replay.run(known)
        return self.model.run(known)

    def asked(self, part: Part, found: Found) -> tuple[Numbers, ...]:
        """A find in its unit, one array for each component; the same number throughout where a case rests on nothing
        that varies.
        """
        factor = 1.0 / in_base(found.unit, self.problem.problem.us)
        numbers = self.runs[part.solution.case].asked(found.name)
        return tuple(np.broadcast_to(v * factor, self.count) for v in numbers)


class ModelOf:
    """A model with a mistake in one part."""

    def __init__(self, case: str, model: Model, replay: Replay) -> None:
        self.case, self.model = case, model
        self.replay = replay if model.equations is replay.equations else Replay(model.equations, replay)

    def run(self, known: Mapping[sp.Symbol, Numbers]) -> Run:
        """The equations of the model for numbers of the given names."""
        base = self.replay.equations.value
        inputs = dict(known)
        for symbol, formula in self.model.inputs.items():
            numbers = {s: known.get(s, np.array([base[s]])) for s in formula.free_symbols}
            factor, rest = formula.as_coeff_Mul()
            if rest in numbers:
                # Ten times a datum: nothing is compiled for that.
                inputs[symbol] = float(factor) * numbers[rest]
                continue
            names = sorted(formula.free_symbols, key=lambda s: s.name)
            call = sp.lambdify([sp.Symbol(f"q{i}") for i in range(len(names))], _renamed(formula, names), "numpy")
            inputs[symbol] = np.asarray(call(*(numbers[s] for s in names)), dtype=float)
        return self.replay.run(inputs, start=self.model.start)


def _renamed(formula: sp.Expr, names: Sequence[sp.Symbol]) -> sp.Expr:
    renamed: sp.Expr = formula.xreplace({s: sp.Symbol(f"q{i}") for i, s in enumerate(names)})
    return renamed


def models_of(problem: WorkedProblem) -> list[tuple[str, ModelOf]]:
    """Every model of every mistake of the shelf, by the name of the mistake."""
    if problem.models is None:
        problem.models = _models_of(problem)
    return problem.models


def _models_of(problem: WorkedProblem) -> list[tuple[str, ModelOf]]:
    found: list[tuple[str, ModelOf]] = []
    for name, kind in members("homework.mistakes").items():
        mistake: Mistake = kind()
        for part in problem.parts:
            if part.replay is not None:
                case, hold_data = part.solution.case, part.replay.equations.hold_data
                for model in mistake.models(part.replay.equations, part.problem):
                    if hold_data and model.changes_data:
                        continue
                    # A model of which a formula has no value, as 1/g without the weight, tells of no mistake.
                    with suppress(NotWritten):
                        found.append((name, ModelOf(case, model, part.replay)))
    return found


# --- what is expected ------------------------------------------------------------------------------------------------


def expected_of(
    problem: WorkedProblem,
    part: Part,
    found: Found,
    values: tuple[float, ...],
    scale: float,
    own: Mapping[str, float],
) -> Expected:
    """One find with its numbers in its unit. `own`: the data of a variant, in base units."""
    what = found.find.found.what if found.find is not None else None
    equations = part.replay.equations if part.replay is not None else None
    last = what.parts[-1].kind if isinstance(what, Quantity) and what.parts else ""
    direction = last == "angle" and isinstance(what, Quantity) and what.word != "r"
    own = {n: v for n, v in own.items() if n not in part.own}
    couple = isinstance(what, Name) and what.name in couples_of(part.problem)
    rotation = not direction and (found.unit.angle or couple or (isinstance(what, Quantity) and what.word in TURNING))
    axis = last if last in ("x", "y") else ""
    # A moment has the same unit; of an energy it is the joule.
    unit = "J" if found.unit.text == "N*m" and is_energy(found.find) else found.unit.text
    return Expected(
        found.name,
        in_case(part.solution.case, part.problem, problem.problem, asked_words(found.find)),
        _kind(found),
        values,
        unit,
        key_text(found, unit, values, _sense(what, bool(rotation), axis)),
        tolerance_of(problem.problem, found.name),
        scale,
        rotation and (len(values) == 1 or found.values is None),
        direction,
        axis,
        heading=heading_of(what, equations, own),
        lines=lines_of(part.problem, equations, own) if len(values) == 2 else (),
        size=last == "mag",
        mode=mode_asked(found.find),
        us=problem.problem.us,
        gravity=gravity_of(equations, own, problem.problem.us),
    )


def _sense(what: object, rotation: bool, axis: str) -> tuple[str, str]:
    """The words for plus and for minus; "" where the number has its sign."""
    moves = isinstance(what, Quantity) and what.word in MOVES and len(what.parts) == 1
    return COUNTERCLOCKWISE if rotation else ALONG.get(axis, ("", "")) if moves else ("", "")


def with_other_number(base: Expected, found: Found, value: float) -> Expected | None:
    """A find that is one number, with another, of data with the same g; None: more of it than that rests on them."""
    if base.kind != "number" or base.heading is not None:
        return None
    what = found.find.found.what if found.find is not None else None
    text = key_text(found, base.unit, (value,), _sense(what, base.rotation, base.axis))
    return replace(base, values=(value,), text=text)


def _kind(found: Found) -> str:
    if found.word:
        return "word"
    if found.values is None:
        return "equation" if found.kind == "curve" else "formula"
    return found.kind if found.kind in ("vector", "list") else "number"


def tolerance_of(problem: Problem, find: str) -> float:
    """Relative: of this answer, else of the file, else one per cent."""
    own = next((a.tolerance for a in problem.answers if a.name == find), None)
    for side in (own, problem.tolerance):
        number = None if side is None else number_of(side)
        if number is not None:
            return float(number[0] * number[1].factor)
    return 0.01


def scale_of(part: Part, unit: Unit, us: bool) -> float:
    """The largest given quantity of a dimension, in a unit; one of that unit where there is none."""
    sizes = []
    if part.replay is not None:
        equations: Equations = part.replay.equations
        for symbol in equations.inputs.values():
            other = equations.units.get(symbol)
            if other is not None and other.dimension == unit.dimension:
                sizes.append(abs(equations.value[symbol]) / in_base(unit, us))
    return max(sizes, default=0.0) or 1.0


def base_expected(problem: WorkedProblem) -> tuple[Expected, ...]:
    """All finds of the file as it is, with what mistakes give."""
    found: list[Expected] = []
    us = problem.problem.us
    for part, one in problem.finds:
        values = tuple(float(v) / in_base(one.unit, us) for v in one.values or ())
        made = expected_of(problem, part, one, values, scale_of(part, one.unit, us), {})
        found.append(_with_formula(made, part, one) if made.kind in ("formula", "equation") else made)
    return tuple(found)


def _with_formula(made: Expected, part: Part, one: Found) -> Expected:
    """A formula, as a problem file writes it, with its letters and what mistakes make of it."""
    expr = sp.sympify((one.expressions or (sp.S.Zero,))[0])
    if len(one.expressions or ()) != 1:
        raise Undecided(f"{one.name} is no single formula; a homework asks for its components one by one")
    ledger = ledger_of(part)
    letters = tuple((s.name, _unit_text(ledger, s)) for s in sorted(expr.free_symbols, key=lambda s: s.name))
    if isinstance(expr, sp.Eq):
        text = f"{as_written(expr.lhs)} = {as_written(expr.rhs)}"
        return replace(made, formula=text, letters=tuple((n, "1") for n, _ in letters), text=text)
    text = as_written(expr)
    mistakes = wrong_formulas(expr, letters, part.problem, ledger) if ledger is not None else ()
    return replace(made, formula=text, letters=letters, text=text, mistakes=mistakes)


def ledger_of(part: Part) -> Any:
    """The names of a part with their values; None: it has none."""
    solution = part.solution
    if solution.motion is not None:
        return solution.motion.ledger
    return solution.instants[-1].instant.scene.ledger if solution.instants else None


def _unit_text(ledger: Any, symbol: sp.Symbol) -> str:
    unit = ledger.units.get(symbol) if ledger is not None else None
    return unit.text if unit is not None else "1"
