"""What is handed out, in every format of pages: sheets with figures, nothing of the key in them, keys with drawings."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from conftest import PROBLEMS, ROOT
from exported import HOSTILE, PAPERS, TITLE
from pdf_text import texts_of_pages
from test_latex import demand_whole
from worked import name_of, worked

from planar_cli.cli import run
from planar_cli.commands._handed_out import PAGES, PDF, page
from planar_cli.figures.handed_out import handed_out, letters_told
from planar_cli.homework.sets.ready import Homework
from planar_cli.homework.sets.sheets import handed
from planar_cli.problem.structure import load_text
from planar_cli.report.document.blocks import Name, Value
from planar_cli.report.document.handed_out import key, sheet
from planar_cli.report.document.marks import Arrow, Dimension, Figure, Tag

PROBLEM = ROOT / "tests" / "homework" / "slope.yaml"
TWICE = ("latex", PDF)
"""Made twice; other tests do so with the other formats."""
EVERY = 24
"""Of so many problem files one is drawn in each run."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Sheets and keys with worked solutions in every format, each in a folder of its own."""
    whole = tmp_path_factory.mktemp("handed_out")
    homework_set = whole / "set.yaml"
    homework_set.write_text(f"problems: [{PROBLEM}]\nvariants: {{number: 1, seed: 7}}\n")
    for form in PAGES:
        for again in ("once", "again") if form in TWICE else ("once",):
            line = ["key", str(homework_set), "--both", "--format", form, "--timeout", "0"]
            assert run([*line, "-o", str(whole / form / again)]) == 0
    return whole


def test_a_problem_is_not_torn_where_it_fits_on_a_page(tmp_path: Path) -> None:
    named = ("spool", "rod", "slot", "slope")
    files = ", ".join(str(PROBLEM.with_name(f"{name}.yaml")) for name in named)
    (tmp_path / "set.yaml").write_text(f"problems: [{files}]\n")
    assert run(["key", str(tmp_path / "set.yaml"), "--format", PDF, "-o", str(tmp_path / PDF), "--timeout", "0"]) == 0
    pages = texts_of_pages(tmp_path / PDF / "sheet.pdf")
    assert len(pages) > 1
    # Each page begins with a heading: nothing of the problem before is left for it.
    assert all(re.match(r"\s*(?:\d\. [A-Z]|How to hand in)", page) for page in pages[1:])
    assert run(["key", str(tmp_path / "set.yaml"), "--format", "html", "-o", str(tmp_path), "--timeout", "0"]) == 0
    html = (tmp_path / "sheet.html").read_text()
    assert html.count('<div class="whole">\n<h2 class="title">') == len(named) + 1


@pytest.mark.parametrize("form", TWICE)
def test_the_same_seed_gives_the_same_bytes(folder: Path, form: str) -> None:
    once, again = ({p.name: p.read_bytes() for p in (folder / form / n).iterdir()} for n in ("once", "again"))
    assert once == again
    assert len(once) > 2


@pytest.mark.parametrize("form", [f for f in PAGES if f != PDF])
def test_figures_stand_in_sheets_and_keys(folder: Path, form: str) -> None:
    for name, least in (("sheet-1", 1), ("key", 2)):
        (page,) = (p for p in (folder / form / "once").glob(f"{name}.*"))
        text = page.read_text()
        pattern = {"markdown": r"!\[[^\]]*\]\(([\w-]+\.svg)\)", "html": "(<svg )", "latex": r"(\\begin\{tikzpicture\})"}
        found = re.findall(pattern[form], text)
        assert len(found) >= least
        if form == "markdown":
            assert all((page.parent / picture).read_text().startswith("<svg") for picture in found)


def test_the_figure_of_a_sheet_has_nothing_that_is_found() -> None:
    problem, _ = load_text(SOUGHT)
    assert problem is not None
    figure = handed_out(problem)
    assert figure is not None
    marks = figure.panels[0].marks
    # The place of A, the force whose way is asked, and the angle are sought.
    assert [m.words for m in marks if isinstance(m, Tag)] == [(Name("O"),), (Name("B"),)]
    assert [m for m in marks if isinstance(m, Arrow)] == []
    assert {w.number for m in marks if isinstance(m, Dimension) for w in m.words if isinstance(w, Value)} <= {2}


SOUGHT = """
plane: horizontal
coordinates: {s: m}
points: {O: [0, 0], A: [s, 0], B: [0, 2 m]}
bodies: {a: {particle: A, mass: 1 kg}, b: {particle: B, mass: 1 kg}}
loads:
  - spring: {between: [O, A], stiffness: 10 N/m, natural_length: 1 m}
  - force: {body: a, magnitude: 5 N, angle: 0}
instant: [equilibrium]
find: {s: s}
"""


