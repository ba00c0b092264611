"""What several tests share."""

from __future__ import annotations

from pathlib import Path

from planar_cli.later import defer

ROOT = Path(__file__).parent.parent
PROBLEMS = sorted(p for p in (ROOT / "problems").rglob("*.yaml") if p.parent.name != "hard")
"""All files with a printed page that is kept; those in `hard` are held by their answers alone."""

# As on the command line, before any test loads SymPy.
defer()
