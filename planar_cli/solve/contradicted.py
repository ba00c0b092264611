"""Finds that a motion followed by independent facts contradicts, and the refusal that tells both values."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

from planar_cli.equation.values.ledger import display
from planar_cli.errors import Diagnostic
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import record
from planar_cli.solve.diagnosis.words import in_unit
from planar_cli.solve.instances import Instance
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.units import Unit, parse_unit

DIFFERENT = "PL720"
HINT = "please report it with the file; `planar simulate` prints the motion that was followed"


@record
class Seen:
    """One find, compared."""

    name: str
    why: str = ""
    """Why it could not be compared."""
    other: str = ""
    """What following the motion gives, where that is something else."""
    found: str = ""
    """What was solved, then."""
    where: str = ""
    """When."""


def disagreement(problem: Problem, wrong: list[Seen], instance: Instance) -> Disagreement:
    """The refusal, with both values of every find that differs."""
    values = {s: Decimal(repr(instance.taken.letters[s.name])) for s in problem.symbols}
    drawn = ", ".join(f"{s.name} = {in_unit(v, parse_unit(s.unit or '1'), problem.us)}" for s, v in values.items())
    diagnostics = tuple(_told(problem, wrong, f", for {drawn}" if drawn else ""))
    return Disagreement("; ".join(f"{d.mark.file}:{d.mark.line}: {d.message}" for d in diagnostics), diagnostics)


def _told(problem: Problem, wrong: list[Seen], drawn: str) -> Iterator[Diagnostic]:
    marks = {f.name: f.mark for f in problem.find}
    for s in wrong:
        text = f"{s.name} is not confirmed: solved {s.found}, in the motion followed by independent facts {s.other}"
        text += f"{drawn} ({s.where})" if s.where else drawn
        yield Diagnostic(marks[s.name], DIFFERENT, text, HINT)


def shown(values: list[Decimal], unit: Unit, us: bool) -> str:
    """Numbers in a unit, to more digits than agree."""
    numbers = ", ".join(f"{float(display(v, unit, us)):.9g}" for v in values)
    text = numbers if len(values) == 1 else f"[{numbers}]"
    return f"{text} {unit.text}" if unit.text != "1" else text
