"""`draw`, `explain`, `solve`, `check`: one position of a mechanism, drawn and proved."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphkin.cli.each import each_mechanism
from graphkin.cli.shared import (
    PAPERS,
    angle_option,
    as_told,
    at_option,
    at_values,
    coincident_option,
    drawing_option,
    drawn,
    force_option,
    is_folder,
    json_line,
    lang_option,
    mechanisms_argument,
    method_option,
    planned,
    read,
    speaking,
    told_each,
    told_option,
)  # fmt: skip
from graphkin.errors import GraphkinError, Lang

if TYPE_CHECKING:
    from graphkin.api import Drawing
    from graphkin.construction import Plane
    from graphkin.outputs.paint import Ink
    from graphkin.planning import Method
    from graphkin.sheet import Style


@click.command()
@each_mechanism
@drawing_option
@click.option("--dpi", type=click.FloatRange(20, 2400), show_default="200, or 100 if it moves",
              help="Dots per inch of .png.")
@click.option("--only", type=click.Choice(["position", "velocity", "acceleration"]), help="This figure alone.")
@click.option("--paper", type=click.Choice(PAPERS), help="Paper; else the smallest that fits.")
@click.option("--style", type=click.Choice(["construction", "result", "given"]), default="construction",
              show_default=True, help="How polygons are drawn, too; results; or only what is given, no answer.")
@click.option("--tight", is_flag=True, help="The figures alone, cut to their size, for Word and LaTeX.")
@click.option("--ink", type=click.Choice(["accent", "black"]), default="accent", show_default=True,
              help="A colour a plane, or black alone.")
@click.option("--path", "paths", multiple=True, metavar="POINT",
              help="The curve that a point draws, with ticks at equal steps of the driver; again for others.")
@click.option("--arrows", is_flag=True, help="With --path: the point's velocity at each tick.")
@click.option("--steps", type=click.Path(path_type=Path, file_okay=False), help="One drawing a step, into this folder.")
@click.option("--animate", is_flag=True, help="Moving, as .svg or .png: a turn of the driver, or as far as it gets.")
@force_option
@coincident_option
@method_option
@angle_option
@at_option
@lang_option
@speaking
def draw(
    mechanism: str, output: Path | None, dpi: float | None, only: Plane | None, paper: str | None, style: Style,
    tight: bool, ink: Ink, paths: tuple[str, ...], arrows: bool, steps: Path | None, animate: bool, force: bool,
    coincident: str, method: str,
    angles: tuple[float, ...], displacements: tuple[float, ...], lang: Lang,
) -> None:  # fmt: skip
    """Draw the mechanism and its polygons to scale: a sheet, or a construction that moves in GeoGebra (.ggb).

    \b
    Example:
      graphkin draw ex3-1 -o sheet.svg --lang zh
      graphkin draw ex3-1 -o sheet.pdf
      graphkin draw *.toml -o sheets
      graphkin draw ex3-7 --angle 120 --steps steps
      graphkin draw ex3-7 --animate -o shaper.svg
      graphkin draw p3-20 --path E --arrows
      graphkin draw mine.toml --watch
    """
    from graphkin.outputs import drawings, svg

    if style == "given" and (steps is not None or only not in (None, "position")):
        raise click.UsageError("--style given draws the mechanism alone: leave out --steps and other planes")
    _check_paths(paths, arrows, style, only, output)
    machine = read(mechanism)
    output = _file(output, machine.name)
    if animate:
        if steps is not None or tight or style != "construction" or paths or angles or displacements:
            raise click.UsageError(
                "--animate shows the motion: leave out --steps, --tight, --style, --path, --angle and --at"
            )
        _write_motion(output, planned(machine, coincident, method), paper, only, dpi or 100.0, ink, force, lang)
        return
    drawing = drawn(machine, coincident, method, angles, displacements)
    sheet = drawing.sheet(paper=paper, lang=lang, only=only, style=style, tight=tight, paths=paths, arrows=arrows)
    written = drawings.WRITERS[output.suffix.lower() or ".svg"]
    pages = [(output, written(drawings.DrawingSource(sheet, drawing.method, drawing.plot, lang, dpi or 200.0, ink)))]
    if steps is not None:
        pages += [
            (steps / f"{machine.name}-{k:02d}.svg", svg.svg(page, ink).encode())
            for k, page in enumerate(drawing.step_sheets(paper=paper, lang=lang, only=only, tight=tight), 1)
        ]
    _write(pages, output, steps, force)


def _write(pages: list[tuple[Path, bytes]], output: Path, steps: Path | None, force: bool) -> None:
    """The sheet and its steps; all are made, and may be written, before the first is."""
    from graphkin.outputs import drawings
    from graphkin.outputs.drawings import refuse_edited

    if str(output) == "-":
        click.echo(pages.pop(0)[1].decode(), nl=False)
    if steps is not None:
        steps.mkdir(parents=True, exist_ok=True)
    for path, _ in pages:
        drawings.refuse(path, force)
    refuse_edited(output, force)
    for path, content in pages:
        drawings.write(path, content, force)
        click.echo(str(path), err=str(output) == "-")


def _file(output: Path | None, name: str) -> Path:
    """Where a mechanism's drawing goes; a folder is made."""
    if output is None or not is_folder(output):
        return output or Path(f"{name}.svg")
    output.mkdir(parents=True, exist_ok=True)
    return output / f"{name}.svg"


