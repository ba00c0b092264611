"""Every joint in every mode: its facts and its position residuals must forbid the same motions, and bend them alike.

Scenes are drawn at random. Velocities that the residuals allow must satisfy the facts; then the rows of both, with
their constant parts (centripetal, Coriolis, the turning of ropes), must span the same space.
"""

from __future__ import annotations

import itertools
import random
from collections.abc import Iterator
from decimal import Decimal
from pathlib import Path
from string import Template

import pytest
import yaml

from planar_cli.equation.values.exact import ZERO, Valuation
from planar_cli.joints.base import Joint
from planar_cli.problem.scene.facts import Mode
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.structure import load_text
from planar_cli.registry import members
from planar_cli.solve.instant.instant import Instant, make_instant
from planar_cli.solve.instant.worked import PARTS
from planar_cli.solve.multibody.assembly import Assembly
from planar_cli.solve.multibody.linear import solve
from planar_cli.solve.multibody.motion import tidied
from planar_cli.solve.multibody.poses import NearPoses, Place
from planar_cli.solve.multibody.sparse import CONSTANT, Echelon, Line
from planar_cli.solve.multibody.time_jets import TimeJet

SCENES: dict[str, str] = yaml.safe_load((Path(__file__).parent / "joint_scenes.yaml").read_text())


def instant_of(name: str, seed: int) -> Instant:
    """The scene of one template with random numbers."""
    rng = random.Random(f"{name} {seed}")
    numbers = {k: f"{rng.uniform(0.4, 1.6):.3f}" for k in "xyzr"}
    numbers |= {"a": f"{rng.uniform(100, 170):.1f}", "b": f"{rng.uniform(60, 85):.1f}"}
    text = Template(SCENES[name]).substitute(numbers)
    body = text.split("bodies: {")[1].split(":")[0]
    text += f"plane: horizontal\ninstant: [at rest]\nfind: {{x: x({body})}}\n"
    problem, wrong = load_text(f"title: drawn at random\n{text}")
    assert problem is not None, [d.message for d in wrong]
    assert not wrong, [d.message for d in wrong]
    return make_instant(problem, (), (), {}, False)


def choices_of(instant: Instant) -> Iterator[list[tuple[Joint, Mode]]]:
    """Every combination of modes."""
    for chosen in itertools.product(*(modes for _, modes in instant.modes)):
        yield [(joint, mode) for (joint, _), mode in zip(instant.modes, chosen, strict=True)]


def jets_of(instant: Instant, chosen: list[tuple[Joint, Mode]], places: dict[str, Place]) -> list[TimeJet]:
    poses = NearPoses(instant.scene.valuations[0], places)
    found = []
    for joint, mode in chosen:
        for residual in joint.residuals(instant.scene, mode):
            value = residual.of(poses)
            found += [tidied(j) for j in ((value.x, value.y) if isinstance(value, Vec) else (value,))]
    return found


def places_of(instant: Instant, speeds: list[Decimal]) -> dict[str, Place]:
    value: Valuation = instant.scene.valuations[0]
    places, column = {}, 0
    for name, body in instant.scene.bodies.items():
        turn = column + 2 if body.rigid else None
        x, y, *spin = speeds[column : column + (3 if body.rigid else 2)]
        center = Vec(value(body.center.x), value(body.center.y))
        places[name] = Place(center, Vec(x, y), spin[0] if spin else ZERO, (column, column + 1, turn))
        column += 3 if body.rigid else 2
    return places


def allowed(instant: Instant, chosen: list[tuple[Joint, Mode]], rng: random.Random) -> list[Decimal]:
    """Random velocities under which no residual changes."""
    width = sum(3 if b.rigid else 2 for b in instant.scene.bodies.values())
    jets = jets_of(instant, chosen, places_of(instant, [ZERO] * width))
    solved = solve([[*(jet.slopes.get(i, ZERO) for i in range(width)), jet.rate] for jet in jets], width)
    assert solved.conflict is None
    speeds = list(solved.values)
    for vector in solved.null.values():
        share = Decimal(rng.randint(-200, 200)) / 100
        speeds = [s + share * v for s, v in zip(speeds, vector, strict=True)]
    return speeds


def facts_of(
    instant: Instant, chosen: list[tuple[Joint, Mode]], places: dict[str, Place]
) -> tuple[list[Line], Decimal]:
    """The rows of accelerations that the facts state, and the largest velocity that they forbid."""
    twists = {name: (p.velocity, p.spin) for name, p in places.items()}
    centers = {name: p.center for name, p in places.items()}
    assembly = Assembly(instant.scene.valuations[0], centers, instant.scene.rigid, twists)
    forbidden = [ZERO]
    for _, mode in chosen:
        for joining in mode.facts.joinings:
            assembly.joining(joining)
            point = assembly.number(joining.point)
            gap = assembly.point_velocity(joining.mover, point) - assembly.point_velocity(joining.base, point)
            if joining.drift is not None:
                gap = gap - assembly.number(joining.drift)
            forbidden += [gap.dot(d) for d in assembly._forbidden(joining)]
            if not joining.turns and all(instant.scene.rigid(b) for b in (joining.mover, joining.base)):
                forbidden.append(assembly.spin(joining.mover) - assembly.spin(joining.base))
        for row in mode.facts.rows:
            assembly.rows.append(assembly.row(row))
            forbidden.append(assembly.row_speed(row))
        if mode.sliding is not None and mode.direction == 0:
            forbidden.append(assembly.row_speed(mode.sliding))
    columns: dict[int, int] = {}
    for (body, part), i in assembly.columns.items():
        column = places[body].columns[PARTS.index(part)]
        assert column is not None
        columns[i] = column
    rows = [{CONSTANT if j < 0 else columns[j]: c for j, c in row.items() if c} for row in assembly.rows]
    return rows, max(abs(f) for f in forbidden)


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", SCENES)
def test_facts_and_residuals_agree(name: str, seed: int) -> None:
    instant = instant_of(name, seed)
    rng = random.Random(seed)
    for chosen in choices_of(instant):
        words = ", ".join(m.name for _, m in chosen)
        places = places_of(instant, allowed(instant, chosen, rng))
        jets = jets_of(instant, chosen, places)
        assert all(abs(jet.rate) < Decimal("1e-45") for jet in jets)
        assert all(abs(jet.value) < Decimal("1e-45") for jet in jets)
        rows, forbidden = facts_of(instant, chosen, places)
        assert forbidden < Decimal("1e-40"), f"{words}: the facts forbid a velocity that the geometry allows"
        ours, theirs = Echelon(), Echelon()
        for jet in jets:
            assert ours.add({**jet.slopes, CONSTANT: jet.second}) < Decimal("1e-40")
        for row in rows:
            assert theirs.add(row) < Decimal("1e-40"), f"{words}: the facts contradict themselves"
        count = len(theirs.pivots)
        assert len(ours.pivots) == count, f"{words}: {count} facts, {len(ours.pivots)} residuals"
        for row in rows:
            remainder = ours.add(row)
            assert remainder < Decimal("1e-35"), f"{words}: another acceleration, by {remainder:.3g} of its size"
            assert len(ours.pivots) == count, f"{words}: the facts forbid another motion"


def test_every_joint_is_tried() -> None:
    tried = {line[4:].split(":")[0] for scene in SCENES.values() for line in scene.splitlines() if line[:4] == "  - "}
    assert tried | {"impact"} == set(members("joints"))
