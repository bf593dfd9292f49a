"""Drawings as students hand them in, measured to a hundredth of a millimetre."""

from __future__ import annotations

import cmath
import io
import math
import random
import re
import sys
import zipfile
from collections.abc import Mapping
from pathlib import Path

import book
import pytest

from graphkin import api, loads
from graphkin.errors import LetterTwice, NoLetters, NoScaleDrawn, Where
from graphkin.files import library
from graphkin.model.quantities import read as quantity
from graphkin.proof.readings import readings
from graphkin.submissions import Limits, ReadableProblem, Submission, read_one
from graphkin.submissions.dxf import read_dxf
from graphkin.submissions.handed import Handed
from graphkin.submissions.letters import find_letters, polygons
from graphkin.submissions.questions import Questions
from graphkin.submissions.students import owner
from graphkin.submissions.svg import read_svg

CASES = Path(__file__).parents[1] / "cases" / "submissions"
DRAWING = api.Drawing.of(book.example())
USUAL = Limits()
EVERY = {"v B2", "v B3", "v B3B2", "a B2", "a_n B3D", "a_t B3D", "a_k B3B2", "a_r B3B2", "a B3"}
SCALES = {"m/s": 0.01, "m/s^2": 0.1}
LETTERS = {"velocity": ("p", "b2", "b3"), "acceleration": ("p'", "b2'", "k'", "b3'", "n3'")}
VECTORS = {
    "velocity": (("p", "b2"), ("p", "b3"), ("b2", "b3")),
    "acceleration": (("p'", "b2'"), ("b2'", "k'"), ("k'", "b3'"), ("p'", "n3'"), ("n3'", "b3'"), ("p'", "b3'")),
}


def handed(name: str, content: bytes, limits: Limits = USUAL, drawing: api.Drawing = DRAWING) -> Submission:
    asked = ReadableProblem(drawing.mechanism, drawing.mechanism.ask)
    return read_one(Handed(owner(name), name, files=((name, content),)), asked, limits)


def off(found: Submission, drawing: api.Drawing = DRAWING, scales: Mapping[str, float] = SCALES) -> dict[str, float]:
    """By how much each vector is off [mm]."""
    motions = readings(drawing.method, drawing.plot)
    misses = {}
    for question, value in found.values.items():
        if value.vector is not None:
            known = quantity(drawing.mechanism, question)
            misses[question] = abs(value.vector - complex(known.answer(motions).vector)) / scales[known.unit]
    return misses


def test_saved_by_inkscape():
    """Layers, a turned group, copies, subscripts; one polygon with its scale written, the other known by its first vector."""
    found = handed("a.svg", (CASES / "inkscape-1.2.svg").read_bytes(), Limits(turned=True))
    misses = off(found)
    assert set(misses) >= EVERY - {"v B2"} | {"a B2"}
    assert max(misses.values()) < 0.01
    assert found.values["omega 3"].value == -3.92
    assert math.degrees(found.drawings[1].turned["acceleration"]) == pytest.approx(-20, abs=0.01)
    straight = off(handed("a.svg", (CASES / "inkscape-1.2.svg").read_bytes()))
    assert straight["a B3"] > 10
    assert straight["v B3"] < 0.01


def test_saved_by_geogebra():
    found = handed("a.ggb", (CASES / "geogebra-4.0.ggb").read_bytes())
    misses = off(found)
    assert set(misses) >= EVERY - {"v B2"}
    assert max(misses.values()) < 0.01


def test_geogebra_s_own_order_of_primes_and_numbers():
    """`b'_{3}`, with points alone."""
    marks = []
    for plane, at, mu in (("velocity", 0j, 0.01), ("acceleration", 100 + 0j, 0.1)):
        for letter, place in places(plane, at, mu).items():
            name = re.sub(r"^([a-z])([0-9])('?)$", r"\1\3_{\2}", letter)
            marks.append(f'<element type="point" label="{name}"><coords x="{place.real}" y="{place.imag}" z="1"/></element>')
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        archive.writestr("geogebra.xml", f"<geogebra><construction>{''.join(marks)}</construction></geogebra>")
    misses = off(handed("a.ggb", stream.getvalue()))
    assert set(misses) >= EVERY - {"v B2"}
    assert max(misses.values()) < 0.01


