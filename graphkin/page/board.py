"""The drawing board: a problem, gridded papers, tools and boxes on one page, handed in as a file that `grade` reads.

The page holds what the problem says and nothing that is asked for: the file's text without its remarks, the given
figure, the letters that can be chosen. Nothing is snapped to but what is given or drawn.
"""

from __future__ import annotations

import hashlib
import math
import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import pairwise

from graphkin.base.geometry import place
from graphkin.base.plain import Plain
from graphkin.base.value import frozen
from graphkin.construction import LETTER, Equation, LayOff, Plane, Plot
from graphkin.construction.terms import Term
from graphkin.errors import Lang
from graphkin.files.toml import parsed, toml
from graphkin.handouts.document import HandoutHeading, HandoutPicture, Paragraph
from graphkin.handouts.markup import block_html
from graphkin.handouts.problem import HandoutProblem, drawn_problem
from graphkin.handouts.stages import blocks_of, figure_of
from graphkin.homework.problems.posed import shown_at
from graphkin.marking.equation_choices import EquationChoices, equation_choices
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.quantities import Centre, Moving
from graphkin.outputs.svg import inline
from graphkin.page.board_forms import answer_rows, empty_answers, empty_equation, equation_table, scale_field
from graphkin.page.elements import TAGS, signs_of
from graphkin.page.writer import FOLDER, page
from graphkin.planning.asked import plane_of
from graphkin.say import names
from graphkin.say.catalogue import LANGUAGES, for_scripts, say
from graphkin.sheet.lettering import formula, plain
from graphkin.sheet.marks import PointMark, Stroke, Text

_SUBJECT = "board."
_HALF = (140.0, 110.0)  # of a polygon's paper, about its pole [mm]
_AROUND = 15.0  # the paper about the figure [mm]
_WIDER = 3.0  # of the paper, where lines of links are drawn on until they meet
_GUIDE = 25.0  # half of a guide's line as it is chosen [mm]
_STRAIGHT = 1e-6  # of directions that are along an axis
_LETTERED = re.compile(r"[A-Za-z][\w@]*'*")
@frozen
class GivenFigure:
    """The problem's figure; of one in the position of the problem where its points are, in mm from the first, y up.

    corner  the left upper corner of the figure's sheet seen from that point, x right and y down; None of a figure that
            stands elsewhere
    """

    picture: HandoutPicture
    points: Mapping[str, complex]
    sides: frozenset[tuple[str, str]]
    corner: complex | None

    @property
    def scale(self) -> float | None:
        return None if self.corner is None else float(self.picture.sheet.scales["position"])


class BoardProblem(HandoutProblem):
    """A problem whose figure stands where it is drawn, too, if ruler and compass do not get there and no more than
    instant centres are asked of the position."""

    @classmethod
    def of(cls, problem: HandoutProblem) -> BoardProblem:
        """The same problem for the board."""
        return cls(problem.drawing, problem.scales, problem.lang, problem.whose, problem.before)

    @cached_property
    def posed_at(self) -> tuple[Plot, bool] | None:
        asked = [one for one in self.asked.wanted if one is not None]
        centred = any(isinstance(one, Centre) for one in asked)
        in_motion = all(isinstance(one, Centre) or plane_of(one) != "position" for one in asked)
        if self.drawing.method.fits and centred and in_motion:
            return self.drawing.plot, True
        return shown_at(self.drawing.method, self.drawing.plot)


def board_page(mechanism: Mechanism, lang: Lang, whose: str = "", set_name: str = "", number: int | None = None) -> str:
    """The text of a board's page; whose, set_name, number: of a problem that a set wrote.

    Raises what loading, planning and proving raise.
    """
    drawn = BoardProblem.of(drawn_problem(mechanism, lang, whose))
    problems = {each: replace(drawn, lang=each) for each in LANGUAGES}
    figure = _given_figure(drawn)
    papers = [*_papers(drawn, figure)]
    text = toml(parsed(mechanism.text))
    origin = {"mechanism": text, "name": mechanism.name, "set": set_name, "student": whose, "number": number}
    equations = equation_choices(drawn.drawing.method, drawn.drawing.plot)
    data: dict[str, Plain] = {
        "key": hashlib.sha256(f"{text}\0{whose}".encode()).hexdigest()[:16], "name": whose or mechanism.name,
        "title": {each: problem.title for each, problem in problems.items()}, "problem": {**origin},
        "papers": papers, "letters": _letters(papers, figure.points), "given": _given(drawn, figure),
        "empty": {"student": whose, "scales": {str(paper["plane"]): paper["scale"] for paper in papers}, "steps": [],
                  "equations": [*map(empty_equation, equations)], "answers": empty_answers(drawn)},
    }  # fmt: skip
    words = {key.removeprefix(_SUBJECT): both for key, both in for_scripts("board").items()}
    return page(drawn.title, lang, scripts=["board"], styles=["board"], data={"words": words, "board": data},
                body=_body(problems, figure, papers, equations))  # fmt: skip


