"""The shape of the code, held by reading it: import arrows, budgets of size, nothing silenced or left undone."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest
from conftest import ROOT

PACKAGE = ROOT / "planar_cli"
MODULES = sorted(PACKAGE.rglob("*.py"))
TESTS = sorted((ROOT / "tests").glob("*.py"))
STAGES = ("problem", "motion", "simulate", "equation", "calculus", "solve", "replay", "homework", "report", "figures")
SHELVES = ("joints", "loads", "principles", "integrators", "formats", "exports", "commands")
COMMON = {"base_units", "errors", "greek", "mathml", "near", "records", "registry", "typeset", "unit_hints", "units"}
# What members of a shelf may import, beside errors, records, units and their own shelf's base and private modules.
MEMBERS_SEE = {
    "joints": {"problem"},
    "loads": {"problem"},
    "principles": {"problem", "equation"},
    "integrators": set[str](),
    "formats": {"report", "mathml"},
    "exports": {"report", "homework"},
}
MOST_LINES, LONGEST_FUNCTION = 400, 60


def id_of(path: Path) -> str:
    return str(path.relative_to(ROOT))


def parts_of(path: Path) -> tuple[str, ...]:
    """The module's name below the package: ("solve", "run")."""
    parts = path.relative_to(PACKAGE).with_suffix("").parts
    return parts[:-1] if parts[-1] == "__init__" else parts


