"""Markdown with its figures: files in a folder beside the page, which calls them by their places."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import quote

from planar_cli.commands._handed_out import PICTURE, with_pictures
from planar_cli.commands._output import write, write_files

if TYPE_CHECKING:
    from planar_cli.report.document.blocks import Block

FOLDER = "-figures"
"""The folder is called as the page is, with this behind."""
OURS = b"<svg xmlns="


def pictures_of(blocks: Iterable[Block]) -> dict[str, str]:
    """Figures by the names by which their Markdown calls them."""
    from planar_cli.formats._svg import picture
    from planar_cli.report.document.blocks import Drawing

    return dict(picture(b.figure) for b in blocks if isinstance(b, Drawing))


def write_with_pictures(text: str, pictures: dict[str, str], output: str) -> None:
    """A page in the file `output`, its figures with numbers in the folder beside it: page.md, page-figures/1.svg.

    The page is written last. Figures of an earlier page in the same place that this one has no more are removed.
    """
    page = Path(output)
    folder = page.with_name(f"{page.stem}{FOLDER}")
    # A link is read as an address: spaces and brackets of a name would end it.
    text, called = with_pictures(text, pictures, lambda i: f"{quote(folder.name)}/{i}{PICTURE}")
    files = [drawn.encode() for drawn in called.values()]
    if files:
        write_files({f"{i}{PICTURE}": drawn for i, drawn in enumerate(files, 1)}, str(folder))
    write(text, output, exact=True)
    _clear(folder, files)


def _clear(folder: Path, files: Sequence[bytes]) -> None:
    """Remove what figures of an earlier page are left behind the last."""
    number = len(files) + 1
    while (left := folder / f"{number}{PICTURE}").is_file() and not left.is_symlink():
        with left.open("rb") as stream:
            if stream.read(len(OURS)) != OURS:
                return
        left.unlink()
        number += 1
