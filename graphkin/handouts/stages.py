"""The stages of a handout: problem, worksheet, half-worked, solution; and the answers of a whole book."""

from __future__ import annotations

import hashlib
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from functools import partial
from math import inf
from typing import assert_never

import graphkin
from graphkin.base.scales import finest
from graphkin.construction import Meet, Plane
from graphkin.errors import Lang, NotBetween, NothingToGoOn, Where
from graphkin.handouts import document
from graphkin.handouts.document import Block, Foot, Handout, Stage
from graphkin.handouts.problem import ROOM, HandoutProblem, Section, beside_analysis, common_mistakes, drawn_problem
from graphkin.handouts.worksheet import answers_room, measured, room, to_measure, to_write, worth
from graphkin.model.mechanism import Mechanism
from graphkin.outputs.letters import lettered
from graphkin.say import entry
from graphkin.say.catalogue import say
from graphkin.say.problems import positions
from graphkin.sheet.composition import Style
from graphkin.sheet.lettering import Label, formula, joined, plain, width
from graphkin.sheet.marks import PointMark
from graphkin.sheet.mechanism_sheet import mechanism_sheet
from graphkin.sheet.paper import written
from graphkin.submissions import Student

_HIGH, _LOW, _NAME = 211.0, 50.0, 7.5  # of a page but for a problem's name, entries and answers, and of a name [mm]
_ENTRY, _LINE, _WIDE = 6.4, 4.9, 170.0  # of an entry, of each further line of it; a page's width [mm]
_FINER, _SMALLEST = 1.05, (8.0, 2.5)  # a figure becomes so many times smaller at a time; in all, one to measure on last
_NO_LIST = 3  # so many problems need no list of them


def handout(
    mechanisms: Sequence[Mechanism], stage: Stage, lang: Lang, *, upto: int | None = None, answers: bool = False,
    seed: str = "", whose: Sequence[Student | None] = (), duplex: bool = False, number: int | None = None,
) -> Handout:  # fmt: skip
    """One or several problems at one stage.

    upto     of a half-worked solution: so many whole equations are done, else one, but the last of a problem; of a
             book's problems the longest has more
    answers  the answers of all at the end
    seed     of the set the problems belong to, as every page says it
    whose    the student each problem is for, if any: it stands after the title
    duplex   printed on both sides: each problem begins on the front of a sheet
    number   of the first problem; of several the first is 1 if left out. Students' own problems are one by number

    Raises NotBetween, NothingToGoOn of another stage, and what loading, planning and proving raise.
    """
    if upto is not None and stage != "half":
        raise NothingToGoOn()
    upto = 1 if upto is None else upto
    owners = whose or [None] * len(mechanisms)
    called = ["" if who is None else who.called for who in owners]
    problems = [drawn_problem(each, lang, who) for each, who in zip(mechanisms, called, strict=True)]
    most = max(1, *(problem.equations - 1 for problem in problems))
    if stage == "half" and upto > most:
        raise NotBetween(Where("--upto"), str(upto), 0, most)
    numbers: Sequence[int] = [number or 0] * len(problems)
    if not any(called) and len(problems) > 1:
        numbers = range(number or 1, (number or 1) + len(problems))
    contents = say("handouts.contents", lang) if len(problems) > _NO_LIST else ""
    front = document.NewPage(duplex)
    blocks = [block for problem in _each_at(problems, stage, upto, numbers) for block in (front, *problem)]
    blocks += [front, *_answers(problems, numbers, lang)] if answers else []
    title = " / ".join(problem.title for problem in problems)
    digest = _digest(mechanisms) if len(mechanisms) == 1 else ""
    words = say("handouts.seed", lang, seed=seed) if seed else ""
    foot = Foot(say(f"handouts.stage {stage}", lang), graphkin.__version__, digest, words, say("handouts.bar", lang))
    ids = ("" if who is None else who.id for who in owners)
    whole = (document.HandoutPart(lang, foot, contents), *blocks[0 if contents else 1 :])
    return Handout(title, lang, whole, tuple(zip((machine.name for machine in mechanisms), ids, strict=True)))