@pytest.mark.many
@pytest.mark.parametrize("name", library.names()[::2])
def test_own_sheets(name: str):
    """Every named vector of a sheet of graphkin's own."""
    drawing = api.Drawing.of(api.load(name))
    found = handed("a.svg", drawing.sheet()._repr_svg_().encode(), drawing=drawing)
    scales = {"m/s": found.drawings[1].scales["velocity"], "m/s^2": found.drawings[1].scales["acceleration"]}
    misses = off(found, drawing, scales)
    assert misses
    assert max(misses.values()) < 0.01


# --- drawings of other programs ---------------------------------------------------------------


def places(plane: str, at: complex, mu: float, turn: float = 0.0) -> dict[str, complex]:
    """The letters of a polygon on the page [mm, y up]."""
    values = DRAWING.plot.points(plane)  # type: ignore[arg-type]
    return {letter: at + cmath.rect(1, turn) * complex(values[letter]) / mu for letter in LETTERS[plane]}


def svg(turn: float = 0.0, scale: float = 1.0, more: str = "", dots: bool = False, unit: str = "mm") -> bytes:
    """Both polygons with letters beside them; nothing names a point but its letter."""
    marks = []
    for plane, at, mu in (("velocity", 60 + 200j, 0.01), ("acceleration", 120 + 120j, 0.1)):
        found = places(plane, at, mu / scale, turn)
        middle = sum(found.values()) / len(found)
        for tail, head in VECTORS[plane]:
            a, b = found[tail], found[head]
            marks.append(f'<path d="M{a.real:.5f} {297 - a.imag:.5f}L{b.real:.5f} {297 - b.imag:.5f}"/>')
        for letter, place in found.items():
            beside = place + 2.5 * (place - middle) / abs(place - middle) - 1 - 1j
            marks.append(f'<text x="{beside.real:.3f}" y="{297 - beside.imag:.3f}" font-size="4">{letter}</text>')
            if dots:
                marks.append(f'<circle cx="{place.real:.5f}" cy="{297 - place.imag:.5f}" r="0.4"/>')
    size = f'width="210{unit}" height="297{unit}" viewBox="0 0 210 297"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size}>{"".join(marks)}{more}</svg>'.encode()


@pytest.mark.parametrize("dots", [False, True])
@pytest.mark.parametrize("turn", [0.0, 30.0, 200.0, 300.0])
def test_letters_beside_their_points(turn: float, dots: bool):
    found = handed("a.svg", svg(math.radians(turn), dots=dots), Limits(turned=True))
    misses = off(found)
    assert set(misses) >= EVERY - {"v B2"}, found.notes
    assert max(misses.values()) < 0.01


