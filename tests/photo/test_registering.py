"""Sheets on pictures: every place of a page is found, or one reason is given; truth is known from the cameras."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import cv2
import numpy as np
import pytest
from assess_map import PLACES, off, pages
from cameras import ASIDE, CAMERAS, PHONE, SCANNER, LaidSheet, Photograph, photograph, taken
from printed_pages import A4, FINE, printed

from graphkin.errors import PhotographAgain, Where
from graphkin.photo.markers import corners, dots, edges
from graphkin.photo.pictures import GreyPicture
from graphkin.photo.registering import RegisteredPage, registered


def found(grey: np.ndarray, **asked) -> list:
    return list(registered(GreyPicture(Where("a.jpg"), grey), **asked))


@cache
def phone() -> Photograph:
    return photograph(printed(), FINE, PHONE, 2)


@cache
def page() -> RegisteredPage:
    (page,) = pages(phone().content)
    assert isinstance(page, RegisteredPage)
    return page


def test_cameras_tell_the_truth():
    """Where a camera says that a spot of the page lies, there is the middle of what is dark."""
    spots = np.array([40 + 60j, 150 + 90j, 105 + 148j, 70 + 250j])
    raster = np.full((round(A4[1] * 12), round(A4[0] * 12)), 255, np.uint8)
    for spot in spots:
        cv2.circle(raster, tuple(round(x * 12 * 16 - 8) for x in (spot.real, spot.imag)), 12 * 16, 0, -1, shift=4)
    clean = {"noise": 0.0, "quality": (98, 99)}
    for device in (replace(PHONE, shade=1.0, lamp=0.0, lens=0.05, curl=6.0, **clean), replace(SCANNER, **clean)):
        photo = photograph(raster, 12.0, device, 5)
        for at in photo.true[0](spots):
            x, y = round(at.real), round(at.imag)
            light = (photo.grey[y - 20 : y + 21, x - 20 : x + 21] / 255.0) ** 2.2
            dark = np.where(light < 0.9 * light[0, 0], light[0, 0] - light, 0.0)
            side = np.arange(-20, 21)
            middle = complex((dark.sum(0) * side).sum(), (dark.sum(1) * side).sum()) / dark.sum() + complex(x, y)
            assert abs(middle - at) < 0.1


@pytest.mark.parametrize("name", ["phone", pytest.param("tilted", marks=pytest.mark.further), "scanner", pytest.param("copier", marks=pytest.mark.further)])
def test_places_of_a_page_are_found(name: str):
    """To a tenth of a mm, and to what the page says of itself."""
    photo = phone() if name == "phone" else photograph(printed(), FINE, (CAMERAS | ASIDE)[name], 4)
    (seen,) = [page()] if name == "phone" else pages(photo.content)
    astray = np.quantile(off(seen, photo), 0.95)
    assert seen.number == 31416
    assert (seen.width, seen.height) == A4
    assert astray < min(0.1, seen.within)
    assert 0 < seen.rms < seen.within < 0.1


def test_lines_beside_dots_do_not_pull_at_them():
    """As those of a grid may, beside every dot of a room."""
    raster = printed(laser=False).copy()
    for k in range(6, 17):
        low, right = round((10 * k + 0.5) * FINE), round((10 * k - 0.6) * FINE)
        raster[low : low + 5, 720:4320] = np.minimum(raster[low : low + 5, 720:4320], 170)
        raster[1440:4080, right - 5 : right] = np.minimum(raster[1440:4080, right - 5 : right], 170)
    photo = photograph(raster, FINE, replace(PHONE, curl=0.5), 8)
    (seen,) = pages(photo.content)
    between = (PLACES.real > 60) & (PLACES.real < 160) & (PLACES.imag > 65) & (PLACES.imag < 165)
    assert np.quantile(off(seen, photo)[between], 0.95) < 0.02


def test_two_sheets_on_one_picture():
    """Side by side, the second one upside down."""
    sheets = [LaidSheet(printed(), FINE, -108, 0.05), LaidSheet(printed(page=2), FINE, 108, np.pi + 0.03)]
    photo = taken(sheets, replace(PHONE, quarters=(0,), tilt=5.0, fill=0.98), 3)
    seen = sorted(found(photo.grey), key=lambda page: page.number)
    assert [page.number for page in seen] == [31416, 31417]
    assert all(np.quantile(off(page, photo, k), 0.95) < 0.1 for k, page in enumerate(seen))


def test_paper_is_told_by_its_markers():
    """Of several kinds that were printed on."""
    (seen,) = found(phone().grey, sizes=((215.9, 279.4), A4, (297.0, 210.0)))
    assert (seen.number, seen.width, seen.height) == (31416, *A4)


def painted(*places: complex) -> np.ndarray:
    """The picture with something laid over some places of its page."""
    grey = phone().grey.copy()
    for at in phone().true[0](np.array(places)):
        cv2.circle(grey, (round(at.real), round(at.imag)), 80, 90, -1)
    return grey


def test_a_corner_may_be_covered():
    (seen,) = found(painted(14 + 14j))
    assert isinstance(seen, RegisteredPage)
    assert np.quantile(off(seen, phone()), 0.95) < min(0.1, seen.within)


@pytest.mark.parametrize("at", [11 + 145.5j, 15 + 151.5j, 201 + 147.5j])
def test_no_number_is_guessed(at: complex):
    """One square of a marker at the edge is of the other colour."""
    grey = phone().grey.copy()
    square = phone().true[0](at + np.array([-0.9 - 0.9j, 0.9 - 0.9j, 0.9 + 0.9j, -0.9 + 0.9j]))
    middle = phone().true[0](np.array([at]))[0]
    other = 30 if grey[round(middle.imag), round(middle.real)] > 128 else 200
    cv2.fillPoly(grey, [np.array([[p.real, p.imag] for p in square]).round().astype(np.int32)], other)
    (error,) = found(grey)
    assert isinstance(error, PhotographAgain)
    assert error.reason == "number"


MIDDLES = [at + 6 + 6j for at in (*corners(*A4), *edges(*A4))]


def cut(grey: np.ndarray) -> np.ndarray:
    """Without the half of the picture where the page's left corners are."""
    at = phone().true[0](np.array([30.0, 180.0]) + 148j)
    middle, low = phone().true[0](np.array([105 + 148j]))[0], at[0] - at[1]
    assert abs(low.imag) > abs(low.real)
    return np.ascontiguousarray(grey[: int(middle.imag)] if low.imag > 0 else grey[int(middle.imag) :])


