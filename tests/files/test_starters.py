"""Files to start from: each loads, solves, answers what it asks, is explained, and speaks one language at a time."""

from __future__ import annotations

import re
from typing import get_args

import pytest
from click.testing import CliRunner

import graphkin
from graphkin import files as loading
from graphkin.cli import main
from graphkin.errors import Lang
from graphkin.files import starters
from graphkin.results import results

LANGUAGES: tuple[Lang, ...] = get_args(Lang)


@pytest.mark.parametrize("kind", starters.kinds())
def test_a_starter_solves(kind: str) -> None:
    mechanism = loading.loads(starters.text(kind, "en"))
    assert not list(loading.remarks(mechanism))
    drawing = graphkin.Drawing.of(mechanism)
    assert all(drawing.explain(lang) for lang in LANGUAGES)
    (position,) = results(mechanism, drawing.method)["positions"]
    assert mechanism.ask
    assert all(answer["value"] is not None for answer in position["ask"].values())
    assert sum(answer["value"] != 0 for answer in position["ask"].values()) >= len(mechanism.ask) - 1


@pytest.mark.parametrize("kind", starters.kinds())
def test_its_comments_are_in_one_language(kind: str) -> None:
    english, chinese = (starters.text(kind, lang) for lang in LANGUAGES)
    comments = [re.findall("(?m)#(?!:)(.*)$", text) for text in (english, chinese)]
    assert len(comments[0]) == len(comments[1]) > 3
    assert not re.search("[\u4e00-\u9fff]", "".join(comments[0]))
    assert all(re.search("[\u4e00-\u9fff]", comment) for comment in comments[1])
    assert not re.search("#(en|zh)", english + chinese)
    assert loading.loads(english).links == loading.loads(chinese).links


def test_new() -> None:
    result = CliRunner().invoke(main, ["new", "four-bar", "--lang", "zh"])
    assert (result.exit_code, result.stdout) == (0, starters.text("four-bar", "zh"))
    unknown = CliRunner().invoke(main, ["new", "six-bar"])
    assert unknown.exit_code == 2
    assert "four-bar" in unknown.output
