"""The studies as programs ask them, in the words of the commands; and their answers in words, as data, on a sheet.

>>> rocker = design("rocker", length=80, swing=40, K=1.3, frame=71)
>>> lines_of(rocker)[0], sheet_of(rocker).paper.name
('Crank-rocker from swing and K', 'A4')
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterable, Mapping, Sequence
from importlib import import_module
from inspect import signature
from types import ModuleType
from typing import TYPE_CHECKING, Literal, overload

from graphkin.api.drawing import Drawing, Source, Values, load, method_of, placed
from graphkin.base.plain import Plain
from graphkin.errors import (
    BadPair,
    Lang,
    MissingKey,
    NeedsTwoLinks,
    NotANumber,
    NothingDrawn,
    OutOfRange,
    UnknownKey,
    UnknownPoint,
    Where,
    WrongCount,
    among,
)
from graphkin.files.values import quantity_at
from graphkin.planning import Method

if TYPE_CHECKING:
    from graphkin.outputs.saving import NotebookSheet
    from graphkin.sheet import Sheet
    from graphkin.studies.assur import Structure
    from graphkin.studies.centres import Centres
    from graphkin.studies.centres.about import About
    from graphkin.studies.centres.about_bobillier import Bobillier
    from graphkin.studies.centres.centrodes import Centrodes
    from graphkin.studies.design import Design
    from graphkin.studies.finding import Findings, VaryingTable
    from graphkin.studies.linkages import Linkage, Report
    from graphkin.studies.sweeps import Road

Size = float | str  # in mm or deg, or with a unit


@overload
def find(
    mechanism: Source | Method, condition: str, ranges: str | Sequence[str] = (), by: Road = "construction",
) -> Findings: ...  # fmt: skip
@overload
def find(
    mechanism: Source | Method, condition: str, ranges: str | Sequence[str] = (), by: Road = "construction", *,
    vary: str,
) -> VaryingTable: ...  # fmt: skip
def find(
    mechanism: Source | Method, condition: str, ranges: str | Sequence[str] = (), by: Road = "construction", *,
    vary: str = "",
) -> Findings | VaryingTable:  # fmt: skip
    """All positions with a property, as `graphkin find` names it: "v C = 0", "max v E", "stroke s ram", "slowest BC".

    ranges  the stretch, "AB=0:90:1"
    vary    again for each value of a dimension, "DH=55:125:5": `rows` with the `value` and what is `found`, or an error

    >>> [round(position.values[0], 3) for position in find("ex3-1", "max omega 3").positions]
    [2.918]
    >>> [round(row.found.swing, 3) for row in find("p3-21", "stroke s piston", vary="DH=90:110:10").rows]
    [0.078, 0.07, 0.061]
    """
    from graphkin import api
    from graphkin.studies import finding, sweeps

    among(sweeps.Road, by=by)
    ranges = [ranges] if isinstance(ranges, str) else ranges
    if not vary:
        return finding.find(method_of(mechanism), condition, ranges, by)
    machine = mechanism.mechanism if isinstance(mechanism, Method) else load(mechanism)
    return finding.vary(machine, vary, condition, ranges, by, plan=api.plan)


def structure(mechanism: Source | Method, values: Values = None) -> Structure:
    """Links, pairs, degrees of freedom and the Assur groups in the order they are solved."""
    from graphkin.studies import assur

    return assur.structure(placed(mechanism, values))


def linkage(
    of: Source | Linkage = "", values: Values = None, *, fourbar: Sequence[Size] = (), slider: Sequence[Size] = (),
    guide: Sequence[Size] = (), driver: str = "crank",
) -> list[Report]:  # fmt: skip
    """Kind, limits, swing or stroke, K, transmission angles and dead points of each four-bar, slider-crank and guide
    bar in a mechanism, or of one by its lengths [mm].

    fourbar  crank, coupler, rocker, frame; slider: crank, rod, offset; guide: crank, frame, offset
    driver   of lengths: "crank", "coupler", "rocker", "slider", "bar"

    >>> [(one.kind, round(one.k, 3)) for one in linkage(fourbar=(15, 48, 55, 45))]
    [('crank-rocker', 1.398)]
    """
    from graphkin.studies import linkages

    for kind, sizes in (("fourbar", fourbar), ("slider", slider), ("guide", guide)):
        if sizes:
            of = from_lengths(kind, sizes, driver)
    if of == "":
        raise MissingKey(Where("linkage"), "of")
    if isinstance(of, linkages.Linkage):
        return [linkages.report(of)]
    machine = load(of) if values is None else placed(of, values).mechanism
    return [*map(linkages.reported, linkages.some_found_in(machine))]


def from_lengths(kind: str, sizes: Sequence[Size], driver: str) -> Linkage:
    """The linkage of `--fourbar`, `--slider` or `--guide`."""
    from graphkin.studies import linkages

    if len(sizes) != (count := 3 + (kind == "fourbar")):
        raise WrongCount(Where(f"--{kind}"), count, len(sizes))
    lengths = [quantity_at(f"--{kind}", "length", size) for size in sizes]
    for length, size in zip(lengths, sizes, strict=True):
        if 0 < abs(length) < LEAST_PART * max(map(abs, lengths)):
            raise OutOfRange(Where(f"--{kind}"), str(size))
    return linkages.from_lengths(kind, *lengths, driver=driver)


@overload
def centres(mechanism: Source | Method, values: Values = None) -> Centres: ...
@overload
def centres(mechanism: Source | Method, values: Values = None, *, about: str) -> About: ...
@overload
def centres(mechanism: Source | Method, values: Values = None, *, about: str, bobillier: str) -> Bobillier: ...
@overload
def centres(
    mechanism: Source | Method, values: Values = None, *, centrodes: str, ranges: str | Sequence[str] = ()
) -> Centrodes: ...
@overload
def centres(
    mechanism: Source | Method, values: Values = None, *, path: str, ranges: str | Sequence[str] = ()
) -> Centrodes: ...
def centres(
    mechanism: Source | Method, values: Values = None, *, about: str = "", bobillier: str = "", centrodes: str = "",
    path: str = "", ranges: str | Sequence[str] = (),
) -> Centres | About | Bobillier | Centrodes:  # fmt: skip
    """All instant centres at the drawn position, or at driver values [deg, mm]; `names`, `board` hold them [m]; or what
    lies around them, as `graphkin centres` names it.

    about      a link about its pole; with `bobillier`, a point: the centre of curvature of its path
    centrodes  two links, "3,1"; path: a centre, "P13"; both over ranges "AB=0:90:1", else all that moves

    >>> centres("fig3-4", about="3", bobillier="E").answer, centres("fig3-6", centrodes="3,1").name
    ('K_E', 'P13')
    """
    from graphkin.studies import centres as found

    drawing = Drawing.of(mechanism, values)
    return around(found.centres(drawing.method, drawing.plot), about, bobillier, centrodes, path, ranges)


def around(
    found: Centres, link: str = "", point: str = "", pair: str = "", centre: str = "", ranges: str | Sequence[str] = ()
) -> Centres | About | Bobillier | Centrodes:
    """The centres, or what the options of the command name around them."""
    from graphkin.studies import sweeps
    from graphkin.studies.centres import centrodes
    from graphkin.studies.centres.about import about
    from graphkin.studies.centres.about_bobillier import bobillier

    if pair or centre:
        ranges = [ranges] if isinstance(ranges, str) else ranges
        course = sweeps.course(found.method, ranges)
        sweeps.prove(course)
        span = None if ranges else centrodes.whole(course)
        if centre:
            return centrodes.path(found, centre, course, span)
        first, comma, second = pair.partition(",")
        if not comma:
            raise NeedsTwoLinks(Where("--centrodes"), pair)
        return centrodes.centrodes(found, first.strip(), second.strip(), course, span)
    if not (link or point):
        return found
    if point and point not in (points := found.method.mechanism.points):
        raise UnknownPoint(Where("--bobillier"), point, points)
    if not link:
        raise MissingKey(Where("--bobillier"), "about")
    seen = about(found, link)
    return bobillier(seen, point) if point else seen


# --- design -----------------------------------------------------------------------------------

Kind = Literal["rocker", "slider", "guide-bar", "positions", "angles"]
LEAST_PART = 1e-9  # beside the longest link, one shorter than this part of it is none
LENGTHS = {"length", "frame", "crank", "coupler", "rod", "stroke", "offset", "AC1"}


def design(
    kind: Kind, *, K: Size | None = None, length: Size | None = None, swing: Size | None = None,
    stroke: Size | None = None, frame: Size | None = None, crank: Size | None = None, coupler: Size | None = None,
    rod: Size | None = None, offset: Size | None = None, AC1: Size | None = None, gamma_min: Size | None = None,
    at: Sequence[str] | None = None, A: str | None = None, D: str | None = None, pair: Sequence[str] | None = None,
    phi0: Size | None = None, psi0: Size | None = None,
) -> Design:  # fmt: skip
    """Linkages from what they are to do, in the words of `graphkin design`; numbers are mm and deg, or have a unit.

    kind  "rocker": length, swing, K, and one of frame, crank, coupler, gamma_min, AC1; "slider": stroke, K, and one of
          offset, crank, rod, gamma_min; "guide-bar": K, frame or crank; "positions": at=["0,50 0", "25,60 -10"] with
          coupler, or both hinges in `at`, A, D; "angles": pair=["40:70", "70:85", "110:110"], frame, crank, phi0, psi0

    >>> round(design("guide-bar", K=1.5, frame=100).best.a, 4)
    0.0309
    """
    given: dict[str, Size | None] = {name: value for name, value in locals().items() if value is not None}
    from graphkin.studies import design as designing

    among(Kind, kind=str(kind))
    for name in ("kind", "K", "at", "pair"):
        given.pop(name, None)
    try:
        ratio = {} if K is None else {"k": float(K)}
    except (ValueError, OverflowError):
        raise NotANumber(Where("--K"), str(K)) from None
    pivots = {f"pivot_{name.lower()}": _place(name, str(given.pop(name))) for name in ("A", "D") if name in given}
    sizes = {name.lower(): quantity_at(_option(name), "length" if name in LENGTHS else "angle", value)
             for name, value in given.items() if value is not None}  # fmt: skip
    if kind == "positions":
        return designing.coupler_positions([_two_hinges(text, sizes.get("coupler")) for text in at or ()], **pivots)
    if kind == "angles":
        return designing.angle_pairs([_two_angles(text) for text in pair or ()], **sizes)
    make: Callable[..., Design] = getattr(designing, kind.replace("-", "_"))
    _refuse_names(kind, make, [*given, *(["K"] if ratio else [])])
    return make(**sizes, **ratio)


def _refuse_names(kind: Kind, make: Callable[..., Design], named: Sequence[str]) -> None:
    """Raises UnknownKey of a name that a design does not take, MissingKey of one that it needs."""
    takes = signature(make).parameters
    names = {name.lower(): name for name in (*LENGTHS, "swing", "gamma_min", "K")}
    for name in named:
        if name.lower() not in takes:
            raise UnknownKey(Where(kind), name, tuple(names[key] for key in takes))
    for key, wanted in takes.items():
        if wanted.default is wanted.empty and names[key] not in named:
            raise MissingKey(Where(kind), names[key])


def _option(name: str) -> str:
    return f"--{name.replace('_', '-')}"


def _two_hinges(text: str, length: float | None) -> tuple[complex, complex]:
    """B and C from their places, or from B and the coupler's direction."""
    first, space, second = text.strip().partition(" ")
    if not space or ("," in second) != (length is None):
        raise BadPair(Where("--at"), text)
    hinge = _place("at", first)
    if length is None:
        return hinge, _place("at", second.strip())
    return hinge, hinge + cmath.rect(length, quantity_at("--at", "angle", second.strip()))


