"""Pages with numbers: what is printed in numbers holds for the values that the page gives, in the units of the page."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from pathlib import Path

import pytest
import sympy as sp
from conftest import PROBLEMS, ROOT
from worked import name_of, page_of_file, worked

from planar_cli.equation.values.ledger import display
from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.document.blocks import Equation, Math
from planar_cli.report.in_numbers.in_numbers import in_numbers
from planar_cli.report.notation.clean import Mixed, dimension_of, is_clean
from planar_cli.report.notation.notation import plain
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.page.narrate import narrate, phrases_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import FORCE, INERTIA, MASS

SAMPLE = (
    "four-bar",
    "ex-2-09",
    "gas-force-on-piston",
    "plate-on-parallel-links",
    "hoist-with-moving-pulley",
    "mine-hoist-us-units",
    "ladder-sliding",
    "quick-return",
    "planetary-gear",
    "falling-pole",
)
FILES = [p for p in PROBLEMS if p.stem in SAMPLE]


def _instants(path: Path) -> Iterator[tuple[InstantSolution, Phrases]]:
    for part in worked(path)[0].parts:
        for instant in part.instants:
            yield instant, phrases_of(instant, 12)


def _number(math: Math, phrases: Phrases) -> tuple[Decimal, Decimal]:
    """The value of one side as it is printed, and its largest term."""
    terms = []
    for term in sp.Add.make_args(math.expr):
        value = Decimal(1)
        for factor in sp.Mul.make_args(term):
            base, power = factor.as_base_exp()
            if base.is_number:
                value *= Decimal(str(sp.N(factor, 30)))
            elif base.name.startswith(NUMBER):
                value *= Decimal(
                    (math.values or {})[base].translate(str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")).replace("×10", "e")
                )
            else:
                unit = phrases.ledger.units[base]
                value *= display(phrases.value(base), phrases.page_unit(unit), phrases.ledger.us) ** int(power)
        terms.append(value)
    return sum(terms, Decimal(0)), max((abs(t) for t in terms), default=Decimal(0))


def _read(text: str) -> Decimal:
    """A number as it is printed: 1.235×10⁶."""
    return Decimal(text.translate(str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")).replace("×10", "e"))


def test_the_sample_is_there() -> None:
    assert {p.stem for p in FILES} == set(SAMPLE)


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_equations_in_numbers_hold(path: Path) -> None:
    """Both sides of every equation of every instant, collected in its unknowns, to ten figures."""
    seen = 0
    for instant, phrases in _instants(path):
        for stage in instant.stages:
            for w in (w for block in stage.blocks for w in block.equations if w.residual.free_symbols):
                found = in_numbers(w.left, w.right, stage.algebra.unknowns, phrases)
                if found is None:
                    continue
                (left, one), (right, two) = _number(found.left, phrases), _number(found.right, phrases)
                assert abs(left - right) <= Decimal("1e-9") * max(one, two, Decimal("1e-9")), w
                seen += 1
    assert seen


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_no_unit_is_swallowed(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a numeric problem, equations that are printed in letters have terms of one dimension; in the letters that the
    ledger knows, before those take the names of what is asked.
    """
    monkeypatch.setattr("planar_cli.report.page.narrate.with_one_name", list)
    for part in worked(path)[0].parts:
        ledgers = [i.instant.scene.ledger for i in part.instants if not i.instant.scene.ledger.symbolic]
        document = narrate(worked(path)[0])
        for block in document.blocks if ledgers else ():
            if isinstance(block, Equation) and block.number is not None:
                sides = [s.expr for s in block.sides if isinstance(s, Math) and s.values is None]
                assert is_clean(ledgers[0], *sides), sides


