"""Energy before Newton's law where several bodies move and only speeds and places are asked."""

from __future__ import annotations

from worked import page_of_file


def test_speed_and_way_of_several_bodies_follow_from_one_balance_of_energies() -> None:
    page = page_of_file("load-on-four-strands")
    assert "Principle Work and energy between the states." in page
    assert "ΣF" not in page
    assert "= 5.844 m/s², constant; 2 " in page, "Newton's law is the check"


def test_where_a_force_is_asked_newtons_law_stays() -> None:
    assert "ΣF_y" in page_of_file("gears-turned-by-a-load")


def test_with_newtons_law_a_constant_acceleration_is_shorter_than_energies() -> None:
    page = page_of_file("gears-turned-by-a-load")
    assert "Principle Newton's second law. Constant angular acceleration." in page
    assert "constant angular acceleration of the pinion" in page
    assert "= 392.4 - 200 = 192.4 J; T_2 = 29.6 + 88.8 + 74 = 192.4 J (pinion, gear, load)" in page


def test_a_way_between_given_places_is_in_letters() -> None:
    page = page_of_file("ex-4-09")
    assert "(2) θ_2 = h/R = 0.6/0.2 = 3 rad" in page
    assert "y_A,1" not in page, "the way alone counts, not the places"
    assert "F r θ_2 - M θ_2 - m_A g h = 1/2 m k_O² ω_2² + 1/2 m_A v²" in page


def test_a_constant_acceleration_that_is_needed_anyway_serves_for_speeds_and_heights_too() -> None:
    page = page_of_file("ex-1-06")
    assert "Principle Newton's second law. Constant acceleration." in page
    assert "(2): y_top = v0²/(2 g) + h" in page
    assert "From thrown to half, constant acceleration of the ball along y:" in page
    assert "(3) v_half² = v0² - 2 g (y_half - h)" in page
    assert "work and kinetic energy" not in page


def test_where_no_law_is_needed_energies_stay() -> None:
    """The push of the buffer is asked, and no time while the block slides freely."""
    assert "From 1 to meets, work and kinetic energy" in page_of_file("block-down-a-slope-onto-a-buffer")
    assert "From 1 to 2, work and kinetic energy" in page_of_file("falling-rod-caught-by-a-cord")


def test_a_velocity_that_stays_has_its_reason() -> None:
    """Constant velocity of the rolling ball has told its place already; of the free carriages that no force acts."""
    ball, carriages = page_of_file("body-ball-that-slides-then-rolls"), page_of_file("three-carriages")
    place = ball.index("From rolls to later, constant angular velocity of the ball: (9) θ_later = θ_rolls + ")
    assert place < ball.index("From rolls to later, no angular acceleration of the ball: (11) ω_later = ω_rolls = ")
    assert "T_rolls + U" not in ball
    assert "no acceleration, x of" not in carriages
    assert carriages.count("no resultant force acts on") == 5


def test_the_work_by_a_height_that_was_sought_has_its_number() -> None:
    page = page_of_file("ladder-leaving-the-wall")
    assert "y_G,2 = 1/2 l sin θ_2 U of the weight" in page
    assert "U of the weight of ladder = 1/2 m g l sin θ_2 = 1/2 · 15 · 9.81 · 4 sin 141.2° = 184.4 J" in page
