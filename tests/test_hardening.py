"""Strings from outside and every channel by which they leave; files, devices and links; numbers that are none."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from planar_cli import cli
from planar_cli.problem.nodes.show import harmless, spreadsheet_cell
from planar_cli.problem.structure import load
from planar_cli.simulate.accuracy_report import Told, as_csv, as_markdown

STEERING = "\x9b31m\u202e\x1b[31m"
"""C1, a turn of the reading direction, ESC."""
FALL = """title: Fall
plane: vertical
points: {P: [0, 0]}
bodies: {b: {particle: P, mass: MASS}}
states:
  1: [at rest]
  2: [END]
find: {v: FIND}
"""


def file_of(folder: Path, mass: str = "2 kg", end: str = "t = 2 s", find: str = "v(b).y @ 2", more: str = "") -> str:
    path = folder / "fall.yaml"
    path.write_text(FALL.replace("MASS", mass).replace("END", end).replace("FIND", find) + more, encoding="utf-8")
    return str(path)


def complaints(path: str) -> list[tuple[str, str]]:
    return [(d.code, d.message) for d in load(path)[1]]


# --- links, pipes, devices, full disks --------------------------------------------------------------------------------


@pytest.mark.parametrize("command", ["solve", "check", "validate", "simulate", "accuracy", "key", "list"])
def test_no_excerpt_of_what_a_link_leads_to(command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "secret").write_text("root: SECRET\n", encoding="utf-8")
    (tmp_path / "link.yaml").symlink_to(tmp_path / "secret")
    assert cli.run([command, str(tmp_path / "link.yaml")]) == cli.BAD
    told = capsys.readouterr()
    assert "link.yaml" in told.err
    assert "SECRET" not in told.err + told.out


def test_standard_input_is_no_file_of_that_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "<stdin>").write_text("another: text\n", encoding="utf-8")
    run = subprocess.run(
        [sys.executable, "-m", "planar_cli", "solve", "-"],
        input="foo: 3\n",
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == cli.BAD
    assert "unknown key 'foo'" in run.stderr
    assert "another" not in run.stderr


@pytest.mark.parametrize("kind", ["pipe", "link to a pipe", "folder"])
def test_output_replaces_no_pipe_and_no_folder(kind: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pipe, target = tmp_path / "pipe", tmp_path / "out"
    os.mkfifo(pipe)
    if kind == "link to a pipe":
        target.symlink_to(pipe)
    elif kind == "folder":
        target.mkdir()
    else:
        target = pipe
    assert cli.run(["solve", "-o", str(target), file_of(tmp_path)]) == cli.BAD
    assert "cannot write" in capsys.readouterr().err
    assert pipe.is_fifo()
    assert target.is_symlink() or target.is_fifo() or target.is_dir()


@pytest.mark.parametrize("output", ["/dev/null", "/dev/stdout", "/proc/self/fd/1"])
def test_output_replaces_nothing_among_the_devices(output: str, tmp_path: Path) -> None:
    before = os.lstat(output).st_mode
    assert cli.run(["solve", "-o", output, file_of(tmp_path)]) == cli.BAD
    assert os.lstat(output).st_mode == before


PRINTING = (
    "--help",
    "solve FILE",
    "check FILE",
    "list FILE",
    "validate FILE",
    "explain rope",
    "schema",
    "solve FILE --format html",
    "draw FILE -o FOLDER",
    "draw FILE --format text",
)


@pytest.mark.parametrize("args", PRINTING)
def test_a_full_disk_is_told(args: str, tmp_path: Path) -> None:
    full = Path("/dev/full")
    if not full.is_char_device():
        return
    words = line_of(args, tmp_path)
    with full.open("w") as stream:
        run = subprocess.run(
            [sys.executable, "-m", "planar_cli", *words], stdout=stream, stderr=subprocess.PIPE, text=True, check=False
        )
    assert run.returncode == cli.BAD
    assert run.stderr == "planar: cannot write to standard output: No space left on device\n"


@pytest.mark.parametrize("args", PRINTING)
def test_a_reader_who_has_left_is_told_nothing(args: str, tmp_path: Path) -> None:
    reader, writer = os.pipe()
    os.close(reader)
    command = [sys.executable, "-m", "planar_cli", *line_of(args, tmp_path)]
    run = subprocess.run(command, stdout=writer, stderr=subprocess.PIPE, text=True, check=False)
    os.close(writer)
    assert (run.returncode, run.stderr) == (cli.SOLVED, "")


def line_of(args: str, folder: Path) -> list[str]:
    """A line for a file and a folder of its own."""
    named = {"FILE": file_of(folder), "FOLDER": str(folder)}
    return [named.get(word, word) for word in args.split()]


def test_closed_streams(tmp_path: Path) -> None:
    command = f"'{sys.executable}' -m planar_cli solve '{file_of(tmp_path)}' >&- 2>&-"
    assert subprocess.run(command, shell=True, check=False).returncode == cli.SOLVED


# --- characters that steer --------------------------------------------------------------------------------------------


def test_what_steers_becomes_escapes() -> None:
    assert harmless(f"a\nb{STEERING}ü") == "a\nb\\x9b31m\\u202e\\x1b[31mü"
    assert harmless("a\nb", kept="") == "a\\x0ab"
    assert harmless("1\N{NO-BREAK SPACE}m\N{EM SPACE}\u3000") == "1\N{NO-BREAK SPACE}m\N{EM SPACE}\u3000"
    assert harmless("\u200b\u2060\ufeff\u2028\u00ad") == r"\u200b\u2060\ufeff\u2028\xad"
    cells = {
        "=1": "'=1",
        "+1": "+1",
        "-v": "'-v",
        "@x": "'@x",
        "v-w": "v-w",
        "\uff1d1": "'\uff1d1",
        " =1": " '=1",
        "a; =b": "a; '=b",
        "-4.38 rad/s cw": "-4.38 rad/s cw",
        "-2,5 m/s^2; -3": "-2,5 m/s^2; -3",
        "+1.2e-3 N*m": "+1.2e-3 N*m",
        "-1+cmd|' /C calc'!A0": "'-1+cmd|' /C calc'!A0",
        "-1 (m/s)": "'-1 (m/s)",
        "-2*v_0": "'-2*v_0",
        "-3; =1": "-3; '=1",
    }
    assert {text: spreadsheet_cell(text) for text in cells} == cells


def test_other_ends_of_lines_count_as_in_editors(tmp_path: Path) -> None:
    path = tmp_path / "lines.yaml"
    path.write_text("title: a\u2028b\x0bc\r\n\rtext: \x85\n", encoding="utf-8", newline="")
    assert [(d.mark.line, d.mark.column) for d in load(str(path))[1]] == [(1, 9), (1, 11), (3, 7)]


@pytest.mark.parametrize("command", ["simulate --rows 2", "accuracy --tolerance 1e-3", "solve", "list"])
def test_a_title_is_one_line(command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    title = 'title: "Fall\\nAnswer  v = 0\\n\\n::error::no"'
    path = Path(file_of(tmp_path))
    path.write_text(path.read_text(encoding="utf-8").replace("title: Fall", title), encoding="utf-8")
    assert cli.run([*command.split(), str(path)]) == cli.SOLVED
    assert "Fall Answer v = 0 ::error::no" in capsys.readouterr().out


@pytest.mark.parametrize("command", ["solve", "simulate --rows 2", "check", "list", "validate --format text"])
def test_no_commands_in_logs(
    command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("GITHUB_ACTIONS", "true")
    title = 'title: "::error::no ##[group]no"'
    right = Path(file_of(tmp_path)).read_text(encoding="utf-8").replace("title: Fall", title)
    for name, text in {"right": right, "::error::bad": "foo: 3\n"}.items():
        Path(f"{name}.yaml").write_text(text, encoding="utf-8")
        cli.run([*command.split(), f"{name}.yaml"])
    told = capsys.readouterr()
    assert "##[" not in told.out + told.err
    assert not any(line.lstrip().startswith("::") for line in (told.out + told.err).split("\n"))


COMMANDS = (
    "solve",
    "solve --format json",
    "solve --format markdown",
    "check",
    "check --format json",
    "validate",
    "validate --format json",
    "validate --format github",
    "list",
    "list --format json",
    "key",
    "simulate",
    "simulate --output json",
    "simulate --output csv",
)


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize("what", ["right", "wrong", "missing", "folder"])
def test_names_of_files(command: str, what: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / f"x{STEERING}\n.yaml"
    if what == "folder":
        path.mkdir()
    elif what != "missing":
        text = Path(file_of(tmp_path)).read_text(encoding="utf-8").replace("title: Fall\n", "")
        path.write_text(text if what == "right" else "foo: 3\n", encoding="utf-8")
    cli.run([*command.split(), str(path)])
    told = capsys.readouterr()
    for text in (told.out, told.err):
        assert all(c == "\n" or c.isprintable() for c in text), text
    if "json" in command and told.out:
        assert json.loads(told.out)["schema_version"] == 1


WORDS = (
    "WORD",
    "--WORD",
    "explain WORD",
    "schema WORD",
    "solve --why WORD FILE",
    "solve -o /WORD/x FILE",
    "simulate --case WORD FILE",
    "simulate --set WORD=3 FILE",
    "simulate --stop WORD FILE",
    "simulate -q WORD FILE",
    "simulate --until WORD FILE",
    "simulate --without WORD FILE",
    "accuracy --plot WORD FILE",
    "accuracy --step WORD FILE",
)


@pytest.mark.parametrize("line", WORDS)
def test_words_of_the_command_line(line: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    args = [w.replace("WORD", f"w{STEERING}").replace("FILE", file_of(tmp_path)) for w in line.split()]
    assert cli.run(args) == cli.BAD
    told = capsys.readouterr()
    assert all(c == "\n" or c.isprintable() for c in told.err + told.out), told


def test_titles_in_tables() -> None:
    told = Told("=HYPERLINK(1)|<script>$\n", failed="no [motion](x)")
    assert as_csv([told]).count("\n") == 1
    assert (
        as_markdown(told)
        == "## =HYPERLINK(1)\\|\\<script\\>\\$\\\\x0a\n\n- The motion can not be followed: no \\[motion\\](x)\n"
    )


# --- numbers that are none --------------------------------------------------------------------------------------------

NO_NUMBERS = {
    "sqrt(-1)*1 kg": "the root of the negative number -1 is no real number",
    "log(0)*1 kg": "log of 0 is no number: its argument is more than zero",
    "asin(2)*1 kg": "asin of 2 is no real number: its argument lies in -1 to 1",
    "tan(90 deg)*1 kg": "tan of a right angle is infinite",
    "(-8)^(1/3)*1 kg": "a power of the negative number -8 is no real number",
    "infinity": "`infinity` is no number to calculate with",
    "atan(infinity)*1 kg": "`infinity` is no number to calculate with",
}


@pytest.mark.parametrize("mass", NO_NUMBERS)
def test_values_are_real_and_finite(mass: str, tmp_path: Path) -> None:
    assert complaints(file_of(tmp_path, mass)) == [("PL217", f"the mass of the body b: {NO_NUMBERS[mass]}")]
    named = file_of(tmp_path, "k", more=f"given: {{k: {mass}}}\n")
    assert complaints(named) == [("PL217", f"the value of k: {NO_NUMBERS[mass]}")]


@pytest.mark.parametrize("angle", ["exp(100)*1 deg", "1e12 deg", "-3e9 rad", "atan(sin(3e9))"])
def test_angles_have_a_direction(angle: str, tmp_path: Path) -> None:
    loads = f"loads:\n  - force: {{body: b, magnitude: 3 N, angle: {angle}}}\n"
    ((code, said),) = complaints(file_of(tmp_path, more=loads))
    assert code == "PL207"
    assert said.endswith("rad leaves no digits for its direction")
    assert complaints(file_of(tmp_path, more=loads.replace(angle, "1e9 deg"))) == []


@pytest.mark.parametrize("mass", ["sqrt(0.3 - 0.1 - 0.2)*1 kg + 2 kg", "(1e20 + 1)/1e20*1 kg", "acos(cos(0.3))*1 kg"])
def test_rounding_refuses_nothing(mass: str, tmp_path: Path) -> None:
    assert complaints(file_of(tmp_path, mass)) == []


@pytest.mark.parametrize(
    ("mass", "said"),
    [
        ("1e60 kg", "the mass of the body b is about 10^60 in m, kg, s: too large to work with"),
        ("1e-60 kg", "the mass of the body b is about 10^-60 in m, kg, s: too small to work with"),
        ("exp(exp(9))*1 kg", "the mass of the body b: a number beyond 10^300 comes up here"),
    ],
)
def test_sizes_leave_digits(mass: str, said: str, tmp_path: Path) -> None:
    assert complaints(file_of(tmp_path, mass)) == [("PL207", said)]


def powers(count: int) -> str:
    return ", ".join(f"k{i}: k{i - 1}^12" for i in range(1, count + 1))


def test_growth_through_names(tmp_path: Path) -> None:
    numbers = file_of(tmp_path, more=f"given: {{k0: 2, {powers(40)}}}\n")
    assert complaints(numbers)[0] == ("PL207", "the value of k3 is about 10^520 in m, kg, s: too large to work with")
    letters = file_of(tmp_path, more=f"given: {{{powers(40)}}}\nsymbols: {{k0: 1}}\n")
    assert complaints(letters) == [("PL207", "the value of k3 is of degree 1728 in letters, more than 300")]


@pytest.mark.parametrize("backwards", [False, True])
@pytest.mark.parametrize("count", [100, 3000])
def test_chains_of_names(count: int, backwards: bool, tmp_path: Path) -> None:
    names = ["k1: 2 kg", *(f"k{i}: k{i - 1}" for i in range(2, count + 1))]
    text = ", ".join(reversed(names) if backwards else names)
    found = complaints(file_of(tmp_path, f"k{count}", more=f"given: {{{text}}}\n"))
    said = "the value of k101 is told by a chain of more than 100 names, signs and brackets"
    assert found == ([] if count == 100 else [("PL207", said)])


def test_chains_of_points(tmp_path: Path) -> None:
    rows = "".join(f", P{i}: {{from: P{i - 1}, distance: 1 m, angle: {i} deg}}" for i in range(1, 900))
    path = Path(file_of(tmp_path))
    text = path.read_text(encoding="utf-8").replace("{P: [0, 0]}", f"{{P: [0, 0], P0: [0, 0]{rows}}}")
    path.write_text(text, encoding="utf-8")
    said = "the point P100 is told by a chain of more than 100 points"
    assert complaints(str(path)) == [("PL207", said)]


@pytest.mark.parametrize("tolerance", ["infinity", "log(-1)", "sqrt(-1)", "asin(2)", "-1", "2", "0.01 m", "1e30"])
@pytest.mark.parametrize("own", [False, True])
def test_tolerances_are_parts(tolerance: str, own: bool, tmp_path: Path) -> None:
    answers = f"answers: {{v: {{value: -19.62 m/s, tolerance: {tolerance}}}}}\n"
    more = answers if own else f"answers: {{v: -19.62 m/s}}\ntolerance: {tolerance}\n"
    ((code, said),) = complaints(file_of(tmp_path, more=more))
    assert code in ("PL217", "PL462", "PL224")
    assert "tolerance" in said or "the answer v" in said


@pytest.mark.parametrize(
    ("end", "find"), [("v(b).y = infinity", "t @ 2"), ("t = 2*infinity", "t @ 2"), ("t = 2 s", "v(b).y @ 2 < infinity")]
)
def test_infinity_is_an_end_of_time_or_of_a_coordinate(end: str, find: str, tmp_path: Path) -> None:
    assert [code for code, _ in complaints(file_of(tmp_path, end=end, find=find))] == ["PL217"]
    assert complaints(file_of(tmp_path, end="t = infinity")) == []


def test_answers_are_numbers(tmp_path: Path) -> None:
    assert [c for c, _ in complaints(file_of(tmp_path, more="answers: {v: sqrt(-1)*1 m/s}\n"))] == ["PL217"]
    assert complaints(file_of(tmp_path, more="answers: {v: infinity}\n")) == []


# --- options ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("command", ["solve", "key", "check", "simulate", "accuracy"])
@pytest.mark.parametrize("seconds", ["inf", "nan", "1e300", "-1"])
def test_limits_of_time_are_numbers(
    command: str, seconds: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.run([command, "--timeout", seconds, file_of(tmp_path)]) == cli.BAD
    assert "Invalid value for '--timeout'" in capsys.readouterr().err


@pytest.mark.parametrize("line", ["simulate --tolerance nan", "accuracy --tolerance nan", "accuracy --budget nan"])
def test_what_is_no_number_lies_between_no_limits(
    line: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.run([*line.split(), file_of(tmp_path)]) == cli.BAD
    assert "nan is no number" in capsys.readouterr().err


@pytest.mark.parametrize("command", ["solve", "key", "simulate", "accuracy"])
def test_a_time_that_is_up_at_once(command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run([command, "--timeout", "1e-6", file_of(tmp_path)]) == cli.UNDECIDED
    assert "not decided" in capsys.readouterr().err


@pytest.mark.parametrize("command", ["simulate", "accuracy"])
def test_a_step_passes(command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run([command, "--step", "0 s", file_of(tmp_path)]) == cli.BAD
    told = capsys.readouterr()
    assert "0 s is no time that passes" in told.err + told.out
