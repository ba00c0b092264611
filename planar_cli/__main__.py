"""`planar` and `python -m planar_cli`: the help page at once, everything else by the command line."""

from __future__ import annotations

import gc
import os
import sys
from typing import NoReturn

CLUTTER = 400_000
"""So many objects more are looked through for what nobody needs: most of what is made at a start lives to the end."""


def main() -> None:
    """Run the command line and leave with its exit status."""
    if sys.argv[1:] in (["--help"], ["-h"]):
        from planar_cli.help_page import show

        try:
            show()
            return
        except OSError:
            # It cannot be written; the command line tells why.
            pass
    gc.set_threshold(CLUTTER, 20, 20)
    from planar_cli.cli import run

    _leave(run())


def _leave(status: int) -> NoReturn:
    """End the process at once: to take apart what goes with it anyway takes as long as a third of importing SymPy."""
    try:
        for stream in (sys.stdout, sys.stderr):
            stream.flush()
    except OSError:
        # The interpreter tells it its own way.
        sys.exit(status)
    os._exit(status)


if __name__ == "__main__":
    main()
