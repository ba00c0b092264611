"""Impacts: velocities just after from those just before, with the impulses of everything that holds, presses or rubs.

    M (v⁺ - v⁻) = Jᵀ Λ + N Λ_N + T Λ_T + P          J v⁺ = rates that the joints demand
    0 <= Λ_N  ⊥  γ_N⁺ + e γ_N⁻ >= 0                  Newton's restitution, at every contact by itself
    |Λ_T| <= μ Λ_N, against what slides at the end   Coulomb's friction impulse

All of it at once is one linear complementarity problem (F. Pfeiffer, C. Glocker, Multibody Dynamics with Unilateral
Contacts, 1996, chapter 8). Without friction the velocities after it are unique. Several contacts at once mean
"simultaneous": bodies in a row that strike one after the other give another answer.
"""

from __future__ import annotations

from collections.abc import Sequence

from planar_cli.motion.terms.complementarity import MOST_ENUMERATED, all_solutions, lemke
from planar_cli.records import record

ZERO = 1e-11
"""An entry below this part of its row's largest one is zero."""
ROUNDING = 1e-13
"""Below this part of the largest a number is rounding."""
AGREE = 1e-9
"""Speeds and impulses, in parts of their scales, that differ by less are the same."""


@record
class Bond:
    """What holds on both sides throughout the impact: `row` · v = `rate` afterwards."""

    joint: str
    """The joint or drive that demands it."""
    row: tuple[float, ...]
    """The relation's coefficients on the velocities of the state."""
    rate: float = 0.0
    """What the relation equals afterwards: zero, or the rate at which something is driven."""
    push: tuple[float, ...] | None = None
    """What a unit of its impulse does to the momenta; None: the same as `row` (an ideal joint)."""
    inner: bool = False
    """Do bodies exert it on each other alone?"""


@record
class StruckContact:
    """A contact or a rope that can only press, or only pull, in the impact."""

    joint: str
    """The joint it belongs to."""
    normal: tuple[float, ...]
    """The speed of separation is `normal` · v + `normal_rate`; also what a unit of the impulse does to the momenta."""
    normal_rate: float = 0.0
    """The part of it that does not come from v: moving surfaces [m/s]."""
    tangent: tuple[float, ...] | None = None
    """The same for sliding; None where it is smooth."""
    tangent_rate: float = 0.0
    """The part of the sliding that does not come from v: a belt [m/s]."""
    restitution: float = 0.0
    """e, 0 to 1."""
    mu: float = 0.0
    """The coefficient of friction of the impact."""
    inner: bool = False
    """Do bodies exert it on each other alone?"""


@record
class Struck:
    """The scene at the moment of an impact."""

    velocities: tuple[float, ...]
    """v⁻ as in the state."""
    masses: tuple[float, ...]
    """The mass or the moment of inertia that belongs to each velocity; 0 where there is none."""
    speeds: tuple[float, ...]
    """The scale of each velocity."""
    bonds: tuple[Bond, ...]
    contacts: tuple[StruckContact, ...]
    applied: tuple[float, ...] | None = None
    """Impulses given by loads, for each velocity."""
    frames: tuple[tuple[int, int, int | None], ...] = ()
    """Of every body the numbers of its velocities along x and y, and of turning if it turns."""
    places: tuple[tuple[float, float], ...] = ()
    """Where its mass centre is [m]."""


@record
class Outgoing:
    """What an impact leads to."""

    velocities: tuple[float, ...]
    """v⁺."""
    bonds: tuple[float, ...]
    """The impulse of each bond; of redundant ones, some that fit."""
    normals: tuple[float, ...]
    """The normal impulse of each contact, >= 0."""
    frictions: tuple[float, ...]
    """The friction impulse of each contact along its tangent."""
    unique: bool | None
    """Are the velocities the only ones? None: too many contacts with friction to try all of them."""
    others: tuple[tuple[float, ...], ...]
    """Other velocities that fulfil the same laws."""


class Contradiction(Exception):
    """Joints demand velocities in the impact that cannot go together; carries the joint."""

    def __init__(self, joint: str) -> None:
        self.joint = joint
        super().__init__(joint)


