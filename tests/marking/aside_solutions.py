"""The twelve problems of `aside`, drawn by a student's hand (`by_hand.Paper`)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping

from by_hand import Given, Line, Paper, Solve, cross, triangle, unit

WRONG_SEGMENT = ("wrong-tail", "segment")
ABSOLUTE = ("absolute-for-relative", "")


def _crank(p: Paper, g: Given, pivot: complex, pin: complex, vector: str, k: int = 0, many: bool = False) -> tuple[complex, complex, float]:
    """Velocity and acceleration of a driven crank's pin, and the crank's omega."""
    _, omega, alpha, kind = g.driver(k)
    length, end = g.length(vector), vector[1] + vector[0]
    omega, alpha = p.rate(vector, omega, kind, many), p.alpha_given(vector, alpha)
    velocity = p.lay("v", f"v_{vector[1]}", 0j, p.crank(f"v_{vector[1]}", omega, pin - pivot, length))
    tip = p.lay("a", f"a_n {end}", 0j, p.normal(end, omega, pin - pivot, length, driven=True))
    if alpha or p.tag("alpha given", vector)[0]:
        tip = p.lay("a", f"a_t {end}", tip, p.tangent(end, alpha, pin - pivot, length))
    return velocity, tip, omega


def _dyad(
    p: Paper, g: Given, names: str, links: tuple[str, str], at: tuple[complex, complex, complex],
    motions: tuple[complex, complex, complex, complex], sizes: tuple[str, str], by: tuple[str, ...] = (),
) -> tuple[complex, complex]:  # fmt: skip
    """Velocity and acceleration of C, on a link from B and one from D (names "BCD"), whose motions are known.

    motions: v_B, a_B, v_D, a_D; sizes: for each link, lengths that may be taken for its own: further ones of it, and of
    links it is hinged to; by: arrows read by themselves
    """
    (b, c, d), (pb, pc, pd) = names, at
    v_b, a_b, v_d, a_d = motions
    arms, lengths = (pc - pb, pc - pd), (g.length(b + c), g.length(d + c))
    others = [{name: g.length(name) for name in some.split()} for some in sizes]
    v = p.meet("v", v_d, Line(f"v_{c}{d}", 1j * arms[1]), v_b, Line(f"v_{c}{b}", 1j * arms[0]))
    omegas = []
    for name, link, arm, length, base, may in zip((b, d), links, arms, lengths, (v_b, v_d), others, strict=True):
        text = f"v {c}{name}"
        read = p.size(text, "v", v - base) if text in by else None
        wrong = {ABSOLUTE: v} if base else {}
        omegas.append(p.rotation("v", link, v - base, arm, length, read, may, wrong, f"v_{c}{name}"))
    tips = []
    for name, arm, length, base, omega, may in zip((b, d), arms, lengths, (a_b, a_d), omegas, others, strict=True):
        forms = {f"omega^2 {other}": omega**2 * x for other, x in may.items() if abs(x / length - 1) > 0.02}
        if base:
            forms["v_abs^2/l"] = abs(v) ** 2 / length
        tips.append(p.lay("a", f"a_n {c}{name}", base, p.normal(c + name, omega, arm, length, forms)))
    a = p.meet("a", tips[1], Line(f"a_t {c}{d}", 1j * arms[1]), tips[0], Line(f"a_t {c}{b}", 1j * arms[0]))
    for name, link, arm, length, base, tip in zip((b, d), links, arms, lengths, (a_b, a_d), tips, strict=True):
        text = f"a_t {c}{name}"
        read = p.size(text, "a", a - tip) if text in by else None
        p.rotation("a", link, a - tip, arm, length, read, None, {WRONG_SEGMENT: a - base}, text)
    return v, a


def _four_bar(p: Paper, g: Given, coupler: str, rocker: str, sizes: tuple[str, str], by: tuple[str, ...] = ()) -> tuple[complex, ...]:
    """Places and motions of B and C."""
    at_a, at_d = g.point("A"), g.point("D")
    at_b = p.pin(at_a, g.length("AB"), g.driver()[0])
    at_c = p.arcs(at_b, g.length("BC"), at_d, g.length("DC"), g.near("C"))
    v_b, a_b, _ = _crank(p, g, at_a, at_b, "AB")
    v_c, a_c = _dyad(p, g, "BCD", (coupler, rocker), (at_b, at_c, at_d), (v_b, a_b, 0j, 0j), sizes, by)
    return at_b, at_c, v_b, a_b, v_c, a_c


def four_bar(p: Paper, g: Given) -> None:
    _, _, v_b, a_b, v_c, a_c = _four_bar(p, g, "2", "3", ("AB BE CE DC", "BC CE"))
    ratio = triangle(g.length("BC"), g.length("BE"), g.length("CE"), left=True)
    p.size("v E", "v", p.corner("v", "BCE", v_b, v_c, ratio))
    p.size("a E", "a", p.corner("a", "BCE", a_b, a_c, ratio))


def crossed(p: Paper, g: Given) -> None:
    _four_bar(p, g, "3", "4", ("AB DC", "BC"), ("v CB", "a_t CD"))


def stephenson(p: Paper, g: Given) -> None:
    at_b, at_c, v_b, a_b, v_c, a_c = _four_bar(p, g, "3", "4", ("AB BE CE DC", "BC CE"))
    ratio = triangle(g.length("BC"), g.length("BE"), g.length("CE"), left=True)
    at_e = p.corner("s", "BCE", at_b, at_c, ratio)
    v_e, a_e = p.corner("v", "BCE", v_b, v_c, ratio), p.corner("a", "BCE", a_b, a_c, ratio)
    p.size("v E", "v", v_e)
    p.size("a E", "a", a_e)
    at_f = p.arcs(at_e, g.length("EF"), g.point("G"), g.length("GF"), g.near("F"))
    _dyad(p, g, "EFG", ("5", "6"), (at_e, at_f, g.point("G")), (v_e, a_e, 0j, 0j), ("BE CE GF", "EF"))


def five_bar(p: Paper, g: Given) -> None:
    at_b = p.pin(g.point("A"), g.length("AB"), g.driver(0)[0])
    at_d = p.pin(g.point("E"), g.length("ED"), g.driver(1)[0])
    at_c = p.arcs(at_b, g.length("BC"), at_d, g.length("DC"), g.near("C"))
    v_b, a_b, _ = _crank(p, g, g.point("A"), at_b, "AB", 0, many=True)
    v_d, a_d, _ = _crank(p, g, g.point("E"), at_d, "ED", 1, many=True)
    v_c, a_c = _dyad(p, g, "BCD", ("2", "3"), (at_b, at_c, at_d), (v_b, a_b, v_d, a_d), ("AB DC", "ED BC"))
    p.size("v C", "v", v_c)
    p.size("a C", "a", a_c)


def _rod(
    p: Paper, g: Given, names: str, link: str, at: tuple[complex, complex], motions: tuple[complex, complex],
    along: complex, sizes: tuple[str, ...], pivot: complex | None = None, by: tuple[str, ...] = (), guide: str = "slide",
) -> tuple[complex, complex]:  # fmt: skip
    """Velocity and acceleration of C that slides on the frame, on a rod from B (names "BC")."""
    (b, c), (at_b, at_c), (v_b, a_b) = names, at, motions
    arm, length = at_c - at_b, g.length(names)
    lengths = {name: g.length(name) for name in sizes}
    v = p.meet("v", 0j, Line(f"v_{c}", along, guide), v_b, Line(f"v_{c}{b}", 1j * arm))
    p.size(f"v {c}", "v", v)
    text = f"v {c}{b}"
    read = p.size(text, "v", v - v_b) if text in by else None
    omega = p.rotation("v", link, v - v_b, arm, length, read, lengths, {ABSOLUTE: v}, f"v_{c}{b}")
    forms = {"v_abs^2/l": abs(v) ** 2 / length, **{f"omega^2 {k}": omega**2 * x for k, x in lengths.items()}}
    tip = p.lay("a", f"a_n {c}{b}", a_b, p.normal(c + b, omega, arm, length, forms))
    start = 0j
    if pivot is not None:
        p.may("slider-normal-term", "", "slider", f"a_{c}", "normal")
        if p.tag("slider", f"a_{c}")[0]:
            start = omega**2 * length * unit(pivot - at_c)
    a = p.meet("a", start, Line(f"a_{c}", along, "slide"), tip, Line(f"a_t {c}{b}", 1j * arm))
    p.size(f"a {c}", "a", a)
    p.rotation("a", link, a - tip, arm, length, None, None, {WRONG_SEGMENT: a - a_b}, f"a_t {c}{b}")
    return v, a


def slider_crank(p: Paper, g: Given) -> None:
    at_a = g.point("A")
    at_b = p.pin(at_a, g.length("AB"), g.driver()[0])
    at_c = p.arc_line(at_b, g.length("BC"), -0.025j + 1j * p.err("s"), 1 + 0j, g.near("C"))
    v_b, a_b, _ = _crank(p, g, at_a, at_b, "AB")
    v_c, _ = _rod(p, g, "BC", "2", (at_b, at_c), (v_b, a_b), 1 + 0j, ("AB", "BM"), at_a)
    p.size("v M", "v", p.corner("v", "BCM", v_b, v_c, g.ratio("2", "B", "C", "M")))


def geared_crank(p: Paper, g: Given) -> None:
    _, omega, _, kind = g.driver()
    omega = p.rate("1", omega, kind)
    r1, r2 = g.document["gear"][0]["radii"]
    omega = p.ratio("omega 2", -omega * r1 / r2, {("centre-ratio", "upside down"): -omega * r2 / r1})
    at_b = g.point("B")
    at_p = p.pin(at_b, g.length("BP"), g.document["pose"][0]["angle"] + g.turned)
    at_c = p.arc_line(at_p, g.length("PC"), 0.012 + p.err("s"), 1j, g.near("C"))
    v_p = p.lay("v", "v_P", 0j, p.crank("v_P", omega, at_p - at_b, g.length("BP")))
    a_p = p.lay("a", "a_n PB", 0j, p.normal("PB", omega, at_p - at_b, g.length("BP"), driven=True))
    _rod(p, g, "PC", "3", (at_p, at_c), (v_p, a_p), 1j, ("BP",), at_b, ("v CP",))


def _sliding(
    p: Paper, names: tuple[str, str, str], link: str, at: tuple[complex, complex], along: complex, guide: float,
    motions: tuple[complex, complex, float], lengths: Mapping[str, float],
) -> tuple[complex, complex, float]:  # fmt: skip
    """Velocity and acceleration of B3, on a guide that turns about D, whose coincident B2 is known.

    names: "B3", "B2", "D"; guide: length along the guide, if any, by which a student may divide
    """
    (b3, b2, d), (at_b, at_d), (v_b2, a_b2, crank) = names, at, motions
    shown = b3 + b2
    # the order in which the problem names the two points
    turned = b2 + b3 if (b3, b2) == ("B2", "B1") else shown
    arm = at_b - at_d
    length = abs(arm)
    split = {("orthogonal-split", ""): 1j * along} if abs(cross(unit(along), unit(arm))) > 0.02 else {}
    v = p.meet("v", 0j, Line(f"v_{b3}", 1j * arm, "across", split), v_b2, Line(f"v_{shown}", along, "slide"))
    slip = v - v_b2
    read = p.size(f"v {turned}", "v", slip)
    wrong = {("sliding-as-turning", ""): slip * length / guide}
    omega = p.rotation("v", link, v, arm, length, None, lengths, wrong, f"v_{b3}")
    forms = {"v_r^2/l": abs(slip) ** 2 / length, **{f"omega^2 {k}": omega**2 * x for k, x in lengths.items()}}
    normal = p.lay("a", f"a_n {b3}{d}", 0j, p.normal(b3 + d, omega, arm, length, forms))
    absolute = {f"v_{b2}": abs(v_b2), f"v_{b3}": abs(v)}
    tip = p.lay("a", f"a_k {turned}", a_b2, p.coriolis(turned, omega, read, slip, crank, absolute))
    a = p.meet("a", normal, Line(f"a_t {b3}{d}", 1j * arm), tip, Line(f"a_r {shown}", along, "slide"))
    p.rotation("a", link, a - normal, arm, length, None, None, {WRONG_SEGMENT: a}, f"a_t {b3}{d}")
    p.size(f"a_r {turned}", "a", a - tip)
    return v, a, omega


def guide_rocker(p: Paper, g: Given) -> None:
    at_a, at_d, offset = g.point("A"), g.point("D"), g.length("DQ")
    at_b = p.pin(at_a, g.length("AB"), g.driver()[0])
    on_guide = math.sqrt(abs(at_b - at_d) ** 2 - offset**2)
    at_q = p.arcs(at_d, offset, at_b, on_guide, g.near("Q"))
    v_b, a_b, omega = _crank(p, g, at_a, at_b, "AB")
    lengths = {"DQ": offset, "BQ": on_guide}
    _sliding(p, ("B3", "B2", "D"), "3", (at_b, at_d), (at_b - at_q) * p.turn(), on_guide, (v_b, a_b, omega), lengths)


def cam(p: Paper, g: Given) -> None:
    at_a, at_d, radius = g.point("A"), g.point("D"), 0.042 + p.err("s")
    at_b = p.pin(at_a, g.length("AB"), g.driver()[0])
    face = unit(at_b - at_d) * cmath.exp(-1j * math.asin(radius / abs(at_b - at_d))) * p.turn()
    v_b, a_b, omega = _crank(p, g, at_a, at_b, "AB")
    motions, lengths = (v_b, a_b, omega), {"DE": g.length("DE")}
    v, a, _ = _sliding(p, ("B2", "B1", "D"), "2", (at_b, at_d), face, abs(at_b - at_d), motions, lengths)
    ratio = g.length("DE") * face / (at_b - at_d)
    p.size("v E", "v", p.corner("v", "DBE", 0j, v, ratio))
    p.size("a E", "a", p.corner("a", "DBE", 0j, a, ratio))


def quick_return(p: Paper, g: Given) -> None:
    at_o, at_b = g.point("O"), g.point("B")
    at_a = p.pin(at_o, g.length("OA"), g.driver()[0])
    v_a, a_a, omega = _crank(p, g, at_o, at_a, "OA")
    along = at_a - at_b
    lengths = {"BC": g.length("BC")}
    v, a, _ = _sliding(p, ("A3", "A2", "B"), "3", (at_a, at_b), along * p.turn(), abs(along), (v_a, a_a, omega), lengths)
    ratio = -g.length("BC") / abs(along) + 0j
    at_c = at_b + along * ratio
    at_d = p.arc_line(at_c, g.length("CD"), at_b + 1j * p.err("s"), 1 + 0j, g.near("D"))
    v_c, a_c = p.corner("v", "BAC", 0j, v, ratio), p.corner("a", "BAC", 0j, a, ratio)
    _rod(p, g, "CD", "4", (at_c, at_d), (v_c, a_c), 1 + 0j, ("BC",))


def swing_block(p: Paper, g: Given) -> None:
    at_a, at_c = g.point("A"), g.point("C")
    at_b = p.pin(at_a, g.length("AB"), g.driver()[0])
    v_b, a_b, crank = _crank(p, g, at_a, at_b, "AB")
    arm = at_c - at_b
    length, lengths = abs(arm), {"BE": g.length("BE"), "AB": g.length("AB")}
    v = p.meet("v", v_b, Line("v_C2B", 1j * arm), 0j, Line("v_C2C3", arm, "slide"))
    read = p.size("v C2C3", "v", v)
    omega = p.rotation("v", "2", v - v_b, arm, length, None, lengths, {ABSOLUTE: v}, "v_C2B")
    ratio = g.length("BE") / length + 0j
    p.size("v E", "v", p.corner("v", "BCE", v_b, v, ratio))
    forms = {"v_abs^2/l": abs(v) ** 2 / length, **{f"omega^2 {k}": omega**2 * x for k, x in lengths.items()}}
    tip = p.lay("a", "a_n C2B", a_b, p.normal("C2B", omega, arm, length, forms))
    laid = p.lay("a", "a_k C2C3", 0j, p.coriolis("C2C3", omega, read, v, crank, {}))
    a = p.meet("a", tip, Line("a_t C2B", 1j * arm), laid, Line("a_r C2C3", arm, "slide"))
    p.rotation("a", "2", a - tip, arm, length, None, None, {WRONG_SEGMENT: a - a_b}, "a_t C2B")
    p.size("a_r C2C3", "a", a - laid)


def planetary(p: Paper, g: Given) -> None:
    """Rotations by the formula of the arm; velocities and accelerations drawn."""
    _, omega, _, kind = g.driver()
    omega = p.rate("OS", omega, kind)
    (r1, r2), (_, r3) = g.document["gear"][0]["radii"], g.document["gear"][1]["radii"]
    arm = p.ratio("omega H", omega / (1 + r3 / r1), {
        ("centre-ratio", "upside down"): omega * (1 + r3 / r1), ("centre-ratio", "inside for outside"): omega / (1 - r3 / r1),
    })  # fmt: skip
    planet = p.ratio("omega 2", arm * (1 - r3 / r2), {
        ("arm-ignored", ""): -omega * r1 / r2, ("centre-ratio", "inside for outside"): arm * (1 + r3 / r2),
        ("centre-ratio", "upside down"): arm * (1 - r2 / r3),
    })  # fmt: skip
    op = (r1 + r2) / 1000 * cmath.exp(1j * math.radians(g.document["pose"][0]["angle"] + g.turned)) * p.turn()
    pq = g.length("PQ") * cmath.exp(1j * math.radians(g.document["pose"][1]["angle"])) * p.turn()
    v_p = p.lay("v", "v_P", 0j, p.crank("v_P", arm, op, abs(op), False))
    p.size("v P", "v", v_p)
    p.size("v Q", "v", p.lay("v", "v_QP", v_p, p.crank("v_QP", planet, pq, abs(pq), False)))
    a_p = p.lay("a", "a_n PO", 0j, p.normal("PO", arm, op, abs(op)))
    p.size("a P", "a", a_p)
    p.size("a Q", "a", p.lay("a", "a_n QP", a_p, p.normal("QP", planet, pq, abs(pq))))


def wheel(p: Paper, g: Given) -> None:
    at_a, radius = g.point("A"), g.length("CF")
    at_b = p.pin(at_a, g.length("AB"), g.driver()[0])
    at_c = p.arc_line(at_b, g.length("BC"), -0.015j + 1j * p.err("s"), 1 + 0j, g.near("C"))
    cf = radius * cmath.exp(1j * math.radians(g.document["pose"][0]["angle"])) * p.turn()
    v_b, a_b, _ = _crank(p, g, at_a, at_b, "AB")
    v_c, a_c = _rod(p, g, "BC", "2", (at_b, at_c), (v_b, a_b), 1 + 0j, ("AB",), at_a, guide="road")
    # the point of contact is at rest, and below C
    omega = p.rotation("v", "3", v_c, 1j * radius, radius, p.values["v C"], {"BC": g.length("BC")}, None, "v_C")
    alpha = p.rotation("a", "3", a_c, 1j * radius, radius, p.values["a C"], None, None, "a_C")
    p.size("v F", "v", p.lay("v", "v_FC", v_c, p.crank("v_FC", omega, cf, radius, False)))
    tip = p.lay("a", "a_n FC", a_c, p.normal("FC", omega, cf, radius))
    p.size("a F", "a", p.lay("a", "a_t FC", tip, p.tangent("FC", alpha, cf, radius)))


SOLUTIONS: dict[str, Solve] = {
    "four-bar": four_bar, "crossed": crossed, "guide-rocker": guide_rocker, "swing-block": swing_block,
    "slider-crank": slider_crank, "quick-return": quick_return, "stephenson": stephenson, "five-bar": five_bar,
    "geared-crank": geared_crank, "planetary": planetary, "wheel": wheel, "cam": cam,
}  # fmt: skip
