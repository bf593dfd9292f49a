"""Which lengths make a linkage: each is one, and the longest is no longer than the others reach."""

from __future__ import annotations

import math
from collections.abc import Mapping

from graphkin.errors import NOWHERE, CannotClose, CannotDriveBy, NotALength, OnlyStretched
from graphkin.studies.linkages.equal import even


def check_links(links: Mapping[str, float]) -> None:
    """Raises NotALength."""
    for name, length in links.items():
        if not (math.isfinite(length) and length > 0):
            raise NotALength(NOWHERE, name, f"{length * 1e3:g}")


def check_offset(offset: float) -> None:
    """Raises NotALength."""
    if not math.isfinite(offset):
        raise NotALength(NOWHERE, "e", f"{offset:g}")


def check_driver(driver: str, known: tuple[str, ...]) -> None:
    """Raises CannotDriveBy."""
    if driver not in known:
        raise CannotDriveBy(NOWHERE, driver, known)


def check_closing(long: str, length: float, others: list[str], rest: float) -> None:
    """Whether the others, of length `rest` together, span the longest. Raises CannotClose, OnlyStretched."""
    gap = even(length - rest, length + rest)
    if gap == 0:
        raise OnlyStretched(NOWHERE, long, " + ".join(others), length * 1e3)
    if gap > 0:
        raise CannotClose(NOWHERE, long, length * 1e3, " + ".join(others), rest * 1e3)
