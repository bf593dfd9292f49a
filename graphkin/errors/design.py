"""Errors about the design of linkages: wanted values that make no sense, and wishes that no linkage meets."""

from __future__ import annotations

from graphkin.errors.base import GraphkinError, Lang

__all__ = ["CouplerChanges", "NoDesign", "NotOnBisector", "OneCondition", "SameWanted", "WantedRange", "WrongNumber"]


class WantedRange(GraphkinError):
    """A wanted value that no linkage of the kind can have."""

    name: str
    given: str
    low: str
    high: str
    en = "{name} = {given} cannot be: it must lie between {low} and {high}. Give a value within."
    zh = "{name} = {given} 不可能：必须在 {low} 与 {high} 之间。请改用其中的值。"


class OneCondition(GraphkinError):
    """More (or fewer) conditions than the design leaves free."""

    given: str
    possible: str
    wanted: str
    en = "Given: {given}. Give {wanted} of {possible}."
    zh = "已给：{given}。在 {possible} 中请给 {wanted} 个。"

    def _words(self, lang: Lang) -> dict[str, object]:
        nothing = "nothing" if lang == "en" else "无"
        return {**self._data(), "given": self.given or nothing}


class WrongNumber(GraphkinError):
    """Too few or too many positions, or pairs of angles."""

    count: int
    wanted: str
    en = "{count} given, where {wanted} are wanted."
    zh = "给了 {count} 个，应为 {wanted} 个。"


class SameWanted(GraphkinError):
    """Two positions, or two pairs, that are one."""

    first: str
    second: str
    en = "{first} and {second} are the same. Give positions that differ."
    zh = "{first} 与 {second} 重合。请给出互不相同的位置。"


class CouplerChanges(GraphkinError):
    """Positions of the moving hinges that are not those of one rigid coupler."""

    first: str
    first_mm: float
    other: str
    other_mm: float
    en = (
        "{first} = {first_mm:.8g} mm but {other} = {other_mm:.8g} mm: the coupler keeps its length. Correct a position, "
        "or give B and the coupler's direction instead of C."
    )
    zh = "{first} = {first_mm:.8g} mm，而 {other} = {other_mm:.8g} mm：连杆长度不变。请改正其中一个位置，或以 B 点和连杆方向代替 C 点。"


class NotOnBisector(GraphkinError):
    """A fixed pivot given where it cannot be."""

    point: str
    off_mm: float
    first: str
    second: str
    x_mm: float
    y_mm: float
    en = (
        "{point} must lie on the perpendicular bisector of {first}{second}; it is {off_mm:.4g} mm off. "
        "The nearest place is ({x_mm:.10g}, {y_mm:.10g})."
    )
    zh = "{point} 必须在 {first}{second} 的中垂线上，现偏离 {off_mm:.4g} mm。最近的点为 ({x_mm:.10g}, {y_mm:.10g})。"


class NoDesign(GraphkinError):
    """No linkage has the wanted properties."""

    reasons: tuple[str, str]  # in English, in Chinese
    en = "No solution. {why}"
    zh = "无解。{why}"

    def _words(self, lang: Lang) -> dict[str, object]:
        return {"why": self.reasons[lang == "zh"]}
