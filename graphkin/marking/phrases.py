"""What is said of each mistake, in both languages side by side.

Keyed by the mistake's id, or `id.way` where a mistake has ways that take other words. Placeholders: {of}, what the
mistake was made with; {form}, with what (only where the rewrite has one). Each is a noun phrase, to stand after "is
consistent with" or 与……相符; a hint names only the place to look at again.
"""

from __future__ import annotations

from collections.abc import Mapping

__all__ = ["HINTS", "SENTENCES", "key"]


def key(id: str, way: str) -> str:
    """Under which a rewrite's sentence stands."""
    return f"{id}.{way}" if way else id


SENTENCES: Mapping[str, Mapping[str, str]] = {
    "driver-reversed": {
        "zh": "原动件 {of} 的转向（或移动方向）取反",
        "en": "the sense of the driver {of} taken the other way round",
    },
    "driver-reversed.all": {
        "zh": "所有原动件的转向（或移动方向）都取反",
        "en": "the senses of all drivers taken the other way round",
    },
    "driver-along-crank": {
        "zh": "{of} 沿曲柄方向画出（应与曲柄垂直）",
        "en": "{of} laid along the crank instead of at right angles to it",
    },
    "velocity-along-link": {
        "zh": "{of} 的方向线沿构件方向画出（应与构件垂直）",
        "en": "the direction line of {of} drawn along the link instead of across it",
    },
    "wrong-radius": {
        "zh": "{of} 的方向线取 {form}，半径取错",
        "en": "the direction line of {of} drawn {form}: across the wrong radius",
    },
    "sliding-across": {
        "zh": "{of} 的方向线垂直于导路画出（应平行于导路）",
        "en": "the direction line of the sliding {of} drawn across the guide instead of along it",
    },
    "orthogonal-split": {
        "zh": "已知速度沿导路及其垂线分解，导路却不过转动中心，{of} 因而有误",
        "en": "the known velocity split along the guide and at right angles to it for {of}, though the guide passes "
        "beside the pivot",
    },
    "orthogonal-split.length": {
        "zh": "已知速度沿导路及其垂线分解（导路却不过转动中心），并以 {form} 除 {of}",
        "en": "the known velocity split along the guide and at right angles to it, though the guide passes beside the "
        "pivot, and {of} divided by {form}",
    },
    "absolute-for-relative": {
        "zh": "求 {of} 时用了绝对速度：{form}",
        "en": "{of} from an absolute velocity instead of the relative one: {form}",
    },
    "wrong-length": {
        "zh": "求 {of} 时误用长度 {form}",
        "en": "{of} from the wrong length {form}",
    },
    "sliding-as-turning": {
        "zh": "由相对滑动速度求 {of}：{form}",
        "en": "{of} from the velocity of sliding, as if that were turning: {form}",
    },
    "omega-sense": {
        "zh": "{of} 的转向判断反了",
        "en": "the sense of {of} read the wrong way round",
    },
    "block-omega": {
        "zh": "{of} 中滑块的角速度取为 {form}",
        "en": "the angular velocity of the block in {of} taken as {form}",
    },
    "image-mirrored": {
        "zh": "影像 {of}（{form}）的字母绕行方向与原图相反",
        "en": "the image of {of} ({form}) lettered in the opposite sense",
    },
    "image-mirrored.swapped": {
        "zh": "影像 {of}（{form}）的两端点互换",
        "en": "the image of {of} ({form}) with the ends of its base exchanged",
    },
    "image-wrong-point": {
        "zh": "影像 {of}（{form}）作在另一构件的重合点上",
        "en": "the image of {of} ({form}) drawn on the coincident point of the other link",
    },
    "normal-omitted": {
        "zh": "漏掉法向加速度 {of}",
        "en": "the normal acceleration {of} left out",
    },
    "normal-outward": {
        "zh": "法向加速度 {of} 画成背离转动中心",
        "en": "the normal acceleration {of} laid off outward",
    },
    "coriolis-omitted": {
        "zh": "漏掉哥氏加速度 {of}",
        "en": "the Coriolis acceleration {of} left out",
    },
    "coriolis-reversed": {
        "zh": "哥氏加速度 {of} 的指向反了",
        "en": "the Coriolis acceleration {of} pointing the other way",
    },
    "coriolis-half": {
        "zh": "哥氏加速度 {of} 漏乘系数 2",
        "en": "the factor 2 missing in the Coriolis acceleration {of}",
    },
    "coriolis-crank-omega": {
        "zh": "哥氏加速度 {of} 误用原动件的角速度 {form}",
        "en": "the Coriolis acceleration {of} with the driver's angular velocity {form}",
    },
    "coriolis-crank-omega.sense": {
        "zh": "哥氏加速度 {of} 误用原动件角速度的大小 {form}，转向按滑块",
        "en": "the Coriolis acceleration {of} with the driver's angular velocity {form}, in the sense of the block's",
    },
    "coriolis-absolute-velocity": {
        "zh": "哥氏加速度 {of} 误用绝对速度 {form}",
        "en": "the Coriolis acceleration {of} with the absolute velocity {form} instead of that of sliding",
    },
    "coriolis-not-turned": {
        "zh": "哥氏加速度 {of} 沿相对速度方向画出，未转 90°",
        "en": "the Coriolis acceleration {of} along the velocity of sliding, not turned by 90°",
    },
    "normal-size": {
        "zh": "法向加速度 {of} 的大小误取为 {form}",
        "en": "the size of the normal acceleration {of} taken as {form}",
    },
    "tangential-along": {
        "zh": "{of} 的方向线沿构件方向画出（应与构件垂直）",
        "en": "the direction line of {of} drawn along the link instead of across it",
    },
    "tangential-along.crank": {
        "zh": "{of} 沿速度方向画出（应指向转动中心）",
        "en": "{of} laid along the velocity instead of towards the pivot",
    },
    "wrong-tail": {
        "zh": "{of} 从极点 {form} 画起，丢失了它前面的矢量",
        "en": "{of} laid off from the pole {form}, so that the arrow before it is lost",
    },
    "wrong-tail.segment": {
        "zh": "求 {of} 时误量线段 {form}",
        "en": "{of} from the segment {form}, which is not the tangential part",
    },
    "wrong-tail.image": {
        "zh": "影像 {of} 作在 {form} 上",
        "en": "the image of {of} drawn on {form}",
    },
    "conversion": {
        "zh": "{of} 的换算差因子 {form}",
        "en": "{of} off by the factor {form} of a unit or a scale",
    },
    "conversion.kind": {
        "zh": "所有单位为 {of} 的量换算都差因子 {form}",
        "en": "all values in {of} off by the factor {form} of a unit or a scale",
    },
    "conversion.carried": {
        "zh": "{of} 的换算差因子 {form}，并用于以后各步",
        "en": "{of} off by the factor {form} of a unit or a scale, and carried on",
    },
    "conversion.given": {
        "zh": "原动件 {of} 的速度换算差因子 {form}",
        "en": "the speed of the driver {of} off by the factor {form} of a unit",
    },
    "conversion.sense": {
        "zh": "{of} 的转向写反",
        "en": "the sense of {of} given the wrong way round",
    },
    "centre-ratio": {
        "zh": "用瞬心求 {of} 时距离之比颠倒",
        "en": "{of} by instant centres with the ratio of distances upside down",
    },
    "centre-ratio.sense": {
        "zh": "用瞬心求 {of} 时转向判断反了（瞬心在两中心之间或之外）",
        "en": "{of} by instant centres with the wrong sense: the centre lies between the two others, or outside",
    },
    "centre-ratio.lines": {
        "zh": "由错误的三心连线 {form} 求得 {of}",
        "en": "{of} found on the wrong pair of lines {form}",
    },
    "centre-acceleration-zero": {
        "zh": "求 {of} 时把速度瞬心 {form} 的加速度也当作零",
        "en": "{of} found as if the instant centre {form} had no acceleration",
    },
    "centre-acceleration-zero.point": {
        "zh": "速度为零的点，其加速度 {of} 也被当作零",
        "en": "{of} taken as zero because that point has no velocity",
    },
    "arm-ignored": {
        "zh": "求 {of} 时在传动比中未计系杆（转臂）的转动",
        "en": "{of} from the ratio of the wheels without the rotation of the arm",
    },
    "relative-as-absolute": {
        "zh": "把原动件 {of} 的相对角速度当作绝对角速度",
        "en": "the relative rotation of the driver {of} taken as absolute",
    },
    "driver-acceleration-dropped": {
        "zh": "漏掉原动件 {of} 的加速度",
        "en": "the acceleration of the driver {of} left out",
    },
    "slider-normal-term": {
        "zh": "在滑块 {of} 处多画一个法向加速度（{form} 的 ω²l，指向曲柄转动中心）",
        "en": "a normal term ω²l of {form} added at the slider for {of}, as if it turned about the crank's pivot",
    },
    "other-assembly": {
        "zh": "{of} 取了另一装配位置",
        "en": "{of} taken on the other side: the other assembly",
    },
    "angle-clockwise": {
        "zh": "原动件 {of} 的位置角按顺时针量取",
        "en": "the angle of the driver {of} measured clockwise",
    },
}

