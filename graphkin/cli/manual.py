"""The manual: the guide, every command with what it gives, every key, every name, and the library. `help --html`.

`say/manual.md` says what stands where: from `#en` on English, from `#zh` on Chinese. In it `{run draw ex3-1 -o @.svg}`,
with lines below it, is a command: these lines, what that command line draws or prints, and what the command says of
itself. Files that command lines need stand there as code with a name.
"""

from __future__ import annotations

import contextlib
import re
import shlex
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from importlib.metadata import metadata
from pathlib import Path
from tempfile import TemporaryDirectory

import click
from click.testing import CliRunner

import graphkin
from graphkin.cli import BROKEN_OFF, main, streams
from graphkin.errors import Lang
from graphkin.files import library
from graphkin.outputs.markdown import slug
from graphkin.say.file_help import file_lines

_PAIR, _ONE = re.compile(r"(?m)#en (.*?) #zh (.*)$"), re.compile(r"#(?:en|zh) ")
_PART = re.compile(r"(?m)^\{(?!contents)(\w+) ?(.*)\}\n((?:.+\n)*)")
_FILE = re.compile(r"(?ms)^```\w+ (\S+)\n(.*?)^```$")
_HEAD = re.compile(r"(?m)^```(?s:.*?)^```$|^(###?) (.*)")
_DRAWING = re.compile(r"(?s)<svg.*?</svg>")
_PICTURE = re.compile(r"(?m)^ *!\[.*\]\(.*\)\n\n?")
_MOST, _WIDE = 45, 130  # lines of what a command prints, and letters of a line
_STYLE = """<style>body { max-width: 240mm } h2 { margin-top: 2.5em; font-size: 1.4em }
pre { overflow-x: auto; background: #f4f6f9; padding: 8px; font-size: .85em }
pre, code { font-family: "DejaVu Sans Mono", "Noto Sans Mono CJK SC", monospace }
:not(pre) > code { overflow-wrap: anywhere } span { white-space: normal }
td svg { width: min(60mm, 22vw); height: auto; max-height: 50mm } figure svg { max-width: 100%; height: auto }
@media (min-width: 200mm) { th { white-space: nowrap } }
@media (max-width: 120mm) { th, td { font-size: .7em; padding: 1mm }
td { word-break: break-word } }</style>"""


