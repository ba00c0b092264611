"""Where commands write: standard output, or a file that appears whole or not at all."""

from __future__ import annotations

import os
import stat
from collections.abc import Mapping
from typing import TYPE_CHECKING

from planar_cli.errors import PlanarError
from planar_cli.problem.nodes.show import harmless
from planar_cli.streams import echo

if TYPE_CHECKING:
    from pathlib import Path

DEVICES = (("/", "dev"), ("/", "proc"))
NO_FILE = "it is a pipe or a device, no ordinary file; leave `-o` out and write `> FILE` behind the command"


def write(text: str, output: str | None, styled: bool = False, exact: bool = False) -> None:
    """Write to the file `output`, or to standard output where there is none or it is `-`.

    `styled`: the text has colours for a terminal, put there by a format that took care of what the text says.
    `exact`: data for programs, which keep all letters wherever they go.
    """
    shown = text if styled else harmless(text)
    if output in (None, "-"):
        echo(shown, end="", exact=exact)
        return
    write_bytes(shown.encode(), output or "")


def write_files(files: Mapping[str, bytes], folder: str) -> None:
    """Write files below a folder, which is made where it is not there. Their names never lead out of it."""
    from pathlib import Path

    root = Path(folder)
    for name, data in files.items():
        target = root.joinpath(*name.split("/"))
        if not target.resolve().is_relative_to(root.resolve()):
            raise PlanarError(f"cannot write {name}: it does not lie in {folder}")
        try:
            target.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise PlanarError(f"cannot write {target}: {error.strerror}") from error
        _replace(target, data)


def write_bytes(data: bytes, output: str) -> None:
    """Write to the file `output`."""
    from pathlib import Path

    _replace(Path(output), data)


def _replace(target: Path, data: bytes) -> None:
    """The data go to a new file beside the target first: a planted link is replaced, never followed."""
    import tempfile

    _demand_file(target)

    try:
        # mkstemp creates with O_EXCL and O_NOFOLLOW, readable by the owner alone until the mode is set.
        handle, name = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name[:40]}-", suffix=".part")
    except OSError as error:
        raise PlanarError(f"cannot write {target}: {error.strerror}") from error
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
            stream.flush()
            os.fsync(stream.fileno())
        os.chmod(name, 0o666 & ~_umask())
        os.replace(name, target)
    except BaseException as error:
        os.unlink(name)
        if not isinstance(error, OSError):
            raise
        raise PlanarError(f"cannot write {target}: {error.strerror}") from error


def _demand_file(target: Path) -> None:
    """PlanarError for a folder, a pipe or a device, which would be gone afterwards; so for a link to one, and for any
    name among those of devices: `/dev/stdout` is a link to whatever the output is.
    """
    if target.parent.resolve().parts[:2] in DEVICES:
        raise PlanarError(f"cannot write {target}: {NO_FILE}")
    try:
        mode = target.stat().st_mode
    except OSError:
        return  # Nothing is there, or a link to nothing; what keeps it from being made is told when it is made.
    if not stat.S_ISREG(mode):
        raise PlanarError(f"cannot write {target}: {'it is a folder' if stat.S_ISDIR(mode) else NO_FILE}")


def _umask() -> int:
    """The mask of new files; it can only be read by setting it."""
    mask = os.umask(0o077)
    os.umask(mask)
    return mask
