"""Which links of a mechanism make a loop of four: the frame and three others, joined by four lower pairs.

A pin in a slot counts as a block of its own between the pin and the slot's link.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import combinations, product

from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.pairs import Slide


@frozen
class LoopPair:
    """Two links joined at a point (a hinge), or by a slide."""

    links: tuple[str, str]
    point: str = ""
    slide: Slide | None = None


@frozen
class LinkLoop:
    """Four links round about, the frame first; pair k joins link k and link k + 1."""

    links: tuple[str, str, str, str]
    pairs: tuple[LoopPair, ...]

    @property
    def slide(self) -> Slide | None:
        return next((pair.slide for pair in self.pairs if pair.slide is not None), None)


def pin_block(slide: Slide) -> str:
    """The name of the block that a pin in a slot stands for; no link of a file can have it."""
    return f"{slide.name}:pin"


def loops(mechanism: Mechanism) -> Iterator[LinkLoop]:
    """Every loop of the frame and three other links with four hinges, or with three and a slide."""
    table = _table(mechanism)
    others = sorted({link for links in table for link in links if link != FRAME}, key=_order(mechanism))
    beside = [link for link in others if _key(FRAME, link) in table]
    for first, last in combinations(beside, 2):
        for middle in others:
            if middle in (first, last):
                continue
            links = (FRAME, first, middle, last)
            steps = [_key(links[k], links[(k + 1) % 4]) for k in range(4)]
            if all(step in table for step in steps):
                yield from _closed(links, [table[step] for step in steps])


def _closed(links: tuple[str, str, str, str], choices: list[list[LoopPair]]) -> Iterator[LinkLoop]:
    for pairs in product(*choices):
        slides, points = [p for p in pairs if p.slide is not None], [p.point for p in pairs if p.slide is None]
        if len(slides) <= 1 and len(set(points)) == len(points):
            yield LinkLoop(links, pairs)


def _order(mechanism: Mechanism) -> Callable[[str], int]:
    places = {link: k for k, link in enumerate(mechanism.links)}
    places |= {pin_block(slide): len(places) + k for k, slide in enumerate(mechanism.slides)}
    return places.__getitem__


def _key(one: str, other: str) -> tuple[str, str]:
    return (one, other) if one < other else (other, one)


def _table(mechanism: Mechanism) -> dict[tuple[str, str], list[LoopPair]]:
    """The pairs between each two links."""
    found: dict[tuple[str, str], list[LoopPair]] = {}

    def joined(one: str, other: str, point: str = "", slide: Slide | None = None) -> None:
        key = _key(one, other)
        if one != other:
            found.setdefault(key, []).append(LoopPair(key, point, slide))

    for hinge in mechanism.hinges:
        for one, other in combinations(hinge.links, 2):
            joined(one, other, hinge.point)
    for slide in mechanism.slides:
        block = slide.block or pin_block(slide)
        joined(slide.guide, block, slide=slide)
        for link in mechanism.owners[slide.point] if slide.block is None else ():
            joined(link, block, slide.point)
    return found
