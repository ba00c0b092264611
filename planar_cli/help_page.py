"""`planar --help`, written without click: what one looks at most often comes at once.

The page is that of click's own formatter (a test compares them at several widths); the commands are the modules of the
folder `commands`, each with the first line of its docstring.
"""

from __future__ import annotations

import os
import sys

ABOUT = (
    "Worked solutions of planar dynamics problems, from small YAML files.",
    "`planar explain` tells how such a file is written.",
)
OPTIONS = (("--version", "Show the version and exit."), ("-h, --help", "Show this message and exit."))
WIDEST, NARROWEST = 78, 50


def page(width: int) -> str:
    """The page in lines of at most `width` characters."""
    lines = ["Usage: planar [OPTIONS] COMMAND [ARGS]..."]
    for paragraph in ABOUT:
        lines += ["", *(f"  {row}" for row in wrapped(paragraph, width - 2))]
    lines += ["", "Options:", *_rows(OPTIONS, width), "", "Commands:", *_rows(tuple(commands().items()), width)]
    return "\n".join(lines)


def commands() -> dict[str, str]:
    """The commands with what they do, read from the files without importing them."""
    folder = os.path.join(os.path.dirname(__file__), "commands")
    names = sorted(n[:-3] for n in os.listdir(folder) if n.endswith(".py") and not n.startswith("_"))
    return {name.replace("_", "-"): summary(os.path.join(folder, f"{name}.py")) for name in names}


def summary(path: str) -> str:
    """The first line of a module's docstring."""
    with open(path, encoding="utf-8") as file:
        return file.readline().strip().strip('"')


def wrapped(text: str, width: int) -> list[str]:
    """A text in lines of at most `width` characters, broken between words."""
    lines: list[str] = []
    for word in text.split():
        if lines and len(lines[-1]) + 1 + len(word) <= width:
            lines[-1] += f" {word}"
        else:
            lines.append(word)
    return lines


def _rows(entries: tuple[tuple[str, str], ...], width: int) -> list[str]:
    """Two columns, the second one wrapped."""
    first = max(len(name) for name, _ in entries) + 2
    found = []
    for name, text in entries:
        rows = wrapped(text, width - first - 2)
        found.append(f"  {name:<{first}}{rows[0]}")
        found += [" " * (first + 2) + row for row in rows[1:]]
    return found


def show() -> None:
    """Print the page to the width of the terminal."""
    try:
        columns = int(os.environ.get("COLUMNS", "0")) or os.get_terminal_size(sys.stdout.fileno()).columns
    except (ValueError, OSError):
        columns = WIDEST + 2
    print(page(max(min(columns - 2, WIDEST), NARROWEST)), flush=True)
