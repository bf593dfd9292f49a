"""The page of the mechanism file: what is said of the whole and of each table."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "intro what": (
        "The mechanism file: one mechanism at one position, the drawn one; sweeps start there. The file is TOML. Its tables follow "
        "in the order in which one writes them, every key with an example; only what the mechanism needs has to be there.",
        "机构文件：描述机构的一个位置（图示位置），运动由此开始。文件为 TOML 格式。下面按书写顺序列出各表，每个键附一例；只写机构需要的部分。",
    ),
    "intro names": (
        "Names: a point is a capital letter, then digits, then primes: A, O1, D'; a link is any word of up to 36 letters, digits, _ and '. "
        "A key with a prime is quoted: \"DE'\" = 40, [links.\"2'\"]. A point that two links name is a hinge between them (the frame "
        "counts as a link), named by three a multiple hinge. \"frame\" is the fixed link.",
        "命名：点为大写字母，后接数字、撇号：A、O1、D'；构件名由字母、数字、_ 和 ' 组成，最长 36 个字母（汉字按两个计）。带撇号的键要加引号：\"DE'\" = 40、[links.\"2'\"]。"
        "两个构件（机架也算）都写出的点即为转动副，三个则为复合铰链。\"frame\" 是机架。",
    ),
    "intro angles": (
        "Angles, angular velocities and angular accelerations are positive counter-clockwise. Where nothing else is said, angles are measured "
        "from +x, to the right. The direction of a line goes from `through` to `toward`; left and right are those of somebody who looks that way.",
        "角度、角速度、角加速度均以逆时针为正；未另说明时角度由 +x（向右）量起。直线的方向由 through 指向 toward，左右以沿此方向看为准。",
    ),
    "intro numbers": (
        "Wherever a number stands, in lists too, a text may carry another unit: \"24 in\", \"120 rpm\", \"45°\". A number without a unit is in the first:",
        "凡是写数的地方（包括列表中），都可写带单位的文字：\"24 in\"、\"120 rpm\"、\"45°\"。不带单位的数取各行的第一个单位：",
    ),
    "of length": ("lengths", "长度"),
    "of angle": ("angles", "角度"),
    "of angular velocity": ("angular velocities", "角速度"),
    "of angular acceleration": ("angular accelerations (² or ^2)", "角加速度（² 或 ^2）"),
    "of velocity": ("velocities", "速度"),
    "of acceleration": ("accelerations (² or ^2)", "加速度（² 或 ^2）"),
    "unit": ("[{first}; as text also {others}]", "[{first}；文字还可用 {others}]"),
    "as in slide": ("{keys}: as in [[slide]]", "{keys}：同 [[slide]]"),
    "table file": ("The whole file: what it says of itself, then the tables below.", "整个文件：先是说明，然后是以下各表。"),
    "table title": ("One title in each language, in place of a text.", "每种语言一个名称，代替一段文字。"),
    "table frame": ("The fixed link, with its fixed points as further keys.", "机架，各固定点直接作为键。"),
    "table link": (
        "A moving link. Its points are those its keys name, and its shape is given by lengths and angles, or by `shape`.",
        "活动构件。其键所写出的点就是它的点；形状由长度和角度给出，或由 shape 给出。",
    ),
    "table slide": (
        "A sliding pair on a line of `guide`: either `block` and `point` (no turning), or `pin` alone (a pin in a slot). The line is given "
        "by `through` and `toward`, or by `through`, `from` and `angle`.",
        "在 guide 的直线上滑动：或写 block 与 point（不相对转动），或只写 pin（销在槽中）。直线由 through 与 toward 给出，或由 through、from、angle 给出。",
    ),
    "table gear": ("A pair of gears: no slip at the pitch point.", "齿轮副：节点处无滑动。"),
    "table roll": (
        "A wheel that rolls without slip and stays in contact, on a line or on a circle of another link.",
        "轮在另一构件的直线或圆上纯滚动并保持接触。",
    ),
    "table cam": ("Two profiles that touch and slide on each other.", "两轮廓接触并相对滑动。"),
    "table profile": (
        "In `profiles` of [[cam]], one for each link: a circle by `centre` and `radius`, or a straight face by the keys of a line.",
        "[[cam]] 的 profiles 中每个构件一个：圆由 centre、radius 给出，直线由直线的各键给出。",
    ),
    "table driver": (
        "What moves the mechanism: `vector`, `link` or `slide`, one of the three, then where it stands and how fast it moves.",
        "原动件：vector、link、slide 三者取一，再给出位置与快慢。",
    ),
    "table pose": (
        "A value that holds at the drawn position only: what gears and rolling leave free, or what a driver without `angle` or `at` leaves open.",
        "只在图示位置成立的给定值：齿轮、滚动未确定的量，或未给 angle、at 的原动件所缺的量。",
    ),
    "table sketch": (
        "Roughly where moving points are, points as keys. It has to tell one assembly from the other, no more.",
        "各动点的大致位置，点作为键；只需能区分装配形式。",
    ),
    "table scales": ("Paper scales, for those who want certain ones.", "图纸比例尺，需要指定时才写。"),
    "asked": ("What `ask` understands (and `sweep --of`, `find`):", "ask（以及 sweep --of、find）可写的量："),
    "ask rotation": (
        "theta 3, omega 3, alpha 3: direction, angular velocity and angular acceleration of link 3",
        "theta 3、omega 3、alpha 3：构件 3 的方向角、角速度、角加速度",
    ),
    "ask motion": (
        "v C, a C: of point C; v_x C, v_y C, a_x C, a_y C: their components",
        "v C、a C：点 C 的速度、加速度；v_x C、v_y C、a_x C、a_y C：其分量",
    ),
    "ask place": (
        "x C, y C: where point C is; path C: both, over a motion its path",
        "x C、y C：点 C 的坐标；path C：两者，运动中即其轨迹",
    ),
    "ask relative": (
        "v CB, a CB, a_n CB, a_t CB: of C relative to B, two points of one link",
        "v CB、a CB、a_n CB、a_t CB：同一构件上 C 相对 B",
    ),
    "ask coincident": (
        "v B3B2, a_k B3B2, a_r B3B2: of coincident points; B3 is the point of link 3 under point B; where names of links are longer, a_k B@rod,B@tube",
        "v B3B2、a_k B3B2、a_r B3B2：重合点；B3 是构件 3 上与 B 重合的点；构件名较长时写 a_k B@rod,B@tube",
    ),
    "ask displacement": ("s ram: displacement of a named slide", "s ram：有名称的移动副的位移"),
    "ask centre": ("P13: an instant centre (P1,3' where names are longer)", "P13：瞬心（名称较长时写 P1,3'）"),
    "ask quotient": ("omega 1 / omega 3: a quotient of two of one unit", "omega 1 / omega 3：两个同单位量之比"),
    "whole": (
        "A whole file to start from: `graphkin new four-bar > mine.toml`, or `graphkin show ex3-1`. For your editor: `graphkin schema`.",
        "完整的起始文件：`graphkin new four-bar > mine.toml`，或 `graphkin show ex3-1`。供编辑器使用：`graphkin schema`。",
    ),
}
