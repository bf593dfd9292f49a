"""The sheet on paper: how much of it is used, its layers, and letters that stand where every viewer puts them."""

from __future__ import annotations

import math
import re
import shutil
import subprocess
from functools import cache
from pathlib import Path
from statistics import median
from xml.etree.ElementTree import Element

import browsing
import pytest
from defusedxml.ElementTree import fromstring
from library_sheets import drawing, library_sheet, plain_text

from graphkin import Drawing
from graphkin.check import measure
from graphkin.files import library, loads
from graphkin.outputs.svg import svg
from graphkin.outputs.typesetting import runs
from graphkin.sheet.lettering import number, plain, point_label, quantity_label, vector_label
from graphkin.sheet.marks import Text

SVG = "{http://www.w3.org/2000/svg}"
LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"
FIGURES_OF_ALL = Path(__file__).parents[2] / "figures"
FIGURES = ("mechanism", "velocity", "acceleration")
THIN = ("p3-6b",)
"""All its points on one line, its velocities on another: it has length alone to fill a paper with."""


@cache
def text(name: str, **options: object) -> str:
    return svg(drawing(name).sheet(**options) if options else library_sheet(name))  # type: ignore[arg-type]


def layers(root: Element) -> dict[str, Element]:
    return {group.get(LABEL, ""): group for group in root.findall(f"{SVG}g")}


def places(group: Element) -> list[complex]:
    """Corners of what is drawn in a layer, without letters."""
    found: list[complex] = []
    for element in group.iter():
        if element.tag == f"{SVG}line":
            found += [complex(*(float(element.get(k, "")) for k in (f"x{n}", f"y{n}"))) for n in (1, 2)]
        elif element.tag == f"{SVG}circle":
            at, r = complex(*(float(element.get(k, "")) for k in ("cx", "cy"))), float(element.get("r", ""))
            found += [at - complex(r, r), at + complex(r, r)]
        elif element.tag == f"{SVG}path" and "A" not in element.get("d", ""):
            numbers = [float(n) for n in re.findall(r"-?[0-9.]+", element.get("d", ""))]
            found += [complex(x, y) for x, y in zip(numbers[::2], numbers[1::2], strict=True)]
    return found


def used(drawing: str) -> float:
    """The boxes of the three figures with their letters around them, over the drawing field."""
    root = fromstring(drawing)
    width, height = (float(value) for value in root.get("viewBox", "").split()[2:])
    strip = [e for e in layers(root)["sheet"].iter(f"{SVG}line") if float(e.get("x2", "")) - float(e.get("x1", "")) > width - 31]
    field = (width - 30) * (min(float(line.get("y1", "")) for line in strip) - 10)
    area = 0.0
    for name in FIGURES:
        corners = places(layers(root)[name])
        wide, high = (max(axis) - min(axis) for axis in ([p.real for p in corners], [p.imag for p in corners]))
        area += (wide + 8) * (high + 8)
    assert height > 200
    return area / field


@pytest.fixture(scope="module")
def library_use() -> dict[str, float]:
    return {name: used((FIGURES_OF_ALL / name / f"{name}.svg").read_text(encoding="utf-8")) for name in library.names()}


def test_the_paper_is_used(library_use: dict[str, float]) -> None:
    assert median(library_use.values()) >= 0.5
    assert {name for name, share in library_use.items() if share < 0.3} <= set(THIN)


@pytest.mark.parametrize("name", ["ex3-1", "p3-12", "p3-3c"])
def test_layers_in_the_order_of_painting(name: str) -> None:
    order = ["sheet", *FIGURES, "leaders", "labels"]
    assert [layer for layer in order if layer in layers(fromstring(text(name)))] == list(layers(fromstring(text(name))))
    assert {"sheet", *FIGURES, "labels"} <= set(layers(fromstring(text(name))))


