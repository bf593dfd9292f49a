"""Files that hold pictures, and those that only seem to: each is read, or gives one reason."""

from __future__ import annotations

import io
import os
import sys
from collections.abc import Sequence

import cv2
import numpy as np
import pytest

from graphkin.errors import BrokenSubmission, GraphkinError, PictureKind, TooMuch, WantsExtra, Where
from graphkin.photo.pictures import is_picture, pictures_in

GREY = np.tile(np.arange(240, dtype=np.uint8), (160, 1))
"""Lighter to the right: it tells how it is turned."""
JPEG, PNG = (cv2.imencode(ending, GREY)[1].tobytes() for ending in (".jpg", ".png"))
EXIF = b"\xff\xe1\x00\x22Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0"
"""A camera's word that it was held a quarter turn aside."""


def pdf_of(jpegs: Sequence[bytes], words: str = "", mode: int = 0, before: bool = False, size: tuple[int, int] = (240, 160)) -> bytes:
    """A page for each picture, which fills it; words: on each, over it or before it, drawn in a mode of PDF."""
    parts, kids = [b"<</Type/Catalog/Pages 2 0 R>>", b""], []
    for jpeg in jpegs:
        number = len(parts) + 1
        text = b"BT /F 9 Tf %d Tr 30 700 Td (%s) Tj ET " % (mode, words.encode()) if words else b""
        image = b"q 595 0 0 842 0 0 cm /I Do Q "
        content = text + image if before else image + text
        parts += [
            b"<</Type/Page/Parent 2 0 R/MediaBox[0 0 595 842]/Contents %d 0 R/Resources<</XObject<</I %d 0 R>>"
            b"/Font<</F<</Type/Font/Subtype/Type1/BaseFont/Helvetica>>>>>>>>" % (number + 1, number + 2),
            b"<</Length %d>>stream\n%s\nendstream" % (len(content), content),
            b"<</Type/XObject/Subtype/Image/Width %d/Height %d/ColorSpace/DeviceGray/BitsPerComponent 8/Filter/DCTDecode"
            b"/Length %d>>stream\n%s\nendstream" % (*size, len(jpeg), jpeg),
        ]
        kids.append(b"%d 0 R" % number)
    parts[1] = b"<</Type/Pages/Count %d/Kids[%s]>>" % (len(kids), b" ".join(kids))
    whole, places = b"%PDF-1.4\n", []
    for number, part in enumerate(parts, 1):
        places.append(len(whole))
        whole += b"%d 0 obj\n%s\nendobj\n" % (number, part)
    table = b"".join(b"%010d 00000 n \n" % place for place in places)
    end = b"trailer<</Size %d/Root 1 0 R>>\nstartxref\n%d\n%%%%EOF" % (len(parts) + 1, len(whole))
    return whole + b"xref\n0 %d\n0000000000 65535 f \n" % (len(parts) + 1) + table + end


def read(name: str, content: bytes) -> list:
    return list(pictures_in(name, content, Where(name)))


@pytest.mark.parametrize(("name", "content"), [("a.jpg", JPEG), ("a.PNG", PNG), ("no name", JPEG)])
def test_a_picture_is_read(name: str, content: bytes):
    (picture,) = read(name, content)
    assert picture.name == name
    assert np.abs(picture.grey.astype(float) - GREY).max() <= 4
    assert is_picture(name, content)


def test_it_is_turned_as_it_was_held():
    (picture,) = read("a.jpg", JPEG[:2] + EXIF + JPEG[2:])
    assert np.abs(picture.grey.astype(float) - np.rot90(GREY, -1)).max() <= 4


def test_colours_depth_and_transparency_do_not_matter():
    for content in (np.dstack([GREY] * 3), np.dstack([GREY, GREY, GREY, np.full_like(GREY, 255)]), GREY.astype(np.uint16) * 257):
        (picture,) = read("a.png", cv2.imencode(".png", content)[1].tobytes())
        assert np.abs(picture.grey.astype(float) - GREY).max() <= 1


def test_pages_of_a_copier_are_pictures_as_fine_as_they_were_scanned():
    pile = read("pile.pdf", pdf_of([JPEG, JPEG]))
    assert [picture.name for picture in pile] == ["pile.pdf, p. 1", "pile.pdf, p. 2"]
    for picture in pile:
        assert picture.grey.size == pytest.approx(GREY.size, rel=0.02)
        assert np.all(np.diff(picture.grey.mean(axis=0)) > 0)


LONG = "omega 3 = 3.92, alpha 3 = 62.2, and many more words of an answer"


@pytest.mark.parametrize(
    ("content", "picture"),
    [
        (pdf_of([JPEG]), True),
        (pdf_of([JPEG], LONG, mode=3), True),  # invisible letters, for searching
        (pdf_of([JPEG], LONG, before=True), True),  # letters under the picture
        (pdf_of([JPEG], "Scanned by A"), True),
        (pdf_of([JPEG], LONG), False),
        (b"%PDF-1.4 but nothing in it", False),
        (b"question,value\nomega 3,3.92\n", False),
    ],
    ids=["scan", "searchable", "under", "stamp", "text", "broken", "csv"],
)
def test_text_stays_text(content: bytes, picture: bool):
    assert is_picture("a.pdf", content) is picture


