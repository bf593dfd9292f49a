"""The elements of a mechanism that plays, before anything moves: figures, bars, steps, results, layers, quiz.

The scripts find them by their data, and move them; each mark of a figure stands in the order of its rows.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from html import escape
from typing import assert_never
from urllib.parse import quote

from graphkin.base.plain import Plain
from graphkin.base.value import filled
from graphkin.construction import Plane
from graphkin.errors import Lang
from graphkin.outputs.stated import stated
from graphkin.outputs.typesetting import html_words, mm, runs, short, signs
from graphkin.page.elements import Attributes, element, in_languages, tick_box, worded
from graphkin.page.figures import OWN, layer_of
from graphkin.page.layers import CentreTrack, MovingLayers
from graphkin.page.rows import MarkTrack
from graphkin.say.catalogue import LANGUAGES, say
from graphkin.sheet.lettering import Label, vector_label
from graphkin.sheet.marks import ArcMark, Disc, PointMark, Stroke, Text, VectorMark


def page_head(titles: Mapping[str, Mapping[Lang, str]]) -> str:
    """The head of a page, and the room for a mechanism; titles: by the names of mechanisms."""
    buttons = (_button("language", "page.language"), _button("print", "page.print"))
    head = element("header", {"class": "top"}, element("h1", {"id": "title"}), *buttons)
    links = (element("a", {"href": f"#show={quote(name)}", "data-show": name}, in_languages(title))
             for name, title in titles.items())  # fmt: skip
    entries = element("ol", {}, *(element("li", {}, link) for link in links))
    contents = element("details", {}, worded("summary", "page.contents"), entries)
    nav = element("nav", {"id": "contents", "data-word-label": "page.contents"}, contents) if len(titles) > 1 else ""
    return head + nav + element("main", {"id": "page"})


@filled
class PlayerElements:
    """The elements of one mechanism, which are added while its data are made."""

    figures: list[str]
    bars: list[str]
    results: list[str]
    diagrams: list[str]
    switched: list[str]

    def html(self, layers: MovingLayers | None, quiz: Mapping[str, Plain]) -> str:
        """The whole, with what lies over the mechanism and the quiz."""
        position, *polygons = self.figures
        together = element("div", {"class": "polygons", "tabindex": 0, "role": "group"}, *polygons)
        shown = element("div", {"data-shown": "diagrams", "hidden": True}, *self.diagrams)
        figures = (position, together, element("div", {"class": "diagrams"}, shown))
        return element("div", {"class": "player"}, element("div", {"class": "figures"}, *figures),
                       element("div", {"class": "panels"}, *self._panels(layers, quiz)), self._driving())  # fmt: skip

    def _panels(self, layers: MovingLayers | None, quiz: Mapping[str, Plain]) -> Iterator[str]:
        yield _steps()
        yield element("p", {"class": "told", "role": "status"})
        yield _panel("results", "page.values", element("table", {}, element("tbody", {}, *self.results)))
        own = (tick_box({"data-toggle": layer, "checked": True}, worded("span", f"page.layer {layer}"))
               for layer in OWN if layer in self.switched)  # fmt: skip
        over = element("div", {"class": "overlays"}, *_overlay_switches(layers, bool(self.diagrams)))
        yield _panel("layers", "page.layers", *own, over)
        if quiz["questions"]:
            yield element("div", {"class": "panel"}, _quiz(quiz))

    def _driving(self) -> str:
        run = worded("button", "page.play", {"type": "button", "class": "run", "data-action": "run"})
        return element("div", {"class": "bars"}, run, *self.bars, worded("p", "page.keys", {"class": "keys"}))


def _panel(name: str, word: str, *inside: str) -> str:
    heading = worded("h2", word, {"id": f"{name}-heading"})
    return element("section", {"class": f"panel {name}", "aria-labelledby": f"{name}-heading"}, heading, *inside)


def _steps() -> str:
    signed = {"back": "◀", "next": "▶"}
    arrows = [element("button", {"type": "button", "data-action": act, "data-word-label": f"page.{act}"}, sign)
              for act, sign in signed.items()]  # fmt: skip
    whole = worded("button", "page.whole", {"type": "button", "data-action": "whole"})
    number = element("span", {"class": "step-number", "aria-live": "polite"})
    row = element("div", {"class": "row"}, *arrows, whole, number)
    return _panel("steps", "page.steps", row, element("div", {"class": "step-text"}))


# --- figures


def figure(plane: Plane, scale: float, size: complex, written: Label, marks: Iterable[str]) -> str:
    """A plane on a paper of its own [mm]."""
    data: Attributes = {"data-plane": plane, "data-scale": repr(scale)}
    paper: Attributes = {
        "viewBox": f"0 0 {size.real:g} {size.imag:g}", "class": "drawing", "role": "group",
        "data-word-label": f"page.{plane}", "font-family": "Times New Roman, Liberation Serif, Tinos, serif",
        "stroke-linejoin": "round", "stroke-linecap": "round", **data,
    }  # fmt: skip
    heading = element("h2", {}, worded("span", f"page.{plane}"), " ")
    header = element("header", {}, heading, element("span", {"class": "scale"}, html_words(written)))
    reasons = {"far": "page.not reached" if plane == "position" else "page.too large", "unsure": "page.not drawn"}
    notes = (worded("p", words, {"class": f"note {kind}"}) for kind, words in reasons.items())
    drawing = element("svg", paper, element("g", data, *marks))
    return element("section", {"class": f"figure {plane}"}, header, drawing, *notes)


def kind_of(row: MarkTrack) -> str:
    """The kind of element that a row is."""
    match row.mark:
        case Stroke(closed=closed):
            return "body" if row.form else "line" if closed or row.numbers.shape[1] != 4 else "segment"
        case Disc():
            return "circle"
        case ArcMark():
            return "arc"
        case Text():
            return "text"
        case VectorMark():
            return "vector"
        case PointMark():
            return "point"
        case _:
            assert_never(row.mark)


_ELEMENTS = {"line": "path", "arc": "path", "segment": "line", "circle": "circle"}


def mark_element(row: MarkTrack, paint: Mapping[str, str]) -> str:
    """A mark that the page moves: what it says of itself, as in drawing files."""
    mark, kind = row.mark, kind_of(row)
    own: Attributes = {"data-step": mark.step, "data-layer": layer_of(mark) or None}
    match mark:
        case VectorMark():
            head = element("path", {"class": "head", "fill": paint["stroke"], "stroke": "none"})
            spoken = "".join(sign.plain for sign in signs(vector_label(mark.name)))
            aloud = {"role": "img", "aria-label": spoken}
            line = {**paint, **_statement(mark), "data-also": " ".join(mark.also) or None, **aloud}
            parts = element("line", {"class": "grasp"}), head, element("line", line)
            return element("g", {"class": "arrow", "data-vector": mark.name, **own}, *parts)
        case Text():
            return element("text", {**paint, **own}, *_spans(mark))
        case PointMark():
            return element("circle", {"r": mark.radius, **paint, **_statement(mark), **own})
        case Stroke() if row.form:
            return element("path", {"d": _path(row.form, mark), "vector-effect": "none", **paint, **own})
        case _:
            return element(_ELEMENTS[kind], {**paint, **own})


def _path(places: Sequence[complex], mark: Stroke) -> str:
    return "M" + "L".join(f"{mm(at.real)} {mm(at.imag)}" for at in places) + ("Z" if mark.closed else "")


def _spans(mark: Text) -> Iterator[str]:
    for span in runs(replace(mark, at=0j)):
        place: Attributes = {"x": round(span.at.real, 2), "y": round(span.at.imag, 2), "font-size": short(span.size)}
        yield element("tspan", {**place, "font-style": "italic" if span.italic else None}, escape(span.text))


def _statement(mark: PointMark | VectorMark) -> dict[str, str]:
    kind = "vector" if isinstance(mark, VectorMark) else "point"
    return {"class": kind, **{f"data-{key}": value for key, value in stated(mark).items()}}


# --- drivers, results


def driver(number: int, name: str, unit: str, ends: tuple[float, float], events: Iterable[float]) -> str:
    """A driver's bar with a tick at each dead point and change point, and its field; in its unit."""
    low, high = ends
    ticks = [element("line", {"class": "tick", "x1": at, "x2": at, "y2": 1})
             for at in (100 * (event - low) / (high - low) for event in events)]  # fmt: skip
    marked = {"class": "ticks", "viewBox": "0 0 100 1", "preserveAspectRatio": "none", "aria-hidden": "true"}
    named: Attributes = {"data-driver": name, "data-word-label": "page.drive", "step": "any"}
    bar = element("input", {"type": "range", "min": low, "max": high, "id": f"bar-{number}", **named})
    field = element("input", {"type": "number", "class": "value", "data-value": name, **named, "data-driver": None,
                              "data-name": name})  # fmt: skip
    return element(
        "div", {"class": "driver"}, element("label", {"for": f"bar-{number}"}, escape(name)),
        element("span", {"class": "bar"}, bar, element("svg", marked, *ticks)), field,
        element("span", {"class": "unit"}, unit), element("p", {"class": "event", "role": "status"}),
    )  # fmt: skip


