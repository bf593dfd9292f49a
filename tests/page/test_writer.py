"""Pages are joined from scripts that stand alone, and hold nothing that could ask for anything."""

from __future__ import annotations

import base64
import hashlib
import json
import re

import pytest

from graphkin.page import writer

SCRIPTS = sorted(writer.FOLDER.glob("*.js"))
TOP = re.compile(r"^(?:export )?(?:async )?(?:function\*?|const|let|class) +(\w+)", re.MULTILINE)


def test_names_are_different_in_all_scripts():
    """They are joined into one function."""
    names = [name for path in SCRIPTS for name in TOP.findall(path.read_text("utf-8"))]
    assert sorted(names) == sorted(set(names))


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.name)
def test_scripts_ask_for_nothing(path):
    text = path.read_text("utf-8")
    assert not re.search(r"\b(fetch|XMLHttpRequest|WebSocket|eval|innerHTML|document\.write)\b", text)
    order = list(writer.needed_scripts(text))
    whole = writer.joined([path.stem])
    assert not re.search(r"^(import|export)\b", whole, re.MULTILINE)
    for name in order:
        own = TOP.search((writer.FOLDER / f"{name}.js").read_text("utf-8"))[0].removeprefix("export ")
        assert -1 < whole.index(own) < whole.index(TOP.search(text)[0].removeprefix("export "))


def test_the_policy_names_what_runs(tmp_path):
    text = writer.page("<a>", "zh", scripts=["words"], styles=[], data={"words": {"a": {"en": "</script>", "zh": "<!--"}}})
    policy = re.search('Content-Security-Policy" content="([^"]*)"', text)[1]
    script = re.search(r"<script>(.*?)</script>", text, re.DOTALL)[1]
    assert f"script-src 'sha256-{base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()}';" in policy
    assert policy.startswith("default-src 'none';")
    held = re.search(r'<script type="application/json" id="words">(.*?)</script>', text)[1]
    assert json.loads(held)["a"] == {"en": "</script>", "zh": "<!--"}
    assert "<title>&lt;a&gt;" in text
