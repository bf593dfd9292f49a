"""Checks that need the whole mechanism: every link is tied to another, and none is tied so that it cannot move."""

from __future__ import annotations

from itertools import combinations, islice

from graphkin.errors import CannotMove, LooseLink, NoDriver, RigidlyJoined, Where
from graphkin.loading.draft import MOST_PROBLEMS, Draft
from graphkin.mechanism import FRAME
from graphkin.pairs import Cam, Gear, Roll, Slide

__all__ = ["check_joints", "check_sketch"]


def check_joints(draft: Draft, pairs: list[Slide | Gear | Roll | Cam], drivers: int) -> None:
    """Note every link that is loose, fixed or joined twice to another."""
    tied = {link for pair in pairs for link in pair.joins}
    tied |= {link for pair in pairs if isinstance(pair, Slide) for link in draft.owners(pair.point)}
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