def result(name: str, label: Label) -> str:
    head = element("th", {"scope": "row"}, html_words(label))
    return element("tr", {}, head, element("td", {"data-result": name}))


# --- what is switched on and off


def _overlay_switches(layers: MovingLayers | None, diagrams: bool) -> Iterator[str]:
    """The switches of what lies over the mechanism, and of the diagrams beside it."""
    every = [("centres", "", "")] if layers and layers["centres"] else []
    if layers:
        every += [("curve", one["name"], one["label"]) for one in layers["curves"]]
        every += [("centrode", one["link"], one["link"]) for one in layers["centrodes"]]
    every += [("diagrams", "", "")] if diagrams else []
    for kind, of, label in every:
        words = {lang: say(f"layers.show {kind}", lang, name=label) for lang in LANGUAGES}
        yield tick_box({"data-toggle": kind, "data-of": of or None}, in_languages(words))


def overlay_drawing(layers: MovingLayers) -> str:
    """The drawing over the mechanism, hidden at first."""
    centres = _shown("centres", "", *(_centre(one) for one in layers["centres"]))
    curves = (_shown("curve", one["name"], *_paths(one["pieces"])) for one in layers["curves"])
    rolling = (_shown("centrode", one["link"], element("g", {"class": "centrode-fixed"}, *_paths(one["fixed"])),
                      element("g", {"class": "centrode-moving"}, *_paths(one["moving"])))
               for one in layers["centrodes"])  # fmt: skip
    return element("g", {"class": "layers-drawn"}, centres, *curves, *rolling)


