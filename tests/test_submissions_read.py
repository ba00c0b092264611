"""Submissions: every form in which answers are handed in, and what is told of those that are not right."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from planar_cli.errors import PlanarError
from planar_cli.homework.sets.paper import Submission
from planar_cli.homework.submissions.submissions import contents, passed_over, submission_files, submissions
from planar_cli.homework.submissions.submitted import with_unit


def read(folder: Path, name: str, text: str | bytes) -> tuple[Submission, ...]:
    """The submissions of a file with this text; their `wrong` without the folder."""
    path = folder / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    found = submissions(contents(str(path)))
    assert all(s.source == str(path) for s in found)
    return found


def wrong(submission: Submission) -> list[str]:
    """What is told, without the folder."""
    return [told.replace(f"{Path(submission.source).parent}/", "") for told in submission.wrong]


def one(folder: Path, name: str, text: str | bytes) -> Submission:
    (found,) = read(folder, name, text)
    return found


SAME = (("incline", "a", "3.20 m/s^2"), ("incline", "N", "12 N"))


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("s1.yaml", "variant: 3\nanswers:\n  incline: {a: 3.20 m/s^2, N: 12 N}\n"),
        ("s1.yml", "variant: 3\nanswers:\n  incline.a: 3.20 m/s^2\n  incline.N: {value: 12, unit: N}\n"),
        ("x.yaml", "student: s1\nvariant: 3\nanswers:\n  incline:\n    a: '3.20 m/s^2'\n    N: 12 N\n"),
        ("s1.json", '{"variant": 3, "answers": {"incline": {"a": "3.20 m/s^2", "N": "12 N"}}}'),
        (
            "x.json",
            '{"student": "s1", "variant": "3",\n "answers": {"incline.a": {"value": 3.20, "unit": "m/s^2"},'
            '"incline.N": "12 N"}}',
        ),
        ("s1.csv", "problem,find,answer,variant\nincline,a,3.20 m/s^2,3\nincline,N,12 N,3\n"),
        ("s1.CSV", "\ufeffProblem;Find;Answer;Unit;Variant\r\nincline;a;3.20;m/s^2;3\r\nincline;N;12 N;;3\r\n"),
        ("c.csv", "student,problem,find,answer,unit,variant\ns1,incline,a,3.20,m/s^2,3\ns1,incline,N,12,N,3\n"),
        ("c.csv", "student,name,variant,incline.a,incline.N\ns1,Miller,3,3.20 m/s^2,12 N\n"),
        ("c.csv", "sep=;\nstudent;variant;incline.a;incline.N\ns1;3;3.20 m/s^2;12\u00a0N\n"),
        ("c.csv", "student\tvariant\tincline.a\tincline.N\n\ns1\t3\t3.20 m/s^2\t12 N"),
    ],
)
def test_one_submission_in_every_form(tmp_path: Path, name: str, text: str) -> None:
    found = one(tmp_path, name, text)
    assert (found.student, found.variant, found.answers, found.wrong) == ("s1", 3, SAME, ())


@pytest.mark.parametrize(
    ("answer", "typed"),
    [
        ("1e-3", "1e-3"),
        ("007.50", "007.50"),
        ("yes", "yes"),
        ("12:30", "12:30"),
        ("3,2", "3,2"),
        ("{value: -1.50, unit: kN}", "-1.50 kN"),
        ("{value: [1, -2], unit: N}", "[1, -2] N"),
        ("{x: 3, y: -4, unit: m/s}", "[3, -4] m/s"),
        ("{x: 3 m/s, y: 0}", "[3 m/s, 0]"),
        ("[1 N, 2 N]", "[1 N, 2 N]"),
        ("[1, 2, 3]", "[1, 2, 3]"),
        ("{magnitude: 10, unit: N, angle: 30 deg}", "10 N at 30 deg"),
        ("__import__('os').system('touch x')", "__import__('os').system('touch x')"),
        ("1e999", "1e999"),
    ],
)
def test_an_answer_is_one_text_as_typed(tmp_path: Path, answer: str, typed: str) -> None:
    # In a flow mapping a comma would end the answer.
    assert one(tmp_path, "s.yaml", f"answers:\n  p:\n    a: {answer}\n").answers == (("p", "a", typed),)


@pytest.mark.parametrize(
    ("answer", "unit", "typed"),
    [
        ("3.2", "m/s^2", "3.2 m/s^2"),
        ("3.2 kN", "N", "3.2 kN"),
        ("3.2 N", "N", "3.2 N"),
        ("6.2 cw", "rad/s", "6.2 rad/s cw"),
        ("6.2 to the left", "m/s", "6.2 m/s to the left"),
        ("10 at 30 deg", "N", "10 N at 30 deg"),
        ("[3, -4]", "m/s", "[3, -4] m/s"),
        ("[3 m/s, -4 m/s]", "m/s", "[3 m/s, -4 m/s]"),
        ("1.2*10^3", "N", "1.2*10^3 N"),
        ("1.2e3", "N", "1.2e3 N"),
        ("5*sqrt(2)", "N", "5*sqrt(2) N"),
        ("30°", "deg", "30°"),
        ("0.25", "1", "0.25"),
        ("yes", "1", "yes"),
        ("yes", "N", "yes"),
        ("m*g*sin(beta)", "N", "m*g*sin(beta)"),
        ("2*m*g", "N", "2*m*g"),
        ("3.2", "", "3.2"),
    ],
)
def test_a_unit_beside_an_answer(answer: str, unit: str, typed: str) -> None:
    assert with_unit(answer, unit) == typed


@pytest.mark.parametrize("answer", ["1.50", "-2", "1e-3", "1E999", "123456789012345678901234567890"])
def test_numbers_of_json_stay_as_typed(tmp_path: Path, answer: str) -> None:
    assert one(tmp_path, "s.json", f'{{"answers": {{"p": {{"a": {answer}}}}}}}').answers == (("p", "a", answer),)


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("s.yaml", "answers:\n  p: {a: , b: 1 N, c: ~, d: ''}\n  q:\n"),
        ("s.json", '{"answers": {"p": {"a": null, "b": "1 N", "c": ""}, "q": null}}'),
        ("s.csv", "problem,find,answer,unit\np,a,,N\np,b,1 N,\n"),
        ("c.csv", "student,p.a,p.b,p.c\ns,,1 N,\n"),
    ],
)
def test_what_is_left_blank_is_no_answer(tmp_path: Path, name: str, text: str) -> None:
    found = one(tmp_path, name, text)
    assert (found.answers, found.wrong) == ((("p", "b", "1 N"),), ())


@pytest.mark.parametrize(
    ("name", "text", "told", "answers"),
    [
        (
            "s.yaml",
            "answers: {p: {a: 1}}\nsolve: x\n",
            ["s.yaml:2:1: `solve` is not read; a submission has answers, student, variant"],
            1,
        ),
        ("s.yaml", "student: s\n", ["s.yaml:1:1: there are no `answers`; write `answers:` and below it what…"], 0),
        ("s.yaml", "- a\n", ["s.yaml:1:1: there are no `answers`; write `answers:` and below it what you…"], 0),
        ("s.yaml", "", ["s.yaml:1:1: the file is empty; begin with `answers:`"], 0),
        ("s.yaml", "answers: {p: {a: 1, a: 2}}\n", ["s.yaml:1:21: `a` stands here a second time; the first is…"], 0),
        (
            "s.yaml",
            "answers: {p: {a: 1, b: 2}, p.a: 3}\n",
            ["s.yaml:1:33: `p.a` is answered a second time; the first is in line 1; neither is graded"],
            1,
        ),
        ("s.yaml", "variant: two\nanswers: {p: {a: 1}}\n", ["s.yaml:1:10: `two` is no number of a variant; write…"], 0),
        (
            "s.yaml",
            "variant: [2]\nanswers: {p: {a: 1}}\n",
            ["s.yaml:1:10: `variant` is one word; write `variant: …`"],
            0,
        ),
        (
            "s.yaml",
            "answers: {p: 3 N, q: {a: 1}}\n",
            ["s.yaml:1:11: `p` does not say what it answers; write `p: {find: answer}` or `p.find: answer`"],
            1,
        ),
        ("s.yaml", "answers: [1, 2]\n", ["s.yaml:1:10: answers stand by name; write…"], 0),
        (
            "s.yaml",
            "answers: {p: {a: {b: 1}, c: 1}}\n",
            ["s.yaml:1:18: `p.a` is no answer that can be read; write…"],
            1,
        ),
        ("s.json", '{"answers": {"p": {"a": 1, "a": 2}}}', ["s.json: the key `a` stands twice"], 0),
        ("s.json", '{"answers": {"p": {"a": NaN}}}', ["s.json: NaN is no number"], 0),
        ("s.json", '{"answers": {"p": {"a": 1},}}', ["s.json:1:28: no JSON: Expecting property name enclosed in…"], 0),
        ("s.csv", "problem,find,answer,mark\np,a,1,10\n", ["s.csv:1:1: the column `mark` is not read"], 1),
        ("s.csv", "find,answer\na,1\n", ["s.csv:1:1: the columns are not known; the first line is…"], 0),
        (
            "s.csv",
            "problem,find,answer\np,a,3,2\np,b,1\n",
            ["s.csv:2:1: the line has 4 cells, the first one 3: put…"],
            1,
        ),
        (
            "s.csv",
            'problem,find,answer\np,a,"3\np,b,1\n',
            ["s.csv:2:1: a quote is not closed, or text follows it;…"],
            1,
        ),
        ("s.csv", "problem,find,answer\n,a,3\np,b,1\n", ["s.csv:2:1: the line does not say what it answers"], 1),
        ("s.csv", "problem,find,find\n", ["s.csv:1:1: there are two columns `find`"], 0),
        ("s.csv", "\n", ["s.csv:1:1: the file is empty; the first line is…"], 0),
        ("s.txt", "x", ["s.txt: the name of a submission ends in .yaml, .yml, .json, .csv"], 0),
        ("s.yaml", b"a: \xff", ["s.yaml:1:4: the file is not UTF-8 text; save it with the encoding UTF-8"], 0),
    ],
)
def test_what_is_wrong_is_told_in_its_place(
    tmp_path: Path, name: str, text: str | bytes, told: list[str], answers: int
) -> None:
    found = one(tmp_path, name, text)
    assert len(wrong(found)) == len(told)
    assert all(w.startswith(t.removesuffix("…")) for w, t in zip(wrong(found), told, strict=True)), wrong(found)
    assert (found.student, len(found.answers)) == ("s", answers)


@pytest.mark.parametrize(
    ("line", "text"),
    [
        ("p.b: [1.61, -0.579] m/s", "[1.61, -0.579] m/s"),
        ("p.b: {1.61, -0.579} m/s   # of G", "{1.61, -0.579} m/s"),
        ("p.b: [1.61, -0.579 m/s", "[1.61, -0.579 m/s"),
        ("p.b: x: 3, y: 4", "x: 3, y: 4"),
        ("p.b: - 15.8 m/s", "- 15.8 m/s"),
        ("p.b: @5 N", "@5 N"),
        ("p.b: '5 N", "'5 N"),
        ("p.b: *m", "*m"),
        ("p.b: %5", "%5"),
    ],
)
def test_a_line_that_is_no_yaml_is_one_text_and_costs_no_other(tmp_path: Path, line: str, text: str) -> None:
    found = one(tmp_path, "f.yaml", f"student: s1\nvariant: 2\nanswers:\n  p.a: 1 N\n  {line}\n  p.c: [3, 4]\n")
    assert (found.student, found.variant, found.wrong) == ("s1", 2, ())
    assert found.answers == (("p", "a", "1 N"), ("p", "b", text), ("p", "c", "[3, 4]"))


@pytest.mark.parametrize("line", ["p.b 5 N", "\x01", "}"])
def test_a_line_that_says_nothing_is_told_and_left_out(tmp_path: Path, line: str) -> None:
    found = one(tmp_path, "f.yaml", f"student: s1\nanswers:\n  p.a: 1 N\n  {line}\n  p.c: 2 N\n")
    assert found.student == "s1"
    assert {a for _, a, _ in found.answers} == {"a", "c"}
    assert len(found.wrong) == 1
    assert "f.yaml:4:" in found.wrong[0]


def test_what_is_answered_twice_costs_nothing_else(tmp_path: Path) -> None:
    found = one(tmp_path, "f.yaml", "answers:\n  p.a: 1 N\n  p.b: 2 N\n  p.a: 3 N\n")
    assert found.answers == (("p", "b", "2 N"),)
    assert wrong(found) == ["f.yaml:4:3: `p.a` stands here a second time; the first is in line 2; neither is graded"]


def test_a_line_that_is_too_long_costs_no_other(tmp_path: Path) -> None:
    long = "(" * 11_000
    found = one(tmp_path, "f.yaml", f"student: s1\nvariant: 3\nanswers:\n  p.a: {long}\n  p.b: 2 N\n")
    assert (found.student, found.variant, found.answers) == ("s1", 3, (("p", "b", "2 N"),))
    (told,) = wrong(found)
    assert told.startswith("f.yaml:4:1: this line has more than 10000 characters")


def test_the_variant_of_a_file_that_cannot_be_read(tmp_path: Path) -> None:
    assert one(tmp_path, "f.yaml", "student: s1\nvariant: 3\nanswers: {}\n---\n[\n").variant == 3


@pytest.mark.parametrize(("sign", "word"), [(";", "a semicolon"), (",", "a comma"), ("\t", "a tab")])
def test_a_vector_without_quotes_is_one_cell(tmp_path: Path, sign: str, word: str) -> None:
    head = sign.join(("student", "p.v", "p.b"))
    rows = [sign.join(cells) for cells in (("s1", "[3", "-4] m/s", "2 N"), ("s2", "[3, 4] m/s", "1", "5 N"))]
    good, bad = read(tmp_path, "c.csv", "\n".join((head, *rows[:1]))), read(tmp_path, "d.csv", "\n".join((head, *rows)))
    assert good[0].answers == (("p", "v", f"[3{sign.strip() or ','} -4] m/s"), ("p", "b", "2 N"))
    assert f"put what has {word} in quotes" in bad[-1].wrong[0]


def test_whose_a_file_is_that_cannot_be_read(tmp_path: Path) -> None:
    found = one(tmp_path, "f.yaml", "student: s1\nanswers: {}\n---\n[\n")
    assert (found.student, found.answers) == ("s1", ())
    assert found.wrong


def test_a_bad_line_of_a_class_costs_nobody_else(tmp_path: Path) -> None:
    lines = [
        "student,problem,find,answer,variant",
        "s1,p,a,1 N,2",
        's2,p,a,"2 N',
        "s3,p,a,3 N,x",
        ",p,a,4 N,",
        "s1,p,a,5 N,2",
    ]
    lines += ["s5,p,a,\x00,", "s6,p,a,\u202e6 N,", "s7,p,a,'-7 N,"]
    found = read(tmp_path, "c.csv", "\n".join(lines))
    told = {s.student: (s.variant, len(s.answers), len(s.wrong)) for s in found}
    assert told == {
        "s1": (2, 0, 1),
        "s2": (0, 0, 1),
        "s3": (0, 0, 1),
        "": (0, 1, 1),
        "s5": (0, 0, 1),
        "s6": (0, 0, 1),
        "s7": (0, 1, 0),
    }
    assert found[-1].answers == (("p", "a", "-7 N"),)
    by_name = {s.student: wrong(s) for s in found}
    assert by_name["s6"] == ["c.csv:8:8: the answer to `p.a` has a hidden character; type it anew"]


def test_a_student_twice_in_a_wide_table_is_two_submissions(tmp_path: Path) -> None:
    found = read(tmp_path, "c.csv", "student,p.a\ns1,1 N\ns1,2 N\n")
    assert [(s.student, s.answers) for s in found] == [("s1", (("p", "a", "1 N"),)), ("s1", (("p", "a", "2 N"),))]


def test_a_table_without_students(tmp_path: Path) -> None:
    (found,) = read(tmp_path, "c.csv", "student,p.a\n")
    assert wrong(found) == ["c.csv:1:1: there is no line below the first"]


def test_folders_in_order(tmp_path: Path) -> None:
    for name in ("b.yaml", "a/z.json", "a/b/x.csv", "note.txt", ".hidden.yaml", "c.yaml/d.yml"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("answers: {}\n")
    (tmp_path / "link.yaml").symlink_to(tmp_path / "b.yaml")
    (tmp_path / "away").symlink_to(tmp_path / "a")
    found = [str(Path(f).relative_to(tmp_path)) for f in submission_files([str(tmp_path)])]
    assert found == ["a/b/x.csv", "a/z.json", "b.yaml", "c.yaml/d.yml", "link.yaml"]


def test_what_is_no_submission_is_told(tmp_path: Path) -> None:
    (tmp_path / "more").mkdir()
    for name in ("a.yaml", "scan.pdf", ".hidden.txt", "more/b.txt"):
        (tmp_path / name).write_text("")
    told = passed_over([str(tmp_path), str(tmp_path / "scan.pdf")])
    assert told.endswith(f".csv: {tmp_path}/more/b.txt, {tmp_path}/scan.pdf")
    (tmp_path / "clean").mkdir()
    assert passed_over([str(tmp_path / "clean"), str(tmp_path / "none")]) == ""


def test_names_that_are_not_there(tmp_path: Path) -> None:
    with pytest.raises(PlanarError, match="there is no file or folder"):
        list(submission_files([str(tmp_path / "x.yaml")]))
    with pytest.raises(PlanarError, match="has no submissions"):
        list(submission_files([str(tmp_path)]))


def test_reading_needs_no_solver() -> None:
    loaded = "[m for m in ('sympy', 'numpy', 'mpmath') if m in sys.modules]"
    code = f"import sys, planar_cli.homework.submissions.grader; print({loaded})"
    assert subprocess.check_output([sys.executable, "-c", code], text=True) == "[]\n"
