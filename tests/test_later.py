"""Modules are loaded when something asks for them, and then they are what they always were."""

from __future__ import annotations

import ast
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
from conftest import ROOT

from planar_cli.later import DEFERRED
from planar_cli.seldom import SELDOM

TEXTS = {path: path.read_text() for path in sorted((ROOT / "planar_cli").rglob("*.py"))}
PAGE = f"""
import sys
from planar_cli.later import defer
defer()
from planar_cli.cli import run
assert run(["solve", "problems/textbook/ex-4-05.yaml"]) == 0
loaded = [name for name in {(*DEFERRED, *SELDOM)!r} if "_StandIn" != type(sys.modules[name]).__name__]
print(len(loaded) < {len(SELDOM) / 3}, [name for name in loaded if name.startswith("sympy")])
"""
ASKED = """
from planar_cli.later import defer
defer()
import sympy
assert sympy.sympify("2*x + sqrt(y)").free_symbols == set(sympy.symbols("x y"))
from sympy import *
from sympy.physics import units
assert sympy.simplify(sympy.sin(units.meter)**2 + sympy.cos(units.meter)**2) == 1
assert sympy.deg(sympy.pi / 3) == 60
from sympy.geometry import Point2D
from sympy.combinatorics import Permutation
assert sympy.Point(3, 4).distance(sympy.Point(0, 0)) == 5
assert isinstance(sympy.Point(1, 2), sympy.Point) and not isinstance(sympy.Symbol("x"), Point2D)
assert Permutation([1, 2, 0]).order() == 3 and Permutation.rmul(Permutation([1, 0]), Permutation([1, 0])).is_Identity
from sympy.tensor.tensor import TensorHead, TensorIndexType, TensorSymmetry, tensor_indices
index = TensorIndexType("L")
a, b = tensor_indices("a b", index)
head = TensorHead("A", [index] * 2, TensorSymmetry.fully_symmetric(-2))
assert head(a, b).canon_bp() == -head(b, a).canon_bp() and head(a, -a).canon_bp() == 0
from sympy.geometry import Circle
assert type(Circle) is type(sympy.Basic) and Circle(sympy.Point(0, 0), 2).area == 4 * sympy.pi
"""


def outcome(program: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False)


def test_a_page_needs_none_of_sympy_and_few_of_planar() -> None:
    done = outcome(PAGE)
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines()[-1] == "True []"


def test_what_asks_for_them_gets_them() -> None:
    done = outcome(ASKED)
    assert done.returncode == 0, done.stderr


CHOSEN = """
import sys
if sys.argv[1] == "later":
    from planar_cli.later import defer
    defer()
import gc
import sympy, sympy.sets.handlers.mul, sympy.sets.handlers.functions, sympy.assumptions.handlers.sets
from sympy.multipledispatch.dispatcher import Dispatcher
from sympy.combinatorics import Permutation
assert Permutation([0]).size == 1 and sympy.Point(0, 0).x == 0
assert sympy.Interval(0, 2).intersect(sympy.Interval(1, 3)) == sympy.Interval(1, 2) and sympy.Eq(sympy.S(1), 1)
every = [d for d in gc.get_objects() if isinstance(d, Dispatcher)]
for it in sorted(every, key=lambda d: (d.name, sorted(map(repr, d.funcs)))):
    it.dispatch(int)
    kinds = sorted({k for given in it.funcs for k in given}, key=lambda k: (k.__module__, k.__name__))
    pairs = [(a, b) for a in kinds for b in kinds] + [(a,) for a in kinds]
    print(it.name, [getattr(it.dispatch(*types), "__name__", "") for types in pairs])
    print([[k.__name__ for k in f] for f in sorted(it.funcs, key=repr)])
"""


def test_what_goes_by_types_is_chosen_as_ever() -> None:
    now, later = (
        subprocess.run([sys.executable, "-c", CHOSEN, when], cwd=ROOT, capture_output=True, text=True, check=False)
        for when in ("now", "later")
    )
    assert now.returncode == later.returncode == 0, now.stderr + later.stderr
    assert now.stdout == later.stdout
    assert now.stderr == later.stderr == ""


def path_of(module: str) -> Path:
    return ROOT / f"{module.replace('.', '/')}.py"


@cache
def functions_of(module: str) -> frozenset[str]:
    return frozenset(
        node.name for node in ast.parse(path_of(module).read_text()).body if isinstance(node, ast.FunctionDef)
    )


def at_once(node: ast.AST) -> Iterator[str]:
    """The names that are made use of while a module is loaded; one that stands in a table only waits there."""
    if isinstance(node, ast.FunctionDef | ast.Lambda):
        own = node.decorator_list if isinstance(node, ast.FunctionDef) else []
        yield from (n for part in (*own, *node.args.defaults) for n in at_once(part))
        return
    if isinstance(node, ast.AnnAssign):
        yield from at_once(node.value) if node.value else ()
        return
    if isinstance(node, ast.Name):
        yield node.id
    waiting = isinstance(node, ast.Tuple | ast.List)
    for part in ast.iter_child_nodes(node):
        yield from () if waiting and isinstance(part, ast.Name) else at_once(part)


@pytest.mark.parametrize(
    "path", [p for p, text in TEXTS.items() if any(f"{m} import" in text for m in SELDOM)], ids=lambda p: p.stem
)
def test_others_take_functions_alone_from_what_is_put_off(path: Path) -> None:
    tree = ast.parse(TEXTS[path])
    taken = {
        name.name: node.module
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and node.module in SELDOM
        for name in node.names
    }
    assert all(name in functions_of(module) for name, module in taken.items())
    assert not taken.keys() & set(at_once(tree)), "they are not used while a module is loaded"


def test_nothing_takes_them_as_a_whole() -> None:
    folders = {module.rpartition(".")[0] for module in SELDOM}
    for text in (t for t in TEXTS.values() if any(f"from {folder} import" in t for folder in folders)):
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.ImportFrom) and node.module in folders:
                assert not {f"{node.module}.{n.name}" for n in node.names} & set(SELDOM)
