"""The manual: pages of kinds, of the language and of error codes, read from the docstrings of what implements them."""

from __future__ import annotations

import ast
import inspect
from dataclasses import is_dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from planar_cli.errors import PlanarError
from planar_cli.near import nearest

if TYPE_CHECKING:
    from planar_cli.problem.scene.keys import KeySpec

PAGES = Path(__file__).parent / "problem" / "pages"
SHELVES = ("joints", "loads", "principles", "integrators", "homework.mistakes", "homework.exports")
# The order in which a newcomer reads.
ORDER = ("language", "sections", "names_units", "points_surfaces", "coordinates", "bodies", "joints", "loads")
AFTER = ("quantities", "statements_instant", "motion_laws", "states", "blows_impacts", "finds", "spans", "methods")
BEYOND = ("oscillations", "paths_hodographs", "simulate_accuracy", "figures_documents_watch")
LAST = ("cases", "answers", "variants", "homework_sets_submissions", "checks_confirmed", "examples", "pitfalls")


@cache
def pages() -> dict[str, str]:
    """The pages of the language, each topic with its text; the module `points_surfaces` serves both words."""
    ordered = sorted(PAGES.glob("[a-z]*.py"), key=_place)
    return {topic: _docstring(path) for path in ordered for topic in path.stem.split("_")}


def _place(path: Path) -> int:
    order = (*ORDER, *AFTER, *BEYOND, *LAST)
    return order.index(path.stem) if path.stem in order else len(order)


def _docstring(path: Path) -> str:
    return ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or ""


@cache
def kinds(shelf: str) -> dict[str, str]:
    """The kinds of a shelf, each with the first line of its manual page."""
    from planar_cli.registry import members

    return {kind: inspect.cleandoc(member.__doc__ or "").partition("\n")[0] for kind, member in members(shelf).items()}


def topics() -> str:
    """All that can be explained."""
    lines = ["planar explain TOPIC prints one of these pages.", "", "The problem file, in the order of reading:"]
    seen: dict[str, list[str]] = {}
    for topic, page in pages().items():
        seen.setdefault(page, []).append(topic)
    named = {", ".join(names): page.partition("\n")[0] for page, names in seen.items()}
    width = max(22, *(len(names) + 2 for names in named))
    lines += [f"  {names:<{width}}{page}" for names, page in named.items()]
    for shelf in SHELVES:
        width = max(22, *(len(kind) + 2 for kind in kinds(shelf)))
        lines += ["", f"Kinds of {shelf.rpartition('.')[2]}:"]
        lines += [f"  {kind:<{width}}{line}" for kind, line in kinds(shelf).items()]
    return "\n".join([*lines, "", "Codes of messages: PL101, PL102, … as printed with each error."])


def explanation(topic: str) -> str:
    """The page of a topic. Raises PlanarError, with the nearest topic, for an unknown one."""
    code = topic.upper()
    word = topic.lower()
    if code in codes():
        return f"{code}\n\n{codes()[code]}"
    for shelf in SHELVES:
        if word in kinds(shelf):
            return kind_page(shelf, word)
    if word in pages():
        return pages()[word]
    known = [*pages(), *(kind for shelf in SHELVES for kind in kinds(shelf)), *codes()]
    near = nearest(topic, known, 0.5) or nearest(code, known, 0.5)
    hint = f"did you mean '{near}'?" if near else "`planar explain` lists the topics"
    raise PlanarError(f"there is no page '{topic}'; {hint}")


def codes() -> dict[str, str]:
    """Every diagnostic code with its explanation."""
    from planar_cli.problem.codes.codes import CODES
    from planar_cli.problem.codes.codes_engine import CODES_ENGINE
    from planar_cli.problem.codes.codes_homework import CODES_HOMEWORK
    from planar_cli.problem.codes.codes_motion import CODES_MOTION
    from planar_cli.problem.codes.codes_scene import CODES_SCENE
    from planar_cli.problem.codes.codes_solve import CODES_SOLVE
    from planar_cli.problem.codes.codes_structure import CODES_STRUCTURE

    return {**CODES, **CODES_STRUCTURE, **CODES_SCENE, **CODES_SOLVE, **CODES_MOTION, **CODES_ENGINE, **CODES_HOMEWORK}


def kind_page(shelf: str, kind: str) -> str:
    """The manual page of a kind: its docstring, and its keys as they are declared."""
    from planar_cli.registry import members

    member = members(shelf)[kind]
    keys = [f"    {spec.name:<16}{'' if spec.required else '(optional) '}{spec.doc}" for spec in _keys(member)]
    common = [
        f"    {'name':<16}(optional) what to call it; else it is called by its point, else by its first body",
        f"    {'during':<16}(optional) `1->2`: acts only between these states",
    ]
    said = inspect.cleandoc(member.__doc__ or "")
    return f"{kind}: {said}" + ("\n\nKeys\n" + "\n".join(keys + common) if keys else "")


def _keys(member: type) -> tuple[KeySpec, ...]:
    """The YAML keys of a member; a principle has none."""
    from planar_cli.problem.scene.keys import keys_of

    return keys_of(member) if is_dataclass(member) else ()
