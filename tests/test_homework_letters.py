"""Answers in letters in a homework: the key as a page tells it, any identical form, and what mistakes make of it."""

from __future__ import annotations

from pathlib import Path

import pytest
import sympy as sp

from planar_cli.commands._handed_out import page
from planar_cli.commands._told_formulas import told_formulas
from planar_cli.homework.grading.carried_errors import Carrier, unpickled
from planar_cli.homework.grading.grading import grade
from planar_cli.homework.homework import assembled, prepared
from planar_cli.homework.sets.paper import Graded, Submission
from planar_cli.homework.sets.ready import Homework
from planar_cli.homework.sets.rules import Rules
from planar_cli.homework.sets.set_file import read_set
from planar_cli.homework.sets.sheets import handed
from planar_cli.homework.submissions.submissions import contents, submissions
from planar_cli.homework.variants.wrong_formulas import as_written
from planar_cli.registry import members
from planar_cli.report.document.handed_out import sheet

SLOPE = """
title: Block that slides down, in letters
text: >-
  A block is let go on a slope of the angle beta on which it slides; the coefficient of friction is mu. Find its speed
  after the length L, and the normal force.
plane: vertical
symbols: {m: kg, beta: deg, mu: 1, L: m}
assume: [mu < tan(beta)]
points: {A: [0, 0]}
surfaces: {slope: {through: A, angle: -beta}}
bodies: {block: {particle: A, mass: m}}
joints:
  - contact: {between: [block, slope], at: A, mu: mu, name: C}
states:
  1: [at rest]
  2: [path_length(block) @ 1->2 = L]
find: {v: v(block).mag @ 2, N: N(C)}
"""
RIGHT = "sqrt(2*g*L*(sin(beta) - mu*cos(beta)))"


@pytest.fixture(scope="module")
def homework(tmp_path_factory: pytest.TempPathFactory) -> Homework:
    folder = tmp_path_factory.mktemp("letters")
    path = folder / "set.yaml"
    (folder / "letters.yaml").write_text(SLOPE)
    path.write_text("problems: [letters.yaml]\n")
    homework_set = read_set(str(path))
    return assembled(homework_set, [prepared(p, 0, 1, told_formulas) for p in homework_set.problems])


def graded(homework: Homework, find: str, typed: str) -> Graded:
    submission = Submission("ann", 0, (("letters", find, typed),))
    result = grade(submission, homework.papers, Rules())
    return next(g for g in result.graded if g.find == find)


@pytest.mark.parametrize("typed", [RIGHT, "sqrt(2)*sqrt(L*g*sin(beta) - g*L*mu*cos(beta))"])
def test_a_size_in_letters_is_right_in_any_form(homework: Homework, typed: str) -> None:
    one = graded(homework, "v", typed)
    assert one.verdict == "right"
    assert one.expected == "√(2 g L (sin β - μ cos β))"


@pytest.mark.parametrize(
    ("find", "typed", "mistake", "said"),
    [
        ("v", "sqrt(2*g*L*sin(beta))", "friction-left-out", "without friction"),
        ("v", "sqrt(2*g*L*(sin(beta) + mu*cos(beta)))", "friction-reversed", "the other way"),
        ("v", "sqrt(2*g*L*(cos(beta) - mu*sin(beta)))", "sine-for-cosine", "sine and cosine of β"),
        ("N", "m*g*sin(beta)", "sine-for-cosine", "sine and cosine of β"),
        ("N", "m*cos(beta)", "mass-for-weight", "the mass stands where the weight"),
    ],
)
def test_a_mistake_in_letters_is_named(homework: Homework, find: str, typed: str, mistake: str, said: str) -> None:
    one = graded(homework, find, typed)
    assert (one.verdict, one.mistakes) == ("wrong", (mistake,))
    assert said in one.feedback


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        ("sqrt(3*g*L*sin(beta))", "mu should stand in it"),
        ("sqrt(m*g*L*(sin(beta) - mu*cos(beta)))", "and asked is a velocity (m/s)"),
        ("sqrt(g*L)*sin(beta) + g", "its terms do not have the same dimension"),
        ("sqrt(g*L*(sin(beta) - mu*cos(beta)))", "stand as they should, but not the number before them"),
        ("-sqrt(2*g*L*(sin(beta) - mu*cos(beta)))", "the sign or sense is not right"),
        ("sqrt(2*g*L*(sin(beta)/2 - mu*cos(beta)^2))", "the formula is not right"),
    ],
)
def test_of_another_wrong_formula_it_is_said_what_can_be_seen(homework: Homework, typed: str, said: str) -> None:
    one = graded(homework, "v", typed)
    assert (one.verdict, one.mistakes, one.feedback) == ("wrong", (), "")
    assert said in one.message


