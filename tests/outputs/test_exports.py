"""Drawings as files of other programs, each read back by a reader that graphkin does not write with."""

from __future__ import annotations

import io
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest
from click.testing import CliRunner
from pdf_lines import lines

import graphkin
from graphkin.cli import main
from graphkin.outputs import drawings, paged
from graphkin.outputs.saving import NotebookSheet
from graphkin.sheet.marks import VectorMark

MUCH = "GRAPHKIN_TEX" in os.environ
"""All that TeX may compile takes a minute."""
NAMES = ("ex3-1", "ex3-4", "p3-22", "curved-slot")


def _picture(name: str) -> NotebookSheet:
    return graphkin.Drawing.of(name).sheet()


def _ends(picture: NotebookSheet) -> list[tuple[complex, complex]]:
    """Of every vector, from the foot of the paper up [mm]."""
    up = complex(0, picture.paper.height)
    vectors = [mark for mark in picture.marks if isinstance(mark, VectorMark)]
    return [(up + v.start.conjugate(), up + v.end.conjugate()) for v in vectors]


def _hold(found: list[tuple[complex, complex]], wanted: list[tuple[complex, complex]]) -> None:
    """Every vector is there to 0.01 mm."""
    for start, end in wanted:
        assert min(max(abs(start - a), abs(end - b)) for a, b in found) < 0.01


@pytest.mark.parametrize("name", NAMES)
def test_dxf_holds_every_vector(name: str, tmp_path: Path):
    ezdxf = pytest.importorskip("ezdxf")
    picture = _picture(name)
    path = tmp_path / "a.dxf"
    picture.save(path)
    document = ezdxf.readfile(path)
    assert document.header["$INSUNITS"] == 4
    lines = document.modelspace().query("LINE")
    _hold([(complex(*e.dxf.start.vec2), complex(*e.dxf.end.vec2)) for e in lines], _ends(picture))
    assert {line.dxf.layer for line in lines} >= {"velocity", "acceleration"}
    assert not document.audit().errors


@pytest.mark.parametrize("name", NAMES)
def test_tikz_holds_every_vector(name: str):
    picture = _picture(name)
    text = picture.content(Path("a" + ".tex")).decode()
    number = r"(-?[\d.]+)"
    lines = re.findall(rf"arrow\] \({number}, {number}\) -- \({number}, {number}\);", text)
    up = picture.paper.height
    found = [(complex(float(a), up - float(b)), complex(float(c), up - float(d))) for a, b, c, d in lines]
    _hold(found, [(a, b) for a, b in _ends(picture) if abs(a - b) > 0.05])


def _compiled(text: bytes, folder: Path, program: str = "pdflatex") -> Path:
    if shutil.which(program) is None:
        pytest.skip("no TeX here")
    (folder / "a.tex").write_bytes(text)
    command = [program, "-interaction=nonstopmode", "-halt-on-error", "a.tex"]
    done = subprocess.run(command, cwd=folder, capture_output=True, check=False)
    if program == "xelatex" and b"ctex.sty' not found" in done.stdout:
        pytest.skip("no Chinese TeX here")
    assert done.returncode == 0, done.stdout[-2000:]
    return folder / "a.pdf"


@pytest.mark.parametrize("name", [*NAMES, "ex3-3"] if MUCH else ["ex3-1"])
def test_tikz_compiles_to_scale(name: str, tmp_path: Path):
    """Every arrow starts at its place and points along its vector; its head takes as much off it as off the others."""
    pypdf = pytest.importorskip("pypdf")
    picture = _picture(name)
    reader = pypdf.PdfReader(_compiled(picture.content(Path("a" + ".tex")), tmp_path))
    (page,) = reader.pages
    paper = picture.paper
    assert [float(length) * 25.4 / 72 for length in page.mediabox[2:]] == pytest.approx([paper.width, paper.height], abs=0.01)
    drawn, heads = list(lines(reader, page)), []
    for start, end in _ends(picture):
        if abs(end - start) > 4:
            along = (end - start) / abs(end - start)
            left = [(end - b) / along for a, b in drawn if abs(a - start) < 0.01 and abs(((b - start) / along).imag) < 0.01]
            heads.append(min((off.real for off in left if off.real > 1), default=99.0))
    assert len(heads) > 5
    assert 1.4 < min(heads) <= max(heads) < 1.9
    assert len({round(off, 1) for off in heads}) <= 2


