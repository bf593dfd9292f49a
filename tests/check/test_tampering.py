"""What check says to drawings that were tampered with: one row for each kind of tampering.

A row is a name, what is done to the drawing, and what must be said: "good"; or the name of what is wrong, which a measured
length or a fault must bear; or, after "refused:", what the reader says it cannot follow. Links, polygons, wheels and
guides are tampered with on two mechanisms, centres on their own sheet.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable
from functools import cache
from pathlib import Path
from xml.sax.saxutils import escape, unescape

import book
import pytest
from reading_back import FAMILIES, drawn, make, read_back, wrong

from graphkin import Drawing
from graphkin.base.plain import seal
from graphkin.check import measure
from graphkin.errors import BadDrawing
from graphkin.files import library
from graphkin.outputs.svg import svg
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.say.results import check_lines
from graphkin.sheet.centre_sheet import centre_sheet
from graphkin.studies.centres import centres

Change = Callable[[str], str]


@cache
def drawing(name: str) -> str:
    if name.endswith(" centres"):
        method = plan(library.load(name.removesuffix(" centres")))
        return svg(centre_sheet(centres(method, replay_all(method))))
    return svg(Drawing.of(book.example() if name == "ex3-1" else library.load(name)).sheet())


# --- what is done -----------------------------------------------------------------------------


def put(old: str, new: str) -> Change:
    def change(text: str) -> str:
        assert old in text, old
        return text.replace(old, new, 1)

    return change


def mark(name: str, change: Change) -> Change:
    """Change one mark: `v_B3`; a point `velocity b3`; a line of a link `link 3 bar`."""

    def changed(text: str) -> str:
        found = element(text, name)
        new = change(found[0])
        assert new != found[0]
        return text[: found.start()] + new + text[found.end() :]

    return changed


def element(text: str, name: str) -> re.Match[str]:
    one, _, rest = name.partition(" ")
    if one == "link":
        link, form = rest.split()
        pattern = rf'<\w+ class="link"[^>]*data-form="{form}"[^>]*data-link="{link}"[^>]*/>'
    elif rest:
        pattern = rf'<circle class="point"[^>]*data-name="{re.escape(rest)}"[^>]*data-plane="{one}"[^>]*/>'
    else:
        pattern = rf'<line class="vector"[^>]*data-name="{re.escape(one)}"[^>]*(?:/>|>.*?</line>)'
    found = re.search(pattern, text)
    assert found is not None, name
    return found


def having(attributes: str) -> Change:
    """With more attributes; those it had of the same name are dropped."""

    def change(tag: str) -> str:
        for key in re.findall(r"([\w-]+)=", attributes):
            tag = re.sub(rf' {key}="[^"]*"', "", tag)
        return re.sub(r"^<(\w+)", rf"<\1 {attributes}", tag)

    return change


def within(before: str, after: str) -> Change:
    return lambda tag: f"{before}{tag}{after}"


def shifted(dx: float) -> Change:
    """All the coordinates x of a line, a path or a circle."""

    def change(tag: str) -> str:
        tag = re.sub(r'\b(x1|x2|cx)="([^"]*)"', lambda m: f'{m[1]}="{float(m[2]) + dx:.4f}"', tag)
        return re.sub(r"([ML])([-0-9.]+)", lambda m: f"{m[1]}{float(m[2]) + dx:.4f}", tag)

    return change


def aside(off: float) -> Change:
    """A vector moved at right angles to itself [mm]."""

    def change(tag: str) -> str:
        x1, y1, x2, y2 = (float(re.search(rf'\b{key}="([^"]*)"', tag)[1]) for key in ("x1", "y1", "x2", "y2"))  # type: ignore[index]
        way = complex(x2 - x1, y2 - y1)
        move = 1j * way / abs(way) * off
        ends = {"x1": x1 + move.real, "x2": x2 + move.real, "y1": y1 + move.imag, "y2": y2 + move.imag}
        for key, value in ends.items():
            tag = re.sub(rf'\b{key}="[^"]*"', f'{key}="{value:.4f}"', tag)
        return tag

    return change


def gone(tag: str) -> str:
    return ""


def turned_round(tag: str) -> str:
    """Head and tail exchanged, with their names left."""
    for a, b in (("x1", "x2"), ("y1", "y2")):
        tag = re.sub(rf"\b{a}=", "T=", tag)
        tag = re.sub(rf"\b{b}=", f"{a}=", tag).replace("T=", f"{b}=")
    return tag


def all_points(text: str) -> str:
    """Hinges of the mechanism shifted against its links."""
    pattern = r'<circle class="point"[^>]*data-plane="position"[^>]*/>'
    return re.sub(pattern, lambda found: shifted(1.0)(found[0]), text)


def at_end(more: str) -> Change:
    return put("</svg>", more + "</svg>")


def at_start(more: str) -> Change:
    return put("</metadata>", "</metadata>" + more)


def whole(before: str, after: str) -> Change:
    """Everything drawn, in something."""
    return lambda text: at_end(after)(at_start(before)(text))


def root(old: str, new: str) -> Change:
    def change(text: str) -> str:
        tag = re.search(r"<svg\b[^>]*>", text)
        assert tag is not None
        assert re.search(old, tag[0]), old
        return text.replace(tag[0], re.sub(old, new, tag[0], count=1), 1)

    return change


def claims(change: Callable[[dict], None], sealed: bool = True) -> Change:
    """The metadata edited, and sealed anew."""

    def changed(text: str) -> str:
        found = re.search(r"(?<=<gk:sheet>)(.*?)(?=</gk:sheet>)", text, re.S)
        assert found is not None
        data = json.loads(unescape(found[0]))
        change(data)
        if sealed:
            data["seal"] = seal(data)
        return text[: found.start()] + escape(json.dumps(data, ensure_ascii=False)) + text[found.end() :]

    return changed


def mechanism(old: str, new: str) -> Change:
    def change(data: dict) -> None:
        assert old in data["mechanism"]
        data["mechanism"] = data["mechanism"].replace(old, new)

    return claims(change)


def undrawn(name: str) -> Callable[[dict], None]:
    def change(data: dict) -> None:
        data["drawn"] = [entry for entry in data["drawn"] if f"name={name}" not in entry]

    return change


def both(first: Change, second: Change) -> Change:
    return lambda text: second(first(text))


def copy_of(name: str, change: Change) -> Change:
    """One more of a mark."""
    return mark(name, lambda tag: tag + change(tag))


def hidden_right_visible_wrong(text: str) -> str:
    """The right vector without ink, a wrong one without a name beside it."""
    tag = element(text, "v_B3")[0]
    bare = re.sub(r' (data-[\w-]+|class|marker-end)="[^"]*"', "", shifted(5)(tag))
    return at_end(bare)(text.replace(tag, having('opacity="0"')(tag)))


def exchanged(text: str) -> str:
    """The letters A and D of the mechanism, each where the other stood."""
    one, other = (re.search(rf"<text[^>]*>{letter}</text>", text) for letter in "AD")
    assert one is not None
    assert other is not None
    assert one.start() < other.start()
    swapped = [found[0].replace(">A<", ">#<").replace(">D<", ">A<").replace(">#<", ">D<") for found in (one, other)]
    return text[: one.start()] + swapped[0] + text[one.end() : other.start()] + swapped[1] + text[other.end() :]


def some(pattern: str, change: Change, number: int = 0) -> Change:
    """Change one of the elements of a pattern."""

    def changed(text: str) -> str:
        found = list(re.finditer(pattern, text))
        assert found, pattern
        one = found[number % len(found)]
        return text[: one.start()] + change(one[0]) + text[one.end() :]

    return changed


def reversed_head(tag: str) -> str:
    """A head of an arrow on the other side of its back."""
    tip, one, other = (complex(*map(float, corner.split())) for corner in re.search(r' d="M([^Z]*)Z"', tag)[1].split("L"))  # type: ignore[index]
    corners = "L".join(f"{p.real:.4f} {p.imag:.4f}" for p in (one + other - tip, one, other))
    return re.sub(r' d="[^"]*"', f' d="M{corners}Z"', tag)


def shorter(tag: str) -> str:
    x1, x2 = (float(re.search(rf' {key}="([^"]*)"', tag)[1]) for key in ("x1", "x2"))  # type: ignore[index]
    return re.sub(r' x2="[^"]*"', f' x2="{x1 + 0.67 * (x2 - x1):.4f}"', tag)


def pale(tag: str) -> str:
    return having('stroke="#ffffff" fill="#ffffff"')(tag)


TURNS = r'<path class="link"[^>]*data-form="(?:omega|alpha|push|thrust)"[^>]*/>'
HUNDRED = r'<line class="link"[^>]*data-form="ruler"[^>]*/>'
CONSTRUCTION = r'<line(?: data-step="\d+")? x1="[^"]*" x2="[^"]*" y1="[^"]*" y2="[^"]*" />'
TITLE = re.compile(r"(?<=<title>)[^<]*(?=</title><desc>)")
TIP = re.compile(r"(?<= = )[0-9.]+(?= m/s</title>)")
OWN_ARROW = '<path d="M60 150L88 159M90 160L87 160.1L88 158Z" fill="#0b4f9c" stroke="#0b4f9c" stroke-width="0.35"/>'
THREE_LINES = '<g stroke="#000" stroke-width=".3"><line x1="60" y1="150" x2="90" y2="150"/><line x1="90" y1="150" x2="87" y2="149"/><line x1="90" y1="150" x2="87" y2="151"/></g>'
GLYPHS = '<text x="60" y="150" font-size="60" fill="#ffffff">\u2588\u2588</text>'
OUTLINED = '<text x="60" y="150" font-size="60" fill="none" stroke="#fff" stroke-width=".5">\u2588</text>'
resealed = claims(lambda data: None)
LETTER = re.compile(r'(<text[^>]* x=")([0-9.]+)(?=" y="[^"]*">A</text>)')
SCALE = re.compile(r"<text(?:(?!</text>).)*?>μ</tspan><tspan[^>]*>v ?</tspan>.*?</text>")
WIDE = '<rect x="0" y="0" width="297" height="210" fill="#ffffff"/>'
ARROW = '<line x1="60" y1="150" x2="90" y2="160" stroke="#000000" stroke-width="0.35" marker-end="url(#tip)"/>'
NEW_POINT = '<circle class="point" cx="50" cy="60" r="0.5" fill="#000000" data-plane="position" data-name="X" data-of="X"/>'
RIGHT, WRONG, REFUSED = "good", "", "refused:"

# --- the table: name, tampering, what must be said --------------------------------------------

EX3_1: list[tuple[str, Change, str]] = [
    # links
    ("line of a link moved", mark("link 1 bar", shifted(1)), "1: A B"),
    ("line of a link deleted", mark("link 1 bar", gone), "1: A B"),
    ("line of a link deleted, and told so", both(mark("link 1 bar", gone), claims(lambda data: None)), "1: A B"),
    ("line of a link to another point", mark("link 3 bar", put("D C", "D B")), "3: D"),
    ("guide turned", mark("link 3 guide", having('x1="80" y1="90"')), "3: s0"),
    ("guide shortened", mark("link 3 guide", lambda tag: re.sub(r'x2="[^"]*" (y1="[^"]*") y2="[^"]*"', r'x2="99" \1 y2="70"', tag)), "3: s0"),
    ("block moved", mark("link 2 block", shifted(1)), "2: s0"),
    ("points shifted against the links", all_points, "1: A B"),
    ("link's line is no line", mark("link 1 bar", put("<line", "<rect")), "1: A B"),
    # transforms
    ("vector moved by transform", mark("v_B3", having('transform="translate(1,0)"')), "v_B3"),
    ("vector turned", mark("v_B3", having('transform="rotate(5)"')), "v_B3"),
    ("vector made longer", mark("v_B3", having('transform="scale(1.01)"')), "v_B3"),
    ("vector sheared", mark("v_B3", having('transform="skewX(3)"')), "refused:stretches"),
    ("vector in a group that moves", mark("v_B3", within('<g transform="matrix(1 0 0 1 0 2)">', "</g>")), "v_B3"),
    ("group that moves what follows", at_start('<g transform="translate(0 3)"></g>'), RIGHT),
    ("everything moved together", whole('<g transform="translate(0.5,0.5)">', "</g>"), RIGHT),
    ("everything moved far together", whole('<g transform="translate(-6,4)">', "</g>"), RIGHT),
    ("everything smaller", whole('<g transform="scale(0.9)">', "</g>"), "v_B3"),
    ("translate(0,0)", mark("v_B3", having('transform="translate(0,0)"')), RIGHT),
    ("there and back", mark("v_B3", within('<g transform="translate(5)"><g transform="translate(-5 0)">', "</g></g>")), RIGHT),
    ("a transform nobody reads", mark("v_B3", having('transform="wobble(3)"')), "refused:wobble"),
    ("transform-origin", mark("v_B3", having('transform-origin="5 5"')), "refused:transform-origin"),
    # styles
    ("style that moves", mark("v_B3", having('style="transform:translate(3px)"')), "refused:style transform"),
    ("style: scale", mark("v_B3", having('style="scale:1.1"')), "refused:style scale"),
    ("style: rotate", mark("v_B3", having('style="rotate:4deg"')), "refused:style rotate"),
    ("style: translate", mark("v_B3", having('style="translate:4px"')), "refused:style translate"),
    ("style: cx of a point", mark("velocity b3", having('style="cx:40px"')), "refused:style cx"),
    ("style sheet with transform", at_start("<style>.vector{transform:translate(1px)}</style>"), "refused:style sheet"),
    ("style sheet with display", at_start("<style>.vector{display:none}</style>"), "refused:style sheet"),
    ("style sheet with cx", at_start("<style>circle{cx:10px}</style>"), "refused:style sheet"),
    ("style sheet brought in", at_start("<style>@import url(x.css);</style>"), "refused:style sheet"),
    ("style sheet before the drawing", put("<svg", '<?xml-stylesheet href="x.css"?><svg'), "refused:style sheet"),
    ("style sheet of type alone", at_start("<style>text{font-weight:bold}</style>"), RIGHT),
    ("ink given as a style", mark("v_B3", having('style="stroke:#000;stroke-width:0.35;fill:none"')), RIGHT),
    # not to be seen
    ("display none", mark("v_B3", having('display="none"')), "v_B3"),
    ("display none above", mark("v_B3", within('<g style="display:none">', "</g>")), "v_B3"),
    ("visibility hidden", mark("v_B3", within('<g visibility="hidden">', "</g>")), "v_B3"),
    ("opacity 0", mark("v_B3", having('opacity="0"')), "v_B3"),
    ("opacity 0 by steps", mark("v_B3", within('<g opacity=".4"><g opacity="40%">', "</g></g>")), "v_B3"),
    ("no stroke", mark("v_B3", having('stroke="none"')), "v_B3"),
    ("white stroke", mark("v_B3", having('stroke="#fefefe"')), "v_B3"),
    ("stroke of no width", mark("v_B3", having('stroke-width="0"')), "v_B3"),
    ("stroke as wide as a hand", mark("v_B3", having('stroke-width="90"')), "v_B3"),
    ("dashed away", mark("v_B3", having('stroke-dasharray="0.1 500"')), "v_B3"),
    ("clipped", mark("v_B3", having('clip-path="url(#tip)"')), "refused:clip-path"),
    ("masked", mark("v_B3", within('<g mask="url(#m)">', "</g>")), "refused:mask"),
    ("filtered", mark("v_B3", having('filter="url(#f)"')), "refused:filter"),
    ("point of no size", mark("velocity b3", having('r="0"')), "b3"),
    ("hidden right line, visible wrong one", hidden_right_visible_wrong, "v_B3"),
    ("a sheet over all", at_end(WIDE), "v_B3"),
    ("a sheet over all, wrong lines on it", at_end(WIDE + ARROW), "v_B3"),
    ("a white line over a vector", copy_of("v_B3", lambda t: re.sub(r' (class|data-[\w-]+|marker-end)="[^"]*"', "", having('stroke="#fff" stroke-width="4"')(t))), "v_B3"),
    ("a picture over all", at_end('<image x="0" y="0" width="297" height="210" href="x.png"/>'), "v_B3"),
    ("off the paper", whole('<g transform="translate(250)">', "</g>"), "v_B3"),
    # not drawn where it stands
    ("vector in defs", mark("v_B3", within("<defs>", "</defs>")), "v_B3"),
    ("vector in a symbol", mark("v_B3", within("<symbol>", "</symbol>")), "v_B3"),
    ("vector in a marker", mark("v_B3", within("<marker>", "</marker>")), "v_B3"),
    ("drawn by use", mark("v_B3", lambda t: "<defs>" + having('id="q"')(t) + '</defs><use href="#q" x="4"/>'), "refused:<use>"),
    ("in a foreignObject", mark("v_B3", within("<foreignObject>", "</foreignObject>")), "refused:<foreignObject>"),
    ("in a switch", mark("v_B3", within("<switch>", "</switch>")), "refused:<switch>"),
    ("for readers of one language", mark("v_B3", having('systemLanguage="de"')), "refused:systemLanguage"),
    ("in a nested svg", mark("v_B3", within('<svg viewBox="0 0 100 100">', "</svg>")), "refused:<svg>"),
    ("of another namespace", mark("v_B3", put("<line", '<line xmlns="urn:x"')), "v_B3"),
    ("a comment", mark("v_B3", within("<!--", "-->")), "v_B3"),
    # alive
    ("animateTransform", at_end('<animateTransform attributeName="transform" type="rotate" to="9"/>'), "refused:<animateTransform>"),
    ("set", mark("v_B3", put("</line>", '<set attributeName="x2" to="9"/></line>')), "refused:<set>"),
    ("script", at_end("<script>1</script>"), "refused:<script>"),
    ("an event", root(r"<svg", r'<svg onload="1"'), "refused:event"),
    # arrows
    ("vector turned round", mark("v_B3", turned_round), "v_B3"),
    ("head at the tail", mark("v_B3", put("marker-end", "marker-start")), "v_B3"),
    ("no head", mark("v_B3", having('marker-end="none"')), "v_B3"),
    ("heads at both ends", mark("v_B3", having('marker-start="url(#tip)"')), "v_B3"),
    ("head that does not turn", put('orient="auto"', 'orient="180"'), "v_B3"),
    ("head drawn backwards", put("M0 .2L2.8 .7L0 1.2Z", "M2.8 .2L0 .7L2.8 1.2Z"), "v_B3"),
    ("head beside its place", put('refX="3.2"', 'refX="0"'), "v_B3"),
    ("head that takes its paint from above", lambda text: put("<defs>", '<defs fill="#fff">')(put(' fill="#0b4f9c" stroke="none" /></marker>', " /></marker>")(text)), "v_B3"),
    ("head without ink", put('d="M0 .2L2.8 .7L0 1.2Z" fill="#0b4f9c"', 'd="M0 .2L2.8 .7L0 1.2Z" fill="none"'), "v_B3"),
    ("head far off its end", put('refX="3.2"', 'refX="9"'), "v_B3"),
    ("an arrow aside, alone on its line", mark("v_B3", aside(1.2)), "v_B3"),
    ("an arrow without a name", at_end(ARROW), "arrow"),
    ("one more arrow, wrong", copy_of("v_C", shifted(4)), "v_C"),
    ("one more arrow, longer", copy_of("v_C", having('x2="60"')), "v_C"),
    ("one more arrow, right", copy_of("v_C", lambda t: t), RIGHT),
    ("vectors' names exchanged", both(mark("v_C", put("v_C", "v_X")), both(mark("v_B3", put("v_B3", "v_C")), put("v_X", "v_B3"))), "v_"),
    ("measured by another site", mark("v_C", put('data-of="C@3"', 'data-of="D@3"')), "v_C"),
    # points
    ("vector deleted", mark("v_B3", gone), "v_B3"),
    ("point deleted", mark("velocity b3", gone), "b3"),
    ("point moved", mark("velocity b3", shifted(0.02)), "b3"),
    ("corner between arrows moved", mark("acceleration k'", shifted(0.02)), "k'"),
    ("point that says nothing", mark("velocity b3", lambda t: re.sub(r' data-(site|of)="[^"]*"', "", t)), "b3"),
    ("a teacher's point", at_end(NEW_POINT), RIGHT),
    ("lines without corners", at_end('<polygon points=""/><path d=""/><polyline points="3 4"/>'), RIGHT),
    ("a teacher's dot and words", at_end('<circle cx="50" cy="60" r="0.5"/><text x="50" y="60">?</text>'), RIGHT),
    ("one more point, wrong", copy_of("position B", shifted(3)), "B"),
    # numbers
    ("digits of no SVG reader", mark("v_B3", lambda t: re.sub(r'x1="(\d)', lambda m: f'x1="{chr(0xFF10 + int(m[1]))}', t)), "refused:length"),
    ("an underscore in a number", mark("v_B3", lambda t: re.sub(r'x1="(\d)', r'x1="\1_', t)), "refused:length"),
    ("millimetres in a length", mark("v_B3", lambda t: re.sub(r'x1="([^"]*)"', r'x1="\1mm"', t)), "v_B3"),
    ("a length of nan", mark("v_B3", lambda t: re.sub(r'x1="[^"]*"', 'x1="nan"', t)), "refused:length"),
    ("an exponent", mark("v_B3", lambda t: re.sub(r'x1="([^"]*)"', r'x1="\1e0"', t)), RIGHT),
    ("no coordinate", mark("v_B3", lambda t: re.sub(r' x1="[^"]*"', "", t)), "v_B3"),
    # paper
    ("a blank in the width", root('width="297mm"', 'width="297 mm"'), RIGHT),
    ("centimetres", root('width="297mm"', 'width="29.7cm"'), RIGHT),
    ("commas in the viewBox", root("0 0 297 210", "0,0,297,210"), RIGHT),
    ("another width", root('width="297mm"', 'width="280mm"'), "refused:viewBox"),
    ("no width", root('width="297mm"', ""), "refused:width"),
    ("percent", root('width="297mm"', 'width="100%"'), "refused:width"),
    ("half the viewBox", root("0 0 297 210", "0 0 148.5 105"), "v_B3"),
    ("preserveAspectRatio", root("<svg", '<svg preserveAspectRatio="none"'), "refused:preserveAspectRatio"),
    ("the sheet's own transform", root("<svg", '<svg transform="scale(2)"'), "refused:transform"),
    # letters
    ("printed scale deleted", lambda text: SCALE.sub("", text), "μ_v"),
    ("printed scale deleted once", lambda text: SCALE.sub("", text, count=1), "μv"),
    ("printed scale changed", lambda text: SCALE.sub(lambda m: m[0].replace("0.01", "0.02"), text), "μ_v"),
    ("printed scale white", lambda text: SCALE.sub(lambda m: m[0].replace("<text", '<text opacity="0"', 1), text), "μ_v"),
    ("a text with a thick pen", at_end('<text x="9" y="99" stroke="#fff" stroke-width="90">.</text>'), "refused:thick pen"),
    ("one more scale", at_end('<text x="20" y="20" font-size="3">μv = 0.03 (m/s)/mm</text>'), "μ_v"),
    ("two letters exchanged", exchanged, "letters"),
    ("a letter moved a little", lambda text: LETTER.sub(lambda m: m[1] + f"{float(m[2]) + 1:.4f}", text, count=1), RIGHT),
    ("a result changed", put(">0.2712<", ">0.3712<"), "0.2712"),
    ("a title of another mechanism", mechanism("Four-bar with a sliding pair", "Slider-crank"), "Slider-crank"),
    ("the sheet's own title changed", lambda text: TITLE.sub("Geneva drive", text), "title"),
    ("a value shown when pointed at changed", lambda text: TIP.sub("9.876", text, count=1), "tip"),
    ("letters in white over a polygon", at_end(GLYPHS), "refused:too light"),
    ("letters in a white outline over a polygon", at_end(OUTLINED), "refused:too light"),
    # what shows no length
    ("100 mm that are 67", some(HUNDRED, shorter), "100 mm"),
    ("100 mm that are 67, sealed anew", both(some(HUNDRED, shorter), resealed), "100 mm"),
    ("100 mm taken away", some(HUNDRED, gone), "ruler"),
    ("the driver's sense reversed", some(TURNS, reversed_head), "1: A"),
    ("the driver's sense reversed, sealed anew", both(some(TURNS, reversed_head), resealed), "1: A"),
    ("the driver's sense deleted", some(TURNS, gone), "1: A"),
    ("another link's sense reversed", some(TURNS, reversed_head, 1), "2: B"),
    ("another link's sense deleted", some(TURNS, gone, 1), "2: B"),
    ("a sense in white", some(TURNS, pale, 1), "2: B"),
    ("a construction line moved", some(CONSTRUCTION, shifted(1), -1), "signs 1: "),
    ("a construction line taken away", some(CONSTRUCTION, gone, -1), "signs 1: "),
    ("a construction line in white", some(CONSTRUCTION, pale, -1), "signs 1: "),
    ("everything moved, and one line more", both(whole('<g transform="translate(-6,4)">', "</g>"), some(CONSTRUCTION, shifted(1), -1)), "signs 1: "),
    ("an arrow as a path with its own head", at_end(OWN_ARROW), "arrow (60.0, 150.0)"),
    ("an arrow as a path that says it is a vector", at_end(OWN_ARROW.replace("<path", '<path class="vector"')), "arrow (60.0, 150.0)"),
    ("an arrow as a path in a paint of its own", at_end(OWN_ARROW.replace('"#0b4f9c"', '"url(#p)"')), "arrow (60.0, 150.0)"),
    ("a construction line dashed away", some(CONSTRUCTION, having('stroke-dasharray="0.1 500"'), -1), "signs 1: "),
    ("a construction line of no width", some(CONSTRUCTION, having('stroke-width="0.01"'), -1), "signs 1: "),
    ("a head alone", at_end('<polygon points="90,160 87,160 88,158"/>'), "arrow (90.0, 160.0)"),
    # what the file says of itself
    ("scale in the file, sealed anew", claims(lambda d: d["scales"].update(velocity=0.0101)), "v_B3"),
    ("drivers in the file, sealed anew", claims(lambda d: d.update(drivers=[1.05])), "v_B3"),
    ("mechanism in the file, sealed anew", mechanism("AB = 24", "AB = 24.1"), "v_B3"),
    ("speed in the file, sealed anew", mechanism("omega = 10", "omega = -10"), "v_B3"),
    ("a remark in the file, not sealed", claims(lambda d: d.update(mechanism=d["mechanism"] + "# x\n"), sealed=False), "changed"),
    ("a remark in the file, sealed anew", claims(lambda d: d.update(mechanism=d["mechanism"] + "# x\n")), RIGHT),
    ("a vector deleted and sealed anew", both(mark("v_C", gone), claims(undrawn("v_C"))), RIGHT),
    ("of another version", claims(lambda d: d.update(format=1)), "refused:another version"),
]  # fmt: skip

OTHERS: list[tuple[str, str, Change, str]] = [
    ("ex3-7", "guide of the frame moved", mark("link frame guide", having('y1="36" y2="36"')), "frame: ram"),
    ("p3-6b", "an arrow off its place aside", mark("v_C", aside(0.3)), "v_C"),
    ("p3-6b", "an arrow far aside", mark("v_C", aside(12)), "v_C"),
    ("p3-6b", "an arrow aside and along", mark("v_C", shifted(1.2)), "v_C"),
    ("ex3-7", "block turned", mark("link 5 block", having('transform="rotate(1)"')), "5: ram"),
    ("ex3-7", "head drawn backwards", put("M0 .2L2.8 .7L0 1.2Z", "M2.8 .2L0 .7L2.8 1.2Z"), "v_B3"),
    ("ex3-7", "points shifted against the links", all_points, "1: A B"),
    ("ex3-3", "a wheel of another size", mark("link 2 wheel", lambda t: re.sub(r'\br="[^"]*"', 'r="7"', t)), "2: "),
    ("ex3-3", "vector in defs", mark("v_C", within("<defs>", "</defs>")), "v_C"),
    ("fig3-4 centres", "a centre hidden", mark("centres P13", having('visibility="hidden"')), "P13"),
    ("fig3-4 centres", "a centre moved by transform", mark("centres P13", having('transform="translate(.1)"')), "P13"),
    ("fig3-4 centres", "a centre covered", at_end(WIDE.replace("210", "420")), "P13"),
    ("fig3-4 centres", "a link moved", mark("link 2 bar", shifted(0.5)), "2: "),
    ("fig3-4 centres", "one more mark, wrong", copy_of("centres P13", shifted(2)), "P13"),
    ("fig3-4 centres", "there and back", whole('<g transform="translate(3)"><g transform="translate(-3)">', "</g></g>"), RIGHT),
]  # fmt: skip

ROWS = [("ex3-1", *row) for row in EX3_1] + OTHERS


def said(path: Path) -> str:
    """What check says: "good", what is wrong, or why it refuses."""
    try:
        report = measure(path)
    except BadDrawing as error:
        return REFUSED + error.message("en")
    wrong = [entry.name for entry in report.measured if not entry.off_mm <= 0.01]
    return RIGHT if report.passed(0.01) else "; ".join([*wrong, *(f"{f.kind} {f.what}" for f in report.faults)])


def test_there_are_as_many_kinds_as_were_attacked():
    assert len({name for _, name, *_ in ROWS}) >= 68


@pytest.mark.parametrize(("of", "name", "change", "wanted"), ROWS, ids=[f"{row[0]}: {row[1]}" for row in ROWS])
def test_tampering(of: str, name: str, change: Change, wanted: str, tmp_path: Path):
    before = drawing(of)
    after = change(before)
    assert after != before, "nothing was done"
    path = tmp_path / "drawing.svg"
    path.write_text(after, encoding="utf-8")
    answer = said(path)
    if wanted == RIGHT:
        assert answer == RIGHT
    elif wanted.startswith(REFUSED):
        assert answer.startswith(REFUSED)
        assert wanted.removeprefix(REFUSED) in answer
    else:
        assert answer != RIGHT
        assert wanted in answer


@pytest.mark.parametrize("of", sorted({row[0] for row in ROWS}))
def test_untouched(of: str, tmp_path: Path):
    path = tmp_path / "drawing.svg"
    path.write_text(drawing(of), encoding="utf-8")
    assert said(path) == RIGHT


NOT_JUDGED = [
    ("an arrow of three lines", at_end(THREE_LINES), "other 3: (60.0, 150.0)"),
    ("a teacher's ring", at_end('<circle cx="50" cy="60" r="4" fill="none" stroke="#c00"/>'), "other 1: (54.0, 60.0)"),
    ("white over a construction line", at_end('<rect x="60" y="150" width="3" height="2" fill="#fff"/>'), "other 1: (60.0, 150.0)"),
    ("a line that says it is a vector", at_end('<path class="vector" d="M60 150L90 160" stroke="#000" fill="none"/>'), "other 1: (60.0, 150.0)"),
    ("a teacher's words", at_end('<text x="50" y="60" font-size="4">sign?</text>'), "words 1"),
]


@pytest.mark.parametrize(("name", "change", "note"), NOT_JUDGED, ids=[row[0] for row in NOT_JUDGED])
def test_what_is_added_is_said_not_to_be_judged(name: str, change: Change, note: str, tmp_path: Path):
    path = tmp_path / "drawing.svg"
    path.write_text(change(drawing("ex3-1")), encoding="utf-8")
    report = measure(path)
    assert report.passed(0.01)
    assert note in [f"{each.kind} {each.what}" for each in report.notes]
    for lang, begin in (("en", "not judged"), ("zh", "未判断")):
        assert sum(line.startswith(begin) for line in check_lines(report, lang)) == len(report.notes)


MISLEADING: dict[str, Change] = {
    "100 mm that are 67": some(HUNDRED, shorter),
    "100 mm taken away": some(HUNDRED, gone),
    "a sense reversed": some(TURNS, reversed_head),
    "the last sense reversed": some(TURNS, reversed_head, -1),
    "a sense taken away": some(TURNS, gone),
    "a construction line moved": some(CONSTRUCTION, shifted(0.5), -1),
    "a construction line taken away": some(CONSTRUCTION, gone, 7),
    "an arrow as a path": at_end(OWN_ARROW),
    "letters in white": at_end(GLYPHS),
    "another title": lambda text: TITLE.sub("Geneva drive", text),
}
EVERYTHING = int(os.environ.get("GRAPHKIN_RANDOM", "0"))
EACH = max(1, EVERYTHING // 400)
SHEETS = [*library.names()[::12], *((family, seed) for family in FAMILIES for seed in range(EACH))][:: 1 if EVERYTHING else 5]


@pytest.mark.parametrize("of", SHEETS, ids=str)
def test_what_misleads_is_seen_on_any_sheet(of: str | tuple[str, int], tmp_path: Path):
    mechanism = library.load(of) if isinstance(of, str) else make(*of)
    text = drawing(of) if isinstance(of, str) else drawn(*of)
    assert text is not None
    assert not wrong(read_back(tmp_path, text, mechanism))
    for name, change in [*MISLEADING.items()][0 if EVERYTHING else SHEETS.index(of) % 3 :: 1 if EVERYTHING else 3]:
        if "sense" in name and not re.search(TURNS, text):
            continue
        try:
            assert wrong(read_back(tmp_path, change(text), mechanism)), name
        except BadDrawing:
            pass