HINTS: Mapping[str, Mapping[str, str]] = {
    "driver": {"zh": "检查原动件的已知运动。", "en": "Look again at what is given of the driver."},
    "position": {"zh": "检查机构位置图。", "en": "Look again at the drawing of the mechanism."},
    "velocity-direction": {
        "zh": "检查速度方程中各矢量的方向。",
        "en": "Look again at the directions in the velocity equation.",
    },
    "rotation": {"zh": "检查由速度求角速度的一步。", "en": "Look again at how angular velocities are read off."},
    "image": {"zh": "检查速度影像或加速度影像。", "en": "Look again at the velocity or acceleration image."},
    "normal": {"zh": "检查法向加速度。", "en": "Look again at the normal accelerations."},
    "coriolis": {"zh": "检查哥氏加速度。", "en": "Look again at the Coriolis acceleration."},
    "acceleration": {"zh": "检查加速度多边形的画法。", "en": "Look again at how the acceleration polygon is drawn."},
    "unit": {"zh": "检查单位、比例尺与转向。", "en": "Look again at units, scales and senses."},
    "centre": {"zh": "检查瞬心及其应用。", "en": "Look again at the instant centres and what they are used for."},
    "wheels": {"zh": "检查轮系的传动比。", "en": "Look again at the ratio of the wheels."},
}
"""By the `topic` of a mistake."""
