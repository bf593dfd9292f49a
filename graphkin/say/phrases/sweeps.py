"""A sweep: how far the driver gets and why, change points, greatest values."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "range": ("{driver} moves from {low} to {high}.", "{driver} 的运动范围为 {low} 至 {high}。"),
    "stop": ("It stops at {at}: {why}.", "在 {at} 处停止：{why}。"),
    "dead": ("dead point, {why}", "死点，{why}"),
    "open": ("Looked at as far as {at}; it may go on.", "只考察到 {at}，其后可能仍可运动。"),
    "change": (
        "Change point at {at}: {why}. The motion goes through it smoothly; a real mechanism needs a guide there.",
        "{at} 处为变点（运动不确定位置）：{why}。计算按运动平滑通过；实际机构须有防止反转的措施。",
    ),
    "dropped": (
        "{count} of the positions asked for are not reached and left out.",
        "所要求的位置中有 {count} 个不能到达，已略去。",
    ),
    "undefined": (
        "{count} of the positions are left out: the mechanism has no definite motion there, as at {at}.",
        "已略去 {count} 个位置：机构在该处运动不确定，如 {at}。",
    ),
    "together": (
        "The other drivers move with it, in proportion to their speeds.",
        "其余原动件按各自速度的比例同时运动。",
    ),
    "event in line": ("links {links} lie in line there", "构件 {links} 共线"),
    "event right angle": (
        "links {links}: the link stands at right angles to the guide there",
        "构件 {links}：连杆垂直于导路",
    ),
    "event tangent": ("links {links}: the guide reaches no farther", "构件 {links}：导路已到极限位置"),
    "event parallel": ("links {links}: their lines become parallel there", "构件 {links} 的作图线趋于平行"),
    "event fit": ("the group of links {links} cannot be moved farther", "构件 {links} 所成的杆组到达极限位置"),
    "event two ways": (
        "the group of links {links} could move in two ways from there",
        "构件 {links} 所成的杆组由此可有两种运动",
    ),
    "constant": ("{name} = {value} throughout", "{name} = {value}（处处相同）"),
    "extreme greatest": ("greatest of the rows: {name} = {value} at {at}", "表中最大值：{name} = {value}，在 {at} 处"),
    "extreme least": ("least of the rows: {name} = {value} at {at}", "表中最小值：{name} = {value}，在 {at} 处"),
}
