"""A drawing as a GeoGebra file whose objects hang on one another: drag the crank, and the polygons move.

`file` puts it together; `steps` draws a construction; `state` knows what it has found, as `formulas`; `protocol` writes
the objects down.
"""

from __future__ import annotations

from graphkin.outputs.geogebra.file import TriedOut, ggb

__all__ = ["TriedOut", "ggb"]
