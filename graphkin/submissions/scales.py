"""Paper scales as students state them: `0.01`, `0.01 (m/s)/mm`, `1 mm = 0.01 m/s`, `100 mm : 1 m/s`."""

from __future__ import annotations

import re
from collections.abc import Mapping

from graphkin.construction import Plane
from graphkin.errors import NOWHERE, GraphkinError, NotAnAnswer, OutOfRange
from graphkin.files.values import read_quantity
from graphkin.model.mechanism import Dimension, Mechanism
from graphkin.submissions.numbers import unit_named, written
from graphkin.submissions.spelling import plain

PAPER: Mapping[str, float] = {"mm": 1.0, "cm": 10.0, "in": 25.4}
"""Units of lengths on paper in mm: such a length is taken for a velocity or an acceleration by its scale."""
_DIMENSIONS: Mapping[Plane, Dimension] = {"position": "length", "velocity": "velocity", "acceleration": "acceleration"}
_KEYS: Mapping[Plane, str] = {"position": "length", "velocity": "velocity", "acceleration": "acceleration"}
_SI: Mapping[str, Plane] = {"m/s": "velocity", "m/s^2": "acceleration"}
_NAMES: Mapping[str, Plane] = {
    "l": "position", "s": "position", "length": "position", "position": "position", "长度": "position",
    "v": "velocity", "velocity": "velocity", "速度": "velocity",
    "a": "acceleration", "acceleration": "acceleration", "加速度": "acceleration",
}  # fmt: skip
_KEY = re.compile(
    r"(?:scales?\.|(?:mu|[μµ]|k|scale)[ _]*)(?:of )?(l|s|v|a|length|position|velocity|acceleration)"
    r"|(?:(length|velocity|acceleration)[ _]*scale|(长度|速度|加速度)比例尺)"
)
_SMALLEST, _LARGEST = 1e-9, 1e9


def plane_named(text: str) -> Plane | None:
    """The plane whose scale a name is: `mu_v`, `μa`, `scales.velocity`, `velocity scale`, `速度比例尺`."""
    found = _KEY.fullmatch(re.sub(r"[{}\\$]", "", plain(text[:60])).strip().lower())
    return _NAMES[next(name for name in found.groups() if name)] if found is not None else None


def plane_of(si: str) -> Plane | None:
    """The polygon in which a quantity of this unit is drawn."""
    return _SI.get(si)


def stated_by(mechanism: Mechanism) -> dict[Plane, float]:
    """The scales that the problem tells to take."""
    return {plane: mechanism.scales[key] for plane, key in _KEYS.items() if key in mechanism.scales}


def scale(raw: object, plane: Plane) -> float:
    """SI units per mm on paper. Raises NotAnAnswer, OutOfRange, OtherDimension with `NOWHERE`."""
    if isinstance(raw, bool) or not isinstance(raw, int | float | str):
        raise NotAnAnswer(NOWHERE, str(raw)[:40])
    shown = str(raw)[:200] if isinstance(raw, str) or abs(raw) < 1e30 else "1e30"
    value = _scale(plain(shown), plane)
    if not _SMALLEST <= value <= _LARGEST:
        raise OutOfRange(NOWHERE, shown[:40])
    return value


def _scale(text: str, plane: Plane) -> float:
    dimension = _DIMENSIONS[plane]
    one, sign, other = text.partition("=") if "=" in text else text.partition(":")
    if sign:
        for paper, thing in ((one, other), (other, one)):
            try:
                return _quantity(thing, dimension) / (_quantity(paper, "length") * 1000)
            except (GraphkinError, ZeroDivisionError):
                continue
    number = written(re.sub(r"/\((s(?:\^2)?)\*mm\)", r"/\1/mm", text.replace(" ", "")), text)
    unit = re.sub(r"(?:/|\*? ?per|\*) ?mm(?:\^-1)?$", "", number.unit.replace("*mm^-1", "/mm")).strip("() ")
    return _quantity(f"{number.number!r} {unit}", dimension) if unit else number.number


def _quantity(text: str, dimension: Dimension) -> float:
    found = written(text.strip(), text)
    return read_quantity(f"{found.number!r} {unit_named(found.unit)}", dimension)
