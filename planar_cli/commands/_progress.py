"""A bar on standard error for what takes long."""

from __future__ import annotations

import time

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

from planar_cli.problem.nodes.show import harmless

PATIENCE = 1.0
"""So many seconds nothing is shown."""


class Bar:
    """How far a motion has been followed."""

    def __init__(self, title: str) -> None:
        self.title, self.began = title, time.monotonic()
        self._progress: Progress | None = None

    def show(self, t: float, until: float) -> None:
        """The motion has come to the time `t`; it goes to `until` [s]."""
        if self._progress is None:
            if time.monotonic() - self.began < PATIENCE:
                return
            columns = (TextColumn("{task.description}", markup=False), BarColumn(), TimeRemainingColumn())
            self._progress = Progress(*columns, console=Console(stderr=True), transient=True)
            self._progress.start()
            self._progress.add_task(harmless(self.title, kept=""), total=until)
        self._progress.update(self._progress.task_ids[0], completed=t, total=until)
        if t >= until:
            self._progress.stop()
            self._progress = None
            self.began = time.monotonic()
