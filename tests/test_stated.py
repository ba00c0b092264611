"""What a file states takes part: it is used, checked, told, or the file is refused."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from answered import assert_close, solve, solved

from planar_cli.errors import FileProblem, NoSolution
from planar_cli.homework.checking.checking import read
from planar_cli.registry import members
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

CRATE = """
title: Crate on a rough floor
plane: vertical
{more}
points: {{P: [0, 0]}}
surfaces: {{floor: {{through: P, angle: 0 deg}}}}
bodies: {{crate: {{particle: P, mass: 2 kg}}}}
joints: [{{contact: {{between: [crate, floor], at: P, mu: {mu}}}}}]
loads: [{{force: {{body: crate, magnitude: {force}, angle: 0 deg}}}}]
instant: [{instant}]
find: {{{find}}}
"""
ROD = """
title: Rod
plane: vertical
points: {{A: [0, 0], B: [0.4 m, 0]}}
bodies: {{AB: {{rod: [A, B], length: {length}, mass: 2 kg}}}}
joints: [{{pin: {{at: A, between: [ground, AB]}}}}]
instant: [at rest]
find: {{alpha: alpha(AB)}}
"""
BLOW = """
title: Two disks
plane: horizontal
points: {{P: [0, 0], Q: [0, 0]}}
{more}
bodies: {{a: {{particle: P, mass: 1 kg}}, b: {{particle: Q, mass: 1 kg}}}}
joints: [{{impact: {{between: [a, b], normal: 0 deg{restitution}, during: 1->2}}}}]
states:
  1: [v(a).x = 1 m/s, v(a).y = 0, v(b).x = 0, v(b).y = 0]
  2: [just after 1, v(b).x = {after}]
find: {{v: v(a).x @ 2}}
"""
CAR = """
title: Car that gathers speed
points: {P: [0, 0]}
bodies: {b: {particle: P}}
motion: [v(b).x = 3 m/s + 2 m/s^2 * t, v(b).y = 0]
find: {v: v(b).x in km/h}
"""
FALL = """
title: Stone
plane: vertical
given: {{c: 3 m}}
{more}
points: {{P: [0, 0]}}
bodies: {{b: {{particle: P, mass: 2 kg}}}}
states: {{1: [t = 0, at rest], 2: [t = 1 s{state}]}}
find: {{v: v(b).y @ 2}}
"""


def crate(instant: str, find: str = "a: a(crate).x", mu: str = "0.3", force: str = "10 N", more: str = "") -> str:
    return CRATE.format(instant=instant, find=find, mu=mu, force=force, more=more)


def refused(text: str) -> str:
    """The code of what is wrong with a text."""
    with pytest.raises((FileProblem, NoSolution)) as raised:
        solve(text)
    (diagnostic,) = raised.value.diagnostics
    assert diagnostic.mark.line > 0
    return diagnostic.code


def page(tmp_path: Path, text: str) -> str:
    file = tmp_path / "problem.yaml"
    file.write_text(text, encoding="utf-8")
    told: str = members("formats")["terminal"]().render(narrate(solve_problem(read(str(file)))))
    return told


@pytest.mark.parametrize(("sign", "a"), [(">", "2.057"), ("<", "7.943")])
def test_an_inequality_tells_the_way_of_a_slip(sign: str, a: str) -> None:
    assert_close(solve(crate(f"'v(crate).x {sign} 0'"))["a"], a)


def test_a_direction_is_enough_where_a_coefficient_is_sought() -> None:
    text = crate("'v(crate).x > 0', a(crate).x = -3 m/s^2", "mu: mu", "mu", "0 N", "unknowns: {mu: 1}")
    assert_close(solve(text)["mu"], "0.305810397553516819571865443425")


def test_a_direction_does_not_tell_a_speed() -> None:
    assert refused(crate("'v(crate).x > 0'", "v: v(crate).x")) == "PL604"


def test_known_numbers_that_contradict_each_other() -> None:
    assert refused(crate("at rest, F = q", force="F", more="given: {F: 10 N, q: 7 N}")) == "PL616"


def test_a_length_fits_the_places() -> None:
    assert refused(ROD.format(length="0.5 m")) == "PL615"
    assert_close(solve(ROD.format(length="0.4 m"))["alpha"], "-36.7875")


@pytest.mark.parametrize(("more", "restitution"), [("", ""), ("unknowns: {e: 1}", ", restitution: e")])
def test_bodies_do_not_part_faster_than_they_met(more: str, restitution: str) -> None:
    assert refused(BLOW.format(more=more, restitution=restitution, after="1.4 m/s")) == "PL619"
    assert refused(BLOW.format(more=more, restitution=restitution, after="0.4 m/s")) == "PL619"
    assert_close(solve(BLOW.format(more=more, restitution=restitution, after="0.8 m/s"))["v"], "0.2")


def test_a_formula_is_in_the_unit_that_is_asked(tmp_path: Path) -> None:
    assert "v = 3.6 · (3 + 2 t) (in km/h, t in s)" in page(tmp_path, CAR)


def test_an_unknown_that_nothing_uses_is_refused(tmp_path: Path) -> None:
    assert refused(FALL.format(more="unknowns: {s: m}", state=", s = 0.5 m")) == "PL459"
    assert_close(solved(tmp_path, FALL.format(more="unknowns: {s: m}", state=", y(b) = -s"))["v"], "-9.81")


def test_a_number_that_nothing_uses_is_told(tmp_path: Path) -> None:
    assert re.search(r"^Not used +c:", page(tmp_path, FALL.format(more="", state="")), re.MULTILINE)


def test_a_mass_that_nothing_needs_is_told(tmp_path: Path) -> None:
    text = """
