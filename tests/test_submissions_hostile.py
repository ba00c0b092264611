"""Files that are made to harm whoever reads them: each is told in a sentence, in no time, and with nothing done."""

from __future__ import annotations

import os
import time
from pathlib import Path

import pytest

from planar_cli.homework.submissions.submissions import contents, submissions

ALIASES = "a: &a [x]\n" + "".join(
    f"{chr(98 + i)}: &{chr(98 + i)} [{', '.join([f'*{chr(97 + i)}'] * 9)}]\n" for i in range(9)
)
HOSTILE = {
    "aliases.yaml": ALIASES,
    "merge.yaml": "a: &a {b: 1}\nanswers: {<<: *a}\n",
    "deep.yaml": "[" * 50_000,
    "deep-mapping.yaml": "{a: " * 50_000,
    "deep-block.yaml": "".join(" " * i + "a:\n" for i in range(400)),
    "long.yaml": "answers: {p: {a: " + "1" * 300_000 + "}}",
    "nul.yaml": "answers: {p: {a: \x00}}",
    "escape.yaml": 'answers: {p: {a: "\\x1b[31m"}}',
    "bidi.yaml": "answers: {p: {a: \u202e5 N}}",
    "tag.yaml": "answers: !!python/object/apply:os.system ['touch owned']\n",
    "twice.yaml": "answers: {p: {a: 1}}\nanswers: {p: {a: 2}}\n",
    "two.yaml": "answers: {}\n---\nanswers: {}\n",
    "many.yaml": "answers: {p: {" + ", ".join(f"a{i}: 1" for i in range(15_000)) + "}}",
    "huge-escape.yaml": '"\\UFFFFFFFF"',
    "minutes.yaml": "answers: {p: {a: 1" + ":59" * 5000 + "}}",
    "deep.json": "[" * 100_000,
    "deep-mapping.json": '{"a":' * 40_000,
    "digits.json": '{"answers": {"p": {"a": ' + "9" * 200_000 + "}}}",
    "power.json": '{"answers": {"p": {"a": 1e999999999}}}',
    "infinite.json": '{"answers": {"p": {"a": -Infinity}}}',
    "twice.json": "{" + ", ".join(f'"a{i}": 1' for i in range(15_000)) + ', "a1": 2}',
    "surrogate.json": '{"answers": {"p": {"a": "\\ud800"}}}',
    "escape.json": '{"answers": {"p": {"a": "\\u001b[31m"}}}',
    "long.json": '{"a": "' + "x" * 300_000 + '"}',
    "columns.csv": ",".join(f"p.a{i}" for i in range(10_000)) + "\n" + "1," * 10_000,
    "wide.csv": "student," + ",".join(f"p.a{i}" for i in range(10_000)) + "\ns" + ",1" * 10_000,
    "field.csv": "problem,find,answer\np,a," + "1" * 300_000,
    "quotes.csv": "problem,find,answer\n" + 'p,a,"' * 50_000,
    "nul.csv": "problem,find,answer\np,a,\x00",
    "lines.csv": "problem,find,answer\n" + "p,a,1\n" * 210_000,
    "binary.csv": bytes(range(256)) * 10,
    "large.csv": b"x" * 8_000_001,
}


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_files_are_told(
    tmp_path: Path, name: str, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / name
    text = HOSTILE[name]
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    monkeypatch.chdir(tmp_path)
    began = time.process_time()
    found = submissions(contents(str(path)))
    # A second for the worst; what grows faster than the file takes minutes.
    assert time.process_time() - began < 20
    told = [w for s in found for w in s.wrong]
    assert told or name in ("power.json", "minutes.yaml")
    assert all(w.isprintable() and w.startswith(str(path)) and "Error" not in w for w in told)
    assert all(text.isprintable() for s in found for _, _, text in s.answers)
    assert not (tmp_path / "owned").exists()
    assert capfd.readouterr() == ("", "")


def test_what_is_no_regular_file(tmp_path: Path) -> None:
    (tmp_path / "folder.yaml").mkdir()
    (tmp_path / "link.yaml").symlink_to("/etc/passwd")
    os.mkfifo(tmp_path / "pipe.yaml")
    told = [submissions(contents(str(tmp_path / n)))[0] for n in ("folder.yaml", "link.yaml", "pipe.yaml", "no.yaml")]
    assert [s.student for s in told] == ["folder", "link", "pipe", "no"]
    assert [s.wrong[0].rsplit(": ", 1)[1] for s in told] == [
        "it is a folder",
        "it is a symbolic link",
        "it is not a regular file",
        "No such file or directory",
    ]
    assert submissions(contents("/dev/zero"))[0].wrong == (
        "/dev/zero: the file cannot be read: it is not a regular file",
    )


def test_names_that_steer_a_terminal(tmp_path: Path) -> None:
    path = tmp_path / "\x1b[31m\u202e.yaml"
    path.write_text("answers: [", encoding="utf-8")
    (found,) = submissions(contents(str(path)))
    assert found.student == "\\x1b[31m\\u202e"
    assert found.wrong[0].isprintable()
    table = tmp_path / "c.csv"
    table.write_text("student,p.a\n\x1b]0;x\x07,1\n", encoding="utf-8")
    assert submissions(contents(str(table)))[0].student == "\\x1b]0;x\\x07"