@pytest.mark.parametrize(("lang", "program"), [("en", "pdflatex"), ("zh", "xelatex")] if MUCH else [("en", "pdflatex")])
@pytest.mark.parametrize("command", ["draw", "explain", "equations"] if MUCH else ["explain"])
def test_tex_compiles_in_both_languages(command: str, lang: str, program: str, tmp_path: Path):
    written = tmp_path / "written.tex"
    done = CliRunner().invoke(main, [command, "p3-22", "--lang", lang, "-o", str(written)])
    assert done.exit_code == 0, done.output
    _compiled(written.read_bytes(), tmp_path, program)
    assert "Overfull" not in (tmp_path / "a.log").read_text(encoding="utf-8", errors="replace")


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_pdf_is_as_large_as_the_paper(lang: str, tmp_path: Path):
    pytest.importorskip("typst")
    pypdf = pytest.importorskip("pypdf")
    path = tmp_path / "a.pdf"
    done = CliRunner().invoke(main, ["draw", "ex3-1", "-o", str(path), "--lang", lang])
    assert done.exit_code == 0, done.output
    first = path.read_bytes()
    page, paper = pypdf.PdfReader(path).pages[0], graphkin.Drawing.of(graphkin.load("ex3-1")).sheet().paper
    assert {paper.width, paper.height} == {210, 297}
    assert abs(float(page.mediabox.width) - paper.width * 72 / 25.4) < 0.01
    assert abs(float(page.mediabox.height) - paper.height * 72 / 25.4) < 0.01
    assert CliRunner().invoke(main, ["draw", "ex3-1", "-o", str(path), "--lang", lang]).exit_code == 0
    assert path.read_bytes() == first


def test_png_says_how_large_it_is(tmp_path: Path):
    pytest.importorskip("resvg_py")
    image = pytest.importorskip("PIL.Image")
    path = tmp_path / "a.png"
    assert CliRunner().invoke(main, ["draw", "ex3-5", "-o", str(path), "--dpi", "100"]).exit_code == 0
    with image.open(path) as picture:
        assert picture.size == (1169, 827)
        assert abs(picture.info["dpi"][0] - 100) < 0.1


def test_png_has_letters_on_a_machine_without_fonts():
    """What matplotlib brings stands in; without any font resvg would leave the text out."""
    resvg, image = pytest.importorskip("resvg_py"), pytest.importorskip("PIL.Image")
    size = 'width="90" height="30" font-family="Nobody, serif"'
    text = f'<svg xmlns="http://www.w3.org/2000/svg" {size}><text y="20">{{}}</text></svg>'

    def ink(letters: str, **fonts: object) -> int:
        drawn = {"svg_string": text.format(letters), "background": "#ffffff", "skip_system_fonts": True}
        made = bytes(resvg.svg_to_bytes(**drawn, **fonts))
        return sum(image.open(io.BytesIO(made)).convert("L").histogram()[:128])

    for letters in ("v", "ω", "μ", "α", "φ", "⊥", "∥", "√", "′", "→", "²"):
        assert ink(letters, serif_family=paged.SERIF, font_files=paged.serif_files()) > ink(letters) == 0, letters


@pytest.mark.parametrize("kind", drawings.DRAWN)
def test_a_file_of_another_is_kept(kind: str, tmp_path: Path):
    path = tmp_path / f"a{kind}"
    path.write_bytes(b"mine")
    done = CliRunner().invoke(main, ["draw", "ex3-1", "-o", str(path)])
    assert done.exit_code == 3, done.output
    assert path.read_bytes() == b"mine"
    path.unlink()
    for _ in range(2):
        done = CliRunner().invoke(main, ["draw", "ex3-1", "-o", str(path)])
        assert done.exit_code == 0, done.output


def test_a_package_that_is_missing_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setitem(__import__("sys").modules, "ezdxf", None)
    done = CliRunner().invoke(main, ["draw", "ex3-1", "-o", str(tmp_path / "a.dxf")])
    assert done.exit_code == 3, done.output
    assert "graphkin[dxf]" in done.output
    assert not list(tmp_path.iterdir())
