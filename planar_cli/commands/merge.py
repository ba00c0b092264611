"""Put results files of several shards together.

FILES are results files that `planar check --set … --results` has written. Every submission stands in the output once,
with its latest line. Files that were graded with different keys are refused.
"""

from __future__ import annotations

from planar_cli import cli
from planar_cli.commands._output import write
from planar_cli.options import argument, option
from planar_cli.options import command as declared


@declared(help=__doc__)
@argument("files")
@option("-o", "--output", metavar="FILE", help="Write to FILE instead of standard output.")
def command(files: tuple[str, ...], output: str | None) -> int:
    """One results file out of several."""
    from planar_cli.homework.tasks.results import merge

    write("".join(f"{line}\n" for line in merge(files)), output, exact=True)
    return cli.SOLVED