def _two_angles(text: str) -> tuple[float, float]:
    first, colon, second = text.partition(":")
    if not colon:
        raise BadPair(Where("--pair"), text)
    return quantity_at("--pair", "angle", first), quantity_at("--pair", "angle", second)


def _place(name: str, text: str) -> complex:
    x, comma, y = text.partition(",")
    if not comma:
        raise BadPair(Where(_option(name)), text)
    return complex(*(quantity_at(_option(name), "length", part.strip()) for part in (x, y)))


# --- answers ----------------------------------------------------------------------------------

_READERS = {
    "Findings": ("say.finding.plain_lines", "studies.finding.as_json", "sheet.finding_sheet.drawn"),
    "VaryingTable": ("say.finding.finding_table", "studies.finding.table_json", ""),
    "Centres": ("say.centre_velocities.centre_lines", "studies.centres.as_json", "sheet.centre_sheet.centre_sheet"),
    "About": ("say.centre_about.about_words", "studies.centres.about.about_json", "sheet.about_sheet.about_sheet"),
    "Bobillier": ("say.centre_about.bobillier_lines", "studies.centres.about_bobillier.bobillier_json",
                  "sheet.about_sheet.bobillier_sheet"),
    "Centrodes": ("say.centre_about.curve_lines", "studies.centres.centrodes.centrodes_json",
                  "sheet.centrode_sheet.centrode_sheet"),
    "Design": ("say.design.lines", "outputs.study_json.as_json", "sheet.design_sheet.design_sheet"),
    "Tolerances": ("say.tolerances.tolerance_lines", "outputs.study_json.tolerance_data", ""),
    "Power": ("say.tolerances.power_lines", "outputs.study_json.power_data", ""),
    "Structure": ("say.structure.structure_lines", "studies.assur.as_json", ""),
    "Report": ("say.linkages.lines", "studies.linkages.as_json", ""),
    "list": ("say.linkages.all_lines", "", "sheet.linkage_sheet.limit_sheet"),
    "Drawing": ("", "api.drawing.solved", ""),
    "SweepFrames": ("say.sweeps.told", "", ""),
    "RulerReport": ("say.results.check_lines", "", ""),
    "Graded": ("say.marks.grade_lines", "outputs.marks_json.line", ""),
}  # fmt: skip
"""By the class of an answer: what puts it into words, makes plain data of it, draws it. A list is of linkages."""


