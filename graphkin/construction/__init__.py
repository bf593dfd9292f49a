"""The pencil's work as data, and `replay`, which does it.

A construction is a list of steps. A step names points, links and slides; it holds no coordinates. Three planes share
the step kinds: `position` (the mechanism), `velocity` (pole p), `acceleration` (pole p'). A point of a plane is named
by a text: the mechanism's own point (`B`), in the polygons the small letter (`b3`, `b3'`, `n3'`, `k'`).

A *site* is a point seen as part of one link: `B3` is the point of link 3 that lies under B now.

`terms` holds the arrows, `kinds` the steps, `construction` the equations and what is made of all; `plot` the start and
the outcome of a replay. `pencil` is the one function that steps through a construction, exactly or with another `Hand`;
`linear` and `fitting` find what ruler and compass do not give.
"""

from __future__ import annotations  # isort: skip_file

from graphkin.construction.construction import BrokenChain, Construction, Equation, Node, NotClosable
from graphkin.construction.kinds import (  # fmt: skip
    Arc, Chain, Closure, Fit, Given, Image, InStep, LayOff, Measure, Meet, Ray, Roll, Simultaneous, Step, Swing,
    Touch, UnknownScalar,
)
from graphkin.construction.linear import unknowns_of
from graphkin.construction.pencil import Hand, replay
from graphkin.construction.plot import Facts, Plot, TurnOf, slide_key
from graphkin.construction.terms import (  # fmt: skip
    LETTER, SCALES, Across, AcrossGuide, Along, AlongGuide, Arm, Coriolis, Direction, Drawn, Driven, Normal, Plane,
    Quarter, Relative, Site, Size, Slid, Span, Tangential, Term, Turning,
)

__all__ = [
    "LETTER", "SCALES", "Across", "AcrossGuide", "Along", "AlongGuide", "Arc", "Arm", "BrokenChain", "Chain", "Closure",
    "Construction", "Coriolis", "Direction", "Drawn", "Driven", "Equation", "Facts", "Fit", "Given", "Hand", "Image",
    "InStep", "LayOff", "Measure", "Meet", "Node", "Normal", "NotClosable", "Plane", "Plot", "Quarter", "Ray",
    "Relative", "Roll", "Simultaneous", "Site", "Size", "Slid", "Span", "Step", "Swing", "Tangential", "Term",
    "Touch", "TurnOf", "Turning", "UnknownScalar", "replay", "slide_key", "unknowns_of",
]  # fmt: skip
