"""Values of given names: ranges and lists under `variants` or in `given`, exact, in the author's unit."""

from __future__ import annotations

import pytest

from planar_cli.homework.variants.variant_draws import draws
from planar_cli.problem.nodes.nodes import read_text
from planar_cli.problem.nodes.reading import Report
from planar_cli.problem.sections.variations import variations_of, with_values, written
from planar_cli.problem.structure import load_text

FILE = """plane: horizontal
given: {GIVEN}
bodies: {b: {particle: [0, 0], mass: m}}
loads:
  - force: {body: b, magnitude: 10 N, angle: 0 deg}
find: {a: a(b).x}
VARIANTS
"""


def told(given: str = "m: 2 kg", variants: str = "") -> tuple[dict[str, tuple[str, ...]], list[str]]:
    text = FILE.replace("{GIVEN}", f"{{{given}}}").replace("VARIANTS", variants)
    node, _ = read_text(text, "f")
    assert node is not None
    report = Report()
    found = {v.name: v.values for v in variations_of(node, report)}
    return found, [f"{d.code} {d.message}" for d in report.sorted()]


def test_a_range_and_a_list() -> None:
    assert told(variants="variants: {m: {from: 2 kg, to: 3 kg, step: 0.25 kg}}")[0] == {
        "m": ("2 kg", "2.25 kg", "2.5 kg", "2.75 kg", "3 kg")
    }
    assert told(variants="variants: {m: [2 kg, 3 kg]}")[0] == {"m": ("2 kg", "3 kg")}
    assert told(given="m: {from: 2 kg, to: 2500 g, step: 0.5 kg}")[0] == {"m": ("2 kg", "2.5 kg")}
    assert told(given="m: {one_of: [2 kg, 3 kg]}")[0] == {"m": ("2 kg", "3 kg")}


def test_the_first_value_is_that_of_the_file() -> None:
    text = FILE.replace("{GIVEN}", "{m: {from: 4 kg, to: 5 kg, step: 1 kg}}").replace("VARIANTS", "")
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    (symbol,) = problem.given
    assert getattr(symbol.value, "value", None) == 4


@pytest.mark.parametrize(
    ("variants", "message"),
    [
        ("variants: {k: [2 kg]}", "'k' is no given name"),
        ("variants: {m: {from: 2 kg, to: 3 m, step: 1 kg}}", "different units"),
        ("variants: {m: {from: 3 kg, to: 2 kg, step: 1 kg}}", "goes up"),
        ("variants: {m: {from: 2 kg, to: 3 kg, step: 0 kg}}", "goes up"),
        ("variants: {m: {from: 2 kg, to: 3 kg, step: 0.0001 kg}}", "1000 are allowed"),
        ("variants: {m: {from: q, to: 3 kg, step: 1 kg}}", "plain numbers"),
        ("variants: {m: {from: 2 kg, to: 3 kg}}", "needs the key 'step'"),
        ("variants: {m: [2, 3 kg]}", "'2' has no unit, the given value has kg"),
        ("variants: {m: [2 m]}", "'2 m' has the unit m, the given value has kg"),
        ("variants: {m: {from: 2, to: 3, step: 1}}", "'2' has no unit"),
    ],
)
def test_what_is_wrong_is_told(variants: str, message: str) -> None:
    assert any(message in m for m in told(variants=variants)[1])


def wrong_of(text: str) -> list[str]:
    return [f"{d.mark.line}:{d.mark.column} {d.code} {d.message} ({d.hint})" for d in load_text(text)[1]]


def test_an_angle_needs_its_unit() -> None:
    text = FILE.replace("{GIVEN}", "{m: 2 kg, beta: 20 deg}").replace("VARIANTS", "variants: {beta: [20, 25 deg, 0]}")
    (told_of,) = wrong_of(text)
    assert told_of.startswith("7:19 PL343 the variant '20' has no unit")
    assert "write `20 deg`" in told_of


def test_a_list_under_given_is_told_how_to_write() -> None:
    (told_of,) = wrong_of(FILE.replace("{GIVEN}", "{m: [80 g, 100 g]}").replace("VARIANTS", ""))
    assert "PL343 m is given one value, not a list" in told_of
    assert "{one_of: [80 g, 100 g]}" in told_of


def test_a_slip_in_a_placeholder_is_told() -> None:
    text = "text: A block of {mass1}.\n" + FILE.replace("{GIVEN}", "{mass: 2 kg}").replace(": m}", ": mass}")
    (told_of,) = wrong_of(text.replace("VARIANTS", ""))
    assert told_of.startswith("1:19 PL344 {mass1} in `text`: 'mass1' is no given name")
    assert "did you mean 'mass'?" in told_of


def test_numbers_are_tidy() -> None:
    from fractions import Fraction

    assert [written(Fraction(n)) for n in ("5/2", "-0.05", "100", "1/3")] == ["2.5", "-0.05", "100", "(1/3)"]


def test_draws_are_all_different_and_the_same_every_time() -> None:
    node, _ = read_text(
        FILE.replace("{GIVEN}", "{m: 2 kg, q: 1 m}").replace(
            "VARIANTS", "variants: {m: [2 kg, 3 kg, 4 kg], q: [1 m, 2 m]}"
        ),
        "f",
    )
    assert node is not None
    varied = variations_of(node, Report())
    first = list(draws(varied, "7"))
    assert len(first) == len(set(first)) == 6
    assert first == list(draws(varied, "7"))
    assert first != list(draws(varied, "8"))


def test_other_values_are_put_in() -> None:
    node, _ = read_text(FILE.replace("{GIVEN}", "{m: 2 kg}").replace("VARIANTS", ""), "f")
    assert node is not None
    from planar_cli.problem.structure import problem_of

    problem, wrong = problem_of("f", with_values(node, {"m": "5 kg"}), [])
    assert problem is not None, wrong
    assert getattr(problem.given[0].value, "value", None) == 5
