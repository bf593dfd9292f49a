"""Layers that lie over the playing mechanism: instant centres, curves of points, and centrodes.

Tracks have a number for each knot along the driver. The place of a centre on paper is (x / w, y / w) [mm], where x, y
and w are smooth though it goes through infinity: there w is 0, and nowhere less. A moving centrode lies in its link's
axes, which the page carries along by their origin [mm] and the cosine and sine of their angle on paper.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NotRequired, Protocol, TypedDict

import numpy as np

from graphkin.base.geometry import Array, Value
from graphkin.base.rooms import Room
from graphkin.base.value import frozen
from graphkin.errors import GraphkinError
from graphkin.model.mechanism import FRAME
from graphkin.outputs.typesetting import html_words
from graphkin.running import replay_all
from graphkin.running.path import along
from graphkin.sheet.lettering import point_label
from graphkin.sheet.window import Window
from graphkin.studies.centres import Centres, centres, over
from graphkin.studies.centres.centrodes import Centrodes, centrodes, whole
from graphkin.studies.sweeps import Course

LINKS = 8  # of mechanisms with more links the centres would hide the mechanism: P with the frame alone is shown
_AROUND = 1.5  # curves go on so far outside their room [of its size]
_AT_INFINITY = 1e-6  # the greatest w of a centre that is always there
_FINE = 0.01  # how far a drawn curve may stand off from the true one [mm]
_FLAT = 1e-6  # a curve whose points are nearer to a line, or to a circle about a fixed point, is one [of the size]


class PageTracks(Protocol):
    """Writes numbers (n,), one a knot: places [mm], and others; and flags, None where all are set."""

    def place(self, values: np.ndarray) -> float | list[int]: ...
    def fine(self, values: np.ndarray) -> float | list[int]: ...
    def mask(self, there: np.ndarray) -> int | None: ...


Tracked = float | list[int]  # a number, or the number of a track


class CentreTrack(TypedDict):
    name: str
    x: Tracked
    y: Tracked
    w: Tracked
    frame: bool
    mask: NotRequired[int]


class CurveTrack(TypedDict):
    name: str
    label: str
    pieces: list[str]


class CentrodeTrack(TypedDict):
    link: str
    name: str
    fixed: list[str]
    moving: list[str]
    x: Tracked
    y: Tracked
    cos: Tracked
    sin: Tracked


class MovingLayers(TypedDict):
    centres: list[CentreTrack]
    curves: list[CurveTrack]
    centrodes: list[CentrodeTrack]


def moving(track: CentreTrack | CentrodeTrack) -> dict[str, object]:
    """The data of a layer that move: the rest stands in the drawing."""
    return {key: value for key, value in track.items() if key in ("x", "y", "w", "cos", "sin", "mask")}


def layers(course: Course, t: Array, window: Window, room: Room, tracks: PageTracks) -> MovingLayers:
    """All layers, as data of a page.

    t       of the knots on the course (n,)
    window  of the mechanism on the page, in the room that it has there
    """
    found = centres(course.method, replay_all(course.method))
    every = _Layers(course, found, t, window, room, tracks)
    return {"centres": [*every.centres()], "curves": [*every.curves()], "centrodes": [*every.centrodes()]}


@frozen
class _Layers:
    course: Course
    found: Centres
    t: Array
    window: Window
    room: Room
    tracks: PageTracks

    def _on_paper(self, places: Value) -> Array:
        """Places (n,) [m] on paper [mm, y down]."""
        return np.asarray(self.window.origin + np.conj(np.asarray(places)) / self.window.scale)

    # --- instant centres ----------------------------------------------------------------------

    def centres(self) -> Iterator[CentreTrack]:
        """Those that are somewhere else than at infinity at some knot; of many links those with the frame."""
        board, machine = over(self.found, self.course.path, self.t).board, self.course.method.mechanism
        corner, unit = self.window(board.origin), board.size / self.window.scale
        for links in self.found.pairs:
            name = self.found.name(*links)
            if name not in board.points or (len(machine.links) > LINKS and FRAME not in links):
                continue
            x, y, w = np.broadcast_to(board.points[name].reshape(3, -1), (3, self.t.size))
            x, y = corner.real * w + unit * x, corner.imag * w - unit * y
            size = (x**2 + y**2) / abs(self.room.size) ** 2 + w**2
            there = np.isfinite(size) & (size > 0)
            size = np.where(there, size, np.nan)
            if there.any() and np.nanmax(w**2 / size) > _AT_INFINITY:
                places = [self.tracks.place(side * w / size) for side in (x, y)]
                centre: CentreTrack = {"name": name, "x": places[0], "y": places[1], "frame": FRAME in links,
                                       "w": self.tracks.fine(w**2 / size)}  # fmt: skip
                if (mask := self.tracks.mask(there)) is not None:
                    centre["mask"] = mask
                yield centre

    # --- curves of points ---------------------------------------------------------------------

    def curves(self) -> Iterator[CurveTrack]:
        """The paths of the points that go on no circle about a fixed point and on no line."""
        method = self.course.method
        t = self.t[0] + np.radians(range(361)) if self.course.full_turn else self.t
        plot, owners = along(method, self.course.path, t), method.mechanism.owners
        fixed = [place for point, place in plot.position.items() if FRAME in owners.get(point, ())]
        for point in method.mechanism.points:
            places = np.asarray(np.broadcast_to(plot.position.get(point, np.nan), t.shape))
            if np.isfinite(places).any() and not _plain_curve(places, fixed, method.size):
                yield {"name": point, "label": html_words(point_label(point)), "pieces": self._pieces(places)}

    def _pieces(self, places: Array) -> list[str]:
        """A curve [m] as paths on paper, as far as it comes near the room; it is cut where it does not."""
        paper, reach = self._on_paper(places), self.room.size
        off = paper - self.room.middle
        with np.errstate(invalid="ignore"):
            near = (np.abs(off.real) < _AROUND * reach.real) & (np.abs(off.imag) < _AROUND * reach.imag)
        return [_path(paper[some]) for some in _runs(near)]

    # --- centrodes ----------------------------------------------------------------------------

    def centrodes(self) -> Iterator[CentrodeTrack]:
        """The curves of each link that turns about no fixed point; of many links, of the first ones."""
        machine = self.course.method.mechanism
        for link in machine.moving[:LINKS]:
            try:
                curves = centrodes(self.found, machine.called(link), machine.called(FRAME), self.course,
                                   whole(self.course))  # fmt: skip
            except GraphkinError:  # it never turns
                continue
            if not curves.is_point:
                yield self._rolling(curves, link)

    def _rolling(self, curves: Centrodes, link: str) -> CentrodeTrack:
        fixed, moving = list[str](), list[str]()
        for piece in curves.pieces:
            paper = self._on_paper(piece.places[0])
            near = np.abs(paper - self.room.middle) < _AROUND * abs(self.room.size)
            for some in _runs(near):
                fixed.append(_path(paper[some]))
                moving.append(_path(np.conj(piece.places[-1][some]) / self.window.scale))
        origin, turn = (np.asarray(np.broadcast_to(value, self.t.shape)) for value in curves.standing(link, self.t))
        corner, turn = self._on_paper(origin), np.conj(turn)
        tracks, called = self.tracks, self.course.method.mechanism.called(link)
        return {
            "link": called, "name": curves.name, "fixed": fixed, "moving": moving, "x": tracks.place(corner.real),
            "y": tracks.place(corner.imag), "cos": tracks.fine(turn.real), "sin": tracks.fine(turn.imag),
        }  # fmt: skip


def _runs(good: Array) -> Iterator[slice]:
    """Stretches of two flags or more that are set."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], good.astype(int), [0]])))
    return (slice(int(a), int(b)) for a, b in zip(edges[::2], edges[1::2], strict=True) if b - a > 1)


def _path(paper: Array) -> str:
    """A polyline on paper as an SVG path, with no more corners than it needs."""
    import shapely

    line = shapely.LineString(np.stack([paper.real, paper.imag], axis=-1)).simplify(_FINE)
    return "M" + "L".join(f"{x:.2f} {y:.2f}" for x, y in line.coords)


def _plain_curve(places: Array, fixed: Sequence[Value], size: float) -> bool:
    """True of a line, a circle about a fixed point, and a point that stands."""
    there = places[np.isfinite(places)]
    off = there - there.mean()
    across = np.linalg.svd(np.stack([off.real, off.imag]), compute_uv=False)[1] / np.sqrt(there.size)
    return bool(across < _FLAT * size) or any(np.ptp(np.abs(there - place)) < _FLAT * size for place in fixed)
