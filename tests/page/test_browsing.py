"""The browser that tests of pages have tells on a page that is not silent."""

from __future__ import annotations

from pathlib import Path

from browsing import Browsing, axe

_PAGE = '<!DOCTYPE html><html lang="en"><head>{}<title>A page</title><link rel="icon" href="data:,"></head><body><main>{}</main></body></html>'
_POLICY = '<meta http-equiv="Content-Security-Policy" content="default-src \'none\'; img-src data:">'


def _opened(browsing: Browsing, folder: Path, body: str, head: str = ""):
    (folder / "page.html").write_text(_PAGE.format(head, body), "utf-8")
    return browsing.open(folder / "page.html")


def test_a_silent_page_under_a_policy_has_no_faults(browsing, tmp_path):
    page = _opened(browsing, tmp_path, "<h1>Still</h1><p>Words.</p>", _POLICY)
    assert page.title() == "A page"
    assert axe(page) == []
    assert browsing.faults == []


def test_errors_and_requests_are_faults(browsing, tmp_path):
    loud = "<h1>Loud</h1><script>console.error('one'); setTimeout(() => { throw Error('two'); })</script><img alt='' src='three.png'>"
    page = _opened(browsing, tmp_path, loud)
    page.wait_for_load_state("networkidle")
    for part in ("error: one", "error: two", "request: "):
        assert any(fault.startswith(part) for fault in browsing.faults), part
    browsing.faults.clear()


def test_what_nobody_can_read_is_grave(browsing, tmp_path):
    page = _opened(browsing, tmp_path, "<h1>Grave</h1><button></button>")
    assert [fault.split(":")[0] for fault in axe(page)] == ["button-name"]
