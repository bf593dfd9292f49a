"""Linear equations over positions, and what their matrices tell of how near a group is to a dead point.

A `Row` is one linear condition: known + sum of coefficient * unknown = 0, by base link or `slide_key`. A complex row
stands for two.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from operator import attrgetter

import numpy as np

from graphkin.base.geometry import Value

Row = tuple[Value, Mapping[str, Value]]


def two(known: Value, coefficients: Mapping[str, Value]) -> Iterator[Row]:
    """A complex row along x and along y."""
    for along in (attrgetter("real"), attrgetter("imag")):
        yield along(known), {name: along(value) for name, value in coefficients.items()}


def system(rows: Sequence[Row], names: Sequence[str], shape: tuple[int, ...]) -> tuple[np.ndarray, np.ndarray]:
    """Known parts (*shape, m) and coefficients (*shape, m, n) of rows, over positions of a shape."""
    known, matrix = np.zeros((*shape, len(rows))), np.zeros((*shape, len(rows), len(names)))
    for k, (value, coefficients) in enumerate(rows):
        known[..., k] = value
        for j, name in enumerate(names):
            if name in coefficients:
                matrix[..., k, j] = coefficients[name]
    return known, matrix


def solved(matrix: np.ndarray, right: np.ndarray) -> np.ndarray:
    """x (..., n) of matrix (..., m, n) x = right (..., m) for every position; least squares where one is singular."""
    try:
        found: np.ndarray = np.linalg.solve(matrix, right[..., None])[..., 0]
    except np.linalg.LinAlgError:
        return _least_squares(matrix, right)
    return found


def _least_squares(matrix: np.ndarray, right: np.ndarray) -> np.ndarray:
    """The same; NaN where something is not finite."""
    finite = np.isfinite(matrix).all(axis=(-2, -1)) & np.isfinite(right).all(axis=-1)
    matrix = np.where(finite[..., None, None], matrix, np.eye(*matrix.shape[-2:]))
    found = (np.linalg.pinv(matrix) @ right[..., None])[..., 0]
    return np.where(finite[..., None], found, np.nan)


def sense(matrix: np.ndarray) -> Value:
    """The sign of a system's determinant: another assembly close by has the other one."""
    if matrix.shape[-2] != matrix.shape[-1]:
        return 1.0
    return np.linalg.slogdet(_finite(matrix))[0]


def least(matrix: np.ndarray) -> Value:
    """How far a system is from singular: least singular value, columns of length 1. Like the sine of an angle."""
    lengths = np.sqrt((matrix * matrix).sum(axis=-2, keepdims=True))
    lengths[lengths == 0] = 1.0
    return np.linalg.svd(_finite(matrix / lengths), compute_uv=False)[..., -1]


def _finite(matrix: np.ndarray) -> np.ndarray:
    return matrix if np.isfinite(matrix).all() else np.nan_to_num(matrix)
