"""`draw`, `explain`, `equations`, `solve`, `check`: one position of a mechanism, drawn, written out and proved."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import click

from graphkin.cli import shared, streams
from graphkin.cli.shared import DriverOptions
from graphkin.cli.spoken import misused
from graphkin.cli.watching import each_mechanism
from graphkin.errors import GraphkinError, Lang
from graphkin.say.catalogue import say

if TYPE_CHECKING:
    from graphkin.construction import Plane
    from graphkin.outputs.paint import Ink
    from graphkin.sheet import Style


@click.command()
@each_mechanism
@shared.drawing_option
@click.option("--dpi", type=click.FloatRange(20, 2400), show_default="200, or 100 if it moves",
              help="Dots per inch of .png.")
@click.option("--only", type=click.Choice(["position", "velocity", "acceleration"]), help="This figure alone.")
@shared.paper_option
@click.option("--style", type=click.Choice(["construction", "result", "given"]), default="construction",
              show_default=True, help="How polygons are drawn, too; results; or only what is given, no answer.")
@click.option("--tight", is_flag=True, help="The figures alone, cut to their size, for Word and LaTeX.")
@click.option("--ink", type=click.Choice(["accent", "black"]), default="accent", show_default=True,
              help="A colour a plane, or black alone.")
@click.option("--path", "paths", multiple=True, metavar="POINT",
              help="The curve that a point draws, with ticks at equal steps of the driver; again for others.")
@click.option("--arrows", is_flag=True, help="With --path: the point's velocity at each tick.")
@shared.steps_option
@click.option("--animate", is_flag=True, help="Moving, as .svg or .png: a turn of the driver, or as far as it gets.")
@shared.force_option
@shared.coincident_option
@shared.method_option
@shared.driver_options
@shared.speaking
def draw(
    mechanism: str, output: Path | None, dpi: float | None, only: Plane | None, paper: str | None, style: Style,
    tight: bool, ink: Ink, paths: tuple[str, ...], arrows: bool, steps: Path | None, animate: bool, force: bool,
    coincident: str, method: str, at: DriverOptions, lang: Lang,
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
    _refuse_together(output, only, style, paths, arrows, steps)
    machine = shared.read(mechanism)
    alone = output is None and steps is not None
    output = _file(output, machine.name)
    if animate:
        still = steps or tight or style != "construction" or paths or at
        misused("usage.without", still, option="--animate", others="--steps, --tight, --style, --path, --angle, --at")
        misused("usage.suffix", output.suffix.lower() not in (".svg", ".png"), output=output, kinds=".svg, .png")
    drawing = shared.drawing(machine, at, coincident, method)
    if animate:
        with streams.waiting():
            drawing.animate(output, paper=paper, lang=lang, only=only, dpi=dpi or 100.0, ink=ink, force=force)
        click.echo(str(output))
        return
    kind = output if output.suffix else Path("-.svg")
    with streams.waiting():
        sheet = drawing.sheet(paper=paper, lang=lang, only=only, style=style, tight=tight, paths=paths, arrows=arrows)
        pages: list[tuple[Path, bytes | str]] = [(output, sheet.content(kind, dpi or 200.0, ink))]
        if steps is not None:
            sheets = drawing.step_sheets(paper=paper, lang=lang, only=only, tight=tight)
            pages += [(steps / f"{machine.name}-{k:02d}.svg", page.svg(ink)) for k, page in enumerate(sheets, 1)]
    shared.write_drawings(pages[alone:], None if alone else output, steps, force)
    if sheet.crowded:
        click.echo(say("sheet.crowded", lang, sheet=machine.name), err=True)


def _refuse_together(
    output: Path | None, only: Plane | None, style: Style, paths: tuple[str, ...], arrows: bool, steps: Path | None
) -> None:
    """Refuses options that contradict each other."""
    planes = only not in (None, "position")
    misused("usage.without", style == "given" and (steps or planes), option="--style given", others="--steps, --only")
    misused("usage.needs", arrows and not paths, option="--arrows", other="--path E")
    misused("usage.without", paths and (style == "given" or planes), option="--path", others="--style given, --only")
    ggb = output is not None and output.suffix.lower() == ".ggb"
    misused("usage.locus", ggb and paths)
    misused("usage.without", ggb and only, option=output, others="--only")


def _file(output: Path | None, name: str) -> Path:
    """The file of a mechanism's drawing; a folder is made."""
    if output is None or not shared.is_folder(output):
        return output or Path(f"{name}.svg")
    output.mkdir(parents=True, exist_ok=True)
    return output / f"{name}.svg"


@click.command()
@each_mechanism
@shared.coincident_option
@shared.method_option
@shared.driver_options
@click.option("--all", "everything", is_flag=True, help="All points and links, whatever the file asks for.")
@click.option("--only", type=click.Choice(["position", "velocity", "acceleration"]), default="acceleration",
              show_default=True, help="How far to go: the mechanism alone, or with velocities, or with both.")