@pytest.mark.parametrize(("given", "find", "styles"), [
    ("v(a).mag = 3 m/s, v(a).angle = 40 deg", "x: v(a).x", ["velocity"]),
    ("v(a).mag = v, v(a).angle = 40 deg, v(a).x = 3 m/s", "v: v", ["velocity"]),
    ("v(a).along(30 deg) = -3 m/s, v(a).across(30 deg) = 0", "x: v(a).x", ["velocity"]),
    ("v(a).x = 3 m/s, v(a).y = v, v(a).mag = 5 m/s, v > 0", "v: v", []),
    ("v(a).x = 2 m/s, v(a).y = 0, a(a).y = -1 m/s^2, a(a).x = 0", "v: v(a).mag", ["velocity", "acceleration"]),
])  # fmt: skip
def test_the_motion_that_is_given_has_its_arrows(given: str, find: str, styles: list[str]) -> None:
    """And what is sought has none: neither a component nor a direction that would tell it."""
    unknown = "unknowns: {v: m/s}\n" if "v: v" in find and "mag" not in find else ""
    text = f"plane: horizontal\n{unknown}bodies: {{a: {{particle: [1 m, 0], mass: 1 kg}}}}\ninstant: [{given}]\n"
    problem, wrong = load_text(f"{text}find: {{{find}}}\n")
    assert not wrong
    assert problem is not None
    figure = handed_out(problem)
    marks = figure.panels[0].marks if figure is not None else ()
    assert [m.style for m in marks if isinstance(m, Arrow)] == styles


def test_what_moves_alike_in_all_cases_is_in_the_scene_of_the_file() -> None:
    text = """
    plane: horizontal
    points: {O: [0, 0], A: [2 m, 0]}
    bodies: {a: {particle: O, mass: 1 kg}, b: {particle: A, mass: 1 kg}}
    cases:
      one: {instant: [v(a).x = 3 m/s, v(a).y = 0, b at rest], find: {p: momentum(all).x}}
      two: {instant: [v(a).x = 3 m/s, v(a).y = 0, v(b).x = 0, v(b).y = 1 m/s], find: {q: momentum(all).x}}
    """
    problem, wrong = load_text(text)
    assert not wrong
    assert problem is not None
    figure = handed_out(problem)
    assert figure is not None
    arrows = [m for m in figure.panels[0].marks if isinstance(m, Arrow)]
    assert [(m.at, m.angle) for m in arrows] == [((0.0, 0.0), 0.0)]


def test_letters_of_a_figure_have_their_values_on_the_sheet() -> None:
    text = "text: A slope of {beta}.\ngiven: {beta: 25 deg, mu: 0.2}\n" + SLOPE
    problem, wrong = load_text(text)
    assert not wrong
    assert problem is not None
    figure = handed_out(problem)
    assert figure is not None
    told = letters_told(figure, problem)
    assert [p.name for p in told if isinstance(p, Name)] == ["beta"]


SLOPE = """
plane: vertical
points: {P: [0, 0]}
surfaces: {slope: {through: P, angle: beta}}
bodies: {block: {particle: P, mass: 2 kg}}
joints: [{contact: {between: [block, slope], mu: mu}}]
instant: [at rest]
find: {a: a(block).mag}
"""


def numbers_of(figure: Figure) -> set[float]:
    words = [w for panel in figure.panels for m in panel.marks for w in getattr(m, "words", ())]
    return {abs(float(f"{w.number:.4g}")) for w in words if isinstance(w, Value)}


@pytest.mark.parametrize("path", PROBLEMS[::EVERY], ids=name_of)
def test_no_answer_stands_in_the_figure_of_a_sheet(path: Path) -> None:
    """Every number in it is one of the file."""
    problem = worked(path)[0].problem
    figure = handed_out(problem)
    if figure is not None:
        assert numbers_of(figure) <= set(map(float, re.findall(r"\d+(?:\.\d+)?", path.read_text())))


@pytest.mark.parametrize("form", PAGES)
def test_a_sheet_holds_nothing_of_the_key(folder: Path, form: str) -> None:
    key = (folder / "markdown" / "once" / "key.md").read_text()
    answers = re.findall(r"^\| slope \| \$\w+\$ \| (\d+\.\d+)", key, re.MULTILINE)
    assert len(answers) == 2
    shown = {p.name: text_of(p) for p in (folder / form / "once").iterdir() if p.name.startswith("sheet")}
    assert shown
    assert not [(name, a) for name, text in shown.items() for a in answers if a in text]


def text_of(path: Path) -> str:
    """The text of a file, of a PDF as a reader of PDF takes it out."""
    if path.suffix != ".pdf":
        return path.read_text()
    told = "\n".join(texts_of_pages(path))
    assert "slope" in told
    return told


def test_words_of_a_hostile_set_do_nothing() -> None:
    papers = dict(enumerate(PAPERS[:1]))
    homework = Homework(TITLE, HOSTILE, papers, {}, "", students=((HOSTILE, 0),))
    (one,) = handed(homework, [0])
    for pieces in (sheet(homework, one), key(homework, [0], worked=False)):
        made = list(pieces)
        demand_whole(page(made, TITLE, "latex").decode())
        html = page(made, TITLE, "html").decode()
        assert "<script" not in html
        assert page(made, TITLE, PDF).startswith(b"%PDF")
        assert not re.search(r"(?<!\\)<script", page(made, TITLE, "markdown").decode().split("```")[0])
