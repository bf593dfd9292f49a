"""What a program calls: mechanisms from data and from Python, other values in them, results by name, sweeps as tables."""

from __future__ import annotations

import copy
import inspect
import os
import pickle
import re
import tomllib
from collections.abc import Callable
from importlib import import_module
from pathlib import Path

import book
import numpy as np
import pytest
from click.testing import CliRunner

import graphkin
from graphkin import Mechanism
from graphkin.cli import main, reference
from graphkin.errors import (
    BadValues,
    GraphkinError,
    MissingKey,
    NoSuchDriver,
    NoSuchValue,
    NotANumber,
    NotOneOf,
    OutOfRange,
    UnknownKey,
    UnknownPaper,
    UnknownQuantity,
    WrongType,
)
from graphkin.files import library
from graphkin.files.builder import Builder
from graphkin.files.toml import replaced_values, toml

FEW = int(os.environ.get("GRAPHKIN_RANDOM", "40"))


def passes_check(mechanism: graphkin.Mechanism, folder: Path) -> bool:
    """Whether a fresh drawing of it is found right by the command that measures drawings."""
    sheet = folder / "sheet.svg"
    sheet.write_text(graphkin.Drawing.of(mechanism).sheet()._repr_svg_(), encoding="utf-8")
    return CliRunner().invoke(main, ["check", str(sheet)]).exit_code == 0


def alike(one: graphkin.Mechanism, other: graphkin.Mechanism) -> bool:
    parts = ("frame", "links", "pairs", "drivers", "poses", "sketch", "scales", "title", "ask")
    return all(getattr(one, part) == getattr(other, part) for part in parts)


# --- data and text ----------------------------------------------------------------------------


@pytest.mark.parametrize("name", library.names())
def test_data_give_the_mechanism_of_the_file(name: str):
    read = graphkin.load(name)
    made = graphkin.from_dict(tomllib.loads(read.text), name=name)
    assert alike(made, read)
    assert alike(graphkin.loads(made.to_toml()), read)


def test_data_may_be_numpy():
    crank = {"frame": {"A": np.array([0, 0])}, "links": {"1": {"AB": np.float64(24)}}}
    made = graphkin.from_dict(crank | {"driver": [{"vector": "AB", "angle": np.int64(60), "omega": 10}]})
    assert made.drivers[0].value == pytest.approx(np.radians(60))
    assert abs(made.links["1"].arm("A", "B")) == 0.024


def test_texts_of_any_letters_come_back():
    document = {"title": {"en": 'a "b" \\ c\n', "zh": "四杆"}, "source": "é\t", "links": {"1'": {"A'B": 1.5e-7}}}
    assert tomllib.loads(toml(document)) == document


def test_data_that_no_file_holds():
    with pytest.raises(WrongType, match=r"links\.1\.AB"):
        graphkin.from_dict({"links": {"1": {"AB": object()}}})


# --- built in Python --------------------------------------------------------------------------


def four_bar() -> Builder[Mechanism]:
    return (
        Mechanism.new("s3-four").fix("4", A=(0, 0), D=(70, 0))
        .link(1, AB=30).link(2, BC=60, BE=40, CE=35, ccw="BCE").link(3, DC=50)
        .drive("AB", angle=65, omega=10, alpha=20).sketch(C=(70, 50))
    )  # fmt: skip


def slider_crank() -> Builder[Mechanism]:
    return (
        Mechanism.new("p3-23a").fix("4", A=(0, 0)).link(1, AB=100).link(2, BC=300).link(3, points="C")
        .slide(block=3, point="C", guide="frame", through=(0, 30), angle=0)
        .drive("AB", angle=60, omega=10).sketch(C=(345, 30))
    )  # fmt: skip


def shaper() -> Builder[Mechanism]:
    return (
        Mechanism.new("s3-shaper").fix("6", A=(0, 0), C=(0, -90))
        .link(1, AB=40).link(2, points="B").link(3, CD=170).link(4, DE=60).link(5, points="E")
        .slide(block=2, point="B", guide=3, through="C", toward="D")
        .slide(block=5, point="E", guide="frame", through=(0, 85), angle=0)
        .drive("AB", angle=30, omega=10).sketch(D=(55, 70), E=(110, 85))
    )  # fmt: skip


