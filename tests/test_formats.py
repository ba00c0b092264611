"""The formats of a document: the spool of the design page as golden texts, narrow terminals, hostile names."""

from __future__ import annotations

import io
import json
import re
import subprocess
import sys
from decimal import Decimal
from fractions import Fraction
from typing import get_args

import pytest
from sympy import Abs, Add, Eq, Mul, Symbol, sqrt, symbols, tan

from planar_cli import registry
from planar_cli.formats.base import runs
from planar_cli.formats.json import dumps
from planar_cli.formats.markdown import Markdown, protected
from planar_cli.formats.terminal import Terminal
from planar_cli.report.document import blocks as doc
from planar_cli.report.document.lettered import lettered


def value(number: str, unit: str = "") -> doc.Value:
    return doc.Value(Decimal(number), unit)


def spool() -> doc.Document:
    P, R, r, m, k, a, alpha, inertia, F = symbols("P R r m k_G a_G alpha I_G F")
    values = {P: "100", R: "0.45", r: "0.3", m: "50", k: "0.2"}
    closed = -P * (R + r) / (m * (R**2 + k**2))
    moment = Add(Mul(-1, m, a, R, evaluate=False), inertia * alpha, evaluate=False)
    return doc.Document(
        "Spool pulled along a rough floor",
        (
            doc.Note(
                "Effects",
                doc.line(
                    "weight · normal force and friction at C (rolling, no slip) · rotational inertia of the spool"
                ),
            ),
            doc.Note("Effects", doc.line("not in this scene: drag, springs, Coriolis, impact")),
            doc.Heading("STEP 1", "Kinematic analysis"),
            doc.Paragraph(doc.line("The spool rolls without slipping on the floor at C:")),
            doc.Equation(
                (doc.Math(a), doc.Math(-R * alpha)),
                1,
                note=doc.line("rolling, ", doc.Name("alpha"), " positive counterclockwise"),
            ),
            doc.Heading("STEP 2", "Kinetic analysis", "free-body diagram = kinetic diagram"),
            doc.Forces(
                "Spool",
                doc.line("P → at T,  ", doc.Math(m * Symbol("g")), " ↓ at G,  N ↑ at C,  F → at C (assumed)"),
                doc.line(doc.Math(m * a), " → at G,  ", doc.Math(inertia * alpha), " ↺"),
            ),
            doc.Paragraph(doc.line("Moments about C, where N and F meet, so that neither enters:")),
            doc.Equation((doc.Math(-P * (R + r)), doc.Math(moment)), 2, doc.line("↺ ", doc.Name("ΣM_C"), ":")),
            doc.Equation(
                (doc.Math(Add(P, F, evaluate=False)), doc.Math(m * a)), 3, doc.line("→ ", doc.Name("ΣF_x"), ":")
            ),
            doc.Heading(
                "STEP 3",
                "Solving the equations",
                doc.line("3 equations, 3 unknowns: ", doc.Math(alpha), ", ", doc.Math(a), ", ", doc.Math(F)),
            ),
            doc.Equation(
                (doc.Math(alpha), doc.Math(closed), doc.Math(closed, values), value("-6.18556701", "rad/s^2")),
                lead=doc.line("(1) in (2):"),
            ),
            doc.Equation(
                (doc.Math(F), doc.Math(m * R * Abs(alpha) - P), value("39.17525773", "N")), lead=doc.line("(1) in (3):")
            ),
            doc.Answer("alpha", doc.line(value("6.18556701", "rad/s^2"), " clockwise")),
            doc.Answer("F", doc.line(value("39.17525773", "N"), " to the right (as assumed)")),
            doc.Check(doc.line("residuals 0 in 4 equations")),
            doc.Check(doc.line("multibody solution agrees to 15 digits")),
            doc.Check(doc.line(doc.Relation(doc.Name("N"), "=", value("490.5", "N")), " > 0")),
            doc.Note(
                "Discussion",
                doc.line(
                    "The friction changes sign at ", doc.Math(Eq(k, sqrt(R * r))), " = ", value("0.36742346", "m"), "."
                ),
            ),
        ),
    )


