"""Print the script that completes commands and options in a shell.

For bash: `eval "$(planar completion bash)"` in ~/.bashrc; for zsh the same with zsh in ~/.zshrc; for fish
`planar completion fish > ~/.config/fish/completions/planar.fish`.
"""

from __future__ import annotations

import click
from click.shell_completion import get_completion_class


@click.command(help=__doc__)
@click.argument("shell", type=click.Choice(["bash", "zsh", "fish"]))
def command(shell: str) -> int:
    """Print the script."""
    from planar_cli.by_click import cli

    completion = get_completion_class(shell)
    if completion is None:
        raise click.UsageError(f"there is no completion for {shell}")
    click.echo(completion(cli, {}, "planar", "_PLANAR_COMPLETE").source())
    return 0
