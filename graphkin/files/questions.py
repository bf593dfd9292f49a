"""`ask`: a text must name what is there, or be a question in words, which ends with a question mark."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.errors import NOWHERE, GraphkinError, NoQuestion, NoRate, Where
from graphkin.files.draft import Draft
from graphkin.model.mechanism import Driver, Mechanism
from graphkin.model.quantities import formed, meant, read

RATES = ("omega", "alpha", "velocity", "acceleration")
"""Keys that say how fast a driver moves."""


def check_questions(draft: Draft, mechanism: Mechanism) -> None:
    """Note every question about something that is not there, and every text that asks nothing."""
    for number, question in enumerate(mechanism.ask):
        try:
            _check(mechanism, question, NOWHERE)
        except GraphkinError:  # its place is looked for only now
            with draft.noting():
                _check(mechanism, question, draft.where("ask", number))


def _check(mechanism: Mechanism, question: str, where: Where) -> None:
    if read(mechanism, question, where) is None and not formed(question) and question[-1:] not in ("?", "？"):
        raise NoQuestion(where, question, meant(mechanism, question) or "")


def remarks(mechanism: Mechanism) -> Iterator[NoRate]:
    """Notes on drivers that stand still because nothing is said of how fast they move."""
    for number, driver in enumerate(mechanism.drivers):
        if driver.rate or not mechanism.lines:
            continue
        if not any(("driver", number, key) in mechanism.lines for key in RATES):
            yield NoRate(mechanism.where("driver", number), driver.name, rate_keys(driver))


def rate_keys(driver: Driver) -> str:
    """The keys that say how fast a driver moves."""
    return {"slide": "velocity", "spin": "omega"}.get(driver.kind, "omega (velocity)")
