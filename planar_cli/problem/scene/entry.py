"""What an entry of `joints` and one of `loads` have in common, beside the keys of their kinds.

- `kind` is the word in the file; the fields declared with `key(...)` are its YAML keys and its part of the JSON Schema.
- `choices` names the groups of keys of which exactly one is written.
- `strikes`: it acts only in a blow, between a state and one just after it.
- `name` is the entry's own `name:`; else that of its point; else that of its first body. Reading a file settles it.
- `during` is the span of states in which the entry acts; None: always.
- `mark` is the place of the entry in the file.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from planar_cli.errors import Mark
from planar_cli.problem.scene.keys import Choice
from planar_cli.problem.scene.setting import Setting
from planar_cli.problem.scene.sketches import Sketch


@dataclass(frozen=True, slots=True, kw_only=True)
class Entry:
    """A joint or a load; the module's docstring tells its fields."""

    kind: ClassVar[str]
    choices: ClassVar[tuple[Choice, ...]] = ()
    strikes: ClassVar[bool] = False
    quantities: ClassVar[tuple[str, ...]] = ()
    """Quantities of the language that may be asked of this kind and not of every other: N, friction, tension, mode."""

    nouns: ClassVar[tuple[str, ...]] = ()
    """Words by which such an entry is called beside its kind: a rope is a cord too."""

    name: str
    during: tuple[str, str] | None
    mark: Mark

    @property
    def derived(self) -> frozenset[str]:
        """Keys whose value was made of that of others, which have their own dimensions."""
        return frozenset()

    def passes_through(self, names: frozenset[str]) -> str | None:
        """The point through which its force on a particle of these names always passes, where it does not move itself;
        "": it has no force; None: there is no such point.
        """
        return None

    @classmethod
    def phrase(cls, name: str) -> str:
        """How one of this kind and name is called in a sentence: "the rope AB", "the spring", "the left cord"."""
        said = name.split("_")
        return f"the {' '.join(said)}" if {cls.kind, *cls.nouns}.intersection(said) else f"the {cls.kind} {name}"

    @property
    def called(self) -> str:
        """How this one is called in a sentence."""
        return self.phrase(self.name)

    def attachments(self) -> tuple[tuple[str, str], ...]:
        """Pairs (point, body or surface): the points that belong to a body because the entry names them together."""
        return ()

    def tangents(self) -> tuple[tuple[str, str, str], ...]:
        """Triples (point, body, other point): of those cords that run straight from the rim to a point, how."""
        return ()

    def rims(self) -> tuple[tuple[str, str], ...]:
        """Pairs (point, body): where a cord leaves a rim. Such a point keeps its direction from the body's centre."""
        return ()

    def sketch(self, scene: Setting) -> tuple[Sketch, ...]:
        """How it looks in a drawing; nothing where the bodies and surfaces show it, as they do a contact."""
        return ()
