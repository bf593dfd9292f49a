"""Room to draw and to write in: gridded paper with a pole, empty rows of an equation, tables, boxes for answers."""

from __future__ import annotations

import cmath
import hashlib
import math
from collections.abc import Iterator, Sequence

import graphkin
from graphkin.base.geometry import place
from graphkin.base.rooms import corners
from graphkin.base.value import frozen
from graphkin.construction import Construction, LayOff, Plane, Term
from graphkin.errors import Lang
from graphkin.handouts.document import (
    GRID,
    BlankLine,
    Block,
    Foot,
    GridRoom,
    Handout,
    HandoutHeading,
    HandoutPart,
    HandoutTable,
    Paragraph,
    TermRows,
)
from graphkin.handouts.problem import ROOM, HandoutProblem
from graphkin.homework.platforms.tables import Cell
from graphkin.marking.answers import asked_of
from graphkin.model.mechanism import FRAME, Driver, Pose
from graphkin.model.quantities import EDGE, Centre, Moving, Quotient, Rotation, Track, at_position
from graphkin.outputs.letters import lettered
from graphkin.say import names
from graphkin.say.catalogue import say
from graphkin.say.entry import Calculation, Entry, VectorEquation
from graphkin.say.problems import positions
from graphkin.sheet.lettering import formula, joined, plain, point_label
from graphkin.sheet.mechanism_figure import shown_places
from graphkin.submissions.submission import DRAWINGS

_MORE = 1.2
_EDGE = 2.0  # distance of the polygon from the edge; the pole stands on a line of the grid [mm]
_FEW, _MANY = 6, 10  # vectors for which a table to measure into has room at least, or two beside each other
_STEP = 10.0  # rooms are so many millimetres, or a multiple of it


def room(problem: HandoutProblem, plane: Plane) -> GridRoom:
    """The same room for every problem, with the pole somewhere, by lot, from where its polygon has room: neither tells
    anything of the polygon. Where a scale of the file's own makes that larger, the box of the polygon and a fifth more.
    """
    machine, points = problem.drawing.mechanism, problem.drawing.plot.points(plane)
    construction = problem.construction(plane)
    steps, names = construction.steps, (construction.pole, *construction.nodes)
    if plane == "position":  # from the first fixed point, with the direction of +x
        steps, names = (), (next(iter(machine.named(FRAME)), ""), *machine.points)
    pole = names[0]
    start = points.get(pole, 0j)
    places = [place(points[name]) for name in names if name in points]
    if plane == "position":  # with wheels and asked centres, as far as these have room
        for at in shown_places(problem.drawing.method, problem.drawing.plot):
            size = (corners([*places, at])[1] - corners([*places, at])[0]) / problem.scales[plane]
            places += [at] if max(size.real / ROOM.real, size.imag / ROOM.imag) < 1 / _MORE else []
    low, high = corners([(at - place(start)) / problem.scales[plane] for at in places])
    wide, tall = _whole((high - low).real, ROOM.real), _whole((high - low).imag, ROOM.imag)
    right, up = (byte / 255 for byte in hashlib.sha256((machine.text + plane).encode()).digest()[:2])
    at = complex(_placed(low.real, high.real, wide, right), tall - _placed(low.imag, high.imag, tall, up))
    direction = 0.0
    for step in steps:  # the first arrow that is laid off is given with the driver
        if isinstance(step, LayOff) and abs(arrow := place(points[step.term.head] - points[step.term.tail])) > 0:
            direction = cmath.phase(arrow) % math.pi if _may_be_shown(problem, step.term) else 0.0
            break
    mark = point_label("x") if plane == "position" else plain(f"{round(math.degrees(direction), 1):g}°")
    words = say(f"sheet.plane {plane}", problem.lang)
    name = pole or next(letter for letter in ("O", "O'", "O''") if letter not in machine.points)
    scale = float(problem.scales[plane])
    reach = (high.imag + _EDGE, _EDGE - low.imag)
    return GridRoom(words, wide, tall, at, point_label(name), direction, mark, plane, scale, *reach)


def _may_be_shown(problem: HandoutProblem, term: Term) -> bool:
    """True if the direction of an arrow gives nothing away: where a place, an angle or a centre is asked for, it must
    follow from that of a link that is given, or from a guide of the frame."""
    if not problem.is_read_off:
        return True
    machine = problem.drawing.mechanism
    turned: tuple[Driver | Pose, ...] = (*machine.drivers, *machine.poses)
    given = {one.link for one in turned if one.kind == "angle" and one.value is not None and one.from_link == FRAME}
    return any(site.link == FRAME or site.link in given for site in term.sites)


