"""A figure of matplotlib's that has graphkin's settings, wherever it is made, shown and saved."""

from __future__ import annotations

import io
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache
from os import PathLike
from threading import RLock
from typing import IO

import matplotlib
from matplotlib import RcParams
from matplotlib.backend_bases import RendererBase
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from graphkin.outputs.diagram.fonts import LATIN, MARK, letters
from graphkin.outputs.typesetting import LATIN as SERIFS

DPI = 200
_ALONE = RLock()
"""matplotlib reads formulas by one reader for all threads: diagrams are made one at a time."""
_OWN: ContextVar[Mapping[str, object]] = ContextVar("own settings")


class _OwnFirst(RcParams):
    """matplotlib's settings while a diagram is made: whoever makes it reads its own, every other thread the user's."""

    def __getitem__(self, key: str) -> object:
        own = _OWN.get({})
        if key in own:
            return own[key]
        return RcParams.__getitem__(self, key)  # type: ignore[index, unused-ignore]  # it may be that class by now


@contextmanager
def settings(outlines: bool = False) -> Iterator[None]:
    """matplotlib as it comes, with our letters, or their outlines, which are as wide in any viewer. The user's settings
    are neither read nor changed."""
    with _ALONE:
        before, token = type(matplotlib.rcParams), _OWN.set(_settings(outlines, *letters()))
        matplotlib.rcParams.__class__ = _OwnFirst
        try:
            yield
        finally:
            matplotlib.rcParams.__class__ = before
            _OWN.reset(token)


@cache
def _settings(outlines: bool, *families: str) -> Mapping[str, object]:
    # PDF fonts as outlines (3): as 42, letters of OpenType Chinese fonts are not seen
    usual: dict[str, object] = dict(matplotlib.rcParamsDefault.items())
    del usual["backend"]
    return usual | {
        "font.family": [*families], "font.size": 9.0, "mathtext.fontset": "stix", "mathtext.fallback": None,
        "svg.hashsalt": "graphkin", "svg.fonttype": "path" if outlines else "none", "pdf.fonttype": 3,
        "text.hinting": "no_hinting", "path.simplify": False,
    }  # fmt: skip


class DiagramPage(Figure):
    """A figure [inches] that looks alike whatever matplotlib's settings are: a Figure with `svg()`, `to_png()`
    and `to_pdf()`."""

    def __init__(self, title: str, width: float, height: float, outlines: bool = False) -> None:
        super().__init__(figsize=(width, height), dpi=DPI)
        self.about, self.outlines = title, outlines
        FigureCanvasAgg(self)

    def draw(self, renderer: RendererBase) -> None:
        with settings(self.outlines):
            super().draw(renderer)

    def savefig(
        self, fname: str | PathLike[str] | IO[bytes], *, transparent: bool | None = None, **more: object
    ) -> None:
        with settings(self.outlines):
            super().savefig(fname, transparent=transparent, **more)

    def content(self, kind: str) -> bytes:
        """The file of this ending, `.svg`, `.png` or `.pdf`: with the title, the program, and no time."""
        file, own = io.BytesIO(), f"graphkin {MARK}"
        about: Mapping[str, Mapping[str, str | None]] = {
            ".svg": {"Title": self.about, "Creator": own, "Date": None}, ".png": {"Software": own},
            ".pdf": {"Creator": own, "Producer": None, "CreationDate": None},
        }  # fmt: skip
        self.savefig(file, format=kind[1:], dpi=DPI, metadata=about[kind])
        # letters of the same widths, where a machine has others
        return file.getvalue().replace(f"'{LATIN}'".encode(), f"'{LATIN}', {SERIFS}".encode())

    def svg(self) -> str:
        return self.content(".svg").decode()

    def to_png(self) -> bytes:
        return self.content(".png")

    def to_pdf(self) -> bytes:
        return self.content(".pdf")

    _repr_svg_ = svg
