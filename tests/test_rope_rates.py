"""What a rope demands of accelerations, where a part of it turns: the length of the part stands on the page."""

from __future__ import annotations

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

PEG = """
title: Two collars and a cord over a peg
points: {C: [0, 0], A: [-3 ft, -4 ft], B: [3 ft, -4 ft]}
bodies: {A: {particle: A}, B: {particle: B}}
joints:
  - guide: {point: A, along: 0 deg}
  - guide: {point: B, along: 90 deg}
  - rope: {path: [A, C, B], name: cord}
motion: [v(A).x = -5 ft/s]
find: {v_B: v(B).y, a_B: a(B).y}
"""


def test_the_parts_that_turn_are_named_with_their_lengths() -> None:
    page = " ".join(Terminal(110).render(narrate(solve_problem(load_text(PEG)[0]))).split())
    assert "l̈ = a·e + v_⊥²/l, e along it, v_⊥ across it, AC = 5 ft, CB = 5 ft:" in page
    assert "4 a_B/5 = 0.64 v_A²/AC + 0.36 v_B²/CB" in page
    assert "= 4 · 5² / (5 · 5) + 0.45 · 3.75² / 5 = 5.266 ft/s²" in page
    assert "4.2125" not in page


LEVEL = """
title: Cord over a wheel, of which only the speed is known
plane: vertical
points: {A: [-0.2 m, -1 m], B: [0.2 m, -1 m], O: [0, 0]}
bodies: {a: {particle: A}, b: {particle: B}, w: {disk: O, radius: 0.2 m}}
joints:
  - rope: {path: [A, over w, B]}
  - pin: {at: O, between: [w, ground]}
  - guide: {point: A, along: 90 deg}
  - guide: {point: B, along: 90 deg}
instant: [v(A).y = -2 m/s]
find: {v: v(B).y}
"""


def test_where_no_acceleration_is_told_the_rope_is_told_all_the_same() -> None:
    page = Terminal(110).render(narrate(solve_problem(load_text(LEVEL)[0])))
    assert "v = v_B = 2 m/s upward" in page
