"""A motion through a change point says so; curves that grow without bound there are cut off: the rest can be read."""

from __future__ import annotations

import pytest

from planar_cli.figures.cut_off import cut_off
from planar_cli.figures.over_time import Plotted
from planar_cli.figures.plots import changing_graphs
from planar_cli.motion.trajectory.drive import AUTOMATIC
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.structure import load_text
from planar_cli.simulate.report import Motion, Watch, told
from planar_cli.simulate.request import TABLE_ROWS, Request
from planar_cli.simulate.run import TOLERANCE
from planar_cli.simulate.table import HERE, Column
from planar_cli.units import parse_unit

LINKS = """
title: Plate on two parallel links
plane: vertical
given: {m: 7 kg, r: 300 mm, l: 300 mm, beta: 60 deg, n: 200 rpm}
points:
  A: [0, 0]
  C: [2*r, 0]
  B: {from: A, distance: l, angle: beta}
  D: {from: C, distance: l, angle: beta}
  O: {midpoint: [B, D]}
bodies:
  AB: {rod: [A, B]}
  CD: {rod: [C, D]}
  plate: {PLATE, mass: m, points: [B, D]}
joints:
  - pin: {at: A, between: [ground, AB]}
  - pin: {at: C, between: [ground, CD]}
  - pin: {at: B, between: [AB, plate]}
  - pin: {at: D, between: [CD, plate]}
instant: [omega(AB) = -n]
find: {v: v(plate).mag, R_A: reaction(A).mag}
"""
HALF_DISK, LEVEL = "sector: O, radius: r, span: 180 deg, angle: 90 deg", "plate: O, width: 0.7 m, height: 0.1 m"
BAR = """
plane: vertical
points: {A: [0, 0], B: [1 m, 0]}
bodies: {bar: {rod: [A, B], mass: 1 kg}}
joints: [{pin: {at: A, between: [ground, bar]}}]
instant: [at rest]
find: {R: reaction(A).mag}
"""


def _followed(text: str, until: float) -> tuple[Motion, str]:
    problem, watch = load_text(text)[0], Watch()
    request = Request(until, (), (), (), TABLE_ROWS, TOLERANCE, AUTOMATIC, None, (), None, (), False, "table")
    _, page = told(problem, request, watch)
    (motion,) = watch.motions
    return motion, " ".join(page.split())


def test_a_change_point_is_told_with_its_time_and_its_joints() -> None:
    motion, page = _followed(LINKS.replace("PLATE", HALF_DISK), 0.3)
    (place,) = motion.singular
    assert place.joints == ("A", "B", "C", "D")
    assert place.in_line == ("A", "B", "C", "D")
    assert place.unbounded
    assert place.times == pytest.approx((0.0486, 0.1843), abs=3e-3)
    assert "A, B, C and D lie on one line (a change point): there the forces of the joints A, B, C and D" in page
    assert "grow without bound on the way there" in page


def test_peaks_are_cut_off_where_forces_grow_without_bound() -> None:
    motion, _ = _followed(LINKS.replace("PLATE", HALF_DISK), 0.3)
    speed, force = changing_graphs(motion)[0], changing_graphs(motion)[-1]
    assert max(y for c in force.curves for piece in c.pieces for _, y in piece) == pytest.approx(force.up.high)
    assert force.up.high < 3000
    assert "peaks cut off" in str(force.up.words)
    assert "peaks cut off" not in str(speed.up.words)


def test_forces_that_stay_finite_there_are_not_said_to_grow() -> None:
    """The mass centre lies on the line of the pins, so that the links need not turn the plate."""
    motion, page = _followed(LINKS.replace("PLATE", LEVEL), 0.3)
    assert not motion.singular[0].unbounded
    assert "(a change point): there the joints would also let it go on in another way" in page
    assert not any("peaks cut off" in str(graph.up.words) for graph in changing_graphs(motion))


def test_a_motion_without_one_says_nothing() -> None:
    motion, page = _followed(BAR, 2.0)
    assert motion.singular == ()
    assert "What happens" not in page


def test_where_a_curve_leaves_the_field_it_ends_at_its_edge() -> None:
    spots = tuple((float(t), 100.0 if t == 10 else float(t % 3)) for t in range(21))
    column = Column("x", parse_unit("m"), Quantity("x", ("bar",), None, (), None, HERE))
    cut = cut_off(Plotted(column, ((spots,),), 1.0))
    assert cut.cut
    (pieces,) = cut.pieces
    assert len(pieces) == 2
    assert pieces[0][-1][1] == pieces[1][0][1] == max(y for p in pieces for _, y in p)
    smooth = Plotted(column, ((tuple((float(t), float(t % 3)) for t in range(21)),),), 1.0)
    assert cut_off(smooth) is smooth
