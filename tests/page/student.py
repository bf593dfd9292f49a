"""A student at the drawing board: draws the construction of a problem with the pointer alone, right or with mistakes."""

from __future__ import annotations

import cmath
import json
import math
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from board_student import StudentHand

from graphkin.base.geometry import number, place
from graphkin.construction import Equation, Given, Image, LayOff, Meet, Plane, Ray, Step
from graphkin.handouts.problem import HandoutProblem
from graphkin.marking.equation_choices import equation_choices
from graphkin.marking.hand import redraw
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import EDGE, Centre, Moving, Rotation, Track
from graphkin.proof.readings import readings

if TYPE_CHECKING:
    from playwright.sync_api import Page

Altered = Callable[[complex], complex]


_PIXEL = """([plane, x, y, seen]) => {
  const paper = document.querySelector(`svg[data-plane="${plane}"]`);
  const place = (u, v) => new DOMPoint(u, -v).matrixTransform(paper.getScreenCTM());
  const aside = paper.closest(".problem");
  const off = place(x, seen).y - innerHeight * 0.6;
  if (aside && aside.scrollHeight > aside.clientHeight + 1) aside.scrollBy(0, off);
  else if (Math.abs(off) > innerHeight * 0.3) scrollBy(0, off);
  const { x: right, y: down } = place(x, y);
  return [right, down];
}"""
_BUTTON = """tool => {
  const { left, top, width, height } = document.querySelector(`[data-tool="${tool}"]`).getBoundingClientRect();
  return [left + width / 2, top + height / 2];
}"""
_FILL = """fields => {
  for (const [selector, text] of fields) {
    const field = document.querySelector(selector);
    if (!field.checkVisibility()) throw new Error(`${selector} is not shown`);
    field.value = text;
    if (field.value !== text) throw new Error(`${selector} cannot be ${text}`);
    for (const kind of ["input", "change"]) field.dispatchEvent(new Event(kind, { bubbles: true }));
  }
}"""


