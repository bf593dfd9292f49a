"""Layers over the playing mechanism lie where the analysis has them."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from shapely.affinity import affine_transform

from graphkin import api
from graphkin.analytic import motion
from graphkin.base.rooms import Room
from graphkin.model.mechanism import FRAME
from graphkin.page.layers import layers
from graphkin.proof.readings import mechanism_at
from graphkin.sheet.window import Window
from graphkin.studies.centres.search import centre_name
from graphkin.studies.sweeps import course

ROOM = Room(0, 0, 120, 100)


class Numbers:
    """Keeps tracks as they come."""

    def place(self, values):
        return np.asarray(values)

    fine = place

    def mask(self, there):
        return None if there.all() else 0


def made(name: str, count: int = 90):
    method = api.plan(api.load(name))
    moved = course(method)
    t = np.arange(count) * (2 * np.pi / count) if moved.full_turn else np.linspace(moved.path.first, moved.path.last, count + 2)[1:-1]
    window = Window(60 + 60j, method.size / 40)
    return method, moved, t, window, layers(moved, t, window, ROOM, Numbers())


def outline(pieces) -> shapely.MultiLineString:
    return shapely.MultiLineString([[tuple(map(float, at.split())) for at in piece[1:].split("L")] for piece in pieces])


@pytest.mark.parametrize("name", ["fig3-4", "ex3-7", "p3-21"])
def test_centres_curves_and_centrodes(name):
    method, moved, t, window, data = made(name)
    centres = {one["name"]: one for one in data["centres"]}
    curves = {one["name"]: outline(one["pieces"]) for one in data["curves"]}
    seen = set()
    for k in range(0, len(t), 11):
        there = motion(mechanism_at(method, moved.path.values(float(t[k]))))
        for one in centres.values():
            if one["frame"]:
                place = complex(one["x"][k], one["y"][k]) / one["w"][k]
                link = next(link for link in method.mechanism.moving if one["name"] == centre_name(method.mechanism, link, FRAME))
                point = next(p for p in method.mechanism.points if link in method.mechanism.owners[p])
                if abs(there.omega[link]) < 1e-6:
                    continue
                right = window(there.position[point] + 1j * there.velocity[point] / there.omega[link])
                if abs(right - ROOM.middle) < 200:
                    assert abs(place - right) < 1e-6 * max(1, abs(right)), (one["name"], k)
                    seen.add("centre")
        for point, line in curves.items():
            at = window(there.position[point])
            assert line.distance(shapely.Point(at.real, at.imag)) < 0.03
            seen.add("curve")
        for one in data["centrodes"]:
            centre = centres[one["name"]]
            at = complex(centre["x"][k], centre["y"][k]) / centre["w"][k]
            if abs(at - ROOM.middle) < 60:
                cos, sin = one["cos"][k], one["sin"][k]
                carried = affine_transform(outline(one["moving"]), (cos, -sin, sin, cos, one["x"][k], one["y"][k]))
                for line in (outline(one["fixed"]), carried):
                    assert line.distance(shapely.Point(at.real, at.imag)) < 0.03
                seen.add("centrode")
    assert seen >= {"centre", "centrode"}
    assert (name == "ex3-7" or "curve" in seen)
