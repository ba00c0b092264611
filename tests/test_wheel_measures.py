"""What the radii of a wheel tell is not told again across it; the head of a dimension is no longer than half of it."""

from __future__ import annotations

import math
from pathlib import Path

from planar_cli.figures.illustrated import figures_of, illustrated
from planar_cli.formats._on_paper import Scale, on_paper
from planar_cli.formats._paper import Stroke
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.document.blocks import Name, line
from planar_cli.report.document.marks import Dimension, Panel
from planar_cli.report.page.narrate import narrate

STEPPED = """\
title: Stepped cylinder held on an incline
plane: vertical
given: {m: 3 kg, r: 0.1 m, R: 0.2 m, beta: 30 deg}
points:
  C: [0, 0]
  G: {from: C, distance: R, angle: beta + 90 deg}
  H: {from: C, distance: R + r, angle: beta + 90 deg}
  T: {from: C, distance: 2*R, angle: beta + 90 deg}
  D: {from: T, distance: 3 m, angle: beta}
surfaces: {incline: {through: C, angle: beta}}
bodies: {cylinder: {disk: G, radius: R, hub: r, mass: m}}
joints:
  - rolling: {between: [cylinder, incline], at: C}
  - rope: {path: [T on cylinder, D], name: cable}
instant: [at rest, equilibrium]
find: {T: tension(cable)}
"""


def test_radii_tell_distances_across_a_wheel(tmp_path: Path) -> None:
    path = tmp_path / "stepped.yaml"
    path.write_text(STEPPED)
    solution, _ = solve_and_compare(read(str(path)))
    (panel,) = dict(figures_of(illustrated(narrate(solution), solution)))["scene"].panels
    told = [m.words for m in panel.marks if isinstance(m, Dimension)]
    assert line(Name("R")) in told
    assert line(Name("r")) in told
    assert len(told) == 3, "and how long the rope is"


def test_heads_of_short_dimensions_are_small() -> None:
    for length in (4.0, 8.0, 200.0):
        panel = Panel((Dimension((0.0, 0.0), (length, 0.0), line(Name("r")), side=0),), ())
        strokes = [s for s in on_paper(panel, Scale(1.0)).strokes if isinstance(s, Stroke) and s.kind == "measure head"]
        (head,) = (s.places for s in strokes)
        assert math.dist(head[0], head[1]) <= min(7.0, 0.53 * length)
