"""What the whole run of `tests/mutations.py` has told so far: a line for each file and kind of mutant.

The run takes hours and may be made in parts. A file whose mutants of a kind have all been judged, none of them an
offender, has a line; it holds as long as the file stays as it is (`digest`).
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple, Protocol

OUTCOMES = ("refused", "no solution", "another answer", "told", "with a reason", "undecided")
HEAD = "\t".join(("file", "digest", "kind", *OUTCOMES))


class Part(NamedTuple):
    """The mutants of one kind of a file as it was."""

    file: str
    digest: str
    kind: str


class Outcome(Protocol):
    """A mutant that was judged."""

    file: str
    digest: str
    kind: str
    outcome: str

    @property
    def offends(self) -> bool: ...


Record = dict[Part, Counter[str]]


def recorded(path: Path) -> Record:
    """The lines of a record, with the counts of outcomes."""
    lines = path.read_text(encoding="utf-8").splitlines()[1:] if path.exists() else []
    record: Record = {}
    for line in lines:
        file, digest, kind, *counts = line.split("\t")
        record[Part(file, digest, kind)] = Counter(dict(zip(OUTCOMES, map(int, counts), strict=True)))
    return record


def extended(record: Record, judged: Iterable[Outcome], wanted: Mapping[Part, int]) -> Record:
    """A record with what was judged since. `wanted`: of all files as they are, how many mutants there are."""
    parts: defaultdict[Part, list[Outcome]] = defaultdict(list)
    for j in judged:
        parts[Part(j.file, j.digest, j.kind)].append(j)
    whole = {part: _counted(parts[part]) for part, n in wanted.items() if len(parts[part]) == n and _clean(parts[part])}
    return {part: whole.get(part) or record[part] for part in sorted(wanted) if part in whole or part in record}


def _clean(judged: Sequence[Outcome]) -> bool:
    return not any(j.offends for j in judged)


def _counted(judged: Sequence[Outcome]) -> Counter[str]:
    return Counter(j.outcome if j.outcome in OUTCOMES else "with a reason" for j in judged)


def write(path: Path, record: Record) -> None:
    """A record as a table of tab-separated lines."""
    lines = ("\t".join((*part, *(str(counts[o]) for o in OUTCOMES))) for part, counts in record.items())
    path.write_text("\n".join((HEAD, *lines)) + "\n", encoding="utf-8")


def totals(record: Record, kinds: Sequence[str]) -> str:
    """The counts of a record by kind, as a table."""
    counts: defaultdict[str, Counter[str]] = defaultdict(Counter)
    for part, outcomes in record.items():
        counts[part.kind] += outcomes
    rows = [("", "files", "mutants", *OUTCOMES)]
    for kind in kinds:
        files = sum(part.kind == kind for part in record)
        rows.append((kind, *map(str, (files, counts[kind].total(), *(counts[kind][o] for o in OUTCOMES)))))
    return "\n".join("".join(f"{cell:>16}" for cell in row) for row in rows)
