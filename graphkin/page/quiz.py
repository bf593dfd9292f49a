"""Questions on a mechanism at its drawn position, in the order of its drawing, with the answers that mistakes give.

Asked are the direction of each line that a vector equation is closed by, that of each arrow calculated and laid off,
each rotation that is read off, and what the file asks for. The data hold by question:

    kind      "line" (a direction of 180 degrees), "arrow" (of 360), "value"
    plane, act, name   the plane; the act of the pencil before which a direction, after which a value is asked; of what
    point     of the plane, through which the line goes, or at which the arrow begins; from   its letter
    right     the direction [deg, counter-clockwise from x], or the value in `unit`
    tolerance of a value; sense   "turn" where a value turns one way or the other, "sign" where it has a sign, else ""
    dimension of a value: its SI unit
    wrong     what mistakes give instead: [direction or value, numbers of mistakes]
    words     the answer: of a direction, the sentence of the solution that draws it

and `mistakes`, in words; `at`: the drivers' values there [rad, m]. All words are HTML in both languages.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

import numpy as np

from graphkin.base.geometry import Value, number, place
from graphkin.base.plain import Plain
from graphkin.base.value import frozen
from graphkin.construction import Construction, Drawn, LayOff, Meet, Plane, Plot, Ray, Step
from graphkin.errors import Lang
from graphkin.files.values import DIMENSIONS, UNITS
from graphkin.homework.grading.keys import marking_of
from graphkin.marking.answers import arrows_of, readable
from graphkin.marking.consequences import rewrites
from graphkin.marking.diagnosis import rarity
from graphkin.marking.drawing_order import drawing_order
from graphkin.marking.hand import Redrawing, redraw
from graphkin.marking.key import Key, KeyEntry, Name, columns, upright
from graphkin.marking.key_making import make_key
from graphkin.marking.mistakes import directions
from graphkin.marking.rewrite import Mistaken, Rewrite
from graphkin.marking.scene import Scene
from graphkin.model.quantities import EDGE, Quantity, Rotation, Unit
from graphkin.outputs.letters import lettered
from graphkin.outputs.typesetting import html_words
from graphkin.planning import Method
from graphkin.planning.method import pages
from graphkin.say import names, numbers
from graphkin.say.catalogue import LANGUAGES, say
from graphkin.say.entry import Sentence
from graphkin.say.explained import derivation
from graphkin.say.marks import mistake_in_signs

TOLERANCE_DEG = 2.0
"""A direction that is off by less is right, and one that a mistake turns by less is not told from the right one."""
_MOST = 2  # mistakes that are named for one answer


def quiz(method: Method, plot: Plot, scales: Mapping[str, float]) -> dict[str, Plain]:
    """The questions, as data of a page; scales: of the drawing, as a mechanism file has them."""
    key = make_key(method, marking_of(method, scales=scales), marks=False)
    every = _Questions(method, plot, key, scales)
    questions: list[Plain] = [*every.questions()]
    drawn: list[Plain] = [number(value) for value in method.facts(None).values]
    return {"questions": questions, "mistakes": every.mistakes, "tolerance": TOLERANCE_DEG, "units": _units(),
            "at": drawn}  # fmt: skip


def _units() -> list[Plain]:
    """The units that may be chosen: name in print, SI unit of their kind, and by how much the shown value is larger."""
    chosen = ("deg", "rad", "mm", "m", "rad/s", "r/min", "m/s", "mm/s", "rad/s²", "m/s²", "mm/s²")
    by_name = {name: (unit, *UNITS[dimension][name]) for unit, dimension in DIMENSIONS.items()
               for name in UNITS[dimension]}  # fmt: skip
    units = ((name, *by_name[name]) for name in chosen)
    return [{"name": name.replace("deg", "°"), "kind": unit, "times": times / divided * EDGE[unit].factor}
            for name, unit, times, divided in units]  # fmt: skip


class _Recorder(Mistaken):
    """Notes the direction of each line that it draws."""

    def __init__(self, made: Sequence[Sequence[Rewrite]]) -> None:
        super().__init__(made)
        self.lines: dict[tuple[Plane, Meet, Ray], Value] = {}

    def line(self, plot: Redrawing, plane: Plane, step: Meet, ray: Ray, right: Value) -> Value:
        self.lines[plane, step, ray] = drawn = super().line(plot, plane, step, ray, right)
        return drawn


@frozen
class _Questions:
    """All questions on one mechanism; mistakes: those that a question names, in words."""

    method: Method
    plot: Plot
    key: Key
    scales: Mapping[str, float]

    @cached_property
    def mistakes(self) -> list[Plain]:
        return []

    @cached_property
    def _texts(self) -> frozenset[str]:
        return frozenset(entry.text for entry in self.key.entries)

    @cached_property
    def _number(self) -> dict[str, int]:
        """The numbers of mistakes by their English words: those that are said alike are one."""
        return {}

    @cached_property
    def _sentences(self) -> dict[Lang, dict[int, str]]:
        """The sentence of each act that the solution needs, by language and page."""
        said: dict[Lang, dict[int, str]] = {}
        for lang in LANGUAGES:
            entries = derivation(self.method, self.plot, self.scales, lang, everything=False, as_planned=True)
            acts = ((entry.act, entry.text) for entry in entries if isinstance(entry, Sentence))
            said[lang] = {act.page: text for act, text in acts if act is not None and act.numbered}
        return said

    def questions(self) -> Iterator[Plain]:
        """In the order of the drawing: a value after the act that gives it."""
        asked = list(self._values())
        rank = 0.0
        for construction in (self.method.velocity, self.method.acceleration):
            for step in construction.steps:
                rank += 1
                yield from (value for at, value in asked if rank - 1 < at < rank)
                yield from self._directions(construction, step)
                yield from (value for at, value in asked if at == rank)
            rank += 1
            yield from (value for at, value in asked if at == rank)
        yield from (value for at, value in asked if at > rank)

    # --- directions ---------------------------------------------------------------------------

    @cached_property
    def _drawn(self) -> tuple[list[Name], _Recorder, Redrawing]:
        """The drawing with every mistake that can be made, the right one first."""
        made = rewrites(self.method, self.plot, (), self.key.marking.scales)
        hand = _Recorder([(), *((one,) for one in made)])
        with np.errstate(divide="ignore", invalid="ignore"):
            drawn = redraw(self.method, hand.placed(self.method, self.plot), hand, hand.shape)
        return [one.name for one in made], hand, drawn

    @cached_property
    def _named(self) -> dict[tuple[Plane, Meet, Ray], str]:
        """The unknown arrow of each direction line."""
        scene, polygons = Scene(self.method, self.plot), (self.method.velocity.plane, self.method.acceleration.plane)
        return {(plane, meet, ray): name for plane in polygons for meet, ray, name in directions.rays(scene, plane)}

    def _directions(self, construction: Construction, step: Step) -> Iterator[Plain]:
        plane, (_, hand, drawn) = construction.plane, self._drawn
        page = pages(self.method).get((plane, step), 0)
        if any(page not in said for said in self._sentences.values()):
            return
        points = drawn.points(plane)
        if isinstance(step, Meet):
            both = (ray for ray in (step.first, step.second) if isinstance(ray, Ray))
            rays = [ray for ray in both if (plane, step, ray) in hand.lines]
            if any(self._lasts(plane, points[step.point] - points[ray.through]) for ray in rays):
                for ray in rays:  # lines that cross where both begin are not drawn
                    name, line = self._named[plane, step, ray], hand.lines[plane, step, ray]
                    yield self._direction("line", plane, page, name, ray.through, line)
        elif isinstance(step, LayOff) and not (step.backwards or isinstance(step.term.size, Drawn)):
            arrow = points[step.tip] - points[step.start]
            if self._lasts(plane, arrow):
                yield self._direction("arrow", plane, page, step.term.name(plane), step.start, arrow)

    def _lasts(self, plane: Plane, arrow: Value) -> bool:
        """True of an arrow that is something beside the largest of its plane, where it is drawn right."""
        largest = max(float(abs(place(value))) for value in self.plot.points(plane).values())
        return bool(abs(np.ravel(arrow)[0]) > _NOTHING * largest)

    def _direction(self, kind: str, plane: Plane, page: int, name: str, point: str, vector: Value) -> Plain:
        made, turn = self._drawn[0], 180.0 if kind == "line" else 360.0
        angles = np.broadcast_to(np.degrees(np.angle(vector)), (len(made) + 1,))
        length = np.broadcast_to(np.abs(vector), angles.shape)
        right = float(angles[0]) % turn
        off = (angles[1:] - right + turn / 2) % turn - turn / 2
        there = np.isfinite(off) & (length[1:] > _NOTHING * length[0]) & (np.abs(off) > TOLERANCE_DEG)
        wrong = {k: round((right + float(off[k])) % turn, 2) for k in np.flatnonzero(there).tolist()}
        words: dict[str, Plain] = {lang: self._html(said[page]) for lang, said in self._sentences.items()}
        return {
            "kind": kind, "plane": plane, "act": page, "name": self._html(names.vector(name)), "point": point,
            "from": self._html(names.point(point)), "right": round(right, 3),
            "wrong": self._wrong(name, made, wrong), "words": words,
        }  # fmt: skip

    # --- values -------------------------------------------------------------------------------

    def _values(self) -> Iterator[tuple[float, Plain]]:
        """The values that are asked, each with its place in the drawing."""
        mechanism, arrows = self.method.mechanism, arrows_of(self.method)
        read = [readable(mechanism, entry.text) for entry in self.key.entries]
        quantities = [quantity for quantity in read if quantity is not None]
        places = iter(drawing_order(self.method, quantities, arrows))
        turned = set[tuple[str, str]]()  # links that keep their angle to one another turn alike
        for column, (quantity, entry) in enumerate(zip(read, self.key.entries, strict=True)):
            if quantity is None:
                continue
            at, chosen = next(places), bool(entry.points)
            if isinstance(quantity, Rotation) and quantity.word != "theta":
                rotation = quantity.word, self.method.structure.base(quantity.link)
                chosen = rotation not in turned
                turned.add(rotation)
            if chosen and entry.doubt in ("", "steep") and np.isfinite(entry.right):
                yield at.rank, self._value(column, quantity, entry, at.rank)

    def _value(self, column: int, quantity: Quantity, entry: KeyEntry, rank: float) -> Plain:
        unit, table = EDGE[entry.unit], columns(self.key.entries)
        given = upright(table, self.key.singles.values)[:, column]
        allowed = max(entry.allowed, entry.tolerance)
        with np.errstate(invalid="ignore"):
            moved = np.isfinite(given) & (np.abs(given - entry.right) > allowed)
        wrong = {k: float(f"{given[k] * unit.factor:.4g}") for k in np.flatnonzero(moved).tolist()}
        turns = isinstance(quantity, Rotation) and quantity.word != "theta"
        plane, page = self._plane_and_page(rank)
        return {
            "kind": "value", "plane": plane, "act": page, "name": self._html(names.symbols(entry.text)),
            "quantity": entry.text, "right": float(f"{entry.right * unit.factor:.6g}"), "unit": unit.sign,
            "dimension": entry.unit,
            "tolerance": float(f"{allowed * unit.factor:.3g}"), "turn": 360.0 if entry.sort == "angle" else 0.0,
            "sense": "turn" if turns else "sign" if entry.sort == "sense" else "",
            "words": {lang: self._answer(entry, unit, turns, lang) for lang in LANGUAGES},
            "wrong": self._wrong(entry.text, [row[0] for row in self.key.singles.names], wrong),
        }  # fmt: skip

    def _answer(self, entry: KeyEntry, unit: Unit, turns: bool, lang: Lang) -> str:
        """`The answer: ω3 = 3.92 rad/s, clockwise`"""
        size = number(entry.right * unit.factor)
        sense = f", {say('quiz.ccw' if size > 0 else 'quiz.cw', lang)}" if turns else ""
        after = unit.sign if unit.sign in ("", "°") else f" {unit.sign}"
        value = numbers.number(abs(size) if turns else size, 1e-9)
        return say("quiz.answer", lang, answer=f"{self._html(names.symbols(entry.text))} = {value}{after}{sense}")

    def _plane_and_page(self, rank: float) -> tuple[Plane, int]:
        """The plane in which a value is drawn, and the act that gives it."""
        count = 0.0
        before: tuple[Plane, int] = ("position", sum(act.plane == "position" for act in self.method.acts))
        for construction in (self.method.velocity, self.method.acceleration):
            for step in construction.steps:
                count += 1
                if count > rank:
                    return before
                page = pages(self.method).get((construction.plane, step))
                before = (construction.plane, page or before[1])
            count += 1
        return before

    # --- words --------------------------------------------------------------------------------

    def _html(self, text: str) -> str:
        return html_words(lettered(text, self.method.mechanism.points))

    def _wrong(self, asked: str, made: Sequence[Name], values: Mapping[int, float]) -> list[Plain]:
        """Each value that mistakes give, with the numbers of the likeliest: made with what is asked, common."""

        def unlikely(k: int) -> tuple[bool, int]:
            id, _, of, _ = made[k]
            return of != (asked,), rarity(id)

        by_value: dict[float, dict[int, None]] = {}
        for k in sorted(values, key=unlikely):
            named = by_value.setdefault(values[k], {})
            if len(named) < _MOST:
                named[self._mistake(made[k])] = None
        return [[value, [*named]] for value, named in by_value.items()]

    def _mistake(self, name: Name) -> int:
        """The number of a mistake in the page's list."""
        en, zh = (self._html(mistake_in_signs(name, self._texts, lang)) for lang in LANGUAGES)
        if en not in self._number:
            self._number[en] = len(self.mistakes)
            self.mistakes.append({"en": en, "zh": zh})
        return self._number[en]


_NOTHING = 1e-6
"""An arrow that is shorter, as a part of the largest, or of what it would be, points nowhere."""