def lines_of(answer: object, lang: Lang = "en") -> list[str]:
    """An answer in words, as its command prints it; a sweep with what it leaves out, a student of `grade`, a drawing
    that `measure` read, too."""
    lines: Callable[[object, Lang], Iterable[str]] = getattr(*_reader(answer, 0))
    return [*lines(answer, lang)]


def data_of(answer: object) -> dict[str, Plain]:
    """The same as plain data for JSON, SI units and radians; of a `Drawing` what `graphkin solve --json` prints."""
    data: Callable[[object], Mapping[str, Plain]] = getattr(*_reader(answer, 1))
    return {**data(answer)}


def sheet_of(answer: object, lang: Lang = "en", paper: str | None = None, **more: bool) -> NotebookSheet:
    """An answer of `find`, `centres` (`fit=True`: on a smaller scale), `linkage`, `design` on a sheet, to be shown and
    saved."""
    from graphkin.outputs.saving import NotebookSheet

    draw: Callable[..., Sheet | tuple[Sheet | None, int]] = getattr(*_reader(answer, 2))
    if isinstance(answer, list) and not answer:
        raise NothingDrawn("list")
    made = draw(answer, lang=lang, paper=paper, **more)
    if (sheet := made[0] if isinstance(made, tuple) else made) is None:
        raise NothingDrawn(type(answer).__name__)
    return NotebookSheet.of(sheet)


def _reader(answer: object, which: int) -> tuple[ModuleType, str]:
    name = _READERS.get(type(answer).__name__, ("", "", ""))[which]
    if not name:
        raise NothingDrawn(type(answer).__name__)
    module, _, function = name.rpartition(".")
    return import_module(f"graphkin.{module}"), function