@shared.svg_option(".html, .tex or .md; else printed.", kinds=(".html", ".tex", ".md"))
@shared.force_option
@click.option("--as-drawn", is_flag=True, help="Read lengths to 0.5 mm, as a hand does, and go on from that.")
@shared.speaking
def explain(
    mechanism: str, coincident: str, method: str, at: DriverOptions, everything: bool, only: Plane,
    output: Path | None, force: bool, as_drawn: bool, lang: Lang,
) -> None:  # fmt: skip
    """Write out the solution: what is given, the vector equations, what is laid off and measured, the answers.

    As far as the file asks; everything where it asks for nothing.

    \b
    Example:
      graphkin explain ex3-1 --lang zh
      graphkin explain p3-22 --only velocity
      graphkin explain mine.toml --watch
    """
    misused("usage.without", output and as_drawn, option="--as-drawn", others="-o")
    machine = shared.read(mechanism)
    with streams.waiting():
        drawing = shared.drawing(machine, at, coincident, method)
        lines = drawing.explain(lang, everything=everything, only=only, as_drawn=as_drawn) if output is None else []
    if output is None:
        click.echo("\n".join(lines))
        return
    from graphkin.handouts import markup
    from graphkin.outputs import files

    kind = output.suffix.lower()
    solution = markup.solution(drawing, lang, everything=everything, only=only, drawn=kind == ".html")
    text = markup.WRITERS[kind](solution)
    files.write(output, text, force, (markup.MARK.encode(), b"graphkin handout"))
    click.echo(str(output))


@click.command()
@shared.mechanisms_argument
@click.option("--method", type=click.Choice(["complex", "matrix"]), default="complex", show_default=True,
              help="Complex vectors, with closed forms; or one system of matrices.")
@shared.svg_option(".txt, .html or .tex; else printed.", kinds=(".txt", ".html", ".tex"))
@shared.force_option
@shared.driver_options
@shared.speaking
def equations(
    mechanisms: tuple[str, ...], method: Literal["complex", "matrix"], output: Path | None, force: bool,
    at: DriverOptions, lang: Lang,
) -> None:  # fmt: skip
    """Write out the analytic solution: loops of link vectors, their equations derived twice, closed forms or matrices.

    \b
    Example:
      graphkin equations ex3-5
      graphkin equations ex3-5 --angle 120
      graphkin equations ex3-7 --method matrix --lang zh -o shaper.html
    """
    from graphkin import equations as writing

    def document(source: str) -> writing.Document:
        return writing.document(shared.placed(source, at), method, lang)

    if output is None:
        shared.print_each(mechanisms, lambda source: writing.write_text(document(source)).splitlines(), False, lang)
        return
    misused("usage.one", len(mechanisms) > 1, option=f"-o {output}", what="MECHANISM")
    writing.write(output, document(mechanisms[0]), force)
    click.echo(str(output))


@click.command()
@shared.mechanisms_argument
@shared.text_option
@click.option("--json", "as_json", is_flag=True, help="One JSON object a line, SI units and radians.")
@shared.force_option
@shared.driver_options
@shared.speaking
def solve(
    mechanisms: tuple[str, ...], output: Path | None, as_json: bool, force: bool, at: DriverOptions, lang: Lang
) -> None:
    """Print all results, graphical beside analytic, and the answers to `ask`.

    \b
    Example:
      graphkin solve ex3-1
      graphkin solve ex3-7 --angle 120
      graphkin solve *.toml -o results.jsonl
    """
    data = shared.wants_json(as_json, output, len(mechanisms))
    shared.print_each(mechanisms, lambda source: _results(source, at, data, lang), data, lang, output, force)


def _results(source: str, at: DriverOptions, as_json: bool, lang: Lang) -> Iterator[str]:
    from graphkin import results
    from graphkin.say.results import solve_lines

    machine = shared.read(source)
    method, values = shared.position(machine, at)
    data = results.results(machine, method, lang, values)
    if as_json:
        yield shared.json_line(data)
    else:
        yield from solve_lines(machine, data, lang)


@click.command()
@click.argument("drawings", metavar="DRAWING.svg...", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option("--tolerance", type=click.FloatRange(min=0, min_open=True), default=0.01, show_default=True, metavar="MM",
              help="How far a vector or point may be off.")
@click.option("--json", "as_json", is_flag=True, help="One JSON object a drawing: mm on paper, and what is wrong.")
@shared.speaking
def check(drawings: tuple[Path, ...], tolerance: float, as_json: bool, lang: Lang) -> None:
    """Measure drawings with a ruler and hold them against the analytic solution.

    \b
    Example:
      graphkin check ex3-1.svg
      graphkin draw ex3-1 -o - | graphkin check -
    """
    from graphkin.check import measure
    from graphkin.say.results import check_json, check_lines

    misused("usage.finite", not math.isfinite(tolerance), option="--tolerance")
    status = 0
    for drawing in streams.counted(drawings, True):
        try:
            with streams.waiting(len(drawings) == 1):
                report = measure(drawing, tolerance)
        except GraphkinError as error:
            refused = {"format": 1, "file": str(drawing), "error": error.message(lang)}
            click.echo(shared.json_line(refused) if as_json else error.message(lang), err=not as_json)
            status = 3
            continue
        data = check_json(report, tolerance, lang) if as_json else None
        click.echo("\n".join(check_lines(report, lang, tolerance) if data is None else [shared.json_line(data)]))
        status = max(status, 0 if report.passed(tolerance) else 1)
    sys.exit(status)