def gear_train() -> Builder[Mechanism]:
    return (
        Mechanism.new("ex3-3").fix(1, O=(0, 0), D=(95, -10))
        .link(2, OM=20).link(3, PB=10).link(4, OP=35).link(5, BC=60).link(6, DC=45)
        .gear(links=(2, 3), centres=("O", "P"), radii=(20, 15))
        .gear(links=(3, "frame"), centres="PO", radii=(15, 50), internal=True)
        .pose(vector="OP", angle=60).pose(vector="PB", angle=130)
        .drive("OM", angle=0, omega=-10).sketch(P=(17, 30), B=(11, 38), C=(70, 27))
    )  # fmt: skip


def cam() -> Builder[Mechanism]:
    eccentric, face = {"centre": "B", "radius": 25}, {"through": "D", "toward": "H", "side": "left"}
    return (
        Mechanism.new("p3-8").fix("3", A=(0, 0), D=(50, 0)).link(1, AB=15).link(2, DH=70)
        .cam(links=(1, 2), profiles=(eccentric, face)).drive("AB", angle=90, omega=10).sketch(H=(10, 55))
    )  # fmt: skip


def six_bar() -> Builder[Mechanism]:
    return (
        Mechanism.new("ex3-2").fix(1, A=(0, 0), G=(80, -30), F=(170, -40))
        .link(2, AB=25).link(3, BC=75).link(4, CD=34, DE=60, CE=91, ccw="DEC").link(5, EF=82).link(6, GD=71)
        .drive("AB", angle=110, omega=10).sketch(C=(60, 55), D=(90, 40), E=(150, 40))
    )  # fmt: skip


@pytest.mark.parametrize("build", [four_bar, slider_crank, shaper, gear_train, cam, six_bar])
def test_built_as_the_file_says(build: Callable[[], Builder[Mechanism]], tmp_path: Path):
    builder = build()
    read = graphkin.load(builder.name)
    made = builder.titled(**read.title, source=read.source).asking(*read.ask).done()
    assert alike(made, read)
    assert passes_check(made, tmp_path)


def test_mechanisms_share_a_beginning():
    begun = Mechanism.new().fix(A=(0, 0)).link(1, AB=20)
    fast, slow = (begun.drive("AB", angle=0, omega=omega).done() for omega in (10, 1))
    assert (fast.drivers[0].rate, slow.drivers[0].rate) == (10, 1)


def test_a_table_named_again_gets_further_keys():
    four_bar = Mechanism.new(en="Four-bar").fix(A=(0, 0), D=(60, 0)).link(1, AB=20).link(3, DC=40).link(2, BC=50)
    four_bar = four_bar.titled(zh="铰链四杆机构").link("2", BE=30, CBE=40, ccw="BCE").link(1, AB=22)
    made = four_bar.drive("AB", angle=60).sketch(C=(45, 38)).done()
    assert made.title == {"en": "Four-bar", "zh": "铰链四杆机构"}
    assert abs(made.links["1"].arm("A", "B")) == pytest.approx(0.022)
    assert set(made.links["2"].points) == {"B", "C", "E"}


def test_a_builder_that_is_not_done_says_so():
    builder = graphkin.Mechanism.new().fix(A=(0, 0))
    with pytest.raises(AttributeError, match=r"'links'; `done\(\)`"):
        builder.links  # noqa: B018
    assert copy.deepcopy(builder) == pickle.loads(pickle.dumps(builder)) == builder


def test_what_is_wrong_in_a_builder_is_said():
    with pytest.raises(GraphkinError, match=r"<mine>:\d+, links\.1\.AB"):
        Mechanism.new("mine").fix(A=(0, 0)).link(1, AB=-3).drive("AB", angle=0).done()


# --- other values -----------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["ex3-1", "p3-21", "ex3-3", "p3-8", "s4-ex1", "ex3-7"])
def test_a_changed_mechanism_is_drawn_and_checked(name: str, tmp_path: Path):
    mechanism = graphkin.load(name)
    document = tomllib.loads(mechanism.text)
    link = next(link for link, table in document["links"].items() if any(isinstance(v, int | float) for v in table.values()))
    key = next(key for key, value in document["links"][link].items() if isinstance(value, int | float))
    driver = document["driver"][0]
    rate = next(key for key in ("omega", "velocity") if key in driver)
    changed = mechanism.with_({f"links.{link}.{key}": document["links"][link][key] * 1.01, f"driver.0.{rate}": 3.5})
    assert changed.drivers[0].rate == 3.5
    assert changed.text.count("\n") == mechanism.text.count("\n")
    assert re.findall("#.*", changed.text) == re.findall("#.*", mechanism.text)
    assert passes_check(changed, tmp_path)