@dataclass(frozen=True)
class Manual:
    """The manual in a language, for a medium.

    drawn      what stands on the page for a drawing, by its name and its SVG
    pictured   what stands there for a mechanism of the library
    guide      a text with links to other files as it stands there
    api        what is said of each public name
    """

    lang: Lang
    drawn: Callable[[str, str], str]
    pictured: Callable[[str], str]
    guide: Callable[[str], str]
    api: Mapping[str, str]

    def text(self) -> str:
        """The whole page, as Markdown."""
        text = self.guide(skeleton(self.lang))
        with streams.waiting(), TemporaryDirectory() as folder, contextlib.chdir(folder):
            for name, content in _FILE.findall(text):
                Path(name).write_text(content, "utf-8")
            text = _PART.sub(self._part, text)
        heads = ((level, head) for level, head in _HEAD.findall(text) if level)
        links = (("\n- " if level == "##" else " · ") + f"[{head}](#{slug(head)})" for level, head in heads)
        return text.replace("{contents}", "".join(links).strip())

    def _part(self, part: re.Match[str]) -> str:
        """The text in place of its name in the skeleton."""
        kind, words, lines = part.groups()
        match kind:
            case "run":
                return "\n\n".join([f"### {words.split()[0]}", *lines.splitlines(), *self._run(words)]) + "\n"
            case "keys":
                return _fenced("\n".join(file_lines(self.lang))) + "\n"
            case "api":
                return "\n\n".join(f"#### {name}\n\n{_fenced(text)}" for name, text in self.api.items()) + "\n"
            case "readme":  # in this language, from its first paragraph on
                _, english, chinese = re.split(r"(?m)^# .*\n\n.*\n\n", whole_readme())
                return self.guide(english.rstrip("\n-") if self.lang == "en" else chinese.rstrip()) + "\n"
            case _:
                return "".join(self._library()) + "\n"

    def _run(self, words: str) -> Iterator[str]:
        """A command line, what it gives, and what the command says of itself."""
        name = words.split(" ")[0]
        line = words.replace("@", name)
        done = CliRunner().invoke(main, ["--lang", self.lang, *shlex.split(line)], catch_exceptions=False)
        if done.exit_code == BROKEN_OFF:
            raise KeyboardInterrupt
        files = [Path(name + end) for end in (".svg", ".html") if "@" in words and Path(name + end).is_file()]
        if files:
            svg = _DRAWING.findall(files[0].read_text("utf-8"))[-1]
            yield from (_fenced(f"$ graphkin {line}"), self.drawn(name, svg))
        else:
            lines = [line if len(line) <= _WIDE else f"{line[:_WIDE]} .." for line in done.output.splitlines()]
            cut = [*lines[:_MOST], ".."] if len(lines) > _MOST + 1 else lines
            yield _fenced("\n".join([f"$ graphkin {line}", *cut]))
        command = main.get_command(click.Context(main), name)
        assert command is not None, name
        context = click.Context(command, info_name=f"graphkin {name}", terminal_width=100)
        yield _fenced(command.get_help(context))

    def _library(self) -> Iterator[str]:
        for group, names in library.groups().items():
            for name in names:
                mechanism = library.load(name)
                kinds = ", ".join(sorted({pair.table for pair in mechanism.pairs})) or "hinge"
                title, source = mechanism.headline(self.lang), mechanism.credit(self.lang)
                cells = (self.pictured(name), f"`{name}` {title}", kinds, group, source)
                yield f"| {' | '.join(cell.replace('|', '&#124;') for cell in cells)} |\n"


def skeleton(lang: Lang) -> str:
    """The manual's own text, and lines that say what stands between."""
    both = (Path(graphkin.__file__).parent / "say" / "manual.md").read_text("utf-8")
    each = _PAIR.sub(r"\2" if lang == "zh" else r"\1", both).splitlines()
    lines = (line.removeprefix(f"#{lang} ") for line in each if not _ONE.match(line) or line.startswith(f"#{lang} "))
    return re.sub("\n{3,}", "\n\n", "\n".join([*lines, ""]))


def write(output: Path, force: bool, lang: Lang, api: Mapping[str, str]) -> None:
    """The manual as one HTML page that needs nothing but itself."""
    from graphkin.api import Drawing
    from graphkin.homework.platforms.pages import PAGE, document
    from graphkin.outputs.files import beside
    from graphkin.outputs.markdown import html
    from graphkin.outputs.svg import inline

    def drawn(name: str, svg: str) -> str:
        return f'<figure role="img" aria-label="{name}">{svg}</figure>'

    def pictured(name: str) -> str:
        return inline(Drawing.of(library.load(name)).sheet(lang=lang, only="position", style="given", tight=True))

    def guide(text: str) -> str:
        return re.sub(r"\[([^]]*)\]\((?!#|https:)[^)]*\)", r"\1", _PICTURE.sub("", text))

    with beside(output, force, (PAGE,)) as draft:
        whole = document("graphkin", _STYLE + html(Manual(lang, drawn, pictured, guide, api).text()), lang)
        draft.write_bytes(whole)
    click.echo(str(output))


def whole_readme() -> str:
    """README.md of a clone, else as an installation keeps it."""
    beside = Path(graphkin.__file__).parents[1] / "README.md"
    text = beside.read_text("utf-8") if beside.is_file() else ""
    return text if text.startswith("# graphkin\n") else str(metadata("graphkin").json["description"])


def _fenced(text: str) -> str:
    return f"```text\n{text.rstrip()}\n```"
