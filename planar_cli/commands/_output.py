"""Where commands write: standard output, or a file that appears whole or not at all."""

from __future__ import annotations

import os
from pathlib import Path

import click

from planar_cli.errors import PlanarError


def write(text: str, output: str | None) -> None:
    """Write to the file `output`, or to standard output where there is none or it is `-`."""
    if output in (None, "-"):
        click.echo(text, nl=False)
        return
    _replace(Path(output or ""), text.encode())


def write_bytes(data: bytes, output: str) -> None:
    """Write to the file `output`."""
    _replace(Path(output), data)


def _replace(target: Path, data: bytes) -> None:
    """The data go to a new file beside the target first: a planted link is replaced, never followed."""
    import tempfile

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
    except OSError as error:
        os.unlink(name)
        raise PlanarError(f"cannot write {target}: {error.strerror}") from error


def _umask() -> int:
    """The mask of new files; it can only be read by setting it."""
    mask = os.umask(0o077)
    os.umask(mask)
    return mask
