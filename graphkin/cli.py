"""The commands: parse, call one function, print.

Exit status: 0 good, 1 a check failed, 2 wrong usage, 3 bad input.
"""

from __future__ import annotations

import functools
import gc
import json
import math
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import click

from graphkin.errors import GraphkinError, Lang

if TYPE_CHECKING:
    from graphkin.api import Drawing
    from graphkin.mechanism import Mechanism
    from graphkin.methods import Method
    from graphkin.steps import Plane
    from graphkin.sweeps import Course, Road

__all__ = ["main"]

LONG = 200_000
"""Positions from which a sweep shows how far it is."""
PAPERS = ("A4", "A4-landscape", "A3", "A3-landscape")
CONTEXT = {"help_option_names": ["-h", "--help"], "max_content_width": 100}


def user_language() -> Lang:
    """Chinese where the environment asks for it, else English."""
    for name in ("GRAPHKIN_LANG", "LC_ALL", "LC_MESSAGES", "LANG"):
        if value := os.environ.get(name):
            return "zh" if value.lower().startswith("zh") else "en"
    return "en"


lang_option = click.option(
    "--lang", type=click.Choice(["en", "zh"]), default=user_language, show_default="of your system",
    help="Language of texts and messages.",
)  # fmt: skip
angle_option = click.option(
    "--angle", "angles", type=float, multiple=True, metavar="DEG",
    help="Draw at this driver angle instead; once for each driver that has an angle, in order.",
)  # fmt: skip
at_option = click.option(
    "--at", "displacements", type=float, multiple=True, metavar="MM",
    help="Draw at this driven displacement instead; once for each driven slide, in order.",
)  # fmt: skip
coincident_option = click.option(
    "--coincident", default="", metavar="POINT",
    help="Look at sliding pairs in this point of theirs instead of the usual one.",
)  # fmt: skip
method_option = click.option(
    "--method", type=click.Choice(["special", "centre"]), default="special", show_default=True,
    help="Velocities of Class III groups: special point, or instant centre where two legs stand on the frame.",
)  # fmt: skip
mechanism_argument = click.argument("mechanism", metavar="MECHANISM")


@contextmanager
def said(lang: Lang) -> Iterator[None]:
    """Bad input becomes one message on stderr and exit status 3."""
    try:
        yield
    except GraphkinError as error:
        click.echo(error.message(lang), err=True)
        sys.exit(error.exit_code)
    except BrokenPipeError:
        raise
    except OSError as error:
        click.echo(f"{error.filename or ''}: {error.strerror or error}", err=True)
        sys.exit(3)


def speaking(command: Callable[..., None]) -> Callable[..., None]:
    """A command whose bad input is said in its `lang`."""

    @functools.wraps(command)
    def wrapped(*args: Any, lang: Lang, **kwargs: Any) -> None:
        with said(lang):
            command(*args, lang=lang, **kwargs)

    return wrapped


class Program(click.Group):
    """The commands as a process of their own (a test, which calls `main.main`, has its own settings).

    It ends soon: garbage is collected rarely, and the interpreter is not taken down module by module at the
    end, which would take a tenth of the whole time of `draw`. Files are written and closed by then.
    """

    def __call__(self, *args: Any, **kwargs: Any) -> Any:
        gc.set_threshold(200_000)
        status: object = 0
        try:
            super().__call__(*args, **kwargs)
        except SystemExit as end:
            status = end.code
        for stream in (sys.stdout, sys.stderr):
            with suppress(OSError, ValueError):
                stream.flush()
        os._exit(status if isinstance(status, int) else 0 if status is None else 1)


@click.group(cls=Program, context_settings=CONTEXT)
@click.version_option(package_name="graphkin")
def main() -> None:
    """Graphical kinematics for planar mechanisms.

    MECHANISM is a TOML file, a name from `graphkin list`, or - for standard input.

    \b
    Example:
      graphkin draw ex3-1
      graphkin show ex3-1 > mine.toml     (edit it, then)
      graphkin draw mine.toml
    """


def read(source: str) -> Mechanism:
    """The mechanism of a MECHANISM argument."""
    from graphkin import api, loading

    if source == "-":
        return loading.load_stream(sys.stdin.buffer, name="stdin", file="<stdin>")
    return api.load(source)


def drawn(
    machine: Mechanism, coincident: str, method: str, angles: Sequence[float], displacements: Sequence[float]
) -> Drawing:
    """The drawing that the options ask for."""
    from graphkin import api

    if coincident and coincident not in machine.points:
        raise click.UsageError(f"--coincident: {machine.name} has no point {coincident}")
    planned = api.plan(machine, coincident, centres=method == "centre")
    return api.Drawing(machine, planned, api.replay(planned, at_values(planned, angles, displacements)))


