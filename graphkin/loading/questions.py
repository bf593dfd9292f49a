"""`ask`: a question that names a link, a point or a slide must name one that is there. Other texts are free."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.errors import OnlyShown
from graphkin.loading.draft import Draft
from graphkin.mechanism import Mechanism
from graphkin.quantities import meant, read


def check_questions(draft: Draft, mechanism: Mechanism) -> None:
    """Note every question about something that is not there."""
    for number, question in enumerate(mechanism.ask):
        with draft.noting():
            read(mechanism, question, draft.where("ask", number))


def remarks(mechanism: Mechanism) -> Iterator[OnlyShown]:
    """Notes on questions that nearly are some."""
    for number, question in enumerate(mechanism.ask):
        if (better := meant(mechanism, question)) is not None:
            yield OnlyShown(mechanism.where("ask", number), question, better)