NAMES = {
    "AB": ("links", "1", "AB"), "BA": ("links", "1", "AB"), "links.3.DC": ("links", "3", "DC"), "A": ("frame", "A"),
    "C": ("sketch", "C"), "omega AB": ("driver", 0, "omega"), "omega": ("driver", 0, "omega"), "alpha": ("driver", 0, "alpha"),
    "angle AB": ("driver", 0, "angle"), "slide.0.angle": ("slide", 0, "angle"), "scales.velocity": ("scales", "velocity"),
    "sketch.C": ("sketch", "C"), "driver.AB.omega": ("driver", 0, "omega"),
}  # fmt: skip


@pytest.mark.parametrize("name", NAMES)
def test_what_a_name_means(name: str):
    *way, key = NAMES[name]
    given = [61.5, 40.25] if key in ("A", "C") else 13.25
    document = tomllib.loads(book.example().with_({name: given}).text)
    expected = tomllib.loads(book.example().text)
    table = expected
    for part in way:
        table = table[part]
    table[key] = given
    assert document == expected


@pytest.mark.parametrize("name", ["AC", "omega", "omega XY", "links.9.AB", "slide.7.angle", "", "frame", "driver.0", "Q"])
def test_a_name_that_means_nothing(name: str):
    with pytest.raises(NoSuchValue):
        graphkin.load("p3-21").with_({name: 1})


def test_a_name_that_means_two_things():
    text = graphkin.load("s3-four").text.replace("BC = 60\nBE = 40\nCE = 35\n", "")
    shaped = graphkin.loads(text.replace('ccw = ["B", "C", "E"]', "shape = { B = [0, 0], C = [60, 0], E = [30, 25] }"))
    with pytest.raises(GraphkinError, match=r"links\.2\.shape\.C, sketch\.C"):
        shaped.with_(C=(60, 1))
    assert shaped.with_({"links.2.shape.C": (61, 0)}).links["2"].points["C"].real == pytest.approx(0.061)


LAYOUTS = (
    'links = { 1 = { AB = 24 } }\nframe = { A = [0, 0] }\ndriver = [{ vector = "AB", angle = 60 }]',
    'links.1.AB = 24\nframe.A = [0, 0] # here\n[[driver]]\nvector = "AB"\nangle = 60',
    '[[driver]]\nvector = "AB"\nangle = 60 # = 3\n\n[frame]\nA = [0,\n 0]\n[links.1]\nAB = 24 # AB = 24',
)


@pytest.mark.parametrize("text", LAYOUTS)
def test_any_layout(text: str):
    changed = graphkin.loads(text).with_({"A": (1, 2), "AB": "2 cm", "angle AB": 10, "omega AB": 5, "alpha AB": 7})
    assert changed.links["frame"].points["A"] == 0.001 + 0.002j
    assert abs(changed.links["1"].arm("A", "B")) == 0.02
    driver = changed.drivers[0]
    assert (driver.value, driver.rate, driver.acceleration) == (pytest.approx(np.radians(10)), 5, 7)


def test_primes_as_they_were_printed():
    text = '[frame]\nA = [0, 0]\n[links."1"]\n"AB′" = 24\n[[driver]]\nvector = "AB\'"\nangle = 0'
    assert abs(graphkin.loads(text).with_({"AB'": 30}).links["1"].arm("A", "B'")) == 0.03


def test_nothing_else_of_a_text_changes():
    text = graphkin.load("ex3-7").text
    assert replaced_values(text, {}) == text


# --- by name ----------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["ex3-1", "ex3-3", "p3-8", "p3-21", "ex3-4"])
def test_the_same_names_everywhere(name: str):
    mechanism = graphkin.load(name)
    drawing, exact, drawn = graphkin.Drawing.of(mechanism), graphkin.motion(mechanism), graphkin.replay(graphkin.plan(mechanism))
    for word in ("theta", "omega", "alpha", "s", "position", "x", "y", "v", "a"):
        tables = [getattr(found, word) for found in (drawing, exact, drawn)]
        assert list(tables[0]) == list(tables[1]) == list(tables[2])
        for key in tables[0]:
            turn = np.exp(1j * np.array([complex(table[key].si) for table in tables])) if word == "theta" else None
            values = np.array([complex(table[key].si) for table in tables]) if turn is None else turn
            assert np.ptp(np.abs(values - values[0])) < 1e-9 * max(1, np.max(np.abs(values)))
            assert tables[0][key].unit == tables[1][key].unit


