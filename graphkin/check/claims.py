"""Claims of a drawing file beside what it shows: every mark that was drawn, every text, the scales, every sign.

A seal tells that the claims are as they were written. It is no lock: whoever changes them can seal them anew. So what
`check` promises does not hang on it: whatever the file shows is right for the mechanism whose text it carries, at the
drivers' values and the scales that it gives, and these scales are printed on it. A drawing that was sealed anew may
show less than graphkin drew, and other signs that show no length (`signs`); where its letters stand is never measured.
An arrow with a gap is as long as it says, with the piece that it says it leaves out.
A tight drawing bears no title. What graphkin draws without a seal (what is given, what moves, what carries no
mechanism) is not judged at all, and `read` says so.
"""

from __future__ import annotations

import contextlib
import math
import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from statistics import median

import numpy as np
import shapely

from graphkin.base.plain import seal
from graphkin.check.drawing import MARKS, DrawingFile, Fault, stated
from graphkin.check.mark_faults import place_of
from graphkin.check.shown import FAINT, HAIR, ShownMark, dashed_away
from graphkin.construction import Plane
from graphkin.model.mechanism import Mechanism

WRITTEN = re.compile(r"(?<![/·])μ\s*([lva])\s*=\s*([0-9.]+(?:\s*[×·]\s*10[−+-]?[0-9]+|[−-][0-9]+)?)")
"""A scale as it is printed on the sheet: μ_v = 0.01 (m/s)/mm; 2×10⁻⁵ and 10⁻⁵ with their exponents raised. What is
divided by one, v/μ_v = 24 mm, is a length."""
Letters = tuple[str, complex]  # a text, and where it begins [mm, y up]
_SAME, _APART = 1.0, 3.0
"""Texts nearer than this stand at one place; farther apart, at two [mm]."""
LETTERS: Mapping[str, Plane] = {"l": "position", "v": "velocity", "a": "acceleration"}


def changed(
    drawing: DrawingFile, read: Sequence[Letters], mechanism: Mechanism, scales: Mapping[Plane, float]
) -> Iterator[Fault]:
    """Faults where the file's claims are not as they were when it was drawn, or the sheet says otherwise.

    read  the texts on it
    """
    texts = [text for text, _ in read]
    if drawing.claims.get("seal") != seal(drawing.claims):
        yield Fault("changed", "")
    yield from _printed(texts, scales)
    titles = [title for text in mechanism.title.values() if (title := " ".join(text.split()))]
    if drawing.title.split() != str(drawing.claims.get("title", "")).split():
        yield Fault("title", drawing.title)
    # a long title is broken into lines; a single letter is none
    begun = (title.startswith(text) and len(text) >= min(len(title), 6) for text in texts for title in titles)
    if titles and drawing.claims.get("tight") is not True and not any(begun):
        yield Fault("title", titles[0])
    claimed_texts = claimed_letters(drawing)
    for text in (Counter(text for text, _ in claimed_texts) - Counter(texts)).elements():
        yield Fault("letters", text)
    # texts that now stand where others stood, and not where they did; the sheet as a whole may have been moved
    now = _places_now(claimed_texts, read)
    shift = _shift(claimed_texts, now)
    for (text, place), at in zip(claimed_texts, now, strict=True):
        astray = abs(at - place - shift) > _APART
        if astray and any(other != text and abs(there + shift - at) < _SAME for other, there in claimed_texts):
            yield Fault("letters", text)
    entries = drawing.claims.get("drawn")
    entries = entries if isinstance(entries, list) else []
    claimed = Counter(tuple(map(str, entry)) for entry in entries if isinstance(entry, list))
    for gone in (claimed - Counter(stated(mark) for kind in MARKS for mark in drawing.of_class(kind))).elements():
        said = dict(part.partition("=")[::2] for part in gone[1:])
        on = next((said[key] for key in ("points", "line", "form") if key in said), "")
        yield Fault("missing", f"{said.get('name') or said.get('link', '') + ': ' + on} ({said.get('plane', '')})")


def _printed(read: Sequence[str], scales: Mapping[Plane, float]) -> Iterator[Fault]:
    """Every scale is printed, and no other."""
    written = [scale for text in read for scale in WRITTEN.findall(text)]
    for letter, plane in LETTERS.items():
        printed = [text for of, text in written if of == letter]
        if plane in scales and not printed:
            yield Fault("unscaled", f"μ_{letter}")
        for text in dict.fromkeys(printed):
            if plane in scales and not _as_written(text, scales[plane]):
                yield Fault("scale", f"μ_{letter} = {text}")


def _as_written(text: str, scale: float) -> bool:
    """Raised letters read like others: `104` may be ten to the fourth."""
    mantissa, *power = re.split(r"\s*[×·]\s*10", text.replace("−", "-"))
    tens = re.fullmatch(r"10(-?[0-9]+)", mantissa)
    for factor, exponent in ((mantissa, power[0] if power else "0"), *([("1", tens[1])] if tens and not power else [])):
        with contextlib.suppress(ValueError, OverflowError):
            if math.isclose(float(factor) * 10.0 ** int(exponent), scale, rel_tol=1e-3):
                return True
    return False


