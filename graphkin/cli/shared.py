"""What the commands share: options, languages, reading a mechanism, saying what is wrong."""

from __future__ import annotations

import functools
import json
import math
import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from graphkin.cli import streams
from graphkin.errors import GraphkinError, Lang

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

    from graphkin.api import Drawing
    from graphkin.model.mechanism import Mechanism
    from graphkin.planning import Method

_Command = TypeVar("_Command", bound=Callable[..., Any])

PAPERS = ("A4", "A4-landscape", "A3", "A3-landscape", "letter", "letter-landscape")


def user_language() -> Lang:
    """As it is said before the command; else Chinese where the environment asks for it, else English."""
    context = click.get_current_context(silent=True)
    if context is not None and (before := context.find_root().meta.get("lang")):
        return "zh" if before == "zh" else "en"
    for name in ("GRAPHKIN_LANG", "LC_ALL", "LC_MESSAGES", "LANG"):
        if value := os.environ.get(name):
            return "zh" if value.lower().startswith("zh") else "en"
    return "en"


lang_option = click.option(
    "--lang", type=click.Choice(["en", "zh"]), default=user_language, show_default="of your system",
    help="Language of texts and messages.", callback=streams.spoken,
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
ranges_option = click.option(
    "--driver", "ranges", multiple=True, metavar="[NAME=]FROM:TO:STEP",
    help="Driver values, deg or mm; again for each further driver; NAME=VALUE holds one still.",
)  # fmt: skip
by_option = click.option(
    "--by", type=click.Choice(["construction", "analysis"]), default="construction", show_default=True,
    help="Replay the construction at every position, or solve the loop equations there.",
)  # fmt: skip
DRAWN_AS = (".svg", ".pdf", ".png", ".dxf", ".ggb", ".tex")
"""The kinds of files that a position is drawn as: those of `outputs.drawings`."""


def svg_option(
    told: str, to_stdout: bool = False, kinds: tuple[str, ...] = (".svg",), folders: bool = False
) -> Callable[[_Command], _Command]:
    """`-o`: a drawing, written as SVG; another kind of file is refused before anything is done."""

    def checked(ctx: click.Context, option: click.Parameter, path: Path | None) -> Path | None:
        if path is None or path.suffix.lower() in kinds or (to_stdout and str(path) == "-"):
            return path
        if folders and is_folder(path):
            return path
        raise click.UsageError(f"{path}: the file to write must end in {' or '.join(kinds)}", ctx)

    kind = click.Path(path_type=Path, dir_okay=folders)
    return click.option("-o", "--output", type=kind, callback=checked, help=told)


def is_folder(path: Path) -> bool:
    """Whether `-o` names a folder, which may not be there yet, for a file of each mechanism."""
    return path.is_dir() or not (path.suffix or str(path) == "-")


drawing_option = svg_option(
    f"{', '.join(DRAWN_AS)} to write, or a folder: an SVG of each mechanism; - for SVG on stdout.",
    to_stdout=True, kinds=DRAWN_AS, folders=True,
)  # fmt: skip
told_option = svg_option(".txt, .json or .jsonl to write; else printed.", kinds=(".txt", ".json", ".jsonl"))
force_option = click.option("--force", is_flag=True, help="Replace a file of another's, or a drawing changed by hand.")


def library_names(ctx: click.Context, option: click.Parameter, begun: str) -> list[CompletionItem]:
    """What a shell offers for a MECHANISM: names of the library, and files where none begins so."""
    from click.shell_completion import CompletionItem

    from graphkin.files import library

    found = [CompletionItem(name) for name in library.names() if name.startswith(begun)]
    return found if found and "/" not in begun else [CompletionItem(begun, type="file")]


mechanism_argument = click.argument("mechanism", metavar="MECHANISM", shell_complete=library_names)
mechanisms_argument = click.argument(
    "mechanisms", metavar="MECHANISM...", nargs=-1, required=True, shell_complete=library_names
)


@contextmanager
def said(lang: Lang) -> Iterator[None]:
    """Bad input becomes one message on stderr and exit status 3."""
    try:
        yield
    except GraphkinError as error:
        click.echo(error.message(lang), err=True)
        sys.exit(error.exit_code)
    except OSError as error:
        sys.exit(streams.ended(error, lang))


def speaking(command: Callable[..., None]) -> Callable[..., None]:
    """A command whose bad input is said in its `lang`."""

    @functools.wraps(command)
    def wrapped(*args: Any, lang: Lang, **kwargs: Any) -> None:
        with said(lang):
            command(*args, lang=lang, **kwargs)

    return wrapped


def read(source: str) -> Mechanism:
    """The mechanism of a MECHANISM argument; what is to be remarked on it goes to stderr."""
    from graphkin import api
    from graphkin import files as loading

    if not source:
        raise click.UsageError("MECHANISM is empty: name a file, or a mechanism of `graphkin list`")
    through_pipe = source == "-"
    machine = loading.load_stream(sys.stdin.buffer, name="stdin", file="<stdin>") if through_pipe else api.load(source)
    lang = click.get_current_context().params.get("lang", "en")
    for remark in loading.remarks(machine):
        click.echo(remark.message(lang), err=True)
    return machine


def read_at(source: str, angles: Sequence[float], displacements: Sequence[float]) -> Mechanism:
    """The mechanism of a MECHANISM argument, standing where `--angle` and `--at` put it."""
    machine = read(source)
    if not angles and not displacements:
        return machine
    from graphkin import api
    from graphkin.proof.readings import mechanism_at

    method = api.plan(machine)
    return mechanism_at(method, at_values(method, angles, displacements) or ())


def drawn(
    machine: Mechanism, coincident: str, method: str, angles: Sequence[float], displacements: Sequence[float]
) -> Drawing:
    """The drawing that the options ask for."""
    from graphkin import api

    found = planned(machine, coincident, method)
    return api.Drawing.at(found, at_values(found, angles, displacements))


def planned(machine: Mechanism, coincident: str, method: str) -> Method:
    """The method that the options ask for."""
    from graphkin import api

    if coincident and coincident not in machine.points:
        raise click.UsageError(f"--coincident: {machine.name} has no point {coincident}")
    return api.plan(machine, coincident, centres=method == "centre")


def at_values(method: Method, angles: Sequence[float], displacements: Sequence[float]) -> list[float] | None:
    """Driver values with those of the command line put in; None for the drawn position."""
    if not angles and not displacements:
        return None
    given: dict[str, list[float]] = {"angle": [math.radians(a) for a in angles], "spin": []}
    given["slide"] = [s / 1000 for s in displacements]
    if not all(math.isfinite(v) for values in given.values() for v in values):
        raise click.UsageError("--angle and --at take finite numbers")
    usual = method.facts(None).values
    values = [given[d.kind].pop(0) if given[d.kind] else float(v) for d, v in zip(method.drivers, usual, strict=True)]
    for option, rest in (("--angle", given["angle"]), ("--at", given["slide"])):
        if rest:
            name = method.mechanism.name
            raise click.UsageError(f"{name} has no driver left for {option} (of {len(values)} drivers)")
    return values


def json_line(value: object) -> str:
    """One line of JSON for programs, on one line for those, too, that end lines as Unicode does."""
    text = json.dumps(value, ensure_ascii=False, allow_nan=False)
    if text.isascii() and "\x7f" not in text:
        return text
    return re.sub(_LINE_ENDS, lambda end: f"\\u{ord(end.group()):04x}", text)


_LINE_ENDS = "[\x7f-\x9f\u2028\u2029\ud800-\udfff]"
"""Ends of lines that JSON does not escape, with their kin that no text file should hold."""


def told_each(
    sources: Sequence[str], told: Callable[[str], Iterator[str]], as_json: bool, lang: Lang,
    output: Path | None = None, force: bool = False,
) -> None:  # fmt: skip
    """What is to be told of every mechanism; one that cannot be solved stops none of the others. Status 3 then."""
    failed: list[str] = []
    pages = _told(sources, told, as_json, lang, failed)
    if output is None:
        for page in pages:
            click.echo(page)
    elif whole := list(pages):
        _write_told(output, whole, as_json, force)
    if failed:
        sys.exit(3)


def refuse_one_file(names: Iterable[str], suffix: str) -> None:
    """Each mechanism has a file of its name: of two with one name the second would replace the first."""
    seen = set[str]()
    for name in names:
        if name in seen:
            raise click.UsageError(f"two mechanisms would be written into {name}{suffix}: rename one of them")
        seen.add(name)


def as_told(as_json: bool, output: Path | None, count: int) -> bool:
    """Whether `count` mechanisms are told as JSON: `-o` says so, too."""
    kind = "" if output is None else output.suffix.lower()
    if kind == ".json" and count > 1:
        raise click.UsageError("several mechanisms make several JSON objects: name a .jsonl file")
    if kind == ".txt" and as_json:
        raise click.UsageError("--json writes .json or .jsonl")
    return as_json or kind in (".json", ".jsonl")


def _told(
    sources: Sequence[str], told: Callable[[str], Iterator[str]], as_json: bool, lang: Lang, failed: list[str]
) -> Iterator[str]:
    """The text of each mechanism; those that cannot be solved are put into `failed`."""
    for k, source in enumerate(sources):
        try:
            lines = list(told(source))
        except GraphkinError as error:
            failed.append(source)
            if not as_json:
                click.echo(error.message(lang), err=True)
                continue
            name = Path(source).stem if source != "-" else "stdin"
            lines = [json_line({"format": 1, "name": name, "error": error.message(lang)})]
        yield "\n".join(([""] if k and not as_json else []) + lines)


def _write_told(output: Path, pages: Sequence[str], as_json: bool, force: bool) -> None:
    """What would be printed; a text says at its end whose it is, so that it may be written again."""
    from graphkin.outputs.files import beside

    end = [] if as_json else ["", "graphkin"]
    with beside(output, force, (b'{"format": 1', b"\ngraphkin\n")) as draft:
        draft.write_text("\n".join([*pages, *end, ""]), encoding="utf-8", newline="\n")
    click.echo(str(output))


def plain(text: str) -> float | str:
    """A number, where a text is one; else the text, which may carry a unit."""
    try:
        return float(text)
    except ValueError:
        return text
