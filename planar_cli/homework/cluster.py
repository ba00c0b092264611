"""A cluster of dask that runs already: its tasks grade batches, each on a worker of its own that can be killed."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from concurrent.futures import Executor
from contextlib import contextmanager
from typing import Any

from planar_cli.errors import PlanarError
from planar_cli.problem.show import visible

LONGEST_WAIT = 10.0
"""Seconds for the scheduler to answer."""


@contextmanager
def cluster(address: str) -> Iterator[Executor]:
    """The executor of the scheduler at an address, `tcp://host:8786`. Raises PlanarError where there is none."""
    try:
        # By name: whoever has no cluster need not have it.
        distributed: Any = importlib.import_module("distributed")
    except ImportError:
        raise PlanarError("a cluster needs the extra `cluster`: pip install 'planar-cli[cluster]'") from None
    try:
        client = distributed.Client(address, timeout=LONGEST_WAIT)
    except (OSError, ValueError) as error:
        raise PlanarError(visible(f"there is no scheduler at {address}: {error}")) from None
    with client:
        # A batch that ends the process of a worker is given once to another, not to one after the other.
        executor: Executor = client.get_executor(retries=0)
        yield executor
