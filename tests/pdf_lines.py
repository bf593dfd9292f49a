"""The straight lines of a PDF's page, measured: a reader of its own, on what pypdf takes apart."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

Matrix = tuple[float, float, float, float, float, float]
_MM = 25.4 / 72
_NOTHING: Matrix = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0)


def lines(reader: Any, page: Any) -> Iterator[tuple[complex, complex]]:
    """Both ends of every line that is drawn, from the left lower corner [mm]; forms within forms, too."""
    from pypdf.generic import ContentStream

    contents = page.get_contents()
    yield from _drawn(reader, ContentStream(contents, reader), page["/Resources"], _NOTHING)


def _drawn(reader: Any, stream: Any, resources: Any, start: Matrix) -> Iterator[tuple[complex, complex]]:
    from pypdf.generic import ContentStream

    matrix, kept, at = start, [], 0j
    for operands, operator in stream.operations:
        match operator:
            case b"q":
                kept.append(matrix)
            case b"Q":
                matrix = kept.pop()
            case b"cm":
                matrix = _times(tuple(map(float, operands)), matrix)  # type: ignore[arg-type]
            case b"m":
                at = _placed(operands, matrix)
            case b"l":
                to = _placed(operands, matrix)
                yield at, to
                at = to
            case b"Do":
                form = resources["/XObject"][operands[0]].get_object()
                if form["/Subtype"] == "/Form":
                    own = tuple(map(float, form.get("/Matrix", _NOTHING)))
                    inner = form.get("/Resources", resources)
                    yield from _drawn(reader, ContentStream(form, reader), inner, _times(own, matrix))  # type: ignore[arg-type]
            case _:
                pass


def _times(first: Matrix, then: Matrix) -> Matrix:
    a, b, c, d, e, f = first
    p, q, r, s, t, u = then
    return a * p + b * r, a * q + b * s, c * p + d * r, c * q + d * s, e * p + f * r + t, e * q + f * s + u


def _placed(operands: Any, matrix: Matrix) -> complex:
    x, y = map(float, operands[:2])
    a, b, c, d, e, f = matrix
    return complex(a * x + c * y + e, b * x + d * y + f) * _MM
