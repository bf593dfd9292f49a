"""What other programs are given: JSON without a number that is none, and the same figures as the values."""

from __future__ import annotations

import json

import pytest

from graphkin.files import library
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.studies.centres import centres
from graphkin.studies.centres.about import about, about_json
from graphkin.studies.centres.centrodes import centrodes, centrodes_json, whole
from graphkin.studies.sweeps import course


@pytest.mark.parametrize("name", library.names())
def test_about_is_plain_json(name: str):
    method = plan(library.load(name))
    found = centres(method, replay_all(method))
    for link in method.mechanism.moving:
        seen = about(found, link)
        data = json.loads(json.dumps(about_json(seen), allow_nan=False))
        assert data["link"] == method.mechanism.called(link)
        assert set(data["points"]) == set(seen.points)
        if isinstance(data["pole"], list):
            assert complex(*data["pole"]) == seen.pole


def test_centrodes_are_plain_json():
    method = plan(library.load("fig3-4"))
    found, way = centres(method, replay_all(method)), course(method)
    curves = centrodes(found, "3", "1", way, whole(way))
    data = json.loads(json.dumps(centrodes_json(curves), allow_nan=False))
    assert data["axes"] == ["1", "3"]
    assert len(data["pieces"]) == 2
    for piece, entry in zip(curves.pieces, data["pieces"], strict=True):
        assert [complex(*place) for place in entry["curves"][0]] == piece.places[0].tolist()
        assert len(entry["drivers"][0]) == piece.t.size
