"""Submissions that are broken in every way that comes to mind, by a seed."""

from __future__ import annotations

import io
import json
import random
import warnings
import zipfile
from collections.abc import Callable
from pathlib import Path

__all__ = ["broken"]

CASES = Path(__file__).parent / "cases" / "submissions"
TOML = 'student = "{student}"\n[answers]\n"omega 3" = {a}\n"alpha 3" = "{b} rad/s^2 ccw"\n"a_k B3B2" = {c}\n[scales]\nvelocity = 0.01\n'
NUMBERS = ("nan", "inf", "-inf", "1e308", "-1e308", "1e999", "9" * 400, "0", "-0.0", "5e-324", "true", '""', "[]", "{}", '"--1"', "1_0", '"1,2,3"',
           '"=HYPERLINK(1)"', '"\\u0000"', "3.92", '"3.92 cw ccw"', '"∞"', '"１e９９"', "0x1F", "1979-05-27")  # fmt: skip
STUDENTS = ("s1", "../../etc/passwd", "/etc/passwd", "C:\\\\Windows\\\\x", "", " ", "a" * 5000, "\\u202Ex", "学号", "con", "..", "s1\\n", "%00", "\\u0007")
MEMBERS = ("../../evil.toml", "/abs/evil.toml", "a/../../b.toml", "C:\\x.toml", "x" * 300 + ".toml", "nul.toml", "学.toml", ".toml", "a.exe", "dir/",
           "First Last_1_assignsubmission_file_/../../x.toml")  # fmt: skip
SVG = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="{w}" height="297mm" viewBox="{v}">{x}</svg>'


def broken(seed: int) -> tuple[str, bytes]:
    """A file's name and its bytes."""
    chance = random.Random(seed)
    make = chance.choice(_MAKERS)
    name, content = make(chance)
    for _ in range(chance.choice((0, 1, 1, 2))):
        content = chance.choice(_HARMS)(chance, content)
    return name, content


# --- files ------------------------------------------------------------------------------------


def _toml(chance: random.Random) -> tuple[str, bytes]:
    a, c = chance.choice(NUMBERS), chance.choice(NUMBERS)
    text = TOML.format(student=chance.choice(STUDENTS), a=a, b=chance.choice(NUMBERS).strip('"'), c=c)
    return "a.toml", text.encode("utf-8", "surrogatepass")


def _json(chance: random.Random) -> tuple[str, bytes]:
    kind = chance.randrange(5)
    if kind == 0:
        return "a.json", b"[" * chance.choice((10, 200_000))
    if kind == 1:
        return "a.json", b'{"a":' * chance.choice((10, 100_000)) + b"1"
    if kind == 2:
        return "a.json", json.dumps([chance.choice((1, {}, None, {"student": "s1", "w3": 3}, [])) for _ in range(3)]).encode()
    values = {chance.choice(("w3", "omega 3", "α3", "", "x" * 999)): chance.choice((1e308, None, [], {}, "x", True, [1, 2], {"value": {}}))}
    text = json.dumps({"student": chance.choice((*STUDENTS, 7, None, [], 1e300)), "answers": values})
    return "a.json", text.replace("1e+308", chance.choice(("NaN", "Infinity", "1e400", "1" * 5000))).encode()


def _csv(chance: random.Random) -> tuple[str, bytes]:
    head = chance.choice(("student,omega 3,alpha 3", "student;w3;a3", "question,value", "student", ",,,", '"student', "a\tb", "sep=|", "student," * 2000))
    rows = [",".join(chance.choice((*NUMBERS, *STUDENTS)) for _ in range(chance.randrange(5))) for _ in range(chance.randrange(8))]
    encoding = chance.choice(("utf-8", "utf-8-sig", "utf-16", "utf-16-le", "gb18030", "latin-1", "utf-7"))
    return "a.csv", "\n".join([head, *rows]).encode(encoding, "replace")


