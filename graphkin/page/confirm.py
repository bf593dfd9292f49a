"""The page on which a teacher looks at photographs with what was found on them, corrects it, and saves that."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from graphkin.base.plain import Plain
from graphkin.errors import GraphkinError, Lang, Where
from graphkin.outputs.sheets_json import readings_data
from graphkin.page import writer
from graphkin.photo.readings import SheetReading
from graphkin.say.catalogue import LANGUAGES, for_scripts, say

_SUBJECT = "photo."


def write_page(
    path: Path, readings: Sequence[SheetReading], failed: Sequence[GraphkinError], called: Mapping[str, str],
    lang: Lang, force: bool = False,
) -> None:  # fmt: skip
    """Write the page of these readings; what it saves is called as it is.

    failed  why other pictures are not read; called: names of students by id
    """
    shown = [reading for reading in readings if reading.rooms]
    data: dict[str, Plain] = {
        "name": path.stem, "file": f"{path.stem}.json", "readings": readings_data(shown),
        "views": [_view(reading, called.get(reading.student, "")) for reading in shown], "failed": _both(failed),
    }  # fmt: skip
    words = {key.removeprefix(_SUBJECT): both for key, both in for_scripts("photo").items()}
    body = (writer.FOLDER / "confirm.html").read_text("utf-8")
    held = {"words": words, "photographs": data}
    title = say("photo.title", lang, name=path.stem)
    text = writer.page(title, lang, scripts=["confirm"], styles=["confirm"], data=held, body=body)
    writer.write(path, text, force)


def _view(reading: SheetReading, name: str) -> dict[str, Plain]:
    """The words beside the reading itself."""
    reasons = [_both(room.drawing(Where(reading.picture)).unsure) for room in reading.rooms]
    return {"called": " ".join(filter(None, (reading.student, name))), "reasons": reasons}


def _both(errors: Sequence[GraphkinError]) -> list[Plain]:
    return [{lang: error.message(lang) for lang in LANGUAGES} for error in errors]
