"""Mistakes: each as it was made, by its id and its way; and where to look again."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    # what was done: {of}, what the mistake was made with; {form}, with what. A noun phrase, after `is consistent with`
    "made driver-reversed": (
        "the sense of the driver {of} taken the other way round",
        "原动件 {of} 的转向（或移动方向）取反",
    ),
    "made driver-reversed all": (
        "the senses of all drivers taken the other way round",
        "所有原动件的转向（或移动方向）都取反",
    ),
    "made driver-along-crank": (
        "{of} laid along the crank instead of at right angles to it",
        "{of} 沿曲柄方向画出（应与曲柄垂直）",
    ),
    "made velocity-along-link": (
        "the direction line of {of} drawn along the link instead of across it",
        "{of} 的方向线沿构件方向画出（应与构件垂直）",
    ),
    "made wrong-radius": (
        "the direction line of {of} drawn {form}: across the wrong radius",
        "{of} 的方向线取 {form}，半径取错",
    ),
    "made sliding-across": (
        "the direction line of the sliding {of} drawn across the guide instead of along it",
        "{of} 的方向线垂直于导路画出（应平行于导路）",
    ),
    "made orthogonal-split": (
        "the known velocity split along the guide and at right angles to it for {of}, though the guide passes "
        "beside the pivot",
        "已知速度沿导路及其垂线分解，导路却不过转动中心，{of} 因而有误",
    ),
    "made orthogonal-split length": (
        "the known velocity split along the guide and at right angles to it, though the guide passes beside the "
        "pivot, and {of} divided by {form}",
        "已知速度沿导路及其垂线分解（导路却不过转动中心），并以 {form} 除 {of}",
    ),
    "made absolute-for-relative": (
        "{of} from an absolute velocity instead of the relative one: {form}",
        "求 {of} 时用了绝对速度：{form}",
    ),
    "made wrong-length": ("{of} from the wrong length {form}", "求 {of} 时误用长度 {form}"),
    "made sliding-as-turning": (
        "{of} from the velocity of sliding, as if that were turning: {form}",
        "由相对滑动速度求 {of}：{form}",
    ),
    "made omega-sense": ("the sense of {of} read the wrong way round", "{of} 的转向判断反了"),
    "made block-omega": (
        "the angular velocity of the block in {of} taken as {form}",
        "{of} 中滑块的角速度取为 {form}",
    ),
    "made image-mirrored": (
        "the image of {of} ({form}) lettered in the opposite sense",
        "影像 {of}（{form}）的字母绕行方向与原图相反",
    ),
    "made image-mirrored swapped": (
        "the image of {of} ({form}) with the ends of its base exchanged",
        "影像 {of}（{form}）的两端点互换",
    ),
    "made image-wrong-point": (
        "the image of {of} ({form}) drawn on the coincident point of the other link",
        "影像 {of}（{form}）作在另一构件的重合点上",
    ),
    "made normal-omitted": ("the normal acceleration {of} left out", "漏掉法向加速度 {of}"),
    "made normal-outward": ("the normal acceleration {of} laid off outward", "法向加速度 {of} 画成背离转动中心"),
    "made coriolis-omitted": ("the Coriolis acceleration {of} left out", "漏掉哥氏加速度 {of}"),
    "made coriolis-reversed": ("the Coriolis acceleration {of} pointing the other way", "哥氏加速度 {of} 的指向反了"),
    "made coriolis-half": ("the factor 2 missing in the Coriolis acceleration {of}", "哥氏加速度 {of} 漏乘系数 2"),
    "made coriolis-crank-omega": (
        "the Coriolis acceleration {of} with the driver's angular velocity {form}",
        "哥氏加速度 {of} 误用原动件的角速度 {form}",
    ),
    "made coriolis-crank-omega sense": (
        "the Coriolis acceleration {of} with the driver's angular velocity {form}, in the sense of the block's",
        "哥氏加速度 {of} 误用原动件角速度的大小 {form}，转向按滑块",
    ),
    "made coriolis-absolute-velocity": (
        "the Coriolis acceleration {of} with the absolute velocity {form} instead of that of sliding",
        "哥氏加速度 {of} 误用绝对速度 {form}",
    ),
    "made coriolis-not-turned": (
        "the Coriolis acceleration {of} along the velocity of sliding, not turned by 90°",
        "哥氏加速度 {of} 沿相对速度方向画出，未转 90°",
    ),
    "made normal-size": (
        "the size of the normal acceleration {of} taken as {form}",
        "法向加速度 {of} 的大小误取为 {form}",
    ),
    "made tangential-along": (
        "the direction line of {of} drawn along the link instead of across it",
        "{of} 的方向线沿构件方向画出（应与构件垂直）",
    ),
    "made tangential-along crank": (
        "{of} laid along the velocity instead of towards the pivot",
        "{of} 沿速度方向画出（应指向转动中心）",
    ),
    "made wrong-tail": (
        "{of} laid off from the pole {form}, so that the arrow before it is lost",
        "{of} 从极点 {form} 画起，丢失了它前面的矢量",
    ),
    "made wrong-tail segment": (
        "{of} from the segment {form}, which is not the tangential part",
        "求 {of} 时误量线段 {form}",
    ),
    "made wrong-tail image": ("the image of {of} drawn on {form}", "影像 {of} 作在 {form} 上"),
    "made conversion": ("{of} off by the factor {form} of a unit or a scale", "{of} 的换算差因子 {form}"),
    "made conversion kind": (
        "all values in {of} off by the factor {form} of a unit or a scale",
        "所有单位为 {of} 的量换算都差因子 {form}",
    ),
    "made conversion lengths": (
        "all lengths in another unit, mm for m or m for mm: every value in {of} off by the factor {form}",
        "长度一律用错单位（mm 与 m 相混）：所有单位为 {of} 的量都差因子 {form}",
    ),
    "made conversion paper": (
        "all values in {of} as they are measured on paper, off by the factors {form} of the scales",
        "所有单位为 {of} 的量都是图上量得的长度，未乘比例尺，差因子 {form}",
    ),
    "made conversion carried": (
        "{of} off by the factor {form} of a unit or a scale, and carried on",
        "{of} 的换算差因子 {form}，并用于以后各步",
    ),
    "made conversion given": (
        "the speed of the driver {of} off by the factor {form} of a unit",
        "原动件 {of} 的速度换算差因子 {form}",
    ),
    "made conversion sense": ("the sense of {of} given the wrong way round", "{of} 的转向写反"),
    "made centre-ratio": (
        "{of} by instant centres with the ratio of distances upside down",
        "用瞬心求 {of} 时距离之比颠倒",
    ),
    "made centre-ratio sense": (
        "{of} by instant centres with the wrong sense: the centre lies between the two others, or outside",
        "用瞬心求 {of} 时转向判断反了（瞬心在两中心之间或之外）",
    ),
    "made centre-ratio lines": ("{of} found on the wrong pair of lines {form}", "由错误的三心连线 {form} 求得 {of}"),
    "made centre-acceleration-zero": (
        "{of} found as if the instant centre {form} had no acceleration",
        "求 {of} 时把速度瞬心 {form} 的加速度也当作零",
    ),
    "made centre-acceleration-zero point": (
        "{of} taken as zero because that point has no velocity",
        "速度为零的点，其加速度 {of} 也被当作零",
    ),
    "made arm-ignored": (
        "{of} from the ratio of the wheels without the rotation of the arm",
        "求 {of} 时在传动比中未计系杆（转臂）的转动",
    ),
    "made relative-as-absolute": (
        "the relative rotation of the driver {of} taken as absolute",
        "把原动件 {of} 的相对角速度当作绝对角速度",
    ),
    "made driver-acceleration-dropped": ("the acceleration of the driver {of} left out", "漏掉原动件 {of} 的加速度"),
    "made slider-normal-term": (
        "a normal term ω²l of {form} added at the slider for {of}, as if it turned about the crank's pivot",
        "在滑块 {of} 处多画一个法向加速度（{form} 的 ω²l，指向曲柄转动中心）",
    ),
    "made other-assembly": ("{of} taken on the other side: the other assembly", "{of} 取了另一装配位置"),
    "made angle-clockwise": ("the angle of the driver {of} measured clockwise", "原动件 {of} 的位置角按顺时针量取"),
    # a mistake by itself, as it shows in several problems. A sentence, after `in 3 of 4 problems`
    "kind driver-reversed": ("the sense of the driver is taken the other way round", "原动件的转向（或移动方向）取反"),
    "kind driver-along-crank": ("the crank's velocity is laid along the crank", "曲柄端点速度沿曲柄方向画出"),
    "kind velocity-along-link": (
        "the direction line of a velocity is drawn along the link",
        "相对速度的方向线沿构件方向画出",
    ),
    "kind wrong-radius": ("the direction line of a velocity is drawn across the wrong radius", "速度方向线的半径取错"),
    "kind sliding-across": ("the direction line of sliding is drawn across the guide", "相对滑动速度的方向线垂直于导路画出"),
    "kind orthogonal-split": (
        "the known velocity is split along the guide and at right angles to it, though the guide passes beside the pivot",
        "导路不过转动中心，却把已知速度沿导路及其垂线分解",
    ),
    "kind absolute-for-relative": (
        "an angular velocity is found from an absolute velocity instead of the relative one",
        "求角速度时用了绝对速度而非相对速度",
    ),
    "kind wrong-length": ("an angular velocity is found from the wrong length", "求角速度时所用长度有误"),
    "kind sliding-as-turning": ("the velocity of sliding is taken for one of turning", "把相对滑动速度当作转动速度求角速度"),
    "kind omega-sense": ("the sense of an angular velocity is read the wrong way round", "角速度的转向判断反了"),
    "kind block-omega": ("the angular velocity of the block is wrong", "滑块的角速度取错"),
    "kind image-mirrored": ("the image is lettered in the opposite sense", "影像的字母绕行方向与原图相反"),
    "kind image-wrong-point": (
        "the image is drawn on the coincident point of the other link",
        "影像作在另一构件的重合点上",
    ),
    "kind normal-omitted": ("a normal acceleration is left out", "漏掉法向加速度"),
    "kind normal-outward": ("a normal acceleration points away from the centre", "法向加速度画成背离转动中心"),
    "kind coriolis-omitted": ("the Coriolis term is left out", "漏掉哥氏加速度"),
    "kind coriolis-reversed": ("the Coriolis term points the wrong way", "哥氏加速度的指向反了"),
    "kind coriolis-half": ("the factor 2 of the Coriolis term is missing", "哥氏加速度漏乘系数 2"),
    "kind coriolis-crank-omega": (
        "the Coriolis term is found with the driver's angular velocity",
        "哥氏加速度误用原动件的角速度",
    ),
    "kind coriolis-absolute-velocity": (
        "the Coriolis term is found with an absolute velocity instead of that of sliding",
        "哥氏加速度误用绝对速度",
    ),
    "kind coriolis-not-turned": (
        "the Coriolis term lies along the velocity of sliding, not turned by 90°",
        "哥氏加速度沿相对速度方向画出，未转 90°",
    ),
    "kind normal-size": ("the size of a normal acceleration is wrong", "法向加速度的大小取错"),
    "kind tangential-along": (
        "the direction line of a tangential acceleration is drawn along the link",
        "切向加速度的方向线沿构件方向画出",
    ),
    "kind wrong-tail": (
        "an arrow of the acceleration polygon begins or is measured at the wrong point",
        "加速度多边形中矢量的起点或所量线段取错",
    ),
    "kind conversion": ("a unit, a scale or a sign is converted wrongly", "单位、比例尺或正负号换算有误"),
    "kind centre-ratio": ("the ratio of distances from the instant centres is wrong", "用瞬心求角速度时距离之比有误"),
    "kind centre-acceleration-zero": (
        "a point without velocity is taken to have no acceleration",
        "把速度为零的点的加速度也当作零",
    ),
    "kind arm-ignored": ("the rotation of the arm is left out of the ratio of the wheels", "传动比中未计系杆（转臂）的转动"),
    "kind relative-as-absolute": (
        "the relative rotation of the driver is taken as absolute",
        "把原动件的相对角速度当作绝对角速度",
    ),
    "kind driver-acceleration-dropped": ("the acceleration of the driver is left out", "漏掉原动件的加速度"),
    "kind slider-normal-term": ("a slider is given a normal acceleration", "给滑块多画了法向加速度"),
    "kind other-assembly": ("the mechanism is drawn in its other assembly", "机构取了另一装配位置"),
    "kind angle-clockwise": ("the angle of the driver is measured clockwise", "原动件的位置角按顺时针量取"),
    # a hint, by topic: the place to look at again, and no more
    "look driver": ("Look again at what is given of the driver.", "检查原动件的已知运动。"),
    "look position": ("Look again at the drawing of the mechanism.", "检查机构位置图。"),
    "look velocity-direction": (
        "Look again at the directions in the velocity equation.",
        "检查速度方程中各矢量的方向。",
    ),
    "look rotation": ("Look again at how angular velocities are read off.", "检查由速度求角速度的一步。"),
    "look image": ("Look again at the velocity or acceleration image.", "检查速度影像或加速度影像。"),
    "look normal": ("Look again at the normal accelerations.", "检查法向加速度。"),
    "look coriolis": ("Look again at the Coriolis acceleration.", "检查哥氏加速度。"),
    "look acceleration": ("Look again at how the acceleration polygon is drawn.", "检查加速度多边形的画法。"),
    "look unit": ("Look again at units, scales and senses.", "检查单位、比例尺与转向。"),
    "look centre": ("Look again at the instant centres and what they are used for.", "检查瞬心及其应用。"),
    "look wheels": ("Look again at the ratio of the wheels.", "检查轮系的传动比。"),
}
