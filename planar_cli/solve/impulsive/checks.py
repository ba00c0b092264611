"""Checks of blows: all impulses and velocities solved at once, the energy lost, and whether another outcome fits too.

The second road takes every body by itself, with all joints and impulses together, and no plan of equations.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.kinematics.motion import Twist
from planar_cli.equation.values.exact import Unvalued, Valuation
from planar_cli.errors import Diagnostic, NoSolution, NoValue
from planar_cli.joints.base import Joint
from planar_cli.problem.scene.geometry import Vec
from planar_cli.solve.between.branches.solved_motion import SolvedMotion
from planar_cli.solve.diagnosis.words import short
from planar_cli.solve.impulsive.impact import Blow
from planar_cli.solve.instant.instant import Trial
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.solve.instant.worked import unknowns_of

NEEDED, FULL, MOST_CHOICES = 6, 50, 60
SAME = Decimal("1e-12")


def blow_checks(found: SolvedMotion) -> Iterator[str]:
    """What is said of the blows of a motion, in phrases. Disagreement: the roads differ."""
    far = {} if found.followed is None else found.followed.far
    for i, blow in found.course.blows.items():
        try:
            yield from _checked(blow, found.value, far.get(i))
        except (NoValue, Unvalued):
            continue


def _checked(blow: Blow, value: Valuation, far: frozenset[str] | None) -> Iterator[str]:
    """`far`: impacts whose bodies are apart; None: nothing tells."""
    name = f"the blow from {blow.since.name} to {blow.stop.name}"
    here = blow.numbers(value)
    trial = blow.struck.try_choice(blow.choice, (here,))
    if not trial.outcomes:
        return
    digits = _digits(trial, value)
    if digits is not None and digits < NEEDED:
        raise Disagreement(f"{name}: all impulses at once give other velocities")
    if digits is not None:
        yield f"{name} solved at once for all bodies: agrees to {digits} digits"
    if not _symbolic(blow):
        _demand_restitution(blow, trial, here, name)
    if not _symbolic(blow) and not blow.scene.problem.loads:
        lost = _energy_lost(blow, trial, here)
        if lost < -SAME * _energy(blow, here):
            yield f"{name} makes kinetic energy: its data can not be right"
    idle = [(joint, words) for joint, words in _idle(blow, trial) if joint.during or joint.name not in (far or ())]
    if idle and blow.since.name != blow.scene.problem.states[0].name and not _acts(blow, trial):
        # From a later state the bodies may have changed sides since they were drawn.
        raise NoSolution([_nothing_strikes(blow, joint, words) for joint, words in idle])
    for joint, words in idle:
        if joint.during:
            yield f"{words} at {blow.since.name}: no impulse there"
    for other in _others(blow, trial, here, far):
        words = ", ".join(m.words for m in other.system.modes.values() if m.words)
        yield f"{name} may also end otherwise: {words}"


def _idle(blow: Blow, trial: Trial) -> Iterator[tuple[Joint, str]]:
    """The impacts of this blow that do not act, with why."""
    for joint in blow.struck.joints:
        mode = trial.system.modes.get(joint.name)
        if mode is not None and mode.name == "apart" and joint.strikes:
            yield joint, mode.words


def _acts(blow: Blow, trial: Trial) -> bool:
    """Is there any impulse in the blow?"""
    return bool(blow.struck.scene.problem.loads) or any(trial.outcomes[0].push(name) for name in trial.system.symbols)


def _nothing_strikes(blow: Blow, joint: Joint, words: str) -> Diagnostic:
    text = (
        f"{words} in state {blow.since.name}, seen from the side on which they are drawn: nothing happens in the blow"
    )
    hint = "begin the motion in a state on that side from which they strike"
    if joint.during is None:
        span = f"{blow.since.name}->{blow.stop.name}"
        hint = f"a straight line has no end: `during: {span}` lets it be struck in this blow alone, whence they come"
    return Diagnostic(joint.mark, "PL626", text, hint)


def _demand_restitution(blow: Blow, trial: Trial, here: Valuation, name: str) -> None:
    """NoSolution: the data make bodies part faster than they approached, or still approach."""
    wrong = []
    for joint in blow.struck.joints:
        mode = trial.system.modes.get(joint.name)
        ratio = joint.restitutes(blow.scene) if joint.strikes and mode is not None and mode.name != "apart" else None
        if ratio is None:
            continue
        number = here(sp.sympify(ratio))
        if -SAME <= number <= 1 + SAME:
            continue
        wrong.append(_no_restitution(joint, name, number))
    if wrong:
        raise NoSolution(wrong)


def demand_restitutions(blows: Iterable[Blow], values: Sequence[Valuation]) -> None:
    """NoSolution: whichever of these values constants have, a coefficient of restitution is none."""
    wrong = [next((d for blow in blows for d in _without_restitution(blow, value)), None) for value in values]
    if wrong and wrong[0] is not None and all(d is not None for d in wrong):
        raise NoSolution([wrong[0]])


def _without_restitution(blow: Blow, value: Valuation) -> Iterator[Diagnostic]:
    name = f"the blow from {blow.since.name} to {blow.stop.name}"
    for joint in blow.struck.joints if not _symbolic(blow) else ():
        ratio = joint.restitutes(blow.scene) if joint.strikes else None
        number = None if ratio is None else value.known(sp.sympify(ratio))
        if number is not None and not -SAME <= number <= 1 + SAME:
            yield _no_restitution(joint, name, number)


def _no_restitution(joint: Joint, name: str, number: Decimal) -> Diagnostic:
    found = f"the data of {name} make the coefficient of restitution {short(number)}"
    why = "bodies do not part faster than they approached" if number > 1 else "they would pass through each other"
    hint = "correct the speeds or masses: it lies between 0 and 1"
    if number < 0:
        hint += "; what one body shoots through gets an unknown `impulse` instead, and the other its opposite"
    return Diagnostic(joint.mark, "PL619", f"{found}: {why}", hint)


def _symbolic(blow: Blow) -> bool:
    """Do letters of the file stay in it?"""
    return bool(blow.struck.scene.problem.symbols)


def _digits(trial: Trial, value: Valuation) -> int | None:
    """To how many digits the equations of the plan and the whole system agree."""
    worst: int | None = None
    unknowns = unknowns_of(trial.system, trial.outcomes[0])
    size = max((abs(v) for v in unknowns.values()), default=Decimal(0))
    for s, number in unknowns.items():
        if s in value.values and size:
            off = abs(value(s) - number) / size
            digits = FULL if not off else min(int(-off.log10()), FULL) if off < 1 else 0
            worst = digits if worst is None else min(worst, digits)
    return worst


def _energy(blow: Blow, here: Valuation, twists: dict[str, Twist] | None = None) -> Decimal:
    """The kinetic energy with which bodies arrive, or that of other twists."""
    total: sp.Expr = sp.S.Zero
    for name, body in blow.scene.bodies.items():
        twist = blow.scene.before[name] if twists is None else twists[name]
        v: Vec = twist.linear + (body.center - twist.point).turned() * twist.angular
        total += body.mass * v.dot(v) / 2 + body.inertia * twist.angular**2 / 2
    return here(total)


def _energy_lost(blow: Blow, trial: Trial, here: Valuation) -> Decimal:
    motion = trial.system.motion
    assert motion is not None
    after = here.extended(unknowns_of(trial.system, trial.outcomes[0]))
    return _energy(blow, here) - _energy(blow, after, motion.accelerations)


def _others(blow: Blow, trial: Trial, here: Valuation, far: frozenset[str] | None) -> Iterator[Trial]:
    """Other modes that hold as well, with other velocities after the blow."""
    kept = _velocities(trial)
    size = max((abs(v) for v in kept.values()), default=Decimal(0)) or Decimal(1)
    for choice in itertools.islice(blow.struck.choices(), MOST_CHOICES):
        if choice == blow.choice or (far is not None and not blow.fits(choice, far)):
            continue
        other = blow.struck.try_choice(choice, (here,))
        if other.objection or not other.outcomes:
            continue
        if any(abs(v - kept[k]) > SAME * size for k, v in _velocities(other).items()):
            yield other


def _velocities(trial: Trial) -> dict[object, Decimal]:
    """Velocities after a blow by body and component."""
    outcome = trial.outcomes[0]
    return {k: outcome.solved.values[j] for k, j in outcome.assembly.columns.items() if isinstance(k, tuple)}
