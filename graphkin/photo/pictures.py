"""Pictures in the files that students and copiers make: JPEG, PNG, each page of a PDF, as grey pixels."""

from __future__ import annotations

import ctypes
import math
import re
from collections.abc import Iterator
from itertools import islice
from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphkin.base.value import bulky
from graphkin.errors import BrokenSubmission, PictureKind, TooMuch, WantsExtra, Where
from graphkin.photo.markers import CORNERS
from graphkin.submissions.archives import foreign

Pixels = NDArray[np.uint8]

_EXTRA = "graphkin[photo]"
_PDF, _GLANCE = b"%PDF", 1024  # a PDF may begin a little later
_KINDS = {
    "JPEG": rb"\xff\xd8\xff", "PNG": rb"\x89PNG\r\n\x1a\n", "HEIC": rb"....ftyp(?:hei|hev|mif1|msf1)",
    "AVIF": rb"....ftypavi", "WEBP": rb"RIFF....WEBP", "GIF": rb"GIF8", "TIFF": rb"II\*\0|MM\0\*",
    "BMP": rb"BM....\0\0\0\0",
}  # fmt: skip
_NAMES = (".jpg", ".jpeg", ".png", ".heic", ".heif", ".avif", ".webp", ".gif", ".tif", ".tiff", ".bmp", ".dng")
_MOST, _PLENTY = 150e6, 45e6
"""Pixels of a picture that is read at all; of one that has more than plenty every second one is left out."""
_COVERS, _WORDS = 0.6, 40  # part of a page that hides what lies below; visible letters that are no text to speak of
_UNSEEN = 3  # a PDF's word for letters that are there to be searched and copied
_PAGES = 3  # of a PDF that tell what it is
_DRAWN, _SEEN = 4.2, 2.0  # pixels a point with which a page is looked at on which no picture is; to find markers on it
_STAMP = 0.1  # part of a page up to which a picture is none of the page


@bulky
class GreyPicture:
    """Grey pixels, 0 black, as they are looked at upright; where: file, and page of a PDF."""

    where: Where
    grey: Pixels

    @property
    def name(self) -> str:
        return str(self.where)


def is_picture(name: str, content: bytes) -> bool:
    """True of a file to be looked at; of a PDF, if there are pictures on its first pages and no text to speak of, or a
    sheet, which was drawn on with a tablet. One that cannot be opened is no picture, nor is any where PDFs cannot be
    looked at."""
    if _PDF not in content[:_GLANCE]:
        return name.lower().endswith(_NAMES) or _kind(content) != ""
    try:
        pages = [*islice(_pages(content, Where(name)), _PAGES)]
        scanned = any(fine for _, fine, _ in pages) and all(letters <= _WORDS for _, _, letters in pages)
        return scanned or any(_is_sheet(_grey(page, _SEEN)) for page, _, _ in pages)
    except (BrokenSubmission, TooMuch, WantsExtra):
        return False


def _is_sheet(grey: Pixels) -> bool:
    """True where markers are seen that stand in corners."""
    import cv2

    known = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_250)
    _, ids, _ = cv2.aruco.ArucoDetector(known).detectMarkers(grey)
    return ids is not None and bool(np.sum(ids < CORNERS) > 1)


def pictures_in(name: str, content: bytes, where: Where) -> Iterator[GreyPicture]:
    """The pictures of a file, one after another. Raises WantsExtra, PictureKind, BrokenSubmission, TooMuch."""
    kind = _kind(content)
    if _PDF in content[:_GLANCE]:
        yield from _rendered(content, where)
    elif kind in ("JPEG", "PNG"):
        yield GreyPicture(where, _decoded(content, kind, where))
    elif kind:
        raise PictureKind(where, kind)
    else:
        raise BrokenSubmission(where, name.rpartition(".")[2].upper())


def _kind(content: bytes) -> str:
    """By how it begins; "" of what is no picture."""
    return next((kind for kind, start in _KINDS.items() if re.match(start, content, re.S)), "")


