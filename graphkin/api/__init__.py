"""The calls of programs and notebooks: from a file or a library name to a method, a plot, a sheet.

>>> import graphkin
>>> drawn, exact = graphkin.replay("ex3-1"), graphkin.motion("ex3-1")
>>> round(float(drawn.omega["3"]), 4), abs(exact.omega["3"] - drawn.omega["3"]) < 1e-9
(-3.9193, True)

Wherever a mechanism is taken, its name in the library and its file are, too. What is given to a call is in the units of
the file, deg and mm; what is read is in SI and has its unit: `.degrees`, `.mm`, `.rpm`.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, overload

from graphkin import running
from graphkin.api.drawing import Drawing, Source, Values, in_si, load, method_of, of_one_shape, plan
from graphkin.errors import among
from graphkin.files.variants import Variants as AnyVariants
from graphkin.model.mechanism import Mechanism
from graphkin.model.readout import State
from graphkin.planning import Method

if TYPE_CHECKING:
    from graphkin.api.variants import Many as Variants
    from graphkin.api.variants import Trial
    from graphkin.outputs.tables import SweepFrames
    from graphkin.studies.sweeps import Ranges, Road

__all__ = ["Drawing", "load", "motion", "plan", "replay", "sweep", "trial"]


def replay(
    method: Method | Source | Variants, values: Values = None, *, compiled: bool | None = None, held: bool = True
) -> State:
    """Carry the constructions out at the drawn position, or at driver `values` [deg, mm]: scalars or arrays (n,).

    method    or its mechanism; or `Mechanism.variants`, many at once, read as arrays (n,) or, at positions,
              (positions, n), as values may be, too; each is the assembly that its own sketch means, and stays on that
              side of its dead points and change points; nan where links do not meet, and where it is `refused`. Held
              are the first and the last mechanism and ten between
    compiled  of arrays by a C function, if a compiler is at hand (`CC`, `cc`); None: of a million positions or more
    held      against the analysis, arrays at both ends and at ten places between, once for as far as the drivers of a
              method go; False: unproved numbers, as the steps give them

    Raises RoadsDiffer where the analysis does not confirm what is drawn, NotReached for a position, one of those places
    too, that lies beyond a dead point. Other positions of an array may do so, or be nan: see `sweep`.

    >>> replay("ex3-1", [[60, 90, 120]]).omega["3"].round(3)
    array([-3.919, -1.132,  0.64 ])
    """
    from graphkin.proof import roads as agreement
    from graphkin.proof.readings import places, readings

    if isinstance(method, AnyVariants):
        from graphkin.api import variants

        return variants.replayed(method, in_si(method.mechanism, values), held)
    method = method_of(method)
    drawn = agreement.held if held else running.replay_all
    plot = drawn(method, of_one_shape(in_si(method.mechanism, values)), compiled)
    return State(partial(readings, method, plot), plot, places(method))


def trial(mechanism: Source, name: str, *names: str, over: Ranges = ()) -> Trial:
    """A mechanism to be drawn again and again with other values of these names, as an optimiser wants it.

    name    one and more, as `with_` has them: "AB", "BDE", "D" for a place (x, y), "omega AB"
    over    the positions, in deg and mm, as `sweep` has them; a driver that is not named stands still

    Drawn are the same crossings as of the mechanism itself, unproved; `taken` proves what is then taken. What wheels,
    cams, links that are fitted, or an angle not between two given lengths hang on is planned anew, which takes longer.

    >>> length = trial("ex3-5", "AB", "DC", over="0:360:1")
    >>> [round(float(length(*pair).v["E"].magnitude.max()), 6) for pair in ((30, 60), (28, 65))]
    [0.409084, 0.381824]
    >>> length.taken(28, 65).mechanism.links["1"].arm("A", "B")
    (0.028+0j)
    """
    from graphkin.api.variants import Trial

    return Trial.of(load(mechanism), (name, *names), over)


def motion(mechanism: Source | Variants, values: Values = None) -> State:
    """The same by the analysis: closed vector loops and the matrix method; nothing is drawn or planned. Of
    `Mechanism.variants` one after another.

    Raises NoAssembly for the drawn position, SingularPosition where that, or a single position asked for, is a dead
    point; positions that no way leads to are nan.

    >>> exact = motion("ex3-1")
    >>> exact.omega["3"], exact.a["C"], exact["a_k B3B2"].magnitude
    (-3.91933 rad/s, 3.07641 m/s^2 at 209.4773°, 2.51485 m/s^2)
    """
    if isinstance(mechanism, AnyVariants):
        from graphkin.api import variants

        return variants.moved(mechanism, in_si(mechanism.mechanism, values))
    from graphkin import analytic

    mechanism = mechanism if isinstance(mechanism, Mechanism) else load(mechanism)
    return State(analytic.motion(mechanism, of_one_shape(in_si(mechanism, values))))


@overload
def sweep(
    mechanism: Variants, ranges: Ranges = (), of: str | Sequence[str] = (), by: Road = "construction"
) -> State: ...
@overload
def sweep(
    mechanism: Source | Method, ranges: Ranges = (), of: str | Sequence[str] = (), by: Road = "construction",
    compiled: bool | None = None,
) -> SweepFrames: ...  # fmt: skip
def sweep(
    mechanism: Source | Method | Variants, ranges: Ranges = (), of: str | Sequence[str] = (),
    by: Road = "construction", compiled: bool | None = None,
) -> SweepFrames | State:  # fmt: skip
    """Quantities over a turn, or as far as the mechanism gets; angles go on beyond a full turn.

    ranges  by driver, in deg and mm: an array, a text `"0:360:10"`, or a number that holds it still; nothing: the first
            driver through a turn. Drivers that move together do so in proportion
    of      `["theta 4", "v E"]`, or one text with commas; nothing: what the file asks
    by      "construction", or "analysis"
    compiled  as `replay` has it

    `Mechanism.variants` gives a `State` (positions, n): without ranges at the positions that the first of them reaches,
    with ranges at all of these, as `replay` has them, or by "analysis" as they are moved there, nan where no way leads;
    drivers without a range stand still.

    Raises BadRange, NoSuchDriver, UnknownQuantity and their like, and RoadsDiffer where the two roads do not agree.

    >>> import numpy as np
    >>> found = sweep("ex3-7", {"AB": np.linspace(0, 20, 3)}, "theta 4, v E")
    >>> found
    <Sweep of ex3-7: AB = 0 to 20 deg, 3 positions: theta 4, v E>
    >>> found["theta 4"].degrees.round(5)
    array([168.93822, 172.02725, 175.32662])
    >>> found["v E"].signed.round(5), found["v E"].direction.round(3)
    (array([-0.10184, -0.12272, -0.13833]), array([180., 180., 180.]))
    """
    from graphkin.outputs.tables import SweepFrames
    from graphkin.studies import sweeps

    among(sweeps.Road, by=by)
    if isinstance(mechanism, AnyVariants):
        from graphkin.api import variants

        return variants.swept(mechanism, ranges, sweeps.split(of) if isinstance(of, str) else of, by)
    method = method_of(mechanism)
    made = sweeps.sweep(method, ranges, sweeps.split(of) if isinstance(of, str) else of, by, compiled)
    return SweepFrames(**vars(made))
