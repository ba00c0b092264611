"""The linear equation of a bar with a spring and a damper: from the lengths to the first order, once for all cases."""

from __future__ import annotations

from worked import page_of_file


def test_lengths_to_the_first_order_come_before_the_linear_equation() -> None:
    page = page_of_file("bar-with-spring-and-damper")
    lines = [
        "AK ≈ h + l θ",
        "AK′ ≈ l",
        "DW′ ≈ l/2",
        "moments: -1/4 c l² ω - k l² θ ≈ I_O α",
        "θ̈ + 3 c θ̇/(4 m) + 3 k θ/m = 0",
    ]
    places = [page.index(told) for told in lines]
    assert places == sorted(places)
    assert page.count("AK ≈ h + l θ") == 1
    assert "As before: the linear equation, ω_0 = 14.14 rad/s." in page
    assert "changes each by at most 1 %, angles of θ_1, the angular velocity of ω_0 θ_1." in page
