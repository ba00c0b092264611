"""Which principles a page names at its head: what its trace used, with the formula of the course that it prints."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Name, Text
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.kinematics.by_centre import ABOUT_CENTRE, FROM_CENTRE
from planar_cli.report.kinetics.free_flight import is_flight
from planar_cli.report.page.uses import OVER_TIME, Uses
from planar_cli.report.words.points_of_principles import in_letters, placed_from, turned_about
from planar_cli.solve.law import RELATIVE as ALIKE
from planar_cli.solve.passages import ALONG, CURVE, PLACES, RADIAL, RATES, ROLLING, SECOND_RATES

CROSS, DOUBLED, CORIOLIS, RELATIVE = " × ", " + 2 ", "a_cor", "a_rel"
"""The product in v = ω × r; what stands before that of a Coriolis acceleration; its name and that of a_rel."""
LENGTHS = {
    "rope": "A cord of constant length.",
    "link": "A link of constant length.",
    "belt": "The belt does not slip: both rims have its speed.",
}
DERIVATIVES = "Velocity and acceleration as derivatives: v = ds/dt, a = dv/dt."
ROLLS = "Rolling without slipping: the points that touch have the same velocity."
ROLLS_BY_ARC = "Rolling without slipping: the centre advances by the arc r φ (φ in radians)."
POSITIONS = "Position vectors: r_B = r_A + r_B/A."
POLAR = "Polar coordinates: v_r = ṙ, v_θ = r θ̇; a_r = r̈ - r θ̇², a_θ = r θ̈ + 2 ṙ θ̇."
STREAM = "Momentum of a stream: its force is the mass per second times its velocity."
EXTREME = "A largest or smallest value: there its derivative is zero."
FLIGHT = "Free flight: its weight alone accelerates a body, whatever its mass."
RADIAN = "rad"
TURNING = ("↺ ", "↻ ")
"""The lead of a balance of moments or of angular momentum."""
DALEMBERT = "d'Alembert's principle: with the inertial forces each body is in equilibrium."


@record
class Printed:
    """Formulas of kinematics that a page prints. `names`: in its equations; `levels`: v, a of the points of bodies that
    turn; `coriolis`: 2 ω × v_rel; `in_turn`: what is asked as the derivative of what stands before it; `centre`: an
    instantaneous centre; `turned`, `placed`: the points of ω × r_B/A and of r_B = r_A + r_B/A.
    """

    names: frozenset[str]
    levels: frozenset[str]
    coriolis: bool
    in_turn: bool
    centre: bool
    turned: tuple[str, str]
    placed: tuple[str, str]
    flight: bool
    """Is what moves told as a free flight?"""


def principles(uses: Uses, page: Sequence[Block]) -> list[str]:
    """What the head of a page names, a sentence for each."""
    found = _printed(page)
    told = list(_laws(uses, found)) or list(_kinematics(uses, found)) or list(_last(uses, found))
    # The force of a stream that is asked needs no law of motion beside it.
    return [STREAM, *told] if uses.streams and STREAM not in told else told


def _last(uses: Uses, page: Printed) -> Iterator[str]:
    """What a page rests on that uses none of the other principles."""
    if uses.asked & {"v", "a", "dot", "ddot", "omega", "alpha"} or uses.laws:
        yield DERIVATIVES
    elif uses.extreme:
        yield EXTREME
    elif uses.asked and uses.asked <= {"r", "x", "y"}:
        yield in_letters(POSITIONS, page.placed)
    elif uses.asked & {"I", "k"}:
        yield "Parallel axes: I_A = I_G + m d²."


def _printed(page: Sequence[Block]) -> Printed:
    names: set[str] = set()
    levels: set[str] = set()
    coriolis = in_turn = centre = False
    for block in page:
        own = list(pieces_of(block))
        heads = [p.name for p in own if isinstance(p, Name)]
        texts = [p.text for p in own if isinstance(p, Text)]
        if not isinstance(block, Equation):
            # a_P = a_P′ + a_rel + 2 ω × v_rel, or + a_cor, said before its component; the last term only of a body that
            # turns.
            coriolis |= RELATIVE in heads and (DOUBLED in texts or CORIOLIS in heads)
            centre |= any(ABOUT_CENTRE in text for text in texts)
            continue
        names |= set(heads)
        in_turn |= "/dt" in texts
        centre |= any(FROM_CENTRE.fullmatch(text) for text in texts)
        if CROSS in texts:
            levels |= {h[0] for h in heads[:1] if h[:2] in ("v_", "a_")}
            coriolis |= DOUBLED in texts
    return Printed(
        names=frozenset(names),
        levels=frozenset(levels),
        coriolis=coriolis or CORIOLIS in names,
        in_turn=in_turn,
        centre=centre,
        flight=is_flight(page),
        turned=turned_about(page),
        placed=placed_from(page),
    )


def _laws(uses: Uses, page: Printed) -> Iterator[str]:
    moved = uses.kinetic or uses.energies or uses.momenta or uses.blows or uses.impulses
    if not moved and uses.relations:
        yield from _kinematics(uses, page)
    elif uses.coriolis or uses.beside:
        yield from _relative(uses, page)
    if uses.forces:
        yield FLIGHT if page.flight else _of_forces(uses)
        if uses.streams:
            yield STREAM
    if any("virtual power" in words for words in uses.singles):
        yield "Virtual power, in which no reaction takes part."
    if any(words.startswith("Lagrange") for words in uses.singles):
        yield "Lagrange's equations, in which no reaction takes part."
    if uses.blows:
        yield "Impulse and momentum across the blow."
    if uses.energies:
        yield "Work and energy between the states."
    yield from _momenta(uses)
    over = uses.over | ({OVER_TIME} if uses.integrated else set())
    yield from sorted(over)
    if "constant" in uses.laws:
        yield f"Constant {'angular ' if uses.constant == {RADIAN} else ''}acceleration."
    elif "steady" in uses.laws and not moved and not over:
        yield f"Constant {'angular ' if uses.constant == {RADIAN} else ''}velocity."
    if ALIKE in uses.laws:
        same = "with the same acceleration the relative velocity is constant."
        yield same.capitalize() if uses.beside else f"Relative motion: {same}"
    if uses.swings:
        yield "Small oscillations about an equilibrium."


def _of_forces(uses: Uses) -> str:
    if uses.at_balance:
        return f"Equilibrium: ΣF = 0{', ΣM = 0' if uses.moments else ''}."
    return DALEMBERT if uses.inertial else "Newton's second law."


def _momenta(uses: Uses) -> Iterator[str]:
    if uses.impulses or any(b.gain != 0 or not b.law.kept for b in uses.momenta):
        turning = all(b.law.lead in TURNING for b in uses.momenta) and not uses.impulses
        yield "Angular impulse and momentum." if turning else "Impulse and momentum."
    kept = [b for b in uses.momenta if b.gain == 0 and b.law.kept]
    if any(b.law.lead not in TURNING for b in kept):
        yield "Conservation of momentum."
    if any(b.law.lead in TURNING for b in kept):
        yield "Conservation of angular momentum."


# --- kinematics ------------------------------------------------------------------------------------------------------


def _kinematics(uses: Uses, page: Printed) -> Iterator[str]:
    """The formulas of the course by which places, velocities and accelerations were found."""
    yield from _relative(uses, page)
    yield from _bodies(uses, page)
    if RADIAL in uses.passages or "e_r" in page.names:
        yield POLAR
    if "e_n" in page.names or ALONG in uses.passages:
        yield "Path coordinates: a = v̇ e_t + v²/ρ e_n."
    if RATES in uses.passages:
        again = SECOND_RATES in uses.passages or (page.in_turn and uses.asked & {"a", "ddot", "alpha"})
        yield f"Position vectors, differentiated: v = dr/dt{', a = dv/dt' if again else ''}."
    elif PLACES in uses.passages:
        yield in_letters(POSITIONS, page.placed)
    if CURVE in uses.passages:
        yield "The path of a point: its coordinates, with their parameter eliminated."
    if uses.kinetic_energy:
        yield "Kinetic energy of each body: T = 1/2 m v_G² + 1/2 I_G ω²."


def _relative(uses: Uses, page: Printed) -> Iterator[str]:
    if "r_dot" in page.names and "e_r" not in page.names and (uses.forces or uses.coriolis):
        yield POLAR
        return
    if page.coriolis or "a_xi" in page.names or (uses.forces and uses.sliding):
        yield "Motion relative to a turning body: v_P = v_P′ + v_rel, a_P = a_P′ + a_rel + 2 ω × v_rel."
    elif uses.coriolis:
        # What slides along a line through its pin is told in polar coordinates.
        if "e_r" not in page.names:
            yield "Motion relative to a turning body: v_P = v_P′ + v_rel."
    elif uses.beside:
        yield "Relative motion: v_B = v_A + v_B/A."


def _bodies(uses: Uses, page: Printed) -> Iterator[str]:
    """How the velocities of the points of bodies hang together."""
    if page.centre:
        yield "The instantaneous centre I of a body: v_P = IP ω, perpendicular to IP."
    elif page.levels and (not uses.coriolis or "e_r" in page.names):
        told = {"v": "v_B = v_A + ω × r_B/A", "a": "a_B = a_A + α × r_B/A - ω² r_B/A"}
        formulas = ", ".join(told[v] for v in "va" if v in page.levels)
        yield f"Rigid bodies: {in_letters(formulas, page.turned)}."
    elif uses.axles and not uses.coriolis and uses.asked & {"v", "a"}:
        yield f"Rotation about a fixed axis: v = r ω{', a_t = r α, a_n = r ω²' if 'a' in uses.asked else ''}."
    if uses.rolling or ROLLING in uses.passages:
        yield ROLLS if uses.rolling else ROLLS_BY_ARC
    for kind in sorted(uses.taut):
        if kind in LENGTHS:
            yield LENGTHS[kind]
