"""A set of eight problems with 300 submissions of known kind: every verdict as planted, mistakes named or ambiguous."""

from __future__ import annotations

from collections import Counter

import pytest
from conftest import ROOT
from homework_class import KINDS, class_of

from planar_cli.commands._handed_out import PAGES, PDF, page
from planar_cli.homework.grading.false_matches import false_matches
from planar_cli.homework.grading.grading_made import grading_of
from planar_cli.homework.homework import assembled, prepared
from planar_cli.homework.sets.paper import Submission
from planar_cli.homework.sets.ready import Homework
from planar_cli.homework.sets.set_file import HomeworkSet, read_set
from planar_cli.homework.sets.sheets import handed, key_csv, sheet_csv, sheet_data
from planar_cli.report.document.handed_out import key, sheet

SET = ROOT / "tests" / "homework" / "set.yaml"
NUMBER = 300
pytestmark = pytest.mark.xdist_group("homework")


@pytest.fixture(scope="module")
def homework_set() -> HomeworkSet:
    return read_set(str(SET))


@pytest.fixture(scope="module")
def homework(homework_set: HomeworkSet) -> Homework:
    made = [prepared(p, homework_set.variants, homework_set.seed) for p in homework_set.problems]
    return assembled(homework_set, made)


def test_every_verdict_is_as_planted(homework_set: HomeworkSet, homework: Homework) -> None:
    grade = grading_of(homework_set, homework)()
    found: Counter[str] = Counter()
    for student, variant, answers in class_of(homework.papers, NUMBER):
        handed = tuple((a.problem, a.find, a.text) for a in answers if a.text)
        result = grade(Submission(student, variant, handed))
        graded = {(g.problem, g.find): g for g in result.graded}
        for a in answers:
            one = graded[a.problem, a.find]
            assert one.verdict == a.verdict, (student, variant, a, one)
            found[a.kind] += 1
            if a.mistake and not one.carried:
                assert a.mistake in one.mistakes, (a, one)
                found["named" if len(one.mistakes) == 1 else "ambiguous"] += 1
    assert set(KINDS) <= set(found)
    # Ambiguous ones are two mistakes that come to the same number.
    assert found["named"] > 8 * found["ambiguous"]


def test_random_wrong_numbers_are_seldom_diagnosed(homework_set: HomeworkSet, homework: Homework) -> None:
    found = false_matches(homework.papers.values(), homework_set.rules, 40, 1)
    assert found.graded > 4000
    assert found.rate <= 0.02


def test_an_error_is_carried_forward(homework_set: HomeworkSet, homework: Homework) -> None:
    """α without the moment of inertia, and the friction that follows from it: m R α - P."""
    grade = grading_of(homework_set, homework)()
    alpha, friction = 100 * 0.75 / (50 * 0.45**2), 50 * 0.45 * 100 * 0.75 / (50 * 0.45**2) - 100
    answers = (("spool", "alpha", f"{alpha:.4g} rad/s^2 cw"), ("spool", "F", f"{friction:.4g} N"))
    result = grade(Submission("s", 0, answers))
    first, second = (g for g in result.graded if g.problem == "spool")
    assert first.mistakes == ("rotational-inertia-left-out",)
    assert (second.carried, second.score) == (("alpha",), 1.0)
    assert "your alpha" in second.message


def test_variants_differ_and_keep_their_physics(homework: Homework) -> None:
    for place in range(8):
        texts = {tuple(e.text for e in homework.papers[k].tasks[place].expected) for k in range(1, 7)}
        assert len(texts) > 3
        signs = {tuple(v > 0 for e in p.tasks[place].expected for v in e.values) for p in homework.papers.values()}
        assert len(signs) == 1


def test_the_same_seed_gives_the_same_key(homework_set: HomeworkSet, homework: Homework) -> None:
    problem = homework_set.problems[0]
    again = prepared(problem, homework_set.variants, homework_set.seed)
    assert again.tasks == tuple(homework.papers[k].tasks[0] for k in range(homework_set.variants + 1))
    other = prepared(problem, homework_set.variants, homework_set.seed + 1)
    assert other.tasks != again.tasks


def test_a_sheet_holds_nothing_of_the_key(homework: Homework) -> None:
    for k in (1, 2):
        expected = [e for t in homework.papers[k].tasks for e in t.expected]
        (one,) = handed(homework, [k])
        pages = [page(sheet(homework, one), "", form).decode() for form in PAGES if form != PDF]
        texts = (*pages, sheet_csv(homework, one), str(sheet_data(homework, one)))
        for text in texts:
            assert not [e.text for e in expected if e.text in text and len(e.text) > 8]
    assert all(e.text in key_csv(homework, [1]) for t in homework.papers[1].tasks for e in t.expected)


def test_html_is_one_page_without_scripts(homework: Homework) -> None:
    made = page(key(homework, [1], worked=False), "<script>alert(1)</script>", "html").decode()
    assert "<script" not in made
    assert "Content-Security-Policy" in made
    assert "<table>" in made
