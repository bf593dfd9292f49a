"""`design`: linkages from what they are to do, as drawn constructions."""

from __future__ import annotations

import cmath
import functools
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from graphkin.cli.shared import PAPERS, force_option, json_line, lang_option, plain, said, svg_option
from graphkin.errors import BadPair, GraphkinError, Lang, Where

if TYPE_CHECKING:
    from graphkin.files.units import Dimension
    from graphkin.studies.design import Design


def _quantity(dimension: Dimension, option: str, text: str) -> float:
    """A number in mm or deg, or with a unit, as SI."""
    from graphkin.files.units import read_quantity

    try:
        return read_quantity(plain(text), dimension)
    except GraphkinError as error:
        raise error.at(Where(option)) from None


def _length(name: str, told: str, required: bool = False) -> Callable[..., Any]:
    return click.option(f"--{name}", _key(name), metavar="MM", required=required, help=told)


def _angle(name: str, told: str, required: bool = False) -> Callable[..., Any]:
    return click.option(f"--{name}", _key(name), metavar="DEG", required=required, help=told)


def _key(name: str) -> str:
    return name.lower().replace("-", "_")


LENGTHS = {"length", "frame", "crank", "coupler", "rod", "stroke", "offset", "ac1"}


def _read(values: dict[str, Any]) -> dict[str, Any]:
    """What is given, in SI; what is not is left out."""
    found: dict[str, Any] = {}
    for name, text in values.items():
        if text is None:
            continue
        if name == "k":
            found[name] = float(text)
        else:
            found[name] = _quantity("length" if name in LENGTHS else "angle", f"--{name.replace('_', '-')}", text)
    return found


def answering(make: Callable[..., Design]) -> Callable[..., None]:
    """A command that makes a design, with the options in which all give it out."""

    @svg_option("Draw the construction, SVG.")
    @click.option("--steps", type=click.Path(path_type=Path, file_okay=False), help="One drawing a step, in a folder.")
    @click.option("--toml", type=click.Path(path_type=Path, dir_okay=False), help="Write the best linkage, as TOML.")
    @click.option("--paper", type=click.Choice(PAPERS), help="Paper; else the smallest that fits.")
    @click.option("--json", "as_json", is_flag=True, help="One JSON object, metres and radians.")
    @force_option
    @lang_option
    @functools.wraps(make)
    def command(
        output: Path | None, steps: Path | None, toml: Path | None, paper: str | None, as_json: bool, force: bool,
        lang: Lang, **values: Any,
    ) -> None:  # fmt: skip
        with said(lang):
            found = make(**values)
            _tell(found, as_json, lang)
            _write(found, output, steps, toml, paper, force, lang)

    return command


def _tell(found: Design, as_json: bool, lang: Lang) -> None:
    if as_json:
        from graphkin.outputs.study_json import as_json as data

        click.echo(json_line(data(found)))
        return
    from graphkin.say.design import error, lines

    click.echo("\n".join(lines(found, lang)))
    if (missing := error(found)) is not None:
        raise missing


def _write(
    found: Design, output: Path | None, steps: Path | None, toml: Path | None, paper: str | None, force: bool,
    lang: Lang,
) -> None:  # fmt: skip
    from graphkin.outputs import drawings, files, svg
    from graphkin.say.design import as_toml, error
    from graphkin.sheet.design_sheet import design_sheet, design_step_sheets

    if not (output or steps or toml):
        return
    if (missing := error(found)) is not None:
        raise missing
    pages = [] if output is None else [(output, svg.svg(design_sheet(found, paper=paper, lang=lang)))]
    if steps is not None:
        sheets = design_step_sheets(found, paper=paper, lang=lang)
        pages += [(steps / f"{found.kind}-{k:02d}.svg", svg.svg(page)) for k, page in enumerate(sheets, 1)]
        steps.mkdir(parents=True, exist_ok=True)
    for path, _ in pages:
        drawings.refuse(path, force)
    if toml is not None:
        files.refuse(toml, force, (b"graphkin",))
    for path, text in pages:
        drawings.write(path, text, force)
        click.echo(str(path), err=True)
    if toml is not None and found.best is not None:
        with files.beside(toml, force, (b"graphkin",)) as draft:
            draft.write_text("# graphkin\n" + as_toml(found.best, found.kind), encoding="utf-8", newline="\n")
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


