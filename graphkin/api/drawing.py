"""The subject of a call, a mechanism by whatever names it with its drivers' values; and the drawing of one."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from graphkin import errors, planning
from graphkin import files as loading
from graphkin.base.geometry import Real, number
from graphkin.base.plain import Plain
from graphkin.base.value import frozen
from graphkin.construction import SCALES, Plane, Plot
from graphkin.errors import Lang, Where, among
from graphkin.errors.arguments import checked
from graphkin.files import library
from graphkin.files.draft import rate_keys
from graphkin.files.values import quantity_at
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import Mechanism
from graphkin.model.readout import Readable, read_off
from graphkin.model.units import EDGE, Measured, Number, Vector, driven
from graphkin.planning import Method

if TYPE_CHECKING:
    from graphkin.equations import By, SavedDocument
    from graphkin.model.quantities import Answer
    from graphkin.outputs.paint import Ink
    from graphkin.outputs.saving import NotebookSheet
    from graphkin.sheet import Style
    from graphkin.studies.sweeps import PointPath

Source: TypeAlias = Mechanism | str | Path  # a mechanism, its name in the library, or its file


def load(source: Source) -> loading.MechanismFile:
    """A mechanism from a file, or from the library by its name (`ex3-1`).

    Raises a `GraphkinError` that names file, line and key of what is wrong.

    >>> load("ex3-1").frame
    '4'
    """
    if isinstance(source, loading.MechanismFile):
        return source
    if not isinstance(source, str | Path):
        raise errors.NotAMechanism(Where("mechanism"), type(source).__name__)
    if isinstance(source, str) and library.has(source):
        return library.load(source)
    path = Path(source)
    if isinstance(source, str) and not path.suffix and path.name == source and not os.path.exists(source):
        return library.load(source)
    return loading.load(path)


def plan(mechanism: Source, coincident: str = "", centres: bool = False) -> Method:
    """The three constructions of a mechanism: position, velocity, acceleration.

    Raises a `GraphkinError` where drivers are too few or too many, where the links do not reach each other,
    where the sketch fits two assemblies, and where a group is of a class that is not solved.

    >>> plan("ex3-1").velocity.equations[0].of
    'B3'
    """
    from graphkin.planning.planner import wrong_side
    from graphkin.proof.roads import wrong_drivers

    mechanism = mechanism if isinstance(mechanism, Mechanism) else load(mechanism)
    try:
        method = planning.plan(mechanism, coincident, centres)
        if method.doubtful and (error := wrong_drivers(mechanism)) is not None:
            raise error
        return method
    except (errors.HigherClass, errors.CannotAssemble):
        if (found := wrong_drivers(mechanism) or wrong_side(mechanism)) is not None:
            raise found from None
        raise


def method_of(subject: Source | Method) -> Method:
    """A method as it is, or that of a mechanism."""
    return subject if isinstance(subject, Method) else plan(subject)


def placed(subject: Source | Method, values: Values) -> Method:
    """Its method; that of the mechanism drawn there where other driver values are given [deg, mm]."""
    method = method_of(subject)
    given = _one_place(method.mechanism, values)
    if given is None or given == [*method.facts().values]:
        return method
    from graphkin.proof.readings import mechanism_at

    return plan(mechanism_at(method, given))


Values: TypeAlias = Sequence[ArrayLike] | Mapping[str, ArrayLike] | float | str | None
"""Of each driver in their order, or by its name: deg and mm, or with their own unit, as texts or what was read."""


def in_si(mechanism: Mechanism, values: Values) -> list[Real] | None:
    """Each driver's values [rad, m]. Raises BadValues, NoSuchDriver, ValueForEach."""
    if values is None:
        return None
    kinds = {driver.name: driver.kind for driver in mechanism.drivers}
    if isinstance(values, Mapping):
        if unknown := [name for name in values if name not in kinds]:
            raise errors.NoSuchDriver(Where("values"), str(unknown[0]), tuple(kinds))
        each = [values[name] for name in kinds if name in values]
    else:
        several = isinstance(values, Sequence) and not isinstance(values, str)
        each = [*values] if several or (isinstance(values, np.ndarray) and values.ndim) else [values]  # type: ignore[misc, list-item]
    if len(each) != len(kinds):
        raise errors.ValueForEach(mechanism.where("driver"), len(each), tuple(kinds))
    return [_driven(value, kind) for value, kind in zip(each, kinds.values(), strict=True)]


