"""Shared by the commands: options, languages, the position of a mechanism, printing and writing."""

from __future__ import annotations

import functools
import json
import math
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

import click

from graphkin.base.value import frozen
from graphkin.cli import streams
from graphkin.cli.spoken import misused, user_language
from graphkin.errors import GraphkinError, Lang
from graphkin.outputs import drawings

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

    from graphkin.api import Drawing
    from graphkin.model.mechanism import Mechanism
    from graphkin.planning import Method

_Command = TypeVar("_Command", bound=Callable[..., object])

PAPERS = ("A4", "A4-landscape", "A3", "A3-landscape", "letter", "letter-landscape")
DRAWN_AS = drawings.DRAWN
"""The kinds of files that a position is drawn as: those of `outputs.drawings`."""


# --- options ----------------------------------------------------------------------------------


lang_option = click.option(
    "--lang", type=click.Choice(["en", "zh"]), default=user_language, show_default="of your system",
    help="Language of texts and messages.",
)  # fmt: skip
angle_option = click.option("--angle", "angles", type=float, multiple=True, metavar="DEG",
    help="Draw at this driver angle instead; once for each driver that has an angle, in order.")  # fmt: skip
displacement_option = click.option("--at", "displacements", type=float, multiple=True, metavar="MM",
    help="Draw at this driven displacement instead; once for each driven slide, in order.")  # fmt: skip
coincident_option = click.option("--coincident", default="", metavar="POINT",
    help="Look at sliding pairs in this point of theirs instead of the usual one.")  # fmt: skip
method_option = click.option(
    "--method", type=click.Choice(["special", "centre"]), default="special", show_default=True,
    help="Velocities of Class III groups: special point, or instant centre where two legs stand on the frame.",
)  # fmt: skip
ranges_option = click.option("--driver", "ranges", multiple=True, metavar="[NAME=]FROM:TO:STEP",
    help="Driver values, deg or mm; again for each further driver; NAME=VALUE holds one still.")  # fmt: skip
by_option = click.option(
    "--by", type=click.Choice(["construction", "analysis"]), default="construction", show_default=True,
    help="Replay the construction at every position, or solve the loop equations there.",
)  # fmt: skip
steps_option = click.option(
    "--steps", type=click.Path(path_type=Path, file_okay=False), help="One drawing a step, into this folder."
)
paper_option = click.option("--paper", type=click.Choice(PAPERS), help="Paper; else the smallest that fits.")
force_option = click.option("--force", is_flag=True, help="Replace a file of another's, or a drawing changed by hand.")


def svg_option(
    text: str, to_stdout: bool = False, kinds: tuple[str, ...] = (".svg",), folders: bool = False
) -> Callable[[_Command], _Command]:
    """`-o`: a drawing, written as SVG; another kind of file is refused before anything is done."""

    def checked(ctx: click.Context, option: click.Parameter, path: Path | None) -> Path | None:
        taken = path is None or path.suffix.lower() in kinds or (to_stdout and str(path) == "-")
        taken = taken or (folders and path is not None and is_folder(path))
        misused("usage.suffix", not taken, output=path, kinds=", ".join(kinds))
        return path

    kind = click.Path(path_type=Path, dir_okay=folders)
    return click.option("-o", "--output", type=kind, callback=checked, help=text)


def is_folder(path: Path) -> bool:
    """True where `-o` names a folder, which may not be there yet, for a file of each mechanism."""
    return path.is_dir() or not (path.suffix or str(path) == "-")


drawing_option = svg_option(
    f"{', '.join(DRAWN_AS)} to write, or a folder: an SVG of each mechanism; - for SVG on stdout.",
    to_stdout=True, kinds=DRAWN_AS, folders=True,
)  # fmt: skip
text_option = svg_option(".txt, .json or .jsonl to write; else printed.", kinds=(".txt", ".json", ".jsonl"))


def library_names(ctx: click.Context, option: click.Parameter, begun: str) -> list[CompletionItem]:
    """Completions of a MECHANISM: names of the library, and files where none begins so."""
    from click.shell_completion import CompletionItem

    from graphkin.files import library

    names = [CompletionItem(name) for name in library.names() if name.startswith(begun)]
    return names if names and "/" not in begun else [CompletionItem(begun, type="file")]


mechanism_argument = click.argument("mechanism", metavar="MECHANISM", shell_complete=library_names)
mechanisms_argument = click.argument(
    "mechanisms", metavar="MECHANISM...", nargs=-1, required=True, shell_complete=library_names
)


