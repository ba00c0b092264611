"""Formulas of a worked page as MathML: read back as what they say, well formed, every command of the report known."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

import planar_cli
from planar_cli.formats._latex import equation
from planar_cli.mathml import MathML
from planar_cli.report.document.blocks import Equation, Text

WRITERS = (
    "report/notation/latex.py",
    "report/notation/names.py",
    "report/notation/notation.py",
    "formats/_formulas.py",
    "formats/markdown.py",
)


def shape(latex: str) -> str:
    """The MathML of a formula, its elements as brackets."""
    return _told(ET.fromstring(MathML().inline(latex)))


def _told(element: ET.Element) -> str:
    if not len(element):
        return "_" if element.tag == "mspace" else element.text or ""
    inside = " ".join(map(_told, element))
    return inside if element.tag in ("math", "mrow") else f"{element.tag}({inside})"


@pytest.mark.parametrize(
    ("latex", "due"),
    [
        (r"a_{G} = R \alpha", "msub(a G) = R α"),
        (r"k_{G}^{2} = 0.2^{2}", "msubsup(k G 2) = msup(0.2 2)"),
        (r"\frac{1}{2} m v_{G,2}^{2}", "mfrac(1 2) m msubsup(v G , 2 2)"),
        (r"\sqrt{3 g l}", "msqrt(3 g l)"),
        (r"2~\mathrm{kg \cdot m^{2}}", "2 _ kg · msup(m 2)"),
        (r"30^{\circ}", "30 °"),
        (r"\sin^{2} \theta", "msup(sin 2) _ θ"),
        (r"m g \cos \beta", "m g _ cos _ β"),
        (r"\cos(\omega t)", "cos ( ω t )"),
        (r"\left(\frac{a}{b} - 1\right)", "( mfrac(a b) − 1 )"),
        (r"\left\lvert \frac{a}{b} \right\rvert", "| mfrac(a b) |"),
        (r"\ddot{x} = -\frac{k}{m} x", "mover(x ¨) = − mfrac(k m) x"),
        (r"\text{in words: }x", "in words:\xa0 x"),
        (r"\int_{0}^{t} v\, dt", "msubsup(∫ 0 t) v _ d t"),
        (
            r"\begin{cases} 1 & x \lt 2 \\ 0 & \text{else} \end{cases}",
            "{ mtable(mtr(mtd(1) mtd(x < 2)) mtr(mtd(0) mtd(else)))",
        ),
        (r"v_{D}' = v_{D'}", "msub(v D) ′ = msub(v D ′)"),
        (r"\unheard", "\\unheard"),
    ],
)
def test_a_formula(latex: str, due: str) -> None:
    assert shape(latex) == due


def test_a_sign_behind_a_comma_belongs_to_what_follows() -> None:
    assert '<mo form="prefix">−</mo><mn>2</mn>' in MathML().inline(r"(1,\ -2)")
    assert "<mo>−</mo><mn>2</mn>" in MathML().inline(r"3~\mathrm{m} -2")


def test_every_command_that_the_report_writes_is_known() -> None:
    folder = Path(planar_cli.__file__).parent
    written = {name for file in WRITERS for name in re.findall(r"\\([A-Za-z]{2,})", (folder / file).read_text())}
    unknown = [n for n in sorted(written) if f"<mtext>\\{n}" in MathML().display(rf"\{n}{{x}}{{y}} \tag{{1}}")]
    # The last three stand in Markdown alone, for viewers that take other signs for their own.
    assert [n for n in unknown if n not in ("tag", "right", "end", "cr", "thinspace", "vert")] == []
    assert len(written) > 30


def test_a_long_formula_may_go_on_in_the_next_line() -> None:
    page = MathML().display(r"\text{(1) in (2):} \quad x = \frac{a}{b} = 3~\mathrm{m} \tag{4}")
    assert page.count("<math>") == 2
    assert ">(1) in (2):\N{EM SPACE} <math>" in page
    assert '<span class="number">(4)</span>' in page
    sum_of_many = " + ".join(f"m_{{{k}}} v_{{{k}}}" for k in range(20))
    assert re.search(
        '<span class="long"><math>.*</math>(<wbr/><math>.*?form="infix".*?</math>){3,}</span>',
        MathML().display(f"p = {sum_of_many}"),
    )
    assert MathML().display("a = b + c").count("<math>") == 1


def test_words_of_a_file_are_text() -> None:
    page = MathML().display(equation(Equation(((Text('a <script> "b" & c'),), Text("x < 1")))))
    root = ET.fromstring(page)
    assert not list(root.iter("script"))
    assert "<script" not in page