def _body(
    problems: Mapping[Lang, HandoutProblem], figure: GivenFigure, papers: Sequence[Mapping[str, Plain]],
    equations: Sequence[EquationChoices],
) -> str:  # fmt: skip
    """The page before anything runs: the text in both languages, then the room for papers, tools and boxes."""
    told = "".join(f'<section class="told" lang="{TAGS[lang]}">{_told(problem, figure)}</section>'
                   for lang, problem in problems.items())  # fmt: skip
    rooms = {paper["plane"]: _room(paper, equations) for paper in papers}
    parts = {"TOLD": told, "FIGURE": inline(figure.picture.sheet), "POSITION": rooms.pop("position", ""),
             "POLYGONS": "".join(rooms.values()), "ANSWERS": answer_rows(problems["en"])}  # fmt: skip
    return _filled("board.html", parts)


def _room(paper: Mapping[str, Plain], equations: Sequence[EquationChoices]) -> str:
    """A paper's heading, its equations and its scale."""
    plane, scale = str(paper["plane"]), paper["scale"]
    tables = "".join(equation_table(one) for one in equations if one.plane == plane)
    field = scale_field(plane, scale if isinstance(scale, float) else None, str(paper["unit"]))
    return _filled("board_paper.html", {"EQUATIONS": tables, "SCALE": field}).replace("PLANE", plane)


def _filled(name: str, parts: Mapping[str, str]) -> str:
    text = (FOLDER / name).read_text("utf-8")
    for key, part in parts.items():
        text = text.replace(f"<!--{key}-->", part)
    return text


def _told(problem: HandoutProblem, figure: GivenFigure) -> str:
    """The problem in words, without its answers' boxes."""
    blocks = [HandoutHeading(plain(problem.title), 1), *blocks_of(problem.posed, problem.lang, problem.points)]
    if figure.corner is None:
        note = say("common.note", problem.lang, note=say("handouts.elsewhere", problem.lang)).strip()
        blocks.append(Paragraph(plain(note)))
    return "".join(map(block_html, blocks))


def _given_figure(problem: HandoutProblem) -> GivenFigure:
    """The problem's figure as it is handed out; its points and its sides, where it is drawn where the problem is."""
    picture, name = figure_of(problem), formula(say("sheet.plane position", problem.lang))
    sheet = picture.sheet.redrawn(lambda mark: None if isinstance(mark, Text) and mark.label == name else mark)
    picture, mechanism = replace(picture, sheet=sheet), problem.drawing.mechanism  # the page names it
    marks = [mark for layer in sheet.layers for mark in layer.marks]
    at = {mark.name: mark.at for mark in marks if isinstance(mark, PointMark) and mark.plane == "position"}
    first = next((point for point in mechanism.named(FRAME) if point in at), "")
    if not first or not (problem.posed_at is None or problem.posed_at[1]):
        return GivenFigure(picture, {}, frozenset(), None)
    points = {name: (there - at[first]).conjugate() for name, there in at.items()}
    strokes = [mark for mark in marks if isinstance(mark, Stroke) and mark.shows is not None]
    corners = (mark.shows.points + mark.shows.points[: mark.closed] for mark in strokes
               if mark.shows is not None and mark.shows.form == "bar")  # fmt: skip
    sides = frozenset(pair for outline in corners for pair in pairwise(outline))
    return GivenFigure(picture, points, sides, -at[first])


def _papers(problem: HandoutProblem, figure: GivenFigure) -> Iterator[dict[str, Plain]]:
    """A paper for the mechanism, and one for each polygon that is drawn."""
    mechanism, paper = problem.drawing.mechanism, figure.picture.sheet.paper
    first = next(iter(mechanism.named(FRAME)), "")
    if figure.corner is not None or problem.posed_at is not None:
        box = _box(-_HALF[0], _HALF[0], -_HALF[1], _HALF[1])
        far = problem.drawing.method.special or any(isinstance(one, Centre) for one in problem.asked.wanted)
        wider = _WIDER if far and figure.corner is not None else 1.0
        if figure.corner is not None:
            half = complex(paper.width, paper.height) / 2
            middle, half = figure.corner.conjugate() + half.conjugate(), wider * (half + complex(_AROUND, _AROUND))
            low, high = middle - half, middle + half
            box = _box(low.real, high.real, low.imag, high.imag)
        letters: list[Plain] = [] if figure.corner is not None else [*mechanism.points]
        letters += [*sorted(problem.drawing.method.special)]
        yield {"plane": "position", "pole": first, "unit": "m", "scale": figure.scale, "box": box, "near": wider,
               "points": letters, "of": {}, "vectors": []}  # fmt: skip
    for plane in problem.polygons:
        construction = problem.construction(plane)
        fixed = {name for name, node in construction.nodes.items() if node.site and node.site.link == FRAME}
        free = [name for name in construction.nodes if name not in {*fixed, construction.pole}]
        letters = [name for name in free if _LETTERED.fullmatch(name)]
        yield {"plane": plane, "pole": construction.pole, "unit": names.UNIT[plane], "scale": None, "near": 1.0,
               "box": _box(-_HALF[0], _HALF[0], -_HALF[1], _HALF[1]),
               "points": letters, "of": {name: construction.nodes[name].of for name in free},
               "vectors": [*_vectors(problem, plane)]}  # fmt: skip