def lettered(drawing: api.Drawing, dots: bool, chance: random.Random) -> tuple[bytes, dict[tuple[str, str], complex]]:
    """Both polygons 100 mm wide, each letter where there is room beside its point, and where the points are [mm, y up]."""
    marks, true = [], {}
    for k, shape in enumerate(polygons(drawing.mechanism, Questions(drawing.mechanism))):
        values = drawing.plot.points(shape.plane)
        here = {letter: complex(values[letter]) for letter in shape.letters if letter in values}
        size = max(abs(a - b) for a in here.values() for b in here.values()) or 1.0
        here = {letter: 120 + 150 * k - 150j + z * 100 / size for letter, z in here.items()}
        pairs = [(here[v.tail], here[v.head]) for v in shape.vectors if v.question and v.tail in here and v.head in here]
        lines = [(a, b) for a, b in pairs if a != b]
        marks += [f'<line x1="{a.real:.5f}" y1="{-a.imag:.5f}" x2="{b.real:.5f}" y2="{-b.imag:.5f}"/>' for a, b in lines]
        groups: dict[complex, list[str]] = {}
        for letter, z in here.items():
            groups.setdefault(next((g for g in groups if abs(g - z) < 0.15), z), []).append(letter)
        placed: list[complex] = []
        for z, letters in groups.items():
            spots = [z + cmath.rect(r, j * math.pi / 8 + chance.random() / 10) for j in range(16) for r in (3.5, 5.0)]
            others = [o for o in [*groups, *placed] if o != z]
            spot = max(spots, key=lambda s: room(s, others, lines) - 0.6 * abs(s - z))
            placed.append(spot)
            text = ", ".join(letters)
            corner = f'x="{spot.real - 0.91 * len(text):.3f}" y="{-spot.imag + 1:.3f}"'
            marks.append(f'<text {corner} font-size="3.5">{text}</text>')
            if dots:
                marks.append(f'<circle cx="{z.real:.5f}" cy="{-z.imag:.5f}" r="0.4"/>')
            true |= {(shape.plane, letter): z for letter in letters}
    size = 'width="400mm" height="400mm" viewBox="0 0 400 400"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size}>{"".join(marks)}</svg>'.encode(), true


def room(spot: complex, points: list[complex], lines: list[tuple[complex, complex]]) -> float:
    def off(a: complex, b: complex) -> float:
        share = ((spot - a) * (b - a).conjugate()).real / abs(b - a) ** 2
        return abs(spot - a - max(0.0, min(1.0, share)) * (b - a))

    return min([abs(spot - o) for o in points] + [6.0]) + min([off(*line) for line in lines] + [3.0])


@pytest.mark.parametrize("dots", [False, True])
def test_letters_on_every_kind_of_polygon(dots: bool):
    """Of letters alone, one in a hundred at most is taken for another point's, and one in ten is told to be doubtful."""
    wrong = doubtful = count = 0
    for name in library.names()[::6]:
        drawing = api.Drawing.of(api.load(name))
        content, true = lettered(drawing, dots, random.Random(1))
        shapes = polygons(drawing.mechanism, Questions(drawing.mechanism))
        found = find_letters(read_svg(content, Where("a.svg"), USUAL), shapes, drawing.mechanism.points)[0]
        count += len(true)
        doubtful += sum(key not in found for key in true)
        wrong += sum(abs(found[key] - place) > 0.2 for key, place in true.items() if key in found)
    assert count > 100
    assert wrong <= count / 100
    assert doubtful <= count / 10


def _small(letter: str) -> str:
    return letter.lower()


def _large(letter: str) -> str:
    return letter if letter[0] == "p" else letter.upper()


def _bare(letter: str) -> str:
    return letter if letter[0] == "p" else letter.rstrip("'")


def three_figures(mechanism, velocity, acceleration) -> tuple[api.Drawing, bytes]:  # type: ignore[no-untyped-def]
    """The mechanism and both polygons on one page, all with points called b and c, spelt so."""
    drawing = api.Drawing.of(api.load("ex3-5"))
    pages = [({n: 40 + 40j + complex(z) * 1000 for n, z in drawing.plot.position.items() if n in "ABCDE"}, mechanism,
              ["AB", "BC", "CD", "BE", "CE"])]  # fmt: skip
    for shape, at, mu in zip(polygons(drawing.mechanism, Questions(drawing.mechanism)), (60 + 250j, 150 + 180j), (0.005, 0.05)):
        values = drawing.plot.points(shape.plane)
        there = {n: at + complex(values[n]) / mu for n in shape.letters if n in values}
        lines = [(v.tail, v.head) for v in shape.vectors if v.tail in there and v.head in there]
        pages.append((there, velocity if shape.plane == "velocity" else acceleration, lines))  # type: ignore[arg-type]
    marks = []
    for there, spelt, lines in pages:  # type: ignore[assignment]
        middle = sum(there.values()) / len(there)
        for tail, head in lines:
            a, b = there[tail], there[head]
            marks.append(f'<path d="M{a.real:.5f} {297 - a.imag:.5f}L{b.real:.5f} {297 - b.imag:.5f}"/>')
        for name, z in there.items():
            beside = z + 2.5 * (z - middle) / abs(z - middle) - 1 - 1j
            marks.append(f'<text x="{beside.real:.3f}" y="{297 - beside.imag:.3f}" font-size="4">{spelt(name)}</text>')
    page = f'<svg xmlns="http://www.w3.org/2000/svg" width="210mm" height="297mm" viewBox="0 0 210 297">{"".join(marks)}</svg>'
    return drawing, page.encode()


