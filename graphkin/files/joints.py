"""Checks that need the whole mechanism: every link is tied to another, and none is tied so that it cannot move."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, islice

from graphkin.errors import CannotMove, LooseLink, NoDriver, OutOfRange, RigidlyJoined, Where
from graphkin.files.draft import MOST_PROBLEMS, Draft
from graphkin.files.positions import Path
from graphkin.model.mechanism import FRAME, Link
from graphkin.model.pairs import Pair

UNEVEN = 1e9
"""No length is so many times another one."""


def check_joints(draft: Draft, pairs: Sequence[Pair], drivers: int) -> None:
    """Note every link that is loose, fixed or joined twice to another."""
    tied = {link for pair in pairs for link in pair.joins}
    tied |= {link for pair in pairs if pair.path is not None for link in draft.owners(pair.path.point)}
    shared = _shared_points(draft)
    tied |= {link for links in shared for link in links}
    for name in draft.links:
        if name not in tied and name != FRAME:
            draft.problems.append(LooseLink(draft.where("links", name), name))
    twice = ((links, points) for links, points in shared.items() if len(points) > 1)
    for (first, second), points in islice(twice, MOST_PROBLEMS):
        where = draft.where("links", second)
        fixed = first == FRAME
        problem = CannotMove(where, second, points) if fixed else RigidlyJoined(where, first, second, points)
        draft.problems.append(problem)
    if not drivers:
        draft.problems.append(NoDriver(Where(draft.file)))


def check_sizes(draft: Draft) -> None:
    """Note what lies so far off, or is so long, that beside it the shortest link has no digit left."""
    arms = {name: _arms(link) for name, link in draft.links.items() if name != FRAME}
    shortest = min((min(lengths) for lengths in arms.values() if lengths), default=0.0)
    if not shortest:
        return
    places: dict[Path, float] = {("links", name): max(lengths, default=0.0) for name, lengths in arms.items()}
    fixed = draft.frame_points.items()
    places |= {draft.starts.get(name, ("frame", name)): abs(place) for name, place in fixed}
    for path, size in places.items():
        if size > UNEVEN * shortest:
            draft.problems.append(OutOfRange(draft.where(*path), f"{size * 1e3:.6g} mm"))


def _arms(link: Link) -> list[float]:
    """Distances of a link's points from its first, those that are not zero [m]."""
    places = list(link.points.values())
    return [distance for place in places[1:] if (distance := abs(place - places[0])) > 0]


def check_sketch(draft: Draft, points: list[str]) -> None:
    """Note every sketched point that no link has."""
    for point in points:
        with draft.noting():
            draft.known(point, "sketch", point)


def _shared_points(draft: Draft) -> dict[tuple[str, str], tuple[str, ...]]:
    """The points any two links have in common."""
    owners: dict[str, list[str]] = {}
    for name, link in draft.links.items():
        for point in link.points:
            owners.setdefault(point, []).append(name)
    shared: dict[tuple[str, str], tuple[str, ...]] = {}
    for point, links in owners.items():
        for first, second in combinations(links, 2):
            shared[first, second] = (*shared.get((first, second), ()), point)
    return shared
