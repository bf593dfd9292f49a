"""The rules of QTI 1.2 for the elements that a bank of numerical questions has, and a checker of them.

Written after the specification's own document type definition (IMS ASI 1.2: what an element holds, in which order, and
its attributes), not after what graphkin writes: an element or an attribute that is not here is refused. With it the rules
of the package's manifest (IMS content packaging 1.1, as common cartridges have it), as far as a bank needs them.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET

ASI = "http://www.imsglobal.org/xsd/ims_qtiasiv1p2"
CP = "http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1"
XML = "{http://www.w3.org/XML/1998/namespace}"
TEXT = "text"  # an element with letters and no children
TESTS = "not|and|or|unanswered|other|varequal|varlt|varlte|vargt|vargte|varsubset|varinside|varsubstring"
MATERIAL = "(material|material_ref)?"
RENDERED = "(render_choice|render_hotspot|render_slider|render_fib|render_extension)"
YES_NO = "Yes|No"
ANY = ".*"
ITEM = (
    "qticomment? duration? itemmetadata? objectives* itemcontrol* itemprecondition* itempostcondition* (itemrubric|rubric)* "
    "presentation? resprocessing* itemproc_extension? itemfeedback* reference?"
)
RULES: dict[str, tuple[str, dict[str, str]]] = {
    "questestinterop": ("qticomment? (objectbank|assessment|(section|item)+)", {}),
    "objectbank": ("qticomment? qtimetadata* (section|item)+", {"ident!": ANY}),
    "qtimetadata": ("vocabulary? qtimetadatafield+", {}),
    "qtimetadatafield": ("fieldlabel fieldentry", {f"{XML}lang": ANY}),
    "fieldlabel": (TEXT, {}),
    "fieldentry": (TEXT, {}),
    "item": (ITEM, {"ident!": ANY, "title": ANY, "label": ANY, "maxattempts": ANY, f"{XML}lang": ANY}),
    "itemmetadata": ("qtimetadata* qmd_computerscored? qmd_itemtype? qmd_maximumscore? qmd_topic?", {}),
    "presentation": (
        "qticomment? (flow|(material|response_lid|response_xy|response_str|response_num|response_grp|response_extension)+)",
        {"label": ANY, f"{XML}lang": ANY},
    ),
    "material": (
        "qticomment? (mattext|matemtext|matimage|matbreak|matref|mat_extension)+ altmaterial*",
        {"label": ANY, f"{XML}lang": ANY},
    ),
    "mattext": (TEXT, {"texttype": "text/(plain|html|xhtml|rtf)", "charset": ANY, "uri": ANY, f"{XML}lang": ANY}),
    "response_str": (
        f"{MATERIAL} {RENDERED} {MATERIAL}",
        {"ident!": ANY, "rcardinality": "Single|Multiple|Ordered", "rtiming": YES_NO},
    ),
    "render_fib": (
        "(material|material_ref|response_label|flow_label)* response_na?",
        {"fibtype": "String|Integer|Decimal|Scientific", "prompt": "Box|Dashline|Asterisk|Underline", "rows": ANY,
         "columns": ANY, "maxchars": ANY, "minnumber": ANY, "maxnumber": ANY, "encoding": ANY, "charset": ANY},
    ),
    "response_label": ("(qticomment|material|material_ref|flow_mat)*", {"ident!": ANY, "rshuffle": YES_NO}),
    "resprocessing": ("qticomment? outcomes (respcondition|itemproc_extension)+", {"scoremodel": ANY}),
    "outcomes": ("qticomment? (decvar interpretvar*)+", {}),
    "decvar": (
        TEXT,
        {"varname": ANY, "vartype": "Integer|String|Decimal|Scientific|Boolean|Enumerated|Set", "defaultval": ANY,
         "minvalue": ANY, "maxvalue": ANY, "members": ANY, "cutvalue": ANY},
    ),
    "respcondition": (
        "qticomment? conditionvar setvar* displayfeedback* respcond_extension?", {"continue": YES_NO, "title": ANY},
    ),
    "conditionvar": (f"({TESTS}|var_extension)+", {}),
    "and": (f"({TESTS})+", {}),
    "or": (f"({TESTS})+", {}),
    "varequal": (TEXT, {"respident!": ANY, "case": YES_NO, "index": ANY}),
    "vargte": (TEXT, {"respident!": ANY, "index": ANY}),
    "varlte": (TEXT, {"respident!": ANY, "index": ANY}),
    "setvar": (TEXT, {"varname": ANY, "action": "Set|Add|Subtract|Multiply|Divide"}),
}  # fmt: skip
MANIFEST: dict[str, tuple[str, dict[str, str]]] = {
    "manifest": ("metadata? organizations resources manifest*", {"identifier!": ANY, "version": ANY}),
    "metadata": ("schema? schemaversion?", {}),
    "schema": (TEXT, {}),
    "schemaversion": (TEXT, {}),
    "organizations": ("organization*", {"default": ANY}),
    "resources": ("resource*", {f"{XML}base": ANY}),
    "resource": ("metadata? file* dependency*", {"identifier!": ANY, "type!": ANY, "href": ANY, f"{XML}base": ANY}),
    "file": ("metadata?", {"href!": ANY}),
    "dependency": ("", {"identifierref!": ANY}),
}
NAME = re.compile(r"[A-Za-z_][\w.-]*")


def check_items(data: bytes) -> None:
    """Refuse a file of questions that the schema of QTI 1.2 refuses, or whose references lead nowhere."""
    root = _checked(data, RULES, ASI, "questestinterop")
    for item in root.iter(f"{{{ASI}}}item"):
        asked = {each.get("ident") for each in item.iter(f"{{{ASI}}}response_str")}
        told = {each.get("respident") for each in item.iter() if each.get("respident") is not None}
        declared = {each.get("varname", "SCORE") for each in item.iter(f"{{{ASI}}}decvar")}
        assert told <= asked, f"{told - asked}: nobody is asked that"
        assert {each.get("varname", "SCORE") for each in item.iter(f"{{{ASI}}}setvar")} <= declared
    idents = [item.get("ident") for item in root.iter(f"{{{ASI}}}item")]
    assert len(set(idents)) == len(idents)


def check_manifest(data: bytes) -> None:
    """Refuse a manifest that the schema refuses: its identifiers are names, each once, and what they refer to is there."""
    root = _checked(data, MANIFEST, CP, "manifest")
    names = [each.get("identifier") for each in root.iter() if each.get("identifier") is not None]
    assert len(set(names)) == len(names)
    assert all(map(NAME.fullmatch, names)), names
    assert {each.get("identifierref") for each in root.iter(f"{{{CP}}}dependency")} <= set(names)
    for resource in root.iter(f"{{{CP}}}resource"):
        files = [file.get("href") for file in resource.findall(f"{{{CP}}}file")]
        assert resource.get("href", files[0]) in files


def _checked(data: bytes, rules: dict[str, tuple[str, dict[str, str]]], space: str, first: str) -> ET.Element:
    root = ET.fromstring(data)
    assert root.tag == f"{{{space}}}{first}", root.tag
    for node in root.iter():
        assert node.tag.startswith(f"{{{space}}}"), f"{node.tag} is not of {space}"
        tag = node.tag.rpartition("}")[2]
        assert tag in rules, f"there is no {tag}"
        content, attributes = rules[tag]
        children = "".join(f"{child.tag.rpartition('}')[2]} " for child in node)
        if content == TEXT:
            assert not children, f"{tag} holds no {children}"
        else:
            assert re.fullmatch(_pattern(content), children), f"{tag}: {children!r} is not {content!r}"
            letters = "" if tag == "response_label" else "".join((node.text or "", *(child.tail or "" for child in node)))
            assert not letters.strip(), f"letters in {tag}: {letters!r}"
        for name, value in node.attrib.items():
            allowed = attributes.get(name, attributes.get(name + "!"))
            assert allowed is not None, f"{tag} has no {name}"
            assert re.fullmatch(allowed, value, re.S), f"{name} of {tag}: {value!r}"
        assert all(name[:-1] in node.attrib for name in attributes if name.endswith("!")), f"{tag} without {attributes}"
    return root


def _pattern(content: str) -> str:
    """A content model as a pattern of names, each with a blank after it."""
    return "".join(re.sub(r"\w+", lambda name: f"(?:{name[0]} )", part) for part in content.split())
