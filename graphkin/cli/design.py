"""`design`: linkages from what they are to do, as drawn constructions."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

import click

from graphkin.api.answers import LENGTHS
from graphkin.api.answers import design as designed
from graphkin.cli import shared
from graphkin.errors import Lang

if TYPE_CHECKING:
    from graphkin.studies.design import Design

_Command = TypeVar("_Command", bound=Callable[..., object])

def _option(name: str, text: str, required: bool = False) -> Callable[[_Command], _Command]:
    """A length, or else an angle, as a text that `designed` reads."""
    key = name.replace("-", "_")
    return click.option(f"--{name}", key, metavar="MM" if key in LENGTHS else "DEG", required=required, help=text)


def answering(make: Callable[..., Design]) -> Callable[..., None]:
    """A command that makes a design, with the options in which all give it out."""

    @shared.svg_option("Draw the construction, SVG.")
    @click.option("--steps", type=click.Path(path_type=Path, file_okay=False), help="One drawing a step, in a folder.")
    @click.option("--toml", type=click.Path(path_type=Path, dir_okay=False), help="Write the best linkage, as TOML.")
    @shared.paper_option
    @click.option("--json", "as_json", is_flag=True, help="One JSON object, metres and radians.")
    @shared.force_option
    @shared.lang_option
    @functools.wraps(make)
    def command(
        output: Path | None, steps: Path | None, toml: Path | None, paper: str | None, as_json: bool, force: bool,
        lang: Lang, **values: object,
    ) -> None:  # fmt: skip
        with shared.errors_said(lang):
            solution = make(**values)
            _print(solution, as_json, lang)
            if output or steps or toml:
                _write(solution, output, steps, toml, paper, force, lang)

    return command


def _print(solution: Design, as_json: bool, lang: Lang) -> None:
    from graphkin.say.design import error

    shared.print_answer(solution, as_json, lang)
    if not as_json and (missing := error(solution)) is not None:
        raise missing


def _write(
    solution: Design, output: Path | None, steps: Path | None, toml: Path | None, paper: str | None, force: bool,
    lang: Lang,
) -> None:  # fmt: skip
    from graphkin.api.answers import sheet_of
    from graphkin.outputs import files
    from graphkin.say.design import error, mechanism_of

    if (missing := error(solution)) is not None:
        raise missing
    pages: list[tuple[Path, bytes | str]] = []
    if output is not None or steps is not None:
        whole = sheet_of(solution, lang, paper)
        pages += [(output, whole.svg())] if output is not None else []
        if steps is not None:
            sheets = enumerate(whole.step_sheets(), start=1)
            pages += [(steps / f"{solution.kind}-{k:02d}.svg", page.svg()) for k, page in sheets]
    if toml is not None:
        files.refuse(toml, force, (b"graphkin",))
    shared.write_drawings(pages, output, steps, force, err=True)
    if toml is not None and solution.best is not None:
        files.write(toml, "# graphkin\n" + mechanism_of(solution.best, solution.kind).text, force, (b"graphkin",))
        click.echo(str(toml), err=True)


@click.group()
def design() -> None:
    """Find linkages from what they are to do: all solutions, drawn with ruler and compass, and proved.

    \b
    Example:
      graphkin design rocker --length 80 --swing 40 --K 1.3 --frame 71 -o rocker.svg --toml rocker.toml
      graphkin design slider --stroke 40 --K 1.2 --offset 15
      graphkin design guide-bar --K 1.5 --frame 100
      graphkin design positions --at "0,50 0" --at "25,60 -10" --at "50,55 -30" --coupler 60
      graphkin design angles --pair 40:70 --pair 70:85 --pair 110:110 --frame 100
    """


ratio_option = click.option("--K", "K", type=float, required=True, help="Time ratio K of the slow to the quick stroke.")


@design.command()
@_option("length", "The rocker's length.", required=True)
@_option("swing", "The rocker's swing.", required=True)
@ratio_option
@_option("frame", "With this frame length.")
@_option("crank", "With this crank length.")
@_option("coupler", "With this coupler length.")
@_option("gamma-min", "With this least transmission angle.")
@_option("AC1", "With this distance of the crank's pivot from C1.")
@answering
def rocker(**values: str | None) -> Design:
    """A crank-rocker from the rocker's length, its swing and K; without a further condition, the whole family."""
    return designed("rocker", **values)


@design.command()
@_option("stroke", "The slider's stroke.", required=True)
@ratio_option
@_option("offset", "With this offset.")
@_option("crank", "With this crank length.")
@_option("rod", "With this rod length.")
@_option("gamma-min", "With this least transmission angle.")
@answering
def slider(**values: str | None) -> Design:
    """An offset slider-crank from its stroke and K; without a further condition, the whole family."""
    return designed("slider", **values)


@design.command("guide-bar")
@ratio_option
@_option("frame", "The distance of the pivots.")
@_option("crank", "Or the crank's length.")
@answering
def guide_bar(**values: str | None) -> Design:
    """An oscillating guide bar from K and the frame's or the crank's length."""
    return designed("guide-bar", **values)


@design.command()
@click.option("--at", multiple=True, required=True, metavar="'X,Y X,Y'",
              help="Hinges B and C at one position, mm (or B and a direction, deg); two or three.")
@_option("coupler", "The coupler's length, where its directions are given.")
@click.option("--A", "A", metavar="X,Y", help="With two positions: the pivot of B, on its bisector.")
@click.option("--D", "D", metavar="X,Y", help="With two positions: the pivot of C, on its bisector.")
@answering
def positions(**values: str | None) -> Design:
    """A four-bar that carries its coupler through two or three positions."""
    return designed("positions", **values)


@design.command()
@click.option("--pair", multiple=True, required=True, metavar="PHI:PSI",
              help="Input and output angle that belong together, deg; three times.")
@_option("frame", "The distance of the pivots.", required=True)
@_option("crank", "With this crank length; only the differences of the angles count then.")
@_option("phi0", "The crank's direction at input angle 0.")
@_option("psi0", "The rocker's direction at output angle 0.")
@answering
def angles(**values: str | None) -> Design:
    """A four-bar whose crank and rocker come together to three pairs of angles."""
    return designed("angles", **values)
