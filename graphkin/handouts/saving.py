"""Handouts as programs make them, in the words of `graphkin handout`, and save them."""

from __future__ import annotations

from pathlib import Path

from graphkin.api.drawing import Source, load
from graphkin.errors import Lang
from graphkin.errors.arguments import checked
from graphkin.handouts.document import Handout, Stage
from graphkin.handouts.markup import html
from graphkin.handouts.stages import in_languages
from graphkin.handouts.typst import printed
from graphkin.outputs import files, sheets_json
from graphkin.sheet.paper import papers_for

MARKS = (b"graphkin handout",)


class SavedHandout(Handout):
    """A handout: `save("x.pdf")`, or `.html`; `to_html()`, `to_pdf()` for a program; a notebook shows it."""

    @checked
    def save(
        self, path: str | Path, *, paper: str = "A4", font: Path | None = None, scan: int | None = None,
        force: bool = False, sheets: Path | None = None,
    ) -> Path:  # fmt: skip
        """Write it on this paper; font: a file with the letters wanted; scan: the number of the first page that is to
        be photographed: what is printed where is written beside it, into `x.sheets.json`, or `sheets`. A .pdf needs
        graphkin[pdf]."""
        file = Path(path)
        if file.suffix.lower() not in (".pdf", ".html"):
            raise files.UnknownEnding(str(file), (".pdf", ".html"))
        papers_for(paper)
        if file.suffix.lower() == ".html":
            files.write(file, html(self, paper), force, MARKS)
            return file
        listed = sheets or file.with_suffix(f".{sheets_json.NAME}")
        if scan is not None:
            files.refuse(listed, force, sheets_json.MARKS)
        content, pages = printed(self, paper, font, scan)
        files.write(file, content, force, MARKS)
        if pages:
            sheets_json.write_sheets(listed, pages, force)
        return file

    @checked
    def to_html(self, paper: str = "A4") -> str:
        """The text of the .html file, for this paper."""
        papers_for(paper)
        return html(self, paper)

    @checked
    def to_pdf(self, paper: str = "A4", font: Path | None = None) -> bytes:
        """The bytes of the .pdf file, on this paper. Needs graphkin[pdf]."""
        papers_for(paper)
        return printed(self, paper, font, None)[0]

    def _repr_html_(self) -> str:
        return html(self)


def handout(
    mechanism: Source, *more: Source, stage: Stage = "solution", lang: Lang = "en", both: bool = False,
    upto: int | None = None, answers: bool = False, seed: str = "", duplex: bool = False, number: int | None = None,
) -> SavedHandout:  # fmt: skip
    """Problems on paper: stage "problem", "blank" (with room to draw), "half" (solved as far as `upto` equations), or
    "solution"; several make a book. The rest is as the command has it."""
    every = [*map(load, (mechanism, *more))]
    made = in_languages(every, stage, ("zh", "en") if both else (lang,), upto=upto, answers=answers, seed=seed,
                        duplex=duplex, number=number)  # fmt: skip
    return SavedHandout(**vars(made))