def _one_place(mechanism: Mechanism, values: Values) -> list[float] | None:
    """Each driver's value [rad, m]. Raises what `in_si` does, and SeveralPositions for arrays."""
    given = in_si(mechanism, values)
    if any(np.ndim(value) for value in given or ()):
        raise errors.SeveralPositions(Where("values"), f"{values}"[:60])
    return None if given is None else [*map(number, given)]


def of_one_shape(values: list[Real] | None) -> list[Real] | None:
    """Arrays of one mechanism's drivers go over the same positions. Raises BadValues."""
    shapes = {np.shape(value) for value in values or () if np.ndim(value)}
    if len(shapes) > 1:
        raise errors.BadValues(Where("values"), ", ".join(map(str, sorted(shapes))))
    return values


def _driven(value: ArrayLike, kind: str) -> Real:
    if isinstance(value, Measured):
        return np.real(value.si)
    if isinstance(value, str):
        return quantity_at("values", "length" if kind == "slide" else "angle", value)
    try:
        plain = np.asarray(value, dtype=float)
        if not plain.ndim and not np.isfinite(plain):
            raise ValueError
    except (TypeError, ValueError, OverflowError):
        raise errors.BadValues(Where("values"), f"{value}"[:60]) from None
    si: Real = plain / 1000 if kind == "slide" else np.radians(plain)
    return si if plain.ndim else float(si)


