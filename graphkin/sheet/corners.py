"""A figure in a room, and blocks in the corners that it leaves: its equations, its tables, the room of a detail.

A block in a corner has a part of the figure beside it and the rest over or under it, as the outline of the figure goes
down to that corner in stairs. So each block, like the sides of the room, keeps some place of the figure [SI] off a side
of the room by some millimetres, along each axis. Any two of these from opposite sides leave the figure a length
between them: the finest scale is the one at which all of them hold.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.rooms import Room
from graphkin.base.scales import finest_each
from graphkin.sheet.marks import Place
from graphkin.sheet.window import CLOSE, Extent, Window

_AIR = 6.0  # from a block to the figure beside it, with room for letters [mm]
_LEAST = 5.0  # points in less room than this are no figure [mm]
_EDGE, _RIM, _TIGHT = 3.0, 2.0, 1.5  # from a block to the side of its corner, to the other, and to other blocks [mm]
_OTHER_SIDE, _OTHER_END = (0.24, 0.04), 0.1
"""The cost of a block on the right, where it should stand under the heading and where at the foot; or at the end that
it is not meant for."""


class _Choices(NamedTuple):
    """Places of one block in all corners, in all its shapes (o,).

    corner  on each axis 0, left or above, or 1, right or below (2, o)
    off, part  the place of the figure that it keeps off that side, on each axis [SI], and how far [mm] (2, o)
    size    width and height with the distance to what is beside it (2, o) [mm]
    shape, cost  its number; the cost of a corner that is not liked as well as others (o,)
    """

    corner: Array
    off: Array
    part: Array
    size: Array
    shape: Array
    cost: Array


def _edges(extent: Extent) -> Array:
    """As the sides of a room keep a figure off them: axis, side, how far [mm] and which place [SI] (2, 2, 2)."""
    ends = ((extent.left, extent.right), (extent.top, extent.bottom))
    size = (extent.size.real, extent.size.imag)
    return np.array([[[first, 0.0], [last, whole]] for (first, last), whole in zip(ends, size, strict=True)])


def _choices(extent: Extent, sizes: Sequence[complex], foot: bool) -> _Choices:
    """All of a block; foot: it is meant to stand at the foot of the room."""
    edges, own = _edges(extent), np.array([(size.real + _EDGE, size.imag + _EDGE) for size in sizes])
    every = np.array([(*corner, shape, *step) for corner, steps in extent.stairs
                      for shape in range(len(sizes)) for step in dict.fromkeys(steps)]).T  # fmt: skip
    corner, shape, stairs = every[:2].astype(np.intp), every[2].astype(np.intp), every[3:]
    size, first = own[shape].T, edges[[[0], [1]], corner]  # where nothing of the figure is beside it
    off = size + np.where(stairs == 0, first[..., 0], _AIR)
    there = np.isfinite(stairs)
    part = edges[:, 1, 1][:, None] * abs(corner - np.where(there, stairs, 0.0))
    off, part = np.where(there, off, first[..., 0]), np.where(there, part, first[..., 1])
    return _Choices(corner, off, part, size, shape, _OTHER_SIDE[foot] * corner[0] + _OTHER_END * (corner[1] != foot))


def _need(choices: _Choices, keeps: Sequence[Array], room: Array) -> Array:
    """The scales at which the figure fits between a block's places and all that keeps it off the other sides (o, n)."""
    need = np.zeros((choices.off.shape[1], room.shape[1]))
    for old, axis in product(keeps, (0, 1)):
        side = choices.corner[axis]
        free = (room[axis] - old[axis, ::-1, 0]).take(side, axis=0) - choices.off[axis][:, None]
        part = (old[axis, ::-1, 1].take(side, axis=0) - choices.part[axis][:, None]) * (1 - 2 * side)[:, None]
        np.maximum(need, np.where(free > _LEAST, part / np.maximum(free, _LEAST), np.inf), out=need)
    return need


class Standing(NamedTuple):
    """A figure and its blocks in each of many rooms (n,); scales: NaN where it does not fit; keeps: of the sides and of
    each block (2, 2, 2, n); blocks: size and side of each (2, n), and the number of its shape (n,)."""

    scales: Array
    keeps: list[Array]
    blocks: list[tuple[Array, Array, Array]]

    def window(self, extent: Extent, room: Room, times: float) -> Window:
        """Of the first room: in the middle of what the sides and the blocks leave."""
        scale = float(self.scales[0])
        low = np.max([each[:, 0, 0, 0] - each[:, 0, 1, 0] / scale for each in self.keeps], axis=0)
        size = np.array([room.size.real, room.size.imag])
        high = np.min([size - each[:, 1, 0, 0] - each[:, 1, 1, 0] / scale for each in self.keeps], axis=0)
        x, y = (low + high) / 2
        return extent.at(complex(room.left + x, room.top + y), scale, times)

    def corners(self, room: Room) -> list[tuple[int, Place]]:
        """Of the first room: the number of each block's shape, and its upper left corner."""
        first = ((*map(float, size[:, 0]), *side[:, 0], int(shape[0])) for size, side, shape in self.blocks)
        return [(shape, complex(room.right - wide if x else room.left + _EDGE, room.bottom - high if y else room.top))
                for wide, high, x, y, shape in first]  # fmt: skip


def standing(rooms: Array, extent: Extent) -> Standing:
    """The finest scales at which a figure and its blocks stand in many rooms: left, top, right, bottom (4, n)."""
    room = rooms[2:] - rooms[:2]
    edges = np.broadcast_to(_edges(extent)[..., None], (2, 2, 2, room.shape[1]))
    free = room - edges[:, 0, 0] - edges[:, 1, 0]
    least = np.where(free > _LEAST, edges[:, 1, 1] / np.maximum(free, _LEAST), np.inf).max(axis=0)
    keeps, blocks = [edges], list[tuple[Array, Array, Array]]()
    for sizes, foot in extent.blocks:
        choices = _choices(extent, sizes, foot)
        need = _fitting(choices, _need(choices, keeps, room), blocks, room)
        price = ((1 + choices.cost)[:, None] * (np.maximum(need, least) + 0.05 * need)).astype(np.float32)
        best = np.argmin(price, axis=0)  # rounding decides nothing
        least = np.maximum(least, need[best, np.arange(room.shape[1])])
        corner, off, part, size = (each[:, best] for each in choices[:4])
        held = corner[:, None, None] == np.array([[[0]], [[1]]])  # which side, on each axis
        keeps.append(np.where(held, np.stack([off, part], axis=1)[:, None], edges))
        blocks.append((size, corner, choices.shape[best]))
    fit = np.isfinite(least)
    if extent.given is None:
        scales = np.where(fit, finest_each(np.where(fit, np.maximum(least, extent.least), 1.0)), np.nan)
    else:
        scales = np.where(fit & (least <= extent.given * CLOSE), extent.given, np.nan)
    return Standing(scales, keeps, blocks)


def _fitting(choices: _Choices, need: Array, blocks: Sequence[tuple[Array, Array, Array]], room: Array) -> Array:
    """Infinite where a block is too large for its room beside those that stand there already."""
    size, wide = choices.size[..., None], np.array([[[1.0]], [[0.0]]])  # the top is the heading's foot
    fits = (size + _RIM * wide <= room[:, None]).all(axis=0)
    for other, corner, _ in blocks:
        aside = corner[:, None] != choices.corner[..., None]
        fits &= (aside & (size + other[:, None] + _TIGHT * wide <= room[:, None])).any(axis=0)
    return np.where(fits, need, np.inf)
