"""Submissions read from files that nobody vouches for.

One YAML or JSON file is one student's; a CSV file is one student's or a whole class's. Whatever cannot be read is told
in sentences of the submission that it belongs to, with its place where it has one, and costs nobody else theirs. A file
is read once: what its digest is of is what was graded.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace

from planar_cli.errors import Diagnostic, Mark, PlanarError
from planar_cli.homework.sets.paper import Submission
from planar_cli.homework.submissions.submitted import LONGEST_NAME, MOST_TOLD, from_tree, sentence, student_of_file
from planar_cli.homework.submissions.submitted_csv import from_csv
from planar_cli.homework.submissions.submitted_json import json_tree
from planar_cli.homework.submissions.submitted_yaml import student_told, variant_told, yaml_tree
from planar_cli.problem.nodes.nodes import Node, mark_behind, regular_bytes
from planar_cli.problem.nodes.show import visible
from planar_cli.records import record

SUFFIXES = (".yaml", ".yml", ".json", ".csv")
MOST_BYTES = 256_000
"""Of one student's YAML or JSON."""
MOST_BYTES_OF_CSV = 8_000_000
SPACES = str.maketrans(dict.fromkeys("\u00a0\u2007\u2009\u202f", " "))
"""No-break and thin spaces, which word processors put between a number and its unit, are spaces."""


@record
class Contents:
    """The bytes of a file, their digest, and why there are none; the digest of what cannot be read is empty."""

    path: str
    data: bytes = b""
    digest: str = ""
    wrong: str = ""


def submission_files(names: Iterable[str]) -> Iterator[str]:
    """The names as given, each folder replaced by the submissions below it, in the order of their names.

    Links are not followed, and of folders only names with one of SUFFIXES that do not begin with a dot are taken: what
    is behind such a name is looked at when it is read. Raises PlanarError for a name that is not there, and for a
    folder without any.
    """
    for name in names:
        if not os.path.lexists(name):
            raise PlanarError(f"there is no file or folder {visible(name)}")
        if os.path.islink(name) or not os.path.isdir(name):
            yield name
            continue
        empty = True
        for found in _below(name):
            empty = False
            yield found
        if empty:
            raise PlanarError(f"the folder {visible(name)} has no submissions (*{', *'.join(SUFFIXES)})")


def _below(folder: str, read: bool = True) -> Iterator[str]:
    """The files that are `read`, or those that are not."""
    with os.scandir(folder) as entries:
        found = sorted((e for e in entries if not e.name.startswith(".")), key=lambda e: e.name)
    for entry in found:
        if entry.is_dir(follow_symlinks=False):
            yield from _below(entry.path, read)
        elif entry.name.lower().endswith(SUFFIXES) == read:
            yield entry.path


def passed_over(names: Iterable[str]) -> str:
    """A sentence on files of the folders that are no submissions by their names, as scans are; "" of none."""
    found = [p for n in names if os.path.isdir(n) and not os.path.islink(n) for p in _below(n, read=False)]
    if not found:
        return ""
    more = f", and {len(found) - MOST_TOLD} more" if len(found) > MOST_TOLD else ""
    listed = ", ".join(found[:MOST_TOLD])
    return visible(f"not read, as the name of a submission ends in {', '.join(SUFFIXES)}: {listed}{more}")


def contents(path: str) -> Contents:
    """What a file holds; never waits on a pipe or device, never follows a link, never raises."""
    most = _most(path)
    try:
        data = regular_bytes(path, most)
    except (OSError, ValueError) as error:
        reason = (error.strerror if isinstance(error, OSError) else None) or str(error)
        return Contents(path, wrong=sentence(Mark(path, 0, 0), f"the file cannot be read: {reason}"))
    digest = hashlib.sha256(data).hexdigest()
    if len(data) > most:
        longest = f"{most // 1_000_000} MB" if most >= 1_000_000 else f"{most // 1000} kB"
        return Contents(path, b"", digest, sentence(Mark(path, 0, 0), f"a submission is at most {longest} long"))
    return Contents(path, data, digest)


def _most(path: str) -> int:
    return MOST_BYTES_OF_CSV if path.lower().endswith(".csv") else MOST_BYTES


def submissions(read: Contents) -> tuple[Submission, ...]:
    """All submissions of a file: one at least, which tells what is wrong if nothing can be read."""
    path = read.path
    if read.wrong:
        return (_unread(path, read.wrong),)
    try:
        text = read.data.decode("utf-8").removeprefix("\ufeff").translate(SPACES)
    except UnicodeDecodeError as error:
        mark = mark_behind(read.data[: error.start].decode("utf-8"), path)
        return (_unread(path, sentence(mark, "the file is not UTF-8 text", "save it with the encoding UTF-8")),)
    ending = os.path.splitext(path)[1].lower()
    if ending == ".csv":
        return from_csv(text, path)
    reader = _TREES.get(ending)
    if reader is None:
        where = Mark(path, 0, 0)
        return (_unread(path, sentence(where, f"the name of a submission ends in {', '.join(SUFFIXES)}")),)
    tree, wrong = reader(text, path)
    told = tuple(sentence(d.mark, d.message, d.hint) for d in wrong)
    if tree is None:
        student = visible(student_told(text)[:LONGEST_NAME]) or student_of_file(path)
        return (Submission(student, variant_told(text), (), path, told),)
    found = from_tree(tree, path)
    return (replace(found, wrong=(*told, *found.wrong)) if told else found,)


def _unread(path: str, why: str) -> Submission:
    return Submission(student_of_file(path), 0, (), path, (why,))


_TREES: dict[str, Callable[[str, str], tuple[Node | None, list[Diagnostic]]]] = {
    ".yaml": yaml_tree,
    ".yml": yaml_tree,
    ".json": json_tree,
}
