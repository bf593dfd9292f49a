"""The catalogue: both languages of a phrase say the same, what is asked for exists, and what exists is asked for."""

from __future__ import annotations

import ast
import re
import string
from collections.abc import Iterator
from functools import cache
from importlib import import_module
from itertools import chain, product
from pathlib import Path
from typing import TypeGuard

import click

import graphkin

PACKAGE = Path(graphkin.__file__).parent
SPEAKER = PACKAGE / "say"
SPEAKING = {"say", "say_close", "phrase", "in_both", "head", "meaning", "misused"}
"""Functions and methods whose first argument is the name of a phrase."""


@cache
def catalogue() -> dict[str, tuple[str, str]]:
    files = [path.stem for path in (SPEAKER / "phrases").glob("*.py") if path.stem != "__init__"]
    tables = {name: import_module(f"graphkin.{SPEAKER.name}.phrases.{name}").PHRASES for name in files}
    return {key: texts for table in tables.values() for key, texts in table.items()}


def placeholders(text: str) -> set[tuple[str, str | None]]:
    """By name and format: a figure has as many digits in either language."""
    return {(name, form) for _, name, form, _ in string.Formatter().parse(text) if name is not None}


def test_both_languages_take_the_same_words():
    unlike = [name for name, (en, zh) in catalogue().items() if placeholders(en) != placeholders(zh)]
    assert not unlike


# --- asked for ----------------------------------------------------------------------------------


def readers() -> Iterator[Path]:
    apart = {SPEAKER / "phrases", SPEAKER / "catalogue.py"}
    return (path for path in PACKAGE.rglob("*.py") if apart.isdisjoint((path, path.parent)))


Function = ast.FunctionDef | ast.AsyncFunctionDef


def asked(node: ast.expr, inside: ast.AST) -> Iterator[str]:
    """The names that an argument may stand for, as patterns: a text, one of several, or a text with a word left open."""
    match node:
        case ast.Constant(str(text)):
            yield re.escape(text)
        case ast.IfExp():
            yield from asked(node.body, inside)
            yield from asked(node.orelse, inside)
        case ast.JoinedStr(parts):
            yield from map("".join, product(*(pieces(part, inside) for part in parts)))
        case ast.Tuple(parts) | ast.List(parts):
            for part in parts:
                yield from asked(part, inside)
        case ast.Name(name):
            for value in bound(name, inside):
                yield from asked(value, inside)
        case _:
            yield ""


def pieces(part: ast.expr, inside: ast.AST) -> list[str]:
    """What a part of a text may be: as it stands, one of several words that are written there, or anything."""
    match part:
        case ast.Constant(str(text)):
            return [re.escape(text)]
        case ast.FormattedValue(ast.Name(name)):
            found = [text for value in bound(name, inside) for text in asked(value, inside)]
            return found if found and all(found) else ["(.+)"]
        case _:
            return ["(.+)"]


def bound(name: str, inside: ast.AST) -> Iterator[ast.expr]:
    """What a name of a function is set to, or runs over."""
    for node in ast.walk(inside):
        match node:
            case ast.Assign(targets=[ast.Name(target)], value=value) if target == name:
                yield value
            case ast.comprehension(target=ast.Name(target), iter=run) | ast.For(target=ast.Name(target), iter=run) if target == name:
                yield run


def is_parameter(node: ast.expr, inside: ast.AST) -> bool:
    """Whether a speaking function hands on what it is asked itself."""
    return (
        isinstance(inside, Function) and inside.name in SPEAKING
        and isinstance(node, ast.Name) and node.id in {a.arg for a in inside.args.args}
    )  # fmt: skip


@cache
def patterns() -> dict[str, str]:
    """What the package asks for, and where."""
    found: dict[str, str] = {}
    for path in readers():
        tree, inner = parsed(path), set[ast.Call]()
        functions = [node for node in walked(path) if isinstance(node, Function)]
        for inside in [*functions, tree]:
            calls = [node for node in (walked(path) if inside is tree else ast.walk(inside)) if is_speaking(node)]
            for call in calls:
                if is_parameter(call.args[0], inside) or (inside is tree and call in inner):
                    continue
                place = f"{path.relative_to(PACKAGE)}:{call.lineno}"
                found |= dict.fromkeys(asked(call.args[0], inside), place)
            inner.update(calls)
    return found


