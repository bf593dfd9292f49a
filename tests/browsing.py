"""Pages opened in a real Chromium, which is silent: it writes no error and asks for nothing."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from playwright.sync_api import Browser, ConsoleMessage, Page, Request

Listener = Callable[[Any], None]
NAMES = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")
_QUIET = ("--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
          "--disable-component-update", "--disable-sync", "--hide-scrollbars")  # fmt: skip
_MODULES = Path(__file__).parent / "page" / "node_modules"
_GRAVE = ("serious", "critical")


def missing(what: str) -> None:
    """Skips the test that needs it; where CI is set it fails instead."""
    assert not os.environ.get("CI"), f"{what} must be there"
    pytest.skip(f"{what} is not installed")


@contextmanager
def chromium() -> Iterator[Browser]:
    """The browser of this machine. While it runs, no other loop of asyncio can in this thread."""
    executable = next(filter(None, map(shutil.which, NAMES)), None)
    if executable is None:
        missing("Chromium")
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        missing("playwright")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=executable, headless=True, args=_QUIET)
        yield browser
        browser.close()


@dataclass
class Browsing:
    """Opens pages, and keeps what they do wrong in `faults`; `windows`: free ones of each kind, which are taken again."""

    browser: Browser
    windows: dict[str, list[Page]] = field(default_factory=dict)
    faults: list[str] = field(default_factory=list)
    opened: list[tuple[str, Page, dict[str, Listener]]] = field(default_factory=list)

    def open(self, path: Path, fragment: str = "", **context: object) -> Page:
        """A page in a window of its own: `viewport={"width": .., "height": ..}`, `has_touch`, `reduced_motion`, `locale`.."""
        kind, own = repr(sorted(context.items())), path.resolve().as_uri()
        free = self.windows.setdefault(kind, [])
        page = free.pop() if free else self.browser.new_context(**context).new_page()
        listeners: dict[str, Listener] = {
            "pageerror": lambda error: self.faults.append(f"error: {error}"),
            "console": self._hear, "request": lambda request: self._ask(request, own),
        }  # fmt: skip
        for event, listener in listeners.items():
            page.on(event, listener)
        self.opened.append((kind, page, listeners))
        page.goto(own + fragment)
        return page

    def _hear(self, message: ConsoleMessage) -> None:
        if message.type in ("error", "warning"):
            self.faults.append(f"{message.type}: {message.text}")

    def _ask(self, request: Request, own: str) -> None:
        if request.url.split("#")[0] != own and not request.url.startswith(("data:", "blob:")):
            self.faults.append(f"request: {request.url}")

    def close(self) -> None:
        """Each window is free again, and as it was: nothing kept, the pointer in its corner, on the screen."""
        for kind, page, listeners in self.opened:
            page.evaluate("localStorage.clear()")
            page.mouse.move(0, 0)
            page.emulate_media(media="null")
            for event, listener in listeners.items():
                page.remove_listener(event, listener)
            page.goto("about:blank")
            self.windows[kind].append(page)
        self.opened.clear()


def axe(page: Page) -> list[str]:
    """Grave faults that axe-core finds on a page as it stands now: the rule, what it says, and the first element."""
    script = _MODULES / "axe-core" / "axe.min.js"
    if not script.is_file():
        missing("axe-core (npm install in tests/page)")
    page.evaluate(script.read_text("utf-8"))
    violations = page.evaluate("axe.run(document, {resultTypes: ['violations']}).then(found => found.violations)")
    return [f"{each['id']}: {each['help']}: {each['nodes'][0]['html'][:200]}" for each in violations if each["impact"] in _GRAVE]