def test_dimensions_of_sums() -> None:
    """A number beside a length hides a length."""
    instant, phrases = next(_instants(next(p for p in FILES if p.stem == "falling-pole")))
    ledger = phrases.ledger
    length, m, g = (ledger.symbols[n] for n in ("l", "m", "g"))
    assert dimension_of(m * g, ledger) == FORCE
    assert dimension_of(m * length**2 / 12, ledger) == INERTIA
    with pytest.raises(Mixed):
        dimension_of(length + 1, ledger)
    assert is_clean(ledger, m * length**2 / 12)
    assert not is_clean(ledger, sp.Rational(2679, 100_000) * m)
    assert not is_clean(ledger, m * length, m * g)
    assert instant.instant.scene.bodies


def test_us_units_need_no_factors() -> None:
    """A slug is lbf s²/ft."""
    units = [coherent_unit(d, us=True) for d in (MASS, FORCE, INERTIA)]
    assert [u.text for u in units] == ["slug", "lbf", "slug*ft^2"]
    assert units[0].factor * coherent_unit(FORCE / MASS, us=True).factor == units[1].factor


@pytest.mark.parametrize(("name", "lines"), [
    ("kinematics/four-bar", ["ω_BC = 1.219/0.4729", "ω_DC = (0.2233 · 2.578 - 1.732)/0.3965"]),
    ("textbook/ex-2-09", ["ω_AB = -0.43094/0.4619", "α_AB = -0.05691/0.4619"]),
    ("textbook/ex-4-17", ["θ̇_2 = √(1.137/0.7708)"]),
])  # fmt: skip
def test_solutions_of_equations_in_numbers_have_their_numbers(name: str, lines: list[str]) -> None:
    blocks = narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]).blocks
    solved = [b.sides for b in blocks if isinstance(b, Equation) and len(b.sides) > 2]
    ends = [(math[0], math[-1]) for sides in solved if (math := [s for s in sides if isinstance(s, Math)])]
    told = [" = ".join(plain(s.expr, s.values) for s in pair) for pair in ends]
    assert set(lines) <= set(told)


RIVER = """\
title: Boat straight across a river
bodies: {raft: {particle: [0, 0]}, boat: {particle: [0, 0]}}
motion: [v(raft).x = 2 m/s, v(raft).y = 0, v(boat/raft).mag = 5 m/s, v(boat).x = 0]
states:
  start: [t = 0, v(boat).y > 0]
  landed: [y(boat) = 60 m]
find: {T: t @ landed}
"""


def test_a_prescribed_motion_that_is_read_off_has_no_law_of_forces(tmp_path: Path) -> None:
    file = tmp_path / "river.yaml"
    file.write_text(RIVER)
    page = Terminal(width=110).render(narrate(solve_and_compare(read(str(file)), None)[0]))
    assert "Newton" not in page
    assert "    y_boat = 4.583 t" in page
    assert "Newton" not in page_of_file("dog-that-runs-at-a-cyclist")


@pytest.mark.parametrize(("stem", "row"), [
    ("car-that-brakes-in-a-bend", "v_car = 60 ft/s"),
    ("car-that-brakes-in-a-bend", "v_car⁴ + a_car,t² = 100 in ft²/s⁴"),
    ("ball-in-a-forked-slot", "0.64 ω² = 4 in m²/s²"),
    ("gear-between-racks", "-2 r_g α_gear = -0.8 m/s²"),
])  # fmt: skip
def test_a_statement_in_numbers_has_its_unit(stem: str, row: str) -> None:
    path = next(p for p in PROBLEMS if p.stem == stem)
    assert row in " ".join(Terminal(200).render(narrate(worked(path)[0])).split())


def test_a_lever_arm_that_is_zero_but_for_rounding_leaves_nothing() -> None:
    """A weight straight above the pivot: 5 · 9.81 · 0.2 cos 90°."""
    path = next(p for p in PROBLEMS if p.stem == "exercise-4-35")
    assert "(3) ↺ ΣM_O: 0 = 0.4667 α in N·m" in " ".join(Terminal(200).render(narrate(worked(path)[0])).split())
