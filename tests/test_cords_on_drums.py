"""A cord on a drum leaves the rim where it is tangent, also when its end is drawn along or off a slanting line."""

from __future__ import annotations

import math

import pytest
from answered import solve
from conftest import ROOT
from worked import worked

from planar_cli.errors import NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate

ALONG_ITSELF = """
title: A wheel turned by a slanting cable
given: {R: 0.6 m, r_h: 0.3 m}
points:
  O: [0, 0]
  T: [-4/5*r_h, 3/5*r_h]
  A: [-0.8 m * 3/5 - 4/5*r_h, -0.8 m * 4/5 + 3/5*r_h]
bodies:
  wheel: {disk: O, radius: R, hub: r_h}
  cable_end: {particle: A}
joints:
  - pin: {at: O, between: [ground, wheel]}
  - rope: {path: [A, T on wheel], name: cable}
motion: [v(A).x = -0.06 m/s, v(A).y = -0.08 m/s]
states:
  1: [t = 0]
  2: [t = 2 s]
find: {omega: omega(wheel) @ 2}
"""

ASIDE = """
title: A drum turned by a cable whose end is drawn aside
given: {r: 0.3 m}
points: {O: [0, 0], T: [-r, 0], A: [-r, -0.8 m]}
bodies:
  drum: {disk: O, radius: r}
  cable_end: {particle: A}
joints:
  - pin: {at: O, between: [ground, drum]}
  - rope: {path: [A, T on drum], name: cable}
motion: [v(A).x = -0.1 m/s, v(A).y = -0.05 m/s]
states:
  1: [t = 0]
  2: [t = 2 s]
find: {omega: omega(drum) @ 2}
"""


def _turned(t: float, r: float = 0.3) -> float:
    """By how much the drum has turned but for a constant: r φ + L is the cable that has run off."""
    x, y = -r - 0.1 * t, -0.8 - 0.05 * t
    free = math.sqrt(x * x + y * y - r * r)
    return math.atan2(y, x) - math.atan2(free, r) + free / r


def test_a_cable_drawn_along_its_own_line() -> None:
    assert float(solve(ALONG_ITSELF)["omega"].values[0]) == pytest.approx(0.1 / 0.3)


def test_a_cable_drawn_aside() -> None:
    rate = (_turned(2 + 1e-5) - _turned(2 - 1e-5)) / 2e-5
    assert float(solve(ASIDE)["omega"].values[0]) == pytest.approx(rate, rel=1e-6)


WINDING = """
title: Puck whose string winds up on a post
plane: horizontal
given: {a: 0.1 m, L: 1 m, v_0: 2 m/s}
points: {O: [0, 0], T: [0, a], P: [L, a]}
bodies: {post: {disk: O, radius: a}, puck: {particle: P, mass: 0.3 kg}}
joints:
  - weld: {at: O, between: [ground, post]}
  - rope: {path: [P, T on post], name: string}
states:
  1: [t = 0, v(puck).x = 0, v(puck).y = -v_0]
  2: [r(puck).mag = sqrt(a^2 + (L/2)^2)]
find: {t: t @ 2, v: v(puck).mag @ 2, S_1: tension(string) @ 1, S_2: tension(string) @ 2}
"""


def test_a_puck_whose_string_winds_up() -> None:
    """It keeps its speed; a free part s that shortens by a v/s a second, s² = L² - 2 a v t, and S = m v²/s."""
    found = {name: float(a.values[0]) for name, a in solve(WINDING).items() if a.values}
    assert found == pytest.approx({"t": 0.75 / 0.4, "v": 2, "S_1": 1.2, "S_2": 2.4})


SWINGING = """
title: Load on a drum that swings while it sinks
plane: vertical
points: {O: [0, 3 m], S: [-0.2 m, 3 m], A: [-0.2 m, 0.9 m]}
bodies: {drum: {disk: O, radius: 0.2 m, mass: 10 kg}, A: {particle: A, mass: 12 kg}}
joints:
  - pin: {at: O, between: [ground, drum]}
  - rope: {path: [A, S on drum], name: cord}
states:
  1: [t = 0, omega(drum) = 0, v(A).x = 0.5 m/s, v(A).y = 0]
  2: [t = 0.4 s]
find: {alpha: alpha(drum) @ 2, S: tension(cord) @ 2, T: KE(all) @ 2, W: PE(A) @ 1 - PE(A) @ 2}
"""


def test_a_load_that_swings_on_a_drum() -> None:
    """S r = I α, and what the weight does is kinetic energy in the end."""
    found = {name: float(a.values[0]) for name, a in solve(SWINGING).items() if a.values}
    assert found["S"] * 0.2 == pytest.approx(0.2 * found["alpha"], rel=1e-6)
    assert found["T"] == pytest.approx(12 * 0.5**2 / 2 + found["W"], rel=1e-6)


def test_what_is_asked_of_several_states_is_told_by_states() -> None:
    page = Terminal(200).render(narrate(worked(ROOT / "problems" / "textbook" / "ex-1-09.yaml")[0]))
    assert "does not slip on the wheel: the way of A is the arc on it, s_A = r_h θ; differentiated:" in page
    assert "θ: the angle by which the wheel has turned, counterclockwise" in page
    assert (
        page.index("At 1:")
        < page.index("v_E = r_h ω")
        < page.index("From 1 to 2")
        < page.index("At 2:")
        < page.index("x_B,2 =")
    )
    assert "0.6 cos 38.20° = 0.4715 m" in page


