"""The library: every file loads, is titled in both languages, and asks something."""

from __future__ import annotations

import pytest

from graphkin.errors import UnknownMechanism
from graphkin.files import library, loads


@pytest.mark.parametrize("name", library.names())
def test_every_file_loads(name: str) -> None:
    mechanism = library.load(name)
    assert mechanism.name == name
    assert mechanism.file == f"{name}.toml"
    assert set(mechanism.title) == {"en", "zh"}
    assert mechanism.source
    assert mechanism.ask
    assert loads(library.text(name)).links == mechanism.links


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_titles_are_distinct(lang: str) -> None:
    titles = library.titles(lang)  # type: ignore[arg-type]
    assert titles == {name: library.load(name).headline(lang) for name in library.names()}  # type: ignore[arg-type]
    assert len(set(titles.values())) == len(library.names())


def test_names_come_in_natural_order() -> None:
    names = library.names()
    assert names.index("p3-3a") < names.index("p3-3b") < names.index("p3-8") < names.index("p3-11a")
    assert names.index("ex3-1") < names.index("fig2-32") < names.index("s2-1a")


def test_every_name_is_in_one_group() -> None:
    grouped = [name for group in library.groups().values() for name in group]
    assert sorted(grouped) == sorted(library.names())


def test_an_unknown_name_gets_the_nearest() -> None:
    with pytest.raises(UnknownMechanism, match=r"Did you mean ex3-1\?") as caught:
        library.load("ex31")
    assert "没有文件 ex31，机构库中也没有这个名称。是否为 ex3-1？" in caught.value.message("zh")