def test_a_sweep_has_them_too():
    mechanism = graphkin.load("ex3-1")
    found = graphkin.sweep(mechanism, {"AB": np.linspace(60, 90, 4)}, ["omega 3"])
    exact = graphkin.motion(mechanism, [np.linspace(60, 90, 4)])
    for word, key in (("omega", "2"), ("v", "C"), ("a", "B3"), ("position", "C"), ("alpha", "3")):
        assert np.allclose(getattr(found, word)[key], getattr(exact, word)[key], rtol=1e-9)
    assert found["omega 3"].rpm == pytest.approx(exact.omega["3"].rpm)


def test_values_are_numbers_with_a_unit():
    drawing = graphkin.Drawing.of(graphkin.load("ex3-1"))
    omega, v = drawing.omega["3"], drawing.v["C"]
    assert isinstance(omega, float)
    assert isinstance(v, complex)
    assert (omega.unit, v.unit) == ("rad/s", "m/s")
    assert omega.degrees == pytest.approx(np.degrees(float(omega)))
    assert v.magnitude == pytest.approx(abs(v))
    assert np.radians(v.direction) == pytest.approx(np.angle(complex(v)) % (2 * np.pi))
    assert drawing["a_k B3B2"].unit == "m/s^2"
    assert type(omega * 2) is float
    for value in (omega, v):
        again = pickle.loads(pickle.dumps(value))
        assert (again, again.unit) == (value, value.unit)


@pytest.mark.parametrize(("of", "unit"), [("omega", "mm"), ("v", "degrees"), ("omega", "direction"), ("theta", "rpm")])
def test_a_unit_that_does_not_fit(of: str, unit: str):
    table = getattr(graphkin.Drawing.of(graphkin.load("ex3-1")), of)
    with pytest.raises(AttributeError, match=unit) as raised:
        getattr(table[list(table)[-1]], unit)
    assert isinstance(raised.value, GraphkinError)
    assert not hasattr(table[list(table)[-1]], unit)
    assert str(raised.value) in repr(raised.value)


def test_arrays_share_memory_and_keep_units():
    found = graphkin.motion(graphkin.load("ex3-1"), [[60, 90]])
    omega = found.omega["3"]
    assert np.shares_memory(omega, found.motions.omega["3"])
    assert omega[:1].unit == omega[0].unit == "rad/s"
    assert type(omega * 2) is np.ndarray
    assert pickle.loads(pickle.dumps(omega)).unit == "rad/s"


def test_what_was_read_cannot_be_written_into():
    """Else a quantity that is read later would be worked out of what stands there by then."""
    drawn = graphkin.replay(graphkin.plan(graphkin.load("ex3-1")), [np.linspace(50, 70, 9)])
    for read in (drawn.omega["2"], drawn.position["B"], drawn["omega 2"].si, drawn.v["B"][2:]):
        with pytest.raises(ValueError, match="read-only"):
            read *= 1000
    assert np.array(drawn.omega["2"]).flags.writeable


def test_a_name_that_is_not_there():
    drawing = graphkin.Drawing.of(graphkin.load("ex3-1"))
    for table, name, there in ((drawing.omega, "7", "1, 2, 3"), (drawing.v, "Q", "A, D, B, C")):
        with pytest.raises(KeyError, match=there):
            table[name]
        assert name not in table
    with pytest.raises(GraphkinError):
        drawing["omega 7"]


# --- sweeps -----------------------------------------------------------------------------------


def test_a_sweep_is_a_mapping():
    found = graphkin.sweep(graphkin.load("ex3-1"), "0:90:10", "omega 3, v C")
    assert list(found) == list(found.keys()) == list(dict(found)) == ["omega 3", "v C"]
    assert len(found) == 2
    assert "omega 3" in found
    assert "omega 2" not in found
    assert [len(series) for series in found.values()] == [10, 10]
    with pytest.raises(KeyError, match="omega 3, v C"):
        found["omega 2"]
    assert len(repr(found)) < 200


