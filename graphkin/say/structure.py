"""What a mechanism is made of, in words: links, pairs, degrees of freedom, groups, and the methods it needs."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from graphkin.assur import Structure, structure
from graphkin.errors import Lang
from graphkin.mechanism import Mechanism
from graphkin.pairs import Cam, CircularSlot, Gear, Pair, Revolute, Roll, Slide
from graphkin.planning import Method
from graphkin.say.catalogue import say
from graphkin.say.redundancy import redundant_constraints


def structure_lines(method: Method, lang: Lang) -> Iterator[str]:
    """Text for a terminal."""
    mechanism, found = method.mechanism, structure(method)
    yield mechanism.headline(lang)
    frame = say("structure.frame", lang, name=mechanism.frame)
    yield f"{say('structure.links', lang)}: {', '.join([frame, *mechanism.moving])}"
    yield f"{say('structure.pairs', lang)}:"
    yield from (f"  {line}" for line in _pairs(mechanism, lang))
    yield from _freedoms(method, found, lang)
    yield f"{say('structure.drivers', lang)}: {', '.join(driver.name for driver in mechanism.drivers)}"
    yield f"{say('structure.groups', lang)}:"
    yield from (f"  {k}. {text}" for k, text in enumerate(_groups(found, lang), 1))
    if not found.groups:
        yield f"  {say('structure.none', lang)}"
    yield say("structure.class", lang, cls=say(f"structure.class {found.cls}", lang))
    methods = ", ".join(say(f"structure.method {key}", lang) for key in found.methods)
    yield f"{say('structure.methods', lang)}: {methods or say('structure.none', lang)}"


KINDS: Mapping[type[Pair], Callable[[Any], tuple[str, str]]] = {
    Revolute: lambda hinge: ("multiple" if len(hinge.links) > 2 else "hinge", hinge.point),
    Slide: lambda slide: ("pin" if slide.block is None else "slide", slide.point),
    CircularSlot: lambda slot: ("circular slot", slot.point),
    Gear: lambda gear: ("gear", ""),
    Roll: lambda roll: ("roll", ""),
    Cam: lambda cam: ("cam", ""),
}
"""The line of each kind, and the point it is about."""


def _pairs(mechanism: Mechanism, lang: Lang) -> Iterator[str]:
    def called(links: tuple[str, ...]) -> str:
        return ", ".join(mechanism.called(link) for link in links)

    for pair in (*mechanism.hinges, *mechanism.pairs):
        key, point = KINDS[type(pair)](pair)
        guide, *block = pair.joins
        names = {"links": called(pair.joins), "guide": called((guide,)), "block": called(tuple(block))}
        yield say(f"structure.pair {key}", lang, point=point, **names)


def _freedoms(method: Method, found: Structure, lang: Lang) -> Iterator[str]:
    yield say("structure.formula", lang, n=found.moving, low=found.low, high=found.high, f=found.formula)
    yield say("structure.rank", lang, f=found.mobility.freedoms)
    if found.mobility.idle:
        yield "  " + say("structure.idle", lang, links=", ".join(found.mobility.idle))
    if found.mobility.repeated:
        yield "  " + say("structure.redundant", lang, count=found.mobility.repeated)
        yield from ("  " + say("structure.repeats", lang, what=what) for what in redundant_constraints(method, lang))


def _groups(found: Structure, lang: Lang) -> Iterator[str]:
    for group in found.groups:
        cls, links = say(f"structure.class {group.cls}", lang), ", ".join(group.links)
        words = {"cls": cls, "links": links, "kind": group.letters, "point": group.point, "link": group.ternary}
        yield say(f"structure.group {group.kind}", lang, **words)
