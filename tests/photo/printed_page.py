"""A page of a real handout as it comes out of a printer: a grey raster."""

from __future__ import annotations

from functools import cache

import numpy as np
from cameras import lasered

import graphkin
from graphkin.handouts import handout
from graphkin.handouts.typst import pdf

PER_MM = 24.0
A4 = 210.0, 297.0


@cache
def sheets_pdf(name: str, first: int, stage: str = "blank") -> bytes:
    return pdf(handout([graphkin.load(name)], stage, "en"), scan=first)


@cache
def printed(name: str = "ex3-1", first: int = 31415, page: int = 1, laser: bool = True) -> np.ndarray:
    """The second page of a worksheet has room for a velocity polygon; its number is one above the first's."""
    import pypdfium2

    sheet = pypdfium2.PdfDocument(sheets_pdf(name, first))[page]
    scale = (PER_MM * A4[1] - 0.02) / sheet.get_size()[1]  # not a row of pixels more: the page would be drawn out
    raster = sheet.render(scale=scale, grayscale=True).to_numpy()
    grey = np.array(raster.reshape(*raster.shape[:2], -1)[:, :, 0])
    assert grey.shape == (round(A4[1] * PER_MM), round(A4[0] * PER_MM))
    return lasered(grey, PER_MM) if laser else grey
