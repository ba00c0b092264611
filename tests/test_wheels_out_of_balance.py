"""Wheels whose mass centre is not their middle: `disk: O, radius: R, center: G`; and cords wound on such rims."""

from __future__ import annotations

import math

import pytest
from answered import assert_close, solve

from planar_cli.errors import FileProblem

R, E, M, K, G = 0.25, 0.075, 20.0, 0.202, 9.81
INERTIA = M * K * K


def wheel(body: str, *rest: str, angle: float = 0.0, plane: str = "vertical") -> str:
    """A wheel that stands on a level floor, OG at an angle in degrees."""
    return "\n".join([
        "title: Wheel out of balance",
        f"plane: {plane}",
        f"points: {{C: [0, 0], O: [0, {R} m], G: {{from: O, distance: {E} m, angle: {angle} deg}}}}",
        "surfaces: {floor: {through: C, angle: 0 deg}}",
        f"bodies: {{wheel: {{{body}}}}}",
        *rest,
    ])  # fmt: skip


ROLLS = "joints: [rolling: {between: [wheel, floor], at: C}]"
ASKED = "find: {alpha: alpha(wheel), N: N(C), F: friction(C).x}"


def rolled(angle: float, omega: float) -> tuple[float, float, float]:
    """Angular acceleration, normal force and friction, by Lagrange's equation with the angle of the wheel."""
    x, y = E * math.cos(angle), E * math.sin(angle)
    # T = m/2 ((R + y)² + x²) w² + I w²/2 with dx = -y dθ, dy = x dθ; V = m g y.
    about_contact = INERTIA + M * ((R + y) ** 2 + x**2)
    alpha = (-M * G * x - M * R * x * omega**2) / about_contact
    ax, ay = -alpha * (R + y) - omega**2 * x, alpha * x - omega**2 * y
    return alpha, M * (G + ay), M * ax


@pytest.mark.parametrize("shape", ["disk", "ring", "sphere"])
@pytest.mark.parametrize(
    "inertia",
    [f"radius_of_gyration: {K} m", f"inertia: {INERTIA} kg*m^2", f"inertia: {INERTIA + M * E * E} kg*m^2, about: O"],
)
@pytest.mark.parametrize(("angle", "omega"), [(0, -3), (120, 2), (-90, 5)])
def test_it_rolls_as_lagranges_equation_says(shape: str, inertia: str, angle: float, omega: float) -> None:
    body = f"{shape}: O, radius: {R} m, center: G, mass: {M} kg, {inertia}"
    found = solve(wheel(body, ROLLS, f"instant: [omega(wheel) = {omega} rad/s]", ASKED, angle=angle))
    for name, truth in zip(("alpha", "N", "F"), rolled(math.radians(angle), omega), strict=True):
        assert_close(found[name], truth, 9)


def test_a_centre_in_the_middle_is_a_uniform_disk() -> None:
    text = wheel(f"disk: O, radius: {R} m, center: O, mass: {M} kg", ROLLS, "loads: [force: {body: wheel, at: O, "
                 "magnitude: 30 N, angle: 0 deg}]", "instant: [at rest]", ASKED)  # fmt: skip
    assert_close(solve(text)["alpha"], -30 * R / (1.5 * M * R * R))


def test_it_comes_round_to_the_lowest_place_of_its_mass_centre() -> None:
    body = f"disk: O, radius: {R} m, center: G, mass: {M} kg, radius_of_gyration: {K} m"
    states = "states: {1: [at rest], 2: [theta(wheel) @ 2 - theta(wheel) @ 1 = -90 deg]}"
    found = solve(wheel(body, ROLLS, states, "find: {w: omega(wheel) @ 2}"))
    assert_close(found["w"], -math.sqrt(2 * M * G * E / (INERTIA + M * (R - E) ** 2)), 9)


def test_its_inertia_must_be_told_where_it_counts() -> None:
    with pytest.raises(Exception, match="inertia"):
        solve(wheel(f"disk: O, radius: {R} m, center: G, mass: {M} kg", ROLLS, "instant: [at rest]", ASKED))


def drum(body: str, find: str) -> str:
    return "\n".join([
        "title: Drum out of balance with a block",
        "plane: vertical",
        "points: {O: [0, 0], G: [-0.05 m, 0.03 m], T: [0.2 m, 0], B: [0.2 m, -1 m]}",
        f"bodies: {{drum: {body}, B: {{particle: B, mass: 3 kg}}}}",
        "joints:",
        "  - pin: {at: O, between: [ground, drum]}",
        "  - rope: {path: [B, T on drum], name: cord}",
        "instant: [omega(drum) = 3 rad/s cw]",
        f"find: {find}",
    ])  # fmt: skip


@pytest.mark.parametrize(
    ("body", "inertia", "mass", "x"),
    [
        ("{disk: O, radius: 0.2 m, center: G, mass: 5 kg, inertia: 0.1 kg*m^2, about: O}", 0.1, 5, -0.05),
        ("{disk: O, radius: 0.3 m, hub: 0.2 m, center: G, mass: 5 kg, inertia: 0.1 kg*m^2, about: O}", 0.1, 5, -0.05),
        ("{parts: [{disk: O, radius: 0.2 m, mass: 4 kg}, {particle: G, mass: 2 kg}]}", 0.08 + 2 * 0.0034, 2, -0.05),
    ],
)
def test_a_cord_unwinds_about_the_middle_of_the_rim(body: str, inertia: float, mass: float, x: float) -> None:
    found = solve(drum(body, "{v: v(B).y, alpha: alpha(drum), T: tension(cord)}"))
    alpha = (-mass * G * x - 3 * G * 0.2) / (inertia + 3 * 0.2**2)
    assert_close(found["v"], -0.6)
    assert_close(found["alpha"], alpha, 9)
    assert_close(found["T"], 3 * (G + 0.2 * alpha), 9)


@pytest.mark.parametrize(
    ("body", "said"),
    [
        (f"{{parts: [{{disk: O, radius: {R} m, center: G, mass: 2 kg}}]}}", "PL331"),
        (f"{{points: [O], radius: {R} m, center: G, mass: 2 kg}}", "`disk: O, radius: R`, with `center: G`"),
        ("{points: [O, C], center: G, mass: 2 kg, inertia: 1 kg*m^2}", "`center: G`"),
    ],
)
def test_other_ways_to_write_it_are_told_this_one(body: str, said: str) -> None:
    text = wheel("", ROLLS, "instant: [at rest]", ASKED).replace("wheel: {}", f"wheel: {body}")
    with pytest.raises(FileProblem) as caught:
        solve(text)
    assert any(said in f"{d.code} {d.message} {d.hint}" for d in caught.value.diagnostics)


def test_a_belt_runs_on_no_wheel_out_of_balance() -> None:
    text = wheel(
        f"disk: O, radius: {R} m, center: G, mass: any, radius_of_gyration: {K} m}}, other: {{disk: P, radius: 0.1 m",
        "joints: [pin: {at: O, between: [ground, wheel]}, pin: {at: P, between: [ground, other]}, "
        "belt: {between: [wheel, other]}]",
        "instant: [omega(other) = 2 rad/s]",
        "find: {w: omega(wheel)}",
    ).replace("O: [0,", "P: [1 m, 0], O: [0,")
    with pytest.raises(FileProblem) as caught:
        solve(text)
    assert [d.code for d in caught.value.diagnostics] == ["PL455"]