title: Block held on a table
plane: horizontal
points: {A: [0, 0]}
bodies: {block: {particle: A, mass: 4 kg}}
joints: [weld: {at: A, between: [block, ground], name: hold}]
loads: [force: {body: block, at: A, magnitude: 7 N, angle: 0 deg}]
instant: [at rest]
find: {R: reaction(hold).mag}
"""
    assert re.search(r"^Not used +the mass of block, 4 kg:", page(tmp_path, text), re.MULTILINE)


FLUNG = """
title: Ball that slides out along a turning rod
plane: {plane}
given: {{I_O: 0.45 kg*m^2, r_1: 0.2 m, r_2: 0.5 m}}
points: {{O: [0, 0], A: [0.55 m, 0], S: [r_1, 0]}}
bodies:
  rod: {{points: [O, A], center: O, mass: 3 kg, inertia: I_O}}
  ball: {{particle: S, mass: 1.5 kg}}
joints:
  - pin: {{at: O, between: [ground, rod]}}
  - guide: {{body: ball, along: rod, name: slide}}
states: {{1: [omega(rod) = 12 rad/s, v(S/rod).mag = 0], 2: [r(S/O).mag = r_2]}}
find: {{{find}}}
"""


@pytest.mark.parametrize("asked", ["omega: omega(rod) @ 2", "lost: KE(rod) @ 1 - KE(rod) @ 2", "R: reaction(O).y @ 1"])
def test_a_mass_of_a_body_that_turns_by_its_given_inertia_is_not_needed(tmp_path: Path, asked: str) -> None:
    """Its mass centre is on the axle: only what the axle bears of its weight needs the mass."""
    needed = "reaction" in asked
    told = page(tmp_path, FLUNG.format(plane="vertical" if needed else "horizontal", find=asked))
    assert ("m_rod = 3 kg" in told) is needed
    assert bool(re.search(r"^Not used +the mass of rod, 3 kg:", told, re.MULTILINE)) is not needed


def test_a_moment_of_inertia_about_another_point_needs_the_mass(tmp_path: Path) -> None:
    text = FLUNG.replace("center: O, mass: 3 kg, inertia: I_O", "center: C, mass: 3 kg, inertia: 0.45 kg*m^2, about: O")
    text = text.replace("A: [0.55 m, 0],", "A: [0.55 m, 0], C: [0.25 m, 0],").replace("I_O: 0.45 kg*m^2, ", "")
    told = page(tmp_path, text.format(plane="horizontal", find="omega: omega(rod) @ 2"))
    assert "m_rod = 3 kg, moment of inertia of rod about O = 0.45 kg·m²" in told
    assert "not needed" not in told


SLOPE = """
title: Crate on a slope, in letters
plane: vertical
symbols: {{mu: 1, beta: deg, m: kg}}
{more}
points: {{P: [0, 0]}}
surfaces: {{slope: {{through: P, angle: beta}}}}
bodies: {{crate: {{particle: P, mass: m}}}}
joints: [{{contact: {{between: [crate, slope], at: P, mu: mu, name: C}}}}]
instant: [at rest{mode}]
find: {{a: a(crate).along(beta)}}
"""


@pytest.mark.parametrize(
    ("mode", "more", "told"),
    [
        (", mode(C) = stick", "", "Assume μ cos β > sin β"),
        (", mode(C) = slip", "", "Assume sin β > μ cos β"),
        ("", "assume: [mu > tan(beta)]", "Assume μ > tan β crate at P does not slip"),
    ],
)
def test_a_decision_that_rests_on_letters_is_told(tmp_path: Path, mode: str, more: str, told: str) -> None:
    text = page(tmp_path, SLOPE.format(mode=mode, more=more))
    assert told in " ".join(text.split())
    assert text.partition("STEP")[0].count(" > ") == 1


DRUM = """
title: Weight on a drum
plane: vertical
points: {{O: [0, 0], T: [{arm}, 0], Q: [{arm}, -1 m]}}
bodies:
  drum: {{disk: O, radius: 0.3 m, hub: 0.2 m, mass: 4 kg}}
  weight: {{particle: Q, mass: 1 kg}}
