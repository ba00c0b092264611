"""One mistake that explains all wrong numbers of a problem is told first, and nothing is carried in a circle."""

from __future__ import annotations

from pathlib import Path

from homework_made import homework_of, set_of

from planar_cli.homework.grading.grading_made import grading_of
from planar_cli.homework.sets.paper import Graded, Submission

PULLEY = """
plane: vertical
given: {I: 0.06 kg*m^2, R: 0.2 m, m_A: 2 kg, m_B: 1 kg, t_1: 0.5 s}
points: {O: [0, 0], L: [-R, 0], K: [R, 0], A: [-R, -3 m], B: [R, -3 m]}
bodies: {drum: {disk: O, radius: R, inertia: I}, block_A: {particle: A, mass: m_A}, block_B: {particle: B, mass: m_B}}
joints:
  - pin: {at: O, between: [ground, drum]}
  - rope: {path: [L on drum, A], name: left}
  - rope: {path: [K on drum, B], name: right}
states: {start: [t = 0, at rest], end: [t = t_1]}
find: {v_A: v(A).y @ end, v_B: v(B).y @ end, T_A: tension(left) @ end, T_B: tension(right) @ end}
"""
G = 9.81
WITHOUT = {
    "v_A": f"{-G / 6:.4g} m/s",
    "v_B": f"{G / 6:.4g} m/s",
    "T_A": f"{4 * G / 3:.4g} N",
    "T_B": f"{4 * G / 3:.4g} N",
}
SAID = "this is the result without the moment of inertia of drum"


def graded(folder: Path, answers: dict[str, str]) -> dict[str, Graded]:
    homework_set = set_of(folder, p=PULLEY)
    handed = Submission("ann", 0, tuple(("p", find, typed) for find, typed in answers.items()))
    found = grading_of(homework_set, homework_of(homework_set))()(handed).graded
    return {one.find: one for one in found}


def test_all_without_the_inertia(tmp_path: Path) -> None:
    """a = g/3 and both tensions 4 m g/3 of 1 kg: what is asked first does not follow from a tension that the same
    equations give, and the mistake is told of each answer.
    """
    found = graded(tmp_path, WITHOUT)
    assert all(SAID in (f"{one.message}; {one.feedback}") for one in found.values())
    assert all("rotational-inertia-left-out" in one.mistakes for one in found.values())
    assert found["v_A"].carried == ()
    order = list(found)
    assert all(order.index(name) < order.index(one.find) for one in found.values() for name in one.carried)
    carried = [one for one in found.values() if one.carried]
    assert carried
    assert all(one.message.startswith(f"{SAID}; it follows rightly from your") for one in carried)


def test_what_no_mistake_explains_is_carried_as_ever(tmp_path: Path) -> None:
    """v_B = -v_A, whatever v_A is."""
    found = graded(tmp_path, {"v_A": "-1.432 m/s", "v_B": "1.432 m/s"})
    assert found["v_B"].carried == ("v_A",)
    assert found["v_B"].mistakes == ()