def claimed_letters(drawing: DrawingFile) -> list[Letters]:
    """The letters of a drawing that state a number, with what they state."""
    given = drawing.claims.get("letters")
    found = []
    for entry in given if isinstance(given, list) else ():
        match entry:
            case [str(text), int() | float() as x, int() | float() as y] if text.strip():
                found.append((" ".join(text.split()), complex(x, -y)))
    return found


def _places_now(told: Sequence[Letters], read: Sequence[Letters]) -> list[complex]:
    """The place of each text now; where it stood if it is no longer to be read."""
    return [min((at for other, at in read if other == text), key=lambda p, q=place: abs(p - q), default=place)  # type: ignore[misc]
            for text, place in told]  # fmt: skip


def _shift(claimed: Sequence[Letters], now: Sequence[complex]) -> complex:
    """The shift of the sheet as a whole since it was drawn, by most of its texts [mm]."""
    moved = [at - place for at, (_, place) in zip(now, claimed, strict=True)]
    return complex(median(m.real for m in moved), median(m.imag for m in moved)) if moved else 0j


# --- signs that show no length -----------------------------------------------------------------


_NEAR = 0.05  # a sign is where it was drawn if its ends are no farther off [mm]
_GAP = 2.0  # no line of ink is as thick [mm]
_SHARP = np.cos(np.radians(75))  # a head of an arrow opens less wide

Ends = tuple[complex, complex]


def _signs(drawing: DrawingFile) -> list[ShownMark]:
    """Elements that are painted and held against no length."""
    return [element for element in drawing.sight.shown
            if element.tag != "text" and element.lines and all(element.lines) and not drawing.measures(element)
            and max(element.style.share("stroke"), element.style.share("fill")) > 0]  # fmt: skip


def _altered(drawing: DrawingFile, read: Sequence[Letters]) -> tuple[list[complex], list[ShownMark]]:
    """Places of signs that are gone, and signs that are new; the sheet as a whole may have been moved."""
    stated, drawn = drawing.claims.get("signs"), list[Ends]()  # ends of those that there were when it was written
    for entry in stated if isinstance(stated, list) else ():
        match entry:
            case [int() | float() as x, int() | float() as y, int() | float() as x2, int() | float() as y2]:
                drawn.append((complex(x, -y), complex(x2, -y2)))
            case _:
                pass
    letters, seen = claimed_letters(drawing), _signs(drawing)
    shift = _shift(letters, _places_now(letters, read))
    # the begin of each, and its middle corner or, of a circle, its middle: as the file states them when it is drawn
    ends = [(sign.lines[0][0], sign.middle if sign.tag == "circle" else sign.lines[0][len(sign.lines[0]) // 2])
            for sign in seen]  # fmt: skip
    now = np.array(ends, dtype=complex).reshape(-1, 2)
    then = np.array(drawn, dtype=complex).reshape(-1, 2) + shift
    first, second = (shapely.points(places[:, 0].real, places[:, 0].imag) for places in (now, then))
    pairs = shapely.STRtree(first).query(second, predicate="dwithin", distance=_NEAR).T
    alike = []
    for k, n in pairs:
        style = seen[n].style
        line = style.ink("stroke") > FAINT and seen[n].width > HAIR and not dashed_away(style, False)
        line |= seen[n].width > _GAP  # white under a link that crosses another
        if abs(then[k, 1] - now[n, 1]) <= _NEAR and (line or style.ink("fill") > FAINT):
            alike.append((k, n))
    kept, known = {old for old, _ in alike}, {new for _, new in alike}
    gone = [complex(place) for k, (place, _) in enumerate(then) if k not in kept]
    return gone, [sign for k, sign in enumerate(seen) if k not in known]


def judged(drawing: DrawingFile, read: Sequence[Letters]) -> tuple[list[Fault], list[Fault]]:
    """Faults, of signs that are not where they were drawn and arrows that were added; notes of what no ruler tells."""
    gone, new = _altered(drawing, read)
    more = Counter(text for text, _ in read) - Counter(text for text, _ in claimed_letters(drawing))
    faults = [Fault("signs", _where(gone))] if gone else []
    filled = (sign for sign in new if sign.style.share("fill") > 0)
    faults += [Fault("arrow", place_of(sign)) for sign in filled if any(map(_is_head, sign.lines))]
    notes = (
        ("signs", str(len(_signs(drawing)) - len(new))), ("other", _where([sign.lines[0][0] for sign in new])),
        ("words", str(more.total() or "")), ("blank", drawing.sight.doubt),
    )  # fmt: skip
    return faults, [Fault(*each) for each in notes if each[1]]


def _where(places: Sequence[complex]) -> str:
    """`3: (12.0, 40.5)`: how many there are, and the first of them; nothing for none."""
    return f"{len(places)}: ({places[0].real:.1f}, {-places[0].imag:.1f})" if places else ""


def _is_head(line: Sequence[complex]) -> bool:
    """True if a corner of it is as sharp as the head of an arrow."""
    sides = [after - before for before, after in pairwise(line) if after != before] if 3 < len(line) < 7 else []
    turns = zip(sides, (*sides[1:], *sides[:1]), strict=True)
    return any((-one * other.conjugate()).real > _SHARP * abs(one) * abs(other) for one, other in turns)
