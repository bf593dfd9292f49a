"""A sheet as PDF in its true size, by typst; or as PNG, by resvg.

The PDF says how it is to be read aloud, and asks for no scaling when printed; the same sheet gives the same bytes.
"""

from __future__ import annotations

import io
import re
import struct
import zlib
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path

from graphkin.errors import Lang, OutOfRange, Where
from graphkin.outputs.files import needed
from graphkin.outputs.paint import Ink
from graphkin.outputs.svg import svg
from graphkin.sheet import Sheet

MARK = b"graphkin sheet"
SERIF = "STIXGeneral"
_COLOURS = 64  # of a moving picture
_PAGE = """#set document(title: sys.inputs.title, author: "graphkin sheet", date: none)
#set text(lang: sys.inputs.lang)
#set page(width: {width}mm, height: {height}mm, margin: 0mm)
#image(bytes(sys.inputs.svg), format: "svg", width: {width}mm, height: {height}mm, alt: sys.inputs.alt)
"""


def pdf(sheet: Sheet, lang: Lang, ink: Ink = "accent") -> bytes:
    """One page as large as the paper, after PDF/UA-1. Raises NeedsExtra without typst."""
    typst = needed("typst", "pdf")
    title = sheet.mechanism.headline(lang)
    page = _PAGE.format(width=sheet.paper.width, height=sheet.paper.height)
    inputs = {"svg": svg(sheet, ink), "title": title, "alt": title, "lang": lang}
    made: bytes = typst.compile(page.encode(), sys_inputs=inputs, timestamp=0, pdf_standards=["ua-1"], format="pdf")
    return unscaled(made)


def unscaled(content: bytes) -> bytes:
    """A PDF that asks to be printed as large as it is: its catalog once more at the end, as PDF lets a file be changed.
    As it was, where its catalog is not found."""
    trailer = content[content.rfind(b"trailer") :]
    root, start = re.search(rb"/Root (\d+) 0 R", trailer), re.search(rb"startxref\s+(\d+)", trailer)
    if root is None or start is None or re.search(rb"/Size (\d+)", trailer) is None:
        return content
    number = root[1]
    catalog = re.search(rb"(?<!\d)%s 0 obj\s.*?endobj" % number, content, re.DOTALL)
    if catalog is None or b"/ViewerPreferences<<" not in catalog[0]:
        return content
    changed = catalog[0].replace(b"/ViewerPreferences<<", b"/ViewerPreferences<</PrintScaling/None")
    body = content.rstrip(b"\n") + b"\n"
    table = b"xref\n%s 1\n%010d 00000 n \n" % (number, len(body))
    entries = re.sub(rb"startxref.*", b"", trailer, flags=re.DOTALL).replace(b"trailer", b"", 1).strip()
    end = b"trailer\n" + entries[:-2] + b"/Prev " + start[1] + b">>\n"
    return body + changed + b"\n" + table + end + b"startxref\n%d\n%%%%EOF\n" % (len(body) + len(changed) + 1)


def serif_files() -> list[str]:
    """A serif that comes with matplotlib, for machines that have none: resvg leaves out text that has no font."""
    spec = find_spec("matplotlib")
    folder = Path(spec.origin or "").parent / "mpl-data/fonts/ttf" if spec else Path()
    return [str(file) for file in sorted(folder.glob(f"{SERIF}*.ttf"))]


def png(sheet: Sheet, dpi: float, ink: Ink = "accent") -> bytes:
    """The sheet at so many dots per inch, with who made it, and how large it is meant to be. Raises NeedsExtra without
    resvg-py."""
    return raster(svg(sheet, ink), dpi)


def raster(drawing: str, dpi: float) -> bytes:
    """The same of an SVG file's text. Raises OutOfRange."""
    if not 20 <= dpi <= 2400:
        raise OutOfRange(Where("dpi"), f"{dpi:g}")
    resvg = needed("resvg_py", "png")
    fonts = {"serif_family": SERIF, "font_files": serif_files()}
    content = bytes(resvg.svg_to_bytes(svg_string=drawing, dpi=dpi, background="#ffffff", **fonts))
    first = 8 + 25  # the signature, and the chunk that every PNG begins with
    metres = round(dpi / 0.0254)
    stated = _chunk(b"tEXt", b"Software\0" + MARK) + _chunk(b"pHYs", struct.pack(">IIB", metres, metres, 1))
    return content[:first] + stated + content[first:]


def moving_png(sheets: Sequence[Sheet], dpi: float, seconds: float, ink: Ink = "accent") -> bytes:
    """The sheets one after the other, again and again (APNG): few colours, and of each only what is new. Raises
    NeedsExtra without resvg-py."""
    from PIL import Image, PngImagePlugin

    pictures = [Image.open(io.BytesIO(png(sheet, dpi, ink))).convert("RGB") for sheet in sheets]
    palette = pictures[0].quantize(_COLOURS, dither=Image.Dither.NONE)
    few = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]
    info, made = PngImagePlugin.PngInfo(), io.BytesIO()
    info.add_text("Software", MARK.decode())
    few[0].save(
        made, "PNG", save_all=True, append_images=few[1:], duration=1000 * seconds / len(few), loop=0,
        dpi=(dpi, dpi), pnginfo=info, optimize=True,
    )  # fmt: skip
    return made.getvalue()


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
