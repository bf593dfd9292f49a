"""A class of fifteen, or sixty, and what it hands in: students who calculate by themselves from the pages that they were given, and
write numbers as they like, into files as they like, that Moodle packs.
"""

from __future__ import annotations

import cmath
import csv
import html
import io
import math
import os
import re
import zipfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import openpyxl

FAMILIES = "赵钱孙李周吴郑王冯陈褚卫蒋沈韩杨朱秦尤许"
LEAST = 15
MANY = 4 * LEAST if "GRAPHKIN_RANDOM" in os.environ else LEAST
"""Students."""
GIVEN = ("霞洋", "明", "文博", "思远", "雨桐", "子涵")


@dataclass(frozen=True)
class Pupil:
    """`number` is Moodle's."""

    id: str
    name: str
    email: str
    number: int

    @property
    def folder(self) -> str:
        return f"{self.name}_{self.number}_assignsubmission_file_/"


def pupils(count: int = MANY) -> list[Pupil]:
    """Two are called 王明, one has a name in two parts; Moodle numbers them in an order of its own."""
    names = [FAMILIES[k % 20] + GIVEN[(k // 20 + k) % 6] for k in range(count)]
    names[3], names[-3], names[11] = "王明", "王明", "阿卜杜拉·买买提"
    return [Pupil(f"202701{k + 1:02}", name, f"s{k + 1:02}@x.edu", 4401 + k * 37 % count) for k, name in enumerate(names)]


def school_list(them: Iterable[Pupil]) -> str:
    return "学号,姓名,邮箱\n" + "".join(f"{one.id},{one.name},{one.email}\n" for one in them)


def worksheet(them: Iterable[Pupil]) -> str:
    """Moodle's grading worksheet, in its order."""
    head = "标识符,全名,电子邮件地址,状态,成绩,最高分,成绩可以被更改,最后修改(成绩),反馈意见\n"
    rows = (f"参与者{one.number},{one.name},{one.email},已提交等待评分,,100.00,是,-,\n" for one in sorted(them, key=lambda one: one.number))
    return "\ufeff" + head + "".join(rows)


# --- the problems -----------------------------------------------------------------------------------------------------

TEMPLATES = {
    "p1": """title = { en = "Crank and rocker", zh = "曲柄摇杆机构" }
ask = ["omega 2", "omega 3", "alpha 3", "v C"]
frame = { name = "4", A = [0, 0], D = [80, 0] }
links.1 = { AB = { from = 24, to = 34, step = 0.5 } }
links.2 = { BC = 70 }
links.3 = { DC = 60 }
driver = [{ vector = "AB", angle = { from = 35, to = 85, step = 1 }, omega = 10 }]
sketch = { C = [80, 60] }
""",
    "p2": """title = { en = "Crank and guide bar", zh = "曲柄导杆机构" }
ask = ["omega 3", "alpha 3", "a_k A3A2", "v A3A2"]
frame = { O = [0, 0], B = [0, -100] }
links.1 = { OA = { from = 30, to = 50, step = 1 } }
links.2 = { points = ["A"] }
links.3 = { BC = 180 }
slide = [{ block = "2", point = "A", guide = "3", through = "B", toward = "C" }]
driver = [{ vector = "OA", angle = { from = 10, to = 60, step = 2 }, omega = 5 }]
""",
    "p3": """title = { en = "Slider-crank", zh = "曲柄滑块机构" }
ask = ["v C", "a C", "omega 2", "alpha 2"]
frame = { A = [0, 0] }
links.1 = { AB = { from = 18, to = 28, step = 0.5 } }
links.2 = { BC = 75 }
links.3 = { points = ["C"] }
slide = [{ name = "piston", block = "3", point = "C", guide = "frame", through = [0, -10], angle = 0 }]
driver = [{ vector = "AB", angle = { from = 30, to = 75, step = 1 }, omega = "300 rpm" }]
sketch = { C = [80, -10] }
""",
}
WRITTEN = {  # as graphkin calls it: as students write it, in three ways, and the unit
    "omega 2": (("ω2", "w2", "omega_2"), "rad/s"), "omega 3": (("ω3", "w3", "omega_3"), "rad/s"),
    "alpha 2": (("α2", "alpha2", "α_2"), "rad/s²"), "alpha 3": (("α3", "alpha3", "α_3"), "rad/s²"),
    "v C": (("vC", "v_C", "v_c"), "m/s"), "a C": (("aC", "a_C", "a_c"), "m/s²"),
    "a_k A3A2": (("akA3A2", "a^k_A3A2", "a_k A3A2"), "m/s²"), "v A3A2": (("vA3A2", "v_A3A2", "v A3A2"), "m/s"),
}  # fmt: skip


def given(page: str) -> tuple[float, float]:
    """The length of the crank [m] and its angle [rad], as the student's page has them."""
    text = re.sub(r"\s+", " ", html.unescape(re.sub(r"<svg.*?</svg>|<style.*?</style>|<[^>]*>", " ", page, flags=re.S)))
    length, angle = re.search(r"l (?:AB|OA) = ([\d.]+) mm", text), re.search(r"φ 1 = ([\d.]+)°", text)
    assert length, text
    assert angle, text
    return float(length[1]) / 1000, math.radians(float(angle[1]))


def _solved(one: complex, other: complex, total: complex) -> tuple[float, float]:
    """x, y of x one + y other = total."""
    across = (one.conjugate() * other).imag
    return -(other.conjugate() * total).imag / across, (one.conjugate() * total).imag / across


Numbers = dict[str, float]


def rocker(crank: float, angle: float, wrong: str = "") -> Numbers:
    b, d, bc, dc = cmath.rect(crank, angle), 0.08, 0.07, 0.06
    far = abs(d - b)
    along = (far**2 + bc**2 - dc**2) / (2 * far)
    c = b + (along + 1j * math.sqrt(bc**2 - along**2)) * (d - b) / far
    omega_2, omega_3 = _solved(1j * (c - b), -1j * (c - d), -10j * b)
    v_c = abs(omega_3) * dc
    if wrong == "slip":
        v_c, omega_3 = 1.4 * v_c, 1.4 * omega_3
    normal = {"mistake": 0.0}.get(wrong, 1.0) * omega_3**2  # that of C about D is forgotten
    _, alpha_3 = _solved(1j * (c - b), -1j * (c - d), 100 * b + omega_2**2 * (c - b) - normal * (c - d))
    return {"omega 2": omega_2, "omega 3": omega_3, "alpha 3": alpha_3, "v C": v_c}


Polygons = dict[str, dict[str, complex]]
"""By velocity and acceleration the places of the letters, in SI."""
LINES = {"velocity": ("pb", "pc", "bc"), "acceleration": ("p′b′", "b′n2′", "n2′c′", "p′n3′", "n3′c′", "p′c′")}


def polygons(crank: float, angle: float, wrong: str = "") -> Polygons:
    """Those of the rocker; with a mistake the normal acceleration of C about D points away from D."""
    b, numbers = cmath.rect(crank, angle), rocker(crank, angle)
    far = abs(0.08 - b)
    along = (far**2 + 0.07**2 - 0.06**2) / (2 * far)
    bc = (along + 1j * math.sqrt(0.07**2 - along**2)) * (0.08 - b) / far
    dc = b + bc - 0.08
    first, second = -100 * b - numbers["omega 2"] ** 2 * bc, -numbers["omega 3"] ** 2 * dc * (-1 if wrong else 1)
    _, alpha_3 = _solved(1j * bc, -1j * dc, second - first)
    return {
        "velocity": {"p": 0j, "b": 10j * b, "c": 1j * numbers["omega 3"] * dc},
        "acceleration": {"p′": 0j, "b′": -100 * b, "n2′": first, "n3′": second, "c′": second + 1j * alpha_3 * dc},
    }


def guide_bar(crank: float, angle: float, wrong: str = "") -> Numbers:
    a = cmath.rect(crank, angle)
    bar = a + 0.1j
    r, u = abs(bar), bar / abs(bar)
    v, acc = 5j * a / u, -25 * a / u
    slides = 1.4 * v.real if wrong == "slip" else v.real
    coriolis = 2 * v.imag / r * slides
    alpha = (acc.imag - {"mistake": -1.0}.get(wrong, 1.0) * coriolis) / r  # the Coriolis term points the wrong way
    return {"omega 3": v.imag / r, "alpha 3": alpha, "a_k A3A2": abs(coriolis), "v A3A2": abs(slides)}


def slider(crank: float, angle: float, wrong: str = "") -> Numbers:
    omega, b = 10 * math.pi, cmath.rect(crank, angle)
    rod = complex(math.sqrt(0.075**2 - (b.imag + 0.01) ** 2), -0.01 - b.imag)
    omega_2, v_c = _solved(1j * rod, -1 + 0j, -1j * omega * b)
    own = 1.4 * omega_2 if wrong == "slip" else omega_2
    normal = {"mistake": -1.0}.get(wrong, 1.0) * own**2 * rod  # away from the centre
    alpha_2, a_c = _solved(1j * rod, -1 + 0j, omega**2 * b + normal)
    return {"v C": abs(v_c), "a C": abs(a_c), "omega 2": own, "alpha 2": alpha_2}


SOLVERS: Mapping[str, Callable[..., Numbers]] = {"p1": rocker, "p2": guide_bar, "p3": slider}
MADE = {"p1": "normal-omitted", "p2": "coriolis-reversed", "p3": "normal-outward"}


# --- what they write --------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Answers:
    """What one student hands in for a problem: by quantity texts or numbers."""

    of: Pupil
    values: Mapping[str, float | str]
    style: int = 0
    """Chooses among ways to write."""

    @cached_property
    def rows(self) -> list[tuple[str, str, str, str]]:
        """Name, value, unit, sense."""
        rows = []
        for text, value in self.values.items():
            names, unit = WRITTEN[text]
            turns = text[:5] in ("omega", "alpha")
            number = value if isinstance(value, str) else f"{abs(value) if turns and self.style % 2 else value:.3g}"
            sense = "" if not turns or isinstance(value, str) or not self.style % 2 else "顺时针" if value < 0 else "逆时针"
            rows.append((names[self.style % 3], number, unit, sense))
        return rows

    @property
    def lines(self) -> list[str]:
        return [f"{name} = {number} {unit} {sense}".strip() for name, number, unit, sense in self.rows]

    def file(self, kind: str, workbook: Path) -> bytes:
        """A file of a kind: the handed-out workbook filled in, or one of the student's own."""
        return {"txt": self._text, "csv": self._table, "xlsx": lambda: self._filled(workbook), "docx": self._document}[kind]()

    def _text(self) -> bytes:
        head = f"机械原理作业 姓名：{self.of.name} 学号：{self.of.id}"
        return "\r\n".join([head, "", *self.lines]).encode("gb18030")

    def _table(self) -> bytes:
        stream = io.StringIO()
        csv.writer(stream).writerows([("量", "答案", "单位", "转向"), *self.rows])
        return stream.getvalue().encode("gb18030" if self.style % 2 else "utf-8-sig")

    def _filled(self, workbook: Path) -> bytes:
        book, stream = openpyxl.load_workbook(workbook), io.BytesIO()
        rows = {row[0].value: row for row in book.active.iter_rows()}
        rows["姓名"][1].value, rows["学号"][1].value = self.of.name, int(self.of.id)
        for (_, number, _, sense), row in zip(self.rows, [*book.active.iter_rows(min_row=4)], strict=True):
            row[1].value = float(number) if re.fullmatch(r"-?[\d.e+-]+", number) else number
            if sense:
                row[3].value = sense
        book.save(stream)
        return stream.getvalue()

    def _document(self) -> bytes:
        import docx

        document, stream = docx.Document(), io.BytesIO()
        document.add_paragraph(f"学号：{self.of.id}    姓名：{self.of.name}")
        table = document.add_table(rows=0, cols=4)
        for row in (("量", "答案", "单位", "转向"), *self.rows):
            for cell, text in zip(table.add_row().cells, row, strict=True):
                cell.text = text
        document.save(stream)
        return stream.getvalue()


def packed(path: Path, files: Mapping[str, bytes]) -> Path:
    """As Moodle packs: every file under the folder of its student, names in UTF-8."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return path


# --- who hands in what ------------------------------------------------------------------------------------------------

FATES = (
    ["another's name", "again", "slip"] + ["mistake"] * 2 + ["right"] * 2 + ["nothing"] + ["unread"] * 3
    + ["copy", "photograph"] + ["late"] * 2
) * (MANY // LEAST)  # fmt: skip
"""Seven students on are eleven fates on: what is copied is of one who hands in nothing, the other's name of who copies."""
LATE = ("late", "again", "photograph")
UNREAD = ("见图", "3.92或3.98", "算不出", "2.7~2.9", "?", "忘了", "3.9x")
STRANGER = "张三丰_9001_assignsubmission_file_/作业.txt"
_KINDS = ("txt", "csv", "xlsx", "docx")


@dataclass(frozen=True)
class HomeworkClass:
    """Students, and the folder in which they are given their problems; each has a fate in each problem."""

    them: tuple[Pupil, ...]
    problems: Path

    def fates(self, problem: str) -> Iterator[tuple[int, Pupil, str]]:
        shift = 7 * [*TEMPLATES].index(problem)
        return ((k, one, FATES[(23 * k + shift) % MANY]) for k, one in enumerate(self.them))

    def of(self, problem: str, *fates: str) -> list[str]:
        return [one.id for _, one, fate in self.fates(problem) if fate in fates]

    def unread(self, problem: str) -> dict[str, str]:
        """By student what nobody can read."""
        return {one.id: UNREAD[k % 7] for k, one, fate in self.fates(problem) if fate == "unread"}

    def numbers(self, problem: str, k: int, fate: str) -> dict[str, float | str]:
        """The answers of one student."""
        other = self.them[(k + 7) % MANY if fate == "copy" else k]
        page = (self.problems / problem / "students" / f"{other.id}.html").read_text("utf-8")
        values: dict[str, float | str] = {**SOLVERS[problem](*given(page), fate)}
        if fate == "unread":
            values[[*values][k % 4]] = UNREAD[k % 7]
        return values

    def on_time(self, problem: str) -> dict[str, bytes]:
        """Everything that lies in Moodle when it is due."""
        there = (each for each in self.fates(problem) if each[2] not in ("nothing", "late"))
        files = dict(self._file(problem, k, "mistake" if fate == "again" else fate) for k, _, fate in there)
        return {**files, STRANGER: "ω2 = 3 rad/s".encode()}

    def late(self, problem: str) -> dict[str, bytes]:
        """Who hands in later, or better work, or what can be read."""
        return dict(self._file(problem, k, "right") for k, _, fate in self.fates(problem) if fate in LATE)

    def _file(self, problem: str, k: int, fate: str) -> tuple[str, bytes]:
        one, kind = self.them[k], _KINDS[k % 4]
        name = (one.id, f"{one.id}-{one.name}", f"{one.name}_{one.id}", "作业1", f"第一次作业-{one.name}")[k % 5]
        if fate == "photograph":
            return f"{one.folder}{name}.jpg", b"\xff\xd8\xff\xe0"
        if fate == "another's name":
            name = self.them[(k + 7) % MANY].id
        answers = Answers(one, self.numbers(problem, k, fate), k // 4)
        return f"{one.folder}{name}.{kind}", answers.file(kind, self.problems / problem / "students" / "_answers.xlsx")
