"""Every diagnostic code that the program can print is explained by `planar explain CODE`."""

from __future__ import annotations

import re
from pathlib import Path

from planar_cli.manual import codes

SOURCE = Path(__file__).parent.parent / "planar_cli"


def test_every_code_is_explained() -> None:
    texts = [path.read_text(encoding="utf-8") for path in SOURCE.rglob("*.py")]
    used = {code for text in texts for code in re.findall(r'"(PL[0-9]{3})"', text)}
    assert used - set(codes()) == set()
