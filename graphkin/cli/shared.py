"""What the commands share: options, languages, reading a mechanism, saying what is wrong."""

from __future__ import annotations

import functools
import json
import math
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import click

from graphkin.errors import GraphkinError, Lang

if TYPE_CHECKING:
    from graphkin.api import Drawing
    from graphkin.mechanism import Mechanism
    from graphkin.methods import Method

__all__ = [
    "PAPERS", "angle_option", "at_option", "at_values", "by_option", "coincident_option", "drawn", "force_option",
    "json_line", "lang_option", "mechanism_argument", "method_option", "plain", "ranges_option", "read", "said",
    "speaking", "user_language",
]  # fmt: skip

PAPERS = ("A4", "A4-landscape", "A3", "A3-landscape")


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
ranges_option = click.option(
    "--driver", "ranges", multiple=True, metavar="[NAME=]FROM:TO:STEP",
    help="Driver values, deg or mm; again for each further driver; NAME=VALUE holds one still.",
)  # fmt: skip
by_option = click.option(
    "--by", type=click.Choice(["construction", "analysis"]), default="construction", show_default=True,
    help="Replay the construction at every position, or solve the loop equations there.",
)  # fmt: skip
force_option = click.option("--force", is_flag=True, help="Replace a file that graphkin did not write.")
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
    return api.Drawing.at(planned, at_values(planned, angles, displacements))


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


def json_line(value: object) -> str:
    """One line of JSON for programs."""
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def plain(text: str) -> float | str:
    """A number, where a text is one; else the text, which may carry a unit."""
    try:
        return float(text)
    except ValueError:
        return text
