"""`centres`: instant centres, found, drawn, explained, and what lies around them."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import click

from graphkin.cli.shared import (
    PAPERS,
    angle_option,
    at_option,
    at_values,
    force_option,
    json_line,
    lang_option,
    read,
    said,
)  # fmt: skip
from graphkin.errors import GraphkinError, Lang

__all__ = ["centres"]


@click.command()
@click.argument("mechanisms", metavar="MECHANISM...", nargs=-1, required=True)
@click.option("-o", "--output", type=click.Path(path_type=Path, dir_okay=False), help="SVG to write; - for stdout.")
@click.option("--steps", type=click.Path(path_type=Path, file_okay=False), help="One drawing a step, into this folder.")
@click.option("--fit", is_flag=True, help="A smaller scale, so that centres far off come onto the sheet.")
@click.option("--paper", type=click.Choice(PAPERS), help="Paper; else the smallest that fits.")
@click.option("--json", "as_json", is_flag=True, help="One JSON object a line, metres and radians.")
@force_option
@angle_option
@at_option
@lang_option
def centres(
    mechanisms: tuple[str, ...], output: Path | None, steps: Path | None, fit: bool, paper: str | None, as_json: bool,
    force: bool, angles: tuple[float, ...], displacements: tuple[float, ...], lang: Lang,
) -> None:  # fmt: skip
    """Find all instant centres, by definition and by Kennedy's lines: listed, explained, drawn.

    \b
    Example:
      graphkin centres fig3-4 -o centres.svg --lang zh
      graphkin centres ex3-7 --steps steps
      graphkin centres --json *.toml > centres.jsonl
    """
    if len(mechanisms) > 1 and (output or steps):
        raise click.UsageError("-o and --steps draw one mechanism")
    if output is not None and output.suffix.lower() != ".svg" and str(output) != "-":
        raise click.UsageError(f"{output}: the file to write must end in .svg")
    if output or steps:
        with said(lang):
            _draw(mechanisms[0], output, steps, fit, paper, force, angles, displacements, lang)
        return
    failed = False
    for k, source in enumerate(mechanisms):
        try:
            lines = list(_told(source, as_json, angles, displacements, lang))
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


def _told(
    source: str, as_json: bool, angles: tuple[float, ...], displacements: tuple[float, ...], lang: Lang
) -> Iterator[str]:
    from graphkin import api, reports
    from graphkin import centres as finding
    from graphkin.words.centre_explained import explain_centres

    method = api.plan(read(source))
    found = finding.centres(method, api.replay(method, at_values(method, angles, displacements)))
    if as_json:
        yield json_line(finding.as_json(found))
        return
    yield f"{method.mechanism.name}  {method.mechanism.headline(lang)}"
    yield from reports.table(list(finding.rows(found, lang)))
    yield ""
    yield from explain_centres(found, lang)


def _draw(
    source: str, output: Path | None, steps: Path | None, fit: bool, paper: str | None, force: bool,
    angles: tuple[float, ...], displacements: tuple[float, ...], lang: Lang,
) -> None:  # fmt: skip
    from graphkin import api
    from graphkin.centres import centres as find
    from graphkin.outputs import svg
    from graphkin.sheet.centre_sheet import centre_sheet, centre_step_sheets

    method = api.plan(read(source))
    found = find(method, api.replay(method, at_values(method, angles, displacements)))
    pages: list[tuple[Path, str]] = []
    if output is not None:
        pages.append((output, svg.svg(centre_sheet(found, paper=paper, lang=lang, fit=fit))))
    if steps is not None:
        pages += [
            (steps / f"{method.mechanism.name}-centres-{k:02d}.svg", svg.svg(page))
            for k, page in enumerate(centre_step_sheets(found, paper=paper, lang=lang, fit=fit), 1)
        ]
    if str(output) == "-":
        click.echo(pages.pop(0)[1], nl=False)
    if steps is not None:
        steps.mkdir(parents=True, exist_ok=True)
    for path, _ in pages:
        svg.refuse(path, force)
    for path, text in pages:
        svg.write(path, text, force)
        click.echo(str(path), err=str(output) == "-")