def _box(left: float, right: float, low: float, high: float) -> Plain:
    return {"left": round(left, 3), "right": round(right, 3), "low": round(low, 3), "high": round(high, 3)}


def _vectors(problem: HandoutProblem, plane: Plane) -> list[str]:
    """The names of the arrows that the equations have, and of those asked for."""
    arrows: dict[str, None] = {}
    for part in problem.goal.parts[plane]:
        parts: tuple[Term, ...] = (part.term,) if isinstance(part, LayOff) else ()
        parts = part.left + part.right if isinstance(part, Equation) else parts
        arrows.update(dict.fromkeys(term.name(plane) for term in parts))
    asked = (one for one in problem.asked.wanted if isinstance(one, Moving) and one.letter == LETTER[plane])
    arrows.update(dict.fromkeys(f"{one.letter}{f'^{one.part}' if one.part else ''}_{one.of}" for one in asked))
    return [*arrows]


def _given(problem: HandoutProblem, figure: GivenFigure) -> Plain:
    """The mechanism's lines, by which a set square is laid, as far as the problem gives them."""
    equations = equation_choices(problem.drawing.method, problem.drawing.plot)
    choices = [choice for equation in equations for choice in equation.directions]
    pairs = list(dict.fromkeys(choice.points for choice in choices if choice.kind == "parallel"))
    lines = [*_lines(figure, pairs)] if figure.corner is not None else []
    guides = {choice.token.removeprefix("parallel ") for choice in choices if choice.kind == "guide"}
    lines += _guide_lines(problem, figure, guides)
    places: dict[str, Plain] = {name: _xy(at) for name, at in figure.points.items()}
    corner: Plain = None if figure.corner is None else [round(-figure.corner.real, 4), round(-figure.corner.imag, 4)]
    return {"lines": lines, "pairs": ["".join(pair) for pair in pairs], "points": places, "corner": corner}


def _lines(figure: GivenFigure, pairs: list[tuple[str, ...]]) -> Iterator[Plain]:
    """The lines between points of the figure."""
    sides = {frozenset(side) for side in figure.sides}
    known = dict.fromkeys(frozenset(pair) for pair in [*pairs, *sorted(figure.sides)])
    in_order = {frozenset(pair): pair for pair in [*sorted(figure.sides), *pairs]}
    for pair in known:
        one, other = in_order[pair]
        if one in figure.points and other in figure.points and one != other:
            yield _line(one + other, figure.points[one], figure.points[other], pair in sides)


def _guide_lines(problem: HandoutProblem, figure: GivenFigure, guides: Collection[str]) -> Iterator[Plain]:
    """The lines of slides as the choices call them; of an oblique one in the frame its direction."""
    plot = problem.drawing.plot
    for slide in problem.drawing.method.structure.slides.values():
        along = place(plot.guide_direction(slide.name))
        upright = {"x": along.imag, "y": along.real}
        axis = next((axis for axis, off in upright.items() if slide.guide == FRAME and abs(off) < _STRAIGHT), "")
        called = (f"guide {slide.name}", f"guide {slide.point}")
        name = axis or next((one for one in called if one in guides), "")
        if name and slide.point in figure.points:
            middle = figure.points[slide.point]
            yield _line(name, middle - _GUIDE * along, middle + _GUIDE * along, True)
        elif name and not axis and slide.guide == FRAME:
            angle = round(math.degrees(math.atan2(along.imag, along.real)), 6)
            yield {"name": name, "angle": angle, "at": None, "drawn": False}


def _line(name: str, start: complex, end: complex, drawn: bool) -> Plain:
    return {"name": name, "angle": None, "at": [_xy(start), _xy(end)], "drawn": drawn}


def _xy(at: complex) -> list[Plain]:
    return [round(at.real, 4), round(at.imag, 4)]


def _letters(papers: Sequence[Mapping[str, Plain]], given: Collection[str]) -> dict[str, Plain]:
    """The letters of each name that the student may give, and of the points given."""
    letters = {name: _signs(names.point(name)) for name in given}
    for paper in papers:
        points, vectors = paper["points"], paper["vectors"]
        assert isinstance(points, list)
        assert isinstance(vectors, list)
        letters |= {name: _signs(names.point(name)) for name in map(str, [*points, paper["pole"]])}
        letters |= {name: _signs(names.vector(name)) for name in map(str, vectors)}
    return letters


def _signs(text: str) -> Plain:
    return [*signs_of(formula(text))]
