"""No consistent case, or several."""

from __future__ import annotations

from decimal import Decimal

from planar_cli.errors import Diagnostic, Mark, NoSolution
from planar_cli.problem.scene.facts import Mode, Test
from planar_cli.solve.diagnosis.words import in_unit, listed, push_name
from planar_cli.solve.instant.instant import Instant, Trial
from planar_cli.solve.solution import Found
from planar_cli.units import parse_unit

MOST_TOLD = 4
OTHER_WAY = "it slides the other way"
WRONG_WAY = {"normal": "pull", "tension": "push"}


def no_case(instant: Instant, rejected: list[Trial], mark: Mark) -> Diagnostic:
    """Every choice of modes contradicts its own assumption."""
    tried = [t for t in rejected if t.objection not in ("velocities", OTHER_WAY)] or rejected
    steady = list(dict.fromkeys(_why(t) for t in tried))
    more = f"; and {len(steady) - MOST_TOLD} more" if len(steady) > MOST_TOLD else ""
    joint = next((j for j, m in instant.modes if len(m) > 1), None)
    at = joint.mark if joint is not None and len(instant.modes) and _rough(instant) == 1 else mark
    text = f"no consistent rigid solution: {'; '.join(steady[:MOST_TOLD])}{more}"
    return Diagnostic(
        at,
        "PL601",
        text,
        "with dry friction rigid bodies may have none (they jam): lower the friction, or give other velocities",
    )


def _rough(instant: Instant) -> int:
    """How many joints have several modes."""
    return sum(len(m) > 1 for _, m in instant.modes)


def assumption(trial: Trial) -> str:
    """The modes of a trial in words."""
    words = [m.words for m in trial.system.modes.values() if m.words]
    return " and ".join(words) or "as drawn"


def _why(trial: Trial) -> str:
    """One rejected choice, such as `if rod at A slips, N(A) = -49.41 N would pull`."""
    if trial.objection == "velocities":
        return f"that {assumption(trial)} contradicts the velocities"
    if trial.objection == "contradiction":
        return f"if {assumption(trial)}, the equations contradict each other"
    if trial.tests:
        return f"if {assumption(trial)}, {_failed(trial, *trial.tests[0])}"
    return f"if {assumption(trial)}, {trial.objection}"


def _failed(trial: Trial, test: Test, value: Decimal | None) -> str:
    """What the failed test measures."""
    outcome, system = trial.outcomes[0], trial.system
    pushes = {p.name: p for p in system.pushes}
    named = [(pushes[n], v) for n, _ in test.pushes if n in pushes and (v := outcome.push(n)) is not None]
    told = system.scene.ledger.symbolic or not named
    if test.joining is not None:
        return "its point moves into the partner at once"
    if told:
        return f"it fails that {test.words}"
    numbers = [f"{push_name(system, p)} = {in_unit(v, parse_unit(p.unit), system.scene.ledger.us)}" for p, v in named]
    if len(named) == 1 and named[0][0].kind in WRONG_WAY and not test.constant:
        return f"{numbers[0]} would {WRONG_WAY[named[0][0].kind]}"
    return f"{listed(numbers)}: it fails that {test.words}"


# --- several ---------------------------------------------------------------------------------------------------------


def several(instant: Instant, held: list[Trial]) -> list[Trial]:
    """The outcomes that hold at once and differ in motion, told apart."""
    if len(held) < 2:
        return held
    pressing = [
        t
        for t in held
        if not any(_apart_of_either_side(m, i) for (_, m), i in zip(instant.modes, t.choice, strict=True))
    ]
    return pressing or held


def _apart_of_either_side(modes: tuple[Mode, ...], index: int) -> bool:
    """Lifting off where the side of the contact is open: it counts only when no side presses."""
    if modes[index].name != "apart":
        return False
    normals = {a.force for m in modes for p in m.facts.pushes if p.kind == "normal" for a in p.actions[:1]}
    return len(normals) > 1


def several_cases(instant: Instant, held: list[Trial], values: list[list[Found]], mark: Mark) -> NoSolution:
    """The report of all outcomes with their answers."""
    told = []
    for number, (trial, found) in enumerate(zip(held, values, strict=True), 1):
        answers = [text for f in found if (text := _answer(f, instant.scene.ledger.us))]
        told.append(f"({number}) {assumption(trial)}" + (f": {', '.join(answers)}" if answers else ""))
    text = f"{len(held)} consistent solutions: {'; '.join(told)}"
    joint = next((j for j, _ in instant.modes if any(t.system.modes[j.name].words for t in held)), None)
    wanted = (
        f"say which, such as `mode({instant.aliases[joint.name]}) = {held[0].system.modes[joint.name].name}`"
        if joint is not None
        else "say which"
    )
    return NoSolution([Diagnostic(mark, "PL612", text, wanted)])


def _answer(found: Found, us: bool) -> str:
    """`alpha = -48.85 rad/s^2`."""
    if found.values is None:
        return f"{found.name} = {found.word}" if found.word else ""
    parts = [in_unit(v, found.unit, us) for v in found.values]
    return f"{found.name} = {parts[0] if len(parts) == 1 else '[' + ', '.join(parts) + ']'}"