class NoImpulse(Exception):
    """No impulses fulfil the laws of impact, friction among them."""


def strike(struck: Struck) -> Outgoing:
    """The impact worked out; raises Contradiction or NoImpulse."""
    directions = [(k, False) for k in range(len(struck.contacts))]
    directions += [(k, True) for k, c in enumerate(struck.contacts) if c.tangent is not None and c.mu > 0]
    free, responses = _responses(struck, directions)
    unit = _impulse_unit(struck)
    solutions, whole = _solutions(struck, directions, free[0], responses, unit)
    if not solutions:
        raise NoImpulse
    outcomes = [_outgoing(struck, directions, free, responses, z) for z in solutions]
    distinct: list[Outgoing] = []
    for outcome in outcomes:
        if not any(_same(outcome.velocities, d.velocities, struck.speeds) for d in distinct):
            distinct.append(outcome)
    first = distinct[0]
    smooth = len(directions) == len(struck.contacts)
    unique = True if smooth else (len(distinct) == 1 if whole else None)
    others = tuple(d.velocities for d in distinct[1:])
    return Outgoing(first.velocities, first.bonds, first.normals, first.frictions, unique, others)


def unbalanced(struck: Struck, found: Outgoing) -> float:
    """The largest part of a usual impulse by which the momentum of any coordinate does not add up."""
    unit, worst = _impulse_unit(struck), 0.0
    for i, mass in enumerate(struck.masses):
        if not mass:
            continue
        total = struck.applied[i] if struck.applied else 0.0
        total += sum((b.push or b.row)[i] * x for b, x in zip(struck.bonds, found.bonds, strict=True))
        for contact, normal, friction in zip(struck.contacts, found.normals, found.frictions, strict=True):
            total += contact.normal[i] * normal + (contact.tangent[i] * friction if contact.tangent else 0.0)
        change = mass * (found.velocities[i] - struck.velocities[i])
        worst = max(worst, abs(change - total) / max(unit, abs(change)))
    return max(worst, _uncancelled(struck, found, unit))


def _uncancelled(struck: Struck, found: Outgoing, unit: float) -> float:
    """The largest part of a usual impulse, or of its moment, that is left of what bodies do to each other alone."""
    exerted = [(b.push or b.row, x) for b, x in zip(struck.bonds, found.bonds, strict=True) if b.inner]
    for contact, normal, friction in zip(struck.contacts, found.normals, found.frictions, strict=True):
        if contact.inner:
            exerted.append((contact.normal, normal))
            exerted += [(contact.tangent, friction)] if contact.tangent else []
    reach = max((abs(x) + abs(y) for x, y in struck.places), default=0.0)
    worst = 0.0
    for column, size in exerted:
        sums, sizes = [0.0] * 3, [unit, unit, unit * reach]
        for (ix, iy, turn), (x, y) in zip(struck.frames, struck.places, strict=True):
            force_x, force_y = size * column[ix], size * column[iy]
            couple = 0.0 if turn is None else size * column[turn]
            for k, parts in enumerate(((force_x,), (force_y,), (x * force_y, -y * force_x, couple))):
                sums[k] += sum(parts)
                sizes[k] += sum(map(abs, parts))
        worst = max(worst, *(abs(s) / z for s, z in zip(sums, sizes, strict=True) if z))
    return worst


def closing(struck: Struck, contact: StruckContact) -> float:
    """The speed of separation just before, negative where the partners approach."""
    return _dot(contact.normal, struck.velocities) + contact.normal_rate


def kinetic_energy(masses: Sequence[float], velocities: Sequence[float]) -> float:
    """Σ m v²/2."""
    return sum(m * v * v for m, v in zip(masses, velocities, strict=True)) / 2


# --- the laws --------------------------------------------------------------------------------------------------------

Direction = tuple[int, bool]
Response = tuple[list[float], list[float]]


