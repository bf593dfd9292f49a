"""What a mechanism is made of, in words: links, pairs, degrees of freedom, groups, and the methods it needs."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from graphkin.errors import Lang, called_pair
from graphkin.model.mechanism import Mechanism
from graphkin.model.naming import named
from graphkin.model.pairs import Cam, CircularSlot, Gear, Pair, Revolute, RollingContact, Slide
from graphkin.planning import Method
from graphkin.say.catalogue import say, say_close
from graphkin.say.redundancy import redundant_constraints
from graphkin.studies.assur import Structure, Together, structure


def structure_lines(method: Method, lang: Lang) -> Iterator[str]:
    """Text for a terminal."""
    mechanism, found = method.mechanism, structure(method)
    colon, between = say("common.colon", lang), say("common.list", lang)
    yield mechanism.headline(lang)
    frame = say("structure.frame", lang, name=mechanism.frame)
    yield f"{say('structure.links', lang)}{colon}{between.join([frame, *mechanism.moving])}"
    yield f"{say('structure.pairs', lang)}{colon}".rstrip()
    yield from (f"  {line}" for line in _pairs(mechanism, lang))
    yield from _freedoms(method, found, lang)
    yield f"{say('structure.drivers', lang)}{colon}{between.join(driver.name for driver in mechanism.drivers)}"
    yield f"{say('structure.groups', lang)}{colon}".rstrip()
    yield from (f"  {k}. {text}" for k, text in enumerate(_groups(mechanism, found, lang), 1))
    if not found.groups:
        yield f"  {say('structure.none', lang)}"
    yield say("structure.class", lang, cls=say(f"structure.class {found.cls}", lang))
    methods = between.join(say(f"structure.method {key}", lang) for key in found.methods)
    yield f"{say('structure.methods', lang)}{colon}{methods or say('structure.none', lang)}"


KINDS: Mapping[type[Pair], Callable[[Any], tuple[str, str]]] = {
    Revolute: lambda hinge: ("multiple" if len(hinge.links) > 2 else "hinge", hinge.point),
    Slide: lambda slide: ("pin" if slide.block is None else "slide", slide.point),
    CircularSlot: lambda slot: ("circular slot", slot.point),
    Gear: lambda gear: ("gear", ""),
    RollingContact: lambda roll: ("roll", ""),
    Cam: lambda cam: ("cam", ""),
}
"""The line of each kind, and the point it is about."""


def _pairs(mechanism: Mechanism, lang: Lang) -> Iterator[str]:
    def called(links: tuple[str, ...]) -> str:
        return say("common.list", lang).join(mechanism.called(link) for link in links)

    for pair in (*mechanism.hinges, *mechanism.pairs):
        key, point = KINDS[type(pair)](pair)
        guide, *block = pair.joins
        names = {"links": called(pair.joins), "guide": called((guide,)), "block": called(tuple(block))}
        yield say(f"structure.pair {key}", lang, point=point, **names)


def _freedoms(method: Method, found: Structure, lang: Lang) -> Iterator[str]:
    rolled = f" − {found.rolled}" if found.rolls else ""
    formula = str(found.formula).replace("-", "−")
    words = {"n": found.moving, "low": found.low, "high": found.high, "f": formula, "rolled": rolled}
    yield say("structure.formula", lang, **words)
    if found.rolls:
        colon = say("common.colon", lang)
        taken = [f"{'–'.join(links)}{colon}{count}" for links, count in found.rolls]
        yield "  " + say("structure.rolled", lang, count=found.rolled, taken=say("common.list", lang).join(taken))
    yield say("structure.rank", lang, f=found.mobility.freedoms)
    if found.mobility.idle:
        yield "  " + say("structure.idle", lang, links=say("common.list", lang).join(found.mobility.idle))
    if found.repeated:
        left_out = say("structure.left out", lang, count=found.uncounted) if found.uncounted else ""
        yield "  " + say("structure.redundant", lang, count=found.repeated) + left_out
        yield from ("  " + say("structure.repeats", lang, what=what) for what in redundant_constraints(method, lang))


def _groups(mechanism: Mechanism, found: Structure, lang: Lang) -> Iterator[str]:
    for group in found.groups:
        words = {"cls": say(f"structure.class {group.cls}", lang), "links": _members(mechanism, group, lang)}
        words |= {"kind": group.letters, "point": group.point, "link": group.ternary}
        yield say(f"structure.group {group.kind}", lang, **words)


def _members(mechanism: Mechanism, group: Together, lang: Lang) -> str:
    """`4, 3, 5, 1+2`, `2 and the block that replaces cam pair 1–2`: as many as the group has."""
    held = {link: "+".join(pair) for pair in group.merged for link in pair}
    links = say("common.list", lang).join(dict.fromkeys(held.get(link, link) for link in group.links))
    for each in group.added:
        pair = called_pair(*named(mechanism, each.pair), lang)
        links += say_close(f"structure.added {each.kind}", lang, pair=pair)
    return links + (say("structure.merged", lang) if group.merged else "")
