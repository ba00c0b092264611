"""Records are dataclasses like those of the standard library."""

from __future__ import annotations

import copy
import pickle
from dataclasses import FrozenInstanceError, dataclass, field, fields, is_dataclass, replace

import pytest

from planar_cli import records
from planar_cli.records import changing, record


@record
class Ours:
    """Two fields that must be given, and others."""

    a: int
    b: tuple[int, ...]
    c: list[int] = field(default_factory=list, compare=False)
    d: float = 1.5
    e: int = field(init=False, compare=False, repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "e", self.a + 1)


@record
class One:
    """A single field."""

    a: int


@record
class Nothing:
    """No field."""


@dataclass(frozen=True, slots=True)
class More(One):
    """What derives from a record is the standard library's."""

    b: int = 2


@changing
class Changing:
    """What is kept while something is worked out."""

    a: int
    b: list[int] = field(default_factory=list)
    c: int = field(default=3, init=False)
    d: list[int] = field(default_factory=list, init=False, repr=False)

    def __post_init__(self) -> None:
        self.a += 1


@changing
class MoreChanging(Changing):
    """What derives from it is the standard library's."""

    e: int = 5


def test_it_is_made_from_its_fields() -> None:
    first, second = Ours(1, (2, 3)), Ours(b=(2, 3), a=1, d=1.5)
    assert first == second
    assert hash(first) == hash(second)
    assert first.c is not second.c
    assert first.e == 2
    assert repr(first) == "Ours(a=1, b=(2, 3), c=[], d=1.5)"
    assert replace(first, a=4).e == 5
    assert [f.name for f in fields(Ours)] == ["a", "b", "c", "d", "e"]
    assert is_dataclass(Ours)


def test_records_of_different_classes_differ() -> None:
    assert One(1) != More(1)
    assert One(1) != Ours(1, ())
    assert {One(1): "one"}[One(1)] == "one"
    assert Nothing() == Nothing()
    assert More(1) == More(1, 2)


def test_it_can_not_be_changed() -> None:
    one = One(1)
    with pytest.raises(FrozenInstanceError):
        one.a = 2
    with pytest.raises(FrozenInstanceError):
        del one.a
    with pytest.raises(TypeError):
        One()
    assert not hasattr(one, "__dict__")


def test_what_changes() -> None:
    first, second = Changing(1), Changing(a=1, b=[2])
    assert repr(first) == "Changing(a=2, b=[], c=3)"
    assert (first.d, first.d is second.d) == ([], False)
    second.b = []
    assert first == second
    second.c += 1
    assert first != second
    assert replace(second, b=[7]).b == [7]
    assert copy.deepcopy(second) == second == pickle.loads(pickle.dumps(second))
    assert [f.name for f in fields(second)] == ["a", "b", "c", "d"]
    assert MoreChanging(1).e == 5
    with pytest.raises(TypeError):
        hash(first)
    with pytest.raises(AttributeError):
        first.f = 1


def test_it_is_matched_copied_and_pickled() -> None:
    first = Ours(1, (2, 3))
    match first:
        case Ours(a, b, d=d):
            assert (a, b, d) == (1, (2, 3), 1.5)
        case _:
            pytest.fail("not matched by its fields")
    assert pickle.loads(pickle.dumps(first)) == copy.deepcopy(first) == copy.copy(first) == first


def test_many_are_made_like_few() -> None:
    """`__init__` is compiled on the way, or where it is called in a wrong way."""
    for k in range(2 * records.RARE):
        assert Few(k, y=[k]) == Few(k, [k], 3)
        assert (Few(k).y, Few(k).w) == ([], k + 1)


@record
class Few:
    """Of every kind of field one."""

    x: int
    y: list[int] = field(default_factory=list)
    z: int = 3
    w: int = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "w", self.x + 1)


@record
class Wrong:
    """Made in no right way at first."""

    x: int
    y: int = 0


@pytest.mark.parametrize(
    ("args", "named"), [((), {}), ((1, 2, 3), {}), ((1,), {"x": 2}), ((1,), {"z": 2}), ((), {"y": 2})]
)
def test_wrong_parameters_are_refused(args: tuple[int, ...], named: dict[str, int]) -> None:
    with pytest.raises(TypeError, match="Wrong"):
        Wrong(*args, **named)
    assert Wrong(1, y=2) == Wrong(x=1, y=2)
