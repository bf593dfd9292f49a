"""From places of a page to pixels: a homography after a smooth shift of the page's places."""

from __future__ import annotations

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.value import bulky

_KNOTS, _TABLE = 20.0, 2.0  # from one to the next of the smooth shift, and of its table [mm]
_SMOOTH = 10.0 ** np.arange(-3.0, 4.0)  # stiffness that is tried
_ROUNDS, _APART = 5, 3.0  # in which values lose weight that stand apart, by so many times what half of them are off
_LEAST = 1e-9  # stiffness where no value tells


@bulky
class Homography:
    """Plane to plane: `matrix` (3, 3)."""

    matrix: Array

    @staticmethod
    def of(places: Array, px: Array) -> Homography:
        """The one that fits best."""
        import cv2

        matrix, _ = cv2.findHomography(np.stack([places.real, places.imag], 1), np.stack([px.real, px.imag], 1))
        return Homography(np.full((3, 3), np.nan) if matrix is None else np.asarray(matrix))

    def __call__(self, places: Array) -> Array:
        across, down, far = np.tensordot(self.matrix, np.stack([places.real, places.imag, np.ones(places.shape)]), 1)
        return np.asarray((across + 1j * down) / far)

    def per_mm(self, width: float, height: float) -> float:
        """Pixels a mm, by the area of the page."""
        a, b, c, d = self(np.array([0, width, complex(width, height), 1j * height]))
        area = abs(((c - a).conjugate() * (d - b)).imag) / 2
        return float(np.sqrt(area / (width * height)))


@bulky
class PageMap:
    """`rough` after a shift of places, which is straight from one to the next of those it is told at: `table` (ny, nx),
    `_TABLE` apart [mm]."""

    rough: Homography
    table: Array

    def __call__(self, places: Array) -> Array:
        z = np.asarray(places, dtype=complex)
        return self.rough(z + sampled(self.table.real, z / _TABLE) + 1j * sampled(self.table.imag, z / _TABLE))

    def around(self, places: Array, beside: Array) -> Array:
        """Places beside each place, as many as there are of each: (.., places.size, beside.size)."""
        right, down = self(places + 0.5) - self(places - 0.5), self(places + 0.5j) - self(places - 0.5j)
        return np.asarray(self(places)[:, None] + right[:, None] * beside.real + down[:, None] * beside.imag)


def sampled(values: Array, px: Array) -> Array:
    """Values of an array (high, wide) at x + iy: straight from one to the next, beyond its rim as at the rim."""
    import cv2

    filled = np.resize(px, (np.size(px) // 4096 + 1, 4096))  # a picture is broad and high, at most 32767
    x, y = (part.astype(np.float32) for part in (filled.real, filled.imag))
    source = values if values.dtype == np.uint8 else np.ascontiguousarray(values, dtype=np.float32)
    found = cv2.remap(source, x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    return np.asarray(found, dtype=float).ravel()[: np.size(px)].reshape(np.shape(px))


def _splines(x: Array, count: int) -> Array:
    """The cubic splines on knots `_KNOTS` apart at some places: (x.size, count)."""
    at = np.asarray(x) / _KNOTS
    first = np.clip(np.floor(at).astype(int), 0, count - 4)
    t = np.clip(at - first, -0.5, 1.5)
    s = 1 - t
    values = np.zeros((at.size, count))
    for k, part in enumerate((s**3, 4 - 6 * t**2 + 3 * t**3, 4 - 6 * s**2 + 3 * s**3, t**3)):
        values[np.arange(at.size), first + k] = part / 6
    return values


def _modes(pull: Array, stiff: Array) -> tuple[Array, Array]:
    """Shapes of a field in which all stiffnesses that are tried are solved alike: as columns, and the part of each that
    is stiffness and not pull."""
    lower = np.linalg.cholesky(pull + stiff + _LEAST * np.eye(pull.shape[0]))
    part, modes = np.linalg.eigh(np.linalg.solve(lower, np.linalg.solve(lower, stiff).T))
    return np.linalg.solve(lower.T, modes), part


def smoothed(places: Array, values: Array, size: tuple[float, float]) -> tuple[Array, Array, Array]:
    """A smooth field near scattered values, as smooth as leaves the least to a value that is not looked at; values that
    stand apart from the others count little. The field's table, `_TABLE` apart (ny, nx); how far each value is from
    what the others tell of it; what each counts for, from 0 to 1."""
    counts = [int(np.ceil(n / _KNOTS)) + 3 for n in size]
    along = [_splines(part, n) for part, n in zip((places.real, places.imag), counts)]
    basis = np.einsum("pi,pj->pij", *along).reshape(places.size, -1)
    bends = [np.diff(np.eye(n), 2, axis=0) for n in counts]
    stiff = np.kron(bends[0].T @ bends[0], np.eye(counts[1])) + np.kron(np.eye(counts[0]), bends[1].T @ bends[1])
    weights = np.ones(places.size)
    for _ in range(_ROUNDS):
        modes, stiffness = _modes((basis.T * weights) @ basis, stiff)
        shown = basis @ modes
        pull, fits = shown.T @ (weights * values), []
        for smooth in _SMOOTH:
            give = 1 / (1 + (smooth - 1) * stiffness)
            own = weights * (shown**2 @ give)  # what of its own value each has in what the field is there
            shift = modes @ (give * pull)
            fits.append((shift, (values - shown @ (give * pull)) / np.maximum(1 - own, 0.05)))
        shift, off = min(fits, key=lambda fit: np.sum(weights * np.abs(fit[1]) ** 2))
        weights = 1 / (1 + (np.abs(off) / (_APART * max(float(np.median(np.abs(off))), 1e-4))) ** 2) ** 2
    x, y = (_splines(np.arange(0.0, n + _TABLE, _TABLE), count) for n, count in zip(size, counts))
    return (x @ shift.reshape(counts) @ y.T).T, np.abs(off), weights