def _solutions(
    struck: Struck, directions: list[Direction], free: list[float], responses: list[Response], unit: float
) -> tuple[list[list[float]], bool]:
    """The impulses along `directions`, every solution, and whether all have been looked for."""
    contacts, n = struck.contacts, len(struck.contacts)
    speed = _speed_unit(struck)
    rough = {k: n + i for i, (k, _) in enumerate(d for d in directions if d[1])}
    gain = [[_dot(_column(struck, d), r[0]) * unit / speed for r in responses] for d in directions]
    start = [(_dot(_column(struck, d), free) + _rate(struck, d)) / speed for d in directions]
    # Along a direction that joints hold already nothing is left but rounding.
    arriving = max((abs(closing(struck, c)) / speed for c in contacts), default=0.0)
    start = [0.0 if abs(v) <= ROUNDING * arriving else v for v in start]
    largest = max((abs(x) for row in gain for x in row), default=0.0)
    gain = [[0.0 if abs(x) <= ROUNDING * largest else x for x in row] for row in gain]
    size = n + 2 * len(rough)
    matrix = [[0.0] * size for _ in range(size)]
    q = [0.0] * size

    def put(row: int, d: int) -> None:
        """γ along d as a function of Λ_N and of μ Λ_N + Λ_T."""
        for k in range(n):
            matrix[row][k] = gain[d][k] - (contacts[k].mu * gain[d][rough[k]] if k in rough else 0.0)
        for t in rough.values():
            matrix[row][t] = gain[d][t]
        q[row] = start[d]

    for k, contact in enumerate(contacts):
        put(k, k)
        q[k] += contact.restitution * min(closing(struck, contact), 0.0) / speed
    for k, t in rough.items():
        back = t + len(rough)
        put(t, t)
        matrix[t][back] = 1.0
        matrix[back][k], matrix[back][t] = 2 * contacts[k].mu, -1.0
    whole = size <= MOST_ENUMERATED
    smooth = not rough
    found = [] if smooth or not whole else all_solutions(matrix, q, AGREE)
    if not found:
        one = lemke(matrix, q)
        found = [] if one is None else [one]

    def impulses(z: list[float]) -> list[float]:
        tangential = [z[t] - contacts[k].mu * z[k] for k, t in rough.items()]
        return [x * unit for x in (*z[:n], *tangential)]

    return [impulses(z) for z in found], whole


def _outgoing(
    struck: Struck, directions: list[Direction], free: Response, responses: list[Response], sizes: list[float]
) -> Outgoing:
    velocities, bonds = list(free[0]), list(free[1])
    for size, (change, held) in zip(sizes, responses, strict=True):
        if size:
            velocities = [v + size * c for v, c in zip(velocities, change, strict=True)]
            bonds = [b + size * h for b, h in zip(bonds, held, strict=True)]
    n = len(struck.contacts)
    frictions = [0.0] * n
    for (k, tangential), size in zip(directions, sizes, strict=True):
        if tangential:
            frictions[k] = size
    return Outgoing(tuple(velocities), tuple(bonds), tuple(sizes[:n]), tuple(frictions), True, ())


def _column(struck: Struck, direction: Direction) -> tuple[float, ...]:
    contact = struck.contacts[direction[0]]
    if direction[1]:
        assert contact.tangent is not None
        return contact.tangent
    return contact.normal


def _rate(struck: Struck, direction: Direction) -> float:
    contact = struck.contacts[direction[0]]
    return contact.tangent_rate if direction[1] else contact.normal_rate


# --- what an impulse does to the joined bodies ---------------------------------------------------------------------


