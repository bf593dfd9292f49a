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
from pathlib import Path
from typing import TYPE_CHECKING

from graphkin import library, loading, planning, running
from graphkin.construction import Plane, Plot
from graphkin.errors import CannotAssemble, HigherClass, Lang
from graphkin.geometry import Value
from graphkin.mechanism import Mechanism
from graphkin.planning import Method
from graphkin.value import frozen

if TYPE_CHECKING:
    from graphkin.outputs.notebook import Shown
    from graphkin.quantities import Answer
    from graphkin.sweeps import Road, Sweep

__all__ = ["Drawing", "load", "plan", "replay", "sweep"]


def load(source: str | Path) -> Mechanism:
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
        _refuse_wrong_drivers(mechanism)
        _refuse_wrong_side(mechanism)
        raise


def _refuse_wrong_drivers(mechanism: Mechanism) -> None:
    from graphkin.freedoms import wrong_drivers

    if (error := wrong_drivers(mechanism)) is not None:
        raise error


def _refuse_wrong_side(mechanism: Mechanism) -> None:
    from graphkin.planning.other_side import other_side

    if (error := other_side(mechanism)) is not None:
        raise error


def replay(method: Method, values: Sequence[Value] | None = None) -> Plot:
    """Carry the constructions out at the drawn position, or at driver `values` [rad, m]: scalars or arrays (n,).

    >>> import numpy as np
    >>> plot = replay(plan(load("ex3-1")), [np.radians([60, 90, 120])])
    >>> np.round(plot.omega["3"], 3)
    array([-3.919, -1.132,  0.64 ])
    """
    return running.replay_all(method, values)


def sweep(mechanism: Mechanism, ranges: Sequence[str] = (), of: Sequence[str] = (), by: Road = "construction") -> Sweep:
    """Quantities over a turn, or as far as the mechanism gets; `ranges` and `of` as on the command line.

    >>> import numpy as np
    >>> found = sweep(load("ex3-7"), ["0:20:10"], ["theta 4", "v E"])
    >>> np.round(np.degrees(found["theta 4"].values), 5)
    array([168.93822, 172.02725, 175.32662])
    >>> np.round(found["v E"].signed, 5)
    array([-0.10184, -0.12272, -0.13833])
    """
    from graphkin import sweeps

    return sweeps.sweep(plan(mechanism), ranges, of, by)


@frozen
class Drawing:
    """A mechanism, planned and drawn at one position, and held against the analysis; a notebook shows its sheet.

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
        from graphkin.agreement import proved

        return cls(method.mechanism, method, proved(method, values).plot)

    def sheet(self, *, paper: str | None = None, lang: Lang = "en", only: Plane | None = None) -> Shown:
        """The sheet: mechanism and polygons to scale, in millimetres on paper."""
        from graphkin.outputs.notebook import shown
        from graphkin.sheet import sheet

        return shown(sheet(self.method, self.plot, paper=paper, lang=lang, only=only))

    def step_sheets(
        self, *, paper: str | None = None, lang: Lang = "en", only: Plane | None = None
    ) -> Iterator[Shown]:
        """One sheet a step of the construction, the newest marks emphasised."""
        from graphkin.outputs.notebook import shown
        from graphkin.sheet import step_sheets

        return map(shown, step_sheets(self.method, self.plot, paper=paper, lang=lang, only=only))

    def explain(self, lang: Lang = "en") -> list[str]:
        """The vector equations and what is measured, line by line, at the scales of the sheet."""
        from graphkin.say import explain
        from graphkin.sheet import scales_of

        scales = scales_of(self.method, self.plot, lang)
        keys: dict[str, Plane] = {"length": "position", "velocity": "velocity", "acceleration": "acceleration"}
        return explain(self.method, self.plot, {key: scales[plane] for key, plane in keys.items()}, lang)

    def answers(self) -> dict[str, Answer | None]:
        """What the file asks for, read off the drawing; None for a text that is only shown."""
        from graphkin.quantities import Centre, read
        from graphkin.readings import readings

        motions = readings(self.method, self.plot)
        wanted = {question: read(self.mechanism, question) for question in self.mechanism.ask}
        return {
            question: None if quantity is None or isinstance(quantity, Centre) else quantity.answer(motions)
            for question, quantity in wanted.items()
        }

    def _repr_svg_(self) -> str:
        from graphkin.outputs.svg import svg

        return svg(self.sheet())