def _shown(kind: str, of: str, *inside: str) -> str:
    return element("g", {"class": kind, "data-shown": kind, "data-of": of or None, "hidden": True}, *inside)


def _paths(pieces: Iterable[str]) -> Iterable[str]:
    return (element("path", {"d": piece}) for piece in pieces)


def _centre(centre: CentreTrack) -> str:
    low = element("tspan", {"dy": 0.8, "class": "low"}, escape(centre["name"][1:]))
    dot, letter = element("circle", {"r": 1}), element("text", {"x": 1.6, "y": -1.2}, "P", low)
    kind = "centre centre-frame" if centre["frame"] else "centre"
    return element("g", {"class": kind, "data-name": centre["name"]}, dot, letter)


# --- quiz


def _quiz(quiz: Mapping[str, Plain]) -> str:
    """The beginning of the quiz, and the room for its questions, with the fields of all kinds of answers."""
    angle = _asked("angle", element("input", {"type": "number", "step": "any", "data-quiz-angle": True}), " °")
    number = _asked("number", element("input", {"type": "text", "inputmode": "decimal", "autocomplete": "off",
                                                "data-quiz-number": True}))  # fmt: skip
    units = quiz["units"]
    assert isinstance(units, list)
    offered = [str(unit["name"]) for unit in units if isinstance(unit, dict)]
    unit = _asked("unit", _chosen("unit", *(element("option", {"value": each}, each) for each in offered)))
    ways = (worded("option", f"quiz.{way}", {"value": way}) for way in ("ccw", "cw"))
    sense = _asked("sense", _chosen("sense", *ways))
    check = worded("button", "quiz.check", {"type": "submit", "data-action": "check"})
    form = element("form", {"novalidate": True}, angle, number, unit, sense, check)
    verdict = element("div", {"class": "quiz-verdict", "role": "status", "data-quiz-verdict": ""})
    acts = element("p", {"class": "quiz-buttons"}, _button("show-answer", "quiz.show"), " ",
                   _button("next-question", "quiz.next"), " ", _button("leave-quiz", "quiz.leave"))  # fmt: skip
    question: Attributes = {"data-quiz-question": True, "id": "quiz-question", "tabindex": -1}
    asked = element("div", {"class": "quiz-asked"}, element("p", {"class": "quiz-count"}), element("p", question), form,
                    verdict, acts)  # fmt: skip
    score = element("p", {"data-quiz-score": True})
    begin = element("div", {"class": "quiz-begin"}, score, _button("quiz", "quiz.start"))
    return element("section", {"class": "quiz", "data-quiz": "off"}, worded("h2", "quiz.title"), begin, asked)


def _asked(word: str, *field: str) -> str:
    return element("label", {"class": f"quiz-{word}"}, worded("span", f"quiz.{word}"), " ", *field)


def _chosen(word: str, *options: str) -> str:
    return element("select", {f"data-quiz-{word}": True}, worded("option", "quiz.choose", {"value": ""}), *options)


def _button(act: str, word: str) -> str:
    return worded("button", word, {"type": "button", "data-action": act})
