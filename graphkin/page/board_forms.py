"""The forms of a drawing board, as HTML: the rows of the vector equations, scales, boxes for answers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from graphkin.base.plain import Plain
from graphkin.handouts.problem import HandoutProblem
from graphkin.marking.choice_rows import RowChoice
from graphkin.marking.equation_choices import EquationChoices
from graphkin.model.quantities import EDGE, Centre, Moving, Quantity, Rotation, Track, at_position
from graphkin.outputs.typesetting import html_words
from graphkin.page.elements import Attributes, element, select, worded
from graphkin.say import names
from graphkin.say.problems import positions
from graphkin.sheet.lettering import formula

_UNITS = {
    "rad/s": ("rad/s", "deg/s", "r/min"), "m/s": ("m/s", "mm/s"), "rad/s^2": ("rad/s^2", "deg/s^2"),
    "m/s^2": ("m/s^2", "mm/s^2"), "m": ("mm", "m"), "rad": ("deg", "rad"),
}  # fmt: skip
"""By SI unit, those in which an answer may stand."""
_TEXT: Attributes = {"type": "text", "autocomplete": "off"}
_NUMBER: Attributes = {**_TEXT, "inputmode": "decimal"}


# --- equations


def equation_table(one: EquationChoices) -> str:
    """An equation with a row of directions and a row of magnitudes."""
    columns = [_column(_name(one.front))] if one.front else []
    for side in one.sides:
        for n, term in enumerate(side):
            columns += [_column("+" if n else "=")] if n or columns else []
            fields = (_choices(one, term.name, row, choices)
                      for row, choices in (("direction", one.directions), ("magnitude", one.magnitudes)))  # fmt: skip
            columns.append(_column(_name(term.name), *fields, term=term.name))
    keys = ("equation", "direction", "magnitude")
    rows = (element("tr", {}, worded("th", key, {"scope": "row"}), *cells)
            for key, cells in zip(keys, zip(*columns, strict=True), strict=True))  # fmt: skip
    table = element("table", {}, element("tbody", {}, *rows))
    return element("div", {"class": "equation", "data-equation": one.number, "data-of-plane": one.plane}, table)


def _column(*cells: str, term: str | None = None) -> list[str]:
    """Three cells under one another."""
    return [element("td", {"data-term": term}, cell) for cell in (*cells, "", "")[:3]]


def _name(vector: str) -> str:
    return element("span", {"class": "name"}, html_words(formula(names.vector(vector))))


def _choices(one: EquationChoices, term: str, row: str, choices: Iterable[RowChoice]) -> str:
    """The field of a term's direction, or of its magnitude; it is named by its data."""
    data: Attributes = {f"data-{row}": term, "data-term": term, "data-of-plane": one.plane, "data-number": one.number,
                        "data-word-label": f"{row} of"}  # fmt: skip
    return select(data, [("", ""), *((each.token, _shown(each)) for each in choices)])


_PRINTED = {"given": "√", "?": "?", "0": "0"}


def _shown(choice: RowChoice) -> str:
    """A choice as a list shows it: `⊥AB`, `B→A`, `ω3²·l_BC`."""
    match choice.kind:
        case "towards":
            return names.arrow(*choice.points)
        case "parallel" | "guide" | "perpendicular" | "across guide":
            sign = "∥" if choice.kind in ("parallel", "guide") else "⊥"
            return sign + choice.token.partition(" ")[2].removeprefix("guide ").replace("@", "_")
        case "product":
            return "·".join(_factor(factor) for factor in choice.factors)
        case _:
            return _PRINTED.get(choice.token, choice.token)


def _factor(factor: str) -> str:
    """`ω3²` of `omega_3^2`; velocities and lengths as they are."""
    word, _, low = factor.partition("_")
    power = "²" if low.endswith("^2") else ""
    greek = {"omega": "ω", "alpha": "α"}.get(word)
    return f"{greek}{low.removesuffix('^2')}{power}" if greek else names.vector(factor) if word in "va" else factor


def empty_equation(one: EquationChoices) -> Plain:
    """Its terms, of which nothing is filled in yet."""
    terms: list[Plain] = [{"term": term.name, "direction": "", "magnitude": ""} for side in one.sides for term in side]
    return {"plane": one.plane, "equation": one.number, "terms": terms}


# --- scales and answers


def scale_field(plane: str, scale: float | None, unit: str) -> str:
    """The scale of a paper: that of the figure [m], which is given, or a field for what is chosen."""
    if scale:
        return f"1 mm = {scale * 1000:.6g} mm"
    data: Attributes = {"data-scale": plane, **_NUMBER, "size": 7, "data-word-label": "scale", "placeholder": "?"}
    return f"1 mm = {element('input', data)} {unit}"


def answer_rows(problem: HandoutProblem) -> str:
    """A box for each quantity that is asked for, at each position."""
    rows = (_answer(problem, *each) for each in _asked(problem))
    return "".join(element("tr", {}, *(element("td", {}, cell) for cell in cells)) for cells in rows)


def empty_answers(problem: HandoutProblem) -> dict[str, Plain]:
    """Each answer of which nothing is filled in yet, in the first of its units."""
    every = ((at_position(text, at), _units(quantity)[0]) for text, quantity, at in _asked(problem))
    return {key: {"value": "", "unit": unit, "sense": ""} for key, unit in every}


def _asked(problem: HandoutProblem) -> Iterator[tuple[str, Quantity, int]]:
    for at in range(1, 2 + positions(problem.drawing.mechanism)):
        for text, quantity in zip(problem.asked.texts, problem.asked.wanted, strict=True):
            if quantity is not None:
                yield text, quantity, at


def _answer(problem: HandoutProblem, text: str, quantity: Quantity, at: int) -> Iterator[str]:
    """The cells of an answer: its name, value, unit and sense."""
    key = at_position(text, at)
    name = html_words(formula(at_position(problem.goal.symbol(quantity), at)))
    kind = {**_TEXT, "placeholder": "(x, y)"} if isinstance(quantity, Centre | Track) else _NUMBER
    yield element("span", {"class": "name"}, name) + " ="
    yield element("input", {"data-answer": key, "data-key": key, "data-word-label": "answer of", **kind, "size": 10})
    units = [(unit, unit.replace("^2", "²")) for unit in _units(quantity)]
    yield select({"data-unit": key, "data-key": key, "data-word-label": "unit of"}, units)
    yield _sense(quantity, {"data-sense": key, "data-key": key})


def _units(quantity: Quantity) -> Sequence[str]:
    return _UNITS.get(quantity.unit, (EDGE[quantity.unit].name,))


def _sense(quantity: Quantity, data: Attributes) -> str:
    """The second half of an answer: which way it turns, or the direction to +x."""
    if isinstance(quantity, Rotation) and quantity.word != "theta":
        ways = {"which way": "", "counter-clockwise": "counter-clockwise", "clockwise": "clockwise"}
        options = (worded("option", word, {"value": value}) for word, value in ways.items())
        return element("select", {**data, "data-word-label": "sense of"}, *options)
    if not isinstance(quantity, Moving):
        return ""
    return f"∠ {element('input', {**data, 'data-word-label': 'angle of', **_NUMBER, 'size': 6})} °"
