"""The arrows of a polygon, by the names of its points: those of its equations, and absolute motions."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from graphkin.base.value import frozen
from graphkin.construction import LETTER, Construction, Given, Site, Size
from graphkin.model.mechanism import Mechanism


@frozen
class Arrow:
    """An arrow between two points of a polygon; part, size: as in `Term`; sites: of the motion, and seen from which;
    of_equation: whether it is a term of the construction's, else an absolute motion that none of them is."""

    name: str
    tail: str
    head: str
    sites: tuple[Site, ...]
    part: str = ""
    size: Size | None = None
    of_equation: bool = True


def arrows(mechanism: Mechanism, construction: Construction, there: Collection[str]) -> Iterator[Arrow]:
    """The arrows of the equations, then the absolute motions that are not among them; between points that are there."""
    terms, pole = construction.vectors(), construction.pole
    sites = {node.of: node.site for node in construction.nodes.values() if node.site is not None}
    for name, term in terms.items():
        if term.tail in there and term.head in there:
            of = term.sites or tuple(sites[text] for text in (term.of, term.seen_from) if text in sites)
            yield Arrow(name, term.tail, term.head, of, term.part, term.size)
    besides = {term.head for term in terms.values() if term.tail == pole}  # and the points that never move
    given = (step for step in construction.steps if isinstance(step, Given))
    besides |= {name for step in given for name in (step.point, *step.also)}
    for name, node in construction.nodes.items() if pole in there else ():
        site = node.site if name in there and name not in besides else None
        if site is not None and site.point not in mechanism.unnamed:
            yield Arrow(f"{LETTER[construction.plane]}_{node.of}", pole, name, (site,), of_equation=False)
