"""Parts of SymPy that no problem of mechanics needs, and parts of planar that few need, are loaded when something asks
for them, not before.

`import sympy` loads plane geometry, tensors, transforms, plots and the languages of other programs, and its first sum
loads the groups that order the indices of tensors: together a fifth of what a short page takes. A stand-in takes the
place of each of these modules. What it offers gets the real module once it is called, or looked into, or something is
asked whether it is an instance of it.

Functions that go by the types of their arguments are spared as much again: SymPy puts all kinds of arguments of one in
order with each that it adds, a twentieth of such a page, though most of these functions are never called.

From the modules of planar that are put off others take functions; who takes a class or a constant loads them at once.
"""

from __future__ import annotations

import importlib
import sys
from importlib.machinery import ModuleSpec, PathFinder
from importlib.util import module_from_spec
from types import ModuleType
from typing import Any

from planar_cli.seldom import SELDOM

IN_SYMPY = {
    "": "algebras combinatorics combinatorics.tensor_can discrete geometry interactive parsing plotting tensor",
    "integrals": "laplace transforms",
    "polys": "numberfields polyquinticconst ring_series",
    "printing": "glsl gtk julia maple mathematica mathml octave preview smtlib",
    "series": "formal fourier",
    "simplify": "hyperexpand",
    "solvers": "ode polysys",
}
DEFERRED = tuple(
    ".".join(("sympy", folder, name)).replace("..", ".") for folder in IN_SYMPY for name in IN_SYMPY[folder].split()
)
"""Modules of SymPy of which others take names as they are loaded, and that hardly a page uses; parents first."""
BY_TYPES = "sympy.multipledispatch"
"""The package for functions that go by the types of their arguments; it needs nothing else of SymPy."""

CLUTTER = 400_000
"""So many objects more are looked through for what nobody needs: most of what is made at a start lives to the end."""


def defer() -> None:
    """Let stand-ins take the places of these modules; without effect on SymPy where it is loaded, or is not there."""
    for name in SELDOM:
        if name not in sys.modules:
            sys.modules[name] = _StandIn(name, [])
    package = PathFinder.find_spec("sympy")
    if package is None or "sympy" in sys.modules:
        return
    for name in DEFERRED:
        folder = "/".join(name.split(".")[1:])
        sys.modules[name] = _StandIn(name, [f"{root}/{folder}" for root in package.submodule_search_locations or ()])
    _order_when_called(package)


def _order_when_called(package: ModuleSpec) -> None:
    """Let a function that goes by types put these in order when it is first called."""
    found = PathFinder.find_spec(BY_TYPES, package.submodule_search_locations)
    if found is None or found.loader is None:
        return
    sys.modules[BY_TYPES] = loaded = module_from_spec(found)
    found.loader.exec_module(loaded)
    dispatcher = loaded.dispatcher.Dispatcher
    warn = loaded.dispatcher.ambiguity_warn
    order, choose = dispatcher.reorder, dispatcher.dispatch
    waiting: dict[Any, Any] = {}

    def wait(self: Any, on_ambiguity: Any = warn) -> None:
        # As the import system does: by now SymPy is there, and `from sympy import *` takes the package from it.
        setattr(sys.modules["sympy"], BY_TYPES.rpartition(".")[2], loaded)
        # What one way of adding says to kinds of which none goes first, holds for all that were added before.
        waiting[self] = waiting.get(self, warn) if on_ambiguity is warn else on_ambiguity

    def chosen(self: Any, *types: Any) -> Any:
        while self in waiting:
            order(self, waiting.pop(self))
        return choose(self, *types)

    dispatcher.reorder, dispatcher.dispatch = wait, chosen


class _StandIn(ModuleType):
    """A module that is not loaded. A package has its folder, so that a module inside it can be loaded by itself."""

    def __init__(self, name: str, path: list[str]) -> None:
        super().__init__(name)
        if path:
            self.__path__ = path

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        if self.__name__ in SELDOM and not name.islower():
            # A class or a constant cannot wait.
            return getattr(loaded(self.__name__), name)
        # As the import system does: `from sympy import *` takes the module from its parent.
        parent, _, own = self.__name__.rpartition(".")
        if parent in sys.modules:
            vars(sys.modules[parent]).setdefault(own, self)
        return _Offered(self.__name__, name)


class _Offered:
    """What a stand-in offers under a name."""

    def __init__(self, module: str, name: str) -> None:
        self._module = module
        self._name = name
        self._found: Any = None

    def _real(self) -> Any:
        if self._found is None:
            self._found = getattr(loaded(self._module), self._name)
        return self._found

    def __call__(self, *values: Any, **options: Any) -> Any:
        return self._real()(*values, **options)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._real(), name)

    def __instancecheck__(self, thing: object) -> bool:
        return isinstance(thing, self._real())


def loaded(module: str) -> ModuleType:
    """The module itself, after those in which it is."""
    for name in (*DEFERRED, module):
        if f"{module}.".startswith(f"{name}.") and isinstance(sys.modules.get(name), _StandIn):
            del sys.modules[name]
            parent, _, own = name.rpartition(".")
            taken = getattr(sys.modules.get(parent), "__dict__", {}).get(own)
            importlib.import_module(name)
            if isinstance(taken, _Offered):
                # A function that its package takes from a module of the same name, such as `mathml`, stays what it is.
                setattr(sys.modules[parent], own, taken)
    return importlib.import_module(module)
