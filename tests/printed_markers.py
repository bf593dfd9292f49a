"""The square markers on a PDF's page, read from what is painted there; the reader knows nothing of how they were made."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

_MM = 25.4 / 72
_CELLS = 6


def markers(reader: Any, page: Any) -> dict[complex, int]:
    """Sixteen bits by the marker's middle, from the left upper corner of the page [mm]: black squares of 12 mm."""
    painted = list(_painted(reader, page))
    found = {}
    for low, high, grey in painted:
        size = high - low
        if grey < 0.1 and abs(size - complex(12, 12)) < 0.01:
            cells = [low + complex(2 * x + 1, 2 * y + 1) for y in range(_CELLS) for x in range(_CELLS)]
            inside = [p for p in painted if p[0].real > low.real - 1 and p[1].real < high.real + 1]
            bits = [_grey(inside, cell) > 0.5 for cell in cells]
            assert not any(bit for k, bit in enumerate(bits) if k // 6 in (0, 5) or k % 6 in (0, 5)), "no black rim"
            inner = [bit for k, bit in enumerate(bits) if 0 < k // 6 < 5 and 0 < k % 6 < 5]
            found[(low + high) / 2] = sum(bit << (15 - k) for k, bit in enumerate(inner))
    return found


def _grey(painted: list[tuple[complex, complex, float]], at: complex) -> float:
    """What was painted last at a place; white paper else."""
    for low, high, grey in reversed(painted):
        if low.real <= at.real <= high.real and low.imag <= at.imag <= high.imag:
            return grey
    return 1.0


def _painted(reader: Any, page: Any) -> Iterator[tuple[complex, complex, float]]:
    """The upright rectangles that are filled, in their order: two corners [mm, y down] and how light they are."""
    from pypdf.generic import ContentStream

    matrix, kept, grey, path, straight = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0), [], 0.0, [], True
    height = float(page.mediabox.height)
    for operands, operator in ContentStream(page.get_contents(), reader).operations:
        match operator:
            case b"q":
                kept.append((matrix, grey))
            case b"Q":
                matrix, grey = kept.pop()
            case b"cm":
                matrix = _times(tuple(map(float, operands)), matrix)
            case b"scn" | b"g" | b"rg":
                grey = sum(map(float, operands)) / len(operands)
            case b"m" | b"l":
                x, y = map(float, operands)
                a, b, c, d, e, f = matrix
                path.append(complex(a * x + c * y + e, height - (b * x + d * y + f)) * _MM)
            case b"c":
                straight = False
            case b"f" | b"B":
                if straight and len(path) >= 4:
                    xs, ys = [p.real for p in path], [p.imag for p in path]
                    yield complex(min(xs), min(ys)), complex(max(xs), max(ys)), grey
                path, straight = [], True
            case b"S" | b"n":
                path, straight = [], True
            case _:
                pass


def _times(first: Any, then: Any) -> Any:
    a, b, c, d, e, f = first
    p, q, r, s, t, u = then
    return a * p + b * r, a * q + b * s, c * p + d * r, c * q + d * s, e * p + f * r + t, e * q + f * s + u