def _each_at(
    problems: Sequence[HandoutProblem], stage: Stage, upto: int, numbers: Sequence[int]
) -> Iterator[list[Block]]:
    """Each problem at a stage; figures of several are numbered through, but each student's own."""
    figures = 0
    for place, (problem, number) in enumerate(zip(problems, numbers, strict=True)):
        digest = _digest([problem.drawing.mechanism]) if len(problems) > 1 else ""
        said = " · ".join(filter(None, (problem.whose, digest)))
        blocks = [*_numbered(replace(problem, before=figures), stage, upto, number, said, place)]
        figures += 0 if problem.whose else sum(isinstance(block, document.HandoutPicture) for block in blocks)
        yield blocks


def _answers(problems: Sequence[HandoutProblem], numbers: Sequence[int], lang: Lang) -> Iterator[Block]:
    """The answers of a whole book."""
    yield document.HandoutHeading(plain(say("handouts.answers", lang)), 1)
    for problem, number in zip(problems, numbers, strict=True):
        yield document.HandoutHeading(plain(_titled(problem.title, lang, number)))
        yield from blocks_of(problem.answers.entries, lang, problem.points)


def in_languages(
    mechanisms: Sequence[Mechanism], stage: Stage, langs: Sequence[Lang], *, upto: int | None = None,
    answers: bool = False, seed: str = "", whose: Sequence[Student | None] = (), duplex: bool = False,
    number: int | None = None,
) -> Handout:  # fmt: skip
    """The handout in each of the languages, one after the other, each with its own feet."""
    made = partial(handout, mechanisms, stage, upto=upto, answers=answers, seed=seed, whose=whose, duplex=duplex,
                   number=number)  # fmt: skip
    first, *others = (made(lang=lang) for lang in langs)
    front = [document.NewPage(True)] if duplex else []
    blocks = list(first.blocks)
    for other in others:
        blocks += [other.blocks[0], *front, *other.blocks[1:]]
    return replace(first, blocks=tuple(blocks))


def _numbered(
    problem: HandoutProblem, stage: Stage, upto: int, number: int, said: str, place: int
) -> Iterator[Block]:
    """A problem at a stage, whose title bears its number, and whose figures are numbered."""
    figures = 0
    for block in _staged(problem, stage, upto):
        match block:
            case document.HandoutHeading(words, 1):
                numbered = (*plain(_titled("", problem.lang, number)), *words)
                yield replace(block, words=numbered, said=said, problem=place)
            case document.HandoutPicture():
                figures += 1
                yield replace(block, number=problem.figure(figures) + block.note)
            case _:
                yield block


def _titled(title: str, lang: Lang, number: int) -> str:
    """`Problem 3. Shaper`."""
    return (say("handouts.problem", lang, number=number) if number else "") + title


def _digest(mechanisms: Sequence[Mechanism]) -> str:
    return hashlib.sha256("\0".join(mechanism.text for mechanism in mechanisms).encode()).hexdigest()[:12]


def _staged(problem: HandoutProblem, stage: Stage, upto: int) -> Iterator[Block]:
    match stage:
        case "problem":
            yield from posed(problem)
        case "blank":
            yield from posed(problem)
            mechanism: tuple[Plane, ...] = ("position",) if problem.is_read_off or problem.measured else ()
            for plane in (*mechanism, *problem.polygons):
                yield from _worksheet(problem, plane)
        case "half" if problem.polygons:
            yield from _half(problem, upto)
        case "half":  # what is read off the mechanism alone is not begun
            yield from _staged(problem, "blank", upto)
        case "solution":
            yield from _solution(problem)
        case _:
            assert_never(stage)