@pytest.mark.parametrize("name", ["ex3-1", "p3-3a", "ex3-3"])
def test_values_in_any_order(name: str):
    mechanism = graphkin.load(name)
    start = np.degrees(float(graphkin.motion(mechanism).values[0]))
    values = start + np.linspace(-9, 9, FEW)
    mixed = np.random.default_rng(1).permutation(FEW)
    link = mechanism.moving[-1]
    straight, other = (graphkin.sweep(mechanism, given, f"omega {link}") for given in (values, values[mixed]))
    assert np.allclose(other.driven, straight.driven[mixed])
    assert np.allclose(other[f"omega {link}"], np.asarray(straight[f"omega {link}"])[mixed], rtol=1e-9)


def test_ranges_say_the_same_in_any_way():
    mechanism = graphkin.load("ex3-7")
    ways = ("0:40:10", ["0:40:10"], ["AB=0:40:10"], {"AB": "0:40:10"}, {"AB": [0, 10, 20, 30, 40]}, np.arange(0, 41, 10), [0, 10, 20, 30, 40])
    found = [np.asarray(graphkin.sweep(mechanism, ranges, "theta 4")["theta 4"]) for ranges in ways]
    assert all(np.allclose(values, found[0], rtol=1e-12) for values in found)


def test_drivers_together_and_held():
    mechanism = graphkin.load("p3-21")
    crank, screw = (driver.name for driver in mechanism.drivers)
    text = graphkin.sweep(mechanism, [f"{crank}=20:40:10", f"{screw}=90:100:5"], "v F")
    listed = graphkin.sweep(mechanism, {crank: [20, 30, 40], screw: [90, 95, 100]}, "v F")
    assert np.allclose(text["v F"], listed["v F"], rtol=1e-12)
    backwards = graphkin.sweep(mechanism, {crank: [40, 30, 20], screw: [100, 95, 90]}, "v F")
    assert np.allclose(np.asarray(backwards["v F"])[::-1], listed["v F"], rtol=1e-9)
    held = graphkin.sweep(mechanism, {crank: [20, 30], screw: 95}, "v F")
    assert np.allclose(held["v F"], graphkin.sweep(mechanism, [f"{crank}=20:30:10", f"{screw}=95"], "v F")["v F"])
    with pytest.raises(BadValues):
        graphkin.sweep(mechanism, {crank: [20, 30, 40], screw: [90, 91, 100]}, "v F")


@pytest.mark.parametrize("values", [[[1, 2], [3, 4]], [0, np.nan], None, [], ["a", 1], 1e9, [1e9, 2e9]])
def test_values_that_are_none(values: object):
    with pytest.raises(BadValues, match=r"^ranges: "):
        graphkin.sweep(graphkin.load("ex3-1"), {"AB": values}, "omega 3")


@pytest.mark.parametrize("values", ["60 deg", ["1.0471975511965976 rad"], {"AB": "60"}])
def test_values_have_units(values: str | list[str] | dict[str, str]):
    turned = graphkin.Drawing.of("ex3-7", values)
    assert np.isclose(turned.omega["4"], graphkin.Drawing.of("ex3-7", 60).omega["4"], rtol=1e-12)
    with pytest.raises(GraphkinError, match=r"^values: mm is the unit of a length"):
        graphkin.Drawing.of("ex3-7", "60 mm")


def test_errors_name_arguments():
    mechanism = graphkin.load("ex3-1")
    with pytest.raises(NoSuchDriver, match=r"^ranges: "):
        graphkin.sweep(mechanism, {"XY": [1, 2]})
    with pytest.raises(UnknownQuantity, match=r"^of: "):
        graphkin.sweep(mechanism, (), "speed 3")
    for wrong, name in (
        (lambda: graphkin.tolerance(mechanism, "0.3"), "pencil"), (lambda: [*graphkin.grade(mechanism, "a.csv", pencil="3")], "pencil"),
        (lambda: graphkin.power(mechanism, trials=0), "trials"), (lambda: graphkin.handout(mechanism, stage="half", upto=99), "upto"),
        (lambda: graphkin.problems("no.toml", -3, "set"), "students: -3 stands where a whole number"), (lambda: graphkin.linkage(), "linkage: of"),
        (lambda: graphkin.Drawing.of(mechanism).sheet(arrows=True), "arrows: paths"), (lambda: mechanism.with_(AB=None), "links.1.AB: NoneType"),
        (lambda: mechanism.with_(A=(0, object())), "frame.A.1: object"),
    ):  # fmt: skip
        with pytest.raises(GraphkinError, match=f"^{re.escape(name)}"):
            wrong()


