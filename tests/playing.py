"""What a browser shows of a moving SVG at one moment: SMIL's `animate`, linear or discrete, worked out."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET

_NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
_ANIMATE = "{http://www.w3.org/2000/svg}animate"


def still(text: str, moment: float) -> str:
    """The drawing at a moment (0 to 1 of its turn), without what moves it and without what is hidden then."""
    root = ET.fromstring(text)
    _stop(root, moment % 1.0)
    return ET.tostring(root, encoding="unicode")


def _stop(element: ET.Element, moment: float) -> None:
    for animate in element.findall(_ANIMATE):
        assert animate.attrib["repeatCount"] == "indefinite"
        element.set(animate.attrib["attributeName"], _value(animate, moment))
        element.remove(animate)
    for child in list(element):
        _stop(child, moment)
        if child.get("visibility") == "hidden":
            element.remove(child)
        child.attrib.pop("visibility", None)


def _value(animate: ET.Element, moment: float) -> str:
    values = animate.attrib["values"].split(";")
    if animate.get("calcMode") == "discrete":
        keys = [float(key) for key in animate.attrib["keyTimes"].split(";")]
        assert keys == sorted({0.0, *keys})
        assert len(keys) == len(values)
        return values[sum(key <= moment + 1e-9 for key in keys) - 1]
    whole, part = divmod(moment * (len(values) - 1) + 1e-9, 1.0)
    pairs = zip(_NUMBER.findall(values[int(whole)]), _NUMBER.findall(values[int(whole) + 1]), strict=True)
    between = iter([f"{float(a) + part * (float(b) - float(a)):.5f}" for a, b in pairs])
    return _NUMBER.sub(lambda _: next(between), values[int(whole)])