def _svg(chance: random.Random) -> tuple[str, bytes]:
    inside: Callable[[], str] = chance.choice((
        lambda: "<g>" * chance.choice((5, 150, 30_000)),
        lambda: "<g>" * 3000 + "</g>" * 3000,
        lambda: "".join(f'<g id="g{k}"><use href="#g{k + 1}"/><use href="#g{k + 1}"/></g>' for k in range(40)) + '<circle id="g40" r="1"/>',
        lambda: '<g id="a"><use xlink:href="#a"/></g>',
        lambda: '<path d="M0 0' + "L1 1" * chance.choice((3, 60_000)) + '"/>',
        lambda: '<path d="' + chance.choice(("M", "MM", "M0", "M1e999 0L1 1", "M0 0Cx", "A1 1 0 0 0 1 1", "M nan 0L1 1")) + '"/>',
        lambda: "".join(f'<text x="{chance.choice(("1", "1e308", "x", ""))}" y="2" font-size="{chance.choice(("1e300", "-3", "0", "2em", "5%"))}">p</text>' for _ in range(9)),
        lambda: '<text x="1" y="1">b3</text>' * chance.choice((3, 600)) + '<line x2="5" y2="5"/>' * chance.choice((1, 400)),
        lambda: f'<g transform="{chance.choice(("scale(0)", "matrix(1 2 3)", "rotate(1e308)", "scale(1e200) scale(1e200)", "skewX(90)", "foo(1)"))}"><circle id="p" r="1"/><line x2="9"/></g>',
        lambda: '<script>alert(1)</script><image href="file:///etc/passwd"/><foreignObject/>',
        lambda: '<text x="1" y="2">w3 = ' + chance.choice(NUMBERS).replace('"', "") + "</text>",
    ))  # fmt: skip
    size = chance.choice(("210mm", "210", "0", "-1mm", "1e308mm", "100%", "x", ""))
    text = SVG.format(w=size, v=chance.choice(("0 0 210 297", "0 0 0 0", "a b c d", "", "0 0 1e-300 1")), x=inside())
    bombs = (
        "", "", "<!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' 'http://www.w3.org/x.dtd'>",
        "<!DOCTYPE s [<!ENTITY a 'aaaaaaaaaa'>" + "".join(f"<!ENTITY {b} '{'&' + a + ';' * 1}{('&' + a + ';') * 9}'>" for a, b in zip("abcdefgh", "bcdefghi", strict=True)) + "]>",
        "<!DOCTYPE s [<!ENTITY x SYSTEM 'file:///etc/passwd'>]>",
    )  # fmt: skip
    return "a.svg", (chance.choice(bombs) + text).encode()


def _zipped(chance: random.Random) -> tuple[str, bytes]:
    stream = io.BytesIO()
    with warnings.catch_warnings(), zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        warnings.simplefilter("ignore")  # of names that stand twice
        for _ in range(chance.randrange(4)):
            name, content = chance.choice((_toml, _json, _csv, _svg))(chance)
            content = content if chance.random() < 0.8 else b"0" * 30_000_000
            archive.writestr(chance.choice((name, *MEMBERS)) or "x", content)
    return chance.choice(("a.zip", "a.ggb", "a.xlsx")), stream.getvalue()


def _ggb(chance: random.Random) -> tuple[str, bytes]:
    point = f'<element type="point" label="{chance.choice(("P", "B_3", "", "P" * 999))}"><coords x="{chance.choice(("1", "NaN", "1e400", "?"))}" y="2" z="{chance.choice(("1", "0", "", "1e-320"))}"/></element>'
    vector = '<command name="Vector"><input a0="P" a1="(1e999, 2)"/><output a0="u"/></command><element type="vector" label="v_B3"/>'
    xml = f'<geogebra format="5.0">{chance.choice(("<construction>", "<x>"))}{point * 3}{vector}</construction></geogebra>'
    if chance.random() < 0.3:
        return "a.ggb", (CASES / "geogebra-4.0.ggb").read_bytes()
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        archive.writestr(chance.choice(("geogebra.xml", "geogebra.xml", "x")), xml)
    return "a.ggb", stream.getvalue()


def _dxf(chance: random.Random) -> tuple[str, bytes]:
    entities = "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n{x}\n20\n0\n11\n5\n21\n5\n0\nTEXT\n8\n0\n10\n0\n20\n0\n40\n{h}\n1\np\n0\nENDSEC\n0\nEOF\n"
    return "a.dxf", entities.format(x=chance.choice(("0", "nan", "1e308", "x")), h=chance.choice(("2", "0", "-1", "1e308", ""))).encode()


def _saved(chance: random.Random) -> tuple[str, bytes]:
    return "a.svg", (CASES / "inkscape-1.2.svg").read_bytes()


def _nothing(chance: random.Random) -> tuple[str, bytes]:
    name = chance.choice(("a.toml", "a.json", "a.csv", "a.svg", "a.ggb", "a.dxf", "a.xlsx", "a.zip", "a.txt", "a.pdf", "a", "a.toml.zip"))
    return name, chance.choice((b"", b"\n", b"\0" * 100, b"\xff\xfe", b"\xef\xbb\xbf", bytes(range(256)), b"PK\x03\x04", b"%PDF-1.7"))


_MAKERS = (_toml, _toml, _json, _csv, _svg, _svg, _zipped, _ggb, _dxf, _saved, _nothing)


# --- harms ------------------------------------------------------------------------------------


def _cut(chance: random.Random, content: bytes) -> bytes:
    return content[: chance.randrange(len(content) + 1)]


def _flip(chance: random.Random, content: bytes) -> bytes:
    changed = bytearray(content)
    for _ in range(chance.randrange(1, 9) if changed else 0):
        changed[chance.randrange(len(changed))] = chance.randrange(256)
    return bytes(changed)


def _splice(chance: random.Random, content: bytes) -> bytes:
    at = chance.randrange(len(content) + 1)
    return content[:at] + chance.choice((b"\0", b"\xff", b"\n", b'"', b"]]", b"\xed\xa0\x80", b"<", content[:50])) + content[at:]


def _as_utf16(chance: random.Random, content: bytes) -> bytes:
    return content[:2_000_000].decode("utf-8", "replace").encode("utf-16")


_HARMS = (_cut, _cut, _flip, _splice, _as_utf16)