def test_paths_of_points():
    mechanism = graphkin.load("ex3-1")
    found = graphkin.sweep(mechanism, [0, 50, 100], "path C, x C, y C")
    assert np.allclose(found["path C"].vectors, np.asarray(found["x C"]) + 1j * np.asarray(found["y C"]))
    assert np.allclose(found["path C"], graphkin.motion(mechanism, [[0, 50, 100]]).position["C"])
    assert list(found.columns())[1:] == ["path C x [mm]", "path C y [mm]", "x C [mm]", "y C [mm]"]
    asking = graphkin.loads(mechanism.text.replace('"omega 2"', '"path C", "x C"'))
    place = complex(graphkin.Drawing.of(asking).answers()["path C"].vector)
    assert place == pytest.approx(complex(graphkin.motion(asking).position["C"]))
    assert len(graphkin.sweep(mechanism, "0:90:10", "path C").figure().axes[0].lines) >= 2


# --- tables and pictures ----------------------------------------------------------------------


def test_columns_as_in_csv():
    found = graphkin.sweep(graphkin.load("ex3-1"), "0:90:10", "omega 3, v C")
    csv = CliRunner().invoke(main, ["sweep", "ex3-1", "--driver", "0:90:10", "--of", "omega 3, v C", "-o", "-"]).output
    assert csv.splitlines()[0].split(",") == list(found.columns())
    si = found.columns(si=True)
    assert np.shares_memory(si["omega 3 [rad/s]"], found["omega 3"].values)
    assert np.shares_memory(si["AB [rad]"], found.driven)


def test_arrow_copies_nothing():
    pytest.importorskip("pyarrow", reason="needs graphkin[parquet]")
    found = graphkin.sweep(graphkin.load("ex3-1"), "0:90:10", "omega 3")
    table = found.to_arrow(si=True)
    assert np.shares_memory(table["omega 3 [rad/s]"].chunk(0).to_numpy(), found["omega 3"].values)
    assert found.to_arrow().num_rows == 10


@pytest.mark.parametrize("library_name", ["pandas", "polars"])
def test_frames(library_name: str):
    pytest.importorskip(library_name)
    found = graphkin.sweep(graphkin.load("ex3-1"), "0:90:10", "omega 3, v C")
    frame = getattr(found, f"to_{library_name}")()
    assert list(frame.columns) == list(found.columns())
    assert np.allclose(frame["omega 3 [rad/s]"], found["omega 3"])


def test_in_a_notebook():
    found = graphkin.sweep(graphkin.load("ex3-1"), "0:360:1", "omega 3")
    assert "<svg" in found._repr_svg_()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("graphkin.page.player._TOLD", 12)  # of a page with few words
        assert found._repr_html_().count("<tr>") == 18
    assert graphkin.sweep(graphkin.load("ex3-1"), "0:90:10", "P13")._repr_svg_() is None


# --- many, and the reference ------------------------------------------------------------------


def test_many_variants():
    mechanism = graphkin.load("ex3-1")
    lengths = np.linspace(20, 28, 4)
    found = list(graphkin.solve_many([*(mechanism.with_(AB=length) for length in lengths), mechanism.with_(AB=500)], ["omega 3"]))
    for length, solved in zip(lengths, found, strict=False):
        assert solved["omega 3"] == pytest.approx(graphkin.motion(mechanism.with_(AB=length)).omega["3"], rel=1e-9)
    assert found[0].keys() == {"omega 3"}
    assert [solved.error is None for solved in found[:4]] == [True] * 4


def test_one_that_cannot_be_drawn_stops_nothing():
    bad = graphkin.load("s3-four").with_(BC=10, BE=5, CE=6)
    first, second = graphkin.solve_many([bad, "s3-four"], ["omega 3"])
    assert isinstance(first.error, GraphkinError)
    assert len(first) == 0
    assert second["omega 3"] != 0


