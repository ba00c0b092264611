"""Command lines read without click: the same values as click's, and everything unusual left to it."""

from __future__ import annotations

from pathlib import Path

import click
import pytest
from test_cli import GOOD, imported, imports_of

from planar_cli import by_click, cli
from planar_cli.options import Command

MOVING = """plane: vertical
points: {P: [0, 0]}
bodies: {P: {particle: P, mass: 1 kg}}
states: {1: [t = 0, at rest], 2: [t = 1 s]}
find: {y: y(P) @ 2}
"""


def command_of(name: str) -> tuple[Command, click.Command]:
    """A command as it is declared, and as click has it."""
    declared = cli._declared([name])
    made = by_click.cli.get_command(click.Context(by_click.cli), name)
    assert declared is not None
    assert made is not None
    return declared, made


@pytest.mark.parametrize(
    "line",
    [
        "solve a.yaml",
        "solve a.yaml -",
        "solve --figures 6 a.yaml --method energy --compare b.yaml",
        "solve --format=json -o out.json a.yaml --timeout 5 --timeout 0",
        "solve a.yaml --digits 30 --effects --verbose --audience lesson --why=a=b",
        "check a --jobs 3 --format json --timeout=1e3",
        "simulate a.yaml --until 10 --stop y(P)=0 --stop x(P)=0 -q v=v(P).x --quantity y(P) --at 1 --at 2",
        "simulate a.yaml --rows 5 --tolerance 1e-6 --integrator rk4 --step 0.1 --set m=2 --case b --without drag",
        "simulate a.yaml --output csv --file out.csv --effects",
    ],
)
def test_values_are_those_of_click(line: str) -> None:
    name, *args = line.split()
    declared, made = command_of(name)
    assert declared.read(args) == made.make_context(name, list(args)).params


@pytest.mark.parametrize(
    "line",
    [
        "solve",
        "solve --help",
        "solve a.yaml -h",
        "solve a.yaml --figures",
        "solve a.yaml --figures 0",
        "solve a.yaml --figures 41",
        "solve a.yaml --figures six",
        "solve a.yaml --method magic",
        "solve a.yaml --fig 3",
        "solve a.yaml --compare=yes",
        "solve a.yaml -oout.txt",
        "solve a.yaml -o=out.txt",
        "solve -- -a.yaml",
        "simulate a.yaml --tolerance nan",
        "simulate a.yaml --tolerance 1",
        "simulate a.yaml --until -5",
    ],
)
def test_what_is_unusual_is_left_to_click(line: str) -> None:
    name, *args = line.split()
    assert command_of(name)[0].read(args) is None


def test_wrong_usage_is_told_as_click_does(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "a.yaml"
    file.write_text(GOOD)
    told = []
    # The second line is one that click reads.
    for args in (["--why", "y", str(file)], ["--why", "y", "--", str(file)]):
        assert cli.run(["solve", *args]) == 2
        told.append(capsys.readouterr().err)
    assert told[0] == told[1]
    assert told[0].startswith("Usage: planar solve [OPTIONS] FILES...\nTry 'planar solve --help' for help.\n\nError: ")


def test_a_simulation_imports_what_it_needs(tmp_path: Path) -> None:
    file = tmp_path / "a.yaml"
    file.write_text(MOVING)
    names = imported("simulate", str(file)) - imports_of("-c", "pass")
    assert not names & {"click", "sympy", "numpy", "rich", "planar_cli.by_click"}
