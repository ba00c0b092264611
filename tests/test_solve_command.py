"""`planar solve` and `planar key`: formats, options, exit statuses, and files that appear whole or not at all."""

from __future__ import annotations

import json
import os
import re
import resource
import signal
import subprocess
import sys
from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import pytest
from answered import HELD_ROD
from conftest import ROOT

from planar_cli import cli
from planar_cli.commands import _limit
from planar_cli.errors import NOWHERE, Diagnostic, NoSolution, Undecided

GOOD = HELD_ROD + "find: {alpha: alpha(rod), pin: reaction(O/rod).y, force: reaction(O/rod)}\n"
ANSWERED = GOOD + "answers: {alpha: 4.905 rad/s^2 cw, pin: 4.905 N, force: [0, 4.905 N]}\n"
WRONG = GOOD + "answers: {alpha: 4.8 rad/s^2 cw, pin: 4.905 N}\n"
LETTERS = GOOD.replace("given: {m: 2 kg, l: 3 m}", "symbols: {m: kg, l: m}")
BAD = "title: Bad\nfind: {x: x(A)}\n"


@dataclass(frozen=True, slots=True)
class Ran:
    status: int
    out: str
    err: str

    @property
    def data(self) -> Any:
        return json.loads(self.out)


@pytest.fixture
def run(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Any:
    """Runs planar in a folder with the files above; each argument is split."""
    texts = {"good": GOOD, "answered": ANSWERED, "wrong": WRONG, "letters": LETTERS, "bad": BAD}
    for name, text in texts.items():
        (tmp_path / f"{name}.yaml").write_text(text)

    def go(line: str | list[str]) -> Ran:
        args = [
            str(tmp_path / a) if a.endswith((".yaml", ".md", ".json")) else a
            for a in (line.split() if isinstance(line, str) else line)
        ]
        status = cli.run(args)
        captured = capsys.readouterr()
        return Ran(status, captured.out, captured.err)

    return go


# --- what is printed -------------------------------------------------------------------------------------------------


def test_a_solution_in_the_terminal(run: Any) -> None:
    ran = run("solve answered.yaml")
    assert ran.status == 0
    assert ran.err == ""
    assert ran.out.startswith("Rod let go\n")
    assert "STEP 1" in ran.out
    assert "4.905 rad/s² clockwise" in ran.out
    assert "Disagrees" not in ran.out
    assert "\x1b" not in ran.out


def test_markdown(run: Any) -> None:
    ran = run("solve good.yaml --format markdown")
    assert ran.status == 0
    assert ran.out.startswith("# Rod let go\n")
    assert "$" in ran.out


def test_markdown_in_a_file_has_its_figures_beside_it(run: Any, tmp_path: Path) -> None:
    """The same each time; what an earlier page had more is gone, what is of another hand stays."""
    called = ["solve", "good.yaml", "--format", "markdown", "-o", "my page (1).md"]
    assert run(called).status == 0
    folder = tmp_path / "my page (1)-figures"
    before = {p.name: p.read_bytes() for p in folder.iterdir()}
    page = (tmp_path / "my page (1).md").read_text(encoding="utf-8")
    found = re.findall(r"!\[([^\]]+)\]\(([^() ]+)\)", page)
    assert [unquote(link) for _, link in found] == [f"{folder.name}/{i}.svg" for i in range(1, len(before) + 1)]
    assert found[0][0] == "Rod let go"
    assert all(drawn.startswith(b"<svg") for drawn in before.values())
    last = len(before)
    (folder / f"{last + 1}.svg").write_bytes(before["1.svg"])
    (folder / f"{last + 2}.svg").write_text("precious")
    assert run(called).status == 0
    kept = {p.name: p.read_bytes() for p in folder.iterdir()}
    assert kept.pop(f"{last + 2}.svg") == b"precious"
    assert kept == before


def test_pages_with_figures(run: Any, tmp_path: Path) -> None:
    """Two files are one page of HTML, or one PDF."""
    assert run(f"solve good.yaml letters.yaml --format html -o {tmp_path}/out.html").status == 0
    page = (tmp_path / "out.html").read_text(encoding="utf-8")
    assert page.count("<html") == 1
    assert page.count("<h1 ") == 2
    assert page.count("<details") == page.count("</details>") > 2
    assert page.count("<svg") > 1
    assert run(f"solve good.yaml letters.yaml --format pdf -o {tmp_path}/out.pdf").status == 0
    assert (tmp_path / "out.pdf").read_bytes().startswith(b"%PDF")


def test_json(run: Any) -> None:
    data = run("solve answered.yaml --format json").data
    assert data["schema_version"] == 1
    assert data["problem"] == "Rod let go"
    assert data["outcome"] == "solved"
    assert data["answers"]["alpha"]["value"] == pytest.approx(-4.905)
    assert data["answers"]["alpha"]["unit"] == "rad/s^2"
    assert "clockwise" in data["answers"]["alpha"]["text"]
    assert data["answers"]["force"]["value"] == pytest.approx([0, 4.905])
    assert set(data["plan"]) == {"method", "equations", "largest_block", "tear"}
    equations = [s for s in data["steps"] if s["kind"] == "equation"]
    assert len(equations) == data["plan"]["equations"]
    assert all(s["left"] and s["right"] and s["number"] and s["law"] for s in equations)
    assert data["seconds"]["solve"] > 0
    assert "weight" in data["effects"]["present"]


def test_json_with_letters(run: Any) -> None:
    answers = run("solve letters.yaml --format json").data["answers"]
    assert answers["alpha"]["value"] is None
    assert answers["alpha"]["expression"] == "-3*g/(2*l)"
    assert answers["force"]["expression"] == ["0", "g*m/4"]


def test_figures(run: Any) -> None:
    assert "4.9 rad/s²" in run("solve good.yaml --figures 2").out
    exact = Decimal("9.81") * 3 / 14
    assert f"{exact:.18f} rad/s²" in solve_text(GOOD.replace("l: 3 m", "l: 7 m"), "--digits", "19")


def solve_text(text: str, *options: str) -> str:
    """What a fresh process prints for a file on standard input."""
    command = [sys.executable, "-m", "planar_cli", "solve", "-", *options]
    run = subprocess.run(command, input=text, capture_output=True, text=True, check=False, cwd=ROOT)
    assert run.returncode == 0, run.stderr
    return run.stdout


def test_standard_input_and_the_same_words_whatever_the_hash_seed() -> None:
    first, second = (
        subprocess.run(
            [sys.executable, "-m", "planar_cli", "solve", "-"],
            input=ANSWERED,
            capture_output=True,
            text=True,
            check=True,
            cwd=ROOT,
            env={**os.environ, "PYTHONHASHSEED": seed},
        ).stdout
        for seed in ("1", "2")
    )
    assert first == second
    assert first.startswith("Rod let go\n")


# --- several files, statuses -----------------------------------------------------------------------------------------


def test_a_wrong_answer_is_noted(run: Any) -> None:
    ran = run("solve wrong.yaml")
    assert ran.status == 1
    assert "Disagrees" in ran.out
    assert "the file states -4.8 rad/s^2, the solution gives -4.905 rad/s^2" in " ".join(ran.out.split())
    stated = run("solve wrong.yaml --format json").data["stated"]
    assert [s["agrees"] for s in stated] == [False, True]


def test_one_bad_file_does_not_stop_the_others(run: Any) -> None:
    ran = run("solve bad.yaml good.yaml")
    assert ran.status == 2
    assert "bad.yaml:2:" in ran.err
    assert ran.out.startswith("Rod let go\n")
    data = run("solve bad.yaml good.yaml --format json").data
    assert [s["outcome"] for s in data["solutions"]] == ["bad file", "solved"]
    assert data["solutions"][0]["diagnostics"][0]["line"] == 2


@pytest.mark.parametrize(
    ("error", "status", "outcome"),
    [
        (NoSolution([Diagnostic(NOWHERE, "PL601", "contradiction")]), 1, "no solution"),
        (Undecided("too hard"), 3, "undecided"),
        (ZeroDivisionError("ours"), 4, "fault"),
    ],
)
def test_failures(run: Any, monkeypatch: pytest.MonkeyPatch, error: Exception, status: int, outcome: str) -> None:
    def fail(*_: object) -> None:
        raise error

    monkeypatch.setattr("planar_cli.homework.checking.checking.solve_problem", fail)
    monkeypatch.delenv("PLANAR_DEBUG", raising=False)
    ran = run("solve good.yaml --format json")
    assert ran.status == status
    assert ran.data["outcome"] == outcome
    assert ran.data["answers"] == {}
    assert ran.err
    assert run("solve good.yaml").status == status
    assert run("key good.yaml").status == status


def test_the_method_is_passed_on(run: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str | None] = []

    def note(problem: object, method: str | None = None) -> None:
        asked.append(method)
        raise Undecided("enough")

    monkeypatch.setattr("planar_cli.homework.checking.checking.solve_problem", note)
    run("solve good.yaml")
    run("solve good.yaml --method energy")
    assert asked == [None, "energy"]


def hang(*_: object) -> None:
    """Work that never ends."""
    while True:
        sum(range(1000))


def test_time_limit() -> None:
    with pytest.raises(Undecided, match=r"0\.05 s"), _limit.time_limit(0.05):
        hang()
    with _limit.time_limit(0):
        assert signal.getitimer(signal.ITIMER_REAL) == (0, 0)


def test_time_limit_on_the_command_line(run: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("planar_cli.homework.checking.checking.solve_problem", hang)
    ran = run("solve good.yaml --timeout 0.2")
    assert ran.status == 3
    assert "not decided within 0.2 s: the file was being worked on; --timeout allows more" in ran.err


def eat(*args: object) -> Any:
    return bytearray(8 * 1024**3)


@pytest.mark.parametrize("command", ["solve", "key"])
def test_a_limit_of_memory(command: str, run: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    before = resource.getrlimit(resource.RLIMIT_AS)
    monkeypatch.setattr("planar_cli.solve.run.solve_part", eat)
    ran = run(f"{command} good.yaml")
    assert ran.status == 3
    assert ":10: not decided, more than 2 GB of memory would be taken: the answers were being sought;" in ran.err
    assert resource.getrlimit(resource.RLIMIT_AS) == before


def test_a_time_limit_tells_what_was_being_worked_on(run: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    # First as it is, so that everything is imported when the limit begins to count.
    assert run("solve good.yaml").status == 0
    monkeypatch.setattr("planar_cli.solve.run.solve_part", hang)
    ran = run("solve good.yaml --timeout 0.5")
    assert ":10: not decided within 0.5 s: the answers were being sought; it may help to give numbers" in ran.err


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("solve", "Missing argument"),
        ("solve good.yaml --format docx", "Invalid value for '--format'"),
        ("solve good.yaml --format pdf", "a PDF is written to a file"),
        ("solve good.yaml --figures 0", "--figures"),
        ("solve good.yaml --digits 41", "--digits"),
        ("solve good.yaml --method magic", "--method"),
        ("solve good.yaml --why alfa", "did you mean alpha"),
        ("solve good.yaml --compare --why alpha", "--compare looks at all methods"),
        ("solve missing.yaml", "missing.yaml"),
    ],
)
def test_wrong_usage(run: Any, line: str, said: str) -> None:
    ran = run(line)
    assert ran.status == 2
    assert said in ran.err


def test_why(run: Any) -> None:
    whole, part = run("solve good.yaml"), run("solve good.yaml --why alpha")
    assert part.status == 0
    assert len(part.out) < len(whole.out)
    assert "4.905 rad/s² clockwise" in part.out


def test_compare(run: Any) -> None:
    ran = run("solve good.yaml --compare")
    assert ran.status == 0
    assert "newton" in ran.out.lower()
    methods = run("solve good.yaml --compare --format json").data["methods"]
    assert methods[0]["answers"]
    assert {"method", "equations", "largest_block", "answers", "objection"} == set(methods[0])


# --- files -----------------------------------------------------------------------------------------------------------


def test_output_replaces_a_link_and_leaves_its_target(run: Any, tmp_path: Path) -> None:
    victim = tmp_path / "victim"
    victim.write_text("precious")
    (tmp_path / "out.md").symlink_to(victim)
    assert run("solve good.yaml --format markdown -o out.md").status == 0
    assert victim.read_text() == "precious"
    assert not (tmp_path / "out.md").is_symlink()
    assert (tmp_path / "out.md").read_text().startswith("# Rod let go")
    assert not list(tmp_path.glob(".*"))


def test_output_to_standard_output(run: Any) -> None:
    assert run("solve good.yaml -o -").out == run("solve good.yaml").out


def test_output_that_cannot_be_written(run: Any, tmp_path: Path) -> None:
    ran = run(f"solve good.yaml -o {tmp_path}/nowhere/out.txt")
    assert ran.status == 2
    assert "cannot write" in ran.err


# --- key -------------------------------------------------------------------------------------------------------------


def test_key(run: Any, tmp_path: Path) -> None:
    ran = run("key good.yaml wrong.yaml")
    assert ran.status == 1
    assert ran.out.count("# Rod let go") == 2
    assert "STEP" not in ran.out
    assert "clockwise" in ran.out
    assert "Disagrees" in ran.out
    assert run("key --worked good.yaml -o key.md").status == 0
    assert "Kinetic analysis" in (tmp_path / "key.md").read_text()


def test_key_with_both(run: Any) -> None:
    """All answers, then all solutions, each file a level below."""
    out = run("key --both good.yaml answered.yaml").out
    answers, solutions = out.split("\n# Solutions\n")
    assert answers.startswith("# Answers\n")
    assert answers.count("\n## Rod let go") == solutions.count("\n## Rod let go") == 2
    assert "Kinetic analysis" not in answers
    assert solutions.count("\n### Step 2. Kinetic analysis") == 2
    assert answers.count("\\alpha = 4.905") == 2


def test_key_in_steps_as_short_as_a_key(run: Any) -> None:
    long, short = (run(f"key --worked --audience {a} good.yaml").out for a in ("student", "exam"))
    assert "Kinetic analysis" in long
    assert "Kinetic analysis" not in short
    assert r"= 4.905~\mathrm{rad/s^{2}}" in short