@pytest.mark.parametrize(
    ("mechanism", "velocity", "acceleration"),
    [(_small, _small, _small), (str, _large, _large), (str, str, _bare), (_small, str, _bare),
     (str, _large, lambda letter: _large(_bare(letter)))],
)  # fmt: skip
def test_letters_that_recur_in_another_figure(mechanism, velocity, acceleration):  # type: ignore[no-untyped-def]
    drawing, page = three_figures(mechanism, velocity, acceleration)
    found = handed("a.svg", page, drawing=drawing)
    misses = off(found, drawing, {"m/s": 0.005, "m/s^2": 0.05})
    assert len(misses) == 11, (found.reason, found.notes)
    assert max(misses.values()) < 0.01


@pytest.mark.parametrize("turn", [0, 40])
def test_directions_of_links_are_measured_on_the_mechanism(turn: int):
    drawing, page = three_figures(str, str, str)
    turned = page.replace(b'297">', f'297"><g transform="rotate({turn} 90 150)">'.encode()).replace(b"</svg>", b"</g></svg>")
    found = handed("a.svg", turned, Limits(turned=True), drawing)
    for link in ("2", "3"):
        assert math.remainder(found.values[f"theta {link}"].value - drawing.plot.theta[link], math.tau) == pytest.approx(0, abs=1e-4)


def test_directions_are_not_taken_off_other_points():
    """C and D exchanged: no link is as long as it is given, and nothing is said rather than something wrong."""
    drawing, page = three_figures(lambda name: {"C": "D", "D": "C"}.get(name, name), str, str)
    assert not {"theta 2", "theta 3"} & set(handed("a.svg", page, drawing=drawing).values)


def test_names_in_place_of_letters():
    names = tuple(letter for plane in LETTERS.values() for letter in plane)
    found = handed("a.svg", re.sub(rb"<text.*?</text>", b"", svg(dots=True)), Limits(names=names))
    assert set(off(found)) >= EVERY - {"v B2"}
    assert max(off(found).values()) < 0.01


def test_a_scale_is_taken_from_the_first_vector_unless_it_is_written():
    calibrated = handed("a.svg", svg(scale=0.8))
    assert calibrated.values["v B3"].value == pytest.approx(0.27120, abs=2e-5)
    written = handed("a.svg", svg(scale=0.8, more='<text x="150" y="20">μ_v = 0.01 (m/s)/mm</text>'))
    assert written.values["v B3"].value == pytest.approx(0.8 * 0.27120, abs=2e-5)


def test_a_value_written_on_the_drawing_keeps_its_drawn_direction():
    found = handed("a.svg", svg(more='<text x="150" y="20">v_B3 = 0.25 m/s</text><text x="150" y="30">v_C = v_B + v_CB</text>'))
    assert found.values["v B3"].value == 0.25
    assert abs(found.values["v B3"].vector) == pytest.approx(0.27120, abs=2e-5)
    assert found.values["v B3"].fault is None


