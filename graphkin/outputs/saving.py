"""A sheet as programs and notebooks have it: shown, and saved as any kind of drawing."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.errors.arguments import checked
from graphkin.outputs import drawings, svg
from graphkin.outputs.paint import Ink
from graphkin.planning import Method
from graphkin.sheet import Sheet
from graphkin.sheet.page import step_sheets


@frozen
class NotebookSheet(Sheet):
    """A finished drawing: `save("x.pdf")`, `svg()`, `to_png()`, `to_pdf()`; a notebook shows it.

    layers   marks in millimetres on paper, y down, in the order of painting: "sheet" (title, results, frame),
             "mechanism", "velocity", "acceleration" (the polygons), "leaders", "labels"; `marks` has those of all
    paper, scales, origins   the paper; by plane what 1 mm means [m, m/s, m/s²] and where the origin, the pole, lies
    drawing  the method and the plot that are drawn, which a GeoGebra file is made of

    A mark is a `Stroke`, `Disc`, `ArcMark` or `Text`, or what a ruler measures: a `VectorMark` (`name`, `plane`,
    `start`, `end`), a `PointMark` (`name`, `plane`, `at`). Its `step` is the number of the step that draws it. Of plane
    "detail" is what is drawn once more, magnified: it has no scale.

    >>> import graphkin
    >>> sheet = graphkin.Drawing.of("ex3-1").sheet()
    >>> [layer.name for layer in sheet.layers]
    ['sheet', 'mechanism', 'velocity', 'acceleration', 'leaders', 'labels']
    """

    drawing: tuple[Method, Plot] | None = None

    def __repr__(self) -> str:
        layers = ", ".join(layer.name for layer in self.layers)
        return f"<Sheet of {self.mechanism.name} on {self.paper.name}: {layers}>"

    @classmethod
    def of(cls, sheet: Sheet, drawing: tuple[Method, Plot] | None = None) -> NotebookSheet:
        return cls(**vars(sheet), drawing=drawing)

    @checked
    def save(self, path: str | Path, *, dpi: float = 200.0, ink: Ink = "accent", force: bool = False) -> Path:
        """Write it as .svg, .pdf, .png, .dxf, .tex or .ggb, by the file's ending: whole, or not at all.

        ink     a colour a plane ("accent"), or "black"
        force   even over a file of another's, or a drawing that was changed by hand
        """
        file = Path(path)
        content = self.content(file, dpi, ink)
        drawings.refuse_edited(file, force)
        drawings.write(file, content, force)
        return file

    def content(self, file: Path, dpi: float = 200.0, ink: Ink = "accent") -> bytes:
        """The bytes that `save` would write into a file of this name. Raises UnknownEnding, NeedsExtra."""
        return drawings.content(file, self, self.drawing, dpi, ink)

    @checked
    def svg(self, ink: Ink = "accent") -> str:
        """The text of the .svg file, which `graphkin check` measures."""
        return svg.svg(self, ink)

    @checked
    def to_png(self, dpi: float = 200.0, ink: Ink = "accent") -> bytes:
        """The bytes of the .png file. Needs graphkin[png]."""
        return self.content(Path("x.png"), dpi, ink)

    @checked
    def to_pdf(self, ink: Ink = "accent") -> bytes:
        """The bytes of the .pdf file. Needs graphkin[pdf]."""
        return self.content(Path("x.pdf"), ink=ink)

    @checked
    def step_sheets(self, steps: Iterable[int] = ()) -> Iterator[NotebookSheet]:
        """One sheet a step of the construction, what it adds emphasised; steps: these alone."""
        return (NotebookSheet(**vars(sheet)) for sheet in step_sheets(self, steps))

    def _repr_svg_(self) -> str:
        return self.svg()
