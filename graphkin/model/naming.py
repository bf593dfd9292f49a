"""Names of sites in files, results and drawings, and their meaning.

`C` is a point; `B3` the point of link 3 under B (unless the file has a point B3); `B@guide` the same where a
link's name is a word. Two of them together, `CB` or `B3B2`, are a motion of the first seen from the second.
"""

from __future__ import annotations

import re
from collections.abc import Collection

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.model.mechanism import FRAME, Mechanism

PairName = tuple[str, int | str]
"""A pair by its table in the file and its number there; a hinge by its point, a link by its name."""

POINT = re.compile(r"[A-Z][0-9]*'*")


@frozen
class Seen:
    """A point of the mechanism as part of a link; `explicit` where the text names the link."""

    point: str
    link: str
    explicit: bool


def seen(mechanism: Mechanism, text: str, more: Collection[str] = ()) -> Seen | None:
    """The site that `C`, `B3` or `B@guide` means; None for a text that means nothing here.

    more  points that a construction has added: a special point S, a rolling contact K
    """
    if text in mechanism.points:
        owners = mechanism.owners[text]
        return Seen(text, next((link for link in owners if link != FRAME), FRAME), False)
    if text in more:
        return Seen(text, FRAME, False)
    point, at, link = text.partition("@")
    if at:
        return _site(mechanism, point, link, more)
    sites = (_site(mechanism, text[:k], text[k:], more) for k in range(1, len(text) + 1))
    by_point = {site.point: site for site in sites if site is not None}
    return next((by_point[point] for point in (*mechanism.points, *more) if point in by_point), None)


def _site(mechanism: Mechanism, point: str, link: str, more: Collection[str]) -> Seen | None:
    name = FRAME if link == mechanism.frame else link
    if name not in mechanism.links or not (point in mechanism.points or point in more):
        return None
    return Seen(point, name, True)


def pair(mechanism: Mechanism, text: str, more: Collection[str] = ()) -> tuple[Seen, Seen] | None:
    """The two sites that `CB`, `B3B2` or `B@guide,B@block` means."""
    first, comma, second = text.partition(",")
    cuts = [(first, second)] if comma else [(text[:k], text[k:]) for k in range(1, len(text))]
    for one, other in cuts:
        sites = seen(mechanism, one, more), seen(mechanism, other, more)
        if sites[0] is not None and sites[1] is not None:
            return sites[0], sites[1]
    return None


def clear(mechanism: Mechanism, text: str) -> str:
    """One or two sites as they are written everywhere: `B@guide,B@block` of BguideBblock, where a link is a word."""
    if "@" in text or text in mechanism.points:
        return text
    one = seen(mechanism, text)
    sites = (one,) if one is not None else pair(mechanism, text) or ()
    links = [mechanism.called(site.link) if site.explicit else "" for site in sites]
    if not any(link and not link.isdigit() for link in links):
        return text
    return ",".join(f"{site.point}@{link}" if link else site.point for site, link in zip(sites, links, strict=True))


def common_link(mechanism: Mechanism, of: Seen, seen_from: Seen) -> str | None:
    """The moving link on which both sites lie, so that one turns about the other."""
    first, second = _links(mechanism, of), _links(mechanism, seen_from)
    return next((link for link in mechanism.moving if link in first and link in second), None)


def _links(mechanism: Mechanism, site: Seen) -> set[str]:
    """The links a site belongs to: all that have the point, unless it is a point of another link there."""
    owners = mechanism.owners.get(site.point, ())
    return set(owners) if not site.explicit or site.link in owners else {site.link}


def primes(mechanism: Mechanism, plane: Plane) -> str:
    """The primes of the letters of a polygon: none for velocities; for accelerations one, or one more than any
    point of the mechanism has, so that b' is never two points."""
    return "'" * (mechanism.most_primes + 1) if plane == "acceleration" else ""


def image_name(mechanism: Mechanism, plane: Plane, label: str) -> str:
    """The polygon's point of a site as written: `b3'` of B3."""
    return label[0].lower() + label[1:] + primes(mechanism, plane)


def in_order(first: str, second: str) -> tuple[str, str]:
    """Two points of a line in the order a textbook writes them: AB, BD, CD; OA, O1B."""
    one, other = sorted((first, second), key=lambda name: (not name.startswith("O"), name))
    return one, other


def driver_number(mechanism: Mechanism, name: str) -> int | None:
    """The driver that is called so; one that drives a slide also by the two points whose distance that is (`DH`)."""
    for number, driver in enumerate(mechanism.drivers):
        if name == driver.name:
            return number
    for number, driver in enumerate(mechanism.drivers):
        slide = next((s for s in mechanism.slides if driver.kind == "slide" and s.name == driver.link), None)
        if slide is not None and name in (slide.line.origin + slide.point, slide.point + slide.line.origin):
            return number
    return None


def named(mechanism: Mechanism, pair: PairName) -> tuple[str, str]:
    """Kind and name of a pair, for `errors.called_pair`: its name, its point, or its links and which of several."""
    table, k = pair
    if isinstance(k, str):
        return table, k
    of_table = [each for each in mechanism.pairs if each.table == table]
    if of_table[k].given:
        return table, of_table[k].given
    if (known := of_table[k].known_by) is not None:
        return known
    names = ["–".join(mechanism.called(link) for link in each.joins) for each in of_table]
    nth = names[: k + 1].count(names[k])
    return table, names[k] if names.count(names[k]) == 1 else f"{names[k]} ({nth})"


_ROD = re.compile(r"(?<![A-Za-z])([a-z]?)e (?:([crg])(\d+)([a-z]?)\b|(\w+))")
_RODS = {"c": "ehjwy", "r": "fimxb", "g": "gqtzd"}
"""The letters of the links that stand for cam pairs, hold rolling wheels, and join the centres of gears: each the first
that is no point's, and the letter of no other link."""


def rod_sign(kind: str, taken: Collection[str]) -> str:
    """The letter of such links where their first one is taken, with which the names of their pairs end."""
    letters = {name[0].lower() for name in taken}
    letter = next((letter for letter in _RODS[kind] if letter not in letters), "")
    return letter if letter != _RODS[kind][0] else ""


def spelled(name: str) -> str:
    """A name with the links of an equivalent as people read them: e, e2, ..; those that hold a wheel f, f2, .."""

    def rod(match: re.Match[str]) -> str:
        letter, kind, number, own, roll = match.groups()
        if kind is None:
            return f"{letter}e_{roll}"
        sign = own or _RODS[kind][0]
        return letter + ("_" if letter else "") + sign + (str(int(number) + 1) if int(number) else "")

    return _ROD.sub(rod, name)
