"""Systems of numbers: who solves the rows that are printed gets the roots that are printed below them."""

from __future__ import annotations

import re
from decimal import Decimal, localcontext
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from conftest import PROBLEMS
from page_rules import PAGES, WIDTH
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.document.blocks import Equation, Paragraph, Table
from planar_cli.report.in_numbers.linear_system import DEPENDENT, SENSITIVE, Row, solved, system
from planar_cli.report.page.narrate import narrate

ROOT_LINE = re.compile(r"^ *(?:together:)? +(\S+) = (-?[\d.]+)(?: \S+)?$")
LIKEWISE = re.compile(r"(\S+) = (-?[\d.]+) rad/s²")
TERM = re.compile(r"([+-]?) ?(?:([\d.]+) )?([^\W\d]\S*)")
MARK = "together:"


def _files() -> list[Path]:
    """The problems whose page has several roots of one system of numbers."""
    names = {
        p.name.removesuffix(".solution.txt")
        for p in PAGES
        if re.search(r"(?:N·m|\n  \(\d+\) [ \d.-]+)\n(?:\n|  Rows.*\n)*  together:", p.read_text(encoding="utf-8"))
    }
    return [p for p in PROBLEMS if f"{p.parent.name}-{p.stem}" in names]


FILES = _files()


def _systems(page: str) -> list[tuple[list[dict[str, float]], list[float], dict[str, str]]]:
    """Of each system its rows, its right sides, and the roots as they are printed."""
    found = []
    lines = page.splitlines()
    for at in (i for i, row in enumerate(lines) if row.strip().startswith(MARK)):
        above = lines[:at]
        while above and (not above[-1].strip() or above[-1].startswith("  Rows")):
            above.pop()
        rows, right = _of_tables(above)
        if not rows:
            rows, right = _of_equations(above)
        if rows:
            found.append((rows, right, _roots(lines[at:], {x for row in rows for x in row})))
    return found


def _of_tables(above: list[str]) -> tuple[list[dict[str, float]], list[float]]:
    """The rows of the last table, with what stands in one before it of the same rows."""
    heads = [i for i, row in enumerate(above) if row.startswith("  row ")]
    if not heads:
        return [], []
    body = above[heads[-1] + 2 :]
    rows, right = _of_table(above[heads[-1]], body)
    before = heads[-1] - len(body) - 3
    if before in heads:
        first = [row.split()[1:] for row in above[before + 2 : heads[-1] - 1]]
        names = above[before].split()[1:]
        rows = [{**dict(zip(names, map(float, own), strict=True)), **row} for own, row in zip(first, rows, strict=True)]
    return rows, right


def _of_table(head: str, body: list[str]) -> tuple[list[dict[str, float]], list[float]]:
    names = head.split("right side", maxsplit=1)[0].split()[1:]
    cells = [row.split() for row in body]
    if not all(len(own) == len(names) + 2 for own in cells):
        return [], []
    return [dict(zip(names, map(float, own[1:-1]), strict=True)) for own in cells], [float(own[-1]) for own in cells]


def _of_equations(above: list[str]) -> tuple[list[dict[str, float]], list[float]]:
    block = []
    while above and re.match(r" {2}\(\d+\):| {4}\S", above[-1]):
        block.insert(0, above.pop())
    rows, right = [], []
    for text in re.split(r"\(\d+\):", " ".join(x.strip() for x in block))[1:]:
        left, number = re.sub(r" {2,}in \S+", "", text).split("=")
        rows.append({m[3]: float((m[1] or "") + (m[2] or "1")) for m in TERM.finditer(left.strip())})
        right.append(float(number.split()[0]))
    return rows, right


def _roots(below: list[str], names: set[str]) -> dict[str, str]:
    found: dict[str, str] = {}
    for row in below:
        for name, number in (m.groups() for m in [ROOT_LINE.match(row)] if m):
            found.setdefault(name, number)
        for name, number in LIKEWISE.findall(row):
            found.setdefault(name, number)
        if names <= found.keys():
            return {s: found[s] for s in names}
    raise AssertionError(f"no roots of {sorted(names - found.keys())}")


def test_pages_have_systems() -> None:
    assert len(FILES) >= 3