def test_the_reference_has_every_name():
    text = CliRunner().invoke(main, ["help", "api"]).output
    assert set(graphkin.__all__) <= set(dir(graphkin))
    for name in reference.names():
        assert re.search(rf"^{name}\b.*\n-+\n\S", text, re.M), name
    for name in graphkin.__all__:
        assert inspect.getdoc(getattr(graphkin, name)), name
    elsewhere = dict(re.findall(r"^(\w+) \(of (graphkin\.[\w.]+)\)\n-", text, re.M))
    assert {*elsewhere, *graphkin.__all__} == {*reference.names()}
    assert all(inspect.isclass(getattr(import_module(module), name)) for name, module in elsewhere.items())
    assert CliRunner().invoke(main, ["help", "api", "nothing"]).exit_code == 2
    assert "sheet(*, paper: str | None = None, lang: 'en' | 'zh' = 'en', only: 'position' | " in text
    assert not re.search(rf"(?m)^ *\.?\w+\(.*: ({'|'.join(reference._WORDS)})\b", text)
    for lang, job in (("en", "an optimum; nan"), ("zh", "优化")):
        shown = CliRunner().invoke(main, ["help", "api", "--lang", lang]).output
        assert f"\n{job}" in shown
        assert '\n    t = trial(m, "AB", "BC", over="0:360:1")' in shown


# --- words ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "wrong",
    [
        lambda drawing: drawing.sheet(lang="fr"),
        lambda drawing: drawing.sheet(style="bold"),
        lambda drawing: drawing.step_sheets(only="forces"),
        lambda drawing: drawing.explain(lang="fr"),
        lambda drawing: drawing.equations(method="polar"),
        lambda _: graphkin.sweep("ex3-1", {"AB": range(3)}, "omega 3", by="eye"),
        lambda _: graphkin.find("ex3-1", "max omega 3", by="eye"),
        lambda _: graphkin.design("toggle", K=1.5),
        lambda _: graphkin.handout("ex3-1", stage="draft"),
        lambda _: graphkin.play("ex3-1", lang="fr"),
        lambda _: graphkin.lines_of(graphkin.centres("ex3-1"), "fr"),
        lambda drawing: drawing.sheet().svg(ink="pink"),
        lambda drawing: drawing.sheet().save("x.svg", ink="pink"),
        lambda _: graphkin.sweep("ex3-1", "0:9:3").figure("fr"),
        lambda _: graphkin.sweep("ex3-1", "0:9:3").save("x.csv", "fr"),
        lambda _: graphkin.problems("no.toml", 2, "set", lang="fr"),
        lambda _: graphkin.problems("no.toml", 2, "set", formats="mood"),
        lambda _: graphkin.grade_into("results", "ex3-1", "in", reveal="all"),
        lambda _: graphkin.grade_into("results", "ex3-1", "in", lang="fr"),
        lambda _: graphkin.grade_into("results", "ex3-1", "in", ["csv", "mood"]),
        lambda _: graphkin.grade_into("results", "ex3-1", "in", "mood"),
    ],
)
def test_a_word_that_stands_nowhere_names_those_that_do(wrong: Callable[[graphkin.Drawing], object]):
    with pytest.raises(NotOneOf, match=r"Possible|Did you mean"):
        wrong(graphkin.Drawing.of("ex3-1"))


def test_a_design_takes_its_own_sizes_only():
    with pytest.raises(UnknownKey, match=r"rocker: .*rod"):
        graphkin.design("rocker", length=80, swing=40, K=1.3, rod=3)
    with pytest.raises(MissingKey, match=r"slider: stroke"):
        graphkin.design("slider", K=1.5)
    with pytest.raises(NotANumber, match=r"^K: "):
        graphkin.design("rocker", length=80, swing=40, K="quick", frame=71)


def test_what_stands_alone_is_said():
    with pytest.raises(MissingKey, match=r"^bobillier: about"):
        graphkin.centres("ex3-5", bobillier="E")
    with pytest.raises(UnknownPaper, match="A9"):
        graphkin.handout("ex3-1", stage="problem").save("x.html", paper="A9")


@pytest.mark.parametrize("wrong", [{"relative": -1}, {"relative": float("nan")}, {"sigmas": 0}, {"trials": 0}])
def test_numbers_of_a_pencil_are_of_reasonable_size(wrong: dict[str, float]):
    with pytest.raises(OutOfRange, match=next(iter(wrong))):
        graphkin.power("ex3-1", **{"trials": 2, **wrong})