def test_a_vector_says_what_it_is() -> None:
    root = fromstring(text("ex3-1"))
    titles = {v.get("data-name"): v.findtext(f"{SVG}title") for v in root.iter(f"{SVG}line") if v.get("class") == "vector"}
    assert titles["v_B3"] == "v_B3 = 0.2712 m/s"
    assert titles["a^k_B3B2"] == "a^k_B3B2 = 2.515 m/s²"
    assert root.get("role") == "img"
    assert root.findtext(f"{SVG}desc")


@pytest.mark.parametrize("only", ["position", "velocity", "acceleration"])
@pytest.mark.parametrize("tight", [False, True])
def test_a_single_figure_cuts_its_page(only: str, tight: bool, tmp_path: Path) -> None:
    drawing = text("ex3-1", only=only, tight=tight)
    root = fromstring(drawing)
    wide, high = (float(v) for v in root.get("viewBox", "").split()[2:])
    corners = places(layers(root)[{"position": "mechanism"}.get(only, only)])
    assert high - max(p.imag for p in corners) < (12 if tight else 65)
    assert ("sheet" in layers(root)) is not tight
    assert wide <= 297 if tight else wide in (210, 297)
    path = tmp_path / "a.svg"
    path.write_text(drawing, encoding="utf-8")
    assert measure(path).passed(0.01)


def test_letter_paper() -> None:
    assert fromstring(text("ex3-1", paper="letter")).get("width") == "215.9mm"


def test_five_widths_and_three_sizes_of_letters() -> None:
    root = fromstring(text("p3-20"))
    assert {e.get("stroke-width") for e in root.iter()} - {None} == {"0.13", "0.18", "0.35", "0.5", "0.7"}
    texts = [e for e in root.iter() if e.tag.endswith("}text")]
    assert {float(e.get("font-size", "")) for e in texts} == {5.0, 3.5, 2.5}
    assert {float(e.get("font-size", "")) for text in texts for e in text if e.get("font-size")} == {2.45}


def test_letters_of_a_large_paper_are_as_high_as_the_least_of_iso_3098_when_it_is_printed_as_a4() -> None:
    root = fromstring(text("ex3-1", paper="A3"))
    sizes = sorted({float(e.get("font-size", "")) for e in root.iter() if e.tag.endswith("}text")})
    assert sizes == pytest.approx([2.75, 3.85, 5.5])
    assert 0.662 * 3.85 / math.sqrt(2) == pytest.approx(1.8, abs=0.005)
    ruler = next(e for e in root.iter() if e.get("data-form") == "ruler")
    assert float(ruler.get("x2", "")) - float(ruler.get("x1", "")) == pytest.approx(100, abs=1e-3)


def test_black_ink_is_all_black() -> None:
    sheet = Drawing.of(library.load("ex3-7")).sheet()
    paints = re.findall(r'(?:fill|stroke)="(#[0-9a-f]{6})"', svg(sheet, ink="black"))
    assert set(paints) == {"#000000", "#ffffff"}
    assert {"#0b4f9c", "#a3200d"} <= set(re.findall(r'(?:fill|stroke)="(#[0-9a-f]{6})"', svg(sheet)))


# --- letters ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "label",
    [point_label("b3'"), vector_label("a^n_B3D"), quantity_label("μ", "l") + plain(" = ") + number(2e-5), plain("p, a, d")],
)
def test_no_span_begins_with_a_space(label: tuple) -> None:
    found = runs(Text(label, 10 + 10j, 3.8))
    assert "".join(span.text for span in found) == "".join(run.text for run in label)
    assert not [span for span in found if span.text.startswith(" ")]


def _resvg(path: Path, image: Path) -> None:
    resvg_py = pytest.importorskip("resvg_py")
    image.write_bytes(bytes(resvg_py.svg_to_bytes(svg_path=str(path), dpi=127, background="white")))


def _run(command: str, *arguments: str) -> None:
    if shutil.which(command) is None:
        pytest.skip(f"{command} is not here")
    subprocess.run([command, *arguments], check=True, capture_output=True, timeout=120)


