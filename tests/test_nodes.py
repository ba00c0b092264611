"""The strict YAML reader: what is refused, where, and agreement with another YAML 1.2 reader on what is accepted."""

from __future__ import annotations

import os
import re
from io import StringIO
from pathlib import Path

import pytest
import ruamel.yaml.nodes
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from ruamel.yaml import YAML
from ruamel.yaml.nodes import MappingNode, ScalarNode

from planar_cli.errors import Mark
from planar_cli.problem.codes import codes
from planar_cli.problem.codes.codes import CODES
from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar, Sequence, read_file, read_text
from planar_cli.problem.nodes.show import show_diagnostic


def plain(node: Node) -> object:
    match node:
        case Scalar(text=text):
            return text
        case Sequence(items=items):
            return [plain(item) for item in items]
        case Mapping(pairs=pairs):
            return {key.text: plain(value) for key, value in pairs}


def from_ruamel(node: ruamel.yaml.nodes.Node) -> object:
    if isinstance(node, ScalarNode):
        return node.value
    if isinstance(node, MappingNode):
        return {key.value: from_ruamel(value) for key, value in node.value}
    return [from_ruamel(item) for item in node.value]


ACCEPTED = [
    "a: 1e-3\nb: .5\nc: 010\n",
    "on: off\nyes: no\ny: N\n",
    "d: 2024-01-02\ne: 12:30\nf: 0x1F\ng: 1_000\n",
    "given: {m: 50 kg, b: 2*l, g: 1.62 m/s^2}\n",
    "assume: [a < g, b < l]\nmotion: [omega(OB) = 2 rad/s]\n",
    "text: >-\n\n  Two lines\n  of words: with a colon\n\nnote: |\n  kept\n  lines\n",
    "states:\n  1: [at rest]\n  2: [just after 1]\nload: {during: 1->2}\n",
    "q: \"a # b\"\nr: 'it''s'\n",
    "---\na: []\nb: {}\n",
    "P: {particle: [0, 0], mass: any}\n",
    "a: 1\r\nb: [x,\r\n  y]\r\n",
    'a: -x\nb: 2*x\nc: ""\n',
    "title: Überschlag – schnell\n",
]


@pytest.mark.parametrize("text", ACCEPTED)
def test_agrees_with_another_reader(text: str) -> None:
    node, diagnostics = read_text(text, "f")
    assert diagnostics == []
    assert node is not None
    assert plain(node) == from_ruamel(YAML(typ="safe", pure=True).compose(StringIO(text)))