TERMINAL = """\
Spool pulled along a rough floor

Effects     weight · normal force and friction at C (rolling, no slip) · rotational inertia of the spool
            not in this scene: drag, springs, Coriolis, impact

STEP 1  Kinematic analysis
  The spool rolls without slipping on the floor at C:
    (1)  a_G = -R α                                     rolling, α positive counterclockwise

STEP 2  Kinetic analysis                                free-body diagram = kinetic diagram
  Spool:  P → at T,  m g ↓ at G,  N ↑ at C,  F → at C (assumed)   =   m a_G → at G,  I_G α ↺
  Moments about C, where N and F meet, so that neither enters:
    (2)  ↺ ΣM_C:   -P (R + r) = -m a_G R + I_G α
    (3)  → ΣF_x:        P + F = m a_G

STEP 3  Solving the equations                           3 equations, 3 unknowns: α, a_G, F
  (1) in (2):   α = -P (R + r) / (m (R² + k_G²)) = -100 (0.45 + 0.3) / (50 (0.45² + 0.2²)) = -6.186 rad/s²
  (1) in (3):   F = m R |α| - P = 39.18 N

Answer      α = 6.186 rad/s² clockwise
            F = 39.18 N to the right (as assumed)
Check       residuals 0 in 4 equations · multibody solution agrees to 15 digits · N = 490.5 N > 0
Discussion  The friction changes sign at k_G = √(R r) = 0.3674 m.
"""

NARROW = """\
STEP 3  Solving the equations
  3 equations, 3 unknowns: α, a_G, F
  (1) in (2):   α = -P (R + r)
                  / (m (R² + k_G²))
                  = -100 (0.45 + 0.3)
                  / (50 (0.45² + 0.2²))
                  = -6.186 rad/s²
  (1) in (3):   F = m R |α| - P
                  = 39.18 N

Answer      α = 6.186 rad/s² clockwise
            F = 39.18 N to the right (as
            assumed)
Check       residuals 0 in 4 equations ·
            multibody solution agrees to
            15 digits · N = 490.5 N > 0
Discussion  The friction changes sign at
            k_G = √(R r) = 0.3674 m.
"""

SUBSTITUTED = r"-\frac{100 (0.45 + 0.3)}{50 (0.45^{2} + 0.2^{2})}"
MARKDOWN = r"""# Spool pulled along a rough floor

**Effects:**

- weight · normal force and friction at C (rolling, no slip) · rotational inertia of the spool
- not in this scene: drag, springs, Coriolis, impact

## Step 1. Kinematic analysis

The spool rolls without slipping on the floor at C:

$$
a_{G} = -R \alpha \qquad \text{rolling, }\alpha\text{ positive counterclockwise} \tag{1}
$$

## Step 2. Kinetic analysis

| body | free-body diagram | kinetic diagram |
| --- | --- | --- |
| **Spool** | P → at T,  $m g$ ↓ at G,  N ↑ at C,  F → at C (assumed) | $m a_{G}$ → at G,  $I_{G} \alpha$ ↺ |

Moments about C, where N and F meet, so that neither enters:

$$
\circlearrowleft \Sigma M_{C}: \quad -P (R + r) = -m a_{G} R + I_{G} \alpha \tag{2}
$$

$$
\rightarrow \Sigma F_{x}: \quad P + F = m a_{G} \tag{3}
$$

## Step 3. Solving the equations

(3 equations, 3 unknowns: $\alpha$, $a_{G}$, $F$)

$$
\text{(1) in (2):} \quad \alpha = -\frac{P (R + r)}{m (R^{2} + k_{G}^{2})} = @ = -6.186~\mathrm{rad/s^{2}}
$$

$$
\text{(1) in (3):} \quad F = m R \lvert \alpha \rvert - P = 39.18~\mathrm{N}
$$

## Answer

- $\alpha = 6.186~\mathrm{rad/s^{2}}$ clockwise
- $F = 39.18~\mathrm{N}$ to the right (as assumed)

**Check:** residuals 0 in 4 equations · multibody solution agrees to 15 digits · $N = 490.5~\mathrm{N} \gt 0$

**Discussion:** The friction changes sign at $k_{G} = \sqrt{R r} = 0.3674~\mathrm{m}$.
""".replace("@", SUBSTITUTED)


