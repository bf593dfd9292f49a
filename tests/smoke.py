"""A few seconds of everything, for an installation that has nothing but what graphkin needs: no pytest, no extras.

    PYTHON tests/smoke.py           what commands say is what is kept, and nothing of graphkin warns
    PYTHON -W error tests/smoke.py  nothing that it stands on warns, either
"""

from __future__ import annotations

import sys
import warnings

warnings.filterwarnings("error", module="graphkin")
warnings.filterwarnings("error", module=r"numpy|shapely", category=RuntimeWarning)

import numpy as np  # noqa: E402
from golden import commands, place, said, unlike  # noqa: E402

import graphkin  # noqa: E402

FIRST = {"ex3-1", "ex3-7", "p3-19", "s1.toml", "rocker", "positions", "angles", "fig3-4", "rocker.toml"}
APART = "sweep ex3-7 --table"  # of two rows that are equal but for rounding it may name either


def main() -> None:
    """Commands of every kind, then arrays and a diagram as a notebook has them."""
    lines = [line for line in commands() if line.count(" ") < 2 or not FIRST.isdisjoint(line.split()[1:2])]
    lines = [line for line in lines if "zh" not in line and not line.startswith(APART)] + ["explain ex3-1 --lang zh"]
    for line in lines:
        assert not (found := unlike(place(line), place(line).read_text("utf-8"), said(line))), (line, found)
    mechanism = graphkin.load("ex3-7")
    sweep = graphkin.sweep(mechanism, {"AB": range(0, 361, 30)}, "v E, path E")
    assert np.asarray(sweep["v E"], float).shape == (13,)
    assert "<svg" in sweep._repr_svg_()
    many = graphkin.replay(mechanism.variants(AB=np.linspace(28, 32, 5)))
    assert np.ptp(many.omega["3"]) > 0
    versions = (sys.modules[name].__version__ for name in ("numpy", "shapely", "matplotlib"))
    print(f"python {sys.version.split()[0]}, numpy, shapely, matplotlib", *versions, f": {len(lines)} commands")


if __name__ == "__main__":
    main()
