"""What a sheet is written as: one file a format.

`svg` is the drawing file itself; a program can measure it (`graphkin.check`).
"""

from graphkin.outputs import svg

__all__ = ["svg"]