HAMMER = """
title: Ball that strikes a block
plane: vertical
symbols: {m: kg, v0: m/s}
given:
  n: {one_of: [1, 2]}
  e: {one_of: [0.5, 0.4]}
points: {P: [0, 0], Q: [1 m, 0]}
bodies:
  ball: {particle: P, mass: m}
  block: {particle: Q, mass: n*m}
joints:
  - guide: {point: P, along: 0 deg}
  - guide: {point: Q, along: 0 deg}
  - impact: {between: [ball, block], normal: 0 deg, restitution: e, during: 2->3}
states:
  1: [v(ball).x = v0, v(block).x = 0]
  2: [x(P) = x(Q)]
  3: [just after 2]
find: {v: v(block).x @ 3}
"""


@pytest.fixture(scope="module")
def blow(tmp_path_factory: pytest.TempPathFactory) -> Homework:
    folder = tmp_path_factory.mktemp("blow")
    path = folder / "set.yaml"
    (folder / "letters.yaml").write_text(HAMMER)
    path.write_text("problems: [letters.yaml]\nvariants: {number: 4, seed: 1}\n")
    homework_set = read_set(str(path))
    return assembled(homework_set, [prepared(p, 4, 1, told_formulas) for p in homework_set.problems])


def test_given_numbers_may_stand_for_their_letters(blow: Homework) -> None:
    for variant in range(1, 5):
        (task,) = blow.papers[variant].tasks
        known = dict(task.expected[0].known)
        factor = (1 + known["e"]) / (1 + known["n"])
        for typed in (
            "(1 + e)*v0/(1 + n)",
            f"(1 + e)*v0/{1 + known['n']:g}",
            f"{factor:.12g}*v0",
            f"{factor:.3f}*m*v0/m",
        ):
            result = grade(Submission("ann", variant, (("letters", "v", typed),)), blow.papers, Rules())
            assert result.graded[0].verdict == "right", typed
        for typed in (f"{factor * 1.02:.5g}*v0", f"{factor * 1.001 + 0.1:.12g}*v0", "(1 - e)*v0/(1 + n)"):
            result = grade(Submission("ann", variant, (("letters", "v", typed),)), blow.papers, Rules())
            assert result.graded[0].verdict == "wrong", typed


def test_the_key_of_a_variant_has_its_numbers_put_in(blow: Homework) -> None:
    texts = {blow.papers[k].tasks[0].expected[0].text for k in range(1, 5)}
    assert len(texts) == 4
    letters, numbers = zip(*(text.split(" = ") for text in texts), strict=True)
    assert len(set(letters)) == 1
    assert all("e" not in text and "n" not in text for text in numbers)


def test_it_is_said_that_there_are_no_more_combinations(tmp_path: Path) -> None:
    (tmp_path / "letters.yaml").write_text(HAMMER)
    (tmp_path / "set.yaml").write_text("problems: [letters.yaml]\n")
    (problem,) = read_set(str(tmp_path / "set.yaml")).problems
    ready = prepared(problem, 5, 1)
    expected = "letters: there are only 4 combinations of values, for 5 variants; they are given out again"
    assert expected in ready.warnings
    assert ready.values[1] == ready.values[5]


def test_a_sheet_is_a_form_to_be_filled_in(blow: Homework, tmp_path: Path) -> None:
    (one, *_) = handed(blow, [1])
    told = page(sheet(blow, one), "", "markdown").decode()
    form = told.partition("```text\n")[2].partition("```")[0]
    assert "  letters.v:  # 2/7*m*sqrt(v0)\n" in form
    (tmp_path / "ann.yaml").write_text(form)
    (handed_in,) = submissions(contents(str(tmp_path / "ann.yaml")))
    assert not any(text.strip() for *_, text in handed_in.answers)
    (tmp_path / "ann.yaml").write_text(form.replace("letters.v:", "letters.v: 3*v0"))
    (handed_in,) = submissions(contents(str(tmp_path / "ann.yaml")))
    assert handed_in.answers == (("letters", "v", "3*v0"),)