@contextmanager
def errors_said(lang: Lang) -> Iterator[None]:
    """Bad input becomes one message on stderr and exit status 3."""
    try:
        yield
    except GraphkinError as error:
        click.echo(error.message(lang), err=True)
        sys.exit(error.exit_code)
    except OSError as error:
        sys.exit(streams.ended(error))


def speaking(command: Callable[..., None]) -> Callable[..., None]:
    """A command with `--lang`, in which its bad input is said."""

    @functools.wraps(command)
    def wrapped(*args: object, lang: Lang, **kwargs: object) -> None:
        with errors_said(lang):
            command(*args, lang=lang, **kwargs)

    return lang_option(wrapped)


# --- a mechanism and its position -------------------------------------------------------------


def read(source: str) -> Mechanism:
    """The mechanism of a MECHANISM argument; what is to be remarked on it goes to stderr."""
    from graphkin import api, files

    misused("usage.empty", not source)
    through_pipe = source == "-"
    machine = files.load_stream(sys.stdin.buffer, name="stdin", file="<stdin>") if through_pipe else api.load(source)
    lang = click.get_current_context().params.get("lang", "en")
    for remark in files.remarks(machine):
        click.echo(remark.message(lang), err=True)
    return machine


@frozen
class DriverOptions:
    """Driver values of the command line: `--angle` [deg] and `--at` [mm], each in the order of its drivers."""

    angles: tuple[float, ...] = ()
    displacements: tuple[float, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.angles or self.displacements)

    def values(self, method: Method) -> list[float] | None:
        """All driver values in SI, with their units, those of the command line put in; None: the drawn position."""
        if not self:
            return None
        from graphkin.model.units import Number, driven

        angles, slides = [math.radians(angle) for angle in self.angles], [s / 1000 for s in self.displacements]
        rest: dict[str, list[float]] = {"angle": angles, "slide": slides, "spin": []}
        finite = all(map(math.isfinite, angles + slides))
        misused("usage.finite", not finite, option="--angle, --at")
        drawn = method.facts(None).values
        values = [rest[d.kind].pop(0) if rest[d.kind] else float(v) for d, v in zip(method.drivers, drawn, strict=True)]
        for option, kind in (("--angle", "angle"), ("--at", "slide")):
            misused("usage.drivers", rest[kind], name=method.mechanism.name, option=option)
        return [Number(value, driven(d.kind == "slide")) for value, d in zip(values, method.drivers, strict=True)]


def driver_options(command: Callable[..., None]) -> Callable[..., None]:
    """`--angle` and `--at` of a command, which takes them together as `at`."""

    @functools.wraps(command)
    def wrapped(*args: object, angles: tuple[float, ...], displacements: tuple[float, ...], **kwargs: object) -> None:
        command(*args, at=DriverOptions(angles, displacements), **kwargs)

    return angle_option(displacement_option(wrapped))


def position(
    machine: Mechanism, at: DriverOptions, coincident: str = "", method: str = "special"
) -> tuple[Method, list[float] | None]:
    """A mechanism planned as the options ask for, and the driver values that `--angle` and `--at` ask for, if any."""
    planned = plan(machine, coincident, method)
    return planned, at.values(planned)


def drawing(machine: Mechanism, at: DriverOptions, coincident: str = "", method: str = "special") -> Drawing:
    """The constructions there, proved."""
    from graphkin import api

    return api.Drawing.of(*position(machine, at, coincident, method))


def placed(source: str, at: DriverOptions) -> Method:
    """The method whose drawn position this is, for readers that take no driver values."""
    from graphkin import api

    return api.drawing.placed(*position(read(source), at))


def read_at(source: str, at: DriverOptions) -> Mechanism:
    """The mechanism of a MECHANISM argument, drawn where `--angle` and `--at` put it; not planned without them."""
    machine = read(source)
    return placed(source, at).mechanism if at else machine


def plan(machine: Mechanism, coincident: str, method: str) -> Method:
    """The method that `--coincident` and `--method` ask for."""
    from graphkin import api

    misused("usage.coincident", coincident not in ("", *machine.points), name=machine.name, point=coincident)
    return api.plan(machine, coincident, centres=method == "centre")


# --- printed and written ----------------------------------------------------------------------

