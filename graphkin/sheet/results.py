"""Tables of a sheet: results, those that were asked for in bold; or what a problem gives and asks."""

from __future__ import annotations

from itertools import pairwise
from typing import assert_never

from graphkin.base.value import frozen
from graphkin.construction import Node, Plot
from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import (
    Centre,
    Component,
    Displacement,
    Moving,
    Place,
    Quantity,
    Quotient,
    Rotation,
    Track,
)
from graphkin.model.quantities.reading import read
from graphkin.model.usual import Usual
from graphkin.planning import Method
from graphkin.say.catalogue import say
from graphkin.say.dimensions import dimensions
from graphkin.say.reading import Reading
from graphkin.sheet.lettering import (
    Label,
    Run,
    bold,
    formula,
    joined,
    link_label,
    number,
    plain,
    point_label,
    quantity_label,
    vector_label,
)
from graphkin.sheet.text_blocks import WrittenLines
from graphkin.sheet.titleblock import SIZE, Table

_SENSE: dict[Lang, tuple[str, str]] = {"en": ("ccw", "cw"), "zh": ("逆", "顺")}


def _speed(usual: Usual, value: float) -> Label:
    return number(usual.motion(value, "velocity"))


def _acceleration(usual: Usual, value: float) -> Label:
    return number(usual.motion(value, "acceleration"))


@frozen
class _Results:
    """The tables in the making."""

    method: Method
    plot: Plot
    lang: Lang
    usual: Usual

    def asked(self, name: str, *quantities: str) -> bool:
        """Whether the problem asks for one of these quantities of what bears the name."""
        words = [text.replace("/", " ").split() for text in self.method.mechanism.ask]
        return any(pair[0] in quantities and pair[1] == name for told in words for pair in pairwise(told))

    def told(self, name: str, label: Label, quantity: str) -> Label:
        """A value, in bold where it is asked for."""
        return bold(label) if self.asked(name, quantity) else label

    def links(self) -> Table:
        """Angular velocities and accelerations, and their sense in a column of its own."""
        machine, plot = self.method.mechanism, self.plot
        head = (
            plain({"en": "link", "zh": "构件"}[self.lang]), _unit(quantity_label("ω", ""), "rad/s"), (),
            _unit(quantity_label("α", ""), "rad/s²"), (),
        )  # fmt: skip
        rows = []
        for name in (name for name in machine.moving if name in plot.omega):
            called = machine.called(name)
            label = link_label(called)
            row = [bold(label) if self.asked(called, "omega", "alpha", "theta") else label]
            turns = (self.usual.rate(float(plot.omega[name]), "velocity"),
                     self.usual.rate(float(plot.alpha[name]), "acceleration"))  # fmt: skip
            for kind, value in zip(("omega", "alpha"), turns, strict=True):
                row += [self.told(called, one, kind) for one in self.turning(value)]
            rows.append(tuple(row))
        return Table(head, tuple(rows))

    def turning(self, value: float) -> tuple[Label, Label]:
        """`3.919` and `cw`."""
        if not value:
            return plain("0"), ()
        return number(abs(value)), plain(_SENSE[self.lang][value < 0])

    def points(self) -> Table:
        """Speeds and accelerations of the moving points."""
        word = {"en": "point", "zh": "点"}[self.lang]
        head = (plain(word), _unit(quantity_label("v", ""), "m/s"), _unit(quantity_label("a", ""), "m/s²"))
        method, plot, usual = self.method, self.plot, self.usual
        primed = {node.of: name for name, node in method.acceleration.nodes.items() if node.site is not None}
        rows = []
        for node in method.velocity.nodes.values():
            if node.of in primed and _moves(method, node):
                label = point_label(node.of)
                speed = _speed(usual, abs(plot.velocity[node.name]))
                other = _acceleration(usual, abs(plot.acceleration[primed[node.of]]))
                name = bold(label) if self.asked(node.of, "v", "a") else label
                rows.append((name, self.told(node.of, speed, "v"), self.told(node.of, other, "a")))
        return Table(head, tuple(rows))

    def parts(self) -> Table:
        """Relative motions of coincident points: velocity, Coriolis and relative acceleration."""
        head = (
            plain(""), _unit(quantity_label("v", "", "r"), "m/s"), _unit(quantity_label("a", "", "k"), "m/s²"),
            _unit(quantity_label("a", "", "r"), "m/s²"),
        )  # fmt: skip
        found: list[tuple[Label, ...]] = []
        arrows = self.method.acceleration.vectors()
        at, usual = self.plot.acceleration, self.usual
        for name, term in self.method.velocity.vectors().items():
            low = name.partition("_")[2]
            pair = [arrows.get(f"a^{part}_{low}") for part in ("k", "r")]
            if not any(pair):
                continue
            label, spoken = _pair_label(low), "".join(run.text for run in _pair_label(low))
            speed = _speed(usual, abs(self.plot.velocity[term.head] - self.plot.velocity[term.tail]))
            sizes = [_acceleration(usual, abs(at[t.head] - at[t.tail])) if t else plain("") for t in pair]
            values = zip((speed, *sizes), ("v", "a_k", "a_r"), strict=True)
            first = bold(label) if self.asked(spoken, "v", "a_k", "a_r") else label
            found.append((first, *(self.told(spoken, value, kind) for value, kind in values)))
        told = [k for k in range(len(head)) if not k or any(run.text for row in found for run in row[k])]
        return Table(tuple(head[k] for k in told), tuple(tuple(row[k] for k in told) for row in found))

    def slide(self, name: str) -> Label:
        """What people call it; a name of the file in italics."""
        title = self.method.mechanism.slide_title(name, self.lang)
        return plain(title, title.isascii())

    def slides(self) -> Table:
        """Displacements that have a name, with their rates."""
        head = (
            plain(""), _unit(plain("s", True), "mm"), _unit(plain("ds/dt", True), "m/s"),
            _unit(plain("d²s/dt²", True), "m/s²"),
        )  # fmt: skip
        plot, usual = self.plot, self.usual
        rows = (
            (
                bold(self.slide(slide.name)) if self.asked(slide.name, "s") else self.slide(slide.name),
                self.told(slide.name, number(1000 * float(plot.s[slide.name])), "s"),
                _speed(usual, float(plot.s_rate.get(slide.name, 0.0))),
                _acceleration(usual, float(plot.s_acceleration.get(slide.name, 0.0))),
            )
            for slide in self.method.mechanism.slides
            if slide.named and slide.name in plot.s
        )
        return Table(head, tuple(rows))


