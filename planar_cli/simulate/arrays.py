"""A motion as arrays for NumPy: one array for each column, in a file `npz`."""

from __future__ import annotations

import io
from collections.abc import Mapping
from typing import Any

import numpy as np


def npz(data: Mapping[str, Any]) -> bytes:
    """The columns of all motions of a problem; those of a case have its name and a dot before theirs."""
    arrays: dict[str, Any] = {}
    for motion in (m for m in data["motions"] if "rows" in m):
        before = f"{motion['case']}." if motion["case"] else ""
        table = np.array(motion["rows"], dtype=float).reshape(-1, len(motion["columns"]))
        for i, column in enumerate(motion["columns"]):
            arrays[f"{before}{column['name']} [{column['unit']}]"] = table[:, i]
    stream = io.BytesIO()
    np.savez_compressed(stream, **arrays)
    return stream.getvalue()
