"""The contract of the shelf of principles: what each says of a scene, as equations that it offers.

A member is one file with one final class; its docstring is its manual page. It offers equations

- at an instant (`at_instant`), in accelerations and reactions: families of equations of one body (`BodyFamily`), from
  which the plan chooses directions and moment centres for bodies and groups, or single equations (`Single`);
- over any stretch of time in one regime (`over`): balances of an amount between its ends (`Balance`), or what comes of
  its equations at an instant when they are integrated (`Integrated`, `Impulses`);
- across a sudden change (`across`), in the velocities after it and in impulses: families as at an instant.

The plan compares what all of them offer and takes the shortest way; `method:` leaves one of them alone. Every offer
bears its cost and the words in which it is told. A principle that offers nothing answers nothing.
"""

from __future__ import annotations

from abc import ABC
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, ClassVar

from planar_cli.records import record

if TYPE_CHECKING:
    import sympy as sp

    from planar_cli.equation.kinematics.motion import Motion
    from planar_cli.equation.scene.displacement import Coordinate
    from planar_cli.equation.system.system import System
    from planar_cli.equation.values.exact import Valuation


@record
class Position:
    """A scene in one choice of modes, its velocities settled: what a principle may ask."""

    system: System
    """All unknowns and conditions, reactions and wrenches."""
    motion: Motion
    """Velocities and accelerations of bodies and of their points."""
    value: Valuation
    """Numbers of everything, for questions of sign and of zero."""
    coordinates: tuple[Coordinate, ...] = ()
    """What varies in a general position; empty in a position as drawn."""
    rates: tuple[tuple[sp.Symbol, sp.Symbol], ...] = ()
    """Every velocity unknown with the acceleration unknown that is its rate."""

    @property
    def time(self) -> sp.Symbol:
        """The letter t."""
        time: sp.Symbol = self.system.scene.ledger.symbols["t"]
        return time


# --- at an instant, across a sudden change ---------------------------------------------------------------------------


@record
class BodyFamily:
    """All equations of one body: any combination of three residuals that vanish."""

    body: str
    x: sp.Expr
    """Along x [N]."""
    y: sp.Expr
    """Along y [N]."""
    moment: sp.Expr
    """About the origin [N m]."""


@record
class Premise:
    """A line that stands before an equation: what something in it is."""

    name: str
    """What it is called, in mathematical notation: T."""
    formula: sp.Expr
    words: str


@record
class Single:
    """One equation of a whole scene, left = right."""

    left: sp.Expr
    right: sp.Expr
    words: str
    """Its heading."""
    lead: str
    """What is equated, before the formulas, names of symbols between backquotes; "" for nothing."""
    cost: float
    """Beside equations of bodies, of which one along an axis costs 1."""
    premises: tuple[Premise, ...] = ()


Family = BodyFamily | Single


# --- over a stretch of time ------------------------------------------------------------------------------------------


@record
class Stored:
    """The potential of a source by what it depends on: factor · measure, or factor · measure²/2 (power 2)."""

    factor: sp.Expr
    """The weight m g [N], or the stiffness k [N/m]."""
    measure: sp.Expr
    """The height y_G of the mass centre, or the stretch s of a spring [m]."""
    power: int
    """1 or 2."""
    letter: str
    """The name of the measure, without the state: y_G, s."""


@record
class Source:
    """What changes an amount, at a rate, in the unknowns of the general position."""

    words: str
    rate: sp.Expr
    function: sp.Expr | None = None
    """A function of place and time of which the rate is the derivative; None: it is looked for."""
    stored: Stored | None = None
    """What that function is made of, where the load says it."""


@record
class Moving:
    """What the kinetic energy m v²/2 + I ω²/2 of one body is made of, in the unknowns of the general position."""

    body: str
    mass: sp.Expr
    """m [kg]."""
    inertia: sp.Expr
    """I about the mass centre [kg m²]."""
    vx: sp.Expr
    """Of the mass centre, along x [m/s]."""
    vy: sp.Expr
    omega: sp.Expr
    """Of turning [rad/s]."""
    center: str
    """The name of the mass centre."""
    why: str = ""
    """How the body is led, so that its mass centre has this velocity."""
    rolls: bool = False
    """Is that by rolling? Where a coordinate tells the place of its mass centre, this is why it turns as it does."""
    place: tuple[sp.Expr, ...] = ()
    """x and y of the mass centre [m], where energies are told of it."""
    resting: tuple[str, sp.Expr] | None = None
    """The point that is its instantaneous centre at the end, with the velocity in general [m/s], along one axis."""


@record
class Storage:
    """What a weight or a spring brings between two states, by what its potential is made of."""

    words: str
    """The words of the source."""
    factor: sp.Expr
    """m g [N], or the stiffness k [N/m]."""
    first: sp.Expr
    """The height y or the stretch s at the beginning [m]."""
    last: sp.Expr
    """The same at the end."""
    power: int
    """1: factor · (first - last); 2: factor · (first² - last²)/2."""
    letter: str
    """The name of height or stretch, without the state."""
    alike: tuple[str, ...] = ()
    """The names of other heights that are the same at both states, without these."""

    @property
    def brought(self) -> sp.Expr:
        """What it brings [J]."""
        return self.factor * (self.first**self.power - self.last**self.power) / self.power


