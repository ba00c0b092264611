"""Verdicts on value, unit, sign and precision, each by itself; what they score; mistakes by their numbers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import pytest

from planar_cli.homework.grading.class_report import ClassReport
from planar_cli.homework.grading.grading import grade
from planar_cli.homework.grading.grading_made import MakeGrade
from planar_cli.homework.mistakes.unit_not_converted import UnitNotConverted
from planar_cli.homework.sets.paper import Expected, Graded, Mistaken, Paper, Submission, Task
from planar_cli.homework.sets.rules import Rules

FORCE = Expected("F", "", "number", (12.74,), "N", "12.74 N", 0.01, 100.0, axis="x")
LEFTWARD = replace(FORCE, values=(-12.74,))
NORMAL = replace(FORCE, axis="")
SIZE = replace(NORMAL, size=True)
ALONG = Expected("a", "", "number", (5.5,), "m/s^2", "5.500 m/s²", 0.01, 1.0, heading=0.436)
GAP = Expected("s", "", "number", (209.4,), "mm", "209.4 mm", 0.01, 1000.0)
TURN = Expected("w", "", "number", (-6.186,), "rad/s", "6.186 rad/s clockwise", 0.01, 1.0, rotation=True)
ANGLE = Expected("p", "", "number", (170.0,), "deg", "170°", 0.01, 1.0, direction=True)
VELOCITY = Expected("v", "", "vector", (3.0, -4.0), "m/s", "[3, -4] m/s", 0.01, 1.0)
WORD = Expected("s", "", "word", (), "1", "slip", 0.01, 1.0)
STAYS = Expected("s", "", "word", (), "1", "no", 0.01, 1.0, mode="stick")


def graded(expected: Expected, text: str, rules: Rules | None = None) -> Graded:
    paper = Paper(0, (Task("p", "", "", (), (expected,)),))
    (one,) = grade(Submission("s", 0, (("p", expected.find, text),)), {0: paper}, rules or Rules()).graded
    return one


@pytest.mark.parametrize(
    ("expected", "text", "verdict", "value", "unit", "sign"),
    [
        (FORCE, "12.7 N", "right", "right", "right", "right"),
        (FORCE, "0.01274 kN", "right", "right", "right", "right"),
        (FORCE, "12.74 N right", "right", "right", "right", "right"),
        (FORCE, "12.74 N left", "wrong", "right", "right", "wrong"),
        (FORCE, "-12.74 N", "wrong", "right", "right", "wrong"),
        (FORCE, "12.74", "ungradable", "", "missing", ""),
        (FORCE, "12.74 kg", "wrong", "right", "wrong", "right"),
        (FORCE, "13.5 N", "wrong", "wrong", "right", ""),
        (FORCE, "12.74 N up", "wrong", "right", "right", "wrong"),
        (FORCE, "12.74 N cw", "ungradable", "", "", ""),
        (FORCE, "hm", "ungradable", "", "", ""),
        (FORCE, "-12.74 N right", "wrong", "right", "right", "wrong"),
        (LEFTWARD, "-12.74 N to the left", "right", "right", "right", "right"),
        (LEFTWARD, "12.74 N at 180 deg", "right", "right", "right", "right"),
        (NORMAL, "12.74 N upwards", "right", "right", "right", "right"),
        (NORMAL, "12.74 N at 90 deg", "ungradable", "", "", ""),
        (TURN, "-6.19 rad/s cw", "right", "right", "right", "right"),
        (GAP, "0.2094", "ungradable", "", "missing", ""),
        (GAP, "209.4", "ungradable", "", "missing", ""),
        (GAP, "0.02094", "wrong", "wrong", "missing", ""),
        (FORCE, "", "missing", "", "", ""),
        (STAYS, "no", "right", "right", "", ""),
        (STAYS, "slips", "right", "right", "", ""),
        (STAYS, "sticks", "wrong", "wrong", "", ""),
        (TURN, "6.19 rad/s cw", "right", "right", "right", "right"),
        (TURN, "-6.19 rad/s", "right", "right", "right", "right"),
        (TURN, "59.07 rpm cw", "right", "right", "right", "right"),
        (TURN, "6.19 rad/s ccw", "wrong", "right", "right", "wrong"),
        (ANGLE, "-190 deg", "right", "right", "right", "right"),
        (ANGLE, "2.967 rad", "right", "right", "right", "right"),
        (VELOCITY, "[3, -4] m/s", "right", "right", "right", "right"),
        (VELOCITY, "5 m/s at -53.13 deg", "right", "right", "right", "right"),
        (VELOCITY, "[3, 4] m/s", "wrong", "right", "right", "wrong"),
        (VELOCITY, "[4, -3] m/s", "wrong", "wrong", "right", ""),
        (SIZE, "12.74 N at 230 deg", "right", "right", "right", "right"),
        (SIZE, "[7.644, 10.19] N", "right", "right", "right", "right"),
        (FORCE, "[12.74, 3.00] N", "right", "right", "right", "right"),
        (FORCE, "12.74 N in the negative x direction", "wrong", "right", "right", "wrong"),
        (LEFTWARD, "12.74 N in -x direction", "right", "right", "right", "right"),
        (NORMAL, "[12.74, 0] N", "ungradable", "", "", ""),
        (ALONG, "5.50 m/s^2 up", "right", "right", "right", "right"),
        (ALONG, "5.50 m/s^2 down", "wrong", "right", "right", "wrong"),
        (ALONG, "5.50 m/s^2 up the ramp", "right", "right", "right", "right"),
        (ALONG, "5.50 m/s^2 down the slope", "wrong", "right", "right", "wrong"),
        (ALONG, "-5.50 m/s^2 down the slope", "wrong", "right", "right", "wrong"),
        (ALONG, "5.50 m/s^2 to the left", "wrong", "right", "right", "wrong"),
        (ALONG, "5.50 m/s^2 at 25 deg", "right", "right", "right", "right"),
        (ALONG, "[4.98, 2.32] m/s^2", "right", "right", "right", "right"),
        (ALONG, "[-4.98, -2.32] m/s^2", "wrong", "right", "right", "wrong"),
        (ALONG, "5.50 m/s^2 at 90 deg", "ungradable", "", "", ""),
        (WORD, "it slides", "ungradable", "", "", ""),
        (WORD, "slides", "right", "right", "", ""),
        (WORD, "sticks", "wrong", "wrong", "", ""),
    ],
)
def test_verdicts(expected: Expected, text: str, verdict: str, value: str, unit: str, sign: str) -> None:
    one = graded(expected, text)
    assert (one.verdict, one.value, one.unit, one.sign) == (verdict, value, unit, sign)


def test_a_missing_sense_is_not_told_as_a_wrong_one() -> None:
    assert "the sense is missing" in graded(TURN, "6.19 rad/s").message
    assert graded(TURN, "6.19 rad/s ccw").message == "the sign or sense is not right"
    assert "the direction is missing" in graded(LEFTWARD, "12.74 N").message


def test_a_part_of_the_points_is_partly_right() -> None:
    one = graded(VELOCITY, "[3.00, 4.00] m/s", Rules(sign=0.5))
    assert (one.score, one.told, one.message) == (0.5, "partly right", "the size is right, the direction is not")
    assert graded(VELOCITY, "[3, 4] m/s").told == "wrong"
    assert graded(FORCE, "13 N", Rules(precision=0.9, tolerance=0.05)).told == "partly right"


@pytest.mark.parametrize(("text", "verdict"), [("-3.66 rad/s cw", "carried"), ("-3.70 rad/s cw", "wrong")])
def test_a_minus_before_clockwise_may_be_its_opposite_where_earlier_values_say_so(text: str, verdict: str) -> None:
    task = Task("p", "", "", (), (FORCE, TURN), behind=(("w", ("F",)),))
    handed = Submission("s", 0, (("p", "F", "20.0 N"), ("p", "w", text)))
    (_, one) = grade(handed, {0: Paper(0, (task,))}, Rules(), lambda *_: ((3.66,), ("F",))).graded
    assert one.told == verdict
    assert ("say the same" in one.message) == (verdict == "wrong")


def test_a_vector_without_its_direction_is_told_so() -> None:
    assert "the direction is missing" in graded(VELOCITY, "5 m/s").message


SLANT = 0.5235987755982988
DRAG = replace(VELOCITY, values=(-10.392, -6.0), unit="N", lines=(SLANT, 0.0))
SLIDER = replace(VELOCITY, values=(-19.9, 0.0), unit="m/s^2", lines=(0.0,))


@pytest.mark.parametrize(
    ("expected", "text", "verdict", "message"),
    [
        (DRAG, "12.0 N down the slope", "right", ""),
        (DRAG, "12.0 N along the ramp, down", "right", ""),
        (DRAG, "12.0 N up the incline", "wrong", "the size is right, the direction is not"),
        (DRAG, "-12.0 N", "ungradable", None),
        (replace(DRAG, lines=()), "12.0 N down the slope", "ungradable", None),
        (SLIDER, "-19.9 m/s^2", "right", "read as the component along x; the other is taken for zero"),
        (SLIDER, "-21.9 m/s^2", "wrong", None),
        (SLIDER, "19.9 m/s^2", "ungradable", None),
        (replace(SLIDER, lines=()), "-19.9 m/s^2", "ungradable", None),
        (replace(SLIDER, values=(19.9, 0.0)), "19.9 m/s^2", "right", None),
    ],
)
def test_a_vector_is_told_along_a_line(expected: Expected, text: str, verdict: str, message: str | None) -> None:
    one = graded(expected, text)
    assert one.verdict == verdict
    assert message is None or one.message == message
    assert verdict != "ungradable" or "the direction is missing" in one.message


@pytest.mark.parametrize("text", ["n/a", "-", "?", " N/A "])
def test_what_says_that_there_is_no_answer_is_none(text: str) -> None:
    assert (graded(FORCE, text).verdict, graded(FORCE, text).message) == ("missing", "there is no answer")


def test_examples_are_in_the_unit_that_is_asked() -> None:
    assert "such as `12.5 rad/s`" in graded(TURN, "fast").message
    assert "`[3, -4] N`, or magnitude and direction, `5 N at -53 deg`" in graded(DRAG, "much").message


def test_what_is_taken_of_a_vector_is_told() -> None:
    assert graded(SIZE, "12.74 N at 230 deg").message == "a vector was typed: the size of it is taken"


def test_how_an_answer_was_read_is_told_beside_its_verdict() -> None:
    assert graded(NORMAL, "12.74 N upwards").message == "the direction in words is not graded here"
    assert graded(NORMAL, "12.74 N down the slope").message == "not read: 'down the slope'"
    assert graded(FORCE, "15 N down the slope").message == "the value is not right; not read: 'down the slope'"
    assert "only a vector" in graded(NORMAL, "12.74 N at 90 deg").message
    assert graded(GAP, "0.2094", Rules(no_unit=0.5)).score == 0.5


def test_few_figures_are_told_and_cost_only_on_request() -> None:
    coarse = replace(FORCE, values=(13.05,))
    assert graded(coarse, "13 N").verdict == "right"
    assert graded(coarse, "13 N").precision == "wrong"
    strict = graded(coarse, "13 N", Rules(precision=0.8))
    assert (strict.verdict, strict.score) == ("wrong", 0.8)
    exact = replace(FORCE, values=(13.0,))
    assert graded(exact, "13 N", Rules(precision=0.8)).verdict == "right"


SLANTED = replace(VELOCITY, values=(2.733, -1.2744))
UPWARD = replace(VELOCITY, values=(0.0, 74.35))
TURNED = replace(VELOCITY, values=(2.7382, -1.2665))


@pytest.mark.parametrize(
    ("expected", "text", "said"),
    [
        (UPWARD, "74.4 m/s at 90 deg", ""),
        (UPWARD, "74.4 m/s at 90.3 deg", ""),
        (UPWARD, "74 m/s at 90 deg", "write 3 significant figures"),
        (UPWARD, "[0, 74.4] m/s", ""),
        (UPWARD, "[0.3, 74.4] m/s", ""),
        (UPWARD, "[0.3, 74] m/s", "write 3 significant figures"),
        # The direction is -24.82°.
        (TURNED, "3.02 m/s at -25 deg", "write the angle to 0.1°"),
        (TURNED, "3.02 m/s at 25 deg below +x", "write the angle to 0.1°"),
        (TURNED, "3.02 m/s at -24.8 deg", ""),
        (TURNED, "3.02 m/s at -0.43 rad", ""),
        (SLANTED, "3.0 m/s at -25.0 deg", "write 3 significant figures"),
        (SLANTED, "[2.73, -1.3] m/s", "write 3 significant figures"),
    ],
)
def test_a_direction_is_as_exact_as_the_vector_needs(expected: Expected, text: str, said: str) -> None:
    one = graded(expected, text, Rules(precision=0.9))
    assert (one.value, one.message, one.score) == ("right", said, 0.9 if said else 1.0)


@pytest.mark.parametrize(
    ("text", "right"), [("12.7 N", True), ("12.8 N", False), ("12.69 N", True), ("12.68 N", False)]
)
def test_by_significant_figures(text: str, right: bool) -> None:
    assert (graded(FORCE, text, Rules(mode="sigfig", figures=3)).value == "right") == right


MOON = replace(ALONG, values=(3.7,), heading=None, gravity=1.62)
POUNDS = replace(FORCE, values=(74.35,), unit="lbf", gravity=9.81456)
MASS = replace(NORMAL, values=(2.5,), unit="lb")
MOMENT = replace(NORMAL, values=(40.0,), unit="lbf*ft")
INERTIA = replace(NORMAL, values=(2.5,), unit="lb*ft^2")


@pytest.mark.parametrize(
    ("expected", "text", "verdict"),
    [
        (replace(MOON, gravity=0), "0.3773 g", "right"),
        (MOON, "2.284 g", "right"),
        (MOON, "0.3773 g", "wrong"),
        (MASS, "1134 g", "right"),
        (POUNDS, "74.4 lb", "right"),
        (POUNDS, "74.4 lbs", "right"),
        (replace(FORCE, values=(330.7,)), "74.4 lb", "right"),
        (MASS, "2.50 lb", "right"),
        (MASS, "2.50 lbs", "right"),
        (MASS, "0.0777 lb s^2/ft", "right"),
        (MASS, "2.50 lbf", "wrong"),
        (MOMENT, "40.0 lb-ft", "right"),
        (MOMENT, "480 lb in", "right"),
        (INERTIA, "2.50 lb ft^2", "right"),
        (INERTIA, "0.0777 slug*ft^2", "right"),
        (INERTIA, "0.0777 lb*ft*s^2", "right"),
    ],
)
def test_g_and_pounds_are_meant_as_they_are_due(expected: Expected, text: str, verdict: str) -> None:
    assert graded(expected, text).verdict == verdict


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("33.7 kg", "the unit is that of a mass (kg): times g it is the right force"),
        ("2.31 slug", "the unit is that of a mass (slug): times g it is the right force"),
        ("74.4 slug", "the number is right; the unit is that of a mass (slug)"),
        ("15 slug", "the unit is that of a mass (slug)"),
    ],
)
def test_masses_in_place_of_forces(text: str, said: str) -> None:
    one = graded(POUNDS, text, Rules(unit=0.5))
    assert (one.message, one.score) == (said, 0.0 if text == "15 slug" else 0.5)


def test_credit_for_part_of_it() -> None:
    rules = Rules(unit=0.5, no_unit=0.25, sign=0.4)
    assert graded(FORCE, "12.74 kg", rules).score == 0.5
    assert graded(FORCE, "12.74", rules).score == 0.25
    assert graded(FORCE, "-12.74 N", rules).score == 0.4


def test_a_true_zero_is_measured_by_the_problem() -> None:
    nothing = replace(FORCE, values=(0.0,), text="0")
    assert graded(nothing, "0.0005 N").verdict == "right"
    assert graded(nothing, "1 N").verdict == "wrong"


def test_one_mistake_is_named_several_are_not() -> None:
    first, second = (
        Mistaken("friction-left-out", "this is the result without friction", (15.0,)),
        Mistaken("b", "c", (15.002,)),
    )
    one = graded(replace(FORCE, mistakes=(first,)), "15.0 N")
    assert (one.mistakes, one.feedback) == (("friction-left-out",), "this is the result without friction")
    two = graded(replace(FORCE, mistakes=(first, second)), "15.0 N")
    assert (two.mistakes, two.feedback) == (("friction-left-out", "b"), "")
    assert graded(replace(FORCE, mistakes=(first,)), "15 N").mistakes == ()
    assert graded(replace(FORCE, mistakes=(first,)), "15.1 N").mistakes == ()


@pytest.mark.parametrize(
    ("wrong", "text", "figures", "is_named"),
    [
        (1.51585, "1.52 N", 3, True),
        (1.51585, "1.516 N", 3, True),
        (1.51585, "1.518 N", 3, False),
        (0.136354, "0.136 N", 3, True),
        (1.0049, "1.00 N", 3, True),
        (1.0071, "1.00 N", 3, False),
        # A number is as exact as it was typed, in the unit in which it was.
        (1024.6, "1.02 kN", 3, True),
        (9.9351e-3, "9.94 mN", 3, True),
        (1.51585, "1.5 N", 3, False),
        (1.51585, "1.5 N", 2, True),
    ],
)
def test_mistakes_are_known_as_far_as_the_number_was_written_out(
    wrong: float, text: str, figures: int, is_named: bool
) -> None:
    made = replace(NORMAL, mistakes=(Mistaken("friction-left-out", "without friction", (wrong,)),))
    one = graded(made, text, Rules(figures=figures))
    assert one.mistakes == (("friction-left-out",) if is_named else ())


def test_a_mistake_is_rounded_in_the_unit_of_the_student() -> None:
    made = replace(ANGLE, mistakes=(Mistaken("other-root", "the other root", (58.17,)),))
    assert graded(made, "1.02 rad").mistakes == ("other-root",)


@pytest.mark.parametrize(
    ("unit", "others"),
    [("m/s", {"km/h"}), ("ft/s", {"mi/h"}), ("in", {"feet"}), ("m", set()), ("rpm", {"rad/s"}), ("deg", {"radians"})],
)
def test_a_number_is_said_to_be_in_another_unit_than_the_one_that_is_asked(unit: str, others: set[str]) -> None:
    slips = list(UnitNotConverted().slips(replace(FORCE, values=(1.0,), unit=unit)))
    assert {said.split(" is one in ")[1].split(",")[0] for said, _ in slips if " is one in " in said} == others


Own = Mapping[str, tuple[float, ...]]


def _of_both(task: Task, expected: Expected, own: Own, way: int = 0) -> tuple[tuple[float, ...], tuple[str, ...]]:
    return (sum(v for (v,) in own.values()) + 10,), tuple(own)


def _of_the_later(task: Task, expected: Expected, own: Own, way: int = 0) -> tuple[tuple[float, ...], tuple[str, ...]]:
    return (2 * own["b"][0] if "b" in own else 3 * own["a"][0],), tuple(own)


def test_own_values_that_change_nothing_are_not_named() -> None:
    """c rests on a and b, or once b is put in on b alone."""
    a, b, c = (replace(FORCE, find=f) for f in "abc")
    paper = Paper(0, (Task("p", "", "", (), (a, b, c), behind=(("c", ("a", "b")),)),))
    handed = Submission("s", 0, tuple(("p", find, f"{n} N") for find, n in (("a", 20), ("b", 30), ("c", 60))))
    worded = replace(handed, answers=(*handed.answers[:2], ("p", "c", "60 N down the slope")))
    third = grade(handed, {0: paper}, Rules(), _of_both).graded[2]
    assert (third.verdict, third.told, third.score) == ("wrong", "carried", 1.0)
    assert third.message == "this follows rightly from your a and your b, which are not right"
    told = grade(worded, {0: paper}, Rules(), _of_both).graded[2].message
    assert told == f"{third.message}; not read: 'down the slope'"
    alone = grade(handed, {0: paper}, Rules(), _of_the_later).graded[2]
    assert alone.message == "this follows rightly from your b, which is not right"


def test_who_is_not_in_the_list_and_names_no_variant_is_not_graded() -> None:
    papers = {k: Paper(k, (Task("p", "", "", (), (FORCE,)),)) for k in (0, 1, 2)}
    grader = MakeGrade(papers, Rules(), {"ann": 1}, {})()
    answers = (("p", "F", "12.74 N"),)
    strange = grader(Submission("zoe", 0, answers))
    assert strange.graded == ()
    assert strange.wrong == ("this student is not in the list of the set, and no variant is given: not graded",)
    assert grader(Submission("zoe", 2, answers)).score == 1
    assert grader(Submission("ann", 0, answers)).variant == 1


def test_a_name_is_that_of_the_list_whatever_its_capitals_and_a_strange_one_is_told() -> None:
    papers = {k: Paper(k, (Task("p", "", "", (), (FORCE,)),)) for k in (0, 1, 2)}
    answers = (("p", "F", "12.74 N"),)
    found = MakeGrade(papers, Rules(), {"jones": 1}, {})()(Submission("Jones", 2, answers))
    assert (found.student, found.variant) == ("jones", 1)
    assert "gives variant 1 to this student" in found.wrong[0]
    strange = MakeGrade(papers, Rules(), {"jones": 1}, {})()(Submission("zoe", 2, answers))
    assert strange.score == 1
    assert strange.wrong == ("this student is not in the list of the set; graded by the variant that is given",)
    # Where two names of the list differ by capitals alone each is itself.
    two = MakeGrade(papers, Rules(), {"Jo": 1, "jo": 2}, {})()
    assert [two(Submission(name, 0, answers)).variant for name in ("Jo", "jo")] == [1, 2]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("13 N", "this is rounded too far: give 3 significant figures"),
        ("10 N", "the value is not right"),
        ("12.9 N", "the value is not right"),
        ("14 N", "the value is not right"),
        ("36.3", "the value is not right; the unit is missing"),
    ],
)
def test_two_slips_are_both_told(text: str, said: str) -> None:
    one = graded(FORCE, text)
    assert (one.verdict, one.message) == ("wrong", said)


def test_a_student_counts_once_in_the_average() -> None:
    paper = Paper(0, (Task("p", "", "", (), (FORCE,)),))
    report = ClassReport()
    for student, source, text in (("ann", "b", "12.74 N"), ("ann", "a", "9 N"), ("bob", "c", "12.74 N")):
        report.add(grade(Submission(student, 0, (("p", "F", text),), source), {0: paper}, Rules()))
    report.add(grade(Submission("bob", 7, (), "d"), {0: paper}, Rules()))
    assert (report.submissions, report.students, report.mean) == (4, 2, 1.0)
    assert report.finds["p", "F"].answers == 3


def test_what_was_not_asked_is_told() -> None:
    paper = Paper(0, (Task("p", "", "", (), (FORCE,)),))
    result = grade(Submission("s", 0, (("p", "G", "1"), ("q", "F", "1"))), {0: paper}, Rules())
    assert result.wrong == ("there is no find 'G' in p", "there is no problem 'q'")
    assert grade(Submission("s", 4, ()), {0: paper}, Rules()).wrong == ("there is no variant 4",)


def test_what_could_not_be_read_is_ungradable_not_blank() -> None:
    paper = Paper(0, (Task("p", "", "", (), (FORCE, WORD)),))
    unread = Submission("s", 0, (), "s.yaml", ("s.yaml:1:4: the file is not UTF-8 text",))
    found = [(g.verdict, g.score, g.max_score, g.message) for g in grade(unread, {0: paper}, Rules()).graded]
    assert found == [("ungradable", 0.0, 1.0, "this cannot be graded: s.yaml:1:4: the file is not UTF-8 text")] * 2
    blank = grade(replace(unread, wrong=()), {0: paper}, Rules())
    assert [g.verdict for g in blank.graded] == ["missing", "missing"]


def test_feedback_gives_nothing_of_the_key_away() -> None:
    for text in ("13.5 N", "-12.74 N", "12.74 kg", "12.74", "hm"):
        assert "12.7" not in graded(FORCE, text).message


TWO = Paper(0, (Task("winch", "", "", (), (replace(FORCE, find="T_1"), replace(FORCE, find="N"))),))


@pytest.mark.parametrize(
    ("answers", "verdicts", "told"),
    [
        ((("winch", "T_1"), ("winch", "N")), ["right", "right"], ()),
        ((("Winch", "T1"), ("winch", "n")), ["right", "right"], ()),
        (
            (("winch", "T_1"), ("Winch", "t1")),
            ["right", "missing"],
            ("there is no problem 'Winch'; did you mean winch?",),
        ),
        ((("winch", "T_3"),), ["missing", "missing"], ("there is no find 'T_3' in winch; did you mean T_1?",)),
        ((("winch", "t1"), ("winch", "T1")), ["missing", "missing"], None),
    ],
)
def test_an_answer_is_known_by_its_name(
    answers: tuple[tuple[str, str], ...], verdicts: list[str], told: tuple[str, ...] | None
) -> None:
    found = grade(Submission("s", 0, tuple((*a, "12.74 N") for a in answers)), {0: TWO}, Rules())
    assert [g.verdict for g in found.graded] == verdicts
    assert told is None or found.wrong == told
    assert told is not None or len(found.wrong) == 2


def test_a_student_is_told_under_which_name_the_answer_stood() -> None:
    found = grade(Submission("s", 0, (("Winch", "T1", "12.74 N"),)), {0: TWO}, Rules())
    assert found.graded[0].message == "the answer stands under 'Winch.T1'"
