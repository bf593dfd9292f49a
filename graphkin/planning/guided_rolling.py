"""How far a wheel has gone along a track on which other pairs keep it, told by those pairs.

A plate on a guide, a wheel that rolls on it, a second plate on top: the wheel's way along the second plate is made up
of the displacements of plates and wheel along their own lines, which are all parallel.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from dataclasses import replace

from graphkin.model.pairs import Slide
from graphkin.planning.equivalent import Contact
from graphkin.planning.structure import Topology

Way = tuple[tuple[str, float], ...]


def with_ways(structure: Topology) -> tuple[Contact, ...]:
    """The contacts; those whose own slide is set aside with the slides that add up to its displacement, if any do."""
    return tuple(
        replace(contact, way=_way(structure, structure.slides[contact.slide], contact.centres[1]))
        if contact.slide in structure.aside.slides
        else contact
        for contact in structure.contacts
    )


def _way(structure: Topology, track: Slide, centre: str) -> Way:
    """From the track over parallel slides to a link that carries the centre; nothing where there is no such way."""
    ways: dict[str, tuple[complex, Way]] = {track.guide: (track.line.direction, ())}
    queue = [track.guide]
    for link in queue:
        along, way = ways[link]
        if centre in structure.bodies[link]:
            return way
        for name, share, other, turned in _on(structure, link, along):
            if other not in ways:
                ways[other] = (turned, (*way, (name, share)))
                queue.append(other)
    return ()


def _on(structure: Topology, link: str, along: complex) -> Iterator[tuple[str, float, str, complex]]:
    """The slides of a link that run as the track does: name, what it counts, the other body, the track's line there."""
    for slide in structure.joining:
        block, turn = structure.block(slide), cmath.rect(1.0, slide.turn)
        if link == slide.guide:
            share, other, turned = slide.line.direction / along, block, along / turn
        elif link == block:
            share, other, turned = -slide.line.direction / (along * turn), slide.guide, along * turn
        else:
            continue
        if abs(share.imag) < 1e-9 * abs(share):
            yield slide.name, 1.0 if share.real > 0 else -1.0, other, turned