def _worksheet(problem: HandoutProblem, plane: Plane) -> Iterator[Block]:
    """Empty equations, gridded paper with the pole, a table to measure into; of the mechanism the paper alone."""
    yield document.NewPage()
    heading = say(f"sheet.plane {plane}", problem.lang)
    several = positions(problem.drawing.mechanism)  # this paper is for the first
    yield document.HandoutHeading(plain(say("handouts.of first", problem.lang, what=heading) if several else heading))
    entries = [each for section in problem.parts if section.plane == plane for each in section.entries]
    drawn, grid = plane == "position", room(problem, plane)
    yield from [] if drawn else to_write(problem, entries)
    table = [] if drawn else [measured(problem, to_measure(entries, plane), grid.width)]
    tall = grid.height > ROOM.imag
    yield from table if tall else []
    yield from _gridded(problem, plane, grid)
    yield from [] if tall else table


def _gridded(problem: HandoutProblem, plane: Plane, grid: document.GridRoom) -> Iterator[Block]:
    """Gridded paper with the pole, and what is to be drawn there."""
    pole, angle = ("".join(run.text for run in label) for label in (grid.name, grid.mark))
    construction = problem.construction(plane)
    last = any(isinstance(step, Meet) and step.point == construction.pole for step in construction.steps)
    which = 2 if last else 0 if plane != "position" else 1 if problem.is_read_off else 3
    words = {"which": which, "scale": "\0", "pole": pole, "angle": angle}
    before, after = say("handouts.draw here", problem.lang, **words).split("\0")
    scale = written(plane, problem.scales[plane])
    yield document.Paragraph((*lettered(before, ()), *scale, *lettered(after, problem.points)))
    yield grid


def posed(problem: HandoutProblem, figure: document.HandoutPicture | None = None) -> Iterator[Block]:
    """The data and the question, the scales to use, the mechanism, boxes for the answers."""
    yield document.HandoutHeading(plain(problem.title + worth(problem)), 1)
    if not problem.whose:
        blanks = ("name", "student number", "class")
        yield document.NameLine(tuple(plain(say(f"handouts.{key}", problem.lang).capitalize()) for key in blanks))
    blocks = [*blocks_of(problem.posed, problem.lang, problem.points)]
    first = next((k for k, block in enumerate(blocks) if isinstance(block, document.HandoutHeading)), 0)
    source = say("common.note", problem.lang, note=problem.source) if problem.source else ""  # in no line of its own
    sentence = say("handouts.see figure", problem.lang, figure=problem.figure(1), source=source)
    yield from (*blocks[:first], document.Paragraph(plain(sentence)), *blocks[first:])
    yield document.Paragraph(scales_to_use(problem))
    figure = figure or figure_of(problem)
    if figure.of_all:
        yield figure
    if problem.asked.wanted:
        several = bool(positions(problem.drawing.mechanism))
        yield document.HandoutHeading(lettered(say("handouts.your answers", problem.lang, which=several), ()))
        yield answers_room(problem)
    if not figure.of_all:
        yield from (document.NewPage(), figure)
    if problem.whose:
        yield document.Paragraph(plain(say("handouts.see hand-in", problem.lang)))


def scales_to_use(problem: HandoutProblem) -> Label:
    """Those of the mechanism and of the polygons that are drawn, as a sentence."""
    planes: tuple[Plane, ...] = ("position", *problem.polygons)
    scales = joined([written(plane, problem.scales[plane]) for plane in planes], say("common.semicolon", problem.lang))
    before, after = say("handouts.scales", problem.lang, scales="\0").split("\0")
    return (*plain(before), *scales, *plain(after))


