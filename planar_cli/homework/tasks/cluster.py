"""A cluster of dask: its tasks grade batches, each on a worker of its own that can be killed."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from concurrent.futures import Executor
from contextlib import contextmanager
from typing import Any

from planar_cli.errors import PlanarError
from planar_cli.problem.nodes.show import visible

LOCAL = "local"
LONGEST_WAIT = 10.0
"""Seconds for the scheduler to answer."""


@contextmanager
def cluster(address: str) -> Iterator[Executor]:
    """The executor of the scheduler at an address, `tcp://host:8786`, or of a cluster of this machine for `local`.

    Raises PlanarError where there is none.
    """
    try:
        # By name: whoever has no cluster need not have it.
        distributed: Any = importlib.import_module("distributed")
    except ImportError:
        raise PlanarError("a cluster needs the extra `cluster`: pip install 'planar-cli[cluster]'") from None
    try:
        # Of its own it starts as many processes as there are cores.
        own: dict[str, Any] = {"dashboard_address": ":0", "threads_per_worker": 1}
        given: dict[str, Any] = {"address": address, "timeout": LONGEST_WAIT}
        client = distributed.Client(**(own if address == LOCAL else given))
    except (OSError, ValueError) as error:
        raise PlanarError(visible(f"there is no scheduler at {address}: {error}")) from None
    with client:
        # A batch that ends the process of a worker is given once to another, not to one after the other.
        executor: Executor = client.get_executor(retries=0)
        yield executor
