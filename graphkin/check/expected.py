"""What a vector or a point of a drawing should be, from the analytic solution and from what its mark says it shows.

A mark names its sites as `B@3`, the point and the link of which it is a part: no name is taken apart.
"""

from __future__ import annotations

from collections.abc import Mapping

from graphkin.check.widened import Widened
from graphkin.construction import LETTER, Plane, Site
from graphkin.model.mechanism import Mechanism
from graphkin.model.naming import image_name, seen
from graphkin.model.pairs import pin_name


def vector_value(exact: Widened, plane: Plane, attributes: Mapping[str, str]) -> complex | None:
    """The motion of `data-of` seen from `data-seen-from`, or its part; with `data-over` that of it, and `data-of` seen
    from `data-onto`, end to end.

    None where the mark says nothing that can be known.
    """
    sites = [_site(attributes.get(f"data-{key}", "")) for key in ("of", "seen-from", "over", "onto")]
    of, seen_from, over, onto = sites
    if of is None or not all(exact.knows(site) for site in sites if site is not None):
        return None
    part = attributes.get("data-part", "")
    if over is None:
        return _part(exact, plane, part, of, seen_from)
    if seen_from is None:
        return None
    first = _part(exact, plane, part, over, seen_from)
    second = _part(exact, plane, "t" if plane == "acceleration" else "", of, onto or over)
    return None if first is None or second is None else first + second


def point_value(mechanism: Mechanism, exact: Widened, plane: Plane, attributes: Mapping[str, str]) -> complex | None:
    """Where a point lies in its plane; None for corners between arrows, and for points of one's own."""
    if attributes.get("data-of") == "pole":
        return 0j
    site = _site(attributes.get("data-site", ""))
    if site is None and (known := seen(mechanism, attributes.get("data-of", ""))) is not None:
        site = Site(known.point, known.link)
    if site is None or not exact.knows(site):
        return None
    return exact.place(site.point) if plane == "position" else _moving(exact, plane, site)


def _site(text: str) -> Site | None:
    point, at, link = text.partition("@")
    return Site(point, link) if at else None


def _moving(exact: Widened, plane: Plane, site: Site) -> complex:
    at = exact.velocity_at if plane == "velocity" else exact.acceleration_at
    return complex(at(site.point, site.link))


def _part(exact: Widened, plane: Plane, part: str, of: Site, seen_from: Site | None) -> complex | None:
    """Of two points of one body the parts n and t, of coincident points k, r, rn and rt."""
    if seen_from is None:
        return None if part else _moving(exact, plane, of)
    whole = _moving(exact, plane, of) - _moving(exact, plane, seen_from)
    arm = exact.place(of.point) - exact.place(seen_from.point)
    if part == "":
        return whole
    if part in ("n", "t"):
        body = _common(exact, of, seen_from)
        if body is None:
            return None
        return -(_omega(exact, body) ** 2) * arm if part == "n" else 1j * _alpha(exact, body) * arm
    slip = _moving(exact, "velocity", of) - _moving(exact, "velocity", seen_from)
    coriolis = 2j * _omega(exact, seen_from.link) * slip
    if part in ("k", "r"):
        return coriolis if part == "k" else whole - coriolis
    return _turned(exact, part, of, seen_from)


def _common(exact: Widened, of: Site, seen_from: Site) -> str | None:
    """The body on which two points lie: a hinge may be written as a point of another link that has it."""
    owners = exact.mechanism.owners
    for site, other in ((of, seen_from), (seen_from, of)):
        if site.link == other.link or site.link in owners.get(other.point, ()):
            return site.link
    return None


def _turned(exact: Widened, part: str, of: Site, seen_from: Site) -> complex | None:
    """The turning of one link against another about their hinge."""
    others = exact.points_of(seen_from.link)
    pivot = next((point for point in exact.points_of(of.link) if point in others), None)
    if pivot is None or part not in ("rn", "rt"):
        return None
    arm = exact.place(of.point) - exact.place(pivot)
    if part == "rn":
        return -((_omega(exact, of.link) - _omega(exact, seen_from.link)) ** 2) * arm
    return 1j * (_alpha(exact, of.link) - _alpha(exact, seen_from.link)) * arm


def _omega(exact: Widened, body: str) -> float:
    return float(exact.turning(body))


def _alpha(exact: Widened, body: str) -> float:
    return float(exact.swing(body))


# --- names ------------------------------------------------------------------------------------


def is_called_so(exact: Widened, plane: Plane, attributes: Mapping[str, str]) -> bool:
    """Whether the name of a vector, as people read it, is that of the sites it is measured by."""
    keys = ("of", "seen-from", "over", "onto")
    of, seen_from, over, onto = (_called(exact, attributes.get(f"data-{key}", "")) for key in keys)
    part, letter = attributes.get("data-part", ""), LETTER[plane]
    name = attributes.get("data-name", "")
    if over:
        first, _, second = name.partition("+")
        turned = "t" if plane == "acceleration" else ""
        return _reads(first, letter, part, over, seen_from) and _reads(second, letter, turned, of, onto or over)
    return _reads(name, letter, part, of, seen_from)


def is_named_so(exact: Widened, attributes: Mapping[str, str]) -> bool:
    """Whether a point's name, as people read it, is that of its site: `B`, `b3`, `b3'`."""
    plane: Plane = "acceleration" if attributes.get("data-plane") == "acceleration" else "velocity"
    name, site = attributes.get("data-name", ""), attributes.get("data-site", "")
    if not site:
        return True
    if attributes.get("data-plane") == "position":
        return name == site.partition("@")[0]
    return name in {image_name(exact.mechanism, plane, written) for written in _called(exact, site)}


def _reads(name: str, letter: str, part: str, of: set[str], seen_from: set[str]) -> bool:
    head, _, sites = name.partition("_")
    pairs = {f"{one}{comma}{other}" for one in of for other in {"", *seen_from} for comma in ("", ",")}
    return head == letter + (f"^{part}" if part else "") and sites in pairs


def _called(exact: Widened, text: str) -> set[str]:
    """Every way in which a site may be written: `B`, `B3`, `B@guide`; by any of the links that have the point."""
    site = _site(text)
    if site is None:
        return set()
    bodies = {site.link, *exact.mechanism.owners.get(site.point, ())}
    bodies |= {name for name, body in exact.bodies.items() if body.points[0] == site.point}
    slots = {pin_name(pair): pair.name for pair in exact.mechanism.pairs}
    names = {exact.mechanism.called(slots.get(body, body)) for body in bodies}
    names |= {exact.mechanism.called(link) for name in bodies if name in exact.bodies for link in _home(exact, name)}
    return {site.point} | {site.point + name for name in names} | {f"{site.point}@{name}" for name in names}


def _home(exact: Widened, body: str) -> tuple[str, ...]:
    """Links that carry the point of a pin."""
    return exact.mechanism.owners.get(exact.bodies[body].points[0], ())
