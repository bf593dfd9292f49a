"""One number of a mechanism file given another value: the same text with that number replaced, and nothing else."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.base.value import frozen
from graphkin.errors import NoDimension, Where
from graphkin.files.toml import replaced_values
from graphkin.files.values import UNITS, split_points, tidy
from graphkin.model.mechanism import Dimension, GivenValue, KeyPath, Mechanism
from graphkin.model.naming import driver_number

WHERE = Where("--vary")


@frozen
class DimensionPlace:
    """Where a dimension stands: its path in the file, and what it measures; or the number of a driver."""

    path: KeyPath
    kind: Dimension
    driver: int | None = None


def dimension(mechanism: Mechanism, name: str) -> DimensionPlace:
    """What `AB`, `BDE`, `links.2.AB`, `slide.0.angle`, or a driver's name means. Raises NoDimension.

    A length of a link that `AB` names goes before a driver of that name: the angle of AB is swept, not varied.
    """
    name = tidy(name.strip())
    found = [DimensionPlace(each.path, each.dimension) for each in _dimensions(mechanism)
             if each.dimension is not None and _named(each.path, name)]  # fmt: skip
    if len(found) == 1:
        return found[0]
    drivers = [driver.name for driver in mechanism.drivers]
    number = driver_number(mechanism, name)
    if not found and number is not None:
        return DimensionPlace((), "length" if mechanism.drivers[number].kind == "slide" else "angle", number)
    possible = (*_possible(mechanism, ambiguous=bool(found)), *drivers)
    raise NoDimension(WHERE, name, tuple(dict.fromkeys(possible)))


def _named(path: KeyPath, name: str) -> bool:
    """Whether a path is called so: in full, or, a measure of a link, by its last key (`BA` is `AB`)."""
    if ".".join(str(part) for part in path) == name:
        return True
    points = split_points(name)
    if not points or path[:1] != ("links",) or len(path) != 3:
        return False
    return split_points(str(path[2])) in (points, points[::-1])


def _dimensions(mechanism: Mechanism) -> Iterator[GivenValue]:
    """The quantities of the file that are dimensions by themselves: no coordinates, no items of lists."""
    for path, each in mechanism.given.items():
        if each.dimension is not None and isinstance(path[-1], str):
            yield each


def _possible(mechanism: Mechanism, ambiguous: bool) -> Iterator[str]:
    """All measures of links, in full where their last key alone would mean two."""
    for each in _dimensions(mechanism):
        if each.path[0] == "links":
            yield each.name if ambiguous else str(each.path[-1])


def replaced(mechanism: Mechanism, place: DimensionPlace, value: float) -> str:
    """The file's text with another value [SI] at a place, in the units of plain numbers."""
    times, divided = next(iter(UNITS[place.kind].values()))
    return replaced_values(mechanism.text, {place.path: value * (divided / times)})