def _check_paths(paths: tuple[str, ...], arrows: bool, style: Style, only: Plane | None, output: Path | None) -> None:
    if arrows and not paths:
        raise click.UsageError("--arrows draws velocities along a path: --path E")
    if paths and (style == "given" or only not in (None, "position")):
        raise click.UsageError("--path is drawn with the mechanism, as a result: leave out --style given and --only")
    if paths and output is not None and output.suffix.lower() == ".ggb":
        raise click.UsageError("GeoGebra draws paths itself, as Locus(E, slider): leave out --path")
    if only is not None and output is not None and output.suffix.lower() == ".ggb":
        raise click.UsageError("in GeoGebra each figure moves with the one before: leave out --only")


def _write_motion(
    output: Path, method: Method, paper: str | None, only: Plane | None, dpi: float, ink: Ink, force: bool, lang: Lang
) -> None:
    """The whole motion, one sheet a position, as a file that moves."""
    from graphkin.outputs import drawings
    from graphkin.outputs.drawings import refuse_edited
    from graphkin.sheet.motion_frames import motion_frames

    if (moving := drawings.MOVING.get(output.suffix.lower())) is None:
        raise click.UsageError(f"{output}: what moves must end in {' or '.join(drawings.MOVING)}")
    drawings.refuse(output, force)
    refuse_edited(output, force)
    frames = motion_frames(method, paper=paper, lang=lang, only=only)
    drawings.write(output, moving(frames, dpi, ink), force)
    click.echo(str(output))


@click.command()
@each_mechanism
@coincident_option
@method_option
@angle_option
@at_option
@click.option("--all", "everything", is_flag=True, help="All points and links, whatever the file asks for.")
@click.option(
    "--only", type=click.Choice(["position", "velocity", "acceleration"]), default="acceleration", show_default=True,
    help="How far to go: the mechanism alone, or with velocities, or with both.",
)  # fmt: skip
@click.option("-o", "--output", type=click.Path(path_type=Path, dir_okay=False),
              help=".html, .tex or .md; else printed.")  # fmt: skip
