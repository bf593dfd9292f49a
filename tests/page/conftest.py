"""One browser for all tests of this folder, and pages in it that must be silent."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from browsing import Browsing, chromium

from graphkin import api
from graphkin.page import player

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page


_open = ExitStack()  # the browser, from the first test that wants it to the last of this folder
_browsers: list[Browser] = []
_windows: dict[str, list[Page]] = {}  # those that no test holds


@pytest.fixture(scope="module")
def browser() -> Browser:
    if not _browsers:
        _browsers.append(_open.enter_context(chromium()))
    return _browsers[0]


@pytest.hookimpl(trylast=True)
def pytest_runtest_teardown(nextitem: pytest.Item | None) -> None:
    """While the browser runs no other loop of asyncio can: it is closed before a test of another folder."""
    if nextitem is None or Path(__file__).parent not in nextitem.path.parents:
        _open.close()
        _browsers.clear()
        _windows.clear()


@pytest.fixture
def browsing(browser: Browser) -> Iterator[Browsing]:
    """Opens pages; the test fails if one of them wrote an error or asked for anything."""
    browsing = Browsing(browser, _windows)
    yield browsing
    browsing.close()
    assert not browsing.faults


WORDED = "ex3-7"
"""Whose words are read by tests; others are told at few places, which takes half as long to make."""


@cache
def _played(name: str) -> player.Data:
    with pytest.MonkeyPatch.context() as patch:
        if name != WORDED:
            patch.setattr(player, "_TOLD", 12)
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