ratio_option = click.option("--K", "k", type=float, required=True, help="Time ratio K of the slow to the quick stroke.")


@design.command()
@_length("length", "The rocker's length.", required=True)
@_angle("swing", "The rocker's swing.", required=True)
@ratio_option
@_length("frame", "With this frame length.")
@_length("crank", "With this crank length.")
@_length("coupler", "With this coupler length.")
@_angle("gamma-min", "With this least transmission angle.")
@_length("AC1", "With this distance of the crank's pivot from C1.")
@answering
def rocker(**values: Any) -> Design:
    """A crank-rocker from the rocker's length, its swing and K; without a further condition, the whole family."""
    from graphkin.studies import design as designing

    given = _read(values)
    return designing.rocker(given.pop("length"), given.pop("swing"), given.pop("k"), **given)


@design.command()
@_length("stroke", "The slider's stroke.", required=True)
@ratio_option
@_length("offset", "With this offset.")
@_length("crank", "With this crank length.")
@_length("rod", "With this rod length.")
@_angle("gamma-min", "With this least transmission angle.")
@answering
def slider(**values: Any) -> Design:
    """An offset slider-crank from its stroke and K; without a further condition, the whole family."""
    from graphkin.studies import design as designing

    given = _read(values)
    return designing.slider(given.pop("stroke"), given.pop("k"), **given)


@design.command("guide-bar")
@ratio_option
@_length("frame", "The distance of the pivots.")
@_length("crank", "Or the crank's length.")
@answering
def guide_bar(**values: Any) -> Design:
    """An oscillating guide bar from K and the frame's or the crank's length."""
    from graphkin.studies import design as designing

    given = _read(values)
    return designing.guide_bar(given.pop("k"), **given)


@design.command()
@click.option("--at", "places", multiple=True, required=True, metavar="'X,Y X,Y'",
              help="Hinges B and C at one position, mm (or B and a direction, deg); two or three.")  # fmt: skip
@_length("coupler", "The coupler's length, where its directions are given.")
@click.option("--A", "pivot_a", metavar="X,Y", help="With two positions: the pivot of B, on its bisector.")
@click.option("--D", "pivot_d", metavar="X,Y", help="With two positions: the pivot of C, on its bisector.")
@answering
def positions(places: tuple[str, ...], coupler: str | None, pivot_a: str | None, pivot_d: str | None) -> Design:
    """A four-bar that carries its coupler through two or three positions."""
    from graphkin.studies import design as designing

    length = None if coupler is None else _quantity("length", "--coupler", coupler)
    points = [_two_hinges(text, length) for text in places]
    a, d = (None if text is None else _place(option, text) for option, text in (("--A", pivot_a), ("--D", pivot_d)))
    return designing.coupler_positions(points, pivot_a=a, pivot_d=d)


def _two_hinges(text: str, length: float | None) -> tuple[complex, complex]:
    """B and C from their places, or from B and the coupler's direction."""
    first, space, second = text.strip().partition(" ")
    if not space or ("," in second) != (length is None):
        raise BadPair(Where("--at"), text)
    hinge = _place("--at", first)
    if length is None:
        return hinge, _place("--at", second.strip())
    return hinge, hinge + cmath.rect(length, _quantity("angle", "--at", second.strip()))


@design.command()
@click.option("--pair", "pairs", multiple=True, required=True, metavar="PHI:PSI",
              help="Input and output angle that belong together, deg; three times.")  # fmt: skip
@_length("frame", "The distance of the pivots.", required=True)
@_length("crank", "With this crank length; only the differences of the angles count then.")
@_angle("phi0", "The crank's direction at input angle 0.")
@_angle("psi0", "The rocker's direction at output angle 0.")
@answering
def angles(pairs: tuple[str, ...], **values: Any) -> Design:
    """A four-bar whose crank and rocker come together to three pairs of angles."""
    from graphkin.studies import design as designing

    given = _read(values)
    told = []
    for text in pairs:
        first, colon, second = text.partition(":")
        if not colon:
            raise BadPair(Where("--pair"), text)
        told.append((_quantity("angle", "--pair", first), _quantity("angle", "--pair", second)))
    return designing.angle_pairs(told, given.pop("frame"), **given)


def _place(option: str, text: str) -> complex:
    x, comma, y = text.partition(",")
    if not comma:
        raise BadPair(Where(option), text)
    return complex(_quantity("length", option, x.strip()), _quantity("length", option, y.strip()))