PULLEY = (ROOT / "problems/systems/double-pulley.yaml").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("drawn", "instead", "line", "message"),
    [
        ("[R, -1 m]", "[R + 0.05 m, -1 m]", 18, "the cord A leaves pulley at T at right angles to the radius there, "),
        (
            "[-r_i, -1.2 m]",
            "[-0.3 m, -1.2 m]",
            19,
            "the cord B leaves pulley at S at right angles to the radius there, ",
        ),
    ],
)
def test_a_block_that_is_not_drawn_below_its_rim_point_is_refused(
    drawn: str, instead: str, line: int, message: str
) -> None:
    with pytest.raises(NoSolution) as refused:
        solve(PULLEY.replace(drawn, instead))
    why = refused.value.diagnostics[0]
    assert (why.code, why.mark.line) == ("PL522", line)
    assert why.message.startswith(message)


@pytest.mark.parametrize(("old", "new"), [("v(A).y = -3 ft/s", "v(D).y = -3 ft/s")])
def test_a_speed_of_a_fixed_point_contradicts_it(old: str, new: str) -> None:
    text = (ROOT / "problems/kinematics/three-blocks-on-one-cable.yaml").read_text(encoding="utf-8")
    with pytest.raises(NoSolution, match=r"but the joints make v\(D\)\.y = 0 ft/s"):
        solve(text.replace(old, new))


@pytest.mark.parametrize(("old", "new"), [("E: [(r - R)/2, -h]", "E: [-0.9 in, -h]"), ("(R + r)/2}", "4.5 in}")])
def test_a_sheave_whose_rim_the_cord_does_not_touch_is_refused(old: str, new: str) -> None:
    text = (ROOT / "problems/kinematics/differential-hoist.yaml").read_text(encoding="utf-8")
    with pytest.raises(NoSolution, match=r"and the rim of sheave is not on that line, but 0\.\d+ in beside it"):
        solve(text.replace(old, new))


@pytest.mark.parametrize(("old", "new"), [("h: 40 in", "h: -40 in"), ("under sheave", "over sheave")])
def test_a_cord_that_passes_a_sheave_on_the_other_side_is_refused(old: str, new: str) -> None:
    text = (ROOT / "problems/kinematics/differential-hoist.yaml").read_text(encoding="utf-8")
    with pytest.raises(NoSolution, match=r"leaves drum at T1 on the other side of sheave: as drawn it runs"):
        solve(text.replace(old, new))


DRUM = """
title: Drum that is turned by a cord
plane: vertical
points: {O: [0, 0], T: [0.2 m, 0], P: [PX, -1 m]}
bodies: {drum: {disk: O, radius: 0.2 m, mass: 5 kg}}
joints:
  - pin: {at: O, between: [ground, drum]}
loads:
  - force: {body: drum, wound_at: T, magnitude: 50 N, PULL}
instant: [at rest]
find: {alpha: alpha(drum)}
"""


@pytest.mark.parametrize(("pull", "x"), [("angle: -60 deg", "0.2 m"), ("towards: P", "0.5 m")])
def test_a_cord_that_unwinds_is_not_pulled_across_the_rim(pull: str, x: str) -> None:
    with pytest.raises(NoSolution) as refused:
        solve(DRUM.replace("PULL", pull).replace("PX", x))
    why = refused.value.diagnostics[0]
    assert (why.code, why.mark.line) == ("PL522", 9)
    assert why.message.endswith("leaves drum at T, and not at right angles to the radius there")


@pytest.mark.parametrize("pull", ["angle: -90 deg", "towards: P"])
def test_a_cord_that_unwinds_is_pulled_along_the_rim(pull: str) -> None:
    found = solve(DRUM.replace("PULL", pull).replace("PX", "0.2 m"))["alpha"].values
    assert found is not None
    assert float(found[0]) == pytest.approx(-50 * 0.2 / (0.5 * 5 * 0.2**2))


BELT = """
title: Belt
points: {A: [0, 0], B: [APART, 0]}
bodies: {one: {disk: A, radius: 0.1 m}, two: {disk: B, radius: 0.3 m}}
joints:
  - pin: {at: A, between: [ground, one]}
  - pin: {at: B, between: [ground, two]}
  - belt: {between: [one, two]CROSSED}
motion: [omega(one) = 2 rad/s]
find: {omega: omega(two)}
"""


@pytest.mark.parametrize(
    ("crossed", "near", "far"), [("", "0.15 m", "0.25 m"), (", crossed: true", "0.35 m", "0.45 m")]
)
def test_the_disks_of_a_belt_are_far_enough_apart(crossed: str, near: str, far: str) -> None:
    with pytest.raises(NoSolution, match=r"runs straight from one to two: they are too near each other") as refused:
        solve(BELT.replace("CROSSED", crossed).replace("APART", near))
    assert (refused.value.diagnostics[0].code, refused.value.diagnostics[0].mark.line) == ("PL522", 8)
    found = solve(BELT.replace("CROSSED", crossed).replace("APART", far))["omega"].values
    assert found is not None
    assert float(found[0]) == pytest.approx(-2 / 3 if crossed else 2 / 3)
