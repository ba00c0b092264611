"""The strict YAML reader: text to a tree of located nodes, with nothing resolved behind the author's back.

Plain scalars stay text (numbers too), so that YAML 1.1 Booleans, dates and base-60 numbers cannot arise. Anchors,
aliases, tags, merge keys, several documents, nulls, duplicate keys and control characters are errors. The tree is built
from the stream of events, where the limits are tested as well, so that nothing recursive ever runs on hostile text.
"""

from __future__ import annotations

import os
import stat
import sys
from collections.abc import Iterator
from dataclasses import field
from typing import Protocol

from planar_cli.errors import Diagnostic, Mark
from planar_cli.problem.language.words import CALL_HABITS, QUANTITIES
from planar_cli.problem.nodes.pyyaml import yaml
from planar_cli.problem.nodes.show import lines_of
from planar_cli.problem.nodes.yaml_errors import explain_error
from planar_cli.records import changing, record

MAX_BYTES = 256_000
MAX_DEPTH = 30
MAX_EVENTS = 20_000
MAX_SCALAR = 10_000
MAX_REPORTED = 20
MAX_SHOWN = 60

STDIN = "<stdin>"

_QUOTES = ("'", '"')
_BLOCKS = ("|", ">")


@record
class Scalar:
    """A text, from `mark` to just before `end`; `quoted` if it stood in quotes or under `|` or `>`."""

    text: str
    quoted: bool
    mark: Mark
    end: Mark


@record
class Sequence:
    items: tuple[Node, ...]
    mark: Mark


@record
class Mapping:
    """Keys in the order of the file; no key stands twice."""

    pairs: tuple[tuple[Scalar, Node], ...]
    mark: Mark

    def get(self, key: str) -> Node | None:
        """The value of `key`, None if it is not there."""
        return next((value for scalar, value in self.pairs if scalar.text == key), None)

    def keys(self) -> tuple[str, ...]:
        return tuple(scalar.text for scalar, _ in self.pairs)


Node = Scalar | Sequence | Mapping


def read_file(path: str | os.PathLike[str]) -> tuple[str, Node | None, list[Diagnostic]]:
    """The text of a file, its tree and what is wrong; `-` is standard input. The tree is None if anything is wrong."""
    name = STDIN if os.fspath(path) == "-" else os.fspath(path)
    start = Mark(name, 1, 1)
    try:
        data = sys.stdin.buffer.read(MAX_BYTES + 1) if name == STDIN else regular_bytes(name)
    except (OSError, ValueError) as error:
        reason = (error.strerror if isinstance(error, OSError) else None) or str(error)
        return "", None, [Diagnostic(start, "PL101", f"the file cannot be read: {reason}", "give a problem file")]
    if len(data) > MAX_BYTES:
        message = f"a problem file is at most {MAX_BYTES // 1000} kB long"
        return "", None, [Diagnostic(start, "PL102", message, "put each problem into a file of its own")]
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        mark = mark_behind(data[: error.start].decode("utf-8"), name)
        return "", None, [Diagnostic(mark, "PL103", "the file is not UTF-8 text", "save it with the encoding UTF-8")]
    node, diagnostics = read_text(text, name)
    return text.removeprefix("\ufeff"), node, diagnostics


def text_of(name: str) -> str:
    """The text of a file from which an excerpt may be shown; "" of anything that is not read as a problem file."""
    try:
        data = regular_bytes(name) if name != STDIN else b""
        return data.decode("utf-8") if len(data) <= MAX_BYTES else ""
    except (OSError, ValueError):
        return ""


def regular_bytes(name: str, most: int = MAX_BYTES) -> bytes:
    """At most `most` + 1 bytes of a regular file; never waits on a pipe or device, never follows a link.

    Raises OSError, and ValueError saying what it is where it is no regular file.
    """
    if os.path.islink(name):
        raise ValueError("it is a symbolic link")
    if os.path.isdir(name):
        raise ValueError("it is a folder")
    flags = [getattr(os, flag, 0) for flag in ("O_NONBLOCK", "O_BINARY", "O_NOFOLLOW")]
    descriptor = os.open(name, os.O_RDONLY | sum(flags))
    with open(descriptor, "rb") as stream:
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            raise ValueError("it is not a regular file")
        return stream.read(most + 1)


def read_text(text: str, file: str, blanks: bool = False) -> tuple[Node | None, list[Diagnostic]]:
    """The tree of one YAML document and what is wrong with it; the tree is None if anything is wrong.

    With `blanks` a key may have no value: its value is an unquoted empty text.
    """
    text = text.removeprefix("\ufeff")
    start = Mark(file, 1, 1)
    if len(text) > MAX_BYTES:
        message = f"a problem file is at most {MAX_BYTES // 1000} kB long"
        return None, [Diagnostic(start, "PL102", message, "put each problem into a file of its own")]
    diagnostics = bad_characters(text, file)
    if diagnostics:
        return None, diagnostics
    builder = _Builder(text, file, blanks)
    try:
        try:
            builder.run(_events(text, _fast()))
        except yaml.MarkedYAMLError as error:
            if "nesting" not in (error.problem or ""):
                raise
            # libyaml looks too far ahead for the limit of this reader to be met; the slower loader tells the place.
            builder = _Builder(text, file, blanks)
            builder.run(_events(text, yaml.SafeLoader))
    except yaml.YAMLError as error:
        builder.report.append(explain_error(error, text, file))
    except (ValueError, OverflowError, RecursionError):
        # The pure loader lets `"\UFFFFFFFF"` through to chr().
        builder.complain(start, "PL104", "the text cannot be read", "check the escapes in double quotes")
    except _LimitError:
        pass
    if builder.root is None and not builder.report:
        builder.complain(start, "PL106", "the file is empty", "begin with `title: …`")
    return (None, sorted(builder.report, key=lambda d: (d.mark, d.code))) if builder.report else (builder.root, [])