@pytest.mark.parametrize("path", FILES, ids=lambda p: p.stem)
def test_printed_rows_give_the_printed_roots(path: Path) -> None:
    systems = _systems(Terminal(WIDTH).render(narrate(worked(path)[0])))
    assert systems
    for rows, right, roots in systems:
        names = list(roots)
        found = np.linalg.solve([[row.get(s, 0.0) for s in names] for row in rows], right)
        for x, text in zip(found, roots.values(), strict=True):
            last = 10.0 ** -len(text.partition(".")[2])
            assert abs(x - float(text)) <= 0.51 * last, (path.stem, x, text)


X, Y, Z = sp.symbols("x y z")


def _row(number: int, *of: str) -> tuple[int, Row, tuple[()]]:
    *coefficients, right = map(Decimal, of)
    return number, Row(dict(zip((X, Y, Z), coefficients, strict=False)), right), ()


def test_four_figures_are_enough_for_rows_that_differ() -> None:
    rows = [_row(1, "2", "1", "5"), _row(2, "1", "-1", "1")]
    (table,) = system(rows, (X, Y), {X: Decimal(2), Y: Decimal(1)}, 4)
    assert isinstance(table, Table)
    assert len(table.rows) == 2


def test_rows_nearly_alike_have_more_figures() -> None:
    rows = [_row(1, "1.000012", "1", "2.000012"), _row(2, "1", "1", "2")]
    said, _ = system(rows, (X, Y), {X: Decimal(1), Y: Decimal(1)}, 4)
    assert isinstance(said, Paragraph)
    assert SENSITIVE in str(said)


@pytest.mark.parametrize("figures", [11, 40])
def test_more_figures_than_rows_mostly_have(figures: int) -> None:
    with localcontext(prec=60):
        rows = [_row(1, "1.00012", "1", "1.33341"), _row(2, "1", "1", "1.33333")]
        x = Decimal("0.00008") / Decimal("0.00012")
        said, *_ = system(rows, (X, Y), {X: x, Y: Decimal("1.33333") - x}, figures)
    assert DEPENDENT not in str(said)


def test_rows_that_only_differ_far_behind_are_called_dependent() -> None:
    rows = [_row(1, "1.0000000000012", "1", "3.0000000000012"), _row(2, "1", "1", "3")]
    said, _ = system(rows, (X, Y), {X: Decimal(1), Y: Decimal(2)}, 4)
    assert DEPENDENT in str(said)


def test_too_wide_a_table_is_equations() -> None:
    names = sp.symbols("a:20")
    rows = [
        (i, Row({s: Decimal(1 if j == i else 0) + Decimal("0.1234567") for j, s in enumerate(names)}, Decimal(3)), ())
        for i in range(20)
    ]
    roots = solved([[r.coefficients[s] for s in names] for _, r, _ in rows], [r.number for _, r, _ in rows])
    assert roots is not None
    told = system(rows, names, dict(zip(names, roots, strict=True)), 4)
    assert all(isinstance(b, Equation) for b in told[-20:])


def test_too_wide_a_table_is_two_where_that_is_shorter() -> None:
    names = sp.symbols("a:9")
    rows = [
        (i, Row({s: 1 / (Decimal(i + j + 1) + Decimal("0.01")) for j, s in enumerate(names)}, Decimal(3)), ())
        for i in range(9)
    ]
    with localcontext(prec=60):
        roots = solved([[r.coefficients[s] for s in names] for _, r, _ in rows], [r.number for _, r, _ in rows])
        assert roots is not None
        tables = [b for b in system(rows, names, dict(zip(names, roots, strict=True)), 4) if isinstance(b, Table)]
    assert [len(b.header) for b in tables] == [6, 6]
    assert all(len(b.rows) == 9 for b in tables)
    assert [row[0] for row in tables[0].rows] == [row[0] for row in tables[1].rows]


def test_no_roots_of_rows_that_say_the_same() -> None:
    one = [Decimal(1), Decimal(1)]
    assert solved([one, one], [Decimal(1), Decimal(2)]) is None


def test_terms_stand_in_one_order_of_unknowns() -> None:
    (path,) = (p for p in FILES if p.stem == "chain-5")
    page = Terminal(300).render(narrate(worked(path)[0]))
    names = ["α_OA", "α_AB", "α_BC", "α_CD", "α_DE"]
    rows = [row.split("=")[1] for row in page.splitlines() if re.match(r" +\(\d+\).* in (?:m/s²|N·m)$", row)]
    assert len(rows) == 6
    assert re.search(rf"\n  row +{' +'.join(names)} +", page)
    for row in rows:
        found = re.findall(r"α_\w\w", row)
        assert found == sorted(found, key=names.index)