SLIDE = """
title: Crate
text: A crate of mass {n}m slides down.
plane: vertical
given: {n: 1, beta: 30 deg}
points: {A: [0, 0], B: {from: A, distance: 2 m, angle: -beta}}
surfaces: {slope: {through: A, angle: -beta}}
bodies: {crate: {particle: A, mass: n * 3 kg}}
joints:
  - contact: {between: [crate, slope], at: A, mu: 0}
states:
  1: [at rest]
  2: [path_length(crate) @ 1->2 = 2 m]
find:
  a: a(crate).along(-beta) @ 1
  v: v(crate).along(-30 deg) @ 2
  K: KE(crate) @ 2 - KE(crate) @ 1
"""


def test_a_sheet_tells_g_directions_and_energies(tmp_path: Path) -> None:
    (tmp_path / "crate.yaml").write_text(SLIDE)
    (tmp_path / "set.yaml").write_text("problems: [crate.yaml]\n")
    (problem,) = read_set(str(tmp_path / "set.yaml")).problems
    task = prepared(problem, 0, 1).tasks[0]
    assert "g = 9.81 m/s²" in task.given
    assert task.text == "A crate of mass m slides down."
    assert [e.asked for e in task.expected][1:] == [
        "component of the velocity of crate along the direction -30° in state 2",
        "K",
    ]
    assert task.expected[2].unit == "J"
    assert task.expected[2].text.endswith(" J")


PENDULUM = """
title: Rod that falls
plane: vertical
symbols: {m: kg, l: m}
given: {n: 2}
points: {A: [0, l], B: [-l, l]}
bodies: {rod: {rod: [A, B], mass: n*m}}
joints:
  - pin: {at: A, between: [ground, rod]}
states:
  1: [at rest]
  2: [y(B) = 0]
find: {omega: omega(rod) @ 2, A_y: reaction(A).y @ 2, K: KE(rod) @ 2}
"""


@pytest.fixture(scope="module")
def pendulum(tmp_path_factory: pytest.TempPathFactory) -> Homework:
    folder = tmp_path_factory.mktemp("pendulum")
    path = folder / "set.yaml"
    (folder / "letters.yaml").write_text(PENDULUM)
    path.write_text("problems: [letters.yaml]\n")
    homework_set = read_set(str(path))
    return assembled(homework_set, [prepared(p, 0, 1, told_formulas) for p in homework_set.problems])


@pytest.mark.parametrize(
    ("find", "typed", "mistake"),
    [
        ("A_y", "n*m*g", "centripetal-left-out"),
        ("A_y", "2*m*g", "centripetal-left-out"),
        ("omega", "sqrt(12*g/l)", "parallel-axis-left-out"),
        ("omega", "3.4641*sqrt(g/l)", "parallel-axis-left-out"),
    ],
)
def test_a_mistake_on_the_way_to_a_formula_is_named(pendulum: Homework, find: str, typed: str, mistake: str) -> None:
    assert graded(pendulum, find, typed).mistakes == (mistake,)


def test_what_follows_from_an_own_formula_is_carried(pendulum: Homework) -> None:
    answers = (("omega", "sqrt(6*g/l)"), ("A_y", "8*m*g"), ("K", "2*l*m*g"))
    submission = Submission("ann", 0, tuple(("letters", *a) for a in answers))
    carry = Carrier(unpickled(pendulum.carrying)).for_variant(0)
    found = grade(submission, pendulum.papers, Rules(), carry).graded
    assert [g.carried for g in found] == [(), ("omega",), ("omega",)]
    assert found[1].message == "this follows rightly from your omega, which is not right"


def test_formulas_are_written_by_the_functions_of_a_file() -> None:
    x, y = sp.symbols("x y", real=True)
    assert as_written(sp.Abs(sp.sqrt(x + y))) == "sqrt(x + y)"
    assert as_written(y + sp.Abs(x)) == "y + abs(x)"
    assert as_written(sp.atan2(y, x)) == "2*atan(y/(x + sqrt(x^2 + y^2)))"
    assert as_written(sp.sinh(x)) == "(exp(x) - exp(-x))/2"


@pytest.mark.parametrize("name", members("homework.mistakes"))
def test_the_page_of_a_mistake_says_what_it_changes(name: str) -> None:
    told = (members("homework.mistakes")[name].__doc__ or "").partition("\n\n    In the equations\n")[2]
    assert len(told.split()) > 3
