"""Errors of drawings: one that is measured or photographed, a file that is to be written, the fonts of a handout; of
printed sheets: their lists, whose they are, and what is measured on them."""

from __future__ import annotations

from typing import ClassVar

from graphkin.errors.base import AboutText, GraphkinError, Lang, LocatedError, Where, WordTable, listed

PLANES: WordTable = {
    "position": ("position", "位置"),
    "velocity": ("velocity", "速度"),
    "acceleration": ("acceleration", "加速度"),
}


class NoFolder(GraphkinError):
    path: str
    folder: str
    en = "{path}: there is no folder {folder}. Make it first, or write elsewhere with -o."
    zh = "{path}：没有文件夹 {folder}。请先建立该文件夹，或用 -o 写到别处。"


class CannotWrite(GraphkinError):
    path: str
    reason: str
    en = "{path}: cannot be written ({reason}). Choose another place, or make the folder first."
    zh = "{path}：无法写入（{reason}）。请另选位置，或先建立文件夹。"

    @classmethod
    def by(cls, path: object, error: OSError) -> CannotWrite:
        """Of a system that refuses. A time limit that ends the command is no such thing, and is raised again."""
        if isinstance(error, TimeoutError) and error.errno is None:
            raise error
        if isinstance(error, FileExistsError):  # where a folder was to be made
            return cls(str(path), "not a folder")
        return cls(str(path), error.strerror or str(error))


class NoDrawing(LocatedError):
    en = "{where}: there is no such file. Check the path."
    zh = "{where}：没有这个文件，请检查路径。"


_UNJUDGED: WordTable = {
    "given": (
        "it shows only what is given. Check one that holds answers, as `graphkin draw` makes it without `--style given`.",
        "它只画出已知条件。请检查带有答案的图（`graphkin draw` 不加 `--style given`）。",
    ),
    "bare": (
        "it carries no mechanism file to solve anew. Check one of a mechanism, as `graphkin draw` makes it.",
        "图中没有可重新求解的机构文件。请检查某一机构的图（`graphkin draw`）。",
    ),
    "moving": (
        "it moves, and a ruler measures one position. Check one drawn at a position, without `--animate`.",
        "它是动态图，而直尺只能测量一个位置。请检查某一位置的图（不加 `--animate`）。",
    ),
}


class NothingToMeasure(LocatedError, style=_UNJUDGED):
    style: str = "given"
    en = "{where}: nothing of this drawing is judged: {style}"
    zh = "{where}：本图不作任何判断：{style}"


class BadDrawing(LocatedError):
    """A file that is no drawing of graphkin's, or no longer one; `reason` is a key of `REASONS`."""

    reason: str
    what: str = ""
    en = (
        "{where}: this is not a drawing that graphkin can measure: {reason}. Draw the mechanism with `graphkin draw`, and "
        "check that SVG."
    )
    zh = "{where}：这不是 graphkin 能测量的图：{reason}。请用 `graphkin draw` 画出机构，再检查所得的 SVG。"

    def _words(self, lang: Lang) -> dict[str, object]:
        return super()._words(lang) | {"reason": REASONS[self.reason][lang].format(what=self.what)}


REASONS: dict[str, dict[Lang, str]] = {
    "large": {"en": "it is larger than any sheet", "zh": "文件过大"},
    "unreadable": {"en": "it cannot be read ({what})", "zh": "无法读取（{what}）"},
    "xml": {"en": "it is no SVG, or a broken one", "zh": "不是 SVG，或已损坏"},
    "svg": {"en": "it is not an SVG", "zh": "不是 SVG 图形"},
    "json": {"en": "what it says of itself cannot be read", "zh": "图中的说明数据无法读取"},
    "metadata": {"en": "it does not come from graphkin", "zh": "不是 graphkin 画的图"},
    "mechanism": {"en": "it carries no mechanism", "zh": "图中没有机构数据"},
    "older": {"en": "it was drawn by another version of graphkin", "zh": "它是由另一版本的 graphkin 画的"},
    "shown": {
        "en": "{what} in it may move, hide or add lines, so that a ruler cannot tell what a viewer shows",
        "zh": "其中的 {what} 可能移动、遮盖或增添图线，无法判断看图程序显示的是什么",
    },
    "value": {"en": "{what} means nothing here", "zh": "{what} 没有意义"},
}