_LINE_ENDS = "[\x7f-\x9f\u2028\u2029\ud800-\udfff]"
"""Ends of lines that JSON does not escape, with their kin that no text file should hold."""


def json_line(value: object) -> str:
    """One line of JSON for programs, on one line for those, too, that end lines as Unicode does."""
    text = json.dumps(value, ensure_ascii=False, allow_nan=False)
    return re.sub(_LINE_ENDS, lambda end: f"\\u{ord(end.group()):04x}", text)


def wants_json(as_json: bool, output: Path | None, count: int) -> bool:
    """True where texts of `count` mechanisms are JSON: `-o` says so, too."""
    kind = output.suffix.lower() if output is not None else ""
    misused("usage.suffix", kind == ".json" and count > 1, output=output, kinds=".jsonl")
    misused("usage.suffix", kind == ".txt" and as_json, output=output, kinds=".json, .jsonl")
    return as_json or kind in (".json", ".jsonl")


def print_each(
    sources: Sequence[str], lines: Callable[[str], Iterable[str]], as_json: bool, lang: Lang,
    output: Path | None = None, force: bool = False,
) -> None:  # fmt: skip
    """The lines of every mechanism; one that cannot be solved stops none of the others. Status 3 then."""
    failed: list[str] = []
    pages = _pages(sources, lines, as_json, lang, failed, output is None)
    if output is None:
        for page in pages:
            click.echo(page)
    elif whole := list(pages):
        from graphkin.outputs import files

        end = [] if as_json else ["", "graphkin"]  # a text says at its end whose it is, to be written again
        files.write(output, "\n".join([*whole, *end, ""]), force, (b'{"format": 1', b"\ngraphkin\n"))
        click.echo(str(output))
    if failed:
        sys.exit(3)


def _pages(
    sources: Sequence[str], lines: Callable[[str], Iterable[str]], as_json: bool, lang: Lang, failed: list[str],
    printed: bool,
) -> Iterator[str]:  # fmt: skip
    """The text of each mechanism; those that cannot be solved are put into `failed`."""
    for k, source in enumerate(streams.counted(sources, printed)):
        try:
            with streams.waiting(len(sources) == 1):
                page = list(lines(source))
        except GraphkinError as error:
            failed.append(source)
            if not as_json:
                click.echo(error.message(lang), err=True)
                continue
            name = Path(source).stem if source != "-" else "stdin"
            page = [json_line({"format": 1, "name": name, "error": error.message(lang)})]
        yield "\n".join(([""] if k and not as_json else []) + page)


def refuse_one_file(names: Iterable[str], suffix: str) -> None:
    """Each mechanism has a file of its name: of two with one name the second would replace the first."""
    seen = set[str]()
    for name in names:
        misused("usage.same file", name in seen, file=f"{name}{suffix}")
        seen.add(name)


def write_drawings(
    pages: list[tuple[Path, bytes | str]], output: Path | None, steps: Path | None, force: bool, err: bool = False
) -> None:
    """A sheet and its steps; all are made, and may be written, before the first is. `err`: their names on stderr."""
    from graphkin.outputs import drawings

    if printed := str(output) == "-":
        first = pages.pop(0)[1]
        click.echo(first if isinstance(first, str) else first.decode(), nl=False)
    if steps is not None:
        steps.mkdir(parents=True, exist_ok=True)
    for path, _ in pages:
        drawings.refuse(path, force)
    if output is not None:
        drawings.refuse_edited(output, force)
    for path, content in pages:
        drawings.write(path, content, force)
        click.echo(str(path), err=err or printed)


def _answer_lines(answer: object, as_json: bool, lang: Lang) -> list[str]:
    """An answer of a study, in words or as a line of JSON; of several of them each."""
    from graphkin.api.answers import data_of, lines_of

    if not as_json:
        return lines_of(answer, lang)
    return [json_line(data_of(one)) for one in (answer if isinstance(answer, list) else [answer])]


def print_answer(answer: object, as_json: bool, lang: Lang) -> None:
    """The same, printed."""
    click.echo("\n".join(_answer_lines(answer, as_json, lang)))


def print_answers(
    sources: tuple[str, ...], answer: Callable[[str], object], as_json: bool, lang: Lang, output: Path | None = None,
    force: bool = False,
) -> None:  # fmt: skip
    """The answers for several sources, as `print_each` prints them."""
    print_each(sources, lambda source: _answer_lines(answer(source), as_json, lang), as_json, lang, output, force)
