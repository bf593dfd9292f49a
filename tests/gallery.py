"""The gallery: every library mechanism as a sheet in each language, a coupler curve, a handout, feedback on homework;
and the manual as GitHub shows it.

    .venv/bin/python tests/gallery.py            rebuilds figures/
    .venv/bin/python tests/gallery.py ex3-1      one of them
    .venv/bin/python tests/gallery.py feedback   the page of feedback; `path` the coupler curve; `handout` the worksheet
    .venv/bin/python tests/gallery.py manual     the manual, which has the texts of all commands and public names
"""

from __future__ import annotations

import io
import re
import shutil
import sys
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from itertools import chain
from pathlib import Path
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any
from unittest import mock

from library_sheets import library_sheet

from graphkin import Drawing
from graphkin.cli import reference
from graphkin.cli.manual import Manual
from graphkin.errors import Lang, Where
from graphkin.files import library
from graphkin.homework import grading, platforms
from graphkin.homework.platforms.feedback import Feedback
from graphkin.homework.platforms.pages import drawing as page
from graphkin.outputs.marks_json import record
from graphkin.outputs.svg import svg

if TYPE_CHECKING:
    from PIL.Image import Image

HOMEWORK = Path(__file__).parent / "cases" / "homework"
FEEDBACK, MANUAL = "feedback", "manual"
"""The folders of the page of feedback, and of the manual."""
PATH, HANDOUT = "path", "handout"
"""The folder of the coupler curve; the picture of a worksheet."""
FIGURES = Path(__file__).parent.parent / "figures"
NUMBER = re.compile(r"[-+]?\d*\.?\d+(?:e[-+]?\d+)?")
CLOSE_MM = 0.02


def drawings(name: str, chinese: bool = True) -> Iterator[tuple[Path, str]]:
    """The files of one mechanism, relative to the gallery, and what should be in them."""
    for lang, end in (("en", ""), ("zh", "-zh"))[: 1 + chinese]:
        yield Path(name) / f"{name}{end}.svg", svg(library_sheet(name, lang=lang))


def feedback() -> Iterator[tuple[Path, str]]:
    """The page of a student who left out the Coriolis acceleration of example 3-1."""
    judge = grading.judge_from("ex3-1")
    (graded,) = grading.grade(judge, [HOMEWORK / "s1.toml"])
    result, pictures = platforms.from_record(record(graded), Where("s1.toml")), platforms.PolygonPictures(judge)
    for lang, end in (("en", ""), ("zh", "-zh")):
        told = Feedback(
            result, lang, "answer", pictures(result, lang, "answer"), problem=pictures.problem(result, lang, "answer")
        )
        yield Path(FEEDBACK) / f"{FEEDBACK}{end}.svg", page(told).decode()


def path() -> Iterator[tuple[Path, str]]:
    """A coupler curve with the point's velocities."""
    drawing = Drawing.of(library.load("ex3-5"))
    for lang, end in (("en", ""), ("zh", "-zh")):
        sheet = drawing.sheet(lang=lang, only="position", tight=True, paths=["E"], arrows=True)
        yield Path(PATH) / f"{PATH}{end}.svg", svg(sheet)


def worksheet() -> Image:
    """Two pages of example 3-1 as they are printed, side by side."""
    import typst
    from PIL import Image

    from graphkin.handouts import handout
    from graphkin.handouts.typst import pdf

    pages: list[bytes] = []
    Compiler = typst.Compiler

    def compiler(source: bytes, **options: Any) -> Any:
        real = Compiler(source, **options)

        def seen(source: bytes, **how: Any) -> Any:
            pages.extend(real.compile(source, format="png", ppi=66))
            return real.compile(source, **how)

        return SimpleNamespace(query=real.query, compile=seen)

    with mock.patch.object(typst, "Compiler", compiler):
        pdf(handout([library.load("ex3-1")], "blank", "en"))
    first, second = (Image.open(io.BytesIO(page)).convert("L") for page in pages[:2])
    both = Image.new("L", (first.width * 2 + 8, first.height), 160)
    both.paste(first, (0, 0))
    both.paste(second, (first.width + 8, 0))
    return both.quantize(16)