def is_speaking(node: ast.AST) -> TypeGuard[ast.Call]:
    if not (isinstance(node, ast.Call) and node.args):
        return False
    return (node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")) in SPEAKING


@cache
def compiled() -> tuple[re.Pattern[str], ...]:
    return tuple(re.compile(pattern, re.DOTALL) for pattern in patterns() if pattern)


@cache
def texts() -> frozenset[str]:
    """Every text that stands in the code, its phrases apart, and in click, which asks for texts of its own."""
    own = (node for path in Path(click.__file__).parent.glob("*.py") for node in walked(path))
    return frozenset(node.value for node in chain(nodes(), own) if isinstance(node, ast.Constant) and isinstance(node.value, str))


@cache
def made() -> re.Pattern[str]:
    """Texts that the code makes of a word and something open, as patterns: `f"{pivot} chosen"`."""
    patterns = (next(asked(node, node)) for node in nodes() if isinstance(node, ast.JoinedStr))
    return re.compile("|".join(sorted({pattern for pattern in patterns if re.search("[a-z]{4}", pattern)})))


def nodes() -> Iterator[ast.AST]:
    return (node for path in readers() for node in walked(path))


@cache
def parsed(path: Path) -> ast.Module:
    return ast.parse(path.read_text("utf-8"))


@cache
def walked(path: Path) -> tuple[ast.AST, ...]:
    return tuple(ast.walk(parsed(path)))


@cache
def is_known(word: str) -> bool:
    return word in texts() or word.isdigit() or made().fullmatch(word) is not None


def test_what_is_asked_for_exists():
    names = "\n".join(catalogue())
    missing = {
        place: pattern for pattern, place in patterns().items()
        if not pattern or not re.search(f"^(?:{pattern})$", names, re.MULTILINE)
    }  # fmt: skip
    assert not missing


@cache
def of_scripts() -> tuple[re.Pattern[str], ...]:
    """What the scripts of pages and their elements ask for; of a family, `${..}` or `{..}` stands for its other words."""
    written = [*(PACKAGE / "page" / "script").glob("*.[jh]*"), *(PACKAGE / "page").glob("*.py")]
    texts = "".join(path.read_text("utf-8") for path in sorted(written))
    quoted = {match[1] for match in re.finditer(r"""["`]([a-z$][^"`\n]*)["`]""", texts)}
    return tuple(re.compile(re.sub(r"(\\\$)?\\\{.+?\\\}", "(.+)", re.escape(text))) for text in quoted)


def is_asked_for(name: str) -> bool:
    """By itself, or as one of a family whose other words the code knows."""
    if any(pattern.fullmatch(own) for own in (name, name.partition(".")[2]) for pattern in of_scripts()):
        return True
    found = [match for pattern in compiled() if (match := pattern.fullmatch(name))]
    return any(all(map(is_known, match.groups())) for match in found)


def test_families_have_a_name():
    """What is left open stands after a word: else a family would be the whole file."""
    assert not {place: pattern for pattern, place in patterns().items() if re.fullmatch(r"\w+\\\.\(\.\+\)", pattern)}


def test_what_exists_is_asked_for():
    assert not [name for name in catalogue() if not is_asked_for(name)]


def test_only_the_catalogue_reads_phrases():
    assert not [path for path in readers() if "PHRASES" in path.read_text("utf-8")]


# --- languages ----------------------------------------------------------------------------------

SPOKEN = {"errors", "say", "sheet", "outputs", "homework", "handouts", "page", "cli"}
"""What speaks: errors bring their words, the others are media; `homework` has formats of files."""
TITLED = {"model", "files"}
"""A mechanism bears its title in each language; files to start from have comments in one of them."""
EDGE = {"results", "equations", "api"}
"""`equations` is data but for its pages; `results` gives the title in the language asked for, as `api` hands it on."""


def part(path: Path) -> str:
    return path.relative_to(PACKAGE).parts[0].removesuffix(".py")


def imports_lang(path: Path) -> bool:
    imported = (node for node in walked(path) if isinstance(node, ast.ImportFrom))
    return any(alias.name == "Lang" for node in imported for alias in node.names)


def test_subjects_know_no_language():
    knowing = {part(path) for path in PACKAGE.rglob("*.py") if imports_lang(path)}
    assert knowing <= SPOKEN | TITLED | EDGE


def test_formulas_know_no_language():
    files = [path for path in (PACKAGE / "equations").glob("*.py") if imports_lang(path)]
    assert {path.stem for path in files} == {"document", "figure", "written"}


def test_subjects_hold_no_chinese():
    """Beside docstrings: what is to be read stands in the catalogue, in errors, and on sheets; `submissions` read what
    students write, in either language, and a format of a platform may have words of its own; `files` shows how keys
    are written, titles too."""
    holding = {part(path) for path in readers() if any(map(is_chinese, said_in(path)))}
    assert holding <= {"errors", "sheet", "outputs", "homework", "submissions", "files"}


def said_in(path: Path) -> Iterator[str]:
    """Texts that are no docstrings."""
    alone = {id(node.value) for node in walked(path) if isinstance(node, ast.Expr)}
    texts = (node for node in walked(path) if isinstance(node, ast.Constant) and id(node) not in alone)
    return (node.value for node in texts if isinstance(node.value, str))


def is_chinese(text: str) -> bool:
    return re.search("[\u4e00-\u9fff]", text) is not None and "\u9fff" not in text


def test_coriolis_has_one_name():
    """The book's."""
    assert not [name for name, (_, zh) in catalogue().items() if "哥氏" in zh]