class NoChineseLetters(GraphkinError):
    en = (
        "No Chinese font was found, so Chinese text would be printed as boxes. Install one (on Debian: apt install "
        "fonts-noto-cjk), or name a font file: --font PATH, or the environment variable GRAPHKIN_FONT."
    )
    zh = "未找到中文字体，中文会印成方框。请安装中文字体（Debian：apt install fonts-noto-cjk），或用 --font 路径（或环境变量 GRAPHKIN_FONT）指定字体文件。"


class NoFont(GraphkinError):
    path: str
    en = "{path} is not a font file (.ttf, .otf, .ttc) that can be read. Name another, or leave --font out."
    zh = "{path} 不是可读取的字体文件（.ttf、.otf、.ttc）。请另行指定，或不用 --font。"


class NoLetter(GraphkinError):
    letter: str
    en = (
        "No font here has the character {letter!r}, which would be printed as a box. Install one that has (on Debian: "
        "apt install fonts-noto-core fonts-noto-cjk), or name its file with --font PATH."
    )
    zh = "现有字体都没有字符 {letter!r}，会印成方框。请安装含该字符的字体（Debian：apt install fonts-noto-core fonts-noto-cjk），或用 --font 路径指定字体文件。"


class TooLargeForPaper(GraphkinError):
    """A given scale at which the drawing fits no paper."""

    where: Where
    key: str
    given: float
    fits: float
    paper: str
    unit: str

    en = (
        "{where}: at {given:g} {unit} the drawing does not fit on {paper}. {fits:g} would fit; "
        "or leave the scale out and it is chosen."
    )
    zh = "{where}：按 {given:g} {unit}，图形放不进 {paper} 图纸。可改用 {fits:g}，或不写比例尺，由程序选取。"


class UnknownPaper(GraphkinError):
    """A paper that is not in the table."""

    name: str
    known: str

    en = "There is no paper {name!r} here. Take one of {known}."
    zh = "没有 {name!r} 这种图纸。可选：{known}。"


class PictureKind(AboutText):
    en = (
        "{where}: pictures of kind {given} are not read. Save it as JPEG or PNG and hand it in anew; an iPhone takes JPEG "
        "where Settings > Camera > Formats says Most Compatible."
    )
    zh = "{where}：不能读取 {given} 格式的图片。请另存为 JPEG 或 PNG 后重新提交；iPhone 可在 设置 > 相机 > 格式 中选择“兼容性最佳”。"


_NOT_MEASURED = {
    "none": ("no printed sheet of graphkin is seen", "图中没有找到 graphkin 打印的答题纸"),
    "corners": ("the black squares {marks} in the corners are {fate}", "角上的黑色方块 {marks} {fate}"),
    "number": ("a black square at the left or right edge, which tells the sheet's number, is {fate}", "左右两侧表示编号的黑色方块{fate}"),
    "coarse": ("it has {value:.1f} pixels a mm, and 8 are needed", "每毫米只有 {value:.1f} 个像素，至少需要 8 个"),
    "faint": ("the printed grey dots are not seen: dark, blurred, or made black and white", "看不清打印的灰色圆点：太暗、模糊，或用了黑白滤镜"),
    "bent": ("the paper is bent, and places are off by up to {value:.2f} mm", "纸张弯折，位置偏差达 {value:.2f} mm"),
}  # fmt: skip
_FATES = (("covered or not readable", "cut off"), ("被遮盖或无法识别", "被裁掉"))


class PhotographAgain(LocatedError):
    """A sheet that cannot be measured; marks: those of its corners, clockwise from 0 at the left upper one, in question,
    and whether they lie outside the picture; value: pixels a mm, or mm."""

    reason: str
    marks: tuple[int, ...] = ()
    cut: bool = False
    value: float = 0.0
    en = "{where}: {why}. Photograph the whole sheet again: flat, from above, close, sharp and evenly lit, in colour."
    zh = "{where}：{why}。请重新拍摄整张答题纸：放平、俯拍、靠近、清晰、光线均匀、彩色。"

    def _words(self, lang: Lang) -> dict[str, object]:
        marks, fate = ", ".join(map(str, self.marks)), _FATES[lang == "zh"][self.cut]
        why = _NOT_MEASURED[self.reason][lang == "zh"].format(marks=marks, fate=fate, value=self.value)
        return {**super()._words(lang), "why": why}


