"""Pages as `graphkin handout --scan` prints them, drawn on by students with pencils, and photographed."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from cameras import CAMERAS, Camera, LaidSheet, Photograph, Scanner, taken
from pencil import NEAT, PER_MM, Habits, PrintedPaper, Work

import graphkin
from graphkin.construction import Plane
from graphkin.handouts.problem import drawn_problem
from graphkin.marking.rewrite import Rewrite
from graphkin.outputs.sheets_json import read_sheets
from graphkin.photo.sheets import PrintedSheet, SheetRoom

SCAN = CAMERAS["scanner"] if "scanner" in CAMERAS else Scanner()
SIZE = 210 + 297j


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
        import pypdfium2

        page = pypdfium2.PdfDocument(self.pdf)[self.page]
        grey = page.render(scale=PER_MM * 25.4 / 72, grayscale=True).to_numpy()
        return np.ascontiguousarray(grey.reshape(grey.shape[0], grey.shape[1], -1)[:, :, 0])


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
    laid = [LaidSheet(page, PER_MM, k * (SIZE.real + 8), turned) for k, page in enumerate(pages)]
    return taken(laid, camera, seed)
