"""The kinds of steps, each what the pencil does once."""

from __future__ import annotations

from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.construction.terms import Arm, Direction, Size, Slid, Span, Term


@frozen
class Given:
    """A point to start from: a fixed pivot, or the pole; `also` are the fixed points that sit on the pole."""

    point: str
    also: tuple[str, ...] = ()


@frozen
class LayOff:
    """A known arrow from `start` to `tip`; `backwards`: the arrow ends at `start` and the pencil goes to its tail."""

    term: Term
    start: str
    tip: str
    backwards: bool = False


@frozen
class Ray:
    """The line through a point in a known direction: where the head of an unknown arrow must lie."""

    through: str
    direction: Direction


@frozen
class Arc:
    """The circle about a point with a known radius: where the end of a link must lie."""

    about: str
    reach: Span


@frozen
class Meet:
    """Two lines or circles cross at `point`.

    side   +1 or -1: which crossing, for a circle (see `geometry`); it stays the same along a sweep
    choice number of this choice among those of the construction, None where lines leave none
    """

    first: Ray | Arc
    second: Ray | Arc
    point: str
    side: int = 1
    choice: int | None = None


@frozen
class Swing:
    """A link with a guide line turns about its `pivot` until the line passes where it must for `through`.

    On paper: the tangent from `through` to the circle about `pivot` that the line touches; where the line
    runs through the pivot, simply the join of the two. `span` goes from pivot to `through` and holds one
    displacement, of `slide`, which this finds; side +1 where s is the greater of the two possible.
    """

    link: str
    pivot: str
    through: str
    slide: str
    span: Span
    side: int = 1
    choice: int | None = None


@frozen
class Image:
    """A further point of `link`: the figure similar to the link on its two known points.

    corners  the two known points and the new one, as points of the mechanism
    base     the two known ones in this plane
    """

    link: str
    corners: tuple[str, str, str]
    base: tuple[str, str]
    point: str


@frozen
class Measure:
    """Ruler and protractor: a quantity read off, with its sense.

    quantity  "theta", "omega", "alpha" of a link; "s", "s_rate", "s_acceleration" of a slide
    span      for an angle of the position plane: what lies between tail and head
    tail, head  the arrow measured, as points of this plane
    lever     for omega, alpha: the points of the mechanism whose distance divides
    sign      for slides: -1 where the arrow is seen the other way round
    """

    quantity: str
    of: str
    tail: str
    head: str
    lever: tuple[str, str] = ("", "")
    span: Span | None = None
    sign: int = 1


@frozen
class Closure:
    """A way round through a group: from the point `start` over the parts to the point `end`."""

    start: str
    parts: tuple[Arm | Slid, ...]
    end: str

    @property
    def floats(self) -> bool:
        """It comes back to where it begins, wherever that lies."""
        return self.start == self.end


@frozen
class InStep:
    """Wheels that roll on each other: sum of coefficient * turn + on_slide * displacement = 0 since the drawn position.

    name    of the gear pair or the rolling wheel
    angles  links with their coefficients [m]
    way     where other pairs keep the wheel on its track, so that `slide` joins nothing: slides with what each
            adds to its displacement
    """

    name: str
    angles: tuple[tuple[str, Value], ...]
    slide: str = ""
    on_slide: float = 0.0
    way: tuple[tuple[str, float], ...] = ()


@frozen
class Roll:
    """A rolling contact gives its last unknown: the angle (or its rate) of a group of links, or of a displacement."""

    contact: InStep
    angle: str = ""
    slide: str = ""


@frozen
class Fit:
    """Links tried until they fit (样板法): positions that ruler and compass do not give, found numerically.

    angles, slides      what is found: bases of groups of links, displacements
    closures, contacts  what must hold
    """

    name: str
    angles: tuple[str, ...]
    slides: tuple[str, ...]
    closures: tuple[Closure, ...]
    contacts: tuple[InStep, ...]


@frozen
class Touch:
    """The point where two wheels touch, on the line of their centres; or a wheel and its track, at right angles to it.

    ratio   how far from `centre` towards `other`; for a track, 0 and `offset` [m] to its left
    """

    point: str
    centre: str
    other: str = ""
    ratio: float = 0.0
    slide: str = ""
    offset: float = 0.0


@frozen
class UnknownScalar:
    """One unknown scalar in a closed chain of arrows: turning of `link` over an arm, or sliding with a `sign`."""

    link: str
    slide: str
    tail: str
    head: str
    sign: int


@frozen
class Chain:
    """A closed chain of arrows: known sizes with their signs, and unknown scalars."""

    known: tuple[tuple[Size, int], ...]
    unknown: tuple[UnknownScalar, ...]


@frozen
class Simultaneous:
    """Several chains closed at once by calculation: no order of ruler and triangle reaches their unknowns."""

    angles: tuple[str, ...]
    slides: tuple[str, ...]
    chains: tuple[Chain, ...]
    contacts: tuple[InStep, ...]


Step = Given | LayOff | Ray | Arc | Meet | Swing | Image | Measure | Roll | Fit | Touch | Simultaneous