def manual(lang: Lang) -> Iterator[tuple[Path, str]]:
    """What the commands draw in a language, then the manual as Markdown."""
    end = "-zh" if lang == "zh" else ""
    files: list[tuple[Path, str]] = []

    def drawn(name: str, svg: str) -> str:
        files.append((Path(MANUAL) / f"{name}{end}.svg", svg + "\n"))
        return f"![{name}]({name}{end}.svg)"

    def pictured(name: str) -> str:
        return f'<a href="../{name}/{name}{end}.svg"><img src="../{name}/{name}{end}.svg" width="240" alt="{name}"></a>'

    def guide(text: str) -> str:
        return re.sub(r"\]\((?!#|https:|README)", "](../../", text).replace("](../../figures/", "](../")

    text = Manual(lang, drawn, pictured, guide, {name: reference.text(name) for name in reference.names()}).text()
    yield from (*files, (Path(MANUAL) / f"README{end}.md", text))


def special(name: str) -> Iterator[tuple[Path, str]]:
    """What is no mechanism's sheet."""
    if name == MANUAL:
        return chain(manual("en"), manual("zh"))
    return feedback() if name == FEEDBACK else path()


def differences(old: str, new: str) -> Iterator[str]:
    """What differs between two drawings: elements, texts, or numbers by more than 0.02 mm."""
    first, second = list(ET.fromstring(old).iter()), list(ET.fromstring(new).iter())
    if len(first) != len(second):
        yield f"{len(first)} elements, now {len(second)}"
        return
    for one, two in zip(first, second, strict=True):
        if one.tag != two.tag or one.attrib.keys() != two.attrib.keys():
            yield f"{one.tag} {one.attrib} is now {two.tag} {two.attrib}"
        elif one.tag.endswith("}sheet"):
            continue
        elif (one.text or "") != (two.text or ""):
            yield f"text {one.text!r} is now {two.text!r}"
        else:
            for key, value in one.attrib.items():
                if not same(value, two.attrib[key]):
                    yield f"{one.tag} {key}={value!r} is now {two.attrib[key]!r}"


def changed(path: Path, text: str) -> str:
    """What differs from a file of the gallery; it is written beside it then."""
    old = FIGURES / path
    if not (found := list(differences(old.read_text("utf-8"), text))):
        return ""
    new = old.with_suffix(".new.svg")
    new.write_text(text, encoding="utf-8", newline="\n")
    return f"{new} differs from {old.name}: {found[:3]}; rebuild with tests/gallery.py if it is right"


def same(old: str, new: str) -> bool:
    """Equal but for numbers that lie within 0.02 of each other."""
    if old == new:
        return True
    numbers = [(float(a), float(b)) for a, b in zip(NUMBER.findall(old), NUMBER.findall(new), strict=False)]
    return NUMBER.sub("#", old) == NUMBER.sub("#", new) and all(abs(a - b) <= CLOSE_MM for a, b in numbers)


def main(names: list[str]) -> None:
    """Rebuild all, or some, of the gallery."""
    if not names:
        for folder in (path for path in FIGURES.iterdir() if path.is_dir()):
            shutil.rmtree(folder)
    for name in names or (*library.names(), FEEDBACK, PATH, HANDOUT, MANUAL):
        if name == HANDOUT:
            worksheet().save(FIGURES / f"{HANDOUT}.png", optimize=True)
            continue
        for file, text in special(name) if name in (FEEDBACK, PATH, MANUAL) else drawings(name):
            (FIGURES / file).parent.mkdir(parents=True, exist_ok=True)
            (FIGURES / file).write_text(text, encoding="utf-8", newline="\n")
            print(file)


if __name__ == "__main__":
    main(sys.argv[1:])
