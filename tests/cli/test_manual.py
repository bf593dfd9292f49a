"""`help --html`: one page that needs nothing but itself. The texts in it are compared in tests/sheet/test_gallery.py."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from graphkin.cli import BROKEN_OFF, design, main, manual
from graphkin.errors import Lang
from graphkin.files import library
from graphkin.outputs.markdown import html

SHORT = "# A\n\n[b](README.md)\n\n{contents}\n\n{readme}\n\n## B\n\n{run design rocker --length 80 --swing 40 --K 1.3 -o @.svg}\n\n### C\n\n| a | b | c | d | e |\n|---|---|---|---|---|\n{library}\n"


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_the_page(lang: Lang, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(manual, "skeleton", lambda _: SHORT)
    monkeypatch.setattr(library, "groups", lambda: {"classics": ("fig3-4", "p3-19")})
    file = tmp_path / "manual.html"
    done = CliRunner().invoke(main, ["help", "--html", "-o", str(file), "--lang", lang], catch_exceptions=False)
    assert done.exit_code == 0
    page = file.read_text("utf-8")
    assert f'<html lang="{lang}">' in page
    assert not re.search(r"""(?:src|href)=["'](?!#|https:)|<(?:img|script|link)""", page), "nothing is loaded from elsewhere"
    assert page.count("<svg") == 3
    assert len(re.findall("<td>", page)) > 10
    for anchor in re.findall('href="#([^"]+)"', page):
        assert f'id="{anchor}"' in page, anchor
    assert "{" not in re.sub(r"(?s)<(style|pre|code).*?</\1>|\{ [a-z]|<svg.*?</svg>", "", page)
    again = CliRunner().invoke(main, ["help", "--html", "-o", str(file)])
    assert again.exit_code == 0, "its own page is written anew"


@pytest.mark.parametrize("words", ["help --html", "help file -o x.html", "help file --html -o x.html"])
def test_the_manual_is_one_page(words: str) -> None:
    done = CliRunner().invoke(main, words.split())
    assert done.exit_code == 2
    assert "help --html -o manual.html" in done.output


def test_a_file_of_another_is_kept(tmp_path: Path) -> None:
    (tmp_path / "x.html").write_text("mine", "utf-8")
    assert CliRunner().invoke(main, ["help", "--html", "-o", str(tmp_path / "x.html")]).exit_code == 3
    assert (tmp_path / "x.html").read_text("utf-8") == "mine"


@pytest.mark.parametrize(
    ("text", "elements"),
    [
        ("a `b*c*` **d** <e>", "<p>a <code>b*c*</code> <b>d</b> &lt;e&gt;</p>"),
        ("3. a\n   b\n\n   ```\n   c\n   ```\n4. d", '<ol start="3"><li><p>a\nb</p>\n<pre>c</pre></li><li><p>d</p></li></ol>'),
        ("| a | b |\n|---|---|\n| `c\\|d` | e |", "<table><tr><th>a</th><th>b</th></tr><tr><td><code>c|d</code></td><td>e</td></tr></table>"),
        ("a:\n\n    b < c\n\nd", "<p>a:</p>\n<pre>b &lt; c</pre>\n<p>d</p>"),
        ("```text\n# a\n\n| b\n```", "<pre># a\n\n| b</pre>"),
    ],
)  # fmt: skip
def test_markdown(text: str, elements: str) -> None:
    assert html(text).replace("<pre>\n", "<pre>") == elements


def test_an_interruption_of_a_command_in_it_ends_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(manual, "skeleton", lambda _: SHORT)
    monkeypatch.setattr(design, "designed", interrupted)
    done = CliRunner().invoke(main, ["help", "--html", "-o", str(tmp_path / "manual.html")])
    assert done.exit_code == BROKEN_OFF
    assert not [*tmp_path.iterdir()]