def _fast() -> type:
    """The loader of libyaml, where PyYAML was built with it."""
    found: type = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    return found


def _events(text: str, loader: type) -> Iterator[yaml.Event]:
    return yaml.parse(text, Loader=loader)


def bad_characters(text: str, file: str) -> list[Diagnostic]:
    """Control, bidirectional and other invisible characters, each with its place."""
    if text.isascii() and text.replace("\n", "").isprintable():
        return []
    found: list[Diagnostic] = []
    for index, character in enumerate(text):
        if character.isprintable() or character in "\n\r\t":
            continue
        found.append(Diagnostic(mark_behind(text[:index], file), "PL103", *_character_words(character)))
        if len(found) == MAX_REPORTED:
            break
    return found


def _character_words(character: str) -> tuple[str, str]:
    if character == "\xa0":
        return "a no-break space (U+00A0) stands here", "write an ordinary space"
    return f"the invisible character U+{ord(character):04X} stands here", "delete it"


def mark_behind(before: str, file: str) -> Mark:
    """The place just behind the text `before`."""
    lines = lines_of(before + "|")
    return Mark(file, len(lines), len(lines[-1]))


class _HasPlace(Protocol):
    """What the marks of both loaders have in common; they count from 0."""

    line: int
    column: int


class _LimitError(Exception):
    """A limit is passed; the diagnostic is already in the report."""


@changing
class _Frame:
    """A collection that is still open; None stands for a child that was refused."""

    mapping: bool
    flow: bool
    mark: Mark
    children: list[Node | None] = field(default_factory=list)