@dataclass
class Student:
    """One student on one page; hand: what is drawn otherwise, from which all that follows is drawn."""

    page: Page
    problem: HandoutProblem
    hand: StudentHand = field(default_factory=StudentHand)
    said: dict[str, Any] = field(init=False)

    def __post_init__(self) -> None:
        drawing = self.problem.drawing
        self.plot = redraw(drawing.method, drawing.plot, self.hand)
        self.said = json.loads(self.page.locator("#board").text_content() or "")

    # --- hands

    def tool(self, tool: str, /, **fields: str) -> None:
        """The tool is pointed at, what it is set to is typed."""
        self.page.mouse.click(*self.page.evaluate(_BUTTON, tool))
        self.page.evaluate(_FILL, [[f'[data-field="{key}"]', text] for key, text in fields.items()])

    def pixel(self, plane: Plane, at: complex, seen: complex | None = None) -> tuple[float, float]:
        """Where a place of a paper is on the screen; the window shows it, or another that is to be `seen`."""
        x, y = self.page.evaluate(_PIXEL, [plane, at.real, at.imag, (at if seen is None else seen).imag])
        return x, y

    def click(self, plane: Plane, at: complex) -> None:
        self.page.mouse.click(*self.pixel(plane, at))

    def drag(self, plane: Plane, start: complex, end: complex) -> None:
        middle = (start + end) / 2
        self.page.mouse.move(*self.pixel(plane, start, middle))
        self.page.mouse.down()
        self.page.mouse.move(*self.pixel(plane, end, middle), steps=2)
        self.page.mouse.up()

    # --- a problem

    def draw(self) -> None:
        for plane in self.problem.polygons:
            self.polygon(plane)

    def polygon(self, plane: Plane) -> None:
        """The construction of a polygon, act by act, as it is on the student's paper."""
        self.page.locator(f'[data-scale="{plane}"]').fill(f"{self.problem.scales[plane]:g}")
        construction = self.problem.construction(plane)
        self.at: dict[str, complex] = {construction.pole: 0j}
        self.plane, self.pole = plane, construction.pole
        for name, node in construction.nodes.items():
            if node.site is not None and node.site.link == FRAME:
                self.at[name] = 0j
        for part in self.problem.goal.parts[plane]:
            for step in part.steps if isinstance(part, Equation) else (part,):
                self.step(step)
            if isinstance(part, Equation):
                for term in part.left + part.right:
                    if term.size is None and term.tail in self.at and term.head in self.at:
                        self.arrow(term.name(plane), self.at[term.tail], self.at[term.head])

    def step(self, step: Step) -> None:
        plot, scale = self.plot, self.problem.scales[self.plane]
        match step:
            case LayOff(term, start, tip):
                name = term.name(self.plane)
                arrow = place(plot.points(self.plane)[tip] - plot.points(self.plane)[start]) / scale
                if abs(arrow) < 0.05 or tip in self.at:
                    self.at.setdefault(tip, self.at[start])
                    return
                angle = math.degrees(cmath.phase(arrow))
                self.tool("vector", kind="angle", length=f"{abs(arrow):.2f}", angle=f"{angle:.3f}", name=name)
                self.click(self.plane, self.at[start])
                self.at[tip] = self.at[start] + cmath.rect(round(abs(arrow), 2), math.radians(round(angle, 3)))
                self.letter(tip)
            case Meet(Ray() as first, Ray() as second, point):
                lines = [self.line(ray, point) for ray in (first, second)]
                (one, along), (other, across) = lines
                part = ((other - one).conjugate() * across).imag / (along.conjugate() * across).imag
                self.at[point] = one + part * along
                self.letter(point)
            case Image(point=point) if point not in self.at:
                arrow = place(plot.points(self.plane)[point]) / scale
                self.at[point] = arrow
                if re.fullmatch(r"\w+'*", point) and abs(arrow) > 0.05:
                    angle, node = math.degrees(cmath.phase(arrow)), self.problem.construction(self.plane).nodes[point]
                    name = f"{self.plane[0]}_{node.of}"
                    self.tool("vector", kind="angle", length=f"{abs(arrow):.3f}", angle=f"{angle:.4f}", name=name)
                    self.click(self.plane, 0j)
                    self.letter(point)
            case Given(point, also):
                self.at.update(dict.fromkeys((point, *also), 0j))
            case _:
                pass

    def letter(self, point: str) -> None:
        if (
            any(abs(self.at[point] - at) < 0.05 for name, at in self.at.items() if name != point)
            and abs(self.at[point]) < 0.05
        ):
            return
        self.tool("point", name=point)
        self.click(self.plane, self.at[point])

    def arrow(self, name: str, tail: complex, head: complex) -> None:
        if abs(head - tail) > 1:
            self.tool("vector", kind="", length="", name=name)
            self.drag(self.plane, tail, head)

    def line(self, ray: Ray, point: str) -> tuple[complex, complex]:
        """A line drawn with the set square along a line of the mechanism: it is pointed at, or taken from the list."""
        turned = self.hand.turned.get((point, ray.through), 1)
        along = place(self.problem.drawing.plot.direction(ray.direction)) * turned
        start = self.at[self.hand.through_others.get((point, ray.through), ray.through)]
        for line in sorted(self.said["given"]["lines"], key=lambda line: not line["drawn"]):
            ends = [complex(*xy) for xy in line["at"] or ()]
            own = (ends[1] - ends[0]) / abs(ends[1] - ends[0]) if ends else cmath.rect(1, math.radians(line["angle"]))
            for tool, laid in (("parallel", own), ("perpendicular", 1j * own)):
                if abs((laid.conjugate() * along).imag) < 1e-5:
                    self.tool(tool)
                    if line["drawn"] and (places := line["at"]):
                        one, other = (complex(*xy) for xy in places)
                        self.click("position", one + 0.37 * (other - one))
                    if self.page.locator('[data-field="line"]').input_value() == "":  # not drawn, or a point is near
                        self.tool(tool, line=line["name"])
                    self.click(self.plane, start)
                    return start, along
        angle = math.degrees(cmath.phase(along)) % 180
        for half in (0, 180):
            self.tool("protractor", angle=f"{angle + half:.4f}")
            self.click(self.plane, start)
        return start, along

    def fill_equations(self, wrong: dict[tuple[str, str], str] | None = None) -> None:
        """Every choice of the equations; `wrong`: by term and row what is chosen instead."""
        drawing, fields = self.problem.drawing, list[list[str]]()
        for equation in equation_choices(drawing.method, drawing.plot):
            row = f'[data-of-plane="{equation.plane}"][data-equation="{equation.number}"] [data-term="{{}}"]'
            for term in equation.terms:
                for kind, right in (("direction", term.directions), ("magnitude", term.magnitudes)):
                    token = (wrong or {}).get((term.name, kind), min(right))
                    fields.append([f"{row.format(term.name)} select[data-{kind}]", token])
        self.page.evaluate(_FILL, fields)

    def answers(self) -> Iterator[tuple[str, float, str]]:
        """By question the value in the first unit offered, and its sense."""
        motions = readings(self.problem.drawing.method, self.problem.drawing.plot)
        for text, quantity in zip(self.problem.asked.texts, self.problem.asked.wanted, strict=True):
            if quantity is None or isinstance(quantity, Centre | Track):
                continue
            answer, unit = quantity.answer(motions), EDGE[quantity.unit]
            value = number(answer.value) * unit.factor
            if isinstance(quantity, Rotation) and quantity.word != "theta":
                yield text, abs(value), "counter-clockwise" if value > 0 else "clockwise"
            elif isinstance(quantity, Moving) and answer.vector is not None:
                arrow = place(answer.vector)
                yield text, abs(arrow) * unit.factor, f"{math.degrees(cmath.phase(arrow)):.2f}"
            else:
                yield text, value, ""

    def fill_answers(self, wrong: dict[str, float] | None = None) -> None:
        fields = list[list[str]]()
        for text, value, sense in self.answers():
            fields.append([f'[data-answer="{text}"]', f"{value * (wrong or {}).get(text, 1.0):.4g}"])
            fields += [[f'[data-sense="{text}"]', sense]] if sense else []
        self.page.evaluate(_FILL, fields)

    def hand_in(self, folder: Path, name: str = "") -> Path:
        if name:
            self.page.locator('[data-field="student"]').fill(name)
        with self.page.expect_download() as download:
            self.page.locator('[data-action="hand-in"]').click()
        path = folder / download.value.suggested_filename
        download.value.save_as(path)
        return path
