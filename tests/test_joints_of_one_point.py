"""A stud and the impact on it at one point: called alike, and still two joints."""

from __future__ import annotations

from pathlib import Path

import pytest
from answered import solved

from planar_cli import cli

ROD = """\
plane: vertical
given: {{e: 0.5, m: 2 kg, l: 1 m, v_1: 3 m/s}}
points: {{A: [0, 0], B: [l, 0], S: [l/4, 0]}}
bodies:
  rod: {{rod: [A, B], mass: m, points: [S]}}
  stud: {{particle: [l/4, 0]}}
joints:
  - weld: {{at: {weld}, between: [stud, ground]}}
  - impact: {{between: {between}, {at}normal: 90 deg, restitution: e, during: 1->2}}
states:
  1: [v(rod).x = 0, v(rod).y = {sign}v_1, omega(rod) = 0]
  2: [just after 1]
find: {{omega: omega(rod) @ 2, v_G: v(rod).y @ 2, J: impulse({name}/rod).y @ 1->2}}
"""
CALLED = [
    ("[l/4, 0]", "at: S, ", "S"),
    ("S", "at: S, ", "S"),
    ("[l/4, 0]", "at: stud, ", "stud"),
    ("S", "name: hit, ", "hit"),
]


@pytest.mark.parametrize(("weld", "at", "name"), CALLED)
@pytest.mark.parametrize("between", ["[rod, stud]", "[stud, rod]"])
@pytest.mark.parametrize("sign", ["-", ""])
def test_a_level_rod_falls_on_a_stud(tmp_path: Path, weld: str, at: str, name: str, between: str, sign: str) -> None:
    """J = (1 + e) m v / (1 + 12 (l/4)²/l²), and the motion followed meets the stud too."""
    found = solved(tmp_path, ROD.format(weld=weld, at=at, name=name, between=between, sign=sign))
    way = 1 if sign else -1
    impulse = way * 1.5 * 2 * 3 / (1 + 12 / 16)
    assert float(found["J"].values[0]) == pytest.approx(impulse)
    assert float(found["v_G"].values[0]) == pytest.approx(-way * 3 + impulse / 2)
    assert float(found["omega"].values[0]) == pytest.approx(-impulse * 0.25 / (2 / 12))


@pytest.mark.parametrize(("at", "name"), [("at: S, ", "S"), ("name: hit, ", "hit")])
def test_the_impulse_is_drawn_at_its_point(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], at: str, name: str
) -> None:
    """Not at a place of the name of the joint, which no figure has."""
    file = tmp_path / "stud.yaml"
    file.write_text(ROD.format(weld="S", at=at, name=name, between="[rod, stud]", sign="-"))
    assert cli.run(["solve", str(file)]) == 0
    (row,) = (s for s in capsys.readouterr().out.splitlines() if s.startswith("  rod:"))
    assert "↑ at S " in row
    assert "at S_2" not in row
    assert "at hit" not in row


STACK = """\
plane: vertical
given: {{M: 3 kg, m: 1 kg, h: 2 m, e: {e}}}
points: {{A: [0, 0]}}
surfaces: {{floor: {{through: A, angle: 0 deg}}}}
bodies: {{big: {{particle: A, mass: M}}, small: {{particle: [0, 0], mass: m}}}}
joints:
  - impact: {{between: [big, floor], restitution: 1{first}}}
  - impact: {{between: {between}, normal: {normal}, restitution: e{second}}}
states:
  1: [t = 0, v(big).x = 0, v(big).y = -sqrt(2*g*h), v(small).x = 0, v(small).y = -sqrt(2*g*h)]
  2: [just after 1]
  3: [just after 2]
find: {{v: v(small).y @ 3, V: v(big).y @ 3}}
"""


@pytest.mark.parametrize("e", ["1", "0.5"])
@pytest.mark.parametrize("normal", ["90 deg", "-90 deg"])
@pytest.mark.parametrize("between", ["[big, small]", "[small, big]"])
def test_balls_drawn_as_one_strike_in_either_order(tmp_path: Path, between: str, normal: str, e: str) -> None:
    """They come from where they approach, not from where the order of their names would have them."""
    spans = {"first": ", during: 1->2", "second": ", during: 2->3"}
    found = solved(tmp_path, STACK.format(between=between, normal=normal, e=e, **spans))
    speed, ratio = (2 * 9.81 * 2) ** 0.5, float(e)
    both = 2 * speed / 4
    assert float(found["v"].values[0]) == pytest.approx(both + 3 / 4 * ratio * 2 * speed)
    assert float(found["V"].values[0]) == pytest.approx(both - 1 / 4 * ratio * 2 * speed)
