"""A line that names another body or point than the one meant is refused where it stands; it is no fault of planar."""

from __future__ import annotations

from pathlib import Path

import pytest

from planar_cli import cli

PROBLEMS = Path(__file__).parent.parent / "problems"


def told(folder: Path, capsys: pytest.CaptureFixture[str], file: str, *changes: tuple[str, str]) -> str:
    """What planar says to a problem file with something else written in it."""
    text = (PROBLEMS / file).read_text(encoding="utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    path = folder / "changed.yaml"
    path.write_text(text, encoding="utf-8")
    assert cli.run(["solve", str(path)]) in (1, cli.BAD)
    return capsys.readouterr().err


@pytest.mark.parametrize(
    ("file", "old", "new"),
    [
        ("motion/paths-from-three-frames.yaml", "theta(groove) = w*t", "theta(bead) = w*t"),
        ("oscillations/collar-on-a-turning-rod-with-spring.yaml", "omega(rod) = w", "omega(collar) = w"),
    ],
)
def test_a_particle_has_no_angle(
    file: str, old: str, new: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    err = told(tmp_path, capsys, file, (old, new))
    assert "PL420" in err
    assert "is a particle: it has no angle" in err
    assert new.split(" = ", maxsplit=1)[0] in err


def test_what_can_not_move_does_not_move_in_time(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    change = ("guide: {body: cart, along: 0 deg, name: road}", "guide: {body: groove, along: 0 deg, name: road}")
    err = told(tmp_path, capsys, "motion/paths-from-three-frames.yaml", change)
    assert ":22:5: PL607 `theta(groove) = w*t` can not hold all the time" in err


def test_bodies_placed_each_from_a_point_of_the_other(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    change = ("pin: {at: O, between: [ground, hoop]}", "pin: {at: O, between: [ground, bead]}")
    err = told(tmp_path, capsys, "oscillations/bead-on-a-turning-hoop.yaml", change)
    # P = O + R e(theta) + R e(theta + phi) stays where it is with theta' = w only at phi = pi, where phi does not vary.
    assert ":21:5: PL465 the pin holds bead at O, and bead is a particle at P, which moves with phi, theta" in err


def test_a_spring_whose_ends_coincide(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    change = ("motion: [y(wheel) =", "motion: [y(car) =")
    err = told(tmp_path, capsys, "oscillations/quarter-car-on-a-washboard.yaml", change)
    assert ":11:3: PL602 the loads on wheel" in err


def test_velocities_that_contradict_each_other_in_equilibrium(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    changes = (
        ("{particle: P, mass: m}", "{points: [P], center: P, mass: m, inertia: 0.1 kg*m^2}"),
        ("guide: {point: P, along: rod", "guide: {body: collar, along: rod"),
        ("[omega(rod) = w]", "[omega(collar) = w, omega(rod) = 2*w]"),
    )
    err = told(tmp_path, capsys, "oscillations/collar-on-a-turning-rod-with-spring.yaml", *changes)
    assert "PL607 `omega(rod) = 2*w`, but `omega(collar) = w` makes omega(rod) = 8 rad/s" in err


def test_a_force_at_another_particle(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    change = ("at: A, magnitude: F", "at: B, magnitude: F")
    err = told(tmp_path, capsys, "particles/two-sliders-on-a-link.yaml", change)
    assert ":18:5: PL465 B is another particle; the force B acts on A, which is a particle elsewhere" in err


def test_the_path_of_what_slides_is_not_that_of_the_body_below_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The bead starts at a point that is the end of the rod as well, or its path is asked by the end of the rod."""
    file = PROBLEMS / "motion/bead-flung-out-of-a-turning-rod-in-letters.yaml"
    text = file.read_text(encoding="utf-8").replace("rod: {rod: [O, E]}", "rod: {rod: [O, P]}")
    path = tmp_path / "changed.yaml"
    path.write_text(text, encoding="utf-8")
    assert cli.run(["solve", str(path)]) == 0
    assert "path: curve, r = r_0 cosh(θ)" in capsys.readouterr().out
    path.write_text(text.replace("[O, P]", "[O, E]").replace("path(P)", "path(E)"), encoding="utf-8")
    assert cli.run(["solve", str(path)]) == cli.DISAGREES
    assert "the solution gives x^2 + y^2 = L^2" in " ".join(capsys.readouterr().out.split())
