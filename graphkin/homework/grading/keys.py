"""Keys: read from a file, or made of a mechanism at the scales of its sheet."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from graphkin import api
from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import BadKey, NoFile, NothingToMark, Unreadable, Where
from graphkin.homework.grading.positions import further_methods
from graphkin.marking.key import Key, Marking
from graphkin.marking.key_making import make_key
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import Quantity
from graphkin.planning import Method
from graphkin.proof.roads import proved

_LARGEST = 64 << 20
KEYS: Mapping[Plane, str] = {"position": "length", "velocity": "velocity", "acceleration": "acceleration"}


@frozen
class Pencils:
    """What a pencil errs by on paper, and what of it is allowed.

    length_mm, angle_deg   standard deviations of a length laid off or read, and of a direction
    sigmas     how many standard deviations are right; relative: a part of the right value instead, where it is not 0
    """

    length_mm: float = 0.25
    angle_deg: float = 0.25
    sigmas: float = 3.0
    relative: float = 0.0


USUAL = Pencils()


def key_from(source: str, pencils: Pencils = USUAL) -> Key:
    """A key.json, or a key made of a mechanism file or a library mechanism.

    Raises what loading and planning raise, BadKey, NothingToMark.
    """
    path = Path(source)
    return key_file(path) if path.suffix.lower() == ".json" else key_for(api.load(source), pencils)


def key_for(
    mechanism: Mechanism, pencils: Pencils = USUAL, quantities: Sequence[Quantity] = (),
    points: Mapping[str, float] | None = None,
) -> Key:  # fmt: skip
    """The key of a mechanism, which both roads must give, with one for each further position that it asks for, at the
    same scales. Raises NothingToMark, NoKeyAtPosition."""
    method = api.plan(mechanism)
    key = key_drawn(method, pencils, quantities, points)
    further = (make_key(there, key.marking, quantities, points) for there in further_methods(method))
    return replace(key, further=tuple(further))


def key_drawn(
    method: Method, pencils: Pencils = USUAL, quantities: Sequence[Quantity] = (),
    points: Mapping[str, float] | None = None,
) -> Key:  # fmt: skip
    """The key of the drawn position alone. Raises NothingToMark."""
    key = make_key(method, marking_of(method, pencils), quantities, points)
    if not any(entry.points for entry in key.entries):
        raise NothingToMark(method.mechanism.where("ask"))
    return key


def marking_of(method: Method, pencils: Pencils = USUAL, scales: Mapping[str, float] | None = None) -> Marking:
    """A pencil's errors at the scales of the mechanism's sheet, or at others."""
    scales = scales or _scales(method)
    lengths: dict[str, float] = {plane: pencils.length_mm * scales[key] for plane, key in KEYS.items()}
    return Marking(lengths, math.radians(pencils.angle_deg), dict(scales), pencils.sigmas, pencils.relative)


def _scales(method: Method) -> dict[str, float]:
    """As the file gives them, else as the sheet is drawn."""
    given, plot = method.mechanism.scales, proved(method).plot
    if all(key in given for key in KEYS.values()):
        return {key: given[key] for key in KEYS.values()}
    from graphkin.sheet import scales_of

    found = scales_of(method, plot, "en")
    return {key: float(found[plane]) for plane, key in KEYS.items()}


def key_file(path: Path) -> Key:
    """The key that a file holds. Raises BadKey, NoFile, Unreadable."""
    from graphkin.outputs.key_json import key_of

    return key_of(text_of(path), Where(str(path)))


def text_of(path: Path) -> str:
    """The text of a key's file."""
    where = Where(str(path))
    if not path.is_file():
        raise NoFile(where, path.name, ())
    try:
        if path.stat().st_size > _LARGEST:
            raise BadKey(where, f"> {_LARGEST >> 20} MB")
        return path.read_text("utf-8-sig")
    except OSError as problem:
        raise Unreadable(where, problem.strerror or str(problem)) from None
    except UnicodeDecodeError as problem:
        raise BadKey(where, problem.reason) from None