# Text, code, line, column, words of the hint.
REFUSED = [
    ("P: ?", "PL111", 1, 4, "unknowns"),
    ("{P: ?}", "PL111", 1, 5, "unknowns"),
    ("k: *k", "PL105", 1, 4, "2*k"),
    ("k: * x", "PL111", 1, 5, "2*k"),
    ("a: @2", "PL111", 1, 4, "v(P) @ 2"),
    ("a: % x", "PL111", 1, 4, "fraction"),
    ("a: & x", "PL111", 1, 5, "two entries"),
    ("a: `x", "PL111", 1, 4, "leave"),
    ("a: ! x", "PL105", 1, 4, "leave"),
    ("a: !!binary aGk=", "PL105", 1, 4, "leave"),
    ("!!set {a, b}", "PL105", 1, 1, "leave"),
    ("? [k]\n: 1", "PL110", 1, 3, "name"),
    ("a: >= 3", "PL111", 1, 5, "- a >= 3"),
    ("a: > 0", "PL111", 1, 6, "- a >= 3"),
    ("note: Rod: hinged", "PL113", 1, 10, ">-"),
    ("a:\n\t- b", "PL112", 2, 1, "spaces"),
    ("a:\n\tb: 1", "PL112", 2, 1, "spaces"),
    ("a: [1, 2", "PL104", 1, 4, "[a, b]"),
    ("a: {b: 1", "PL104", 1, 4, "{a: 1"),
    ('a: "b', "PL104", 1, 4, "quote"),
    ("a: 1\n b: 2", "PL104", 2, 3, "column"),
    ("a: - 1", "PL104", 1, 4, "next line"),
    ("a: 1\n---\nb: 2", "PL106", 2, 1, "one problem"),
    ("", "PL106", 1, 1, "title"),
    ("# only words", "PL106", 1, 1, "title"),
    ("{b}", "PL107", 1, 2, "b: …"),
    ("a:", "PL107", 1, 1, "a: …"),
    ("a: ~", "PL107", 1, 1, "a: …"),
    ("a: null", "PL107", 1, 1, "a: …"),
    ("- 1\n-\n- 2", "PL107", 2, 2, "delete"),
    ("a: 1\nb: 2\na: 3", "PL109", 3, 1, "delete"),
    ("instant: [distance(A, B) = 3 m]", "PL108", 1, 21, "r(B/A).mag"),
    ("find: {I: I(rod, O)}", "PL108", 1, 16, "I(rod/O)"),
    ("<<: {a: 1}", "PL105", 1, 1, "entries"),
    ("&id [*id]", "PL105", 1, 1, ""),
    ("%YAML 1.1\n---\na: 1", "PL105", 1, 1, "delete"),
    ("a: \x1b[31m", "PL103", 1, 4, "delete"),
    ('a: "\\x1b[31m"', "PL103", 1, 5, "delete"),
    ('a: "\\u202E"', "PL103", 1, 5, "delete"),
    ("a: \u202e", "PL103", 1, 4, "delete"),
    ("a: \x00", "PL103", 1, 4, "delete"),
    ("a: \x9b", "PL103", 1, 4, "delete"),
    ("a: b\xa0c", "PL103", 1, 5, "ordinary space"),
    ('a: "\\q"', "PL104", 1, None, "single quotes"),
    ("[" * 30_000, "PL102", 1, 31, ""),
    ("{a: " * 10_000, "PL102", 1, None, ""),
    ("- " * 40 + "x", "PL102", 1, None, ""),
    ("a: " + "x" * 10_001, "PL102", 1, 4, ""),
    ("a: 1" + ":59" * 100_000, "PL102", 1, 1, ""),
    ("- a\n" * 20_100, "PL102", None, None, ""),
    ("a: &a [x,x]\nb: &b [*a,*a]\n<<: *b", "PL105", 1, 4, ""),
]


