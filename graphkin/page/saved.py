"""Pages as programs make them, in the words of `graphkin page`, and save them; in a notebook they play in a frame."""

from __future__ import annotations

from html import escape
from pathlib import Path

from graphkin.api.drawing import Drawing, Source, method_of
from graphkin.base.geometry import number
from graphkin.base.value import bulky
from graphkin.errors import Lang
from graphkin.errors.arguments import checked
from graphkin.outputs.files import UnknownEnding
from graphkin.page import player, writer
from graphkin.planning import Method

_HIGH = 820  # of the frame in a notebook [px]


@bulky
class SavedPage:
    """A page: `save("x.html")`; a notebook shows it."""

    text: str

    @checked
    def save(self, path: str | Path, *, force: bool = False) -> Path:
        """Write it as .html; force: even over a file of another's."""
        file = Path(path)
        if file.suffix.lower() != ".html":
            raise UnknownEnding(str(file), (".html",))
        writer.write(file, self.text, force)
        return file

    def _repr_html_(self) -> str:
        style = f"width:100%;height:{_HIGH}px;border:0"
        return f'<iframe style="{style}" title="graphkin" srcdoc="{escape(self.text)}"></iframe>'


def play(*mechanisms: Source | Drawing | Method, lang: Lang = "en") -> SavedPage:
    """Mechanisms that play in a browser: drag the crank, the polygons follow. Several make a lecture; a drawing begins
    at its position."""
    return SavedPage(player.page_of([*map(_played, mechanisms)], lang))


def _played(mechanism: Source | Drawing | Method) -> player.Data:
    if isinstance(mechanism, Drawing):
        return player.played(mechanism.method, [*map(number, mechanism.plot.facts.values)])
    return player.played(method_of(mechanism))
