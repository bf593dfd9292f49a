"""What the pencil did, written down: a replay with quantities that only keep a tape.

`record` replays constructions once. Where plain replay has numbers, this one has `Written` quantities: complex numbers
whose two parts are places in a tape. Whatever is done with them, by operators or by NumPy, is entered there. So the
steps stay the one place that says how a mechanism is drawn; `program` reads the tape.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.construction.construction import Construction
from graphkin.construction.kinds import Meet, Swing
from graphkin.construction.pencil import Compass, replay
from graphkin.construction.plot import Facts, Plot
from graphkin.geometry import Value, cross, leg, meet_circles, meet_line_circle, meet_lines, third_corner
from graphkin.running.compiled.calculated import fitted, together
from graphkin.running.compiled.tape import Tape
from graphkin.running.compiled.written import Written
from graphkin.value import Lazy, frozen


@frozen
class Recording:
    """A replay written down.

    plot   its plot: every value a number, or `Written`
    sides  of the crossings that may be taken either way, as the steps have them, by number of the choice; the tape is
           given the drivers' values, then a side of each of these
    near   what is asked of a position close by, given last: angles by base link, displacements by `slide_key`
    sound  what is above 0 where links that are fitted are found
    """

    tape: Tape
    plot: Plot
    sides: Mapping[int, int]
    near: tuple[str, ...]
    sound: tuple[Written, ...]


def record(constructions: Sequence[Construction], facts: Facts, near: Iterable[str] = ()) -> Recording:
    """Replay position, velocity and acceleration once, for all values of the drivers and all sides of the crossings.

    The drivers' rates and accelerations are numbers: what stands still costs nothing. `near` has what a position close
    by can tell. Raises CannotRecord.
    """
    tape = Tape()
    count = len(facts.values)
    values = tuple(Written(tape, tape.given(k)) for k in range(count))
    meant = {
        step.choice: step.side
        for step in constructions[0].steps
        if isinstance(step, Meet | Swing) and step.choice is not None
    }
    sides = {choice: Written(tape, tape.side(count + k)) for k, choice in enumerate(meant)}
    read: list[str] = []
    sound: list[Written] = []

    def close_by(name: str) -> Value:
        read.append(name)
        return Written(tape, tape.given(count + len(meant) + len(read) - 1))

    plot = Plot(replace(facts, values=values), Lazy(near, close_by))
    compass = replace(WRITING, fit=lambda step, plot: sound.append(fitted(step, plot)))
    for construction in constructions:
        replay(construction, plot, sides if construction.plane == "position" else None, compass)
    return Recording(tape, plot, meant, tuple(read), tuple(sound))


# --- crossings that can be written down --------------------------------------------------------


def _leg(hypotenuse: Value, other: Value) -> Value:
    """`geometry.leg` as a plain root.

    What that makes of squares below 0 is left to it: their roots fail, and whoever carries the tape out does such
    positions by plain replay.
    """
    if isinstance(hypotenuse, Written) or isinstance(other, Written):
        return np.sqrt(hypotenuse * hypotenuse - other * other)
    return leg(hypotenuse, other)


def _meet_lines(p: Value, u: Value, q: Value, w: Value) -> tuple[Value, Value]:
    """The same crossing; how far it lies along both lines is known where that is measured.

    On a line that is drawn along an axis, one of its coordinates is a number; the other line gives the other sooner.
    """
    point, sine = meet_lines(p, u, q, w)
    if not isinstance(point, Written):
        return point, sine
    start, way, far = p, u, cross(q - p, w) / cross(u, w)
    if isinstance(w, Written) and not isinstance(u, Written):
        times = cross(q - p, u) / cross(u, w)
        if (sooner := q + w * times).straight:
            start, way, far, point = q, w, times, sooner
    (point - start).know_along(far, way)
    return point, sine


def _meet_line_circle(p: Value, u: Value, c: Value, r: Value, side: Value) -> tuple[Value, Value, Value]:
    """The same crossing; the compass has laid its distance from the centre off, and it need not be measured again."""
    found = meet_line_circle(p, u, c, r, side, _leg)
    _know_length(found[0] - c, r)
    return found


def _meet_circles(c1: Value, r1: Value, c2: Value, r2: Value, side: Value) -> tuple[Value, Value, Value]:
    """The same crossing; nor need the area between its arms."""
    point, sine, miss = meet_circles(c1, r1, c2, r2, side, _leg)
    arm, other = point - c1, point - c2
    _know_length(arm, r1)
    _know_length(other, r2)
    if isinstance(arm, Written) and isinstance(other, Written):
        arm.know_cross(other, side * sine * r1 * r2)
    return point, sine, miss


def _image(first: Value, second: Value, ratio: Value) -> Value:
    """The same corner; it may be found with the vectors as wholes."""
    found = third_corner(first, second, ratio)
    number = ratio.number if isinstance(ratio, Written) else complex(ratio)
    if number is not None and isinstance(found, Written):
        found.know_image(first, second, number)
    return found


def _know_length(arm: Value, length: Value) -> None:
    if isinstance(arm, Written):
        arm.know_length(length)


WRITING = Compass(_leg, _meet_lines, _meet_line_circle, _meet_circles, _image, together=together)