@record
class EnergyParts:
    """The parts of the energies of one balance."""

    moving: tuple[Moving, ...]
    """Of every body at the end of the balance, in letters of that state."""
    storages: tuple[Storage, ...]
    """Of the sources that have a potential of such parts."""
    midway: tuple[tuple[tuple[str, ...], str], ...] = ()
    """Of several equal bodies, between which points their common mass centre is halfway, in words."""


@record
class Idle:
    """A reaction that does no work, and why that is so in two or three words; "": nothing short tells it."""

    force: sp.Symbol
    why: str


@record
class Balance:
    """amount at the end - amount at the beginning = Σ what the sources bring, over any stretch of time."""

    words: str
    """The law by name: work and kinetic energy."""
    name: str
    """What it balances, in mathematical notation, before the equation: H_O. "": nothing."""
    amounts: tuple[tuple[str, sp.Expr], ...]
    """The amount, by body, in the unknowns of the general position."""
    sources: tuple[Source, ...]
    cost: float
    """Beside a law of motion, of which q(t) costs 1."""
    bodies: tuple[str, ...] = ()
    """Whose amount it is, in the heading; empty: of the whole system."""
    heading: str = ""
    """The law in the heading of an equation; "": its name."""
    kept: str = ""
    """The same where no source brings anything: conservation of momentum; "": as ever."""
    about: str = ""
    """The point it is taken about, the end of the heading."""
    explained: str = ""
    """What that point is, after it."""
    passing: tuple[sp.Expr, ...] = ()
    """The forces through that point, which have no moment about it."""
    letter: str = ""
    """The letter of the amount: then amounts and what sources bring are told one by one, T_1 + U = T_2."""
    bring: str = ""
    """The letter of what a source brings."""
    lead: str = ""
    """What stands before the equation: → ↑ ↺."""
    idle: tuple[Idle, ...] = ()
    """Reactions that bring nothing, which is told."""
    internal: tuple[sp.Symbol, ...] = ()
    """Reactions between bodies that move, which bring nothing in all: what one body gets another gives."""
    adds: bool = False
    """Does it run on through regimes that follow each other?"""
    timeless: bool = False
    """Is it only put on paper where no time enters it?"""
    moving: tuple[Moving, ...] = ()
    """Of kinetic energies, what each is made of."""
    longest: int = 300
    """With more operations an amount, or what a source brings, is not put on paper."""


@record
class Integrated:
    """The equations of motion that follow from those at an instant, integrated from state to state."""


@record
class Impulses:
    """Every equation of bodies at an instant whose coefficients are constant, integrated over time, with letters for
    the impulses of reactions.
    """

    words: str
    """The law by name."""
    cost: float
    """As that of a balance."""


Over = Balance | Integrated | Impulses


class Principle(ABC):
    """What a principle says of itself, and what it offers. Everything that it does not offer stays empty."""

    kind: ClassVar[str]
    """The word of `method:` and `--method`."""
    title: ClassVar[str] = ""
    """Its name in a JSON document; "": its kind."""
    diagram: ClassVar[str] = ""
    """What is drawn, as the heading of the kinetic analysis says it."""
    usual: ClassVar[bool] = False
    """Is it taken at an instant where nobody names another that has equations there?"""
    inertia_as_force: ClassVar[bool] = False
    """Does inertia stand among the forces of the diagram?"""
    general: ClassVar[bool] = False
    """Does it need the coordinates of a general position, also at an instant?"""
    alone: ClassVar[str] = ""
    """What relates states even where no motion leads from one to the other, in words; "": nothing of it does."""

    def at_instant(self, position: Position) -> Iterable[Family]:
        """Equations between accelerations and forces."""
        return ()

    def over(self, position: Position, chosen: bool) -> Iterable[Over]:
        """Equations between the ends of a stretch of time. `chosen`: no other principle may take part."""
        return ()

    def of_part(self, position: Position, body: str, words: str, pull: sp.Expr) -> Balance | None:
        """The balance of one body on which one reaction alone works, at the rate `pull`, which is told by `words`."""
        return None

    def across(self, position: Position) -> Iterable[Family]:
        """Equations between velocities after a sudden change and impulses; the accelerations and forces of `position`
        are these, and its wrenches hold the momenta before.
        """
        return ()

    @classmethod
    def offers(cls, when: str) -> bool:
        """Has it equations of this kind: `at_instant`, `over`, `across`?"""
        return getattr(cls, when) is not getattr(Principle, when)

    def objection(self, problem: Any) -> str:
        """Why the principle can not answer this problem; "" when it may. `problem`: a problem.scene.Problem."""
        if not any(self.offers(when) for when in ("at_instant", "over", "across")):
            return "it offers no equation"
        if not self.offers("at_instant") and not relates_states(problem):
            return "it relates two states, and this problem asks about one instant"
        return ""

    def sides(self, left: Any, right: Any) -> tuple[Any, Any]:
        """The equation's sides, from Σ forces (left) and inertia (right)."""
        return left, right


def relates_states(problem: Any) -> bool:
    """Does the problem, or a case of it, have two states between which something happens?"""
    return any(len(p.states) > 1 for p in (problem, *(case.problem for case in problem.cases)))
