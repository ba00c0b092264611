"""Problem files with other names: every given, symbol, unknown, coordinate, point, surface, body, joint and load."""

from __future__ import annotations

import random
import re
from collections.abc import Iterable, Iterator
from typing import Any

import yaml

WORDS = ("title", "text", "source", "note", "answers", "variants", "figure")
NUMBERS = ("given", "symbols", "unknowns", "coordinates")
THINGS = ("points", "surfaces", "bodies")
UNITS = ("symbols", "unknowns", "coordinates")
"""Mappings whose values are units."""
TOKEN = re.compile(
    r"(?P<unit>(?<=[0-9)] )(?!in\b|cw\b|ccw\b|during\b|is\b|on\b|at\b)[A-Za-z1][A-Za-z0-9]*(?:[*/^][A-Za-z0-9]+)*)"
    r"|(?P<shown>\bin [A-Za-z0-9*/^]+$)"
    r"|(?P<number>\d+(?:\.\d+)?(?:e[-+]?\d+)?)"
    r"|(?P<part>\.(?:x|y|mag|angle|t|n|r|theta)\b(?! *\())"
    r"|(?P<name>[A-Za-z][A-Za-z0-9_]*)(?P<call> *\()?"
)
CALLS = frozenset(
    "sin cos tan asin acos atan sqrt exp log abs x y r v a theta omega alpha dot ddot coriolis rho IC path hodograph "
    "N friction reaction moment tension force mode mass I KE PE momentum H power work impulse heat path_length "
    "mean count reached period frequency stable along across".split()
)
NASTY = {
    "coordinates": ("x", "v_pos", "x_dot", "omega_0", "theta_b", "E", "phi_ddot"),
    "numbers": (
        *("x_0", "x_dot", "x_ddot", "v_pos_0", "omega", "alpha", "E", "t1", "F_a", "N_a", "I_a", "theta", "v_A_x", "S"),
        *("J_N_a", "a_A", "x_A", "y_A", "s_A", "k_1", "lambda", "theta_0", "t_0", "x_1", "delta", "beta", "Q", "e_a"),
    ),
    "things": ("A", "A_x", "a", "pos", "x_B", "E1", "b_0", "N_b", "omega_b", "t2", "dot_a", "v_c", "I_b", "A_y", "S_c"),
}


def scene_of(text: str) -> dict[str, Any]:
    """A file as a tree of text, without its words and answers."""
    whole: dict[str, Any] = yaml.load(text, Loader=yaml.BaseLoader)
    return _without_words(whole)


def _without_words(tree: dict[str, Any]) -> dict[str, Any]:
    kept = {key: value for key, value in tree.items() if key not in WORDS}
    for name, case in kept.get("cases", {}).items():
        kept["cases"][name] = _without_words(case)
    return kept


def written(scene: dict[str, Any]) -> str:
    return yaml.safe_dump(scene, sort_keys=False, width=1000)


# --- names -----------------------------------------------------------------------------------------------------------


def names_of(scene: dict[str, Any]) -> dict[str, list[str]]:
    """The names that the file makes, by what they are: coordinates, numbers, things."""
    found: dict[str, list[str]] = {"coordinates": [], "numbers": [], "things": []}
    for part in _parts(scene):
        found["coordinates"] += part.get("coordinates", {})
        found["numbers"] += [n for key in ("given", "symbols", "unknowns") for n in part.get(key, {}) if n != "g"]
        found["things"] += [n for key in THINGS for n in part.get(key, {})]
        for entry in (*part.get("joints", ()), *part.get("loads", ())):
            found["things"] += [body["name"] for body in entry.values() if isinstance(body, dict) and "name" in body]
    taken = _other_names(scene)
    return {kind: [n for n in dict.fromkeys(names) if n not in taken] for kind, names in found.items()}


def _parts(scene: dict[str, Any]) -> Iterator[dict[str, Any]]:
    yield scene
    yield from scene.get("cases", {}).values()