def figure_of(problem: HandoutProblem, solved: bool = False) -> document.HandoutPicture:
    """The mechanism with what is given, so large that the problem has room on its page; one that would be far smaller
    may stand on the next. With a note where it is smaller, or stands elsewhere, as what is asked could be measured.

    solved  its position is drawn here: it stands where that is, with all that is drawn of it if there is room
    """
    method, shown = problem.drawing.method, None if solved else problem.posed_at
    there = shown is None or shown[1]
    if shown is not None:
        problem = replace(problem, drawing=replace(problem.drawing, plot=shown[0]))
    figure = _figure(problem, "position", "construction" if solved else "given")
    notes = [] if there else [say("handouts.elsewhere", problem.lang)]
    texts = [each.text for each in problem.posed if isinstance(each, entry.Sentence | entry.Heading)]
    further = sum(int(width(formula(text), document.LETTERS) / _WIDE) for text in texts)
    answers = answers_room(problem)
    below = answers.row * (1 + len(answers.rows)) + (0.0 if problem.whose else _NAME)
    least, scale = max(_LOW, _HIGH - _ENTRY * len(texts) - _LINE * further - below), problem.scales["position"]
    whole, most = figure, _SMALLEST[there] * scale
    while (high := figure.sheet.paper.height) > least and scale <= most:
        scale = finest(complex(0, max(high / least, _FINER) * scale), complex(1, 1))  # signs are as large as before
        machine = replace(method.mechanism, scales={**method.mechanism.scales, "length": scale})
        reduced = replace(problem.drawing, mechanism=machine, method=replace(method, mechanism=machine))
        figure = _figure(replace(problem, drawing=reduced), "position", "given")
    far = scale > most
    notes += [say("handouts.smaller", problem.lang)] if figure is not whole and not far else []
    note = say("common.note", problem.lang, note=say("common.semicolon", problem.lang).join(notes)) if notes else ""
    return replace(whole if far else figure, of_all=not far, note=note)


def _half(problem: HandoutProblem, upto: int) -> Iterator[Block]:
    """The solution as far as whole equations go, drawn so far; then what leads to the next equation, and room for all
    that is left. The figure of the problem serves the solution, too, unless it is smaller."""
    figure = figure_of(problem, solved=True)
    whole = figure.sheet.scales["position"] == problem.scales["position"]
    yield from posed(problem, figure)
    last, figures = 0, 0 if whole else 1
    for section, left in problem.upto(upto):
        entries, lead = section.entries, tuple[entry.Entry, ...]()
        if section.plane and left and not entries:
            yield from _worksheet(problem, section.plane)
            continue
        if left and isinstance(entries[-1], entry.Sentence):
            entries, lead = entries[:-1], entries[-1:]
        acts = (each.act for each in section.entries if isinstance(each, entry.Sentence))
        last = max([last, *(act.page for act in acts if act is not None)])
        plane, number, shown, paper = section.plane, 2 - whole, list[Block](), list[Block]()
        if plane is not None:
            shown = [] if whole and plane == "position" else _so_far(problem, plane, last)
            if any(isinstance(block, document.GridRoom) for block in shown):
                shown, paper = paper, shown
            figures += not paper
            number = 0 if paper else figures
        yield from _section(problem, replace(section, entries=entries), number)
        yield from shown
        if plane and left:
            several = bool(positions(problem.drawing.mechanism))
            there = "" if paper else say("handouts.with figure", problem.lang, figure=problem.figure(number))
            yield document.Paragraph(plain(say("handouts.go on", problem.lang, which=several, figure=there)))
            yield from blocks_of(lead, problem.lang, problem.points)
            yield from (*to_write(problem, left), *paper, measured(problem, to_measure(left, plane), ROOM.real))


def _so_far(problem: HandoutProblem, plane: Plane, last: int) -> list[Block]:
    """A figure as it is drawn up to an act, or gridded paper with its pole where that is nothing."""
    picture = _figure(problem, plane, "construction", last)
    begun = any(isinstance(mark, PointMark) for mark in picture.sheet.marks)
    return [picture] if begun else [*_gridded(problem, plane, room(problem, plane))]


