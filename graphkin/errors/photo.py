"""Errors of photographs: kinds of files that are not read, and sheets that cannot be measured."""

from __future__ import annotations

from graphkin.errors.base import AboutText, Lang, LocatedError

__all__ = ["PhotographAgain", "PictureKind"]


class PictureKind(AboutText):
    en = (
        "{where}: pictures of kind {given} are not read. Save it as JPEG or PNG and hand it in anew; an iPhone takes JPEG "
        "where Settings > Camera > Formats says Most Compatible."
    )
    zh = "{where}：不能读取 {given} 格式的图片。请另存为 JPEG 或 PNG 后重新提交；iPhone 可在 设置 > 相机 > 格式 中选择“兼容性最佳”。"


_REASONS = {
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
        why = _REASONS[self.reason][lang == "zh"].format(marks=marks, fate=fate, value=self.value)
        return {**super()._words(lang), "why": why}
