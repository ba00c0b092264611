"""Sheets and keys of an earlier run in the same folder: those that `planar key` wrote are removed, others are told."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Mapping
from pathlib import Path

from planar_cli.errors import PlanarError
from planar_cli.problem.nodes.show import visible
from planar_cli.streams import echo

MANIFEST = ".planar-key.json"
"""The names of the files that were written, with the digests of what stands in them."""
OF_A_KEY = re.compile(r"(sheet|key)(-[a-z0-9_-]+)?\.(md|html|tex|pdf|json|csv|svg)")
MOST_BYTES = 8_000_000


WORKED = "worked solutions in"
"""Under this name the manifest has the key that holds worked solutions."""


def manifest(files: Mapping[str, bytes], worked: str) -> bytes:
    """What is to be known of the files of this run by the next. `worked`: the key with worked solutions; "": none."""
    told = {name: _digest(data) for name, data in sorted(files.items())} | ({WORKED: worked} if worked else {})
    return (json.dumps(told, indent=1) + "\n").encode()


def demand_no_loss(folder: str, way: str) -> None:
    """PlanarError where a key with worked solutions stands, which a run without them would remove or write over.
    `way`: what to do so that the new key has them too; "": its format has none.
    """
    key = _written(Path(folder) / MANIFEST).get(WORKED, "")
    if OF_A_KEY.fullmatch(key) and (Path(folder) / key).exists():
        there = visible(str(Path(folder) / key))
        raise PlanarError(
            f"{there} holds worked solutions, which this run would leave out: "
            f"{f'{way}, or name' if way else 'name'} another folder"
        )


def clear(folder: str, files: Mapping[str, bytes]) -> None:
    """Remove sheets and keys that an earlier run wrote and this one does not; what was changed since, or is of another
    hand, stays and is told.
    """
    root = Path(folder)
    if not root.is_dir():
        return
    written = _written(root / MANIFEST)
    for path in sorted(root.iterdir()):
        name = path.name
        if name in files or not OF_A_KEY.fullmatch(name) or path.is_symlink() or not path.is_file():
            continue
        if written.get(name) == _digest(path.read_bytes()):
            path.unlink()
        else:
            echo(
                visible(f"warning: {path} is not of this run, and was not written by planar as it is; it stays"),
                err=True,
            )


def _digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


def _written(path: Path) -> dict[str, str]:
    """Names with digests; none where the file is not there or is no such list."""
    try:
        if path.is_symlink() or path.stat().st_size > MOST_BYTES:
            return {}
        found = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return {n: d for n, d in found.items() if isinstance(d, str)} if isinstance(found, dict) else {}
