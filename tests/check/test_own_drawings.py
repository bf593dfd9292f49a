"""A law: whatever graphkin draws and seals, by any command with any options, of any mechanism, passes its check.

What bears no seal, check says it does not judge. GRAPHKIN_RANDOM=4000 draws so many random mechanisms, each by every
command; without it some of each family, by some of the commands.
"""

from __future__ import annotations

import os
import random
from pathlib import Path

import pytest
import repeating
from designs import DESIGNS
from every_family import FAMILIES as EVERY
from own_drawings import COMMANDS, drawings
from reading_back import FAMILIES, make, wrong
from renamed import renamed

from graphkin import Drawing
from graphkin.analytic import motion
from graphkin.check import measured
from graphkin.check.drawing import mechanism_of, read
from graphkin.check.ruler import pole_of, ways_to_move
from graphkin.errors import GraphkinError, NothingToMeasure
from graphkin.files import library, loads
from graphkin.model.mechanism import Mechanism
from graphkin.outputs.svg import svg
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.sheet.centrode_sheet import pole_sheet
from graphkin.sheet.design_sheet import design_sheet
from graphkin.sheet.linkage_sheet import family_sheet
from graphkin.sheet.marks import PointMark
from graphkin.sheet.page import step_sheets
from graphkin.studies.centres import centres
from graphkin.studies.centres.two_velocities import from_text

MANY = int(os.environ.get("GRAPHKIN_RANDOM", "0"))
APART = 1 if MANY else len(COMMANDS)
"""Every so manyth command draws a mechanism, another one each."""


def hold(folder: Path, text: str, mechanism: Mechanism | None = None) -> None:
    """It passes, or bears no seal and is said not to be judged."""
    path = folder / "drawing.svg"
    path.write_text(text, encoding="utf-8")
    try:
        drawing = read(path)
    except NothingToMeasure:
        assert '"seal"' not in text
        return
    assert '"seal"' in text
    assert not wrong(measured(drawing, mechanism or mechanism_of(drawing), 0.01))


@pytest.mark.parametrize("number", range(len(FAMILIES))[0 if MANY else -len(COMMANDS) :], ids=list(FAMILIES)[0 if MANY else -len(COMMANDS) :])
def test_every_drawing_of_random_mechanisms(number: int, tmp_path: Path):
    family = list(FAMILIES)[number]
    for seed in range(max(1, MANY // len(FAMILIES))):
        try:
            mechanism = make(family, seed)
        except GraphkinError:
            continue
        for command in COMMANDS[(number + seed) % APART :: APART]:
            for text in drawings(mechanism, command, f"{family}{seed}"):
                hold(tmp_path, text, None if command.__name__ == "linkage" else mechanism)


@pytest.mark.parametrize("number", range(0, len(library.names()), APART), ids=lambda k: library.names()[k])
def test_every_drawing_of_the_library(number: int, tmp_path: Path):
    name = library.names()[number]
    for command in COMMANDS[number // APART % APART :: APART]:
        for text in drawings(library.load(name), command, name):
            hold(tmp_path, text)


@pytest.mark.parametrize("name", ["twin_cams", "breadth_cam"])
@pytest.mark.parametrize("seed", [9200, 9201])
def test_each_face_of_a_follower_is_drawn_at_its_own_cam(name: str, seed: int, tmp_path: Path):
    """Two faces of one link: only that on which its stem stands is drawn to both sides of the stem."""
    mechanism = EVERY[name](seed)
    hold(tmp_path, svg(Drawing.of(mechanism).sheet(only="position")), mechanism)


@pytest.mark.many
@pytest.mark.parametrize("name", DESIGNS)
def test_every_design(name: str, tmp_path: Path):
    for sheet in (design_sheet(DESIGNS[name]), *step_sheets(design_sheet(DESIGNS[name], lang="zh"))):
        hold(tmp_path, svg(sheet))


@pytest.mark.parametrize("sheet", [family_sheet, lambda: pole_sheet(from_text("A 0,0 1,0.5; B 100,0 1,-0.2"))])
def test_what_carries_no_mechanism(sheet, tmp_path: Path):
    text = svg(sheet())
    assert '"seal"' not in text
    hold(tmp_path, text)


@pytest.mark.parametrize("command", [command for command in COMMANDS if command.__name__ in ("given", "moving")])
def test_what_is_not_judged_says_so_in_both_languages(command, tmp_path: Path):
    (text,) = drawings(library.load("ex3-1"), command, 0)
    assert '"seal"' not in text
    path = tmp_path / "drawing.svg"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(NothingToMeasure) as caught:
        read(path)
    assert "nothing of this drawing is judged" in caught.value.message("en")
    assert "不作任何判断" in caught.value.message("zh")


def repeated(name: str) -> list[Mechanism]:
    family, _ = repeating.FAMILIES[name]
    return [renamed(loads(family(random.Random(seed), 0.0)), seed) for seed in range(4 if MANY else 2)]


@pytest.mark.many
@pytest.mark.parametrize("name", repeating.FAMILIES)
def test_nothing_lies_off_a_sheet_that_is_cut(name: str):
    """Where less width breaks what stands over a figure into more lines, too."""
    for drawing in map(Drawing.of, repeated(name)):
        for plane in ("position", "velocity", "acceleration"):
            sheet = drawing.sheet(only=plane, tight=True)
            places = [mark.at for mark in sheet.marks if isinstance(mark, PointMark)]
            assert all(0 <= at.real <= sheet.paper.width and 0 <= at.imag <= sheet.paper.height for at in places)


@pytest.mark.parametrize("name", repeating.FAMILIES)
def test_centres_by_lines_are_those_of_the_analysis(name: str):
    """Where links turn alike, so that several centres lie at infinity in one direction, too."""
    for mechanism in repeated(name):
        method = plan(mechanism)
        found, exact = centres(method, replay_all(method)), ways_to_move(mechanism, motion(mechanism))
        size = max(abs(complex(place)) for place in exact[0].position.values())
        for first, second in found.pairs:
            place, (pole, finite) = found.place(first, second), pole_of(mechanism, exact, first, second)
            if finite and abs(pole) < 100 * size:
                assert abs(place - pole) < 1e-6 * size, (first, second)
