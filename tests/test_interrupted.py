"""Ctrl-C while modules are loaded: every command ends quietly, with the exit status 130."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from planar_cli.registry import modules

FILE = str(Path(__file__).parents[1] / "problems" / "motion" / "car-three-phases.yaml")
CHILD = """
import os, signal, sys
loaded = sys.argv.pop(1)
# Who is started in the background inherits that the signal is ignored.
signal.signal(signal.SIGINT, signal.default_int_handler)
class Finder:
    def find_spec(self, name, path=None, target=None):
        if name == loaded:
            try:
                os.kill(os.getpid(), signal.SIGINT)
            except BaseException:
                pass  # as a module does that asks whether it can have another
sys.meta_path.insert(0, Finder())
from planar_cli.__main__ import main
main()
"""


def interrupted(loaded: str, *line: str) -> tuple[int, str, str]:
    """How a command ends that hears Ctrl-C as this module is loaded."""
    ended = subprocess.run(
        [sys.executable, "-c", CHILD, loaded, *line], capture_output=True, text=True, check=False, timeout=60
    )
    return ended.returncode, ended.stdout.strip(), ended.stderr.strip()


@pytest.mark.parametrize("command", modules("commands"))
def test_every_command(command: str) -> None:
    assert interrupted(f"planar_cli.commands.{command}", command, FILE) == (130, "", "")


@pytest.mark.parametrize("loaded", ["planar_cli.cli", "planar_cli.help_page", "planar_cli.problem.structure", "sympy"])
def test_every_part(loaded: str) -> None:
    line = ["--help"] if loaded == "planar_cli.help_page" else ["solve", FILE]
    assert interrupted(loaded, *line) == (130, "", "")
