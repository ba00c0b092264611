"""What typical mistakes give where a motion is followed in numbers: the same motion followed without an effect, or with
other data.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from planar_cli.base_units import in_base
from planar_cli.errors import PlanarError
from planar_cli.homework.grading.changed_data import changed_data
from planar_cli.homework.grading.what_mistakes_give import is_clearly_wrong
from planar_cli.homework.mistakes.base import Mistake
from planar_cli.homework.sets.paper import Expected, Mistaken
from planar_cli.homework.sets.powers_of_ten import is_of_a_datum
from planar_cli.homework.variants.literal_data import with_names
from planar_cli.homework.variants.worked_problem import Part, WorkedProblem
from planar_cli.problem.nodes.reading import listed
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.sections.variations import with_first_values, with_values
from planar_cli.problem.structure import problem_of
from planar_cli.registry import members
from planar_cli.simulate.effects import known_effects, without
from planar_cli.simulate.run import Settings, simulate
from planar_cli.solve.solution import Found

ONCE = Settings(estimate=False, balanced=False, check=False)
MOST = 30
"""Of so many, the file and its variants, data are changed at most: each mistake is a motion to be followed."""
FEW = 5
"""Of so many at most, data are also a power of ten off, which is six motions for each of them."""
SAME = 1e-3
"""Relative: what is followed gives what was found, if not, its mistakes say nothing."""
Numbers = dict[str, tuple[float, ...]]


def with_followed(
    problem: WorkedProblem, rows: Sequence[tuple[Expected, ...]], values: Sequence[Mapping[str, str]]
) -> list[tuple[Expected, ...]]:
    """The finds of each variant; those that no written equations give, with what the motion gives without friction,
    without the weight, without its springs, and with data as they are often got wrong. `values`: of the file and of
    the variants, as a file writes them; of more than `MOST` data are not changed, which `left_out` tells.
    """
    parts = [(part, finds) for part in problem.parts if (finds := _followed_finds(part))]
    made = list(rows)
    for part, finds in parts:
        if not _is_followed_the_same(problem, part, finds, rows[0]):
            continue
        for k, own in enumerate(values):
            earlier = _earlier(problem, rows[k])
            own_problem = _problem(problem, part, own)
            if own_problem is None:
                continue
            wrong = list(_without_effects(own_problem, finds, earlier))
            if len(values) <= MOST:
                wrong += _with_other_data(problem, part, own_problem, (own, earlier), finds, len(values) <= FEW)
            made[k] = tuple(_with(e, wrong) if e.find in {f.name for f in finds} else e for e in made[k])
    return made


def left_out(problem: WorkedProblem, count: int) -> Iterator[str]:
    """What is to be said of mistakes that are not looked for in so many variants, that of the file among them."""
    names = [f.name for part in problem.parts for f in _followed_finds(part)] if count > FEW else []
    if names:
        told = f"{listed(names, 'and')} {'is' if len(names) == 1 else 'are'} found by following a motion in numbers"
        most, what = (
            (MOST, "mistakes in its data, as sine for cosine,") if count > MOST else (FEW, "data ten times off")
        )
        yield f"{told}; in {most} variants or more {what} are not told there"


def _followed_finds(part: Part) -> list[Found]:
    """The numbers of a motion that do not follow from equations."""
    if part.solution.followed is None and part.solution.motion is None:
        return []
    asked = part.replay.equations.asked if part.replay is not None else {}
    plain = not part.problem.symbols
    return [f for f in part.solution.found if plain and f.values and f.name not in asked and f.kind != "list"]


def _earlier(problem: WorkedProblem, row: Sequence[Expected]) -> dict[str, float]:
    """The finds of cases as later cases use them, in base units."""
    right = {e.find: e.values for e in row}
    us = problem.problem.us
    return {
        f"{p.solution.case}.{f.name}": right[f.name][0] * in_base(f.unit, us)
        for p, f in problem.finds
        if len(right.get(f.name, ())) == 1
    }


def _is_followed_the_same(problem: WorkedProblem, part: Part, finds: Sequence[Found], row: Sequence[Expected]) -> bool:
    us, numbers = problem.problem.us, _numbers(part.problem, finds, _earlier(problem, row))
    for f in finds:
        due = [float(v) / in_base(f.unit, us) for v in f.values or ()]
        got = numbers.get(f.name, ())
        if len(got) != len(due) or any(abs(a - b) > SAME * max(map(abs, due)) for a, b in zip(got, due, strict=True)):
            return False
    return bool(finds)


def _problem(problem: WorkedProblem, part: Part, values: Mapping[str, str]) -> Problem | None:
    """The part with the numbers of a variant; None: these make no problem."""
    if not values:
        return part.problem
    whole, wrong = problem_of(problem.path, with_values(with_names(with_first_values(problem.node)), values), [])
    if whole is None or wrong:
        return None
    return next((c.problem for c in whole.cases if c.name == part.solution.case), whole)


def _without_effects(
    problem: Problem, finds: Sequence[Found], earlier: Mapping[str, float]
) -> Iterator[tuple[str, str, Numbers]]:
    """By mistake: its name, what it says, and what comes out without its effect."""
    known = known_effects(problem)
    for name, kind in members("homework.mistakes").items():
        mistake: Mistake = kind()
        if mistake.effect in known:
            said = f"this is the result without {'the weight' if mistake.effect == 'weight' else mistake.effect}"
            yield name, said, _numbers(without(problem, [mistake.effect]), finds, earlier)


def _with_other_data(
    problem: WorkedProblem,
    part: Part,
    own: Problem,
    known: tuple[Mapping[str, str], Mapping[str, float]],
    finds: Sequence[Found],
    powers: bool,
) -> Iterator[tuple[str, str, Numbers]]:
    """By mistake: its name, what it says, and what comes out with its data. `own`: the part with the numbers of a
    variant; `known`: these, and the finds of earlier cases; `powers`: may data be a power of ten off?
    """
    values, earlier = known
    for name, said, data in changed_data(own):
        if is_of_a_datum(said) and not powers:
            continue
        changed = _problem(problem, part, {**values, **data})
        if changed is not None:
            yield name, said, _numbers(changed, finds, earlier)


def _numbers(problem: Problem, finds: Sequence[Found], earlier: Mapping[str, float]) -> Numbers:
    """What the motion answers, in the units of the finds; nothing where it cannot be followed."""
    try:
        answers = simulate(problem, replace(ONCE, values=earlier), {f.name: f.unit.text for f in finds}).answers
    except PlanarError:
        return {}
    units = {f.name: in_base(f.unit, problem.us) for f in finds}
    return {a.name: tuple(v / units[a.name] for v in a.values) for a in answers if a.name in units and not a.why}


def _with(expected: Expected, wrong: Sequence[tuple[str, str, Numbers]]) -> Expected:
    more = [Mistaken(n, said, numbers[expected.find]) for n, said, numbers in wrong if expected.find in numbers]
    # What a step of the motion gives stands before slips at the end.
    fit = tuple(m for m in more if is_clearly_wrong(expected, m.values))
    return replace(expected, mistakes=(*fit, *expected.mistakes))