def _placed(low: float, high: float, room: float, lot: float) -> float:
    """A place of the pole in a room, so that what reaches from low to high about it keeps off the edge."""
    first, last = _EDGE - low, room - _EDGE - high
    least, most = math.ceil(first / GRID), math.floor(last / GRID)
    return GRID * (least + round(lot * (most - least)))


def _whole(length: float, usual: float) -> float:
    return usual if length <= usual - 2 * _EDGE - GRID else _STEP * math.ceil(_MORE * length / _STEP)


def to_write(problem: HandoutProblem, entries: Sequence[Entry]) -> Iterator[Block]:
    """Room for what a polygon is drawn from: each equation, empty but for its signs; a line for each magnitude that is
    reckoned for an arrow, as `v_B = ω1 l_AB` is."""
    yield from (_empty_rows(problem, each) for each in entries if isinstance(each, VectorEquation))
    reckoned = (each for each in entries if isinstance(each, Calculation) and each.formulas and each.name[0] in "va")
    lines = [formula(f"{each.name} =") for each in reckoned if "μ" not in each.formulas[0]]
    yield from [BlankLine(tuple(lines))] if lines else []


def _empty_rows(problem: HandoutProblem, equation: VectorEquation) -> TermRows:
    """Lines to write an equation on, with its own signs."""
    heads = [plain(say(key, problem.lang)) for key in ("derivation.direction row", "derivation.size row")]
    signs = ((plain(term), (), ()) if term in ("=", "+") else None for term, _, _ in equation.columns)
    return TermRows((heads[0], heads[1]), tuple(signs))


def measured(problem: HandoutProblem, count: int, under: float = 0.0) -> HandoutTable:
    """Room for what is read off: a vector, its length on paper, its value; two beside each other, of many three."""
    heads = tuple(plain(say(f"handouts.{key}", problem.lang)) for key in ("vector", "measured", "value"))
    beside = 2 if count <= _MANY else 3
    return HandoutTable(heads * beside, (((),) * 3 * beside,) * math.ceil(count / beside), under)


def to_measure(entries: Sequence[Entry], plane: Plane) -> int:
    """Room enough for every vector that a solution measures in a polygon; for no few of them less."""
    scaled = (each.formulas[0] for each in entries if isinstance(each, Calculation) and each.formulas)
    return max(_FEW, sum(first.startswith(f"{names.SCALE[plane]}·") for first in scaled))


@frozen
class AnswerRow:
    """A place for an answer: `ω3 #2`, its unit, whether it has a sense, a direction or two coordinates, and what it is
    worth; a ratio of rotations has the `same` sense or the opposite."""

    symbol: str
    unit: str
    turns: bool
    points: str
    directed: bool = False
    is_place: bool = False
    same: bool = False


def answer_rows(problem: HandoutProblem) -> list[AnswerRow]:
    """Each quantity that is asked for, at each position."""
    mechanism, rows = problem.drawing.mechanism, list[AnswerRow]()
    worth = {text: f"{mechanism.worth[text]:g}" for text in asked_of(mechanism)}
    for at in range(1, 2 + positions(mechanism)):
        for text, quantity in zip(problem.asked.texts, problem.asked.wanted, strict=True):
            if quantity is not None:
                unit = EDGE[quantity.unit].sign or "—"
                turning = [isinstance(half, Rotation) and half.word != "theta" for half in quantity.halves]
                same = isinstance(quantity, Quotient) and all(turning)
                turns = turning == [True]
                symbol = at_position(problem.goal.symbol(quantity), at)
                kinds = isinstance(quantity, Moving), isinstance(quantity, Centre | Track)
                rows.append(AnswerRow(symbol, unit, turns, worth.get(text, ""), *kinds, same))
    return rows


def worth(problem: HandoutProblem) -> str:
    """` (points: 10)`: all answers together, where the file says what any is worth."""
    given = problem.drawing.mechanism.given
    has_points = any(path[0] == "points" and path[1:] not in ((), ("follows",)) for path in given)
    total = sum(float(row.points or 0) for row in answer_rows(problem))
    return say("handouts.worth", problem.lang, points=f"{total:g}") if has_points else ""


