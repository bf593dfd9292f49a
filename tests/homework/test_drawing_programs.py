"""Drawings that Inkscape and GeoGebra write themselves, handed in through Moodle: measured, marked, nobody's lost."""

from __future__ import annotations

import html
import json
import re
from pathlib import Path

import pytest
from click.testing import CliRunner
from drawing_programs import by_geogebra, by_inkscape, needed
from the_week import LINES, TEMPLATES, Polygons, Pupil, given, packed, polygons, pupils, school_list, worksheet

from graphkin.cli import main

TWO = pupils()[:2]
AT = {"velocity": 150 + 150j, "acceleration": 150 + 310j}  # their middles on the page [mm]
PX = 96 / 25.4
ASKED = ("omega 2", "omega 3", "alpha 3", "v C")


def run(*words: str) -> str:
    done = CliRunner().invoke(main, list(words))
    assert done.exit_code == 0, done.output
    return done.stdout


def page_of(one: Pupil) -> str:
    return Path("week/students", f"{one.id}.html").read_text("utf-8")


def on_paper(one: Pupil, wrong: str) -> Polygons:
    """The student's polygons at the scales of the student's page [mm, y down]."""
    text = re.sub(r"\s+", " ", html.unescape(re.sub(r"<svg.*?</svg>|<[^>]*>", " ", page_of(one), flags=re.S)))
    scales = {plane: float(re.search(rf"μ {letter} = ([\d.]+)", text)[1]) for plane, letter in (("velocity", "v"), ("acceleration", "a"))}
    paper = {}
    for plane, places in polygons(*given(page_of(one)), wrong).items():
        drawn = {letter: (place / scales[plane]).conjugate() for letter, place in places.items()}
        across, down = ([getattr(place, way) for place in drawn.values()] for way in ("real", "imag"))
        middle = complex(min(across) + max(across), min(down) + max(down)) / 2
        paper[plane] = {letter: AT[plane] + place - middle for letter, place in drawn.items()}
    return paper


def ends(line: str) -> list[str]:
    return re.findall(r"[a-z]\d?′?", line)


def on_the_sheet(one: Pupil, wrong: str) -> str:
    """The figure that was handed out, on a larger page, with both polygons in layers, in pixels."""
    (figure,) = re.findall(r"<svg.*?</svg>", page_of(one), flags=re.S)
    marks = []
    for plane, places in on_paper(one, wrong).items():
        middle = sum(places.values()) / len(places)
        for a, b in (ends(line) for line in LINES[plane]):
            tail, head = PX * places[a], PX * places[b]
            marks.append(f'<path d="M{tail.real:.4f} {tail.imag:.4f}L{head.real:.4f} {head.imag:.4f}" style="stroke:#000;fill:none"/>')
        for letter, place in places.items():
            beside = PX * (place + 3 * (place - middle) / abs(place - middle) - 1 + 1j)
            marks.append(f'<text x="{beside.real:.2f}" y="{beside.imag:.2f}" style="font-size:12px">{letter}</text>')
    larger = re.sub(r'height="\S+mm"', 'height="420mm"', re.sub(r'width="\S+mm"', 'width="297mm"', figure, count=1), count=1)
    larger = re.sub(r'viewBox="[^"]*"', 'viewBox="0 0 297 420"', larger, count=1)
    return larger.replace("</svg>", f'<g transform="scale({1 / PX})">{"".join(marks)}</g></svg>')


def typed(one: Pupil, wrong: str) -> list[str]:
    """Points, which the program begins with capital letters, renamed, and vectors between them; a unit is a millimetre."""
    lines = []
    for plane, places in on_paper(one, wrong).items():
        names = {letter: re.sub(r"^(.)(\d?)(′?)$", _label, letter) for letter in places}
        for letter, place in places.items():
            lines += [f"Q=({place.real!r},{-place.imag!r})", f"rename Q {names[letter]}"]
        lines += ["Vector[{},{}]".format(*(names[letter] for letter in ends(line))) for line in LINES[plane]]
    return lines


def _label(letter: re.Match[str]) -> str:
    """Of n2′ n'_{2}."""
    return letter[1] + letter[3].replace("′", "'") + (f"_{{{letter[2]}}}" if letter[2] else "")


@pytest.mark.parametrize("program", ["Inkscape", "GeoGebra"])
def test_drawings_of_a_program(program: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """One draws rightly, one with a normal acceleration that points away from the centre."""
    needed(program)
    monkeypatch.chdir(tmp_path)
    for name, text in (("p1.toml", TEMPLATES["p1"]), ("list.csv", school_list(TWO)), ("worksheet.csv", worksheet(TWO))):
        Path(name).write_text(text, "utf-8")
    run("problems", "p1.toml", "--students", "list.csv", "--seed", "2027", "-o", "week", "--lang", "zh")
    kinds = ["", "mistake"]
    if program == "Inkscape":
        files, ending = by_inkscape([on_the_sheet(*each) for each in zip(TWO, kinds)], tmp_path), "svg"
    else:
        files, ending = by_geogebra([typed(*each) for each in zip(TWO, kinds)], tmp_path), "ggb"
    packed(Path("p1.zip"), {f"{one.folder}{one.name}.{ending}": file for one, file in zip(TWO, files)})
    found = [json.loads(line) for line in run("grade", "week", "p1.zip", "--roster", "worksheet.csv", "--json").splitlines()]
    assert [(one["student"], one["status"]) for one in found] == [(one.id, "marked") for one in TWO]
    for one, kind in zip(found, kinds):
        verdicts = {text: each["verdict"] for text, each in one["quantities"].items() if text in ASKED}
        assert verdicts == {"omega 2": "right", "omega 3": "right", "alpha 3": "wrong" if kind else "right", "v C": "right"}
        assert [each["ids"][0] for each in one["mistakes"]] == ["normal-outward"] * bool(kind)