def _solution(problem: HandoutProblem) -> Iterator[Block]:
    """Reasons, equations, steps in words and drawing, results beside the analysis, tolerance, common mistakes."""
    yield document.HandoutHeading(plain(problem.title + worth(problem)), 1)
    yield from [document.Paragraph(plain(problem.source))] if problem.source else []
    yield from blocks_of(problem.story, problem.lang, problem.points)
    for section in problem.head:
        yield from _section(problem, section)
    figures = 0
    for section in problem.parts:
        figures += section.plane is not None
        yield from _section(problem, section, figures if section.plane else 1)  # centres are found in the mechanism
        if section.plane is not None:  # it may stand where not all of its steps are told yet
            steps = [each.act.number for each in section.entries
                     if isinstance(each, entry.Sentence) and each.act is not None and each.act.numbered]  # fmt: skip
            told = say("handouts.steps", problem.lang, first=steps[0], last=steps[-1]) if len(steps) > 1 else ""
            note = say("common.note", problem.lang, note=told) if told else ""
            yield replace(_figure(problem, section.plane, "construction"), note=note)
    yield from _section(problem, problem.answers)
    yield from beside_analysis(problem)
    yield from common_mistakes(problem)


def _section(problem: HandoutProblem, section: Section, figure: int = 0) -> Iterator[Block]:
    """A section under its heading, which names the figure that goes with it."""
    lang = problem.lang
    reference = say("handouts.with figure", lang, figure=problem.figure(figure)) if figure else ""
    yield document.HandoutHeading(plain(section.heading + reference))
    yield from blocks_of(section.entries, lang, problem.points)


def blocks_of(entries: Sequence[entry.Entry], lang: Lang, points: Collection[str]) -> Iterator[Block]:
    """Each entry of a solution as a block; the mechanism's points are in italics."""
    for each in entries:
        match each:
            case entry.Heading(text):
                yield document.HandoutHeading(plain(text))
            case entry.Sentence(text, item=True):
                yield document.FormulaLine(lettered(text, points))
            case entry.Sentence(text, act):
                number = str(act.number) if act is not None and act.numbered else ""
                yield document.Paragraph(lettered(text, points), number)
            case entry.Calculation():
                note = say("common.note", lang, note=each.note) if each.note else ""
                yield document.FormulaLine(lettered(each.text + note, points))
            case entry.VectorEquation():
                yield rows(each, lang, points)
            case _:
                assert_never(each)


def rows(equation: entry.VectorEquation, lang: Lang, points: Collection[str]) -> document.TermRows:
    """A vector equation as it is printed."""
    heads = [plain(say(key, lang)) for key in ("derivation.direction row", "derivation.size row")]
    columns = ((plain(term) if term in ("=", "+") else formula(term), lettered(direction, points),
                formula(size))
               for term, direction, size in equation.columns)  # fmt: skip
    return document.TermRows((heads[0], heads[1]), tuple(columns))


def _figure(problem: HandoutProblem, plane: Plane, style: Style, last: int | None = None) -> document.HandoutPicture:
    """One figure of the sheet at its scale, cut to its size; `last`: the act after which nothing is drawn."""
    drawing, lang = problem.drawing if style == "given" else problem.told, problem.lang
    sheet = mechanism_sheet(drawing.method, drawing.plot, lang=lang, only=plane, style=style, tight=True, told=True)
    acts = [act for act in drawing.method.acts if act.plane == plane and act.numbered]
    left = {act.page for act in acts if act.number not in problem.numbers}  # of what a driver at rest holds
    end = inf if last is None else last
    drawn = sheet.redrawn(lambda mark: None if mark.step in left or (mark.step or 0) > end else mark)
    key = "handouts.figure given" if style == "given" else "handouts.figure drawn"
    words = say(key, lang, what=say(f"sheet.plane {plane}", lang), title=problem.title)
    return document.HandoutPicture(drawn, words)
