"""What waits is looked at in order, and again only when it is called."""

from __future__ import annotations

from graphkin.base.worklist import Waiting


def test_the_first_that_gives_anything_stays_first():
    waiting, given = Waiting(6), {4, 5}
    look = lambda number: number if number in given else None  # noqa: E731
    assert waiting.first(look) == waiting.first(look) == 4
    given |= {1, 2}
    assert waiting.first(look) == 4  # nobody called the others
    waiting.call([2, 5])
    assert waiting.first(look) == 2