def washed_out(width: float) -> np.ndarray:
    """With a lamp's reflection in the middle of the page, so many mm wide, in which nothing is seen."""
    grey, (middle, aside) = phone().grey.copy(), phone().true[0](np.array([105 + 150j, 105 + width / 2 + 150j]))
    cv2.circle(grey, (round(middle.real), round(middle.imag)), round(abs(aside - middle)), 255, -1)
    return grey


def test_a_small_reflection_does_no_harm():
    (seen,) = found(washed_out(50))
    assert isinstance(seen, RegisteredPage)
    assert np.quantile(off(seen, phone()), 0.95) < min(0.1, seen.within)


def filtered(grey: np.ndarray) -> np.ndarray:
    """Black and white, as some programs that scan with a phone leave it."""
    return cv2.adaptiveThreshold(cv2.GaussianBlur(grey, (0, 0), 1.0), 255, cv2.ADAPTIVE_THRESH_MEAN_C, cv2.THRESH_BINARY, 401, 70)


REFUSED = {
    "coarse": lambda: (cv2.resize(phone().grey, None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA), "coarse"),
    "corners": lambda: (painted(MIDDLES[0], MIDDLES[2]), "corners"),
    "left": lambda: (painted(MIDDLES[4]), "number"),
    "cut": lambda: (cut(phone().grey), "corners"),
    "black and white": lambda: (filtered(phone().grey), "faint"),
    "washed out": lambda: (washed_out(100), "faint"),
    "crumpled": lambda: (photograph(printed(), FINE, replace(PHONE, wave=9.0), 2).grey, "bent"),
    "blurred": lambda: (cv2.GaussianBlur(phone().grey, (0, 0), 20.0), "none"),
    "desk": lambda: (photograph(np.full((1485, 1050), 250, np.uint8), 5.0, PHONE, 1).grey, "none"),
    "small": lambda: (np.full((1, 1), 250, np.uint8), "none"),
}


@pytest.mark.parametrize("kind", REFUSED)
def test_one_reason_for_what_cannot_be_measured(kind: str):
    grey, reason = REFUSED[kind]()
    (error,) = found(grey)
    assert isinstance(error, PhotographAgain)
    assert error.reason == reason
    assert error.cut == (kind == "cut")
    assert error.marks == {"corners": (0, 2), "cut": (0, 3)}.get(kind, ())
    for lang in ("en", "zh"):
        assert error.message(lang).startswith("a.jpg")


def test_darkness_is_that_of_the_ink():
    """Not of the shadow that falls there."""
    seen = page()
    squares = np.array([at + 0.5 + 0.5j for at in corners(*A4)])  # in the rims of markers
    between = np.array([at + 2.3 + 1.7j for at in dots(*A4) if at.imag > 225 and 30 < at.real < 180])
    px = seen.pixels(between)
    light = phone().grey[px.imag.round().astype(int), px.real.round().astype(int)]
    assert light.max() > 1.1 * light.min()  # or there would be no shadow to be told from ink
    assert seen.darkness(squares).min() > 0.75
    assert np.median(seen.darkness(between)) < 0.05
    assert np.quantile(seen.darkness(between), 0.9) < 0.1
    assert np.isnan(seen.darkness(np.array([-400 + 0j, 900 + 100j]))).all()
    assert seen.darkness(np.zeros((2, 3, 4), complex) + 100).shape == (2, 3, 4)


def test_a_part_of_the_page_set_straight():
    seen = page()
    crop = seen.crop(8 + 8j, 20 + 20j, 4.0)
    assert crop.shape == (48, 48)
    assert crop.dtype == np.uint8
    bits = crop.reshape(6, 8, 6, 8)[:, 2:6, :, 2:6].mean(axis=(1, 3)) > 128
    assert not bits[0].any()
    assert not bits[:, 5].any()
    assert [int("".join(map(str, row.astype(int))), 2) for row in bits[1:5, 1:5]] == [0b1011, 0b0101, 0b0011, 0b0010]
    assert (seen.crop(-500 + 0j, -490 + 10j, 2.0) == 255).all()
