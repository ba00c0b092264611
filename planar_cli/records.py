"""Dataclasses with slots that are cheap to define.

`@dataclass(frozen=True, slots=True)` compiles six methods for each class, 0.45 ms at every start: with some hundreds of
classes that is more than the rest of importing them. Here `__init__` alone is compiled, once so many objects are made
that it pays, and the others are shared. What comes out is a dataclass like any other for `fields`, `replace`, `match`
and `pickle`: its fields are told by a twin that the standard library makes when they are first asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import MISSING, Field, FrozenInstanceError, dataclass, field, fields
from operator import attrgetter
from typing import Any, TypeVar, dataclass_transform

T = TypeVar("T")
RARE = 40
"""To compile `__init__` takes as long as so many calls of one that looks its fields up, and most records are few."""


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def record(cls: type[T]) -> type[T]:
    """Make a class a frozen dataclass with slots, which is compared and hashed by its fields."""
    return _made(cls, frozen=True)


@dataclass_transform(field_specifiers=(field,))
def changing(cls: type[T]) -> type[T]:
    """Make a class a dataclass with slots whose fields may change; it is compared by them, and cannot be hashed."""
    return _made(cls, frozen=False)


def _made(cls: type[T], frozen: bool) -> type[T]:
    if cls.__bases__ != (object,):
        # What a class inherits from others, the standard library sees to.
        return dataclass(frozen=frozen, slots=True)(cls)
    own = dict(cls.__dict__)
    names = [n for n, kind in own.get("__annotations__", {}).items() if not _of_class(kind)]
    written = {n: own.pop(n) for n in names if n in own}
    special = {n: f for n, f in written.items() if isinstance(f, Field)}
    del own["__dict__"], own["__weakref__"]
    shared = FROZEN if frozen else SHARED
    shown = _shown([n for n in names if n not in special or special[n].repr])
    space = {**shared, **shown, **_comparisons([n for n in names if n not in special or special[n].compare]), **own}
    if not frozen:
        space["__hash__"] = own.get("__hash__")
    space["__slots__"] = tuple(names)
    space.setdefault("__match_args__", tuple([n for n in names if n not in special or special[n].init]))
    made: Any = type(cls.__name__, (object,), space)
    made.__qualname__ = cls.__qualname__
    if "__init__" not in own:
        made.__init__ = _first_time(made, names, written, frozen)
    made.__dataclass_fields__ = _Told("__dataclass_fields__", made, cls, frozen)
    made.__dataclass_params__ = _Told("__dataclass_params__", made, cls, frozen)
    ours: type[T] = made
    return ours


def _field(written: Mapping[str, Any], name: str) -> Field[Any]:
    """What was written of a field."""
    value = written.get(name, MISSING)
    if isinstance(value, Field):
        return value
    plain: Field[Any] = field(default=value)
    return plain


def _of_class(kind: object) -> bool:
    """Does an annotation tell something of the class, not a field?"""
    return isinstance(kind, str) and kind.startswith(("ClassVar", "typing.ClassVar"))


class _Told:
    """What the standard library knows of a dataclass, when it is first asked for."""

    def __init__(self, name: str, made: type, written: type, frozen: bool) -> None:
        self.name, self.made, self.written, self.frozen = name, made, written, frozen

    def __get__(self, owner: object, kind: type | None = None) -> Any:
        # Without one, the standard library takes long to write one from the signature.
        self.written.__doc__ = self.written.__doc__ or self.written.__qualname__
        twin: Any = dataclass(init=False, repr=False, eq=False)(self.written)
        # Told only now: the methods of a class that is frozen from the start would be compiled for it alone.
        twin.__dataclass_params__.frozen, twin.__dataclass_params__.eq = self.frozen, True
        for name in ("__dataclass_fields__", "__dataclass_params__"):
            setattr(self.made, name, getattr(twin, name))
        return getattr(twin, self.name)


def _first_time(made: Any, names: Sequence[str], written: Mapping[str, Any], frozen: bool) -> Callable[..., None]:
    """`__init__`, which is compiled when it has been called so often that it pays, or is called in a wrong way."""
    members: dict[str, Field[Any]] = {}
    left = RARE
    # Most records are made from their fields in order; the last ones may have values of their own.
    plain = not any(isinstance(value, Field) for value in written.values()) and not hasattr(made, "__post_init__")
    defaults = [written.get(n) for n in names]
    fewest = sum(n not in written for n in names)

    def initialize(self: Any, *args: Any, **named: Any) -> None:
        nonlocal left
        left -= 1
        if plain and not named and fewest <= len(args) <= len(names) and left > 0:
            for name, value in zip(names, (*args, *defaults[len(args) :]), strict=True):
                object.__setattr__(self, name, value)
            return
        members.update({} if members else {n: _field(written, n) for n in names})
        if left > 0 and _enter(self, members, args, named):
            return
        made.__init__ = _init(made, members, frozen)
        made.__init__(self, *args, **named)

    return initialize


def _enter(owner: Any, members: Mapping[str, Field[Any]], args: Sequence[Any], named: Mapping[str, Any]) -> bool:
    """Set all fields; False: these are not the right parameters."""
    values = dict(zip([n for n, f in members.items() if f.init], args, strict=False))
    if len(values) < len(args) or not named.keys().isdisjoint(values):
        return False
    values.update(named)
    number = 0
    for name, f in members.items():
        if f.init and name in values:
            number, value = number + 1, values[name]
        elif f.default is not MISSING:
            value = f.default
        elif f.default_factory is not MISSING:
            value = f.default_factory()
        elif f.init:
            return False
        else:
            continue
        object.__setattr__(owner, name, value)
    if number < len(values):
        return False
    if hasattr(owner, "__post_init__"):
        owner.__post_init__()
    return True


def _init(cls: type, members: dict[str, Field[Any]], frozen: bool) -> Callable[..., None]:
    """`__init__` with the fields as parameters, in their order."""
    known: dict[str, Any] = {"_set": object.__setattr__, "_made": MISSING}
    parameters, lines = ["self"], []
    for name, f in members.items():
        value, parameter, own = name, name, f"_of_{name}"
        if f.default is not MISSING:
            known[own] = f.default
            value, parameter = name if f.init else own, f"{name}={own}"
        elif f.default_factory is not MISSING:
            known[own] = f.default_factory
            value, parameter = f"{own}() if {name} is _made else {name}" if f.init else f"{own}()", f"{name}=_made"
        elif not f.init:
            # `__post_init__` makes it.
            continue
        parameters += [parameter] if f.init else []
        lines.append(f" _set(self, {name!r}, {value})" if frozen else f" self.{name} = {value}")
    if hasattr(cls, "__post_init__"):
        lines.append(" self.__post_init__()")
    exec(f"def __init__({', '.join(parameters)}):\n" + "\n".join(lines or [" pass"]), known)
    made: Callable[..., None] = known["__init__"]
    made.__qualname__ = f"{cls.__qualname__}.__init__"
    return made


def _comparisons(names: Sequence[str]) -> dict[str, Callable[..., Any]]:
    """Two records are equal where they are of one class and all their fields are."""
    values: Callable[[object], tuple[Any, ...]] = attrgetter(*names) if len(names) > 1 else _each(names)

    def equal(self: object, other: object) -> bool:
        return values(self) == values(other) if other.__class__ is self.__class__ else NotImplemented

    def hashed(self: object) -> int:
        return hash(values(self))

    return {"__eq__": equal, "__hash__": hashed}


def _each(names: Sequence[str]) -> Callable[[object], tuple[Any, ...]]:
    """What `attrgetter` is for two names and more."""
    return lambda owner: tuple(getattr(owner, n) for n in names)


def _shown(names: Sequence[str]) -> dict[str, Callable[..., str]]:
    """What a record looks like to a programmer: its class and its fields."""

    def shown(self: object) -> str:
        return f"{self.__class__.__qualname__}({', '.join([f'{n}={getattr(self, n)!r}' for n in names])})"

    return {"__repr__": shown}


def _set(self: object, name: str, value: object) -> None:
    raise FrozenInstanceError(f"cannot assign to field {name!r}")


def _delete(self: object, name: str) -> None:
    raise FrozenInstanceError(f"cannot delete field {name!r}")


def _state(self: Any) -> list[Any]:
    """What is pickled."""
    return [getattr(self, f.name) for f in fields(self)]


def _restore(self: Any, state: Sequence[Any]) -> None:
    for f, value in zip(fields(self), state, strict=True):
        object.__setattr__(self, f.name, value)


SHARED: dict[str, Any] = {"__getstate__": _state, "__setstate__": _restore}
FROZEN: dict[str, Any] = {**SHARED, "__setattr__": _set, "__delattr__": _delete}
