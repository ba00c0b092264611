"""Terminals with ASCII alone: everything that a page prints has letters there, and lines are laid out with them."""

from __future__ import annotations

import io
import json

import pytest
from conftest import ROOT
from worked import GOLDEN, worked

from planar_cli import cli
from planar_cli.formats.terminal import Terminal
from planar_cli.plain_letters import ascii_of, is_poor, of_dots
from planar_cli.report.page.narrate import narrate

PAGES = sorted(GOLDEN.rglob("*.txt"))
SPOOL = ROOT / "problems" / "textbook" / "ex-4-05.yaml"


def test_every_page_has_letters() -> None:
    for path in PAGES:
        text = path.read_text(encoding="utf-8")
        told = ascii_of(text)
        assert told.isascii(), (path, sorted({c for c in told if not c.isascii()}))
        assert told.count("?") == text.count("?"), path


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("θ̇_1 = 3 rad/s ↺", "theta_dot_1 = 3 rad/s ccw"),
        ("ẍ + ω² x = 0", "x_ddot + omega^2 x = 0"),
        ("v = √(2 g h) = √3 m/s", "v = sqrt(2 g h) = sqrt(3) m/s"),
        ("1.235×10⁻⁶ N·m", "1.235x10^-6 N*m"),
        ("↺ ΣM_C: 2π r² ⇒ x¹ᐟ²", "ccw Sum M_C: 2 pi r^2 => x^(1/2)"),
        ("30° ± 2°, Δt ≈ 5 s", "30 deg +/- 2 deg, Delta_t ~ 5 s"),
        ("Müller → Genève", "Mueller -> Geneve"),
    ],
)
def test_what_stands_for_a_letter(text: str, told: str) -> None:
    assert ascii_of(text) == told


@pytest.mark.parametrize(("dots", "letter"), [(0x00, " "), (0x09, "'"), (0x12, "-"), (0xC0, "."), (0x47, "|")])
def test_a_cell_of_dots(dots: int, letter: str) -> None:
    assert of_dots(dots) == letter


@pytest.mark.parametrize("width", [110, 80, 40])
def test_lines_are_laid_out_with_them(width: int) -> None:
    text = Terminal(width, plain=True).render(narrate(worked(SPOOL)[0]))
    assert text.isascii()
    assert "Sum M_C" in text
    assert max(map(len, text.splitlines())) <= width


class Stream(io.StringIO):
    def __init__(self, encoding: str, tty: bool) -> None:
        super().__init__()
        self.told, self.tty = encoding, tty

    @property
    def encoding(self) -> str:
        return self.told

    def isatty(self) -> bool:
        return self.tty


@pytest.mark.parametrize(
    ("encoding", "tty", "env", "poor"),
    [
        ("utf-8", True, {"TERM": "xterm-256color"}, False),
        ("utf-8", False, {"TERM": "dumb"}, False),
        ("utf-8", True, {"TERM": "dumb"}, True),
        ("utf-8", True, {"TERM": "linux"}, True),
        ("utf-8", True, {"TERM": "vt100"}, True),
        ("ascii", False, {}, True),
        ("iso8859-1", True, {"TERM": "xterm"}, True),
        ("utf-8", False, {"LC_ALL": "C"}, True),
        ("utf-8", False, {"LC_ALL": "C", "PYTHONIOENCODING": "utf-8"}, False),
        ("utf-8", False, {"LC_ALL": "C.UTF-8"}, False),
    ],
)
def test_who_can_do_no_better(
    encoding: str, tty: bool, env: dict[str, str], poor: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("TERM", "LC_ALL", "PYTHONIOENCODING", "PYTHONUTF8"):
        monkeypatch.delenv(name, raising=False)
    for name, value in env.items():
        monkeypatch.setenv(name, value)
    assert is_poor(Stream(encoding, tty)) == poor


def test_commands_print_so(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setenv("LC_ALL", "C")
    monkeypatch.delenv("PYTHONIOENCODING", raising=False)
    monkeypatch.delenv("PYTHONUTF8", raising=False)
    for args in (["solve", str(SPOOL)], ["explain", "quantities"], ["solve", "no-such-file.yaml"]):
        cli.run(args)
        told = capsys.readouterr()
        assert (told.out + told.err).isascii()
    assert cli.run(["solve", str(SPOOL), "--format", "json"]) == 0
    # Data for programs keep their letters.
    assert json.loads(capsys.readouterr().out)


def test_a_pipe_is_as_wide_as_columns_says(monkeypatch: pytest.MonkeyPatch) -> None:
    for told, width in (("72", 72), ("300", 120), ("5", 20), ("", 110), ("0", 110), ("wide", 110)):
        monkeypatch.setenv("COLUMNS", told)
        assert Terminal.on(Stream("utf-8", False)).width == width
