"""The page of the mechanism file: what is said of the whole, of each table and of each key; `*` are the keys that are
points, lengths, angles."""

from graphkin.say.catalogue import Phrases

# fmt: off
PHRASES: Phrases = {
    # === the whole and each table
    "file_page.intro what": ("The mechanism file: one mechanism at one position, the drawn one; sweeps start there. "
                             "The file is TOML. Its tables follow in the order in which one writes them, every key "
                             "with an example; only what the mechanism needs has to be there.",
                             "机构文件：描述机构的一个位置（图示位置），运动由此开始。文件为 TOML 格式。下面按书写顺序列出各表，每个键附一例；只写机构需要的部分。"),
    "file_page.intro names": ("Names: a point is a capital letter, then digits, then primes: A, O1, D'; a link is any "
                              "word of up to 36 letters, digits, _ and '. A key with a prime is quoted: \"DE'\" = 40, "
                              "[links.\"2'\"]. A point that two links name is a hinge between them (the frame counts "
                              'as a link), named by three a multiple hinge. "frame" is the fixed link.',
                              "命名：点为大写字母，后接数字、撇号：A、O1、D'；构件名由字母、数字、_ 和 ' 组成，最长 36 个字母（汉字按两个计）。带撇号的键要加引号：\"DE'\" = "
                              "40、[links.\"2'\"]。两个构件（机架也算）都写出的点即为转动副，三个则为复合铰链。\"frame\" 是机架。"),
    "file_page.intro angles": ("Angles, angular velocities and angular accelerations are positive counter-clockwise. "
                               "Where nothing else is said, angles are measured from +x, to the right. The direction "
                               "of a line goes from `through` to `toward`; left and right are those of somebody who "
                               "looks that way.",
                               "角度、角速度、角加速度均以逆时针为正；未另说明时角度由 +x（向右）量起。直线的方向由 through 指向 toward，左右以沿此方向看为准。"),
    "file_page.intro numbers": ('Wherever a number stands, in lists too, a text may carry another unit: "24 in", "120 '
                                'rpm", "45°". A number without a unit is in the first:',
                                '凡是写数的地方（包括列表中），都可写带单位的文字："24 in"、"120 rpm"、"45°"。不带单位的数取各行的第一个单位：'),
    "file_page.of length": ("lengths", "长度"),
    "file_page.of angle": ("angles", "角度"),
    "file_page.of angular velocity": ("angular velocities", "角速度"),
    "file_page.of angular acceleration": ("angular accelerations (² or ^2)", "角加速度（² 或 ^2）"),
    "file_page.of velocity": ("velocities", "速度"),
    "file_page.of acceleration": ("accelerations (² or ^2)", "加速度（² 或 ^2）"),
    "file_page.unit": ("[{first}; as text also {others}]", "[{first}；文字还可用 {others}]"),
    "file_page.as in slide": ("{keys}: as in [[slide]]", "{keys}：同 [[slide]]"),
    "file_page.table file": ("The whole file: what it says of itself, then the tables below.", "整个文件：先是说明，然后是以下各表。"),
    "file_page.table title": ("One title in each language, in place of a text.", "每种语言一个名称，代替一段文字。"),
    "file_page.table points": ("For homework: what each answer is worth, questions as keys; 1 where nothing is said.",
                               "用于作业：各答案的分值，以所求量的写法为键；未写者为 1 分。"),
    "file_page.table frame": ("The fixed link, with its fixed points as further keys.", "机架，各固定点直接作为键。"),
    "file_page.table link": ("A moving link. Its points are those its keys name, and its shape is given by lengths "
                             "and angles, or by `shape`.",
                             "活动构件。其键所写出的点就是它的点；形状由长度和角度给出，或由 shape 给出。"),
    "file_page.table slide": (
        "A sliding pair on a line of `guide`: either `block` and `point` (no turning), or `pin` alone (a pin in a "
        "slot). The line is given by `through` and `toward`, or by `through`, `from` and `angle`.",
        "在 guide 的直线上滑动：或写 block 与 point（不相对转动），或只写 pin（销在槽中）。直线由 through 与 toward 给出，或由 through、from、angle 给出。"),
    "file_page.table gear": ("A pair of gears: no slip at the pitch point.", "齿轮副：节点处无滑动。"),
    "file_page.table roll": ("A wheel that rolls without slip and stays in contact, on a line or on a circle of "
                             "another link.",
                             "轮在另一构件的直线或圆上纯滚动并保持接触。"),
    "file_page.table cam": ("Two profiles that touch and slide on each other.", "两轮廓接触并相对滑动。"),
    "file_page.table profile": ("In `profiles` of [[cam]], one for each link: a circle by `centre` and `radius`, or a "
                                "straight face by the keys of a line.",
                                "[[cam]] 的 profiles 中每个构件一个：圆由 centre、radius 给出，直线由直线的各键给出。"),
    "file_page.table driver": ("What moves the mechanism: `vector`, `link` or `slide`, one of the three, then where "
                               "it stands and how fast it moves.",
                               "原动件：vector、link、slide 三者取一，再给出位置与快慢。"),
    "file_page.table pose": ("A value that holds at the drawn position only: what gears and rolling leave free, or "
                             "what a driver without `angle` or `at` leaves open.",
                             "只在图示位置成立的给定值：齿轮、滚动未确定的量，或未给 angle、at 的原动件所缺的量。"),
    "file_page.table sketch": ("Roughly where moving points are, points as keys. It has to tell one assembly from the "
                               "other, no more.",
                               "各动点的大致位置，点作为键；只需能区分装配形式。"),
    "file_page.table scales": ("Paper scales, for those who want certain ones.", "图纸比例尺，需要指定时才写。"),
    "file_page.asked": ("What `ask` understands (and `sweep --of`, `find`):", "ask（以及 sweep --of、find）可写的量："),
    "file_page.ask rotation": ("theta 3, omega 3, alpha 3: direction, angular velocity and angular acceleration of "
                               "link 3",
                               "theta 3、omega 3、alpha 3：构件 3 的方向角、角速度、角加速度"),
    "file_page.ask motion": ("v C, a C: of point C; v_x C, v_y C, a_x C, a_y C: their components",
                             "v C、a C：点 C 的速度、加速度；v_x C、v_y C、a_x C、a_y C：其分量"),
    "file_page.ask place": ("x C, y C: where point C is; path C: both, over a motion its path",
                            "x C、y C：点 C 的坐标；path C：两者，运动中即其轨迹"),
    "file_page.ask relative": ("v CB, a CB, a_n CB, a_t CB: of C relative to B, two points of one link",
                               "v CB、a CB、a_n CB、a_t CB：同一构件上 C 相对 B"),
    "file_page.ask coincident": ("v B3B2, a_k B3B2, a_r B3B2: of coincident points; B3 is the point of link 3 under "
                                 "point B; a_k takes the ω of link 2, or of 3 where B is a pin or block of 2 that slides "
                                 "along 3: the path is straight there, and a_k B2B3 is the opposite; of links whose names are longer B@rod is that of rod: v B@rod, a_k B@rod,B@tube",
                                 "v B3B2、a_k B3B2、a_r B3B2：重合点；B3 是构件 3 上与 B 重合的点；"
                                 "a_k 取构件 2 的 ω，若 B 是 2 上沿 3 滑动的销或滑块，则取 3 的（B 相对 3 沿直线移动），a_k B2B3 与之等值反向；构件名较长时，rod 上的点写作 B@rod：v B@rod、a_k B@rod,B@tube"),
    "file_page.ask displacement": ("s ram: displacement of a named slide", "s ram：有名称的移动副的位移"),
    "file_page.ask centre": ("P13: an instant centre (P1,3' where names are longer)", "P13：瞬心（名称较长时写 P1,3'）"),
    "file_page.ask quotient": ("omega 1 / omega 3: a quotient of two of one unit", "omega 1 / omega 3：两个同单位量之比"),
    "file_page.whole": ("A whole file to start from: `graphkin new four-bar > mine.toml`, or `graphkin show ex3-1`. "
                        "For your editor: `graphkin schema`.",
                        "完整的起始文件：`graphkin new four-bar > mine.toml`，或 `graphkin show ex3-1`。供编辑器使用：`graphkin "
                        "schema`。"),
    # === each key, by table and key
    "file_keys.file title": ("What the mechanism is called: one text, or one for each language.", "机构名称：一段文字，或每种语言一段。"),
    "file_keys.file source": ("Where the problem is from; shown only. One text, or one in each language as { en = .., "
                              "zh = .. }.",
                              "题目出处，只显示。一段文字，或写成 { en = .., zh = .. }。"),
    "file_keys.file text": ("A story that stands before what is given, in handouts and sets: one text, or one in each "
                            "language as { en = .., zh = .. }.",
                            "题目正文，在讲义与作业中印在已知条件之前：一段文字，或写成 { en = .., zh = .. }。"),
    "file_keys.file ask": ("What the problem wants, a list of quantities; a question in words ends with `?` and is "
                           "shown only.",
                           "题目要求的量；以“？”结尾的文字只显示、不求解。"),
    "file_keys.file frame": ("The fixed link: its fixed points.", "机架：各固定点。"),
    "file_keys.file links": ("The moving links, one table each; the name is any word of letters, digits, _ and '.",
                             "各活动构件，每件一个表；名称由字母、数字、_ 和 ' 组成。"),
    "file_keys.file slide": ("Sliding pairs, and pins in slots.", "移动副，以及销与滑槽。"),
    "file_keys.file gear": ("Pairs of gears.", "齿轮副。"),
    "file_keys.file roll": ("Wheels that roll without slip.", "纯滚动副。"),
    "file_keys.file cam": ("Profiles that touch and slide on each other.", "凸轮副：两轮廓接触并相对滑动。"),
    "file_keys.file driver": ("What moves the mechanism: as many as it has degrees of freedom.", "原动件：个数等于自由度。"),
    "file_keys.file pose": ("A value that fixes the drawn position only.", "只确定图示位置的给定值。"),
    "file_keys.file sketch": ("Roughly where moving points are: it picks the assembly, and the `side` of wheels and "
                              "faces.",
                              "各动点的大致位置：用来选定装配形式，以及滚轮、平底在直线的哪一侧（side）。"),
    "file_keys.file scales": ("Paper scales; one left out is chosen to fill the sheet.", "图纸比例尺；省略时自动选取。"),
    "file_keys.file points": ("What answers are worth.", "各答案的分值。"),
    "file_keys.points follows": ('An answer that follows rightly from a wrong one counts "full" (if left out), "half" '
                                 'or "none".',
                                 '由前面的错误数值正确推出的答案：得全部（full，省略时）、一半（half）或不得分（none）。'),
    "file_keys.points *": ("Points of an answer, by its text in `ask`.", "某一答案的分值，键为 ask 中的写法。"),
    "file_keys.title en": ("The English title.", "英文名称。"),
    "file_keys.title zh": ("The Chinese title.", "中文名称。"),
    "file_keys.frame name": ("The frame's own number, for instant centres; 0 if left out. Other tables call it "
                             '"frame" or by this name.',
                             '机架编号，用于瞬心；省略为 0。其他表中写 "frame" 或此名。'),
    "file_keys.frame *": ("A fixed point and its place [x, y], x to the right, y up.", "固定点及其坐标 [x, y]，x 向右，y 向上。"),
    "file_keys.link points": ("Points of the link that need no length, such as the one point of a block or of a wheel.",
                              "不需要尺寸的点，如滑块或轮的唯一一点。"),
    "file_keys.link ccw": ("Three points that run counter-clockwise in this order, or a list of such triples; needed "
                           "where lengths leave two mirror images.",
                           "按此顺序为逆时针的三点，或若干这样的三点组；仅有长度而有两种镜像时需要。"),
    "file_keys.link shape": ("All points of the link by coordinates [x, y], in any axes fixed in the link; in place "
                             "of lengths.",
                             "用固结在构件上的任意坐标系给出各点 [x, y]，代替长度。"),
    "file_keys.link *": (
        "Two points: their distance. Three points, BDE = 90: the angle at D between D->B and D->E, 0 to 180 deg. The "
        "first two points named in the table give the link's direction: theta is that of A->B for AB, of B->A for BA.",
        "两点：其距离。三点 BDE = 90：D 处 D→B 与 D→E 的夹角，0 到 180 度。表中最先写出的两点决定构件方向：写 AB 时 theta 是 A→B 的方向，写 BA 时是 B→A 的方向。"),
    "file_keys.slide name": ("A name, to drive the slide or to ask for `s ram`. s is measured along the line, from "
                             "`through` to the point.",
                             "名称，用于驱动或求 s ram。s 沿直线由 through 量到滑块上的点。"),
    "file_keys.slide title": ("What the slide is called in texts: one name, or one in each language as { en = .., zh "
                              "= .. }.",
                              "移动副在文中的名称：一个名称，或写成 { en = .., zh = .. } 分别给出两种语言的名称。"),
    "file_keys.slide block": ("The link that slides and does not turn against the guide. Goes with `point`.",
                              "滑块构件，与导路无相对转动。与 point 同用。"),
    "file_keys.slide point": ("The point of the block that stays on the line.", "滑块上始终在直线上的点。"),
    "file_keys.slide pin": ("A point that stays on the line while its link may turn: a pin in a slot. In place of "
                            "`block` and `point`.",
                            "始终在直线上的销，其构件可以转动（销槽副）；代替 block 和 point。"),
    "file_keys.slide guide": ('The link that carries the line, or "frame". A guide of one point that slides on '
                              "nothing needs no further key: the line is its own axis (a cylinder).",
                              '带有直线的构件，或 "frame"。不在其他构件上滑动的单点导路不必再写直线：直线就是其轴线（液压缸）。'),
    "file_keys.line through": ("The line passes through this point of its link; on the frame it may be a place [x, y] "
                               "instead.",
                               "直线通过其所在构件上的这一点；在机架上也可写坐标 [x, y]。"),
    "file_keys.line toward": ("The line runs from `through` to this other point of the same link. Stands in place of "
                              "`from` and `angle`.",
                              "直线由 through 指向同一构件上的这另一点；代替 from 和 angle。"),
    "file_keys.line from": ("The direction from which `angle` is measured: D->C, two points of the link that carries "
                            "the line. Left out on the frame: +x. For a link of one point, two points of the link it "
                            "slides on.",
                            "angle 由此方向 D→C 量起（直线所在构件上的两点）。在机架上省略即为 +x 轴；单点构件则取其导路构件上的两点。"),
    "file_keys.line angle": ("Angle from the direction `from` to the line, positive counter-clockwise; 0 if left out.",
                             "由 from 方向到直线的角度，逆时针为正；省略为 0。"),
    "file_keys.slide tilt": ("Angle from the line to the direction of the block's first two points, positive "
                             "counter-clockwise. A block of two or more points needs it, one of one point has none.",
                             "由直线到滑块最先两点方向的角度，逆时针为正；两点以上的滑块必须给出，单点滑块不写。"),
    "file_keys.slide centre": ("Of a circular slot in place of a line, with `pin`: its centre, a point of the guide; "
                               "for the frame also [x, y].",
                               "圆弧槽（与 pin 同用，代替直线）的圆心：导路上的点；在机架上也可写 [x, y]。"),
    "file_keys.slide radius": ("The radius of a circular slot's centre line.", "圆弧槽中心线的半径。"),
    "file_keys.gear links": ('The two gears; one may be "frame". Other links keep the distance of their centres.',
                             '两齿轮；其一可为 "frame"。中心距由其他构件保持。'),
    "file_keys.gear centres": ("Their centres, in the same order.", "两轮中心，次序相同。"),
    "file_keys.gear radii": ("Their pitch radii, in the same order.", "两轮节圆半径，次序相同。"),
    "file_keys.gear internal": ("One rim encloses the other: the larger is the ring. false if left out.",
                                "内啮合，较大者为内齿圈；省略为 false。"),
    "file_keys.roll name": ("On a line: a name, to drive the wheel like a slide. s is measured along the line, from "
                            "`through` to the centre.",
                            "在直线上滚动时的名称，可像移动副那样驱动。s 沿直线由 through 量到轮心。"),
    "file_keys.roll wheel": ("The link that rolls.", "滚动的构件。"),
    "file_keys.roll centre": ("Its centre, a point of the wheel.", "轮心，轮上的点。"),
    "file_keys.roll radius": ("Its radius.", "轮的半径。"),
    "file_keys.roll on": ("The link it rolls on: on a line (`through` ..) or on a circle (`on_centre`, `on_radius`).",
                          "轮在其上滚动的构件：沿直线（through 等）或沿圆（on_centre、on_radius）。"),
    "file_keys.roll side": ("On which side of the line the wheel's centre lies, looking along the line. Left out: as "
                            "the sketch has it, else left.",
                            "沿直线方向看，轮心在直线的哪一侧；省略时按 sketch，无从判断则为 left。"),
    "file_keys.roll on_centre": ("Centre of the circle it rolls on, a point of `on`.", "所沿圆的圆心，on 构件上的点。"),
    "file_keys.roll on_radius": ("Radius of that circle.", "该圆的半径。"),
    "file_keys.roll internal": ("On a circle: one encloses the other. false if left out.", "沿圆滚动时：一圆包含另一圆；省略为 false。"),
    "file_keys.profile centre": ("A circular profile: its centre, a point of the link.", "圆弧轮廓的圆心，构件上的点。"),
    "file_keys.profile radius": ("A circular profile: its radius; 0 is a knife edge.", "圆弧轮廓的半径；0 为尖顶。"),
    "file_keys.profile side": ("A straight face: on which side of its line the other profile's centre lies, looking "
                               "along the line. Left out: as the sketch has it, else left.",
                               "直线轮廓：沿直线方向看，另一轮廓的圆心在哪一侧；省略时按 sketch，无从判断则为 left。"),
    "file_keys.cam links": ('The two links that touch; one may be "frame".', '相接触的两构件；其一可为 "frame"。'),
    "file_keys.cam profiles": ("One profile for each link, in the same order: a circle or a straight face, and not "
                               "two faces.",
                               "每个构件一个轮廓，次序相同：圆或直线，但不能两个都是直线。"),
    "file_keys.cam internal": ("Two circles, one inside the other. false if left out.", "两圆内切；省略为 false。"),
    "file_keys.pose vector": ("The direction A->B, two points of one link.", "方向 A→B，同一构件上的两点。"),
    "file_keys.pose angle": ("Angle of that direction at the drawn position, positive counter-clockwise from +x, or "
                             "from `from`.",
                             "该方向在图示位置的角度，由 +x（或 from）量起，逆时针为正。"),
    "file_keys.pose from": ("Measure the angle from this direction of another link instead of from +x.",
                            "角度改由另一构件上的此方向量起。"),
    "file_keys.pose slide": ("A named slide, or a named wheel on a line, in place of `vector`.",
                             "有名称的移动副或直线滚动副，代替 vector。"),
    "file_keys.pose at": ("Its displacement s at the drawn position, along its line from `through`.",
                          "其在图示位置的位移 s，沿直线由 through 量起。"),
    "file_keys.driver vector": ("What is driven: the direction A->B, two points of one link.", "被驱动的方向 A→B，同一构件上的两点。"),
    "file_keys.driver link": ("What is driven: a wheel whose own direction does not matter. With `omega`, `alpha` "
                              "only.",
                              "被驱动的轮，其自身方位无关紧要；只给 omega、alpha。"),
    "file_keys.driver slide": ("What is driven: a named slide (a piston, a cylinder), or a named wheel on a line. "
                               "With `at`.",
                               "被驱动的移动副（活塞、液压缸）或直线滚动副的名称；与 at 同用。"),
    "file_keys.driver angle": ("Angle of `vector` at the drawn position, positive counter-clockwise from +x, or from "
                               "`from`.",
                               "vector 在图示位置的角度，由 +x（或 from）量起，逆时针为正。"),
    "file_keys.driver from": ("A motor carried on a moving link: `angle`, `omega` and `alpha` are relative to this "
                              "direction of another link. Commands and programs call this driver AB/BA.",
                              "装在活动构件上的电机：angle、omega、alpha 均相对于另一构件上的此方向；命令和程序中此原动件称为 AB/BA。"),
    "file_keys.driver at": ("Displacement s of `slide` at the drawn position, along its line from `through`.",
                            "slide 在图示位置的位移 s，沿直线由 through 量起。"),
    "file_keys.driver omega": ("Angular velocity, positive counter-clockwise; 0 if left out.", "角速度，逆时针为正；省略为 0。"),
    "file_keys.driver alpha": ("Angular acceleration, positive counter-clockwise; 0 if left out.", "角加速度，逆时针为正；省略为 0。"),
    "file_keys.driver velocity": ("Of a slide: the rate of s. Of a vector, in place of `omega`: the speed of its head "
                                  "about its tail, positive counter-clockwise. 0 if left out.",
                                  "移动副：s 的变化率。vector：其末端绕始端的速度，逆时针为正，代替 omega。省略为 0。"),
    "file_keys.driver acceleration": ("Of a slide: the rate of `velocity`. Of a vector, in place of `alpha`: "
                                      "tangential. 0 if left out.",
                                      "移动副：velocity 的变化率。vector：切向加速度，代替 alpha。省略为 0。"),
    "file_keys.driver also": ("Further values of `angle` (or `at`) that the problem asks for, reached by moving on "
                              "from the drawn position; deg (or mm), or texts with a unit.",
                              "题目还要求的其他 angle（或 at）值，由图示位置运动到达；单位度（或 mm），也可写带单位的文字。"),
    "file_keys.scales length": ("Length scale: m on one mm of paper.", "长度比例尺 μl：m/mm。"),
    "file_keys.scales velocity": ("Velocity scale: m/s on one mm of paper.", "速度比例尺 μv：(m/s)/mm。"),
    "file_keys.scales acceleration": ("Acceleration scale: m/s² on one mm of paper.", "加速度比例尺 μa：(m/s²)/mm。"),
    "file_keys.sketch *": ("A moving point and roughly where it is, [x, y].", "动点及其大致位置 [x, y]。"),
}