def _responses(struck: Struck, directions: list[Direction]) -> tuple[Response, list[Response]]:
    """Velocities and impulses of bonds without any contact, and what a unit impulse along each direction adds.

    One elimination of M Δv - Pᵀ Λ = p, J Δv = r with all right sides; velocities in their scales.
    """
    n, m = len(struck.masses), len(struck.bonds)
    unit = _impulse_unit(struck)
    rows: list[dict[int, float]] = []
    for i in range(n):
        row = {i: struck.masses[i] * struck.speeds[i]} if struck.masses[i] else {}
        for j, bond in enumerate(struck.bonds):
            push = (bond.push or bond.row)[i]
            if push:
                row[n + j] = -push * unit
        right = [struck.applied[i] if struck.applied else 0.0, *(_column(struck, d)[i] for d in directions)]
        rows.append(row | {n + m + k: x for k, x in enumerate(right) if x})
    for bond in struck.bonds:
        row = {i: x * struck.speeds[i] for i, x in enumerate(bond.row) if x}
        missing = bond.rate - _dot(bond.row, struck.velocities)
        rows.append(row | ({n + m: missing} if missing else {}))
    found = _eliminated(rows, n + m, 1 + len(directions), [*("" for _ in range(n)), *(b.joint for b in struck.bonds)])
    answers: list[Response] = []
    for column in found:
        change = [x * s for x, s in zip(column[:n], struck.speeds, strict=True)]
        answers.append((change, [x * unit for x in column[n:]]))
    free = [v + c for v, c in zip(struck.velocities, answers[0][0], strict=True)]
    return (free, answers[0][1]), answers[1:]


def _eliminated(rows: list[dict[int, float]], size: int, rights: int, names: list[str]) -> list[list[float]]:
    """Gauss with a sparse pivot order; unknowns that nothing decides are 0, redundant rows must agree."""
    left = {i: _balanced(row, size) for i, row in enumerate(rows)}
    done: list[tuple[int, dict[int, float]]] = []
    while left:
        best = _pivot_of(left, size)
        if best is None:
            break
        i, k = best
        pivot = left.pop(i)
        done.append((k, pivot))
        for row in left.values():
            entry = row.pop(k, 0.0)
            if entry:
                factor = entry / pivot[k]
                for j, x in pivot.items():
                    if j != k:
                        row[j] = row.get(j, 0.0) - factor * x
    for i, row in left.items():
        # A contact's direction that only joints could take up has no response; what the joints demand must agree.
        if abs(row.get(size, 0.0)) > AGREE:
            raise Contradiction(names[i])
    found = [[0.0] * size for _ in range(rights)]
    for k, pivot in reversed(done):
        for r in range(rights):
            value = pivot.get(size + r, 0.0) - sum(x * found[r][j] for j, x in pivot.items() if j < size and j != k)
            found[r][k] = value / pivot[k]
    return found


def _balanced(row: dict[int, float], size: int) -> dict[int, float]:
    """The row with 1 as the largest coefficient."""
    largest = max((abs(x) for j, x in row.items() if j < size), default=1.0)
    return {j: x / largest for j, x in row.items()}


def _pivot_of(left: dict[int, dict[int, float]], size: int) -> tuple[int, int] | None:
    """Row and column of the next pivot: few entries in its row, not small in row or column."""
    largest: dict[int, float] = {}
    for row in left.values():
        for j, x in row.items():
            if j < size:
                largest[j] = max(largest.get(j, 0.0), abs(x))
    ranked: tuple[int, float, int, int] | None = None
    for i, row in left.items():
        entries = {j: abs(x) for j, x in row.items() if j < size and abs(x) > ZERO}
        for j, x in entries.items():
            if x >= 0.1 * largest[j]:
                key = (len(entries), -x, i, j)
                ranked = key if ranked is None else min(ranked, key)
    return None if ranked is None else (ranked[2], ranked[3])


def _impulse_unit(struck: Struck) -> float:
    """The size of a usual impulse: the largest mass times its speed."""
    return max((m * s for m, s in zip(struck.masses, struck.speeds, strict=True)), default=0.0) or 1.0


def _speed_unit(struck: Struck) -> float:
    """The size of a usual speed along a contact."""
    reach = [abs(x) * s for c in struck.contacts for x, s in zip(c.normal, struck.speeds, strict=True)]
    return max(reach, default=0.0) or 1.0


def _same(a: Sequence[float], b: Sequence[float], scale: Sequence[float]) -> bool:
    return all(abs(x - y) <= 1e3 * AGREE * s for x, y, s in zip(a, b, scale, strict=True))


def _dot(a: Sequence[float], b: Sequence[float]) -> float:
    return sum(x * y for x, y in zip(a, b, strict=True))