joints:
  - pin: {{at: O, between: [ground, drum]}}
  - rope: {{path: [Q, T on drum], name: cord}}
instant: [at rest]
find: {{S: tension(cord)}}
"""


@pytest.mark.parametrize("arm", ["0.25 m", "0"])
def test_a_cord_leaves_a_rim(arm: str) -> None:
    assert refused(DRUM.format(arm=arm)) == "PL522"
    assert_close(solve(DRUM.format(arm="0.3 m"))["S"], "6.54")


@pytest.mark.parametrize("find", ["v(P/P).x", "a(O).theta"])
def test_what_has_no_direction_is_refused(find: str) -> None:
    text = """
title: Point on a circle
points: {{O: [0, 0], P: [1 m, 0]}}
bodies: {{b: {{rod: [O, P]}}}}
joints: [{{pin: {{at: O, between: [ground, b]}}}}]
motion: [omega(b) = 2 rad/s]
find: {{f: {find}}}
"""
    assert refused(text.format(find=find)) == ("PL421" if "/" in find else "PL556")


@pytest.mark.parametrize(
    ("states", "motion"),
    [("at rest, F < q", ""), ("at rest, F = q", ""), ("at rest", "F = q")],
)
def test_known_numbers_are_compared_wherever_they_stand(states: str, motion: str) -> None:
    text = f"""
title: Block
plane: vertical
given: {{F: 10 N, q: 7 N}}
points: {{P: [0, 0]}}
bodies: {{b: {{particle: P, mass: 2 kg}}}}
joints: [{{guide: {{point: P, along: 0 deg}}}}]
loads: [{{force: {{body: b, magnitude: F, angle: 0 deg}}}}]
motion: [{motion}]
states: {{1: [t = 0, {states}], 2: [t = 2 s]}}
find: {{v: v(b).x @ 2}}
"""
    assert refused(text if motion else text.replace("motion: []\n", "")) == "PL616"


@pytest.mark.parametrize(
    ("joint", "code"),
    [
        ("link: {between: [O, Q]}", "PL541"),
        ("rope: {path: [O, Q], name: cord}", "PL541"),
        ("rope: {path: [O, P, P], name: cord}", "PL455"),
    ],
)
def test_what_is_drawn_at_one_place_has_no_direction(joint: str, code: str) -> None:
    text = f"""
title: Ball
plane: vertical
points: {{O: [0, 0], Q: [0, 0], P: [0, -1 m]}}
bodies: {{b: {{points: [P, Q], center: P, mass: 2 kg}}}}
joints: [{{{joint}}}]
instant: [at rest]
find: {{a: a(P).y}}
"""
    assert refused(text) == code


@pytest.mark.parametrize(
    ("instant", "code"),
    [
        ("at rest, m is smallest", "PL431"),
        ("at rest, 'v(P).along(m) = 0'", "PL222"),
    ],
)
def test_what_makes_no_sense_of_a_given_number_is_refused(instant: str, code: str) -> None:
    assert refused(crate(instant, force="m*1 m/s^2", more="given: {m: 2 kg}")) == code
