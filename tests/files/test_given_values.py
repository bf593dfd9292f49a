"""A mechanism keeps what its file states; another position of it is the same file with that position as its drawn one."""

from __future__ import annotations

import math
import pickle
import tomllib

import pytest

from graphkin import api
from graphkin.files import library, loads
from graphkin.files.builder import reposed
from graphkin.model.mechanism import FRAME, GivenValue
from graphkin.planning.drawn_position import value_of
from graphkin.running import replay_all

TEXT = """
[frame]
A = [0, "5 cm"]
[links.1]
AB = "2 in"
"BAC\u2032" = 90
"AC\u2032" = 30
ccw = ["A", "B", "C\u2032"]
[[driver]]
vector = "AB"
angle = 60
omega = "95 rpm"
also = [90, "0.5 rev"]
[scales]
length = 0.001
"""


@pytest.mark.parametrize("name", library.names())
def test_all_that_the_file_has_is_there_in_its_order(name: str):
    mechanism = library.load(name)
    document = {path[0]: value.written for path, value in mechanism.given.items() if len(path) == 1}
    assert document == tomllib.loads(mechanism.text)
    assert list(document) == list(tomllib.loads(mechanism.text))
    assert set(mechanism.lines) == set(mechanism.given)


def test_quantities_are_there_in_si():
    given = loads(TEXT).given
    assert given["links", "1", "AB"] == GivenValue(("links", "1", "AB"), "2 in", "length", 0.0508)
    assert given["links", "1", "BAC'"].dimension == "angle"
    assert given["links", "1", "BAC'"].si == math.pi / 2
    assert [given["frame", "A", k].si for k in (0, 1)] == [0.0, 0.05]
    assert given["driver", 0, "omega"].si == pytest.approx(95 * math.pi / 30)
    assert given["driver", 0, "also", 1].si == math.pi
    assert given["driver", 0, "vector"].dimension is None
    assert given["scales", "length"].written == 0.001
    assert dict(pickle.loads(pickle.dumps(given))) == dict(given)


@pytest.mark.parametrize("name", library.names())
def test_another_position_reads_as_its_file(name: str):
    method = api.plan(library.load(name))
    mechanism = method.mechanism
    values = [0.0 if driver.value is None else driver.value for driver in mechanism.drivers]
    plot = replay_all(method)
    poses = [float(value_of(plot, pose)) for pose in mechanism.poses]
    sketch = {p: complex(z) for p, z in plot.position.items()
              if p in mechanism.points and p not in mechanism.links[FRAME].points}
    there = reposed(mechanism, values, poses, sketch)
    read = loads(there.text, name=mechanism.name, file=mechanism.file)
    for part in ("links", "pairs", "drivers", "poses", "sketch", "text", "lines", "given"):
        assert getattr(there, part) == getattr(read, part), part
