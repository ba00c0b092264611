"""`planar` and `python -m planar_cli`: the help page at once, everything else by the command line."""

from __future__ import annotations

import gc
import os
import sys

TYPE_CHECKING = False
if TYPE_CHECKING:
    from signal import SIGINT, default_int_handler, getsignal, signal
    from types import FrameType
    from typing import NoReturn
else:
    # The core of `signal`, and no `typing`: until Ctrl-C is heard below, the less is loaded the better.
    from _signal import SIGINT, default_int_handler, getsignal, signal

INTERRUPTED = 130
"""The exit status after Ctrl-C, 128 and the number of the signal."""


def main() -> None:
    """Run the command line and leave with its exit status."""
    if getsignal(SIGINT) is default_int_handler:
        signal(SIGINT, _interrupted)
    if sys.argv[1:] in (["--help"], ["-h"]):
        from planar_cli.help_page import show

        try:
            show()
            return
        except OSError:
            # It cannot be written; the command line tells why.
            pass
    from planar_cli.later import CLUTTER, defer

    gc.set_threshold(CLUTTER, 20, 20)
    from planar_cli.cli import run

    defer()
    _leave(run())


def _interrupted(number: int, frame: FrameType | None) -> None:
    """Ctrl-C: what goes on is given up. While a module is loaded the process ends at once: an exception there may be
    taken for a failure of the module, or told with its traceback.
    """
    while frame is not None:
        # Before the command line is there, nobody is who would tell of it.
        if frame.f_code.co_filename.startswith("<frozen importlib") or "planar_cli.cli" not in sys.modules:
            os.write(2, b"\n")
            os._exit(INTERRUPTED)
        frame = frame.f_back
    raise KeyboardInterrupt


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