def imports(path: Path) -> Iterator[tuple[str, ...]]:
    """Every import of our own modules, also inside functions: ("joints", "pin")."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            for alias in node.names:
                if alias.name.split(".")[0] == "planar_cli":
                    yield tuple(alias.name.split(".")[1:])
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: a relative import"
            whole = (node.module or "").split(".")
            if whole[0] == "planar_cli":
                for alias in node.names:
                    below = (*whole[1:], alias.name)
                    place = PACKAGE.joinpath(*below)
                    yield below if place.is_dir() or place.with_suffix(".py").exists() else tuple(whole[1:])


def is_member(target: tuple[str, ...]) -> bool:
    """A module of a shelf that registers something: a class with a `kind`, or a command."""
    if len(target) < 2 or target[0] not in SHELVES or target[1] == "base" or target[1].startswith("_"):
        return False
    if target[0] == "commands":
        return True
    tree = ast.parse((PACKAGE / target[0] / f"{target[1]}.py").read_text(encoding="utf-8"))
    classes = [node for node in tree.body if isinstance(node, ast.ClassDef)]
    fields = [f.target for c in classes for f in c.body if isinstance(f, ast.AnnAssign)]
    return any(isinstance(f, ast.Name) and f.id == "kind" for f in fields)


@pytest.mark.parametrize("path", MODULES, ids=id_of)
def test_nobody_imports_a_member_by_name(path: Path) -> None:
    ours = parts_of(path)
    private = len(ours) > 1 and ours[0] in SHELVES and ours[1].startswith("_")
    named = [t for t in imports(path) if is_member(t) and not (private and t[0] == ours[0])]
    assert not named


@pytest.mark.parametrize("path", [p for p in MODULES if parts_of(p)[:1] and parts_of(p)[0] in STAGES], ids=id_of)
def test_stages_import_to_the_left(path: Path) -> None:
    stage = parts_of(path)[0]
    allowed = {*STAGES[: STAGES.index(stage) + 1], *COMMON}
    wrong = []
    for target in imports(path):
        contract = len(target) > 1 and target[0] in SHELVES and target[1] == "base"
        if target and target[0] not in allowed and not contract:
            wrong.append(".".join(target))
    assert not wrong


def reached(start: tuple[str, ...], graph: dict[tuple[str, ...], set[tuple[str, ...]]]) -> set[tuple[str, ...]]:
    """Everything that a module imports, directly or by a chain."""
    found: set[tuple[str, ...]] = set()
    waiting = [start]
    while waiting:
        new = graph[waiting.pop()] - found
        found |= new
        waiting += new
    return found


def test_no_file_imports_what_imports_it() -> None:
    """Also not for type checking or inside a function, and not by a chain of others."""
    names = {parts_of(path) for path in MODULES}
    graph = {parts_of(path): {t for t in imports(path) if t in names} for path in MODULES}
    assert not sorted(".".join(name) for name in names if name in reached(name, graph))


@pytest.mark.parametrize("path", [p for p in MODULES if parts_of(p)[:1] == ("report",)], ids=id_of)
def test_print_sees_only_the_trace_of_a_motion(path: Path) -> None:
    hidden = {("solve", f) for f in ("regimes", "impulsive", "between", "following", "curves")}
    trace = {("solve", "between", f) for f in ("trace", "oscillation_trace")}
    assert {t for t in imports(path) if t[:2] in hidden} <= trace


@pytest.mark.parametrize("path", [p for p in MODULES if parts_of(p)[:1] and parts_of(p)[0] in MEMBERS_SEE], ids=id_of)
def test_members_see_little(path: Path) -> None:
    shelf = parts_of(path)[0]
    allowed = {*MEMBERS_SEE[shelf], "errors", "records", "units", shelf}
    assert not [".".join(t) for t in imports(path) if t[0] not in allowed]


@pytest.mark.parametrize("name", sorted(COMMON))
def test_the_common_modules_stand_alone(name: str) -> None:
    assert not [t for t in imports(PACKAGE / f"{name}.py") if t[0] not in COMMON]


@pytest.mark.parametrize("path", MODULES, ids=id_of)
def test_budgets(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert text.count("\n") <= MOST_LINES
    long = [
        f"{node.name}: {node.end_lineno - node.lineno + 1} lines"
        for node in ast.walk(ast.parse(text))
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
        and node.end_lineno is not None
        and node.end_lineno - node.lineno + 1 > LONGEST_FUNCTION
    ]
    assert not long


@pytest.mark.parametrize("path", [*MODULES, *TESTS], ids=id_of)
def test_nothing_is_silenced_or_left_undone(path: Path) -> None:
    # In two pieces each, so that this very file passes.
    marks = ["TO" + "DO", "FIX" + "ME", "Not" + "ImplementedError", "type:" + " ignore", "no" + "qa", "mark." + "xfail"]
    text = path.read_text(encoding="utf-8")
    assert not [mark for mark in marks if mark in text]


@pytest.mark.parametrize("path", [p for p in MODULES if parts_of(p)[:1] == ("solve",)], ids=id_of)
def test_no_fault_of_arithmetic_is_swallowed(path: Path) -> None:
    """Formulas without a value are told by `NoValue`; any other error of arithmetic is a fault of the program."""
    caught = [n for n in ast.walk(ast.parse(path.read_text(encoding="utf-8"))) if isinstance(n, ast.ExceptHandler)]
    names = {x.id for n in caught if n.type is not None for x in ast.walk(n.type) if isinstance(x, ast.Name)}
    assert not names & {"ArithmeticError", "Exception", "BaseException", "AssertionError", "KeyError"}


@pytest.mark.parametrize("path", MODULES, ids=id_of)
def test_every_module_says_what_it_is(path: Path) -> None:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    assert not tree.body or ast.get_docstring(tree)


def test_the_top_level_holds_nothing_else() -> None:
    allowed = {"pyproject.toml", "README.md", "LICENSE", "problems", "tests", "planar_cli", "build"}
    found = {p.name for p in ROOT.iterdir() if not p.name.startswith(".") and p.suffix != ".egg-info"}
    assert found <= allowed


def calls(path: Path) -> Iterator[ast.Call]:
    """Every call of a plain name."""
    nodes = ast.walk(ast.parse(path.read_text(encoding="utf-8")))
    return (n for n in nodes if isinstance(n, ast.Call) and isinstance(n.func, ast.Name))


@pytest.mark.parametrize("path", MODULES, ids=id_of)
def test_drawn_numbers_and_values_are_kept_apart(path: Path) -> None:
    """Only valuations make a `Settled` number, and no other module makes a valuation with definitions anew: it would
    forget what was drawn.
    """
    if parts_of(path) in (("equation", "exact"), ("equation", "ledger")):
        return
    made = [(n.func.id, len(n.args)) for n in calls(path) if isinstance(n.func, ast.Name)]
    assert not [n for n, count in made if n in ("Settled", "Sample") or (n == "Valuation" and count > 1)]
