"""Explain a kind of joint or load, a part of the problem language, or an error code.

TOPIC is a kind such as `rope`, a page such as `points` or `quantities`, or a code such as PL301. Without it, all topics
are listed.
"""

from __future__ import annotations

import click

from planar_cli.manual import explanation, topics
from planar_cli.streams import echo


@click.command(help=__doc__)
@click.argument("topic", required=False)
def command(topic: str | None) -> int:
    """Print one page, or the list of pages."""
    echo(topics() if topic is None else explanation(topic))
    return 0