class _Builder:
    """Builds the tree from events and gathers diagnostics."""

    def __init__(self, text: str, file: str, blanks: bool) -> None:
        self.file, self.blanks = file, blanks
        self.lines = text.splitlines()
        self.report: list[Diagnostic] = []
        self.root: Node | None = None
        self.frames: list[_Frame] = []
        self.documents = 0

    def complain(self, mark: Mark, code: str, message: str, hint: str) -> None:
        self.report.append(Diagnostic(mark, code, message, hint))

    def stop(self, mark: Mark, code: str, message: str, hint: str) -> None:
        self.complain(mark, code, message, hint)
        raise _LimitError

    def run(self, events: Iterator[yaml.Event]) -> None:
        for count, event in enumerate(events):
            if count > MAX_EVENTS:
                self.stop(self.mark(event), "PL102", "the file has too many entries", "split it")
            self.handle(event)

    def mark(self, event: yaml.Event, columns: int = 0) -> Mark:
        place = self._place(event.start_mark)
        return place.shifted(columns) if columns else place

    def _place(self, mark: _HasPlace | None) -> Mark:
        return Mark(self.file, mark.line + 1, mark.column + 1) if mark is not None else Mark(self.file, 1, 1)

    def handle(self, event: yaml.Event) -> None:
        match event:
            case yaml.ScalarEvent():
                self._refuse_labels(event)
                self._add(self._scalar(event))
            case yaml.DocumentStartEvent():
                self._document(event)
            case yaml.AliasEvent():
                hint = "write the value again, or give it a name under `given`; a product is `2*k`"
                self.complain(self.mark(event), "PL105", f"`*{_short(str(event.anchor))}` refers to an anchor", hint)
                self._add(None)
            case yaml.SequenceStartEvent() | yaml.MappingStartEvent():
                self._refuse_labels(event)
                mapping = isinstance(event, yaml.MappingStartEvent)
                self.frames.append(_Frame(mapping, bool(event.flow_style), self.mark(event)))
                if len(self.frames) > MAX_DEPTH:
                    self.stop(self.mark(event), "PL102", f"nested more than {MAX_DEPTH} deep", "close the brackets")
            case yaml.SequenceEndEvent() | yaml.MappingEndEvent():
                frame = self.frames.pop()
                self._add(self._mapping(frame) if frame.mapping else self._sequence(frame))

    def _document(self, event: yaml.DocumentStartEvent) -> None:
        self.documents += 1
        if event.version or event.tags:
            self.complain(self.mark(event), "PL105", "a YAML directive stands here", "delete the line with `%`")
        if self.documents > 1:
            self.stop(self.mark(event), "PL106", "a second document begins here", "one problem a file; delete `---`")

    def _refuse_labels(self, event: yaml.ScalarEvent | yaml.CollectionStartEvent) -> None:
        if event.anchor is not None:
            self.complain(self.mark(event), "PL105", f"`&{_short(str(event.anchor))}` is an anchor", "leave it out")
        if event.tag is not None:
            self.complain(self.mark(event), "PL105", "a tag stands here", "leave `!` and its word out")

    def _add(self, node: Node | None) -> None:
        if self.frames:
            self.frames[-1].children.append(node)
        elif isinstance(node, Scalar) and is_null(node):
            self.root = None
        else:
            self.root = node

    def _scalar(self, event: yaml.ScalarEvent) -> Scalar:
        text = event.value
        style = event.style if event.style in (*_QUOTES, *_BLOCKS) else ""
        mark = self.mark(event, columns=1 if style in _QUOTES else 0)
        mark = self._content(mark.line) if style in _BLOCKS else mark
        if len(text) > MAX_SCALAR:
            self.stop(mark, "PL102", f"a text is at most {MAX_SCALAR} characters long", "shorten it")
        bad = None if text.isprintable() else next((c for c in text if not (c.isprintable() or c in "\n\t")), None)
        if bad is not None:
            self.complain(mark, "PL103", *_character_words(bad))
        return Scalar(text, bool(style), mark, self._place(event.end_mark))

    def _content(self, indicator: int) -> Mark:
        """The first character of the first line with content below the line of `|` or `>`."""
        for number, line in enumerate(self.lines[indicator:], indicator + 1):
            if line.strip():
                return Mark(self.file, number, len(line) - len(line.lstrip(" ")) + 1)
        return Mark(self.file, indicator, 1)

    def _sequence(self, frame: _Frame) -> Sequence:
        split = self._comma_splits(frame)
        for child in frame.children:
            if isinstance(child, Scalar) and is_null(child) and not split:
                self.complain(child.mark, "PL107", "an entry of the list is empty", "write a value, or delete it")
        return Sequence(tuple(child for child in frame.children if child is not None), frame.mark)

    def _mapping(self, frame: _Frame) -> Mapping:
        split = self._comma_splits(frame)
        seen: dict[str, Scalar] = {}
        pairs: list[tuple[Scalar, Node]] = []
        for key, value in zip(frame.children[::2], frame.children[1::2], strict=True):
            if not isinstance(key, Scalar):
                place = frame.mark if key is None else key.mark
                self.complain(place, "PL110", "a key is one word", "write `name: …`")
                continue
            self._check_key(key, seen)
            blank = isinstance(value, Scalar) and is_null(value)
            if blank and not self.blanks and not is_null(key) and not split:
                name = _short(key.text)
                self.complain(key.mark, "PL107", f"`{name}` has no value", f"write `{name}: …`, or leave the key out")
            if value is not None:
                pairs.append((key, value))
        return Mapping(tuple(pairs), frame.mark)

    def _check_key(self, key: Scalar, seen: dict[str, Scalar]) -> None:
        if key.text == "<<" and not key.quoted:
            self.complain(key.mark, "PL105", "`<<` would merge mappings", "write the entries out")
        elif not key.text or is_null(key):
            hint = "write `name: …`; instead of `?`, declare the name under `unknowns:`"
            self.complain(key.mark, "PL110", "a key is missing", hint)
        elif key.text in seen:
            first = seen[key.text].mark.line
            message = f"`{_short(key.text)}` stands here a second time; the first is in line {first}"
            self.complain(key.mark, "PL109", message, "delete one of the two, or give it another name")
        seen.setdefault(key.text, key)

    def _comma_splits(self, frame: _Frame) -> bool:
        """Report each plain text of a flow collection whose bracket is closed only behind a comma."""
        if not frame.flow:
            return False
        plain = [child for child in frame.children if isinstance(child, Scalar) and not child.quoted]
        split = False
        for index, scalar in enumerate(plain):
            if scalar.text.count("(") <= scalar.text.count(")"):
                continue
            behind = next((later for later in plain[index + 1 :] if ")" in later.text), None)
            if behind is not None:
                split = True
                whole = f"{scalar.text}, {behind.text}"
                message = f"a comma splits here: `{_short(whole)}` becomes two entries"
                self.complain(scalar.end, "PL108", message, _joined(whole))
        return split


def _joined(whole: str) -> str:
    """What to write instead of a text with a comma in its brackets."""
    word, _, rest = whole.partition("(")
    word = "".join(c for c in word if c.isalnum() or c in "_ ").split(" ")[-1]
    if word in CALL_HABITS:
        return CALL_HABITS[word]
    if QUANTITIES.get(word) == "things" and "(" not in rest:
        inside = "/".join(part.strip() for part in rest.split(")")[0].split(","))
        return f"write `{word}({inside})`"
    return "no comma stands inside a quantity: write `r(B/A).mag`, `I(rod/O)`"


def _short(text: str) -> str:
    return text if len(text) <= MAX_SHOWN else text[:MAX_SHOWN] + "…"


def is_null(scalar: Scalar) -> bool:
    return not scalar.quoted and scalar.text in ("", "~", "null", "Null", "NULL")
