"""How well places of a page are found on pictures, camera by camera: python tests/photo/assess_map.py [pictures each] [cameras]

Truth is known from the cameras. For each: rms and 95 % of places [mm], the greatest of all pictures; by how much they are
off by the page's own estimate; in how many pictures 95 % of the places are off by less than it says; seconds of a core for a picture.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Sequence

import numpy as np
from cameras import ASIDE, CAMERAS, Photograph, photograph
from printed_pages import A4, FINE, printed

from graphkin.errors import GraphkinError, Where
from graphkin.photo.pictures import pictures_in
from graphkin.photo.registering import RegisteredPage, registered

PLACES = np.add.outer(np.arange(15.0, A4[0] - 14, 5), 1j * np.arange(15.0, A4[1] - 14, 5)).ravel()
"""All over a page but its rim."""


def pages(content: bytes, name: str = "a.jpg") -> list[RegisteredPage | GraphkinError]:
    return [page for picture in pictures_in(name, content, Where(name)) for page in registered(picture)]


def off(page: RegisteredPage, photo: Photograph, sheet: int = 0) -> np.ndarray:
    """By how much its places are off [mm]."""
    true = photo.true[sheet]
    right, down = true(PLACES + 0.5) - true(PLACES - 0.5), true(PLACES + 0.5j) - true(PLACES - 0.5j)
    return np.abs(page.pixels(PLACES) - true(PLACES)) / np.sqrt(np.abs((right.conj() * down).imag))


def main(count: int, names: Sequence[str]) -> None:
    for name in names:
        rows, refused = [], []
        for seed in range(count):
            photo = photograph(printed(laser=seed % 2 == 0), FINE, (CAMERAS | ASIDE)[name], seed)
            start = time.process_time()
            (page,) = pages(photo.content)
            took = time.process_time() - start
            if isinstance(page, RegisteredPage):
                astray = off(page, photo)
                most = float(np.quantile(astray, 0.95))
                rows.append((np.sqrt(np.mean(astray**2)), most, page.rms, page.within, most < page.within, took))
            else:
                refused.append(f"{seed}: {page}")
        rms, most, told, within, covered, took = np.array(rows).T
        print(f"{name:8} rms {rms.max():.3f}, 95 % {most.max():.3f}; told {told.mean():.3f}, 95 % {within.mean():.3f}, "
              f"covers {covered.sum():.0f} of {len(rows)}; {took.max():.1f} s", *refused, sep="\n", flush=True)  # fmt: skip


if __name__ == "__main__":
    main(int(sys.argv[1]) if sys.argv[1:] else 5, sys.argv[2:] or [*CAMERAS, *ASIDE])
