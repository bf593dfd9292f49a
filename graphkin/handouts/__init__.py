"""Handouts on paper: a problem, a worksheet to draw on, a half-worked solution, a solution; for one mechanism or many.

`stages` makes blocks of a solution's sections and what stands after it (`problem`), with what is to be filled in
(`worksheet`); `paging` turns the pages. `typst` sets them as PDF, `markup` as HTML. Texts and drawings are those of
`explain` and `draw`.
"""

from __future__ import annotations

from graphkin.handouts.document import Handout, Stage
from graphkin.handouts.stages import handout, in_languages

__all__ = ["Handout", "Stage", "handout", "in_languages"]
