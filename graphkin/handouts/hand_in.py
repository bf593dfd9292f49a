"""A page that says how a problem is handed in, in several languages, and the workbook to fill in."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import graphkin
from graphkin.construction import Construction
from graphkin.handouts.document import Block, Foot, Handout, HandoutHeading, HandoutPart, HandoutTable, Paragraph
from graphkin.handouts.problem import HandoutProblem
from graphkin.handouts.worksheet import answer_boxes, answer_heads, answer_rows
from graphkin.homework.platforms.tables import Cell
from graphkin.model.mechanism import FRAME
from graphkin.say.catalogue import say
from graphkin.say.problems import positions
from graphkin.sheet.lettering import joined, plain, point_label
from graphkin.submissions.submission import DRAWINGS

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