def test_a_sheet_that_was_drawn_on_with_a_tablet_is_a_picture():
    """It has text and no picture on it, but markers."""
    pytest.importorskip("typst")
    from printed_pages import drawn_on_tablet, sheets_pdf

    content = drawn_on_tablet(sheets_pdf("ex3-1", 31415), {1: [(40 + 60j, 90 + 75j)]})
    assert is_picture("a.pdf", content)
    page = read("a.pdf", content)[1].grey
    fine = page.shape[0] / 297
    x, y = (round(at * fine) for at in (65, 67.5))
    assert page[y - 3 : y + 4, x - 3 : x + 4].min() < 60


def locked() -> bytes:
    pypdf = pytest.importorskip("pypdf")
    writer, out = pypdf.PdfWriter(clone_from=io.BytesIO(pdf_of([JPEG]))), io.BytesIO()
    writer.encrypt("secret", algorithm="RC4-128")
    writer.write(out)
    return out.getvalue()


BROKEN = {
    "cut.jpg": lambda: JPEG[: len(JPEG) // 2],
    "head.jpg": lambda: JPEG[:30],
    "thumbnail.jpg": lambda: (JPEG[:2] + b"\xff\xe1\x00\x06\xff\xd8\xff\xd9" + JPEG[2:])[:-20],
    "page.jpg": lambda: b"<html>",
    "empty.jpg": lambda: b"",
    "cut.png": lambda: PNG[: len(PNG) // 2],
    "head.png": lambda: PNG[:18] + b"IEND",
    "cut.pdf": lambda: pdf_of([JPEG])[:900],
    "locked.pdf": locked,
}


@pytest.mark.parametrize("name", BROKEN)
def test_what_is_broken_gives_one_reason(name: str):
    with pytest.raises(BrokenSubmission) as caught:
        read(name, BROKEN[name]())
    assert name in str(caught.value)
    assert ("password" in str(caught.value)) == (name == "locked.pdf")


def bomb_png() -> bytes:
    return PNG[:16] + (60_000).to_bytes(4, "big") * 2 + PNG[24:]


def bomb_jpeg() -> bytes:
    at = JPEG.index(b"\xff\xc0") + 5
    return JPEG[:at] + b"\xff\xff\xff\xff" + JPEG[at + 4 :]


@pytest.mark.parametrize("bomb", [bomb_png, bomb_jpeg, lambda: pdf_of([JPEG], size=(60_000, 60_000))])
def test_what_is_too_large_is_never_unpacked(bomb, monkeypatch):
    monkeypatch.setattr(cv2, "imdecode", lambda *_: pytest.fail("unpacked"))
    with pytest.raises(TooMuch) as caught:
        read("a", bomb())
    assert "150 million pixels" in str(caught.value)


@pytest.mark.parametrize(
    ("kind", "start"),
    [("HEIC", b"\0\0\0\x18ftypheic"), ("HEIC", b"\0\0\0\x1cftypmif1"), ("AVIF", b"\0\0\0\x1cftypavif"), ("TIFF", b"II*\0"),
     ("WEBP", b"RIFF\1\2\3\4WEBP"), ("GIF", b"GIF89a"), ("BMP", b"BM\1\2\3\4\0\0\0\0")],
)  # fmt: skip
def test_other_kinds_are_refused_by_name(kind: str, start: bytes):
    content = start + b"\1" * 100
    assert is_picture("a", content)
    with pytest.raises(PictureKind) as caught:
        read("a", content)
    for lang in ("en", "zh"):
        assert kind in caught.value.message(lang)
        assert "JPEG" in caught.value.message(lang)


@pytest.mark.parametrize(("name", "content"), [("a.jpg", JPEG), ("a.pdf", pdf_of([JPEG]))])
def test_a_missing_extra_is_named(name: str, content: bytes, monkeypatch):
    monkeypatch.setitem(sys.modules, "cv2", None)
    monkeypatch.setitem(sys.modules, "pypdfium2", None)
    with pytest.raises(WantsExtra) as caught:
        read(name, content)
    assert "graphkin[photo]" in str(caught.value)


def test_hostile_bytes_raise_nothing_else():
    """Any file may have any bytes changed."""
    rng = np.random.default_rng(3)
    for whole in (JPEG[:2] + EXIF + JPEG[2:], PNG, pdf_of([JPEG], "Scanned")):
        for _ in range(60 if "GRAPHKIN_RANDOM" in os.environ else 20):
            content = np.frombuffer(whole, np.uint8).copy()
            content[rng.integers(0, len(content), rng.integers(1, 30))] = rng.integers(0, 256)
            start = content[: rng.integers(1, len(content))].tobytes() if rng.random() < 0.3 else content.tobytes()
            is_picture("a.bin", start)
            try:
                read("a.bin", start)
            except GraphkinError as error:
                assert "a.bin" in str(error)
