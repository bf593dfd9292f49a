"""Signs that show no length: whether they are as they were drawn, and what no ruler judges."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import shapely

from graphkin.check.claims import Letters, claimed_letters, shift_of
from graphkin.check.drawing import DrawingFile, Fault
from graphkin.check.heads import place_of
from graphkin.check.shown import ShownMark
from graphkin.check.styles import FAINT, HAIR, dashed_away

_NEAR = 0.05
"""A sign is where it was drawn if its ends are no farther off [mm]."""
_SHARP = np.cos(np.radians(75))
"""A head of an arrow opens less wide."""

Ends = tuple[complex, complex]


def _ends(sign: ShownMark) -> Ends:
    """Where it begins, and its middle corner or, of a circle, its middle: as the file states them when it is drawn."""
    line = sign.lines[0]
    return line[0], sign.middle if sign.tag == "circle" else line[len(line) // 2]


def _signs(drawing: DrawingFile) -> list[ShownMark]:
    """Elements that are painted and held against no length."""
    return [element for element in drawing.sight.shown
            if element.tag != "text" and element.lines and all(element.lines) and not drawing.measures(element)
            and max(element.style.share("stroke"), element.style.share("fill")) > 0]  # fmt: skip


def _can_be_seen(sign: ShownMark) -> bool:
    line = sign.style.ink("stroke") > FAINT and sign.width > HAIR and not dashed_away(sign.style, False)
    return line or sign.style.ink("fill") > FAINT


def _drawn(drawing: DrawingFile) -> list[Ends]:
    """The same, as it was when the file was written."""
    stated = drawing.claims.get("signs")
    found = []
    for entry in stated if isinstance(stated, list) else ():
        match entry:
            case [int() | float() as x, int() | float() as y, int() | float() as x2, int() | float() as y2]:
                found.append((complex(x, -y), complex(x2, -y2)))
            case _:
                pass
    return found


def _altered(drawing: DrawingFile, read: Sequence[Letters]) -> tuple[list[complex], list[ShownMark]]:
    """Places of signs that are gone, and signs that are new; the sheet as a whole may have been moved."""
    shift, seen, drawn = shift_of(drawing, read), _signs(drawing), _drawn(drawing)
    now = np.array([_ends(sign) for sign in seen], dtype=complex).reshape(-1, 2)
    then = np.array(drawn, dtype=complex).reshape(-1, 2) + shift
    first, second = (shapely.points(places[:, 0].real, places[:, 0].imag) for places in (now, then))
    pairs = shapely.STRtree(first).query(second, predicate="dwithin", distance=_NEAR).T
    alike = [(k, n) for k, n in pairs if abs(then[k, 1] - now[n, 1]) <= _NEAR and _can_be_seen(seen[n])]
    kept, known = {old for old, _ in alike}, {new for _, new in alike}
    gone = [complex(place) for k, (place, _) in enumerate(then) if k not in kept]
    return gone, [sign for k, sign in enumerate(seen) if k not in known]


def judged(drawing: DrawingFile, read: Sequence[Letters]) -> tuple[list[Fault], list[Fault]]:
    """Faults, of signs that are not where they were drawn and arrows that were added; notes of what no ruler tells."""
    gone, new = _altered(drawing, read)
    more = Counter(text for text, _ in read) - Counter(text for text, _ in claimed_letters(drawing))
    faults = [Fault("signs", _where(gone))] if gone else []
    faults += [Fault("arrow", place_of(sign)) for sign in new if _has_head(sign)]
    notes = (
        ("signs", str(len(_signs(drawing)) - len(new))), ("other", _where([sign.lines[0][0] for sign in new])),
        ("words", str(more.total() or "")), ("blank", drawing.sight.doubt),
    )  # fmt: skip
    return faults, [Fault(*each) for each in notes if each[1]]


def _where(places: Sequence[complex]) -> str:
    """`3: (12.0, 40.5)`: how many there are, and the first of them; nothing for none."""
    return f"{len(places)}: ({places[0].real:.1f}, {-places[0].imag:.1f})" if places else ""


def _has_head(sign: ShownMark) -> bool:
    """True if a filled corner of it is as sharp as the head of an arrow."""
    return sign.style.share("fill") > 0 and any(_sharp(line) for line in sign.lines if 3 < len(line) < 7)


def _sharp(line: Sequence[complex]) -> bool:
    sides = [after - before for before, after in pairwise(line) if after != before]
    turns = zip(sides, (*sides[1:], sides[0]), strict=True)
    return any((-one * other.conjugate()).real > _SHARP * abs(one) * abs(other) for one, other in turns)
