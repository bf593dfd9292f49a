"""Examples of how each key of the mechanism file is written, by table and key.

The meaning of the keys stands in the catalogue, `file_keys`; the page of the file and the JSON Schema are made of both.
"""

from __future__ import annotations

from collections.abc import Mapping

from graphkin.files.schema import FURTHER

LINE: Mapping[str, str] = {
    "through": 'through = "C"', "toward": 'toward = "E"', "from": 'from = "DC"', "angle": "angle = 100",
}

EXAMPLES: Mapping[str, Mapping[str, str]] = {
    "file": {
        "title": 'title = "Shaper"', "source": 'source = "Example 3-1"',
        "text": 'text = "In a shaper the crank AB drives the arm DC."', "ask": 'ask = ["omega 3", "v C"]',
        "points": "[points]", "frame": "[frame]", "links": "[links.1]", "slide": "[[slide]]", "gear": "[[gear]]",
        "roll": "[[roll]]", "cam": "[[cam]]", "driver": "[[driver]]", "pose": "[[pose]]", "sketch": "[sketch]",
        "scales": "[scales]",
    },
    "title": {"en": 'en = "Shaper"', "zh": 'zh = ".."'},
    "points": {"follows": 'follows = "half"', FURTHER: '"omega 3" = 2'},
    "frame": {"name": 'name = "4"', FURTHER: "D = [78, 0]"},
    "link": {
        "points": 'points = ["B"]', "ccw": 'ccw = ["B", "C", "E"]',
        "shape": "shape = { B = [0, 0], C = [50, 0], E = [20, -15] }", FURTHER: "AB = 24",
    },
    "slide": {
        "name": 'name = "ram"', "title": 'title = { en = "ram" }', "block": 'block = "2"', "point": 'point = "B"',
        "pin": 'pin = "P"', "guide": 'guide = "3"', **LINE, "tilt": "tilt = -90", "centre": 'centre = "O"',
        "radius": "radius = 60",
    },
    "gear": {
        "links": 'links = ["1", "2"]', "centres": 'centres = ["A", "B"]', "radii": "radii = [20, 40]",
        "internal": "internal = true",
    },
    "roll": {
        "name": 'name = "wheel"', "wheel": 'wheel = "2"', "centre": 'centre = "C"', "radius": "radius = 25",
        "on": 'on = "frame"', **LINE, "side": 'side = "right"', "on_centre": 'on_centre = "O"',
        "on_radius": "on_radius = 80", "internal": "internal = true",
    },
    "profile": {"centre": 'centre = "B"', "radius": "radius = 25", **LINE, "side": 'side = "right"'},
    "cam": {
        "links": 'links = ["1", "2"]',
        "profiles": 'profiles = [{ centre = "B", radius = 25 }, { through = "D", toward = "E" }]',
        "internal": "internal = true",
    },
    "pose": {
        "vector": 'vector = "AB"', "angle": "angle = 60", "from": 'from = "BA"', "slide": 'slide = "ram"',
        "at": "at = 90",
    },
    "driver": {
        "vector": 'vector = "AB"', "link": 'link = "2"', "slide": 'slide = "ram"', "angle": "angle = 60",
        "from": 'from = "BA"', "at": "at = 90", "omega": 'omega = "95 rpm"', "alpha": "alpha = 2",
        "velocity": "velocity = 0.5", "acceleration": "acceleration = 2", "also": "also = [120, 220]",
    },
    "scales": {"length": "length = 0.001", "velocity": "velocity = 0.01", "acceleration": "acceleration = 0.1"},
    "sketch": {FURTHER: "C = [65, 46]"},
}  # fmt: skip
"""By table, as it is called in the file, then by key."""