def _other_names(scene: dict[str, Any]) -> set[str]:
    """States, finds and cases keep their names, and the points that are called like one theirs."""
    found = set(scene.get("cases", {}))
    for part in _parts(scene):
        found |= {*part.get("states", {}), *part.get("find", {})}
    return found


def random_names(scene: dict[str, Any], seed: int) -> dict[str, str]:
    """Names of no meaning."""
    draw = random.Random(seed)
    made: dict[str, str] = {}
    for names in names_of(scene).values():
        for name in names:
            made.setdefault(name, f"{draw.choice('bcdhjkpquw')}{len(made)}{draw.choice('bcdhjkpquw')}")
    return made


def nasty_names(scene: dict[str, Any], seed: int) -> dict[str, str]:
    """Names that could be taken for symbols that a solver makes."""
    draw = random.Random(seed)
    other = _other_names(scene)
    made: dict[str, str] = {}
    for kind, names in names_of(scene).items():
        pool = [n for n in NASTY[kind] if n not in made.values() and n not in other]
        if kind != "coordinates":
            draw.shuffle(pool)
        for name in names:
            new = pool.pop(0) if pool else f"n_{len(made)}"
            made.setdefault(name, new)
    return made


# --- renaming --------------------------------------------------------------------------------------------------------


def renamed(scene: dict[str, Any], names: dict[str, str]) -> dict[str, Any]:
    """The same file with these names."""
    found: dict[str, Any] = {}
    for key, value in scene.items():
        if key == "cases":
            found[key] = {name: renamed(case, names) for name, case in value.items()}
        elif key in UNITS:
            found[key] = {names.get(n, n): unit for n, unit in value.items()}
        elif key in ("given", *THINGS):
            found[key] = {names.get(n, n): _inside(v, names) for n, v in value.items()}
        else:
            found[key] = _inside(value, names)
    return found


def _inside(node: Any, names: dict[str, str]) -> Any:
    if isinstance(node, dict):
        return {
            key: {names.get(n, n): _inside(v, names) for n, v in value.items()}
            if key == "distances"
            else _inside(value, names)
            for key, value in node.items()
        }
    if isinstance(node, list):
        return [_inside(value, names) for value in node]
    return _line(node, names)


def _line(text: str, names: dict[str, str]) -> str:
    """One line of mathematics, or one name."""

    def other(match: re.Match[str]) -> str:
        name, call = match["name"], match["call"] or ""
        if name is None or (call and name in CALLS and not (call == " (" and name in names)):
            return match[0]
        return names.get(name, name) + call

    return TOKEN.sub(other, text)


def shuffled(scene: dict[str, Any], seed: int) -> dict[str, Any]:
    """The same file with its mappings and lists in another order, where order has no meaning."""
    draw = random.Random(seed)
    found: dict[str, Any] = {}
    for key, value in _mixed(scene.items(), draw):
        if key == "cases":
            found[key] = {name: shuffled(case, seed) for name, case in value.items()}
        elif key in (*NUMBERS, *THINGS, "find"):
            found[key] = {n: _mixed_node(v, draw) for n, v in _mixed(value.items(), draw)}
        elif key in ("motion", "instant", "assume"):
            found[key] = _mixed(value, draw)
        elif key == "states":
            found[key] = {n: _mixed(v, draw) for n, v in value.items()}
        elif key in ("joints", "loads"):
            found[key] = [_mixed_node(v, draw) for v in _mixed(value, draw)]
        else:
            found[key] = value
    return found


def _mixed(entries: Iterable[Any], draw: random.Random) -> list[Any]:
    found = list(entries)
    draw.shuffle(found)
    return found


def _mixed_node(node: Any, draw: random.Random) -> Any:
    """Keys of one entry stand in any order; lists inside it (paths, places) mean their order."""
    if isinstance(node, dict):
        return {key: _mixed_node(value, draw) for key, value in _mixed(node.items(), draw)}
    return node
