"""Where a motion begins: places and velocities from the first state, over- and underdetermined ones told by name."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from answered import BARS_IN_A_LOOP

from planar_cli.errors import PlanarError
from planar_cli.motion.regime.model import Model
from planar_cli.motion.scene.scene import MovingScene
from planar_cli.motion.start.start import Start, start_of
from planar_cli.problem.structure import load

FOUR_BAR = BARS_IN_A_LOOP.format(A="[0, 0]", B="[0, 1 m]", C="[2 m, 1.5 m]", D="[2 m, 0]", mass="2 kg")
BALL = """
title: Ball
plane: vertical
bodies: {P: {particle: free, mass: 1 kg}}
"""
BLOCK = """
title: Block
plane: vertical
points: {C: [0, 0]}
surfaces: {slope: {through: C, angle: 30 deg}}
bodies: {b: {particle: C, mass: 2 kg}}
joints:
  - contact: {between: [b, slope], at: C, mu: 0.3}
"""
SPUN = """
title: Ball drawn at an angle
plane: vertical
given: {phi: 30 deg}
points: {P: [1 m, 1 m * sin(phi)]}
bodies: {P: {particle: P, mass: 1 kg}}
find: {v: v(P) @ 2}
"""
CAUGHT = """
title: Rods and plates that a hook catches
plane: vertical
points: {A: [0, 1 m], B: [1 m, 1 m], K: PLACE}
bodies: {b: BODY}
joints:
  - pin: {at: K, between: [ground, b], during: 2->3}
states: {1: [t = 0, at rest], 2: [y(b) = 0.5 m], 3: [theta(b) = -90 deg]}
"""


def model_of(folder: Path, text: str) -> Model:
    path = folder / "p.yaml"
    path.write_text(text, encoding="utf-8")
    problem, wrong, _ = load(str(path))
    assert problem is not None, wrong
    return Model(MovingScene(problem))


def begun(folder: Path, text: str) -> tuple[Model, Start, dict[str, float]]:
    """The start with the state by names."""
    model = model_of(folder, text)
    start = start_of(model)
    names = [model.graph.names[v] for v in model.layout.state]
    return model, start, dict(zip(names, start.state, strict=True))


def test_velocities_of_a_mechanism_from_one_of_them(tmp_path: Path) -> None:
    model, start, at = begun(tmp_path, FOUR_BAR + "instant: [omega(AB) = -2 rad/s]\n")
    # v_B = (2, 0); C turns about D, and B and C keep their distance: v_C = ω_CD (-1.5, 0), along BC (2, 0.5).
    omega = -2.0 * 2 / (1.5 * 2)
    assert at["omega_CD"] == pytest.approx(omega)
    assert at["omega_BC"] == pytest.approx(0.0)
    assert max(map(abs, model.regime().residuals(start.time, start.state))) < 1e-15


def test_rest_is_rest(tmp_path: Path) -> None:
    _, start, _ = begun(tmp_path, FOUR_BAR + "instant: [at rest]\n")
    assert not any(start.state[len(start.state) // 2 :])


def test_size_and_direction_of_a_velocity(tmp_path: Path) -> None:
    said = "instant: [x(P) = 2 m, y(P) = 1 m, v(P).mag = 10 m/s, v(P).angle = 120 deg]\n"
    _, _, at = begun(tmp_path, BALL + said)
    expected = [2.0, 1.0, -5.0, 10 * math.sqrt(0.75)]
    assert list(at.values()) == pytest.approx(expected)


def test_a_speed_along_a_slope_either_way(tmp_path: Path) -> None:
    for sign, operator in ((1, ">"), (-1, "<")):
        _, _, at = begun(tmp_path, BLOCK + f"instant: [v(b).mag = 3 m/s, v(b).x {operator} 0]\n")
        assert at["vx_b"] == pytest.approx(sign * 3 * math.sqrt(0.75))
        assert at["vy_b"] == pytest.approx(sign * 1.5)


SWUNG = FOUR_BAR.replace("B: [0, 1 m], C: [2 m, 1.5 m]", "B: {B}, C: {C}")
AB_AT = "{from: A, distance: 1 m, angle: phi}"
C_AT = "{distances: {B: sqrt(17/4)*(1 m), D: 1.5 m}, side: above}"


def test_places_follow_from_relations(tmp_path: Path) -> None:
    """What is written with a coordinate is where the first state says."""
    text = "coordinates: {phi: deg}\n" + SWUNG.replace("{B}", AB_AT).replace("{C}", C_AT)
    _, _, at = begun(tmp_path, text + "instant: [omega(AB) = 0, theta(AB) = 80 deg]\n")
    assert at["theta_AB"] == pytest.approx(math.radians(80))
    b = math.cos(math.radians(80)), math.sin(math.radians(80))
    end = [at["x_BC"] * 2 - b[0], at["y_BC"] * 2 - b[1]]
    assert math.dist(end, (2, 0)) == pytest.approx(1.5)
    assert math.dist(end, b) == pytest.approx(math.hypot(2, 0.5))


WHEEL = """
title: Wheel
plane: horizontal
points: {O: [0, 0], P: [0.1 m, 0]}
bodies: {wheel: {disk: O, radius: 0.1 m, mass: 4 kg%s}}
joints:
  - pin: {at: O, between: [ground, wheel]}
