"""Files are read as far as is allowed: a copier's pile of a whole class is larger than what one student writes."""

from __future__ import annotations

import io
from dataclasses import replace
from zipfile import ZipFile

import pytest

from graphkin.errors import TooMuch, Where
from graphkin.submissions import Limits
from graphkin.submissions.archives import content, read_member

LIMITS = replace(Limits(), bytes=100, pile_bytes=1000)


@pytest.mark.parametrize(("name", "most"), [("a.csv", 100), ("a.svg", 100), ("pile.PDF", 1000), ("page.jpg", 1000)])
def test_a_file_is_read_as_far_as_its_kind_may_be_large(name, most):
    assert len(content(io.BytesIO(b"x" * most), name, Where(name), LIMITS)) == most
    with pytest.raises(TooMuch, match=name):
        content(io.BytesIO(b"x" * (most + 1)), name, Where(name), LIMITS)
    packed = io.BytesIO()
    with ZipFile(packed, "w") as archive:
        archive.writestr(name, b"x" * (most + 1))
    with ZipFile(packed) as archive, pytest.raises(TooMuch):
        read_member(archive, archive.getinfo(name), Where(name), LIMITS)
