"""Arms and unit vectors with the angle of the file before their numbers."""

from __future__ import annotations

from decimal import Decimal

from worked import page_of_file

from planar_cli.report.document.blocks import line
from planar_cli.report.kinematics.along_slots import by_angle


def test_an_arm_by_the_distance_and_the_angle_of_the_file() -> None:
    page = page_of_file("gripper-on-two-turning-arms")
    assert "r_A/O = [0.4 cos 60°, 0.4 sin 60°] = [0.2, 0.3464] m" in page
    assert "r_P/A = [0.1 cos 30°, -0.1 sin 30°] = [0.08660, -0.05] m" in page, "at -30°"


def test_a_unit_vector_by_its_angle() -> None:
    assert "e = [cos 60°, sin 60°] = [0.5, 0.8660] along AC" in page_of_file("pin-in-two-slotted-rods")
    assert "e = [cos 30°, -sin 30°] = [0.8660, -0.5] along AB" in page_of_file("gripper-on-two-turning-arms")


def test_along_and_across_a_line_that_falls() -> None:
    root = Decimal(3).sqrt() / 2
    down, left, right = (root, Decimal("-0.5")), (Decimal("0.5"), root), (Decimal("-0.5"), -root)
    assert by_angle(down, down) == line("[cos 30°, -sin 30°] = ")
    assert by_angle(left, down) == line("[sin 30°, cos 30°] = ")
    assert by_angle(right, down) == line("[-sin 30°, -cos 30°] = ")


def test_an_arm_stands_before_its_numbers() -> None:
    page = page_of_file("slider-crank-two-positions")
    assert page.index("r_A/O = [r_c cos θ, r_c sin θ] = ") < page.index("v_A = ω_crank × r_A/O = [-0.04 · 50")
    assert "[0, 0.2 · 3] m/s r_C/O = [0.06, 0] m" not in page
    assert "= [0, 1.2] m/s r_C/O = [0.06, 0] m" in page_of_file("planetary-gear"), "along an axis it stays behind"