def answers_room(problem: HandoutProblem) -> HandoutTable:
    """Boxes for the answers; of several positions a column each."""
    every, count = answer_rows(problem), 1 + positions(problem.drawing.mechanism)
    if count == 1:
        return answer_boxes(problem)
    first, worthy = every[: len(every) // count], bool(problem.whose or worth(problem))
    heads = [say("handouts.quantity", problem.lang), *(f"#{at}" for at in range(1, count + 1))]
    heads += [say("handouts.unit", problem.lang), *[say("handouts.points", problem.lang)] * worthy]
    rows = []
    for k, row in enumerate(first):
        points = " + ".join(one.points for one in every[k :: len(first)])
        blank = plain("(\u2003\u2002, \u2003\u2002)" if row.is_place else "")
        rows.append((formula(row.symbol), *[blank] * count, plain(row.unit), *[plain(points)] * worthy))
    return HandoutTable(tuple(map(plain, heads)), tuple(rows))


def answer_heads(rows: Sequence[AnswerRow], lang: Lang) -> list[str]:
    """The heads of a table of answers, without that of the points."""
    columns = ["quantity", "answer", "unit", "direction" if any(row.directed for row in rows) else "sense"]
    return [say(f"handouts.{key}", lang) for key in columns]


def answer_boxes(problem: HandoutProblem) -> HandoutTable:
    """A box an answer, with its unit, and one for sense or direction where it has any; what it is worth, where that
    differs."""
    rows = answer_rows(problem)
    end = None if problem.whose or worth(problem) else -1
    ratio = say("handouts.ratio", problem.lang)
    labels = [(formula(row.symbol), plain("(\u2003\u2003\u2002, \u2003\u2003\u2002)" if row.is_place else ""),
               plain(row.unit), plain("" if row.turns else "\u2003\u2003\u2003°" if row.directed else
                                      ratio if row.same else "—"),
               plain(row.points)) for row in rows]  # fmt: skip
    heads = (*answer_heads(rows, problem.lang), say("handouts.points", problem.lang))
    return HandoutTable(tuple(lettered(head, ()) for head in heads[:end]), tuple(row[:end] for row in labels))


# --- how it is handed in ----------------------------------------------------------------------------------------------

_EXAMPLE = "20270001"


def hand_in_page(problems: Sequence[HandoutProblem], workbook: str) -> Handout:
    """The page, once for each language in which the problem is there; workbook: the name of the file to fill in."""
    blocks: list[Block] = []
    for problem in problems:
        foot = Foot("", graphkin.__version__, "", "", say("handouts.bar", problem.lang))
        blocks += [HandoutPart(problem.lang, foot), *_page(problem, workbook)]
    first = problems[0]
    return Handout(say("handouts.what to hand in", first.lang, title=first.title), first.lang, tuple(blocks))


def _page(problem: HandoutProblem, workbook: str) -> Iterator[Block]:
    lang = problem.lang
    yield HandoutHeading(plain(say("handouts.what to hand in", lang, title=problem.title)), 1)
    yield HandoutHeading(plain(say("handouts.numbers", lang)))
    answers = answer_boxes(problem)
    before, between, after = say("handouts.fill in", lang, file="\0", line="\0").split("\0")
    line = (*answers.rows[0][0], *plain(" = 1.23 "), *answers.rows[0][2]) if answers.rows else ()
    yield Paragraph((*plain(before + workbook + between), *line, *plain(after)))
    yield answers
    yield HandoutHeading(plain(say("handouts.files", lang)))
    yield Paragraph(plain(say("handouts.called", lang)))
    kinds = {"number": (".xlsx", ".csv", ".txt"), "drawing": DRAWINGS}
    between = say("common.list", lang)
    rows = [(plain(say(f"handouts.{what} file", lang)), plain(between.join(_EXAMPLE + end for end in ends)))
            for what, ends in kinds.items()]  # fmt: skip
    if positions(problem.drawing.mechanism):
        rows.append((plain(say("handouts.further file", lang)), plain(f"{_EXAMPLE} #2{DRAWINGS[0]}")))
    yield HandoutTable(tuple(plain(say(f"handouts.{head}", lang)) for head in ("content", "file")), tuple(rows))
    yield HandoutHeading(plain(say("handouts.drawing", lang)))
    yield Paragraph(plain(say("handouts.to scale", lang)))
    polygons = tuple(
        (plain(say(f"sheet.plane {plane}", lang)), joined([*map(point_label, _letters(problem.construction(plane)))]))
        for plane in problem.polygons
    )
    yield HandoutTable(tuple(plain(say(f"handouts.{head}", lang)) for head in ("plane", "letters")), polygons)


def _letters(polygon: Construction) -> list[str]:
    """The pole and the points that lie elsewhere: fixed ones stand on it."""
    fixed = {name for name, node in polygon.nodes.items() if node.site is not None and node.site.link == FRAME}
    return [name for name in dict.fromkeys((polygon.pole, *polygon.nodes)) if name not in fixed - {polygon.pole}]


def workbook_rows(problem: HandoutProblem) -> Iterator[Sequence[Cell]]:
    """The rows of the workbook: under the heads of the answers whose they are, then each with nothing in it."""
    lang = problem.lang
    rows = answer_rows(problem)
    yield answer_heads(rows, lang)
    yield from ([say(f"handouts.{head}", lang), ""] for head in ("name", "student number"))
    for row in rows:
        yield [row.symbol, "", row.unit, "" if row.turns or row.directed else "—"]