@force_option
@click.option("--as-drawn", is_flag=True, help="Read lengths to 0.5 mm, as a hand does, and go on from that.")
@lang_option
@speaking
def explain(
    mechanism: str, coincident: str, method: str, angles: tuple[float, ...], displacements: tuple[float, ...],
    everything: bool, only: Plane, output: Path | None, force: bool, as_drawn: bool, lang: Lang,
) -> None:  # fmt: skip
    """Write out the solution: what is given, the vector equations, what is laid off and measured, the answers.

    As far as the file asks; everything where it asks for nothing.

    \b
    Example:
      graphkin explain ex3-1 --lang zh
      graphkin explain p3-22 --only velocity
      graphkin explain mine.toml --watch
    """

    if output is not None and output.suffix.lower() not in (".html", ".tex", ".md"):
        raise click.UsageError(f"{output}: the file to write must end in .html, .tex or .md")
    if output is not None and as_drawn:
        raise click.UsageError("--as-drawn is printed: leave out -o")
    machine = read(mechanism)
    drawing = drawn(machine, coincident, method, angles, displacements)
    if output is not None:
        _write_solution(output, drawing, everything, only, force, lang)
        return
    click.echo("\n".join(drawing.explain(lang, everything=everything, only=only, as_drawn=as_drawn)))


def _write_solution(output: Path, drawing: Drawing, everything: bool, only: Plane, force: bool, lang: Lang) -> None:
    from graphkin.handouts import written
    from graphkin.outputs.files import beside

    found = written.solution(drawing, lang, everything=everything, only=only)
    text = written.WRITERS[output.suffix.lower()](found)
    with beside(output, force, (written.MARK.encode(), b"graphkin handout")) as draft:
        draft.write_text(text, encoding="utf-8", newline="\n")
    click.echo(str(output))


@click.command()
@mechanisms_argument
@told_option
@click.option("--json", "as_json", is_flag=True, help="One JSON object a line, SI units and radians.")
@force_option
@angle_option
@at_option
@lang_option
@speaking
def solve(
    mechanisms: tuple[str, ...], output: Path | None, as_json: bool, force: bool, angles: tuple[float, ...],
    displacements: tuple[float, ...], lang: Lang,
) -> None:  # fmt: skip
    """Print all results, graphical beside analytic, and the answers to `ask`.

    \b
    Example:
      graphkin solve ex3-1
      graphkin solve ex3-7 --angle 120
      graphkin solve *.toml -o results.jsonl
    """
    data = as_told(as_json, output, len(mechanisms))
    told_each(mechanisms, lambda source: _solved(source, data, angles, displacements, lang), data, lang, output, force)


def _solved(
    source: str, as_json: bool, angles: tuple[float, ...], displacements: tuple[float, ...], lang: Lang
) -> Iterator[str]:
    from graphkin import api, results
    from graphkin.say.results import solve_lines

    machine = read(source)
    method = api.plan(machine)
    found = results.results(machine, method, lang, at_values(method, angles, displacements))
    if as_json:
        yield json_line(found)
    else:
        yield from solve_lines(machine, found, lang)


@click.command()
@click.argument("drawings", metavar="DRAWING.svg...", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option("--tolerance", type=click.FloatRange(min=0, min_open=True), default=0.01, show_default=True, metavar="MM",
              help="How far a vector or point may be off.")  # fmt: skip
@click.option("--json", "as_json", is_flag=True, help="One JSON object a drawing: mm on paper, and what is wrong.")
@lang_option
@speaking
def check(drawings: tuple[Path, ...], tolerance: float, as_json: bool, lang: Lang) -> None:
    """Measure drawings with a ruler and hold them against the analytic solution.

    \b
    Example:
      graphkin check ex3-1.svg
      graphkin draw ex3-1 -o - | graphkin check -
    """
    from graphkin.check import measure
    from graphkin.say.checks import check_json, check_lines

    if not math.isfinite(tolerance):
        raise click.UsageError("--tolerance takes a finite number")
    status = 0
    for drawing in drawings:
        try:
            report = measure(drawing, tolerance)
        except GraphkinError as error:
            refused = {"format": 1, "file": str(drawing), "error": error.message(lang)}
            click.echo(json_line(refused) if as_json else error.message(lang), err=not as_json)
            status = 3
            continue
        lines = [json_line(check_json(report, tolerance, lang))] if as_json else check_lines(report, tolerance, lang)
        click.echo("\n".join(lines))
        status = max(status, 0 if report.passed(tolerance) else 1)
    sys.exit(status)
