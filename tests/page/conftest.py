"""A browser for each module of tests, and pages in it that must be silent."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from browsing import Browsing, chromium

from graphkin import api
from graphkin.page import player

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium() as browser:
        yield browser


@pytest.fixture(scope="module")
def windows(browser: Browser) -> dict[str, list[Page]]:
    """The browser's windows that no test holds."""
    return {}


@pytest.fixture
def browsing(browser: Browser, windows: dict[str, list[Page]]) -> Iterator[Browsing]:
    """Opens pages; the test fails if one of them wrote an error or asked for anything."""
    browsing = Browsing(browser, windows)
    yield browsing
    browsing.close()
    assert not browsing.faults


@cache
def _played(name: str) -> player.Data:
    return player.played(api.plan(api.load(name)))


@pytest.fixture(scope="session")
def page_of(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Path]:
    """The page of library mechanisms, made once."""
    folder = tmp_path_factory.mktemp("pages")

    def of(*names: str) -> Path:
        path = folder / f"{'+'.join(names)}.html"
        if not path.is_file():
            path.write_text(player.page_of([_played(name) for name in names], "en"), "utf-8")
        return path

    return of
