"""What a template can do is found once for all tests that draw problems from the same text."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator

import pytest

from graphkin.homework.grading.keys import Pencils
from graphkin.homework.problems import Template, draws

Found = dict[tuple[object, ...], draws._Goal]


@pytest.fixture(scope="session")
def known() -> Found:
    return {}


FEW = 8
"""So many problems show what a template can do, where this is not what a test asks."""


@pytest.fixture(autouse=True, scope="module")
def _once(known: Found, request: pytest.FixtureRequest) -> Iterator[None]:
    """By all that it hangs on: the text, the seed, the pencil, how many problems are tried."""
    many = "GRAPHKIN_RANDOM" in os.environ or request.module.__name__ == "test_telling"
    of: Callable[[Template, str, Pencils], draws._Goal] = draws._Goal.of

    def kept(template: Template, seed: str, pencils: Pencils) -> draws._Goal:
        place = template.pieces, template.ranges, seed, pencils, draws._SAMPLE, draws._SAMPLE_TRIES, draws._HOPELESS
        if place not in known:
            known[place] = of(template, seed, pencils)
        return known[place]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(draws._Goal, "of", kept)
        patch.setattr(draws, "_SAMPLE", draws._SAMPLE if many else FEW)
        yield
