"""The redundant (passive) constraints (虚约束) of a planned mechanism in words: which, and what holds the same."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.errors import Lang, called_pair, listed
from graphkin.model.naming import named
from graphkin.planning import Method
from graphkin.planning.stages import Bridge
from graphkin.planning.structure import SetAside
from graphkin.say.catalogue import say, say_close


def redundant_constraints(method: Method, lang: Lang) -> Iterator[str]:
    """One line each: `guide high (guide low holds the same already)`."""
    yield from (_told(method, each, lang) for each in method.aside)
    if not any(each.part == "link" for each in method.aside):
        bridged = (stage.body for stage in method.stages if isinstance(stage, Bridge))
        links = (body for body in bridged if body in method.mechanism.links)
        yield from (say("structure.distance", lang, what=called_pair("links", link, lang)) for link in links)


def _told(method: Method, each: SetAside, lang: Lang) -> str:
    what = say_close(f"structure.part {each.part}", lang, pair=called_pair(*named(method.mechanism, each.pair), lang))
    if not each.held or each.part == "link":
        return say_close("structure.distance", lang, what=what)
    held = listed((called_pair(*named(method.mechanism, pair), lang) for pair in each.held), lang)
    return say_close("structure.held" if len(each.held) > 1 else "structure.held by one", lang, what=what, held=held)
