"""Inkscape and GeoGebra themselves, driven without a window, to write drawings as students save them."""

from __future__ import annotations

import base64
import json
import os
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

import pytest

GEOGEBRA = Path("/usr/share/geogebra/geogebra.jar")
_SCRIPT = """
var panel = new Packages.geogebra.GeoGebraPanel();
panel.buildGUI();
var api = panel.getGeoGebraAPI(), drawings = %s;
var out = new java.io.FileWriter("drawings.txt");
for (var k = 0; k < drawings.length; k++) {
    for (var i = 0; i < drawings[k].length; i++) {
        var words = drawings[k][i].split(" ");
        var does = words[0] == "rename" ? api.renameObject(words[1], words[2]) : api.evalCommand(drawings[k][i]);
        if (!does) out.write("refused: " + drawings[k][i] + " ");
    }
    out.write(api.getBase64(false) + "\\n");
    api.reset();
    var names = api.getAllObjectNames();
    for (var i = 0; i < names.length; i++) api.deleteObject(names[i]);
}
out.close();
java.lang.System.exit(0);
"""


def needed(program: str) -> None:
    """Skips the test where a program is not installed; where CI is set it fails instead."""
    there = shutil.which("inkscape") if program == "Inkscape" else GEOGEBRA.is_file() and shutil.which("java") and shutil.which("Xvfb")
    if not there:
        assert not os.environ.get("CI"), f"{program} must be there"
        pytest.skip(f"{program} is not installed")


def by_inkscape(drawings: Sequence[str], folder: Path) -> list[bytes]:
    """Each opened, its groups taken apart, all of it moved, saved as Inkscape's own SVG."""
    for k, drawing in enumerate(drawings):
        (folder / f"{k}.svg").write_text(drawing, "utf-8")
    acts = "select-all:groups;selection-ungroup;select-all;transform-translate:3,4;selection-group;export-type:svg;export-do"
    words = ["inkscape", "--actions", acts, *(f"{k}.svg" for k in range(len(drawings)))]
    home = {"HOME": str(folder), "XDG_CONFIG_HOME": str(folder), "XDG_DATA_HOME": str(folder), "XDG_CACHE_HOME": str(folder)}
    done = subprocess.run(words, cwd=folder, env={**os.environ, **home}, capture_output=True, timeout=120, check=False)
    saved = [folder / f"{k}_out.svg" for k in range(len(drawings))]
    assert all(path.is_file() for path in saved), done.stderr.decode()
    return [path.read_bytes() for path in saved]


def by_geogebra(drawings: Sequence[Sequence[str]], folder: Path) -> list[bytes]:
    """Each typed into its input line, command by command, and saved; `rename A b` gives a point another name."""
    (folder / "draw.js").write_text(_SCRIPT % json.dumps(drawings), "utf-8")
    places = [f"-D{key}={folder}" for key in ("java.io.tmpdir", "java.util.prefs.userRoot", "user.home")]
    words = ["java", "-XX:TieredStopAtLevel=1", *places, "-cp", str(GEOGEBRA), "org.mozilla.javascript.tools.shell.Main", "draw.js"]
    with subprocess.Popen(["Xvfb", "-displayfd", "1", "-nolisten", "tcp"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as screen:
        try:
            display = f":{screen.stdout.readline().decode().strip()}"
            done = subprocess.run(words, cwd=folder, env={**os.environ, "DISPLAY": display}, capture_output=True, timeout=120, check=False)
        finally:
            screen.terminate()
    assert (folder / "drawings.txt").is_file(), done.stderr.decode()
    saved = (folder / "drawings.txt").read_text("utf-8").splitlines()
    assert not any("refused" in one for one in saved), saved
    return [base64.b64decode(one) for one in saved]