@frozen
class Drawing(Readable[Number, Vector]):
    """A mechanism, planned and drawn at one position, and held against the analysis; a notebook plays it.

    What is read off by name (`drawing.omega["3"]`, `drawing["a_k B3B2"]`) is said in `Readable`.

    >>> drawing = Drawing.of("ex3-1", 60)
    >>> drawing.answers()["omega 3"].unit
    'rad/s'
    """

    mechanism: Mechanism
    method: Method
    plot: Plot

    @classmethod
    def of(cls, mechanism: Source | Method, values: Values = None) -> Drawing:
        """Plan a mechanism, if it is not, and draw it at the drawn position or at other driver values [deg, mm].

        Raises RoadsDiffer where the analysis does not confirm the drawing.
        """
        from graphkin.proof.roads import proved

        method = method_of(mechanism)
        return cls(method.mechanism, method, proved(method, _one_place(method.mechanism, values)).plot)

    @cached_property
    def _motions(self) -> Motions:
        from graphkin.proof.readings import readings

        return readings(self.method, self.plot)

    def quantity(self, text: str) -> Number | Vector:
        """Whatever `ask` can name, as a number with its unit."""
        return read_off(self._motions, text)  # type: ignore[return-value]

    __getitem__ = quantity

    @checked
    def sheet(
        self, *, paper: str | None = None, lang: Lang = "en", only: Plane | None = None, style: Style = "construction",
        tight: bool = False, paths: Sequence[str] = (), arrows: bool = False,
    ) -> NotebookSheet:  # fmt: skip
        """The sheet: mechanism and polygons to scale, in millimetres on paper; `style`: with their construction, as
        results alone, or only the mechanism with what is given; `tight`: the figures alone.

        paths   points whose paths are drawn over the driver's turn, or as far as it gets; arrows: with velocities
        """
        from graphkin.outputs.saving import NotebookSheet
        from graphkin.sheet import Paths, Style, sheet

        among(Style, style=style)
        drawn = Paths(tuple(self._paths(paths, arrows)), arrows and bool(paths), lang)
        found = sheet(
            self.method, self.plot, paper=paper, lang=lang, only=only, style=style, tight=tight, paths=drawn
        )
        return NotebookSheet.of(found, (self.method, self.plot))

    def _paths(self, points: Sequence[str], arrows: bool) -> Iterator[PointPath]:
        if not points:
            if arrows:
                raise errors.MissingKey(Where("arrows"), "paths")
            return
        from graphkin.studies.sweeps import point_path

        values = tuple(float(value) for value in self.plot.facts.values)
        for point in dict.fromkeys(points):
            path = point_path(self.method, point, values)
            if arrows and not path.course.driver.rate:
                raise errors.NoSpeed(Where(f"path {point}"), path.course.driver.name, rate_keys(path.course.driver))
            yield path

    @checked
    def step_sheets(
        self, *, paper: str | None = None, lang: Lang = "en", only: Plane | None = None, tight: bool = False
    ) -> Iterator[NotebookSheet]:
        """One sheet a step of the construction, the newest marks emphasised."""
        from graphkin.outputs.saving import NotebookSheet
        from graphkin.sheet import step_sheets

        sheets = step_sheets(self.method, self.plot, paper=paper, lang=lang, only=only, tight=tight)
        return map(NotebookSheet.of, sheets)

    @checked
    def explain(
        self, lang: Lang = "en", *, everything: bool = False, only: Plane = "acceleration", as_drawn: bool = False
    ) -> list[str]:
        """The solution, line by line, at the scales of the sheet.

        everything, only  all points and links, whatever is asked; the last plane that is drawn
        as_drawn          lengths are read to 0.5 mm, as a hand reads them, and what follows follows from that
        """
        from graphkin.say import explain
        from graphkin.sheet import scales_of

        scales = scales_of(self.method, self.plot)
        on_paper: dict[str, float] = {key: scales[plane] for plane, key in SCALES.items()}
        plot, ruler = self.plot, None
        if as_drawn:
            from graphkin.marking.ruler import as_drawn as read_off

            plot, ruler = read_off(self.method, plot, scales)
        return explain(self.method, plot, on_paper, lang, everything, only, ruler)

    @checked
    def equations(self, lang: Lang = "en", *, method: By = "complex") -> SavedDocument:
        """The analytic solution written out, with closed forms, or as one system of matrices ("matrix")."""
        from graphkin.equations import By, SavedDocument, document

        among(By, method=method)
        drawn, units = self.plot.facts.values, [driven(driver.kind == "slide") for driver in self.method.drivers]
        there = placed(self.method, [*map(Number, map(number, drawn), units)])
        return SavedDocument(**vars(document(there, method, lang)))

    @checked
    def animate(
        self, path: str | Path, *, paper: str | None = None, lang: Lang = "en", only: Plane | None = None,
        dpi: float = 100.0, ink: Ink = "accent", force: bool = False,
    ) -> Path:  # fmt: skip
        """Write a turn of the driver from the mechanism's own position on, or as far as it gets, as a .svg or .png that
        moves."""
        from graphkin.outputs import drawings, files
        from graphkin.sheet.motion_frames import motion_frames

        file = Path(path)
        if (moving := drawings.MOVING.get(file.suffix.lower())) is None:
            raise files.UnknownEnding(str(file), tuple(drawings.MOVING))
        drawings.refuse_edited(file, force)
        frames = motion_frames(self.method, paper=paper, lang=lang, only=only)
        drawings.write(file, moving(frames, dpi, ink), force)
        return file

    def answers(self) -> dict[str, Answer | None]:
        """The answers to what the file asks, read off the drawing; None for a text that is only shown."""
        from graphkin.model.quantities import Centre, read

        questions = {text: read(self.mechanism, text) for text in self.mechanism.ask}
        return {
            text: None if quantity is None or isinstance(quantity, Centre) else quantity.answer(self._motions)
            for text, quantity in questions.items()
        }

    def _repr_svg_(self) -> str:
        return self.sheet().svg()

    def _repr_html_(self) -> str | None:
        """A notebook plays it; nothing of what cannot move."""
        import graphkin

        try:
            return graphkin.play(self)._repr_html_()
        except errors.GraphkinError:
            return None

    def __repr__(self) -> str:
        stands = zip(self.mechanism.drivers, map(number, self.plot.facts.values))
        units = ((driver.name, EDGE[driven(driver.kind == "slide")], value) for driver, value in stands)
        at = ", ".join(f"{name} = {unit.shown(value)}" for name, unit, value in units)
        return f"<Drawing of {self.mechanism.name}{at and ' at ' + at}>"


def solved(drawing: Drawing) -> Mapping[str, Plain]:
    """One position as `graphkin solve --json` prints it."""
    from graphkin.results import results

    return results(drawing.mechanism, drawing.method, values=[*map(number, drawing.plot.facts.values)])
