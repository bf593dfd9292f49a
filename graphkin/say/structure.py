"""The parts of a mechanism in words: links, pairs, degrees of freedom, groups, redundant constraints, methods."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from graphkin.errors import Lang, called_pair, listed
from graphkin.model.naming import named
from graphkin.model.pairs import Cam, CircularSlot, Gear, Pair, Revolute, RollingContact, Slide
from graphkin.planning import Method
from graphkin.planning.stages import Bridge
from graphkin.say.catalogue import in_list, say, say_close

if TYPE_CHECKING:
    from graphkin.studies.assur import Structure

KINDS: Mapping[type[Pair], Callable[..., tuple[str, str]]] = {
    Revolute: lambda hinge: ("multiple" if len(hinge.links) > 2 else "hinge", hinge.point),
    Slide: lambda slide: ("pin" if slide.block is None else "slide", slide.point),
    CircularSlot: lambda slot: ("circular slot", slot.point),
    Gear: lambda gear: ("gear", ""),
    RollingContact: lambda roll: ("roll", ""),
    Cam: lambda cam: ("cam", ""),
}
"""The line of each kind, and the point it is about."""


def structure_lines(parts: Structure, lang: Lang) -> Iterator[str]:
    """Text for a terminal."""
    mechanism = parts.method.mechanism

    def head(name: str, entries: Iterable[str] = ()) -> str:
        return f"{say(name, lang)}{say('common.colon', lang)}{in_list(entries, lang)}".rstrip()

    yield mechanism.headline(lang)
    yield head("structure.links", [say("structure.frame", lang, name=mechanism.frame), *mechanism.moving])
    yield head("structure.pairs")
    for pair in (*mechanism.hinges, *mechanism.pairs):
        key, point = KINDS[type(pair)](pair)
        guide, *block = pair.joins
        groups = {"links": pair.joins, "guide": (guide,), "block": block}
        names = {word: in_list(map(mechanism.called, links), lang) for word, links in groups.items()}
        yield "  " + say(f"structure.pair {key}", lang, point=point, **names)
    yield from _freedoms(parts, lang)
    yield head("structure.drivers", [mechanism.driver_title(driver, lang) for driver in mechanism.drivers])
    yield head("structure.groups")
    for k, group in enumerate(parts.groups, 1):  # `4, 3, 5, 1+2`, `2 and the block that replaces cam pair 1–2`
        held = {link: "+".join(pair) for pair in group.merged for link in pair}
        links = in_list(dict.fromkeys(held.get(link, link) for link in group.links), lang)
        for each in group.added:
            replaced = called_pair(*named(mechanism, each.pair), lang)
            links += say_close(f"structure.added {each.kind}", lang, pair=replaced)
        links += say("structure.merged", lang) if group.merged else ""
        words = {"cls": say(f"structure.class {group.cls}", lang), "links": links, "kind": group.letters}
        yield f"  {k}. " + say(f"structure.group {group.kind}", lang, **words, point=group.point, link=group.ternary)
    if not parts.groups:
        yield f"  {say('structure.none', lang)}"
    yield say("structure.class", lang, cls=say(f"structure.class {parts.cls}", lang))
    methods = [say(f"structure.method {key}", lang) for key in parts.methods]
    yield head("structure.methods", methods or [say("structure.none", lang)])


def _freedoms(parts: Structure, lang: Lang) -> Iterator[str]:
    rolled = f" − {parts.rolled}" if parts.rolls else ""
    formula = str(parts.formula).replace("-", "−")
    words = {"n": parts.moving, "low": parts.low, "high": parts.high, "f": formula, "rolled": rolled}
    yield say("structure.formula", lang, **words)
    if parts.rolls:
        colon = say("common.colon", lang)
        counts = in_list((f"{'–'.join(links)}{colon}{count}" for links, count in parts.rolls), lang)
        yield "  " + say("structure.rolled", lang, count=parts.rolled, taken=counts)
    yield say("structure.rank", lang, f=parts.mobility.freedoms)
    if parts.mobility.idle:
        yield "  " + say("structure.idle", lang, links=in_list(parts.mobility.idle, lang))
    if parts.repeated:
        left_out = say("structure.left out", lang, count=parts.uncounted) if parts.uncounted else ""
        yield "  " + say("structure.redundant", lang, count=parts.repeated) + left_out
        repeated = redundant_constraints(parts.method, lang)
        yield from ("  " + say("structure.repeats", lang, what=what) for what in repeated)


def redundant_constraints(method: Method, lang: Lang) -> Iterator[str]:
    """Each redundant (passive) constraint (虚约束): `guide high (guide low holds the same already)`."""
    for each in method.aside:
        pair = called_pair(*named(method.mechanism, each.pair), lang)
        what = say_close(f"structure.part {each.part}", lang, pair=pair)
        if not each.held or each.part == "link":
            yield say_close("structure.distance", lang, what=what)
        else:
            held = listed((called_pair(*named(method.mechanism, pair), lang) for pair in each.held), lang)
            yield say_close("structure.held", lang, which=len(each.held) > 1, what=what, held=held)
    if not any(each.part == "link" for each in method.aside):
        bodies = (stage.body for stage in method.stages if isinstance(stage, Bridge))
        links = (body for body in bodies if body in method.mechanism.links)
        yield from (say("structure.distance", lang, what=called_pair("links", link, lang)) for link in links)
