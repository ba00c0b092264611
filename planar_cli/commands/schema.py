"""Print the JSON Schema of problem files, for completion and checks in editors.

Save it with `planar schema > planar.schema.json`, and begin a problem file with the line
`# yaml-language-server: $schema=planar.schema.json`.
"""

from __future__ import annotations

import json

import click


@click.command(help=__doc__)
def command() -> int:
    """Print the schema."""
    from planar_cli.problem.sections.schema import schema

    click.echo(json.dumps(schema(), ensure_ascii=False, indent=2))
    return 0