def test_a_letter_at_two_places_is_doubtful():
    twice = b'<path d="M150 250l20 0l0 20z"/><text x="149" y="249" font-size="4">b3</text>'
    drawing = svg().replace(b"<text", twice + b"<text", 1)
    lone = re.sub(rb"<path[^>]*/>", b"", svg())
    found = handed("a.svg", drawing)
    assert max(off(found).values()) < 0.01
    assert isinstance(handed("a.svg", lone).reason, NoLetters | LetterTwice | NoScaleDrawn)


def test_no_letters():
    found = handed("a.svg", re.sub(rb"<text.*?</text>", b"", svg()))
    assert isinstance(found.reason, NoLetters)
    assert "b3" in found.reason.message("zh")


@pytest.mark.parametrize("path", ["M1e300 1e300L-1e308 1e308", "M0 0L1e12 3"])
def test_coordinates_beyond_any_page(path: str):
    found = handed("a.svg", svg(more=f'<path d="{path}"/>'))
    assert type(found.reason).__name__ == "BrokenSubmission"


def test_layers_that_are_hidden_are_not_measured():
    hidden = svg().replace(b"<path", b'<g style="display:none"><path', 1).replace(b"</svg>", b"</g></svg>")
    assert isinstance(handed("a.svg", hidden).reason, NoLetters)


def test_symbols_and_nested_sheets():
    text = (
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="100mm" height="100mm" viewBox="0 0 100 100">'
        '<defs><g id="d"><circle cx="1" cy="1" r=".5"/></g></defs><symbol id="s"><circle cx="2" cy="3" r="1"/></symbol>'
        '<g transform="translate(10 20) rotate(90)"><use href="#d" x="4" y="5"/></g><use xlink:href="#s" x="1"/>'
        '<svg x="10" y="10" width="50" height="50" viewBox="0 0 10 10"><circle id="b3" cx="1" cy="2" r="1"/></svg></svg>'
    )
    dots = [dot.place for dot in read_svg(text.encode(), Where("a.svg"), Limits()).dots]
    assert dots == pytest.approx([10 - 6 - 25j, 3 - 3j, 15 - 20j])


# --- DXF --------------------------------------------------------------------------------------


@pytest.mark.parametrize("unit", [0, 1, 4, 6])
def test_blocks_and_rotated_text(unit: int):
    """One polygon in a block that is turned and scaled, the other plain, in several units."""
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf reads DXF; it is an extra")
    mm = {0: 1.0, 1: 25.4, 4: 1.0, 6: 1000.0}[unit]
    document = ezdxf.new()
    document.header["$INSUNITS"] = unit
    sheet, block = document.modelspace(), document.blocks.new("polygon")
    turn, size = math.radians(-35), 2.0
    for plane, at, mu, layout in (("velocity", 60 + 200j, 0.01, block), ("acceleration", 320 + 120j, 0.1, sheet)):
        found = places(plane, at, mu)
        middle = sum(found.values()) / len(found)
        inner = (lambda z: z * cmath.rect(1 / size, -turn) / mm) if layout is block else (lambda z: z / mm)
        for tail, head in VECTORS[plane]:
            ends = [inner(found[letter]) for letter in (tail, head)]
            layout.add_lwpolyline([(z.real, z.imag) for z in ends]) if tail == "p" else layout.add_line(
                *((z.real, z.imag) for z in ends)
            )
        for k, (letter, place) in enumerate(found.items()):
            outward = (place - middle) / abs(place - middle)
            anchor = inner(place + 2 * outward)
            tall = 3 * abs(inner(1 + 0j) - inner(0j))
            if k % 2:
                layout.add_mtext(letter, {"char_height": tall, "attachment_point": 5, "insert": (anchor.real, anchor.imag), "rotation": 30})
            else:
                text = layout.add_text(letter, height=tall, rotation=40)
                text.set_placement((anchor.real, anchor.imag), align=ezdxf.enums.TextEntityAlignment.MIDDLE_CENTER)
    sheet.add_blockref("polygon", (0, 0), {"xscale": size, "yscale": size, "rotation": math.degrees(turn)})
    stream = io.StringIO()
    document.write(stream)
    found = handed("a.dxf", stream.getvalue().encode())
    misses = off(found)
    assert set(misses) >= EVERY - {"v B2"}, (found.reason, found.notes)
    assert max(misses.values()) < 0.01