def at_values(method: Method, angles: Sequence[float], displacements: Sequence[float]) -> list[float] | None:
    """Driver values with those of the command line put in; None for the drawn position."""
    if not angles and not displacements:
        return None
    given: dict[str, list[float]] = {"angle": [math.radians(a) for a in angles], "spin": []}
    given["slide"] = [s / 1000 for s in displacements]
    if not all(math.isfinite(v) for values in given.values() for v in values):
        raise click.UsageError("--angle and --at take finite numbers")
    values = [given[d.kind].pop(0) if given[d.kind] else (d.value or 0.0) for d in method.drivers]
    for option, rest in (("--angle", given["angle"]), ("--at", given["slide"])):
        if rest:
            name = method.mechanism.name
            raise click.UsageError(f"{name} has no driver left for {option} (of {len(values)} drivers)")
    return values


@main.command()
@mechanism_argument
@click.option("-o", "--output", type=click.Path(path_type=Path, dir_okay=False), help="SVG to write; - for stdout.")
@click.option("--only", type=click.Choice(["position", "velocity", "acceleration"]), help="This figure alone.")
@click.option("--paper", type=click.Choice(PAPERS), help="Paper; else the smallest that fits.")
@click.option("--steps", type=click.Path(path_type=Path, file_okay=False), help="One drawing a step, into this folder.")
@click.option("--force", is_flag=True, help="Replace a file that graphkin did not write.")
@coincident_option
@method_option
@angle_option
@at_option
@lang_option
@speaking
def draw(
    mechanism: str, output: Path | None, only: Plane | None, paper: str | None, steps: Path | None, force: bool,
    coincident: str, method: str, angles: tuple[float, ...], displacements: tuple[float, ...], lang: Lang,
) -> None:  # fmt: skip
    """Draw the mechanism and its polygons to scale, as SVG.

    \b
    Example:
      graphkin draw ex3-1 -o sheet.svg --lang zh
      graphkin draw ex3-7 --angle 120 --steps steps
    """
    from graphkin.outputs import svg

    machine = read(mechanism)
    output = output or Path(f"{machine.name}.svg")
    if output.suffix.lower() != ".svg" and str(output) != "-":
        raise click.UsageError(f"{output}: the file to write must end in .svg")
    drawing = drawn(machine, coincident, method, angles, displacements)
    sheet = drawing.sheet(paper=paper, lang=lang, only=only)
    pages = [(output, svg.svg(sheet))]
    if steps is not None:
        pages += [
            (steps / f"{machine.name}-{k:02d}.svg", svg.svg(page))
            for k, page in enumerate(drawing.step_sheets(paper=paper, lang=lang, only=only), 1)
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


@main.command()
@mechanism_argument
@coincident_option
@method_option
@angle_option
@at_option
@lang_option
@speaking
def explain(
    mechanism: str, coincident: str, method: str, angles: tuple[float, ...], displacements: tuple[float, ...],
    lang: Lang,
) -> None:  # fmt: skip
    """Write out the vector equations, what is laid off, and what is measured.

    \b
    Example:
      graphkin explain ex3-1 --lang zh
    """

    machine = read(mechanism)
    drawing = drawn(machine, coincident, method, angles, displacements)
    click.echo("\n".join(drawing.explain(lang)))


@main.command()
@click.argument("mechanisms", metavar="MECHANISM...", nargs=-1, required=True)
@click.option("--json", "as_json", is_flag=True, help="One JSON object a line, SI units and radians.")
@lang_option
def solve(mechanisms: tuple[str, ...], as_json: bool, lang: Lang) -> None:
    """Print all results, graphical beside analytic, and the answers to `ask`.

    \b
    Example:
      graphkin solve ex3-1
      graphkin solve --json *.toml > results.jsonl
    """
    failed = False
    for k, source in enumerate(mechanisms):
        try:
            lines = list(_solved(source, as_json, lang))
            click.echo("\n".join(([""] if k and not as_json else []) + lines))
        except BrokenPipeError:
            raise
        except (GraphkinError, OSError) as error:
            failed = True
            message = error.message(lang) if isinstance(error, GraphkinError) else str(error)
            if as_json:
                name = Path(source).stem if source != "-" else "stdin"
                click.echo(_json({"format": 1, "name": name, "error": message}))
            else:
                click.echo(message, err=True)
    if failed:
        sys.exit(3)


def _solved(source: str, as_json: bool, lang: Lang) -> Iterator[str]:
    from graphkin import api, reports, results

    machine = read(source)
    found = results.results(machine, api.plan(machine), lang)
    if as_json:
        yield _json(found)
    else:
        yield from reports.solve_lines(machine, found, lang)


def _json(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


@main.command()
@click.argument("drawings", metavar="DRAWING.svg...", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option("--tolerance", type=click.FloatRange(min=0, min_open=True), default=0.01, show_default=True, metavar="MM",
              help="How far a vector or point may be off.")  # fmt: skip
@lang_option
def check(drawings: tuple[Path, ...], tolerance: float, lang: Lang) -> None:
    """Measure drawings with a ruler and hold them against the analytic solution.

    \b
    Example:
      graphkin check ex3-1.svg
    """
    from graphkin import reports
    from graphkin.check import measure

    if not math.isfinite(tolerance):
        raise click.UsageError("--tolerance takes a finite number")
    status = 0
    for drawing in drawings:
        try:
            report = measure(drawing, tolerance)
        except GraphkinError as error:
            click.echo(error.message(lang), err=True)
            status = 3
            continue
        click.echo("\n".join(reports.check_lines(report, tolerance, lang)))
        status = max(status, 0 if report.passed(tolerance) else 1)
    sys.exit(status)


@main.command()
@mechanism_argument
@click.option("--driver", "ranges", multiple=True, metavar="[NAME=]FROM:TO:STEP",
              help="Driver values, deg or mm; again for each further driver; NAME=VALUE holds one still.")  # fmt: skip
@click.option("--of", default="", metavar="QUANTITIES",
              help='Such as "theta 3, v E, a_k B3B2"; else what the file asks.')  # fmt: skip
@click.option("--by", type=click.Choice(["construction", "analysis"]), default="construction", show_default=True,
              help="Replay the construction at every position, or solve the loop equations there.")  # fmt: skip
@click.option("-o", "--output", type=click.Path(path_type=Path, dir_okay=False),
              help=".csv, .json, .parquet, or a diagram: .svg, .png, .pdf; - for CSV on stdout.")  # fmt: skip
@click.option("--table", is_flag=True, help="Print as table 3-1 of the textbook: deg and m, five decimals.")
@click.option("--limit", "limits", multiple=True, metavar="QUANTITY VALUE",
              help='Say where a size is passed, such as "a E 3 g".')  # fmt: skip
@click.option("--force", is_flag=True, help="Replace a file that graphkin did not write.")
@lang_option
@speaking
def sweep(
    mechanism: str, ranges: tuple[str, ...], of: str, by: Literal["construction", "analysis"], output: Path | None,
    table: bool, limits: tuple[str, ...], force: bool, lang: Lang,
) -> None:  # fmt: skip
    """Move the mechanism through a turn, or as far as it gets: tables and motion diagrams.

    \b
    Example:
      graphkin sweep ex3-7 --table
      graphkin sweep p3-20 --driver 0:360:1 -o needle.csv
      graphkin sweep ex3-7 --of "theta 3, omega 3, alpha 3, s ram, v E, a E" -o diagram.svg
    """
    from graphkin import api, reports, sweeps

    method = api.plan(read(mechanism))
    course = sweeps.course(method, ranges)
    names = sweeps.asked(method.mechanism, sweeps.split(of))
    if output is None:
        found = sweeps.sweep_over(course, names, by)
        click.echo("\n".join(reports.book_lines(found) if table else reports.sweep_lines(found)))
        for line in (*sweeps.remarks(course, lang), *sweeps.extremes(found, lang)):
            click.echo(line, err=table)
    else:
        _write_sweep(output, course, names, by, force, lang)
        for line in sweeps.remarks(course, lang):
            click.echo(line, err=True)


def _write_sweep(
    output: Path, course: Course, names: tuple[str, ...], by: Road, force: bool, lang: Lang
) -> None:
    from graphkin.outputs import tables
    from graphkin.sweeps import parts

    suffix = output.suffix.lower()
    if str(output) == "-":
        for lines in tables.csv_lines(course, parts(course, names, by)):
            click.echo(lines, nl=False)
        return
    if suffix in tables.FORMATS:
        with click.progressbar(length=course.t.size, file=sys.stderr, hidden=course.t.size < LONG) as bar:
            tables.write(output, course, names, by, force, bar.update)
    elif suffix in (".svg", ".png", ".pdf"):
        from graphkin.outputs import diagram

        if (remark := diagram.write(output, course, names, lang, by, force)) is not None:
            click.echo(remark.message(lang), err=True)
    else:
        raise click.UsageError(f"{output}: the file to write must end in .csv, .json, .parquet, .svg, .png or .pdf")
    click.echo(str(output))


@main.command("list")
@lang_option
@speaking
def list_(lang: Lang) -> None:
    """List the mechanisms of the library.

    \b
    Example:
      graphkin list --lang zh
    """
    from graphkin import library

    for name, title in library.titles(lang).items():
        click.echo(f"{name:<12}{title}")


@main.command()
@click.argument("name")
@lang_option
@speaking
def show(name: str, lang: Lang) -> None:
    """Print the TOML file of a library mechanism, to start one's own from.

    \b
    Example:
      graphkin show ex3-1 > mine.toml
    """
    from graphkin import library

    click.echo(library.text(name), nl=False)


@main.command()
@mechanism_argument
@lang_option
@speaking
def structure(mechanism: str, lang: Lang) -> None:
    """List links, pairs, degrees of freedom and the Assur groups in the order they are solved.

    \b
    Example:
      graphkin structure p3-15
    """
    from graphkin import api, assur

    for line in assur.structure_lines(api.plan(read(mechanism)), lang):
        click.echo(line)


@main.command()
def schema() -> None:
    """Print the JSON Schema of the mechanism file, for editors.

    \b
    Example:
      graphkin schema > graphkin.schema.json
    """
    from graphkin import loading

    click.echo(loading.json_schema_text(), nl=False)


if __name__ == "__main__":
    main()
