"""Phrases of wrong usage of a command, and those of click."""

from graphkin.say.catalogue import Phrases

# fmt: off
_CLICK = {
    "Usage:": "用法:", "Options": "选项", "Commands": "命令", "default: {default}": "默认：{default}", "(dynamic)": "（自动）",
    "required": "必填", "Try '{command} {option}' for help.": "'{command} {option}' 显示帮助。",
    "Error: {message}": "错误：{message}", "Invalid value: {message}": "值有误：{message}",
    "Invalid value for {param_hint}: {message}": "{param_hint} 的值有误：{message}", "Missing command.": "缺少命令。",
    "Missing argument": "缺少参数", "Missing option": "缺少选项", "No such command {name!r}.": "没有命令 {name!r}。",
    "No such option {name!r}.": "没有选项 {name!r}。", "Did you mean {possibility}?": "是否为 {possibility}？",
    "(Did you mean one of: {possibilities}?)": "是否为其中之一：{possibilities}？",
    "Got unexpected extra argument ({args})": "多余的参数（{args}）",
    "Got unexpected extra arguments ({args})": "多余的参数（{args}）",
    "Option {name!r} does not take a value.": "选项 {name!r} 不带值。",
    "Option {name!r} requires an argument.": "选项 {name!r} 须带一个值。",
    "Option {name!r} requires {nargs} arguments.": "选项 {name!r} 须带 {nargs} 个值。",
    "Choose from:\n\t{choices}": "可选：\n\t{choices}",
    "{value!r} is not one of {choices}.": "{value!r} 不在 {choices} 之中。",
    "{value!r} is not a valid {number_type}.": "{value!r} 不是合法的数（{number_type}）。",
    "{value} is not in the range {range}.": "{value} 不在范围 {range} 之内。",
    "{name} {filename!r} is a file.": "{filename!r} 是文件，须为 {name}。",
    "{name} {filename!r} is a directory.": "{filename!r} 是文件夹，须为 {name}。",
}
PHRASES: Phrases = {
    "usage.suffix": ("{output}: the file to write must end in {kinds}", "{output}：要写的文件须以 {kinds} 结尾"),
    "usage.needs": ("{option} needs {other}", "{option} 须与 {other} 同用"),
    "usage.without": ("{option}: leave out {others}", "{option}：请去掉 {others}"),
    "usage.one": ("{option}: for one {what} alone", "{option}：只用于一个 {what}"),
    "usage.either": ("name a MECHANISM, or {others}", "请写 MECHANISM，或 {others}"),
    "usage.locus": ("GeoGebra draws paths itself, as Locus(E, slider): leave out --path",
                    "GeoGebra 自己可画轨迹：Locus(E, slider)；请去掉 --path"),
    "usage.watched": ("--watch looks at files, and {file} is none", "--watch 只看文件，{file} 不是文件"),
    "usage.empty": ("MECHANISM is empty: name a file, or a mechanism of `graphkin list`",
                    "MECHANISM 为空：请写文件，或 `graphkin list` 中的机构名"),
    "usage.finite": ("{option}: finite numbers are wanted", "{option}：须为有限的数"),
    "usage.drivers": ("{name} has no driver left for {option}: --angle is for those that turn, --at for those that slide",
                      "{name} 没有可用于 {option} 的原动件了：--angle 用于转动的，--at 用于移动的"),
    "usage.coincident": ("--coincident: {name} has no point {point}", "--coincident：{name} 中没有点 {point}"),
    "usage.same file": ("two mechanisms would be written into {file}: rename one of them",
                        "两个机构将写入同一文件 {file}：请改其中一个的名称"),
    "usage.manual": ("the manual is one page: graphkin help --html -o manual.html",
                     "手册是一页：graphkin help --html --lang zh -o manual.html"),
    "usage.names": ("no {names} in the interface. There are: {known}", "接口中没有 {names}。可用：{known}"),
    "usage.page": ("there is no page {topic!r}: file, api, or a command", "没有 {topic!r} 页：file、api 或命令名"),
    **{f"usage.click {en}": (en, zh) for en, zh in _CLICK.items()},
}