def test_raised_and_lowered_pieces_of_a_text():
    """As `graphkin draw` and CAD programs set them: a scale and a letter with its number."""
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf reads DXF; it is an extra")
    document, stream = ezdxf.new(), io.StringIO()
    for text in ("μ{\\H0.7x;\\S^ v;} = 0.01", "a{\\H0.7x;\\Sn^ CD;}", "2 rad/s^ 2"):
        document.modelspace().add_mtext(text, {"char_height": 3})
    document.write(stream)
    found = read_dxf(stream.getvalue().encode(), Where("a.dxf"), Limits())
    assert [text.text for text in found.texts] == ["μ_v = 0.01", "a^n_CD", "2 rad/s^2"]


def test_dxf_without_its_reader(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    assert "pip install ezdxf" in handed("a.dxf", b"0\nEOF\n").reason.message("en")


# --- remarks on how a page looks ----------------------------------------------------------------


def seen(found: Submission) -> list[str]:
    return [remark.id for drawing in found.drawings.values() for remark in drawing.remarks]


@pytest.mark.parametrize("turn", [37.0, 90.0, 180.0, 270.0])
def test_a_turned_page_is_remarked_upon(turn: float):
    (remark,) = handed("a.svg", svg(math.radians(turn))).drawings[1].remarks
    assert (remark.id, round(remark.degrees)) == ("turned", turn)
    assert seen(handed("a.svg", svg(math.radians(turn)), Limits(turned=True))) == []
    assert seen(handed("a.svg", svg())) == []


def test_a_polygon_alone_that_is_upside_down_may_be_a_mistake():
    """A driver taken the other way round turns the velocity polygon, and nothing else."""
    marks = {turn: re.findall(rb"<(?:path[^>]*/|text.*?</text)>", svg(math.radians(turn))) for turn in (0, 90, 180)}
    count = len(VECTORS["velocity"]) + len(LETTERS["velocity"])
    start, accelerations = svg().partition(b"<path")[0], marks[0][count:]
    pages = {turn: start + b"".join(some[:count]) for turn, some in marks.items()}
    both = handed("a.svg", pages[180] + b"".join(accelerations) + b"</svg>")
    assert set(off(both)) >= EVERY - {"v B2"}
    assert seen(both) == []
    assert [seen(handed("a.svg", pages[turn] + b"</svg>")) for turn in (0, 90, 180)] == [[], ["turned"], []]


def test_the_mechanism_tells_a_turned_page_from_a_reversed_driver():
    drawing, page = three_figures(str, str, str)
    turned = page.replace(b'297">', b'297"><g transform="rotate(180 90 150)">').replace(b"</svg>", b"</g></svg>")
    assert seen(handed("a.svg", turned, drawing=drawing)) == ["turned"]
    assert seen(handed("a.svg", page, drawing=drawing)) == []


def test_a_sheet_of_graphkin_s_own_is_remarked_upon():
    page = DRAWING.sheet()._repr_svg_().encode()
    assert seen(handed("a.svg", page)) == ["own-sheet"]
    assert seen(handed("a.svg", svg(dots=True))) == []
    other = loads(DRAWING.mechanism.text.replace("omega = 10", "omega = -10"))
    assert other.drivers[0].rate == -DRAWING.mechanism.drivers[0].rate
    assert seen(handed("a.svg", api.Drawing.of(other).sheet()._repr_svg_().encode())) == []
