"""The analytic methods written out for a mechanism as a textbook writes them: `document`, then a writer.

    Method -> bodies, polygons        θ of every link, the closed vector polygons, what rolls (`model`)
           -> expressions             sums of products of symbols with cos, sin, e^i: added, derived, evaluated
           -> dyads                   closed forms: two rules, crosswise and squared, for every dyad
           -> matrices                A ω = ω1 B, A α = −Ȧ ω + ω1 Ḃ
           -> methods, written        a Document -> writers: text, html, tex

Source: Sun Huan, Theory of Machines, section 3-3, examples 3-5, 3-6 and 3-7.
"""

from __future__ import annotations

from pathlib import Path

from graphkin.equations.document import By, Document
from graphkin.equations.writers import write_html, write_tex, write_text
from graphkin.equations.written import document
from graphkin.errors.arguments import checked
from graphkin.outputs import files

__all__ = ["WRITERS", "By", "Document", "SavedDocument", "document", "write", "write_html", "write_tex", "write_text"]

WRITERS = {".txt": write_text, ".html": write_html, ".tex": write_tex}
_SIGNED = {".txt": "{text}\n(graphkin)\n", ".html": "{text}<!-- graphkin -->\n", ".tex": "{text}% graphkin\n"}
"""By these words at its end a file is known as graphkin's, so that it may be written anew."""


def write(path: Path, document: Document, force: bool = False) -> None:
    """Write a document by its file's ending. Raises FileInTheWay, NoFolder, CannotWrite."""
    if (kind := path.suffix.lower()) not in WRITERS:
        raise files.UnknownEnding(str(path), tuple(WRITERS))
    files.write(path, _SIGNED[kind].format(text=WRITERS[kind](document)), force, (b"graphkin",))


class SavedDocument(Document):
    """Analytic equations: `print` them, or `save("x.html")`, `.txt`, `.tex`."""

    def __str__(self) -> str:
        return write_text(self)

    @checked
    def save(self, path: str | Path, *, force: bool = False) -> Path:
        """Write them, by the file's ending."""
        write(Path(path), self, force)
        return Path(path)
