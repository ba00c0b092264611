"""Modules are loaded when something asks for them, and then they are what they always were."""

from __future__ import annotations

import ast
import subprocess
import sys

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
x, t, s, f = sympy.Symbol("x"), sympy.Symbol("t", positive=True), sympy.Symbol("s"), sympy.Function("f")
assert sympy.mathml(x) == sympy.printing.mathml(x) == sympy.printing.mathml(x)
assert sympy.octave_code(x**2) == "x.^2" and "<ci>x</ci>" in sympy.mathml(x)
assert sympy.dsolve(f(x).diff(x) - f(x), f(x)).rhs.subs(x, 0) == sympy.Symbol("C1")
assert sympy.laplace_transform(sympy.exp(-t), t, s, noconds=True) == 1 / (s + 1)
assert sympy.minimal_polynomial(sympy.sqrt(2), x) == x**2 - 2 and sympy.field_isomorphism(sympy.I, sympy.I)
assert sympy.diophantine(x + t) and sympy.solvers.diophantine(x + t)
assert sympy.Quaternion(0, 1, 0, 0)**2 == sympy.Quaternion(-1, 0, 0, 0) and x * sympy.Quaternion(1, 0, 0, 0)
assert sympy.IndexedBase("A")[1].base.label == sympy.Symbol("A") and not isinstance(x, sympy.Indexed)
assert sympy.Array([1, 2]).shape == (2,) and sympy.Matrix(sympy.Array([[1, 2], [3, 4]])).det() == -2
assert sympy.fps(sympy.exp(x)).truncate(2) == 1 + x + sympy.O(x**2) and sympy.fft([1, 2])[0] == 3
assert sympy.solve(x**5 - 5*x + 12, x) and sympy.solve([x**2 + s - 1, x - s], [x, s])
assert sympy.parse_expr("x + 1") == x + 1 and sympy.hyperexpand(sympy.hyper([], [], x)) == sympy.exp(x)
from sympy.solvers.ode.systems import dsolve_system
from sympy.tensor.array.expressions import ArraySymbol
from sympy.integrals.transforms import MellinTransform
"""

TAKEN = """
import sys
from planar_cli.later import defer
defer()
from planar_cli.calculus.polish import polish
assert not hasattr(sys.modules["planar_cli.calculus.polish"], "__file__")
from planar_cli.calculus.polish import GUARD
assert GUARD > 0 and hasattr(sys.modules["planar_cli.calculus.polish"], "__file__")
assert polish.__code__ is sys.modules["planar_cli.calculus.polish"].polish.__code__
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


@pytest.mark.parametrize("module", SELDOM)
def test_what_is_put_off_has_functions_by_their_names(module: str) -> None:
    """A name in small letters waits for its first call, so that it has to be that of a function."""
    tree = ast.parse((ROOT / f"{module.replace('.', '/')}.py").read_text())
    made = [t.id for node in tree.body if isinstance(node, ast.Assign) for t in node.targets if isinstance(t, ast.Name)]
    assert all(node.name.islower() for node in tree.body if isinstance(node, ast.FunctionDef))
    assert not [name for name in made if name.islower() and name != "__all__"]


def test_a_constant_loads_what_was_put_off() -> None:
    done = outcome(TAKEN)
    assert done.returncode == 0, done.stderr
