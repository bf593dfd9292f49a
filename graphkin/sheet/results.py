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
from graphkin.say.explained import AnswerLines
from graphkin.say.reading import Reading
from graphkin.say.solution_goal import solution_goal
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
    results = _TablesInMaking(method, plot, lang)
    every = (results.links(), results.points(), results.coincident_points(), results.slides(), results.answers())
    parts = {plane: [part for table in every if (part := table.of(plane))] for plane in PLANES}
    return {plane: TableBlock.shapes(own) for plane, own in parts.items() if own}


@frozen
class _TablesInMaking:
    method: Method
    plot: Plot
    lang: Lang

    @cached_property
    def questions(self) -> dict[_Key, asked.Quantity]:
        quantities = (read(self.method.mechanism, text) for text in self.method.mechanism.ask)
        return {self.key(quantity): quantity for quantity in quantities if quantity is not None}

    @cached_property
    def shown(self) -> set[_Key]:
        """What has a value in these tables so far."""
        return set()

    def key(self, quantity: asked.Quantity) -> _Key:
        """What it is of, however it is written: a link, a slide, or the points of the velocity polygon."""
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

    def title(self, label: Label, of: Iterable[str], *words: str) -> Label:
        """What heads a row, in bold where one of these quantities of it is asked for."""
        return bold(label) if any((word, frozenset(of)) in self.questions for word in words) else label

    def value(self, label: Label, of: Iterable[str], word: str) -> Label:
        """A value, in bold where it is asked for."""
        self.shown.add((word, frozenset(of)))
        return self.title(label, of, word)

    def size(self, value: float, plane: Plane) -> Label:
        """A speed or an acceleration as a figure."""
        return number(real(self.method.mechanism.usual.motion(value, plane)))

    def links(self) -> Table:
        """Angular velocities and accelerations, and their sense in a column of its own; an idle roller has none."""
        machine, plot = self.method.mechanism, self.plot
        head = (plain({"en": "link", "zh": "构件"}[self.lang]), _column("ω", "rad/s"), (), _column("α", "rad/s²"), ())
        rows = []
        for name in (name for name in machine.moving if name in plot.omega and name not in machine.idle):
            row = [self.title(lettering.link_label(machine.called(name)), [name], "omega", "alpha", "theta")]
            for kind, rates, plane in (("omega", plot.omega, "velocity"), ("alpha", plot.alpha, "acceleration")):
                value = real(machine.usual.rate(rates[name], plane))
                sense = plain(say("sheet.sense", self.lang, which=int(value < 0))) if value else ()
                label = number(abs(value)) if value else plain("0")
                row += [self.value(label, [name], kind), self.value(sense, [name], kind)]
            rows.append(tuple(row))
        return Table(head, tuple(rows))

    def points(self) -> Table:
        """Speeds and accelerations of the named points of moving links."""
        head = (plain({"en": "point", "zh": "点"}[self.lang]), _column("v", "m/s"), _column("a", "m/s²"))
        method, plot = self.method, self.plot
        primed = {node.of: name for name, node in method.acceleration.nodes.items() if node.site is not None}
        rows = []
        for node in method.velocity.nodes.values():
            if node.of not in primed or node.site is None or node.site.link == FRAME:
                continue
            if node.site.point not in method.mechanism.unnamed:
                speed = self.size(abs(place(plot.velocity[node.name])), "velocity")
                other = self.size(abs(place(plot.acceleration[primed[node.of]])), "acceleration")
                of = [node.name]
                name = self.title(point_label(node.of), of, "v", "a")
                rows.append((name, self.value(speed, of, "v"), self.value(other, of, "a")))
        return Table(head, tuple(rows))

    def coincident_points(self) -> Table:
        """Relative motions of coincident points: velocity, Coriolis and relative acceleration."""
        head = ((), _column("v", "m/s", "r"), _column("a", "m/s²", "k"), _column("a", "m/s²", "r"))
        rows: list[tuple[Label, ...]] = []
        arrows, velocity, acceleration = self.method.acceleration.vectors(), self.plot.velocity, self.plot.acceleration
        for name, term in self.method.velocity.vectors().items():
            low = name.partition("_")[2]
            pair = [arrows.get(f"a^{part}_{low}") for part in ("k", "r")]
            if not any(pair):
                continue
            label = tuple(Run(run.text, run.italic) for run in lettering.vector_label(f"v_{low}")[1:])
            values = [self.size(abs(place(velocity[term.head] - velocity[term.tail])), "velocity")]
            for arrow in pair:
                size = abs(place(acceleration[arrow.head] - acceleration[arrow.tail])) if arrow else None
                values.append(plain("") if size is None else self.size(size, "acceleration"))
            cells = zip(values, ("v", "a_k", "a_r"), strict=True)
            pair_of = (term.tail, term.head)
            first = self.title(label, pair_of, "v", "a_k", "a_r")
            rows.append((first, *(self.value(value, pair_of, kind) if value else () for value, kind in cells)))
        filled = [k for k in range(len(head)) if not k or any(run.text for row in rows for run in row[k])]
        return Table(tuple(head[k] for k in filled), tuple(tuple(row[k] for k in filled) for row in rows))

    def slides(self) -> Table:
        """Displacements that have a name and are not given, with their rates; a name of the file in italics."""
        head = ((), _column("s", "mm"), _column("ds/dt", "m/s"), _column("d²s/dt²", "m/s²"))
        machine, plot, rows = self.method.mechanism, self.plot, list[tuple[Label, ...]]()
        given = {pose.link for pose in machine.poses} | {one.link for one in machine.drivers if one.value is not None}
        for name in (slide.name for slide in machine.slides if slide.named and slide.name in plot.s):
            title = machine.slide_title(name, self.lang)
            rows.append((
                self.title(plain(title, title.isascii()), [name], "s"),
                () if name in given else self.value(number(1000 * real(plot.s[name])), [name], "s"),
                self.size(real(plot.s_rate.get(name, 0.0)), "velocity"),
                self.size(real(plot.s_acceleration.get(name, 0.0)), "acceleration"),
            ))  # fmt: skip
        return Table(head, tuple(rows))

    def answers(self) -> Table:
        """What is asked for and stands in no other table."""
        reading = Reading(self.method, self.plot, dict.fromkeys(KEYS.values(), 1.0), self.lang)
        lines = AnswerLines(solution_goal(reading), {})
        rows = list[tuple[Label, ...]]()
        for key, quantity in self.questions.items():
            if key not in self.shown:  # units stand with the names, as in the other tables
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
                rows.append((bold(_unit(label, unit) if unit else label), bold(formula(figure))))
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
