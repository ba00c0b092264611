"""LaTeX source: it compiles, holds no command that is not ours, and nothing of a file is a command in it."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from conftest import PROBLEMS
from worked import name_of, worked

from planar_cli.figures.illustrated import illustrated
from planar_cli.formats.base import in_one
from planar_cli.formats.latex import Latex
from planar_cli.report.document import blocks as doc
from planar_cli.report.document.marks import Figure, Panel, Polyline, Tag
from planar_cli.report.notation.tex_words import in_ascii, words
from planar_cli.report.page.narrate import narrate

EVERY = 24
"""Of so many problem files one is read in each run."""
ENGINES = ("pdflatex", "xelatex")
HOSTILE = "\\input{/etc/passwd} \\write18{id} % # $x$ ~ ^^5c & _a_ {b} <c> ``d'' -- é ω 中 \u202e \\end{document}"
OURS = frozenset(
    "planarhead planarshown planaranswer planarlist unicodeletter LARGE Large large normalsize small ttfamily textbf "
    "textit textbackslash textasciicircum textasciitilde textless textgreater textbar textquotedbl textasciigrave "
    "textbullet ensuremath text item par quad qquad ldots S ss begin end hline endhead linewidth raggedright "
    "arraybackslash path node sffamily fontsize selectfont raisebox mbox allowbreak displaystyle Rightarrow frac tfrac "
    "sqrt surd int partial dot ddot vec mathrm operatorname left right lvert rvert lbrack rbrack lbrace rbrace cdot "
    "times sim wedge pm perp parallel backslash prime infty circ bullet approx ne lt le gt ge to rightarrow leftarrow "
    "uparrow downarrow nearrow nwarrow searrow swarrow leftrightarrow updownarrow circlearrowleft circlearrowright sin "
    "cos tan cot sec csc arcsin arccos arctan sinh cosh tanh ln exp max min alpha beta gamma delta epsilon zeta eta "
    "theta kappa lambda mu nu xi pi rho sigma tau phi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega "
    "vartheta nopagebreak medskip centering dimexpr tabcolsep arrayrulewidth relax "
    "char quotedblbase o O ae AE oe OE l L i u r H v c k".split()
)
ENVIRONMENTS = {"document", "itemize", "longtable", "tabular", "tikzpicture", "cases", "minipage"}


def page_of(path: Path) -> doc.Document:
    solution = worked(path)[0]
    return illustrated(narrate(solution), solution)


def demand_whole(source: str) -> None:
    """Plain ASCII, known commands, everything that is opened is closed."""
    assert source.isascii()
    body = source.split("\\begin{document}", 1)[1]
    commands = re.findall(r"\\([A-Za-z]+)", body.replace("\\\\", "\\\\ "))
    assert set(commands) <= OURS
    bare = re.sub(r"\\.", "", body, flags=re.DOTALL)
    assert bare.count("{") == bare.count("}")
    assert bare.count("$") % 2 == 0
    assert "%" not in bare
    assert "#" not in bare
    open_ = ["document"]
    for which, name in re.findall(r"\\(begin|end)\{(\w+)\}", body):
        assert name in ENVIRONMENTS
        assert which == "begin" or open_.pop() == name
        open_ += [name] if which == "begin" else []
    assert open_ == []


@pytest.mark.parametrize("path", PROBLEMS[::EVERY], ids=name_of)
def test_a_page_is_whole(path: Path) -> None:
    demand_whole(Latex().render(page_of(path)))


def hostile() -> doc.Document:
    figure = Figure((Panel((Polyline(((0.0, 0.0), (1.0, 0.0)), "body"), Tag((0.0, 0.0), doc.line(HOSTILE)))),), HOSTILE)
    return doc.Document(
        HOSTILE,
        (
            doc.Heading(HOSTILE, HOSTILE, HOSTILE),
            doc.Paragraph(doc.line(HOSTILE, doc.Name(HOSTILE), doc.Text(HOSTILE, "strong"))),
            doc.Equation((doc.Text(HOSTILE), doc.Name(HOSTILE)), 1, doc.line(HOSTILE)),
            doc.Forces(HOSTILE, doc.line(HOSTILE)),
            doc.Table((doc.line(HOSTILE),), ((doc.line(HOSTILE),),)),
            doc.Answer(HOSTILE, doc.line(HOSTILE)),
            doc.Typed((HOSTILE, "  a: b # c")),
            doc.Drawing(figure),
        ),
    )


def test_words_of_a_file_do_nothing() -> None:
    demand_whole(Latex().render(hostile()))
    assert words("\\input{x}") == r"\textbackslash{}input\{x\}"
    assert words("v̇ é 5 m/s² → 中") == (
        r"\text{\.{v}} \text{\'{e}} 5 m/s\ensuremath{^{2}} \ensuremath{\rightarrow} \text{\unicodeletter{4E2D}}"
    )
    assert in_ascii(r"\text{Größe } ω_{1}") == r"\text{Gr\text{\"{o}}\ss{}e } \ensuremath{\omega}_{1}"


@pytest.mark.parametrize("engine", ENGINES)
def test_the_source_compiles(engine: str, tmp_path: Path) -> None:
    """A page with figures and a hostile one, of which nothing is read."""
    found = shutil.which(engine)
    if found is None:
        pytest.skip(f"no {engine} is installed (Debian's packages texlive-pictures, texlive-xetex and lmodern)")
    source = tmp_path / "page.tex"
    page = page_of(next(p for p in PROBLEMS if p.stem == "ex-4-05"))
    source.write_text(Latex().render(in_one([page, hostile()])))
    line = [found, "-interaction=nonstopmode", "-halt-on-error", "-no-shell-escape", source.name]
    ran = subprocess.run(line, cwd=tmp_path, capture_output=True, text=True, errors="replace", check=False, timeout=120)
    assert ran.returncode == 0, ran.stdout[-3000:]
    assert (tmp_path / "page.pdf").read_bytes().startswith(b"%PDF")
    assert "/etc/passwd)" not in ran.stdout