def _librsvg(path: Path, image: Path) -> None:
    _run("rsvg-convert", "-d", "127", "-p", "127", "-b", "white", str(path), "-o", str(image))


def _inkscape(path: Path, image: Path) -> None:
    _run("inkscape", "-d", "127", "-b", "white", "-y", "1", str(path), "-o", str(image))


def _chromium(path: Path, image: Path) -> None:
    """A picture of the window, in which a page of A4 lies at its corner."""
    browser = next(filter(shutil.which, browsing.NAMES), "chromium")
    page = ("--window-size=794,1123", f"--force-device-scale-factor={127 / 96}", "--hide-scrollbars", f"file://{path}")
    own = ("--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={path.parent / 'browser'}")
    _run(browser, *own, f"--screenshot={image}", *page)


def _typst(path: Path, image: Path) -> None:
    typst = pytest.importorskip("typst")
    page = path.with_suffix(".typ")
    page.write_text(f'#set page(width: 210mm, height: 297mm, margin: 0mm)\n#image("{path.name}", width: 210mm)', encoding="utf-8")
    typst.compile(str(page), output=str(image), ppi=127.0)


VIEWERS = {"librsvg": _librsvg, "inkscape": _inkscape, "chromium": _chromium, "typst": _typst}


@pytest.mark.parametrize("viewer", VIEWERS)
def test_viewers_put_letters_at_the_same_places(viewer: str, tmp_path: Path) -> None:
    """Five pixels to the millimetre; where resvg has ink of a letter, the other has some within half a millimetre."""
    import numpy as np
    from matplotlib.image import imread

    path, one, other = tmp_path / "a.svg", tmp_path / "one.png", tmp_path / "other.png"
    path.write_text(text("ex3-1", paper="A4"), encoding="utf-8")
    _resvg(path, one)
    VIEWERS[viewer](path, other)
    first, second = (np.asarray(imread(image))[..., :3].mean(axis=2) < 0.7 for image in (one, other))
    high, wide = (min(sizes) for sizes in zip(first.shape, second.shape, strict=True))
    near = np.zeros((high, wide), dtype=bool)
    for dy in range(-2, 3):
        for dx in range(-2, 3):
            near |= np.roll(second[:high, :wide], (dy, dx), axis=(0, 1))
    assert abs(first.shape[0] - second.shape[0]) <= 2
    assert (first[:high, :wide] & ~near).sum() <= 0.003 * first.sum()


LIFT = """
frame = { name = "6", A = [0, 0], D = [200, 0], H = [90, -40] }
[links]
1 = { AB = 240, AK = 120, BK = 120 }
2 = { BC = 200, BE = 260, CE = 103.65, ccw = ["B", "C", "E"] }
3.DC = 240
4.points = ["H"]
5.points = ["K"]
[[slide]]
name = "cylinder"
block = "5"
point = "K"
guide = "4"
[[driver]]
slide = "cylinder"
at = 110
velocity = 0.05
[sketch]
B = [170, 170]
K = [85, 85]
C = [370, 170]
E = [400, 260]
"""


def test_a_paper_with_too_little_room_says_so() -> None:
    """At fine scales the rows under equations go first, then these; the tables stay, and the foot tells it."""
    fine = loads(LIFT + "[scales]\nlength = 0.004\nvelocity = 0.002\nacceleration = 0.0006\n")
    words = {plain_text(m.label) for m in Drawing.of(fine).sheet(paper="A4-landscape").marks if isinstance(m, Text)}
    assert "no room for all equations at these scales" in words
    assert {"ω [rad/s]", "α [rad/s²]"} <= words
    less = loads(LIFT + "[scales]\nlength = 0.004\nvelocity = 0.003\nacceleration = 0.0006\n")
    words = {plain_text(m.label) for m in Drawing.of(less).sheet(paper="A4-landscape").marks if isinstance(m, Text)}
    assert "directions and magnitudes: see the solution" in words
    assert "direction:" not in words
    assert any(word.startswith("∽") or "=" in word for word in words)
