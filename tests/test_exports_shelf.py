"""What every export keeps to: a manual page, safe names, the same bytes, nothing dropped silently, light to import."""

from __future__ import annotations

import io
import re
import subprocess
import sys
import zipfile

import pytest
from exported import PAPERS, SHELF, exported, manual_page

from planar_cli.homework.exports._text import Names, slug, table
from planar_cli.homework.exports.base import PaperExport, ResultExport
from planar_cli.registry import members

KINDS = tuple(members(SHELF))
NAME = re.compile(r"[a-z0-9][a-z0-9_-]{0,63}(\.[a-z]+)?")
FIXED = {"clientFilesQuestion", "question.html", "server.py", "info.json", "results.json"}


def test_the_shelf_has_its_members() -> None:
    assert KINDS == ("canvas", "gradebook", "gradescope", "moodle", "prairielearn", "qti", "text2qti")


@pytest.mark.parametrize("kind", KINDS)
def test_the_page_tells_what_it_is_how_it_is_imported_and_what_is_lost(kind: str) -> None:
    first, blank, rest = manual_page(kind).partition("\n\n")
    assert first.endswith(".")
    assert first.count("\n") == 0
    assert blank
    for heading in ("The file", "To import it", "What is lost"):
        assert re.search(rf"^{heading}s?$", rest, re.MULTILINE)


@pytest.mark.parametrize("kind", KINDS)
def test_a_member_says_what_it_takes(kind: str) -> None:
    member = members(SHELF)[kind]
    assert issubclass(member, PaperExport if member.takes == "papers" else ResultExport)


@pytest.mark.parametrize("kind", KINDS)
def test_the_same_homework_gives_the_same_bytes(kind: str) -> None:
    first, second = exported(kind), exported(kind)
    assert first == second
    assert list(first.files) == list(second.files)


@pytest.mark.parametrize("kind", KINDS)
def test_file_names_are_safe(kind: str) -> None:
    for name in exported(kind).files:
        for part in name.split("/"):
            assert part in FIXED or NAME.fullmatch(part), name


@pytest.mark.parametrize("kind", KINDS)
def test_sentences_are_lines_without_control_characters(kind: str) -> None:
    for sentence in exported(kind).left_out:
        assert sentence.isprintable()


@pytest.mark.parametrize("kind", KINDS)
def test_nothing_makes_an_empty_file(kind: str) -> None:
    result = exported(kind, ())
    assert all(result.files.values())
    assert not result.left_out


@pytest.mark.parametrize("kind", [k for k in KINDS if members(SHELF)[k].takes == "papers"])
def test_every_find_is_exported_or_told(kind: str) -> None:
    result = exported(kind)
    contents = b"\n".join(result.files.values())
    if kind == "qti":
        archive = zipfile.ZipFile(io.BytesIO(contents))
        contents = b"\n".join(archive.read(name) for name in archive.namelist())
    told = "\n".join(result.left_out)
    for task in PAPERS[0].tasks:
        for expected in task.expected:
            assert re.search(rf"\b{expected.find}\b|\b{expected.find}_", contents.decode()) or expected.find in told


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("../../etc/passwd", "etc-passwd"),
        ("Über Kräfte", "uber-krafte"),
        ("Homework 5 - Dynamics", "homework-5-dynamics"),
        ("CON", "con_"),
        ("lpt1", "lpt1_"),
        ("", "unnamed"),
        ("=_-", "unnamed"),
        ("\0\u202e", "unnamed"),
        ("力", "unnamed"),
        ("a" * 300, "a" * 64),
    ],
)
def test_slugs(text: str, name: str) -> None:
    assert slug(text) == name


def test_names_that_collide_are_counted() -> None:
    names = Names()
    assert [names.of(t) for t in ("A b", "a-b", "a/b")] == ["a-b", "a-b-2", "a-b-3"]
    assert [len(names.of("x" * 300)) for _ in range(12)] == [64] * 12


@pytest.mark.parametrize("begin", ["=", "+", "-", "@", "\t", "\r", "\n", "\0"])
def test_a_text_that_begins_a_formula_gets_an_apostrophe(begin: str) -> None:
    assert table([[f"{begin}SUM(1)"]], excel=False).lstrip(b'"').startswith(b"'")


@pytest.mark.parametrize("text", ["-2.5", "+3", "1e-3", "-.5"])
def test_a_number_stays_a_number(text: str) -> None:
    assert table([[text, -2.5]], excel=False) == f"{text},-2.5\r\n".encode()


def test_importing_the_shelf_is_light() -> None:
    script = f"import sys; from planar_cli.registry import members; members({SHELF!r}); print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout.split()
    assert not {"sympy", "numpy", "mpmath", "yaml"} & set(loaded)


@pytest.mark.parametrize("kind", ["prairielearn", "text2qti"])
def test_the_seed_stands_in_the_file(kind: str) -> None:
    contents = b"".join(exported(kind).files.values()).decode()
    assert re.search(r"^[#%] .*rawn with seed 7\.$", contents, re.MULTILINE)
