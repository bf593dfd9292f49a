"""`centres`: instant centres, found, drawn, and used."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import click

from graphkin.cli.shared import json_line, lang_option, read
from graphkin.errors import GraphkinError, Lang

__all__ = ["centres"]


@click.command()
@click.argument("mechanisms", metavar="MECHANISM...", nargs=-1, required=True)
@click.option("--json", "as_json", is_flag=True, help="One JSON object a line, metres and radians.")
@lang_option
def centres(mechanisms: tuple[str, ...], as_json: bool, lang: Lang) -> None:
    """Find all instant centres, by definition and by Kennedy's lines.

    \b
    Example:
      graphkin centres fig3-4
      graphkin centres --json *.toml > centres.jsonl
    """
    failed = False
    for k, source in enumerate(mechanisms):
        try:
            lines = list(_found(source, as_json, lang))
            click.echo("\n".join(([""] if k and not as_json else []) + lines))
        except BrokenPipeError:
            raise
        except (GraphkinError, OSError) as error:
            failed = True
            message = error.message(lang) if isinstance(error, GraphkinError) else str(error)
            if as_json:
                name = Path(source).stem if source != "-" else "stdin"
                click.echo(json_line({"format": 1, "name": name, "error": message}))
            else:
                click.echo(message, err=True)
    if failed:
        sys.exit(3)


def _found(source: str, as_json: bool, lang: Lang) -> Iterator[str]:
    from graphkin import api, reports
    from graphkin import centres as finding

    method = api.plan(read(source))
    found = finding.centres(method, api.replay(method))
    if as_json:
        yield json_line(finding.as_json(found))
        return
    yield f"{method.mechanism.name}  {method.mechanism.headline(lang)}"
    yield from reports.table(list(finding.rows(found, lang)))