def _decoded(content: bytes, kind: str, where: Where) -> Pixels:
    """Turned as the camera says it was held."""
    size = _jpeg_size(content) if kind == "JPEG" else _png_size(content)
    if size > _MOST:
        raise TooMuch(where, "pixels", _MOST)
    with foreign(where, kind, _EXTRA):
        import cv2

        flag = cv2.IMREAD_REDUCED_GRAYSCALE_2 if size > _PLENTY else cv2.IMREAD_GRAYSCALE
        if size and (grey := cv2.imdecode(np.frombuffer(content, np.uint8), flag)) is not None:
            return np.asarray(grey, dtype=np.uint8)
    raise BrokenSubmission(where, kind)


def _png_size(content: bytes) -> int:
    """Its pixels; 0 where it has no end."""
    wide, high = (int.from_bytes(content[at : at + 4], "big") for at in (16, 20))
    return wide * high if b"IEND" in content[max(33, len(content) - _GLANCE) :] else 0


def _jpeg_size(content: bytes) -> int:
    """Its pixels, by its segments up to where the picture begins; 0 where that has no end."""
    at, size = 2, 0
    while content[at : at + 1] == b"\xff":
        mark, length = content[at + 1 : at + 2], int.from_bytes(content[at + 2 : at + 4], "big")
        if mark == b"\xda":
            return size if content.find(b"\xff\xd9", at) > 0 else 0
        if b"\xc0" <= mark <= b"\xcf" and mark not in b"\xc4\xc8\xcc":
            size = int.from_bytes(content[at + 5 : at + 7], "big") * int.from_bytes(content[at + 7 : at + 9], "big")
        at += 1 if mark == b"\xff" else 2 + length
    return 0


def _pages(content: bytes, where: Where) -> Iterator[tuple[Any, float, int]]:
    """The pages of a PDF as pypdfium2 has them, each with the finest picture on it [pixels a point], 0 where there is
    none, and its letters that are seen: not invisible, as programs that read scans draw them, nor under a picture."""
    with foreign(where, "PDF", _EXTRA):
        import pypdfium2

        try:
            document = pypdfium2.PdfDocument(content)
        except pypdfium2.PdfiumError as problem:
            raise BrokenSubmission(where, "PDF", "password" if "password" in str(problem) else "") from None
        for page in document:
            yield page, *_glance(page, where)


def _glance(page: Any, where: Where) -> tuple[float, int]:
    import pypdfium2.raw as raw

    (wide, high), text, fine, letters = page.get_size(), page.get_textpage(), 0.0, 0
    left, low, right, top = (ctypes.c_float() for _ in range(4))
    across, down = ctypes.c_uint(), ctypes.c_uint()
    for each in page.get_objects(max_depth=4):
        if each.type == raw.FPDF_PAGEOBJ_IMAGE and raw.FPDFImageObj_GetImagePixelSize(each, across, down):
            if (pixels := across.value * down.value) > _MOST:
                raise TooMuch(where, "pixels", _MOST)
            raw.FPDFPageObj_GetBounds(each, left, low, right, top)
            covered = (right.value - left.value) * (top.value - low.value) / (wide * high)
            covered = covered if 0 < covered < 1 and each.level == 0 else 1.0  # inside a form measures are its own
            fine = max(fine, math.sqrt(pixels / (covered * wide * high)) if covered > _STAMP else 0.0)
            letters = 0 if covered > _COVERS else letters
        elif each.type == raw.FPDF_PAGEOBJ_TEXT and raw.FPDFTextObj_GetTextRenderMode(each) != _UNSEEN:
            letters += raw.FPDFTextObj_GetText(each, text, None, 0) // 2 - 1  # UTF-16, with a zero at its end
    return fine, letters


def _rendered(content: bytes, where: Where) -> Iterator[GreyPicture]:
    """Each page as fine as the pictures on it are."""
    for number, (page, fine, _) in enumerate(_pages(content, where), 1):
        with foreign(where, "PDF", _EXTRA):
            scale = min(fine or _DRAWN, math.sqrt(_PLENTY / math.prod(page.get_size())))
            grey = _grey(page, scale)
        yield GreyPicture(Where(where.file, where.line, f"p. {number}"), grey)


def _grey(page: Any, scale: float) -> Pixels:
    """A page of a PDF with so many pixels a point."""
    image = page.render(scale=scale, grayscale=True).to_numpy()
    return np.array(image.reshape(*image.shape[:2], -1)[:, :, 0])