def tables(method: Method, plot: Plot, lang: Lang) -> list[Table]:
    """Links, points, coincident points, slides; empty ones left out."""
    results = _Results(method, plot, lang, method.mechanism.usual)
    found = (results.links(), results.points(), results.parts(), results.slides())
    return [table for table in found if table.rows]


def _unit(label: Label, unit: str) -> Label:
    return (*label, Run(f" [{unit}]"))


def _moves(method: Method, node: Node) -> bool:
    """Whether a point of the polygon is a named point of a moving link."""
    unnamed = method.mechanism.unnamed
    return node.site is not None and node.site.point not in unnamed and node.site.link != FRAME


def _pair_label(low: str) -> Label:
    """`B3B2` as a row's name: the subscript of a relative velocity."""
    return tuple(Run(run.text, run.italic) for run in vector_label(f"v_{low}")[1:])


_WIDE = 62.0
"""Lines of what is given are no longer [mm]."""


def given_tables(reading: Reading) -> list[Table]:
    """Dimensions and driven rates; what is asked for. Empty ones left out."""
    given = WrittenLines.of([formula(text) for text in dimensions(reading)], _WIDE, SIZE).lines
    asked = WrittenLines.of([_asked(reading, text) for text in reading.mechanism.ask], _WIDE, SIZE).lines
    found = ((say("sheet.given", reading.lang), given), (say("sheet.find", reading.lang), asked))
    return [Table((plain(head),), tuple((line,) for line in lines)) for head, lines in found if lines]


def _asked(reading: Reading, text: str) -> Label:
    """A question as the field writes it; what is no quantity, as the file does."""
    quantity = read(reading.mechanism, text)
    return plain(text) if quantity is None else label_of(quantity)


def label_of(quantity: Quantity, over: str = " / ") -> Label:
    """A quantity as the field writes it: `theta 3` as θ₃, `a_k B3B2` as a with k above B3B2."""
    match quantity:
        case Quotient():
            return joined([label_of(half) for half in quantity.halves], over)
        case Rotation() | Displacement() | Place() | Track() | Moving() | Component():
            return quantity_label(quantity.letter, quantity.of.replace(",", ", ").replace("@", " "), quantity.part)
        case Centre():
            return quantity_label("P", quantity.text.removeprefix("P"))
        case _:
            assert_never(quantity)