def test_the_spool_in_a_terminal() -> None:
    assert Terminal().render(spool()) == TERMINAL


def test_the_spool_in_a_narrow_terminal() -> None:
    text = Terminal(40).render(spool())
    assert text[text.index("STEP 3") :] == NARROW


def test_the_spool_in_markdown() -> None:
    assert Markdown().render(spool()) == MARKDOWN


@pytest.mark.parametrize("width", [20, 30, 40, 60, 80, 100, 120])
def test_no_row_is_wider_than_the_terminal(width: int) -> None:
    assert max(len(row) for row in Terminal(width).render(spool()).splitlines()) <= width


def test_colours_do_not_change_the_words() -> None:
    coloured = Terminal(colour=True).render(spool())
    assert "\x1b[" in coloured
    assert re.sub(r"\x1b\[[0-9;]*m", "", coloured) == TERMINAL


def test_a_pipe_gets_plain_text(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("FORCE_COLOR", raising=False)
    assert Terminal.on(io.StringIO()) == Terminal()


class Screen(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_no_color_is_obeyed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", "72")
    monkeypatch.delenv("NO_COLOR", raising=False)
    assert Terminal.on(Screen()) == Terminal(72, colour=True)
    monkeypatch.setenv("NO_COLOR", "1")
    assert Terminal.on(Screen()) == Terminal(72, colour=False)


ROWS = doc.Document(
    "Rows",
    (
        doc.Title("Second title"),
        doc.Bullet(doc.line("first")),
        doc.Bullet(doc.line("second, with ", doc.Math(Symbol("omega_AB") ** 2))),
        doc.Result(doc.line(doc.Relation(doc.Name("a_C"), "≈", value("2.5", "m/s^2")))),
        doc.Forces("Rod AB", doc.line("W ↓ at G")),
        doc.Table(
            (doc.line("method"), doc.line("equations")),
            ((doc.line("work"), doc.line("1")), (doc.line(doc.Math(Abs(Symbol("x")))), doc.line("12"))),
        ),
        doc.Answer("taut", doc.line("yes"), relation=":"),
        doc.Equation((doc.Math(Symbol("x")), doc.line(value("1", "N"), doc.Text(" or more"))), relation="≥"),
        doc.Equation((doc.Math(Symbol("y")),)),
        doc.Typed(("x.a: 1 # 2", "  $b$")),
    ),
)


def test_the_other_blocks_in_a_terminal() -> None:
    assert Terminal(60).render(ROWS) == (
        "Rows\nSecond title\n\n"
        "  • first\n  • second, with ω_AB²\n    ⇒ a_C ≈ 2.5 m/s²\n  Rod AB:  W ↓ at G\n\n"
        "  method   equations\n  ──────   ─────────\n  work     1\n  |x|      12\n\n"
        "Answer      taut: yes\n\n"
        "    x ≥ 1 N or more\n    y\n  x.a: 1 # 2\n    $b$\n"
    )


def test_the_other_blocks_in_markdown() -> None:
    text = Markdown().render(ROWS)
    assert "- first\n- second, with $\\omega_{AB}^{2}$" in text
    assert "⇒ $a_{C} \\approx 2.5~\\mathrm{m/s^{2}}$" in text
    assert "| method | equations |\n| --- | --- |\n| work | 1 |\n| $\\lvert x \\rvert$ | 12 |" in text
    assert "- $\\mathrm{taut}$: yes" in text
    assert "x \\ge 1~\\mathrm{N}\\text{ or more}" in text
    assert text.endswith("```text\nx.a: 1 # 2\n  $b$\n```\n")


@pytest.mark.parametrize(("tex", "safe"), [
    (r"\dot{x}_{2} + v_{A}", r"\dot{x}_ {2} + v_{A}"),
    (r"\int_{0}^{t} c\, dt", r"\int_{0}^{t} c\thinspace  dt"),
    (r"\begin{cases} 1 & a \\ 2 & b \end{cases}", r"\begin{cases} 1 & a \cr 2 & b \end{cases}"),
])  # fmt: skip
def test_github_finds_nothing_of_its_own_in_a_formula(tex: str, safe: str) -> None:
    assert protected(tex) == safe


m, h, r = (doc.Name(n) for n in "mhr")


def test_a_bar_in_a_formula_does_not_end_its_cell() -> None:
    table = doc.Table((doc.line("a"), doc.line("b")), ((doc.line("|", m, "| = ", h), doc.line("c | d")),))
    row = Markdown().render(doc.Document("", (table,))).splitlines()[-1]
    assert row == r"| $\vert m\vert  = h$ | c \| d |"


@pytest.mark.parametrize(("line", "text"), [
    (doc.line(m, " = ", value("12", "kg"), ", ", h, " = ", value("2", "m")),
     r"$m = 12~\mathrm{kg}$, $h = 2~\mathrm{m}$"),
    (doc.line("G(0, -", h, ") lies on AB"), r"$G(0,\ -h)$ lies on AB"),
    (doc.line("C(0, 0), A(", r, "/", "√", "", value("2"), ", 0)"), r"C(0, 0), $A(r/\sqrt{2},\ 0)$"),
    (doc.line("v", " = [", value("4.6"), ", ", value("-3"), "] m/s, to the right"),
     r"v = $\lbrack 4.6,\ -3\rbrack ~\mathrm{m/s}$, to the right"),
    (doc.line("|", m, "| = ", value("2", "N"), " ≤ ", h, r), r"$|m| = 2~\mathrm{N} \le hr$"),
    (doc.line("at ", r, " - ", value("90", "deg"), " (seen from ", doc.Name("v_P"), ")"),
     r"at $r - 90^{\circ}$ (seen from $v_{P}$)"),
    (doc.line("1: ", h, " = 0; 2: ", h, " = ", r, " sin ", doc.Name("beta")), r"1: $h = 0$; 2: $h = r \sin \beta$"),
    (doc.line("J (u + v)/2 = ", value("-4", "J")), r"J (u + v)/2 = $-4~\mathrm{J}$"),
    (doc.line(doc.Name("v_P"), "′ = 2 ω × ", h), r"$v_{P}' = 2 \omega \times h$"),
    (doc.line(doc.Name("low_is_stable"), ": yes"), r"low\_is\_stable: yes"),
    (doc.line("it strikes at v_0, at G_AB; F_0*sin(w t), a face_1"),
     r"it strikes at $v_{0}$, at $G_{AB}$; F\_0\*sin(w t), a face\_1"),
])  # fmt: skip
def test_one_formula_for_each_datum(line: doc.Line, text: str) -> None:
    """Units upright; words, and brackets of words, stay words."""
    assert Markdown().render(doc.Document("", (doc.Paragraph(line),))) == f"# \n\n{text}\n"


@pytest.mark.parametrize(("sentence", "names"), [
    ("Newton's second law.", ""),
    ("Rigid bodies: v_B = v_A + ω × r_B/A.", "v_B v_A ω r_B/A"),
    ("Path coordinates: a = v\u0307 e_t + v²/ρ e_n.", "a v_dot e_t v ρ e_n"),
    ("Integration over the way: v dv = a ds.", "v d v a d s"),
    ("ratio: v = ω r about O = 4", "v ω r"),
    ("A largest value: there a derivative is zero.", ""),
])  # fmt: skip
def test_letters_of_a_sentence(sentence: str, names: str) -> None:
    pieces = lettered(sentence)
    assert " ".join(p.name for p in pieces if isinstance(p, doc.Name)) == names
    assert Terminal(200).render(doc.Document("", (doc.Paragraph(pieces),))).strip() == sentence


def test_units_inside_formulas_are_upright() -> None:
    angle = Symbol("theta")
    sides = (doc.Math(tan(angle)), doc.Math(tan(angle), {angle: "2.06 rad"}))
    text = Markdown().render(doc.Document("", (doc.Equation(sides),)))
    assert r"\tan \theta = \tan(2.06~\mathrm{rad})" in text


def test_components_of_an_answer_are_subscripts() -> None:
    row = doc.Equation((doc.line(doc.Name("J"), ", x"), value("3", "N*s")))
    assert "J_{x} = 3~" in Markdown().render(doc.Document("", (row,)))


def test_diagrams_of_a_blow_have_heads_of_their_own() -> None:
    row = doc.Forces("ball", doc.line("m v"), doc.line("m u"), ("momentum before + impulses", "momentum after"))
    assert "| body | momentum before + impulses | momentum after |" in Markdown().render(doc.Document("", (row,)))


def test_a_value_continues_under_its_sign() -> None:
    """Also where the sign stands in the right half of the page, as long as everything fits there."""
    a, b, c = symbols("alpha_1 beta_1 gamma_1", positive=True)
    equation = doc.Equation(
        (doc.line("length of the spring, s"), doc.Math(a + b - c), doc.Math(a - b + c), value("0.1172", "m"))
    )
    rows = Terminal(50).render(doc.Document("", (equation,))).splitlines()[-3:]
    assert rows[-1].endswith("= 0.1172 m")
    assert len({row.index("= ") for row in rows}) == 1
    assert rows[0].index("= ") > 25


def test_a_long_lead_stays_on_the_line_of_what_fits_beside_it() -> None:
    lead = doc.line("moment of inertia about A, parallel axes:")
    equation = doc.Equation((doc.line("I_A"), value("0.1172", "kg*m^2")), lead=lead)
    wide, narrow = (Terminal(width).render(doc.Document("", (equation,))).strip().splitlines() for width in (72, 50))
    assert len(wide) == 1
    assert len(narrow) == 2
    assert narrow[0].endswith("axes:")


def test_a_formula_breaks_between_factors_before_it_breaks_in_brackets() -> None:
    a, b, c = symbols("alpha_1 beta_1 gamma_1", positive=True)
    long = doc.Math(Mul(a + b * c, a + 2 * b, 3 * a + c, evaluate=False) / (b + c))
    rows = Terminal(40).render(doc.Document("", (doc.Equation((doc.line("x"), long)),))).splitlines()
    assert all(row.count("(") == row.count(")") for row in rows)
    nested = doc.Math(sqrt(Add(a * b, b * c, 2 * a * c, 3 * a**2, 5 * c**2)))
    rows = Terminal(30).render(doc.Document("", (doc.Equation((doc.line("x"), nested)),))).splitlines()
    assert len(rows) > 1
    assert not any(row.rstrip().endswith(("+", "-", "/", "·")) for row in rows)


@pytest.mark.parametrize("width", range(36, 60))
def test_a_vector_of_two_numbers_stays_together(width: int) -> None:
    first, second = value("-40.6", "1"), value("-48.39", "1")
    vector = doc.line("[", first, ", ", second, "]", " m/s²")
    equation = doc.Equation((doc.line("a_A"), doc.line("-ω² r_A/O"), vector))
    page = Terminal(width).render(doc.Document("", (equation,)))
    assert "[-40.6, -48.39] m/s²" in page


def test_a_wide_table_is_stacked() -> None:
    assert "  method: work\n  equations: 1\n" in Terminal(19).render(ROWS)


HOSTILE = [
    "\x1b[31mred\x1b[0m",
    "\x9b2J",
    "\u202eabc",
    "[link=http://x]x[/link]",
    "[/]",
    "a\nb\r# c",
    "<script>",
    "$x$ `y`",
    "![i](u)",
]


@pytest.mark.parametrize("name", HOSTILE)
@pytest.mark.parametrize("colour", [False, True])
def test_hostile_words_are_harmless(name: str, colour: bool) -> None:
    document = doc.Document(
        name,
        (
            doc.Paragraph(doc.line(name, doc.Name(name), doc.Math(Symbol(name)))),
            doc.Note(name, doc.line(name)),
            doc.Forces(name, doc.line(name)),
            doc.Answer(name, doc.line()),
        ),
    )
    text = Terminal(colour=colour).render(document)
    for steering in ("\x1b[31m", "\x9b", "\u202e", "\r", "\x1b]8"):
        assert steering not in text
    assert "[/]" in text if name == "[/]" else True
    markdown = Markdown().render(document)
    assert all(c.isprintable() or c == "\n" for c in markdown)
    assert "<script>" not in markdown
    assert "![i](u)" not in markdown
    assert "\n# c" not in markdown


def test_a_paragraph_cannot_become_a_list() -> None:
    assert (
        Markdown().render(doc.Document("t", (doc.Paragraph(doc.line("- 5 N")), doc.Paragraph(doc.line("1. item")))))
        == "# t\n\n\\- 5 N\n\n1\\. item\n"
    )


def test_the_shelf_holds_the_formats() -> None:
    found = registry.members("formats")
    assert found["terminal"] is Terminal
    assert found["markdown"] is Markdown


def test_every_kind_of_block_has_its_pieces() -> None:
    """The dispatch of the contract knows all of them; which methods a format must have is held by type checking."""
    found = {type(run[0]) for run in runs(ROWS)} | {type(run[0]) for run in runs(spool())}
    assert found | {doc.Drawing} == set(get_args(doc.Block))
    assert all(list(Markdown().pieces(run)) for shown in (ROWS, spool()) for run in runs(shown))


def test_json_is_exact_and_deterministic() -> None:
    text = dumps(
        {
            "b": Decimal("-6.18556701030927835"),
            "a": [Fraction(1, 4), Fraction(4, 2), True, None, Decimal("-0")],
            "name": "α\u202e\x1b",
        }
    )
    assert text == (
        '{\n  "schema_version": 1,\n  "b": -6.185567010309279,\n  "a": [\n'
        "    0.25,\n    2,\n    true,\n    null,\n    0.0\n  ],\n"
        '  "name": "α\\u202e\\u001b"\n}\n'
    )
    assert json.loads(text)["name"] == "α\u202e\x1b"


@pytest.mark.parametrize("number", [Decimal("NaN"), Decimal("1E+999"), Fraction(10**400), float("inf")])
def test_json_refuses_numbers_that_are_not_finite(number: Decimal | Fraction | float) -> None:
    if isinstance(number, Fraction):
        assert json.loads(dumps({"x": number}))["x"] == 10**400
        return
    with pytest.raises(ValueError, match="finite"):
        dumps({"x": number})


@pytest.mark.parametrize("value_", [object(), {1: 2}, {"x"}])
def test_json_refuses_what_it_does_not_know(value_: object) -> None:
    with pytest.raises(TypeError):
        dumps({"x": value_})


def test_blocks_and_plain_text_load_neither_sympy_nor_rich() -> None:
    code = (
        "import sys; from planar_cli.report.document.blocks import Document, Name, Paragraph, Value, line;"
        "from planar_cli.formats.terminal import Terminal;"
        "from planar_cli.formats.markdown import Markdown; from decimal import Decimal;"
        "d = Document('t', (Paragraph(line('x', Value(Decimal(1), 'N'), Name('m'))),));"
        "Terminal().render(d); Markdown().render(d); sys.exit(any(m in sys.modules for m in ('sympy', 'rich')))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_degrees_among_letters_are_mathematics() -> None:
    side = doc.line("180° - ", doc.Math(symbols("beta")))
    page = Markdown().render(doc.Document("", (doc.Equation((doc.line(doc.Name("theta_1")), side)),)))
    assert r"\theta_{1} = 180^{\circ} - \beta" in page
    assert r"\text" not in page


def test_words_behind_a_letter_keep_their_space() -> None:
    told = doc.Equation(
        (doc.Name("a"), doc.Name("b")), lead=(doc.Name("v_B"), doc.Text(" "), doc.Text("along x"), doc.Text(":"))
    )
    assert r"v_{B}\ \text{along x}: \quad a = b" in Markdown().render(doc.Document("", (told,)))
    listed = doc.Equation(
        (doc.Name("a"), doc.Name("b")), note=(doc.Text("not 0°"), doc.Text(": "), doc.Name("v"), doc.Text(" > 0"))
    )
    assert r":\ v \gt 0" in Markdown().render(doc.Document("", (listed,)))


def test_an_aside_that_begins_with_a_number_needs_no_brackets() -> None:
    pages = [
        Markdown().render(doc.Document("", (doc.Heading("STEP 3", "Solving", x),))) for x in ("(1), (2)", "at rest")
    ]
    assert pages[0].rstrip().endswith("\n\n(1), (2)")
    assert pages[1].rstrip().endswith("\n\n(at rest)")