@pytest.fixture(params=["C", "pure"])
def loader(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    """Both loaders of PyYAML: the C one may be missing."""
    if request.param == "pure":
        monkeypatch.delattr(yaml, "CSafeLoader", raising=False)
    return str(request.param)


@pytest.mark.parametrize("row", REFUSED, ids=range(len(REFUSED)))
def test_refused(loader: str, row: tuple[str, str, int | None, int | None, str]) -> None:
    text, code, line, column, hint = row
    node, diagnostics = read_text(text, "f")
    assert node is None
    first = next(d for d in diagnostics if d.code == code)
    assert line in (None, first.mark.line)
    if loader == "C":
        assert column in (None, first.mark.column)
    assert hint in first.hint
    for diagnostic in diagnostics:
        assert show_diagnostic(diagnostic, text).replace("\n", "").isprintable()


def test_errors_are_gathered() -> None:
    text = "a: 1\na: 2\nb:\nc: [f(x, y)]\nd: &k 3\n"
    _, diagnostics = read_text(text, "f")
    assert [(d.mark.line, d.code) for d in diagnostics] == [(2, "PL109"), (3, "PL107"), (4, "PL108"), (5, "PL105")]


def test_duplicate_keys_name_both_lines() -> None:
    _, diagnostics = read_text("a: 1\nb: 2\na: 3", "f")
    assert "line 1" in diagnostics[0].message
    assert diagnostics[0].mark.line == 3


def test_marks_point_at_the_first_character() -> None:
    node, _ = read_text("a: x + y\nb: \"x y\"\nc: 'z'\nd: >-\n\n   foo\n   bar\ne: [p,  q]\n", "f")
    assert isinstance(node, Mapping)
    marks = {key.text: value.mark for key, value in node.pairs}
    assert marks["a"] == Mark("f", 1, 4)
    assert marks["b"] == Mark("f", 2, 5)
    assert marks["c"] == Mark("f", 3, 5)
    assert marks["d"] == Mark("f", 6, 4)
    entries = node.get("e")
    assert isinstance(entries, Sequence)
    assert entries.items[1].mark == Mark("f", 8, 9)
    assert node.get("missing") is None


def test_numbers_stay_text() -> None:
    node, _ = read_text("[1e3, 010, 0o10, 1_000, 12:30, .inf, true]", "f")
    assert node is not None
    assert plain(node) == ["1e3", "010", "0o10", "1_000", "12:30", ".inf", "true"]


def test_read_file(tmp_path: Path) -> None:
    path = tmp_path / "a.yaml"
    path.write_bytes(b"\xef\xbb\xbfa: 1\n")
    text, node, diagnostics = read_file(path)
    assert (text, diagnostics) == ("a: 1\n", [])
    assert node is not None


def test_bad_files(tmp_path: Path) -> None:
    (tmp_path / "latin.yaml").write_bytes(b"a: 1\nb: \xe9\n")
    (tmp_path / "large.yaml").write_bytes(b"#" * 300_000)
    (tmp_path / "link.yaml").symlink_to(tmp_path / "latin.yaml")
    os.mkfifo(tmp_path / "pipe.yaml")
    found = {}
    for name in ("latin", "large", "link", "pipe", "missing"):
        _, node, diagnostics = read_file(tmp_path / f"{name}.yaml")
        assert node is None
        found[name] = diagnostics[0]
    assert {name: d.code for name, d in found.items()} == {
        "latin": "PL103",
        "large": "PL102",
        "link": "PL101",
        "pipe": "PL101",
        "missing": "PL101",
    }
    assert (found["latin"].mark.line, found["latin"].mark.column) == (2, 4)
    assert read_file(tmp_path)[2][0].code == "PL101"
    assert read_file("a\x00b")[2][0].code == "PL101"


def test_every_code_of_the_reading_layer_is_explained() -> None:
    folder = Path(codes.__file__).parents[1]
    names = (
        "language/dimensions language/instants language/limits language/parser language/sides "
        "language/tokens language/unit_run "
        "nodes/nodes nodes/yaml_errors"
    )
    used = {
        code for name in names.split() for code in re.findall(r"PL\d{3}", (folder / f"{name}.py").read_text("utf-8"))
    }
    assert used <= set(CODES)


def test_caret_and_long_lines() -> None:
    text = "a: " + "x" * 300 + " @"
    _, diagnostics = read_text("b: 1\nb: 2", "f")
    shown = show_diagnostic(diagnostics[0], "b: 1\nb: 2").splitlines()
    assert shown[0].startswith("f:2:1: PL109 ")
    assert shown[1:3] == ["  b: 2", "  ^"]
    assert shown[3].startswith("hint: ")
    far = type(diagnostics[0])(Mark("f\x1b", 1, 305), "PL104", "bad \x1b", "")
    lines = show_diagnostic(far, text).splitlines()
    assert "\\x1b" in lines[0]
    assert lines[1][lines[2].index("^")] == "@"
    assert all(len(line) < 130 for line in lines)


@settings(max_examples=300, deadline=None)
@given(st.text(max_size=200) | st.text(alphabet="ab:-? []{},&*!|>'\"%@`#\n\t\\x(1)~<", max_size=60))
def test_any_text_gives_a_tree_or_diagnostics(text: str) -> None:
    node, diagnostics = read_text(text, "f")
    assert (node is None) == bool(diagnostics)
    for diagnostic in diagnostics:
        assert diagnostic.code in CODES
        assert diagnostic.mark.line >= 1
        assert show_diagnostic(diagnostic, text).replace("\n", "").isprintable()


@settings(max_examples=200, deadline=None)
@given(st.text(alphabet="ab: -[]{},'\"\n(1)<", max_size=40))
def test_accepted_text_means_the_same_elsewhere(text: str) -> None:
    node, _ = read_text(text, "f")
    if node is not None:
        assert plain(node) == from_ruamel(YAML(typ="safe", pure=True).compose(StringIO(text)))
