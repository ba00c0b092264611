"""`planar` and `python -m planar_cli`: the help page at once, everything else by the command line."""

from __future__ import annotations

import gc
import sys

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
    from planar_cli.cli import main as command_line

    try:
        command_line()
    finally:
        # What is left goes with the process: at its end nobody has to look through it for what is out of use, which
        # takes as long as a third of importing SymPy.
        gc.freeze()


if __name__ == "__main__":
    main()
