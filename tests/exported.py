"""A small homework and its results by hand, with names and texts as hostile as a file or a student can make them."""

from __future__ import annotations

import inspect
from decimal import Decimal
from typing import Any

from planar_cli.formats._course_html import DELIMITERS, course_html
from planar_cli.homework.exports.base import Exported
from planar_cli.homework.sets.paper import Expected, Graded, Mistaken, Paper, Result, Task
from planar_cli.registry import members
from planar_cli.report.document.blocks import Bullet, Equation, Forces, Heading, Name, Paragraph, Title, Value, line

SHELF = "homework.exports"
SCRIPT = "<script>alert('x')</script>"
FORMULA = '=HYPERLINK("http://evil.example","click")'
HOSTILE = f'{SCRIPT} {FORMULA} ]]> " \\ {{{{params}}}} $x$ \\(y\\) {{1:SA:=a}} %100% ~ # --> \u202e\x1b[31m'
TITLE = f"Homework 3 {HOSTILE}"
SEED = 7

SLIDER = "slider"
WORKED = (
    Title("Slider"),
    Heading("STEP 1", HOSTILE),
    Equation((Name("a_A"), line(Value(Decimal("3.2"), "m/s^2"))), 1, relation="<"),
    Bullet(line("one")),
    Bullet(line("two ", Name("x"))),
    Forces("A", line(Name("N"), " ↑")),
    Paragraph(line(HOSTILE)),
)
LETTERS = (Paragraph(line("In the figure: ", Name("x"), " = 2 m")),)
LEFT_OUT = Mistaken("weight-left-out", "This is the result without the weight: is it in <every> equation?", (5.1,))
REVERSED = Mistaken("friction-reversed", "Friction acts the other way.", (-2.0,))
INSIDE = Mistaken("sine-for-cosine", "Sine and cosine are exchanged.", (3.21,))
BESIDE = Mistaken("mass-for-weight", "Mass is not weight.", (5.13,))


def number(find: str, value: float, unit: str, *mistakes: Mistaken, **others: Any) -> Expected:
    return Expected(
        find, f"the {find} of A", "number", (value,), unit, f"{value} {unit}", 0.01, 10.0, mistakes=mistakes, **others
    )


def slider(variant: int) -> Task:
    """Numbers of all kinds."""
    k = 1.0 + variant / 10
    expected = (
        number("a_A", 3.2 * k, "m/s^2", LEFT_OUT, REVERSED, INSIDE, BESIDE, points=2.0, axis="x"),
        number("mu", 0.25 * k, "1"),
        number("R", 0.0, "N"),
        number("tiny", 3.0e-6 * k, "m"),
        number("omega", -4.5 * k, "rad/s", rotation=True),
        number("theta", 350.0, "deg", Mistaken("other-root", "This is the other root.", (170.0,)), direction=True),
    )
    worked = {way: course_html(WORKED, way) for way in DELIMITERS}
    scene = {"svg": drawn(variant), "words": HOSTILE, **{way: course_html(LETTERS, way) for way in DELIMITERS}}
    text, given = f"A block slides.\n\n{HOSTILE}", ("m = 2 kg", FORMULA)
    return Task(SLIDER, f"A slider {HOSTILE}", text, given, expected, worked, scene)


def drawn(variant: int) -> str:
    """The figure of the slider; variants 1 and 2 have the same."""
    return f'<svg xmlns="http://www.w3.org/2000/svg"><title>{min(variant, 1)}</title></svg>'


def linkage(variant: int) -> Task:
    """What is no single number."""
    k = 1.0 + variant / 10
    wrong = Mistaken("coriolis-left-out", "The Coriolis term is missing.", (3.0 * k, 9.0))
    formula = "0.5*m*g*sin(beta)"
    letters = (("m", "kg"), ("g", "m/s^2"), ("beta", "rad"))
    vector = Expected("v_B", "the velocity of B", "vector", (3.0 * k, 0.0), "m/s", "", 0.01, 5.0, mistakes=(wrong,))
    expected = (
        vector,
        Expected("t", "the times of arrival", "list", (4.0 * k, 2.0), "s", "", 0.01, 4.0),
        Expected("slips", "does it slip?", "word", (), "1", "yes", 0.0, 0.0),
        Expected("mode", "what happens", "word", (), "1", "sticks*", 0.0, 0.0),
        Expected("T", "the tension", "formula", (), "N", "", 0.0, 0.0, formula=formula, letters=letters),
        Expected("U", "the work", "formula", (), "J", "", 0.0, 0.0, formula="m*heaviside(g)", letters=letters),
    )
    return Task("linkage", "x" * 300, "", (), expected)


PAPERS = tuple(Paper(v, (slider(v), linkage(v))) for v in (0, 1, 2))


def graded(find: str, submitted: str, verdict: str, score: float, **others: Any) -> Graded:
    return Graded(SLIDER, find, submitted, verdict, score, 2.0, **others)


RESULTS = (
    Result(
        "ada",
        1,
        (
            graded("a_A", "3.52 m/s^2", "right", 2.0, expected="3.52 m/s²", due_unit="m/s^2", tolerance=0.01),
            graded(
                "mu", "-2.5", "wrong", 0.0, message="-the value is not right", feedback="Friction acts the other way."
            ),
        ),
    ),
    Result(
        FORMULA,
        2,
        (
            graded("a_A", "@SUM(1)", "ungradable", 0.0, message=f"{SCRIPT}"),
            graded("mu", "", "missing", 0.0, expected="+0.25"),
        ),
    ),
    Result("x" * 300, 0, (), wrong=("\tno answers were found",)),
    Result("../con", 0, (graded("a_A", "\r3", "right", 1 / 3),)),
    Result("CON", 0, (graded("a_A", "3", "right", 2.0),)),
    Result("con_", 0, (graded("a_A", "3", "right", 2.0),)),
)


def exported(kind: str, source: Any = None, title: str = TITLE, **others: Any) -> Exported:
    """What a member makes of the homework, or of other papers or results."""
    member: Any = members(SHELF)[kind]()
    if member.takes == "papers":
        return member.export(PAPERS if source is None else source, title, SEED)
    return member.export(RESULTS if source is None else source, title, **others)


def manual_page(kind: str) -> str:
    return inspect.cleandoc(members(SHELF)[kind].__doc__ or "")
