"""Tables of a sheet: results, those that were asked for in bold; or what a problem gives and asks."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from typing import assert_never

from graphkin.base.geometry import number as real
from graphkin.base.geometry import place
from graphkin.base.value import frozen
from graphkin.construction import Plane, Plot
from graphkin.errors import Lang
from graphkin.model import quantities as asked
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities.reading import read
from graphkin.model.units import EDGE
from graphkin.planning import Method
from graphkin.say.catalogue import say
from graphkin.say.dimensions import dimensions
from graphkin.say.reading import Reading
from graphkin.sheet import lettering
from graphkin.sheet.lettering import LABEL, Label, Run, bold, formula, number, plain, point_label, quantity_label
from graphkin.sheet.paper import KEYS
from graphkin.sheet.text_blocks import WrittenLines
from graphkin.sheet.titleblock import Table, TableBlock
from graphkin.sheet.window import PLANES

_Key = tuple[str, frozenset[str]]
_WIDE = 62.0  # lines of what is given are no longer [mm]


# --- results, as far as there is room ---------------------------------------------------------------------------------


def tables(method: Method, plot: Plot, lang: Lang) -> dict[Plane, list[TableBlock]]:
    """Links, points, coincident points, slides, as each plane gives of them, in all shapes; empty ones left out."""
    shown, blocks = set[_Key](), dict[Plane, list[TableBlock]]()
    for plane in PLANES[::-1]:  # what is asked and stands in no other table comes last
        if own := [table for table in _PlaneTables(method, plot, lang, plane, shown).every if table.rows]:
            blocks[plane] = TableBlock.shapes(own)
    return blocks


@frozen
class _PlaneTables:
    """shown: what has a value in the tables of all planes so far."""

    method: Method
    plot: Plot
    lang: Lang
    plane: Plane
    shown: set[_Key]

    @property
    def every(self) -> list[Table]:
        if self.plane == "position":
            return [self.slides(), self.answers()]
        return [self.links(), self.points(), self.coincident_points(), self.slides()]

    @cached_property
    def questions(self) -> dict[_Key, asked.Quantity]:
        quantities = (read(self.method.mechanism, text) for text in self.method.mechanism.ask)
        return {self.key(quantity): quantity for quantity in quantities if quantity is not None}

    def key(self, quantity: asked.Quantity) -> _Key:
        """The subject, however it is written: a link, a slide, or points of the velocity polygon."""
        match quantity:
            case asked.Rotation():
                return quantity.word, frozenset((quantity.link,))
            case asked.Displacement():
                return "s", frozenset((quantity.slide,))
            case asked.Moving():
                links = self.method.nodes_of_links
                nodes = (links.get(site.link, {}).get(site.point, "") for site in quantity.sites)
                return quantity.word, frozenset(nodes)
            case asked.Centre() | asked.Component() | asked.Place() | asked.Quotient() | asked.Track():
                return quantity.text, frozenset()
            case _:
                assert_never(quantity)

    def cell(self, label: Label, of: Iterable[str], *words: str) -> Label:
        """A label of these quantities, in bold where one of them is asked for."""
        keys = {(word, frozenset(of)) for word in words}
        self.shown.update(keys)
        return bold(label) if keys & self.questions.keys() else label

    def size(self, value: float) -> Label:
        """A speed or an acceleration as a figure."""
        return number(real(self.method.mechanism.usual.motion(value, self.plane)))

    def links(self) -> Table:
        """Angular velocities or accelerations, and their sense in a column of its own; an idle roller has none."""
        machine, rates, word, column = self.method.mechanism, self.plot.omega, "omega", _column("ω", "rad/s")
        if self.plane == "acceleration":
            rates, word, column = self.plot.alpha, "alpha", _column("α", "rad/s²")
        rows = []
        for name in (name for name in machine.moving if name in rates and name not in machine.idle):
            value = real(machine.usual.rate(rates[name], self.plane))
            sense = plain(say("sheet.sense", self.lang, which=int(value < 0))) if value else ()
            cells = lettering.link_label(machine.called(name)), number(abs(value)) if value else plain("0"), sense
            rows.append(tuple(self.cell(label, [name], word) for label in cells))
        return Table((plain({"en": "link", "zh": "构件"}[self.lang]), column, ()), tuple(rows))

    def points(self) -> Table:
        """Speeds or accelerations of the named points of moving links."""
        method, velocity, letter = self.method, self.plane == "velocity", self.plane[0]
        primed = {node.of: name for name, node in method.acceleration.nodes.items() if node.site is not None}
        rows = []
        for node in (node for node in method.velocity.nodes.values() if node.site is not None and node.of in primed):
            assert node.site is not None
            if node.site.link != FRAME and node.site.point not in method.mechanism.unnamed:
                value = self.plot.points(self.plane)[node.name if velocity else primed[node.of]]
                cells = point_label(node.of), self.size(abs(place(value)))
                rows.append(tuple(self.cell(label, [node.name], letter) for label in cells))
        head = plain({"en": "point", "zh": "点"}[self.lang]), _column(letter, "m/s" if velocity else "m/s²")
        return Table(head, tuple(rows))

    def coincident_points(self) -> Table:
        """Relative motions of coincident points: velocity, or Coriolis and relative acceleration."""
        columns = {"v": _column("v", "m/s", "r")}
        if self.plane == "acceleration":
            columns = {"a_k": _column("a", "m/s²", "k"), "a_r": _column("a", "m/s²", "r")}
        arrows, points = self.method.acceleration.vectors(), self.plot.points(self.plane)
        rows = list[tuple[Label, ...]]()
        for name, term in self.method.velocity.vectors().items():
            low, of = name.partition("_")[2], (term.tail, term.head)
            every = {word: arrow for word in ("a_k", "a_r") if (arrow := arrows.get(f"a^{word[-1]}_{low}"))}
            if own := {"v": term, **every} if every else {}:
                label = tuple(Run(run.text, run.italic) for run in lettering.vector_label(f"v_{low}")[1:])
                sizes = {word: self.size(abs(place(points[one.head] - points[one.tail])))
                         for word, one in own.items() if word in columns}  # fmt: skip
                cells = (self.cell(sizes[word], of, word) if word in sizes else () for word in columns)
                rows.append((self.cell(label, of, *sizes), *cells))
        filled = [0, *(k for k in range(1, 1 + len(columns)) if any(row[k] for row in rows))]
        head = (), *columns.values()
        return Table(tuple(head[k] for k in filled), tuple(tuple(row[k] for k in filled) for row in rows))

    def slides(self) -> Table:
        """Displacements that have a name and are not given, or their rates; a name of the file in italics."""
        machine, plot, rows = self.method.mechanism, self.plot, list[tuple[Label, ...]]()
        given = {pose.link for pose in machine.poses} | {one.link for one in machine.drivers if one.value is not None}
        for name in (slide.name for slide in machine.slides if slide.named and slide.name in plot.s):
            title = machine.slide_title(name, self.lang)
            label = plain(title, title.isascii())
            if self.plane != "position":
                rates = plot.s_rate if self.plane == "velocity" else plot.s_acceleration
                rows.append((label, self.size(real(rates.get(name, 0.0)))))
            elif name not in given:
                rows.append((self.cell(label, [name], "s"), self.cell(number(1000 * real(plot.s[name])), [name], "s")))
        columns = {"position": ("s", "mm"), "velocity": ("ds/dt", "m/s"), "acceleration": ("d²s/dt²", "m/s²")}
        return Table(((), _column(*columns[self.plane])), tuple(rows))

    def answers(self) -> Table:
        """The answers that stand in no other table."""
        if not (others := [quantity for key, quantity in self.questions.items() if key not in self.shown]):
            return Table((), ())
        from graphkin.say.explained import AnswerLines
        from graphkin.say.solution_goal import solution_goal

        reading = Reading(self.method, self.plot, dict.fromkeys(KEYS.values(), 1.0), self.lang)
        lines, rows = AnswerLines(solution_goal(reading), {}), list[tuple[Label, ...]]()
        for quantity in others:  # units stand with the names, as in the other tables
            label = label_of(quantity)
            if isinstance(quantity, asked.Centre):
                assert lines.goal.centred is not None, quantity
                figure, unit = lines.goal.centred.figure(quantity)
                far = Run(" → ∞"), Run(reading.say("centres.towards").rstrip())
                label = (*label, *far) if unit == "°" else label
            else:
                text, unit = lines.result(quantity), EDGE[quantity.unit].sign
                figure = text.removesuffix(unit).rstrip()
                unit = "" if figure == text else unit
            rows.append((bold(_unit(label, unit) if unit else (*label, Run(" ="))), bold(formula(figure))))
        return Table((plain({"en": "asked", "zh": "所求"}[self.lang]), ()), tuple(rows))


def _unit(label: Label, unit: str) -> Label:
    return (*label, Run(f" [{unit}]"))


def _column(letter: str, unit: str, part: str = "") -> Label:
    """The head of a column of values."""
    return _unit(quantity_label(letter, "", part), unit)


# --- what a problem gives and asks, of a sheet that shows nothing else ------------------------------------------------


def given_tables(reading: Reading) -> list[Table]:
    """Dimensions and driven rates; what is asked for. Empty ones left out."""
    given = WrittenLines.of([formula(text) for text in dimensions(reading)], _WIDE, LABEL).lines
    quantities = ((text, read(reading.mechanism, text)) for text in reading.mechanism.ask)
    asked_for = [plain(text) if quantity is None else label_of(quantity) for text, quantity in quantities]
    questions = WrittenLines.of(asked_for, _WIDE, LABEL).lines
    every = ((say("sheet.given", reading.lang), given), (say("sheet.find", reading.lang), questions))
    return [Table((plain(head),), tuple((line,) for line in lines)) for head, lines in every if lines]


def label_of(quantity: asked.Quantity, over: str = " / ") -> Label:
    """A quantity as the field writes it: `theta 3` as θ₃, `a_k B3B2` as a with k above B3B2."""
    match quantity:
        case asked.Quotient():
            return lettering.joined([label_of(half) for half in quantity.halves], over)
        case asked.Centre():
            return quantity_label("P", quantity.text.removeprefix("P"))
        case (
            asked.Rotation() | asked.Displacement() | asked.Place() | asked.Track() | asked.Moving() | asked.Component()
        ):
            return quantity_label(quantity.letter, quantity.of.replace(",", ", ").replace("@", " "), quantity.part)
        case _:
            assert_never(quantity)