class NoSheetList(LocatedError):
    """Neither a list of printed sheets, nor what was measured on them."""

    en = "{where}: this is not as graphkin wrote it. Take the sheets.json of handout --scan, or save the page of grade --confirm anew."
    zh = "{where}：文件内容与 graphkin 所写的不符。请用 handout --scan 生成的 sheets.json，或在 grade --confirm 的网页上重新保存。"


class NoSheetsKnown(LocatedError):
    en = "{where}: to measure a picture of paper, put the sheets.json that graphkin handout --scan wrote beside KEY, or say --sheets FILE."
    zh = "{where}：量取照片须知道纸上印了什么。请把 graphkin handout --scan 生成的 sheets.json 放在 KEY 旁，或用 --sheets 指出。"


class NothingToScan(GraphkinError):
    en = "--scan is for paper that is drawn on: a solution leaves nothing to measure. Take --stage blank, or leave --scan out."
    zh = "--scan 用于供学生作图的纸，solution 阶段没有可量取的内容。请用 --stage blank，或去掉 --scan。"


class NothingToGoOn(GraphkinError):
    en = "--upto says how far a half-worked solution goes. Take --stage half, or leave --upto out."
    zh = "--upto 规定半成解答做到哪一步。请用 --stage half，或去掉 --upto。"


class UnknownSheet(LocatedError):
    number: int
    en = "{where}: sheet #{number} is not in the list, or of another problem. Name the sheets.json with which it was printed: --sheets FILE"
    zh = "{where}：第 #{number} 号纸不在清单中，或属于另一题。请用 --sheets 给出打印该纸时生成的 sheets.json。"


class SheetTwice(LocatedError):
    number: int
    kept: str
    id: ClassVar[str] = "sheet-twice"
    en = "{where}: what is on sheet #{number} is on {kept}, too, which is read better and counts."
    zh = "{where}：第 #{number} 号纸上的图在 {kept} 中也有，该份读得更清楚，以其为准。"


_UNSURE: WordTable = {
    "blank": ("nothing is seen that was drawn", "看不到所画的图"),
    "outside": ("a part of the paper is not on the picture", "作图区未全部拍入"),
    "no ink": ("where they should lie there is no line", "应有线处没有线"),
    "short": ("the lines are too short to be measured", "线段太短，无法量准"),
    "flat": ("the lines cross at too flat an angle", "两线夹角太小，交点量不准"),
    "alike": ("two drawings fit as well", "有两种画法都相符"),
    "unexplained": ("there are lines that belong to no known drawing", "有不属于任何已知画法的线"),
    "far": ("they lie where no known drawing has them", "其位置与任何已知画法都不符"),
    "twice": ("it is there twice, and drawn differently", "有两份，且所画不同"),
    "lost": ("it may be on a picture that could not be read", "可能在未能识读的照片上"),
}


_NOT_COUNTED = "It is not counted", "暂不计入"
_AS_KNOWN = "It is known to {off} mm, and is counted where that is exact enough", "误差约 {off} mm，精度足够时才计入"


class UnsureDrawing(LocatedError, plane=PLANES, reason=_UNSURE):
    """Drawn work that a photograph does not surely show: points of a polygon, or all of it; off: their standard deviation [mm], 0
    where none is known."""

    plane: str
    reason: str
    letters: tuple[str, ...] = ()
    off: float = 0.0
    id: ClassVar[str] = "unsure"
    en = "{where}: look at the {plane} polygon{points}: {reason}. {counted}."
    zh = "{where}：请核对{plane}多边形{points}：{reason}，{counted}。"

    def _words(self, lang: Lang) -> dict[str, object]:
        points = f"{'：' if lang == 'zh' else ', '}{listed(self.letters, lang)}" if self.letters else ""
        en, zh = _AS_KNOWN if self.off else _NOT_COUNTED
        counted = (zh if lang == "zh" else en).format(off=f"{self.off:.1f}")
        return {**super()._words(lang), "points": points, "counted": counted}
