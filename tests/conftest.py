"""What all tests share."""

from __future__ import annotations

import gc
import os
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest
from library_sheets import key_for, loaded

from graphkin.files import library
from graphkin.homework.grading import keys
from graphkin.sheet import mechanism_sheet
from graphkin.sheet.paper import papers_for

DRAWN = ("cli", "sheet")
"""Folders whose tests look at the sheets of the library."""
PART = 3  # of the cases of a test that is marked `many` one of so many runs; of `many(8)` one of eight


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """A law that is held against many mechanisms takes some of them, and a single case that is marked `further` is left
    out; all run with GRAPHKIN_RANDOM in the environment. A test whose cases take turns at something of their own is not
    to be marked `many`: some turns would be nobody's. Tests that look at the same drawings come one after another, so
    that of two processes one makes them."""
    if "GRAPHKIN_RANDOM" in os.environ:
        return
    there = Counter(map(function_of, items))
    seen, taken, left = Counter[str](), list[pytest.Item](), list[pytest.Item]()
    for item in items:
        name, many = function_of(item), item.get_closest_marker("many")
        part = 1 if many is None else min(*many.args, there[name]) if many.args else PART
        is_left = (seen[name] + len(name)) % part > 0 or item.get_closest_marker("further") is not None
        (left if is_left else taken).append(item)
        seen[name] += 1
    items[:] = sorted(taken, key=lambda item: item.path.parent.name not in DRAWN)
    if left:
        config.hook.pytest_deselected(items=left)


def function_of(item: pytest.Item) -> str:
    return item.nodeid.partition("[")[0]


def pytest_collection_finish() -> None:
    """Thousands of collected tests live to the end: looking through them for garbage again and again takes a tenth of the time."""
    gc.collect()
    gc.freeze()
    gc.set_threshold(20_000, 20, 50)


@pytest.fixture(autouse=True)
def _library_once(request: pytest.FixtureRequest) -> Iterator[None]:
    """A process loads each mechanism of the library once: tests and commands that ask for it one after another are answered
    from what is kept of its plan, its motion, its sheet and its key, as a user is who asks again. A test that changes what the
    package does loads its own."""
    if "monkeypatch" in request.fixturenames:
        yield
        return
    own = library.load, keys.key_for
    library.load, keys.key_for = loaded, key_for
    yield
    library.load, keys.key_for = own


@pytest.fixture
def one_paper() -> Iterator[None]:
    """Every sheet is on A3: a solution has the scales of its sheet, and choosing its paper takes longer than all the rest of
    it. For mechanisms of a test's own, as what is kept of one of the library is shown to other tests."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(mechanism_sheet, "papers_for", lambda name: papers_for(name or "A3"))
        yield


@pytest.fixture
def own_folder(tmp_path: Path) -> Iterator[Path]:
    """Commands are given in a folder of the test's own, in English: nothing that the package does is changed."""
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(tmp_path)
        patch.setenv("GRAPHKIN_LANG", "en")
        yield tmp_path
