"""What a program or a notebook calls: from a file or a library name to a method, a plot, a sheet.

>>> import graphkin
>>> mechanism = graphkin.load("ex3-1")
>>> method = graphkin.plan(mechanism)
>>> plot = graphkin.replay(method)
>>> round(float(plot.omega["3"]), 4)
-3.9193
>>> exact = graphkin.motion(mechanism)
>>> abs(float(exact.omega["3"] - plot.omega["3"])) < 1e-9
True
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from graphkin import files as loading
from graphkin import planning, running
from graphkin.base.geometry import Real
from graphkin.base.value import frozen
from graphkin.construction import SCALES, Plane, Plot
from graphkin.errors import CannotAssemble, GraphkinError, HigherClass, Lang, NoSpeed, Where
from graphkin.files import library
from graphkin.files.draft import rate_keys
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import Mechanism
from graphkin.model.readout import Readable, State, read_off
from graphkin.planning import Method

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from graphkin.model.quantities import Answer
    from graphkin.outputs.svg import NotebookSheet
    from graphkin.outputs.tables import SweepFrames
    from graphkin.running.variants import DrawnVariants
    from graphkin.sheet import Style
    from graphkin.studies.sweeps import PointPath, Ranges, Road

__all__ = ["Drawing", "load", "motion", "plan", "replay", "replay_many", "sweep"]


def load(source: str | Path) -> loading.MechanismFile:
    """A mechanism from a file, or from the library by its name (`ex3-1`).

    Raises a `GraphkinError` that names file, line and key of what is wrong.

    >>> load("ex3-1").frame
    '4'
    """
    if isinstance(source, str) and library.has(source):
        return library.load(source)
    path = Path(source)
    if isinstance(source, str) and not path.suffix and not path.exists() and path.name == source:
        return library.load(source)
    return loading.load(path)


def plan(mechanism: Mechanism, coincident: str = "", centres: bool = False) -> Method:
    """The three constructions of a mechanism: position, velocity, acceleration.

    Raises a `GraphkinError` where drivers are too few or too many, where the links do not reach each other,
    where the sketch fits two assemblies, and where a group is of a class that is not solved.

    >>> plan(load("ex3-1")).velocity.equations[0].of
    'B3'
    """
    try:
        method = planning.plan(mechanism, coincident, centres)
        if method.doubtful:
            _refuse_wrong_drivers(mechanism)
        return method
    except (HigherClass, CannotAssemble):
        from graphkin.planning.planner import wrong_side

        _refuse_wrong_drivers(mechanism)
        if (error := wrong_side(mechanism)) is not None:
            raise error from None
        raise


def _refuse_wrong_drivers(mechanism: Mechanism) -> None:
    from graphkin.proof.roads import wrong_drivers

    if (error := wrong_drivers(mechanism)) is not None:
        raise error


def replay(
    method: Method, values: Sequence[Real] | None = None, *, compiled: bool | None = None, held: bool = True
) -> State:
    """Carry the constructions out at the drawn position, or at driver `values` [rad, m]: scalars or arrays (n,).

    compiled  of arrays by a C function, if a compiler is at hand (`CC`, `cc`); None: of a million positions or more
    held      against the analysis, arrays at both ends and at ten places between, once for as far as the drivers of a
              method go; False: unproved numbers, as the steps give them

    Raises RoadsDiffer where the analysis does not confirm what is drawn, NotReached for a position, one of those places
    too, that lies beyond a dead point. Other positions of an array may do so, or be nan: see `sweep`.

    >>> import numpy as np
    >>> drawn = replay(plan(load("ex3-1")), [np.radians([60, 90, 120])])
    >>> np.round(drawn.omega["3"], 3)
    array([-3.919, -1.132,  0.64 ])
    """
    from graphkin.proof import roads as agreement
    from graphkin.proof.readings import places, readings

    drawn = agreement.held if held else running.replay_all
    plot = drawn(method, values, compiled)
    return State(partial(readings, method, plot), plot, places(method))


def replay_many(
    method: Method, mechanisms: Sequence[Mechanism] | Mechanism, values: Sequence[Real] | None = None, *,
    held: bool = True,
) -> DrawnVariants:  # fmt: skip
    """Every mechanism of a method's topology, each at its own drawn position or at driver values.

    mechanisms  one after another; or one whose numbers are arrays (n,), those that all share scalars
    values      one entry a driver, scalar, (positions, 1) or (positions, n) [rad, m]
    held        the first and the last mechanism, and ten between, are held against the analysis; False: none is, as an
                optimiser may want it, which asks again and again

    Each is the assembly that its own sketch means. Raises ValueError for a mechanism of another topology, RoadsDiffer
    where the analysis does not confirm what is drawn.

    >>> slotted = load("ex3-1")
    >>> found = replay_many(plan(slotted), [slotted.with_(AB=length) for length in (20, 24, 28)])
    >>> found.plot.omega["3"].round(3)
    array([-3.273, -3.919, -4.514])
    """
    from graphkin.proof import roads as agreement
    from graphkin.running import variants

    drawn = variants.replay_many(method, mechanisms, values)
    if held:
        agreement.hold_rows(method, mechanisms, values, drawn)
    return drawn


def motion(mechanism: Mechanism, values: Sequence[ArrayLike] | None = None) -> State:
    """The same by the analysis: closed vector loops and the matrix method; nothing is drawn or planned.

    Raises NoAssembly for the drawn position, SingularPosition where that, or a single position asked for, is a dead
    point; in arrays, positions that are not reached are nan.

    >>> exact = motion(load("ex3-1"))
    >>> exact.omega["3"], exact.a["C"], exact["a_k B3B2"].magnitude
    (-3.91933 rad/s, 3.07641 m/s^2 at 209.4773°, 2.51485 m/s^2)
    """
    from graphkin import analytic

    return State(analytic.motion(mechanism, values))


def sweep(
    mechanism: Mechanism | Method, ranges: Ranges = (), of: str | Sequence[str] = (), by: Road = "construction",
    compiled: bool | None = None,
) -> SweepFrames:  # fmt: skip
    """Quantities over a turn, or as far as the mechanism gets; angles go on beyond a full turn.

    ranges  by driver, in deg and mm: an array, a text `"0:360:10"`, or a number that holds it still; nothing: the first
            driver through a turn. Drivers that move together do so in proportion
    of      `["theta 4", "v E"]`, or one text with commas; nothing: what the file asks
    by      "construction", or "analysis"
    compiled  as `replay` has it

    Raises BadRange, NoSuchDriver, UnknownQuantity and their like, and RoadsDiffer where the two roads do not agree.

    >>> import numpy as np
    >>> found = sweep(load("ex3-7"), {"AB": np.linspace(0, 20, 3)}, "theta 4, v E")
    >>> found
    <Sweep of ex3-7: AB = 0 to 20 deg, 3 positions: theta 4, v E>
    >>> found["theta 4"].degrees.round(5)
    array([168.93822, 172.02725, 175.32662])
    >>> found["v E"].signed.round(5), found["v E"].direction.round(3)
    (array([-0.10184, -0.12272, -0.13833]), array([180., 180., 180.]))
    """
    from graphkin.outputs.tables import framed
    from graphkin.studies import sweeps

    method = mechanism if isinstance(mechanism, Method) else plan(mechanism)
    with in_python():
        return framed(sweeps.sweep(method, ranges, sweeps.split(of) if isinstance(of, str) else of, by, compiled))


_ARGUMENTS = {"--driver": "ranges", "--of": "of"}  # arguments of functions by the options of commands


@contextmanager
def in_python() -> Iterator[None]:
    """Errors name arguments, not the options of a command."""
    try:
        yield
    except GraphkinError as error:
        where = getattr(error, "where", None)
        if isinstance(where, Where) and where.file in _ARGUMENTS:
            raise error.at(Where(_ARGUMENTS[where.file])) from None
        raise


@frozen
class Drawing(Readable):
    """A mechanism, planned and drawn at one position, and held against the analysis; a notebook shows its sheet.

    What is read off by name (`drawing.omega["3"]`, `drawing["a_k B3B2"]`) is said in `Readable`.

    >>> drawing = Drawing.of(load("ex3-1"))
    >>> drawing.answers()["omega 3"].unit
    'rad/s'
    """

    mechanism: Mechanism
    method: Method
    plot: Plot

    @classmethod
    def of(cls, mechanism: Mechanism, values: Sequence[float] | None = None) -> Drawing:
        """Plan a mechanism and draw it, at the drawn position or at other driver values [rad, m]."""
        return cls.at(plan(mechanism), values)

    @classmethod
    def at(cls, method: Method, values: Sequence[float] | None = None) -> Drawing:
        """Draw a planned mechanism. Raises RoadsDiffer where the analysis does not confirm the drawing."""
        from graphkin.proof.roads import proved

        return cls(method.mechanism, method, proved(method, values).plot)

    @cached_property
    def _motions(self) -> Motions:
        from graphkin.proof.readings import readings

        return readings(self.method, self.plot)

    def quantity(self, text: str) -> Any:
        """Whatever `ask` can name, as a number with its unit."""
        return read_off(self._motions, text)

    __getitem__ = quantity

    def sheet(
        self, *, paper: str | None = None, lang: Lang = "en", only: Plane | None = None, style: Style = "construction",
        tight: bool = False, paths: Sequence[str] = (), arrows: bool = False,
    ) -> NotebookSheet:  # fmt: skip
        """The sheet: mechanism and polygons to scale, in millimetres on paper; `style`: with their construction, as
        results alone, or only the mechanism with what is given; `tight`: the figures alone.

        paths   points whose paths are drawn over the driver's turn, or as far as it gets; arrows: with velocities
        """
        from graphkin.outputs.svg import shown
        from graphkin.sheet import Paths, sheet

        drawn = Paths(tuple(self._paths(paths, arrows)), arrows and bool(paths), lang)
        found = sheet(
            self.method, self.plot, paper=paper, lang=lang, only=only, style=style, tight=tight, paths=drawn
        )
        return shown(found)

    def _paths(self, points: Sequence[str], arrows: bool) -> Iterator[PointPath]:
        if not points:
            return
        from graphkin.studies.sweeps import point_path

        values = tuple(float(value) for value in self.plot.facts.values)
        for point in dict.fromkeys(points):
            path = point_path(self.method, point, values)
            if arrows and not path.course.driver.rate:
                raise NoSpeed(Where(f"path {point}"), path.course.driver.name, rate_keys(path.course.driver))
            yield path

    def step_sheets(
        self, *, paper: str | None = None, lang: Lang = "en", only: Plane | None = None, tight: bool = False
    ) -> Iterator[NotebookSheet]:
        """One sheet a step of the construction, the newest marks emphasised."""
        from graphkin.outputs.svg import shown
        from graphkin.sheet import step_sheets

        return map(shown, step_sheets(self.method, self.plot, paper=paper, lang=lang, only=only, tight=tight))

    def explain(
        self, lang: Lang = "en", *, everything: bool = False, only: Plane = "acceleration", as_drawn: bool = False
    ) -> list[str]:
        """The solution, line by line, at the scales of the sheet.

        everything, only  all points and links, whatever is asked; the last plane that is drawn
        as_drawn          lengths are read to 0.5 mm, as a hand reads them, and what follows follows from that
        """
        from graphkin.say import explain
        from graphkin.sheet import scales_of

        scales = scales_of(self.method, self.plot, lang)
        on_paper: dict[str, float] = {key: scales[plane] for plane, key in SCALES.items()}
        plot, ruler = self.plot, None
        if as_drawn:
            from graphkin.marking.ruler import as_drawn as read_off

            plot, ruler = read_off(self.method, plot, scales)
        return explain(self.method, plot, on_paper, lang, everything, only, ruler)

    def answers(self) -> dict[str, Answer | None]:
        """What the file asks for, read off the drawing; None for a text that is only shown."""
        from graphkin.model.quantities import Centre, read

        questions = {text: read(self.mechanism, text) for text in self.mechanism.ask}
        return {
            text: None if quantity is None or isinstance(quantity, Centre) else quantity.answer(self._motions)
            for text, quantity in questions.items()
        }

    def _repr_svg_(self) -> str:
        from graphkin.outputs.svg import svg

        return svg(self.sheet())
