"""Pages as `graphkin handout --scan` prints them: as they come out of a printer, drawn on with pencils, photographed."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path

import numpy as np
from cameras import CAMERAS, Camera, LaidSheet, Photograph, Scanner, lasered, taken
from pencil import NEAT, PER_MM, Habits, PrintedPaper, Work

import graphkin
from graphkin.construction import Plane
from graphkin.handouts import handout
from graphkin.handouts.problem import drawn_problem
from graphkin.handouts.typst import pdf
from graphkin.marking.rewrite import Rewrite
from graphkin.outputs.sheets_json import read_sheets
from graphkin.photo.sheets import PrintedSheet, SheetRoom

A4 = 210.0, 297.0
FINE = 24.0  # pixels a mm of what nobody has drawn on


def rastered(document: bytes | Path, page: int, per_mm: float) -> np.ndarray:
    """A page of a PDF in grey."""
    import pypdfium2

    sheet = pypdfium2.PdfDocument(document)[page]
    scale = (per_mm * A4[1] - 0.02) / sheet.get_size()[1]  # not a row of pixels more: the page would be drawn out
    raster = sheet.render(scale=scale, grayscale=True).to_numpy()
    grey = np.array(raster.reshape(*raster.shape[:2], -1)[:, :, 0])
    assert grey.shape == (round(A4[1] * per_mm), round(A4[0] * per_mm))
    return grey


@cache
def sheets_pdf(name: str, first: int, stage: str = "blank") -> bytes:
    return pdf(handout([graphkin.load(name)], stage, "en"), scan=first)


@cache
def printed(name: str = "ex3-1", first: int = 31415, page: int = 1, laser: bool = True) -> np.ndarray:
    """The second page of a worksheet has room for a velocity polygon; its number is one above the first's."""
    grey = rastered(sheets_pdf(name, first), page, FINE)
    return lasered(grey, FINE) if laser else grey


def drawn_on_tablet(document: bytes | Path, lines: Mapping[int, Sequence[tuple[complex, complex]]]) -> bytes:
    """A PDF with lines on its pages, by number [mm from the left upper corner, y down], as vectors."""
    import pypdfium2
    import pypdfium2.raw as raw

    pages, out = pypdfium2.PdfDocument(document), io.BytesIO()
    for number, own in lines.items():
        page = pages[number]
        for ends in own:
            (x0, y0), (x1, y1) = ((72 / 25.4 * at.real, 72 / 25.4 * (A4[1] - at.imag)) for at in ends)
            path = raw.FPDFPageObj_CreateNewPath(x0, y0)
            raw.FPDFPath_LineTo(path, x1, y1)
            raw.FPDFPageObj_SetStrokeWidth(path, 1.2)
            raw.FPDFPageObj_SetStrokeColor(path, 20, 20, 90, 255)
            raw.FPDFPath_SetDrawMode(path, raw.FPDF_FILLMODE_NONE, True)
            raw.FPDFPage_InsertObject(page, path)
        page.gen_content()
    pages.save(out)
    return out.getvalue()


@dataclass(frozen=True)
class PdfPage(PrintedPaper):
    """A page of a PDF with the rooms that its list tells."""

    sheet: PrintedSheet | None = None
    pdf: Path = Path()
    page: int = 0

    @property
    def planes(self) -> tuple[Plane, ...]:
        return tuple(self.rooms)

    @cached_property
    def rooms(self) -> dict[Plane, SheetRoom]:
        assert self.sheet is not None
        return {room.plane: room for room in self.sheet.rooms if room.plane != "position"}

    @cached_property
    def light(self) -> np.ndarray:
        return rastered(self.pdf, self.page, PER_MM)


@dataclass(frozen=True)
class Printed:
    """A PDF with its list; `mechanism`: the file of each of its problems, by name."""

    pdf: Path
    folder: Path | None = None

    @cached_property
    def sheets(self) -> list[PrintedSheet]:
        listed = self.pdf.with_suffix(".sheets.json")
        return read_sheets(listed if listed.is_file() else self.pdf.with_name("sheets.json"))

    def drawn(
        self, number: int, seed: int = 1, mistakes: tuple[Rewrite, ...] = (), habits: Habits = NEAT
    ) -> tuple[np.ndarray, Work]:
        """The page of this number after a student has drawn on it."""
        at = next(k for k, sheet in enumerate(self.sheets) if sheet.number == number)
        sheet = self.sheets[at]
        source = sheet.problem if self.folder is None else str(self.folder / f"{sheet.problem}.toml")
        problem = drawn_problem(graphkin.load(source), "en", sheet.student)
        work = Work(PdfPage(problem, sheet, self.pdf, at), seed, mistakes, habits=habits)
        return work.page(), work


def photographed(*pages: np.ndarray, camera: Camera | Scanner = CAMERAS["phone"], seed: int = 1, turned: float = 0.0) -> Photograph:
    """One or several pages on one picture, beside each other."""
    laid = [LaidSheet(page, PER_MM, k * (A4[0] + 8), turned) for k, page in enumerate(pages)]
    return taken(laid, camera, seed)
