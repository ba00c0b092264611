"""What is left of zero in a run with numbers is no mistake that somebody makes."""

from __future__ import annotations

from planar_cli.homework.exports._asked import Asked, LeftOut, numbers
from planar_cli.homework.sets.paper import Expected, Mistaken, Task


def test_the_rest_of_a_zero_component_is_zero() -> None:
    wrong = Mistaken("left-out", "It is left out.", (5.0, 3e-16))
    expected = Expected("v", "velocity", "vector", (3.0, 4.0), "m/s", "", 0.01, 1.0, mistakes=(wrong,))
    _, along_y = numbers(Asked(Task("p", "P", "", (), (expected,)), expected, 0), LeftOut())
    assert [m.value for m in along_y.mistakes] == [0.0]