states:
  1: [t = 0, theta(wheel) = 60 deg, omega(wheel) = 0]
"""


def test_a_wheel_has_turned_as_far_as_the_first_state_says(tmp_path: Path) -> None:
    """Unless a point of its rim is drawn."""
    _, _, at = begun(tmp_path, WHEEL % "")
    assert at["theta_wheel"] == pytest.approx(math.radians(60))
    with pytest.raises(PlanarError, match="does not hold in the drawn position"):
        begun(tmp_path, WHEEL % ", points: [P]")


@pytest.mark.parametrize("said", ["theta(AB) = 80 deg", "x(B) = 0.1 m", "r(C/A).mag = 2 m"])
def test_what_is_drawn_is_not_moved(tmp_path: Path, said: str) -> None:
    with pytest.raises(PlanarError, match="does not hold in the drawn position") as caught:
        begun(tmp_path, FOUR_BAR + f"instant: [omega(AB) = 0, {said}]\n")
    assert caught.value.diagnostics[0].code == "PL609"
    assert caught.value.diagnostics[0].mark.line > 1


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (FOUR_BAR + "instant: [omega(AB) = 1 rad/s, omega(CD) = 1 rad/s]\n", "no start fulfils"),
        (FOUR_BAR, "velocity of AB, BC, CD"),
        (BALL + "instant: [x(P) = 2 m, at rest]\n", "where P is"),
        (BLOCK + "instant: [v(b).x = 1 m/s, v(b).y > 0.7 m/s]\n", "contradicts"),
        (SPUN + "states: {1: [t = 0, at rest, phi > 60 deg], 2: [y(P) = 0]}\n", "contradicts “phi > 60 deg”"),
        (SPUN + "states: {1: [t = 0, v(P).x = 1 m/s, v(P).y = 0, phi > 60 deg], 2: [y(P) = 0]}\n", "phi > 60 deg"),
    ],
)
def test_what_is_wrong_is_told(tmp_path: Path, text: str, words: str) -> None:
    with pytest.raises(PlanarError, match=words) as caught:
        begun(tmp_path, text)
    assert {d.code for d in caught.value.diagnostics} == {"PL704"}


@pytest.mark.parametrize(
    ("body", "place", "caught"),
    [
        ("{rod: [A, B], mass: 1 kg}", "[0.3 m, 1 m]", True),
        ("{rod: [A, B], mass: 1 kg}", "[1.2 m, 1 m]", False),
        ("{rod: [A, B], mass: 1 kg}", "[-0.2 m, 1 m]", False),
        ("{rod: [A, B], mass: 1 kg}", "[0.3 m, 0.5 m]", False),
        ("{plate: A, width: 1 m, height: 0.4 m, angle: 90 deg, mass: 1 kg}", "[0.1 m, 1.4 m]", True),
        ("{plate: A, width: 1 m, height: 0.4 m, angle: 90 deg, mass: 1 kg}", "[0.4 m, 1.1 m]", False),
        ("{disk: A, radius: 0.3 m, mass: 1 kg}", "[0.3 m, 1 m]", True),
        ("{disk: A, radius: 0.3 m, mass: 1 kg}", "[0.3 m, 0.7 m]", False),
        ("{disk: A, radius: 0.3 m, mass: 1 kg, points: [K]}", "[0.3 m, 0.7 m]", True),
    ],
)
def test_what_is_caught_later_is_drawn_on_the_body(tmp_path: Path, body: str, place: str, caught: bool) -> None:
    """A fixed place beside the body, to which it comes, does not tell which of its points is there by then."""
    text = CAUGHT.replace("PLACE", place).replace("BODY", body)
    if caught:
        model_of(tmp_path, text)
        return
    with pytest.raises(PlanarError, match="takes hold of b at 2") as told:
        model_of(tmp_path, text)
    assert [d.code for d in told.value.diagnostics] == ["PL537"]
