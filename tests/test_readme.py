"""The README: its console blocks print what it shows, its files can be read, and it names every command.

`PLANAR_UPDATE=1 pytest tests/test_readme.py` writes the outputs anew.
"""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys

import click
import pytest
from conftest import ROOT

from planar_cli import by_click
from planar_cli.problem.structure import load_text

README = ROOT / "README.md"
CONSOLE = re.compile(r"```console\n\$ (?P<command>[^\n]+)\n(?P<output>.*?)```", re.DOTALL)
YAML = re.compile(r"```yaml\n(.*?)```", re.DOTALL)
INSTALLS = "python3 -m venv .venv && .venv/bin/pip install -q "
# What a clock says is no part of what a command says.
SECONDS = re.compile(r'"seconds": [\d.]+')


def readme() -> str:
    return README.read_text(encoding="utf-8")


def printed(command: str) -> str:
    """What the planar command at the end of a line prints, run from the top of the repository."""
    words = shlex.split(command.rpartition("&& ")[2])
    assert words[0] in ("planar", ".venv/bin/planar"), command
    env = {k: v for k, v in os.environ.items() if k not in ("FORCE_COLOR", "PLANAR_DEBUG")}
    run = subprocess.run(
        [sys.executable, "-m", "planar_cli", *words[1:]], cwd=ROOT, capture_output=True, text=True, check=False, env=env
    )
    assert run.stderr == ""
    return SECONDS.sub('"seconds": 0.1', run.stdout)


@pytest.mark.parametrize("command", [m["command"] for m in CONSOLE.finditer(readme())])
def test_console(command: str) -> None:
    output = printed(command)
    if os.environ.get("PLANAR_UPDATE"):
        replaced = CONSOLE.sub(
            lambda m: f"```console\n$ {command}\n{output}```" if m["command"] == command else m[0], readme()
        )
        README.write_text(replaced, encoding="utf-8")
    (shown,) = [m["output"] for m in CONSOLE.finditer(readme()) if m["command"] == command]
    assert output == shown


@pytest.mark.parametrize("text", YAML.findall(readme()))
def test_files_can_be_read(text: str) -> None:
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong


def test_two_commands_install_by_themselves() -> None:
    """The one that solves comes first, the one that tests second; .ci/run takes them from here."""
    lines = [line.removeprefix("$ ") for line in readme().splitlines() if INSTALLS in line]
    assert len(lines) == 2
    assert lines[0].endswith(".venv/bin/planar solve problems/textbook/ex-4-05.yaml")
    assert lines[1].endswith(".venv/bin/python -m pytest -n auto --dist loadfile")


def test_every_command_is_in_the_table() -> None:
    for name in by_click.cli.list_commands(click.Context(by_click.cli)):
        assert f"| `planar {name}" in readme()


def test_links_lead_somewhere() -> None:
    for target in re.findall(r"\]\(([^)#:]+)\)", readme()):
        assert (ROOT / target).exists(), target


def test_every_folder_of_problems_is_in_the_table_with_its_count() -> None:
    """`PLANAR_UPDATE=1` puts the counts right."""
    rows = re.findall(r"^\| (`[a-z` -]+`) \| (.*) \((\d+(?:, \d+)*)\) \|$", readme(), re.MULTILINE)
    counted = {folder: len(list((ROOT / "problems" / folder).glob("*.yaml"))) for folder in folders(rows)}
    assert sorted(counted) == sorted(p.name for p in (ROOT / "problems").iterdir() if p.is_dir())
    for names, words, numbers in rows:
        right = ", ".join(str(counted[name]) for name in names.strip("`").split("` `"))
        if os.environ.get("PLANAR_UPDATE"):
            README.write_text(readme().replace(f"{words} ({numbers})", f"{words} ({right})"), encoding="utf-8")
            continue
        assert numbers == right, names


def folders(rows: list[tuple[str, str, str]]) -> list[str]:
    """The folders that the rows of the table name."""
    return [name for names, _, _ in rows for name in names.strip("`").split("` `")]
